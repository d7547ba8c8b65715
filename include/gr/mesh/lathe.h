// Meshes turned round the y axis, as on a lathe.
#pragma once

#include "gr/mesh/polyhedron.h"

#include <span>

namespace gr {

// A point of the outline that is turned: how far from the axis, and how high.
struct ProfilePoint {
    double r, y;

    bool operator==(const ProfilePoint&) const = default;
};

// At a corner that turns by more than this, degrees, the surface has an edge.
inline constexpr double sharpProfile = 40;
inline constexpr int mostLatheFaces = 5'000'000;

// The profile turned round, in so many segments of a full turn. Where the profile comes to the axis the mesh has a
// pole, a fan of triangles round one vertex; parts of the profile on the axis make nothing. A profile whose last point
// is its first is a ring. Normals are those of the profile's own segments, turned round, and at a point where they
// differ by at most sharpProfile the mean of both. u is the longitude, from the -z side by way of -x, as on spheres; v
// goes from 0 to 1 along the profile, by length. A closed mesh faces outwards, an open one away from the axis.
//
// profile: at least two points, finite, r at least 0. Throws core::Error for equal neighbours, a profile that crosses
// or touches itself elsewhere than on the axis, one that never leaves the axis, and one of more faces than
// mostLatheFaces. Of n points the search for crossings takes n log n where few parts lie side by side.
FlatMesh latheMesh(std::span<const ProfilePoint> profile, int segments);

}  // namespace gr
