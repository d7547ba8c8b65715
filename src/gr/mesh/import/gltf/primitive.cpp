#include "gr/mesh/import/gltf/primitive.h"

#include "gr/mesh/import/gltf/words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gr::importer {
namespace {

// The vertices that are kept, by their numbers in the file; all of them where the list is empty.
class Kept {
public:
    // Several primitives often share one long list of vertices, of which each uses some: where there are fewer corners
    // than vertices, only those that have a corner are kept. The corners then are numbered by what is kept.
    Kept(std::vector<std::uint32_t>& corners, std::size_t vertexCount) : count_(vertexCount) {
        if (corners.size() >= vertexCount) return;
        numbers_ = corners;
        std::sort(numbers_.begin(), numbers_.end());
        numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
        for (std::uint32_t& corner : corners)
            corner = static_cast<std::uint32_t>(std::lower_bound(numbers_.begin(), numbers_.end(), corner) -
                                                numbers_.begin());
        count_ = numbers_.size();
        isAll_ = false;
    }

    std::size_t count() const { return count_; }
    std::size_t number(std::size_t i) const { return isAll_ ? i : numbers_[i]; }

private:
    std::vector<std::uint32_t> numbers_;
    std::size_t count_;
    bool isAll_ = true;
};

// What an attribute is, for each vertex that is kept, and with what morph targets add.
std::vector<glm::dvec3> morphed(const PrimitiveSource& source, const Accessor& base, const std::string& name,
                                const std::vector<double>& weights, const Kept& kept) {
    std::vector<glm::dvec3> vectors(kept.count());
    for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = base.vector(kept.number(i));
    for (std::size_t target = 0; target < std::min(weights.size(), source.targetCount()); ++target) {
        if (weights[target] == 0) continue;
        const std::optional<Accessor> added = source.targetAttribute(target, name);
        if (!added) continue;
        added->expectType(name, {"VEC3"});
        for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] += weights[target] * added->vector(kept.number(i));
    }
    return vectors;
}

void readNormals(const PrimitiveSource& source, const std::vector<double>& weights, const Kept& kept,
                 Primitive& primitive) {
    const std::optional<Accessor> normals = source.attribute("NORMAL");
    if (!normals) return;
    normals->expectType("NORMAL", {"VEC3"});
    for (const glm::dvec3& normal : morphed(source, *normals, "NORMAL", weights, kept))
        primitive.normals.emplace_back(normal);
}

void readUvs(const PrimitiveSource& source, const Kept& kept, Primitive& primitive) {
    const std::optional<Accessor> uvs = source.attribute("TEXCOORD_0");
    if (!uvs) return;
    uvs->expectType("TEXCOORD_0", {"VEC2"});
    primitive.uvs.resize(kept.count());
    for (std::size_t i = 0; i < kept.count(); ++i)
        primitive.uvs[i] = {uvs->number(kept.number(i), 0), 1 - uvs->number(kept.number(i), 1)};
}

void readColours(const PrimitiveSource& source, const Kept& kept, Primitive& primitive) {
    const std::optional<Accessor> colours = source.attribute("COLOR_0");
    if (!colours) return;
    colours->expectType("COLOR_0", {"VEC3", "VEC4"});
    if (colours->component != Component::float32 && !colours->isNormalised)
        throw Failure("its " + colours->place + " has colours of whole numbers that are not normalised");
    primitive.colours.resize(kept.count());
    for (std::size_t i = 0; i < kept.count(); ++i) primitive.colours[i] = colours->vector(kept.number(i));
}

// Weights are 1 in all but for their rounding. Where all are 0 the first joint has the vertex, as in most programs.
void normalise(std::vector<Influence>& influences, std::size_t first, std::size_t count) {
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i) sum += influences[i].weight;
    if (sum == 0) influences[first].weight = 1;
    for (std::size_t i = first; sum != 0 && i < first + count; ++i)
        influences[i].weight = static_cast<float>(influences[i].weight / sum);
}

void readInfluences(const PrimitiveSource& source, const Kept& kept, Primitive& primitive) {
    std::vector<std::pair<Accessor, Accessor>> sets;
    for (std::size_t set = 0;; ++set) {
        const std::string number = std::to_string(set);
        const std::optional<Accessor> joints = source.attribute("JOINTS_" + number),
                                      weights = source.attribute("WEIGHTS_" + number);
        if (!joints != !weights)
            throw Failure("its " + source.place() + " has only one of JOINTS_" + number + " and WEIGHTS_" + number);
        if (!joints) break;
        joints->expectType("JOINTS_" + number, {"VEC4"});
        joints->expectUnsigned("JOINTS_" + number);
        weights->expectType("WEIGHTS_" + number, {"VEC4"});
        sets.emplace_back(*joints, *weights);
    }
    if (sets.empty()) throw Failure("its " + source.place() + " has no JOINTS_0, but a node gives its mesh a skin");
    primitive.influenceCount = 4 * sets.size();
    primitive.influences.reserve(kept.count() * primitive.influenceCount);
    for (std::size_t i = 0; i < kept.count(); ++i) {
        for (const auto& [joints, weights] : sets)
            for (std::size_t k = 0; k < 4; ++k)
                primitive.influences.push_back(
                    {joints.whole(kept.number(i), k), static_cast<float>(weights.number(kept.number(i), k))});
        normalise(primitive.influences, i * primitive.influenceCount, primitive.influenceCount);
    }
}

std::string materialOf(const GltfDocument& document, const JsonObject& primitive) {
    const std::optional<std::size_t> index = document.named(primitive, "material", materialKind);
    if (!index) return "";
    const std::string name = document.item(materialKind, *index).text("name");
    return name.empty() ? "material " + std::to_string(*index) : name;
}

// Of modes 0 to 3: points, separate lines, a closed line, an open line.
std::uint64_t lineOrPointCount(std::uint64_t mode, std::uint64_t vertices) {
    switch (mode) {
        case 1:
            return vertices / 2;
        case 3:
            return vertices > 0 ? vertices - 1 : 0;
        default:
            return vertices;
    }
}

}  // namespace

Primitive readPrimitive(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& object,
                        const std::vector<double>& weights, bool isSkinned) {
    Primitive primitive;
    primitive.place = object.place();
    primitive.material = materialOf(document, object);
    const std::uint64_t mode = object.whole("mode", 4);
    if (mode > 6) throw Failure(object.subjectOf("mode") + " is " + std::to_string(mode) + ", and glTF has 0 to 6");
    const PrimitiveSource source(document, buffers, object);
    if (!source.hasPositions()) return primitive;
    std::vector<std::uint32_t> indices = source.indices();
    if (mode < 4) {
        primitive.linesAndPoints = lineOrPointCount(mode, indices.size());
        return primitive;
    }
    primitive.corners = trianglesOf(std::move(indices), source.isTriangleList() ? 4 : mode);
    const Kept kept(primitive.corners, source.vertexCount());
    primitive.vertices = morphed(source, source.positions(), "POSITION", weights, kept);
    readNormals(source, weights, kept, primitive);
    readUvs(source, kept, primitive);
    readColours(source, kept, primitive);
    if (isSkinned) readInfluences(source, kept, primitive);
    return primitive;
}

}  // namespace gr::importer
