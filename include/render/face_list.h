// The flat faces of a small scene, made ready to be tested against many rays at once, one face after the other.
#pragma once

#include "gr/scene.h"

namespace render {

// A parallelogram or a triangle in the world. All numbers are floats, so that lanes can gather them.
struct Face {
    core::Vec3f corner;
    core::Vec3f normal;  // unit length, outward
    core::Vec3f edge1, edge2;
    core::Vec3f toU, toV;  // of the way from the corner to a point corner + u edge1 + v edge2 they make u and v
    core::Vec3f tangent;  // see gr::SurfacePoint
    float error, errorPerUnit;  // see gr::Instance
    float extent;  // the sum of its edges along the axes
    float reachU, reachV;  // the sum of toU, of toV, along the axes
    float margin;  // over the error: how much of u, of v and of 1 - u - v a point should keep from the edges
    float material, light;  // indices; light is -1 where nothing shines
};

struct FaceList {
    std::vector<Face> parallelograms, triangles;
    // The first so many of each may stand between two points of the scene. Behind all others nothing lies.
    std::size_t blockingParallelograms = 0, blockingTriangles = 0;

    std::size_t size() const { return parallelograms.size() + triangles.size(); }
};

// Of a scene's squares, and of its meshes that have no normals of their own.
FaceList facesOf(const gr::Scene& scene);

}  // namespace render
