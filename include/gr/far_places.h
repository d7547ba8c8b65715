// Shapes so small and so far away that single precision cannot tell where they stand.
#pragma once

#include "gr/scene.h"

#include <glm/mat4x4.hpp>

#include <string>

namespace gr {

struct Node;

// Single precision rounds a place to a grid, which is the wider the farther away it is: 2^-23 to 2^-24 of its largest
// coordinate. A shape is noted where that is more than a hundredth of its size: then it is not where it should be, and
// not round.
class FarPlaces {
public:
    // matrix: from the shape's own space to the scene.
    void note(const Node& node, const Shape& shape, const glm::dmat4& matrix);

    // A text for the user that names the shape whose place is rounded most for its size; empty if none was noted.
    // origin: the scene's own, in the world.
    std::string warning(const glm::dvec3& origin) const;

private:
    const Node* worst_ = nullptr;
    double distance_ = 0, grid_ = 0;  // of the worst
    double ratio_ = 0;  // its grid to its size
    std::size_t count_ = 0;
};

}  // namespace gr
