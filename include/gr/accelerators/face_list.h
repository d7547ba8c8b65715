// The flat faces of a scene that has few, made ready to be tested against many rays at once, one face after the other.
#pragma once

#include "gr/light.h"
#include "gr/shape.h"

#include <vector>

namespace gr {

class Scene;

// A parallelogram or a triangle in the world. All numbers are floats, so that lanes can gather them.
struct Face {
    core::Vec3f corner;
    core::Vec3f normal;  // unit length, outward
    core::Vec3f edge1, edge2;
    core::Vec3f toU, toV;  // of the way from the corner to a point corner + u edge1 + v edge2 they make u and v
    core::Vec2f uv, uvAlong1, uvAlong2;  // of the corner, and how much they grow along the edges
    core::Vec3f tangent;  // see SurfacePoint
    core::Vec3f inNode, inNodeAlong1, inNodeAlong2;  // likewise, as uv
    float error, errorPerUnit;  // see Instance
    float extent;  // the sum of its edges along the axes
    float reachU, reachV;  // the sum of toU, of toV, along the axes
    float margin;  // over the error: how much of u, of v and of 1 - u - v a point should keep from the edges
    float material, light;  // indices; light is -1 where nothing shines
};

// How many faces are few.
inline constexpr std::size_t mostFaces = 64;

struct FaceList {
    std::vector<Face> parallelograms, triangles;
    bool hasNodeSpaces = false;  // whether inNode is there
    std::vector<bool> isFlat;  // of each instance, whether it is here
    // The first so many of each may stand between two points of the scene. Behind all others nothing lies.
    std::size_t blockingParallelograms = 0, blockingTriangles = 0;

    std::size_t size() const { return parallelograms.size() + triangles.size(); }
};

// Of a scene's squares, and of its small meshes that have no normals of their own, no needles, and no u and v that a
// texture may ask for; none where these are more than few.
FaceList facesOf(const Scene& scene);

}  // namespace gr
