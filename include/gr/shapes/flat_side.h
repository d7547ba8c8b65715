// The flat parts of a shape's surface: what another flat part can touch all over.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace gr {

// A triangle, or a parallelogram round something flat. Its outward normal is that of edge1 x edge2.
struct FlatSide {
    glm::dvec3 corner, edge1, edge2;
    bool isTriangle = false;
};

// Round a disc across the y axis that looks upwards or downwards.
inline FlatSide squareAcrossY(double y, double radius, bool looksUp) {
    const glm::dvec3 x(2 * radius, 0, 0), z(0, 0, 2 * radius);
    return {{-radius, y, -radius}, looksUp ? z : x, looksUp ? x : z};
}

}  // namespace gr
