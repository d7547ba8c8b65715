#include "gr/mesh/import/ply_source.h"
#include "gr/mesh/import/readers.h"
#include "gr/mesh/import/srgb.h"
#include "gr/mesh/import/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace gr::importer {
namespace {

// The places of properties that go together, under the first of some sets of names that an element has; or none.
template<std::size_t count>
std::array<int, count> findAll(const PlyElement& element,
                               std::initializer_list<std::array<std::string_view, count>> sets) {
    std::array<int, count> places{};
    for (const auto& names : sets) {
        for (std::size_t i = 0; i < count; ++i) places[i] = element.find(names[i]);
        if (std::all_of(places.begin(), places.end(), [&](int place) {
                return place >= 0 && !element.properties[static_cast<std::size_t>(place)].isList;
            }))
            return places;
    }
    places.fill(-1);
    return places;
}

class PlyReader {
public:
    explicit PlyReader(std::string_view file) : header_(takePlyHeader(file)), source_(file, header_) {}

    SourceMesh read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                readVertices(element);
            else if (element.name == "face" || element.name == "tristrips")
                readFaces(element, element.name == "tristrips");
            else
                skip(element);
        }
        checkNames();
        addOfVertices();
        return std::move(mesh_);
    }

private:
    // Calls function() with each of the elements in element_.
    template<class Function>
    void forEach(const PlyElement& element, Function&& function) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (!source_.next(element, element_)) failCutOff(element, i);
            function();
        }
    }

    void skip(const PlyElement& element) {
        forEach(element, [] {});
        if (element.name == "edge") mesh_.linesAndPoints += static_cast<std::uint32_t>(element.count);
    }

    template<std::size_t count>
    std::array<double, count> numbersAt(const std::array<int, count>& places) const {
        std::array<double, count> numbers{};
        for (std::size_t i = 0; i < count; ++i) numbers[i] = element_.of(places[i])[0];
        return numbers;
    }

    void readVertices(const PlyElement& element) {
        if (!mesh_.vertices.empty()) throw Failure("its header has two elements \"vertex\"");
        const auto place = findAll<3>(element, {{"x", "y", "z"}}), normal = findAll<3>(element, {{"nx", "ny", "nz"}});
        const auto uv =
            findAll<2>(element, {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}});
        const auto colour = findAll<3>(
            element, {{"red", "green", "blue"}, {"r", "g", "b"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}});
        if (place[0] < 0) throw Failure("its vertices have no x, y and z");
        mesh_.vertices.reserve(element.count);
        forEach(element, [&] {
            const auto [x, y, z] = numbersAt(place);
            mesh_.vertices.emplace_back(x, y, z);
            if (normal[0] >= 0) {
                const auto [nx, ny, nz] = numbersAt(normal);
                normals_.push_back(packedOrNone(core::Vec3f(nx, ny, nz)));
            }
            if (uv[0] >= 0) uvs_.emplace_back(numbersAt(uv)[0], numbersAt(uv)[1]);
            if (colour[0] >= 0) addColour(element, colour);
        });
    }

    // Whole numbers are parts of their type's largest.
    void addColour(const PlyElement& element, const std::array<int, 3>& places) {
        glm::dvec3 colour;
        for (int i = 0; i < 3; ++i) {
            const auto place = static_cast<std::size_t>(places[static_cast<std::size_t>(i)]);
            const PlyType type = element.properties[place].type;
            const double most = type >= PlyType::float32 ? 1 : std::exp2(8. * static_cast<double>(sizeOf(type))) - 1;
            colour[i] = element_.of(static_cast<int>(place))[0] / most;
        }
        colours_.push_back(fromSrgb(colour));
    }

    void readFaces(const PlyElement& element, bool areStrips) {
        const int found = element.find("vertex_indices"), place = found >= 0 ? found : element.find("vertex_index");
        if (place < 0 || !element.properties[static_cast<std::size_t>(place)].isList) {
            if (element.count == 0) return;
            throw Failure("its " + element.name + " elements have no list vertex_indices");
        }
        const int wedge = areStrips ? -1 : element.find("texcoord");
        forEach(element, [&] {
            if (areStrips) return addStrip(element_.of(place));
            const std::size_t first = mesh_.corners.size();
            addFace(element_.of(place));
            if (wedge >= 0 && mesh_.corners.size() > first) addWedges(first, element_.of(wedge));
        });
    }

    int vertexOf(double number) const {
        if (!(std::abs(number) <= std::numeric_limits<int>::max() && number == std::floor(number)))
            throw Failure("a face names a vertex by what is no whole number");
        return static_cast<int>(number);
    }

    void addFace(std::span<const double> numbers) {
        if (numbers.size() < 3) {
            ++mesh_.linesAndPoints;
            return;
        }
        for (const double number : numbers) mesh_.corners.push_back(vertexOf(number));
        mesh_.endFace();
    }

    // Each vertex makes a triangle with the two before it, every other one the other way round; -1 begins anew. Where
    // two are the same nothing is meant to be seen.
    void addStrip(std::span<const double> numbers) {
        std::size_t first = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i] == -1) first = i + 1;
            if (i < first + 2) continue;
            const double a = numbers[i - 2], b = numbers[i - 1], c = numbers[i];
            if (a == b || b == c || c == a) continue;
            const bool isTurned = (i - first) % 2 != 0;
            addFace(std::array{isTurned ? b : a, isTurned ? a : b, c});
        }
    }

    // u v of a face's corners.
    void addWedges(std::size_t first, std::span<const double> numbers) {
        if (numbers.size() != 2 * (mesh_.corners.size() - first)) return;
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            setOf(first + i / 2, mesh_.uvs, core::Vec2f(numbers[i], numbers[i + 1]), core::Vec2f(0));
    }

    void checkNames() const {
        const std::size_t count = mesh_.vertices.size();
        for (const int corner : mesh_.corners)
            if (corner < 0 || static_cast<std::size_t>(corner) >= count)
                throw Failure("a face names vertex " + std::to_string(corner) + " of " + std::to_string(count));
    }

    // What vertices have their corners have.
    void addOfVertices() {
        const auto add = [&](auto& ofCorners, const auto& ofVertices) {
            if (ofVertices.empty() || !ofCorners.empty()) return;
            ofCorners.reserve(mesh_.corners.size());
            for (const int corner : mesh_.corners) ofCorners.push_back(ofVertices[static_cast<std::size_t>(corner)]);
        };
        add(mesh_.normals, normals_);
        add(mesh_.uvs, uvs_);
        add(mesh_.colours, colours_);
    }

    PlyHeader header_;
    PlySource source_;
    ElementNumbers element_;
    SourceMesh mesh_;
    // Of the vertices:
    std::vector<PackedNormal> normals_;
    std::vector<core::Vec2f> uvs_;
    std::vector<core::Rgbf> colours_;
};

}  // namespace

SourceMesh readPly(std::string_view file) {
    return PlyReader(withoutByteOrderMark(file)).read();
}

}  // namespace gr::importer
