// The outline that a lathe turns.
#pragma once

#include "gr/mesh/lathe.h"

#include <vector>

namespace gr {

// A straight part of a profile that leaves the axis, and so makes a surface.
struct ProfileSegment {
    int first, second;  // numbers of its points
    glm::dvec2 direction;  // of unit length, in r and y
    double start, end;  // along the profile: 0 to 1 by length
    glm::dvec2 normals[2];  // at its first and second point, of unit length, to the right of the direction
};

// The segments, each with its normals. Throws core::Error as latheMesh does.
std::vector<ProfileSegment> segmentsOf(std::span<const ProfilePoint> profile);

}  // namespace gr
