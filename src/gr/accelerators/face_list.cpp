#include "gr/accelerators/face_list.h"

#include "gr/scene.h"

#include <algorithm>

namespace gr {
namespace {

using core::Vec3f;
using Corners = std::array<glm::dvec3, 3>;

// The corner b, opposite to which the other triangle's corner would be, if the two make a parallelogram.
std::optional<Corners> joined(const Corners& a, const Corners& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &apex = a[i], &next = a[(i + 1) % 3], &last = a[(i + 2) % 3];
        const glm::dvec3 opposite = next + last - apex;
        const double tolerance = 1e-6 * (glm::length(next - apex) + glm::length(last - apex));
        for (std::size_t j = 0; j < 3; ++j)
            if (glm::distance(b[j], opposite) <= tolerance && glm::distance(b[(j + 1) % 3], last) <= tolerance &&
                glm::distance(b[(j + 2) % 3], next) <= tolerance)
                return Corners{apex, next, last};
    }
    return std::nullopt;
}

class FaceMaker {
public:
    explicit FaceMaker(const Scene& scene) : scene_(scene) {}

    FaceList make() {
        list_.isFlat.resize(scene_.instances.size());
        list_.hasNodeSpaces = !scene_.nodeSpaces.empty();
        for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
            const Instance& instance = scene_.instances[i];
            if (instance.isOperand) continue;
            if (const auto* mesh = std::get_if<const Polyhedron*>(&instance.shape))
                list_.isFlat[i] =
                    isSmall(**mesh) && !(*mesh)->hasNormals() && !hasWantedUv(**mesh) && add(instance, **mesh);
            else if (const auto* square = std::get_if<Square>(&instance.shape))
                list_.isFlat[i] = add(instance, *square);
            if (list_.size() > mostFaces) return {};
        }
        collectPoints();
        list_.blockingParallelograms = sortBlockingFirst(list_.parallelograms);
        list_.blockingTriangles = sortBlockingFirst(list_.triangles);
        return std::move(list_);
    }

private:
    bool hasWantedUv(const Polyhedron& mesh) const { return scene_.hasTextures() && !mesh.uvs().empty(); }
    static bool isSmall(const Polyhedron& mesh) { return mesh.triangleCount() <= 2 * mostFaces; }

    // Adds all its faces, or none where one of them is a needle; returns whether it did.
    bool add(const Instance& instance, const Polyhedron& mesh) {
        const std::size_t parallelograms = list_.parallelograms.size(), triangles = list_.triangles.size();
        const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
        const core::Transform map = instance.place.worldFromObject();
        const auto corners = [&](std::uint32_t triangle) {
            Corners c;
            for (int k = 0; k < 3; ++k) c[static_cast<std::size_t>(k)] = map.point(mesh.vertex(triangle, k));
            return c;
        };
        const bool isMirrored = glm::dot(glm::cross(map.x, map.y), map.z) < 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Corners first = corners(i);
            const auto pair = i + 1 < count ? joined(first, corners(i + 1)) : std::nullopt;
            auto& faces = pair ? list_.parallelograms : list_.triangles;
            const Corners c = pair.value_or(first);
            if (!addFace(faces, instance, isMirrored ? Corners{c[0], c[2], c[1]} : c, -1)) {
                list_.parallelograms.resize(parallelograms);
                list_.triangles.resize(triangles);
                return false;
            }
            if (pair) ++i;
        }
        return true;
    }

    bool add(const Instance& instance, const Square& square) {
        const AreaLight& light = scene_.lights.of<AreaLight>()[square.light];
        const Vec3f side = glm::cross(light.edge1, light.edge2);
        const bool isTurned = glm::dot(side, light.normal) < 0;
        const glm::dvec3 corner(light.corner), end1(corner + glm::dvec3(light.edge1)),
            end2(corner + glm::dvec3(light.edge2));
        return addFace(list_.parallelograms, instance,
                       isTurned ? Corners{corner, end2, end1} : Corners{corner, end1, end2},
                       static_cast<int>(square.light));
    }

    // At the corners of a face.
    static std::array<Coordinates<float>, 3> coordinatesOf(const Instance& instance, const Corners& c,
                                                           const Vec3f& normal) {
        const Vec3f objectNormal = instance.place.worldFromObject().transposed(normal);
        std::array<Coordinates<float>, 3> at;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const ShapePoint<float> point{instance.place.objectFromWorld().point(Vec3f(c[i])), objectNormal, true};
            const auto* mesh = std::get_if<const Polyhedron*>(&instance.shape);
            at[i] = mesh != nullptr ? (*mesh)->flatCoordinatesAt(point)
                                    : std::get<Square>(instance.shape).coordinatesAt(point);
        }
        return at;
    }

    std::array<Vec3f, 3> inNodeOf(const Instance& instance, const Corners& c) const {
        std::array<Vec3f, 3> at{};
        if (scene_.nodeSpaces.empty()) return at;
        const core::Transform& space = scene_.nodeSpaces[static_cast<std::size_t>(&instance - scene_.instances.data())];
        for (std::size_t i = 0; i < at.size(); ++i)
            at[i] = space.point(instance.place.objectFromWorld().point(Vec3f(c[i])));
        return at;
    }

    // c: counterclockwise as seen from the normal's side. Refuses a needle: a face is tested a hair too large, by so
    // much of its length that a needle, many times as long as wide, would be much too wide.
    bool addFace(std::vector<Face>& faces, const Instance& instance, const Corners& c, int light) {
        const glm::dvec3 edge1 = c[1] - c[0], edge2 = c[2] - c[0], across = glm::cross(edge1, edge2);
        const double square = glm::dot(across, across);
        const glm::dvec3 toU = glm::cross(edge2, across) / square, toV = glm::cross(across, edge1) / square;
        const Vec3f normal(glm::normalize(across));
        const std::array<Coordinates<float>, 3> at = coordinatesOf(instance, c, normal);
        const std::array<Vec3f, 3> inNode = inNodeOf(instance, c);
        // A step of the error's 2.4-fold along each axis, across an edge that meets its neighbour at 15 degrees.
        const auto reach = [](const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
        const auto margin = static_cast<float>(4 * 2.4 * std::max({reach(toU), reach(toV), reach(toU + toV)}));
        const auto extent = static_cast<float>(reach(edge1) + reach(edge2));
        constexpr double mostSlender = 1024;
        if (!(reach(edge1) + reach(edge2) < mostSlender / std::max(reach(toU), reach(toV)))) return false;
        faces.push_back({Vec3f(c[0]),
                         normal,
                         Vec3f(edge1),
                         Vec3f(edge2),
                         Vec3f(toU),
                         Vec3f(toV),
                         at[0].uv,
                         at[1].uv - at[0].uv,
                         at[2].uv - at[0].uv,
                         instance.place.worldFromObject().vector(at[0].tangent),
                         inNode[0],
                         inNode[1] - inNode[0],
                         inNode[2] - inNode[0],
                         instance.error,
                         instance.errorPerUnit(),
                         extent,
                         static_cast<float>(reach(toU)),
                         static_cast<float>(reach(toV)),
                         margin,
                         static_cast<float>(instance.material),
                         static_cast<float>(light)});
        return true;
    }

    // Points such that whatever lies behind a plane has some of them there, with how far rounding may have moved each.
    void collectPoints() {
        // What has no end is behind all planes but those along it, and shadow rays to an endless light leave the scene.
        hasEndless_ = std::any_of(scene_.instances.begin(), scene_.instances.end(),
                                  [](const Instance& instance) { return isEndless(instance.shape); }) ||
                      scene_.lights.placed() < scene_.lights.size();
        if (hasEndless_) return;
        for (const Instance& instance : scene_.instances) {
            const auto add = [&](const Vec3f& p) {
                points_.push_back({p, instance.error + instance.errorPerUnit() * core::largestComponent(p)});
            };
            const auto* mesh = std::get_if<const Polyhedron*>(&instance.shape);
            if (mesh != nullptr && isSmall(**mesh)) {
                const core::Transform map = instance.place.worldFromObject();
                for (std::uint32_t i = 0; i < (*mesh)->triangleCount(); ++i)
                    for (int k = 0; k < 3; ++k) add(map.point((*mesh)->vertex(i, k)));
            } else {
                const core::Bounds bounds = instance.bounds();
                for (int corner = 0; corner < 8; ++corner)
                    add({corner & 1 ? bounds.low.x : bounds.high.x, corner & 2 ? bounds.low.y : bounds.high.y,
                         corner & 4 ? bounds.low.z : bounds.high.z});
            }
            if (points_.size() > mostPoints) return;
        }
        scene_.lights.forEach([&]<class Light>(const Light& light) {
            if constexpr (!Light::canBeMet && !Light::isEndless) points_.push_back({light.bounds().centre, 0});
        });
    }

    // Between two points in front of a plane, it does not stand. What touches the plane counts as in front: the faces
    // that meet in a room's corner do, and a ball on the floor.
    bool isBlocking(const Face& face) const {
        if (hasEndless_ || points_.size() > mostPoints) return true;
        for (const Vec3f& normal : {face.normal, -face.normal}) {
            const auto isBehind = [&](const Point& point) {
                const double distance = glm::dot(glm::dvec3(normal), glm::dvec3(point.place) - glm::dvec3(face.corner));
                const float error = face.error + face.errorPerUnit * core::largestComponent(point.place);
                return distance < -4.0 * static_cast<double>(error + point.error);
            };
            if (std::none_of(points_.begin(), points_.end(), isBehind)) return false;
        }
        return true;
    }

    std::size_t sortBlockingFirst(std::vector<Face>& faces) const {
        const auto end =
            std::stable_partition(faces.begin(), faces.end(), [&](const Face& face) { return isBlocking(face); });
        return static_cast<std::size_t>(end - faces.begin());
    }

    const Scene& scene_;
    FaceList list_;
    struct Point {
        Vec3f place;
        float error;
    };
    static constexpr std::size_t mostPoints = 4096;  // all faces are compared with all of them
    std::vector<Point> points_;
    bool hasEndless_ = false;
};

}  // namespace

FaceList facesOf(const Scene& scene) {
    return FaceMaker(scene).make();
}

}  // namespace gr
