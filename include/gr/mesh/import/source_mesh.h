// A mesh as its file tells it: what a reader makes, and all that is kept of the file.
#pragma once

#include "core/vec.h"
#include "gr/mesh/octahedral.h"

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gr::importer {

// What is wrong with a file, in words for a person: the end of a sentence that begins "cannot read "name": ".
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline constexpr double mostCoordinate = 1e18;  // its square is still a float

// normal: of any length.
inline PackedNormal packedOrNone(const core::Vec3f& normal) {
    const float size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    return size > 0 && size < core::infinity ? packNormal(normal) : noNormal;
}

// Faces that follow each other and belong together, to the next group's first one.
struct SourceGroup {
    std::string name, material;  // "" where the file gives none
    int firstFace = 0;
};

// Vertices are numbered as the file does it; several may be at one place, and faces need not use all of them.
class SourceMesh {
public:
    std::vector<glm::dvec3> vertices;
    std::vector<int> corners;  // of all faces, one face after another, as numbers of vertices
    std::vector<int> ends;  // of each face in `corners`; empty: all faces are triangles
    // Of each corner. Shorter ones than `corners`, or none: corners behind their end have nothing of the kind.
    std::vector<PackedNormal> normals;  // noNormal where there is none
    std::vector<core::Vec2f> uvs;  // v upwards: {0 0} is a picture's lower left corner
    std::vector<core::Rgbf> colours;  // linear
    std::vector<SourceGroup> groups;  // the first one at face 0; or empty
    std::uint32_t linesAndPoints = 0;  // left out
    std::uint32_t absentReferences = 0;  // corners that name a normal or u v which the file does not have

    int faceCount() const { return static_cast<int>(ends.empty() ? corners.size() / 3 : ends.size()); }

    // Says that the corners that were added since the last face are one. Throws Failure where there are too many.
    void endFace() {
        if (corners.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw Failure("its faces have more than 2147483647 corners in all");
        const std::size_t first = static_cast<std::size_t>(ends.empty() ? 3 * triangles_ : ends.back());
        const bool isTriangle = corners.size() - first == 3;
        if (isTriangle && ends.empty()) {
            ++triangles_;
            return;
        }
        // All faces before the first one that is no triangle were some.
        if (ends.empty())
            for (int i = 1; i <= triangles_; ++i) ends.push_back(3 * i);
        ends.push_back(static_cast<int>(corners.size()));
    }

    // Faces from here on belong to this group.
    void beginGroup(std::string name, std::string material) {
        const int face = ends.empty() ? triangles_ : static_cast<int>(ends.size());
        if (!groups.empty() && groups.back().firstFace == face) groups.pop_back();
        if (groups.empty() && face > 0) groups.push_back({"", "", 0});
        groups.push_back({std::move(name), std::move(material), face});
    }

private:
    int triangles_ = 0;  // as long as all faces are triangles: how many
};

// Says what a corner has. Corners before it of which nothing was said have `none`.
template<class Value>
void setOf(std::size_t corner, std::vector<Value>& values, const Value& value, const Value& none) {
    values.resize(corner, none);
    values.push_back(value);
}

}  // namespace gr::importer
