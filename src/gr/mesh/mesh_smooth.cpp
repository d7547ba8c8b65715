#include "gr/mesh/mesh_smooth.h"

#include "core/elementary.h"
#include "gr/mesh/mesh_repair.h"
#include "gr/mesh/parts.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <numeric>

namespace gr {
namespace {

// One corner of a face, with what is needed of it at its vertex.
struct Corner {
    int place;  // in FlatMesh::corners
    int face;
};

// The corners at each vertex.
class Fans {
public:
    explicit Fans(const FlatMesh& mesh) : starts_(mesh.vertices.size() + 1), corners_(mesh.corners.size()) {
        for (const int v : mesh.corners) ++starts_[v];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        // Filled from behind, which leaves in starts_ where each vertex's corners start.
        for (int f = mesh.faceCount() - 1; f >= 0; --f)
            for (int place = mesh.end(f) - 1; place >= mesh.begin(f); --place)
                corners_[--starts_[mesh.corners[place]]] = {place, f};
    }

    std::span<const Corner> at(int vertex) const {
        return std::span(corners_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }

private:
    std::vector<int> starts_;
    std::vector<Corner> corners_;
};

std::vector<glm::dvec3> unitNormals(const FlatMesh& mesh) {
    std::vector<glm::dvec3> normals(mesh.faceCount());
    inParts(mesh.faceCount(), [&](int first, int end) {
        for (int f = first; f < end; ++f) {
            const glm::dvec3 normal = faceNormal(mesh.vertices, mesh.face(f));
            normals[f] = normal == glm::dvec3(0) ? normal : glm::normalize(normal);
        }
    });
    return normals;
}

// Joins the corners at one vertex after the other. Its vectors are kept from one to the next.
class Smoother {
public:
    Smoother(FlatMesh& mesh, const Fans& fans, const std::vector<glm::dvec3>& normals, double degrees)
        : mesh_(mesh), fans_(fans), normals_(normals), leastCosine_(std::cos(glm::radians(std::min(degrees, 180.)))) {}

    void smooth(int vertex) {
        const std::span<const Corner> fan = fans_.at(vertex);
        join(fan);
        sums_.assign(fan.size(), glm::dvec3(0));
        for (std::size_t i = 0; i < fan.size(); ++i)
            sums_[groupOf(static_cast<int>(i))] += static_cast<double>(angleAt(fan[i])) * normals_[fan[i].face];
        for (std::size_t i = 0; i < fan.size(); ++i) {
            const glm::dvec3 sum = sums_[groupOf(static_cast<int>(i))];
            const glm::dvec3 normal = glm::length(sum) > 1e-6 ? glm::normalize(sum) : normals_[fan[i].face];
            mesh_.normals[fan[i].place] = normal == glm::dvec3(0) ? noNormal : packNormal(core::Vec3f(normal));
        }
    }

private:
    // The edge from the vertex to another, as one of the faces there has it.
    struct Edge {
        int to;
        int corner;  // its number in the fan
    };

    // Puts those corners into one group that share an edge which is not sharp.
    void join(std::span<const Corner> fan) {
        edges_.clear();
        for (std::size_t i = 0; i < fan.size(); ++i)
            for (const int to : {before(fan[i]), after(fan[i])}) edges_.push_back({to, static_cast<int>(i)});
        std::sort(edges_.begin(), edges_.end(),
                  [](const Edge& a, const Edge& b) { return a.to != b.to ? a.to < b.to : a.corner < b.corner; });
        groups_.resize(fan.size());
        std::iota(groups_.begin(), groups_.end(), 0);
        for (std::size_t first = 0, end; first < edges_.size(); first = end) {
            for (end = first + 1; end < edges_.size() && edges_[end].to == edges_[first].to;) ++end;
            if (end - first != 2) continue;
            const int a = edges_[first].corner, b = edges_[first + 1].corner;
            if (glm::dot(normals_[fan[a].face], normals_[fan[b].face]) > leastCosine_) groups_[groupOf(b)] = groupOf(a);
        }
    }

    // Trees of corners, each known by its root (Tarjan 1975).
    int groupOf(int corner) {
        while (groups_[corner] != corner) corner = groups_[corner] = groups_[groups_[corner]];
        return corner;
    }

    // The vertices next to a corner in its face.
    int before(const Corner& corner) const {
        const int place = corner.place == mesh_.begin(corner.face) ? mesh_.end(corner.face) : corner.place;
        return mesh_.corners[place - 1];
    }
    int after(const Corner& corner) const {
        const int place = corner.place + 1;
        return mesh_.corners[place == mesh_.end(corner.face) ? mesh_.begin(corner.face) : place];
    }

    // Of the face, at a corner of it: more than pi where its outline is dented.
    float angleAt(const Corner& corner) const {
        const glm::dvec3 place = mesh_.vertices[mesh_.corners[corner.place]];
        const glm::dvec3 out = glm::normalize(mesh_.vertices[after(corner)] - place);
        const glm::dvec3 in = glm::normalize(mesh_.vertices[before(corner)] - place);
        const float angle = core::atan2(static_cast<float>(glm::dot(glm::cross(out, in), normals_[corner.face])),
                                        static_cast<float>(glm::dot(out, in)));
        const float rounding = 1e-6f;
        return angle < -rounding ? angle + 2 * core::pi : std::abs(angle);
    }

    FlatMesh& mesh_;
    const Fans& fans_;
    const std::vector<glm::dvec3>& normals_;
    const double leastCosine_;
    std::vector<Edge> edges_;
    std::vector<int> groups_;
    std::vector<glm::dvec3> sums_;
};

}  // namespace

void smoothNormals(FlatMesh& mesh, double degrees) {
    if (!mesh.normals.empty() || degrees <= 0) return;
    const std::vector<glm::dvec3> normals = unitNormals(mesh);
    const Fans fans(mesh);
    mesh.normals.resize(mesh.corners.size());
    inParts(static_cast<int>(mesh.vertices.size()), [&](int first, int end) {
        Smoother smoother(mesh, fans, normals, degrees);
        for (int vertex = first; vertex < end; ++vertex) smoother.smooth(vertex);
    });
}

}  // namespace gr
