#include "gr/placing.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace gr {
namespace {

glm::dmat3 absolute(const glm::dmat4& matrix) {
    return {glm::abs(glm::dvec3(matrix[0])), glm::abs(glm::dvec3(matrix[1])), glm::abs(glm::dvec3(matrix[2]))};
}

// The largest absolute coordinates of any point of a shape, along each of its own axes; of one that is endless 0.
glm::dvec3 extentOf(const Shape& shape) {
    if (isEndless(shape)) return glm::dvec3(0);
    const core::Bounds bounds = boundsOf(shape);
    return glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
}

// What a placement makes of numbers that are each off by no more than so much, row by row, at the most:
struct Sizes {
    double extent = 0;  // |worldFromObject| |the shape's extent|
    double thereAndBack = 0;  // |worldFromObject| |objectFromWorld| |1|
    double extentThereAndBack = 0;  // |worldFromObject| |objectFromWorld| |worldFromObject| |the shape's extent|
    double backTranslation = 0;  // |worldFromObject| |objectFromWorld's translation|

    Sizes(const glm::dmat4& matrix, const glm::dmat4& inverse, const Shape& shape) {
        const glm::dmat3 there = absolute(matrix), back = absolute(inverse);
        const glm::dvec3 inWorld = there * extentOf(shape);
        extent = core::largestComponent(inWorld);
        thereAndBack = core::largestComponent(there * (back * glm::dvec3(1)));
        extentThereAndBack = core::largestComponent(there * (back * inWorld));
        backTranslation = core::largestComponent(there * glm::abs(glm::dvec3(inverse[3])));
    }
};

// How far roundings may move a point along an axis on its way from the object to the world and back, in units of
// u = 2^-24, the relative size of one. |x| is the point's largest coordinate, extent and the like are what Sizes
// has: each axis of the object counts by how far the shape reaches along it and by what the matrix makes of that.
// What is short but stretched and what is long but not are then as large as they are in the world.
// A row times a vector makes 4: the entries, the products and two sums.
//   6 extent                                  where the shape computes it
//   4 extent + |translation| + |x|            in worldFromObject
//   |x|                                       in the step off the surface
//   4 thereAndBack |x| + |back translation| + extent    in objectFromWorld
//   17 extent                                 in the next intersection: a triangle's corners, seen along the ray
// and for a ray along the surface, which goes on for up to twice the extent,
//   2 * 10 extent                             in its direction, out of the frame round the normal
//   2 * (4 + 4) extentThereAndBack            in its direction in the object, and in the normal in the world
// Instance::errorPerUnit is twice what this asks for, since a shadow ray also rounds by how far away it starts.
float errorOf(const glm::dmat4& matrix, const Sizes& sizes) {
    constexpr double u = 0x1p-24;
    return static_cast<float>(u * (48 * sizes.extent + 16 * sizes.extentThereAndBack +
                                   core::largestComponent(glm::dvec3(matrix[3])) + sizes.backTranslation));
}

Placement placementOf(const glm::dmat4& matrix, const glm::dmat4& inverse, const Sizes& sizes, Scene& scene) {
    const core::Transform there(matrix), back(inverse);
    if (matrix == glm::dmat4(1)) return {};
    const auto isAligned = [](const core::Transform& m) {
        return m.x.y == 0 && m.x.z == 0 && m.y.x == 0 && m.y.z == 0 && m.z.x == 0 && m.z.y == 0;
    };
    const auto aligned = [](const core::Transform& m) -> AlignedMap {
        return {{{m.x.x, m.y.y, m.z.z}, m.translation}};
    };
    if (isAligned(there) && isAligned(back)) return Placement::Aligned{aligned(there), aligned(back)};
    scene.placements.push_back(
        std::make_unique<Placement::General>(Placement::General{there, back, static_cast<float>(sizes.thereAndBack)}));
    return Placement(scene.placements.back().get());
}

}  // namespace

void placeAt(Instance& instance, const glm::dmat4& matrix, Scene& scene) {
    const glm::dmat4 inverse = glm::inverse(matrix);
    const Sizes sizes(matrix, inverse, instance.shape);
    instance.place = placementOf(matrix, inverse, sizes, scene);
    instance.error = errorOf(matrix, sizes);
}

// A plane's normal goes by the transposed inverse, which keeps it on the same side of the plane.
glm::dvec3 lampNormal(const glm::dmat4& matrix) {
    return glm::normalize(glm::transpose(glm::inverse(glm::dmat3(matrix))) * glm::dvec3(0, -1, 0));
}

AreaLight lampAt(const glm::dmat4& matrix, const core::Rgbf& radiance, const Instance& instance) {
    const core::Vec3f edge1(matrix[0]), edge2(matrix[2]);
    const core::Vec3f corner(matrix * glm::dvec4(-0.5, 0, -0.5, 1));
    const float area = static_cast<float>(glm::length(glm::cross(glm::dvec3(matrix[0]), glm::dvec3(matrix[2]))));
    const float size = core::largestComponent(corner) + core::largestComponent(edge1) + core::largestComponent(edge2);
    return {corner,
            edge1,
            edge2,
            core::Vec3f(lampNormal(matrix)),
            radiance,
            area,
            instance.error + instance.errorPerUnit() * size,
            instance.errorPerUnit()};
}

}  // namespace gr
