// Rays that lie just so: along axes and faces, through edges and corners, from within.

#include "gr/mesh/pack.h"
#include "gr/random_shapes.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::infinity;
using core::Rayf;
using core::Vec3f;

float meet(const Polyhedron& polyhedron, const Rayf& ray) {
    Hit hit;
    polyhedron.intersect(PackRay(ray), 0, hit);
    EXPECT_EQ(polyhedron.occluded(PackRay(ray)), hit.t < infinity);
    return hit.t;
}

TEST(SphereEdges, AlongAnAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.f, 1.f}) {
            Vec3f way(0), aside(0);
            way[axis] = side;
            aside[(axis + 1) % 3] = 0.6f;
            EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{-3.f * way, way}), 2);
            EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{-3.f * way + aside, way}), 2.2f);
            EXPECT_EQ(Sphere{}.intersect(Rayf{3.f * way, way}), infinity) << "behind the ray";
            EXPECT_EQ(Sphere{}.intersect(Rayf{-3.f * way + 2.f * aside, way}), infinity) << "beside it";
        }
    }
}

TEST(SphereEdges, FromWithin) {
    EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{Vec3f(0), {0, 1, 0}}), 1);
    EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{{0, 0.5f, 0}, {0, 1, 0}}), 0.5f);
    EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{{0, 0.5f, 0}, {0, -1, 0}}), 1.5f);
    EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{{0.6f, 0, 0}, {0, 0, -1}}), 0.8f);
}

TEST(SphereEdges, TIsInUnitsOfTheDirection) {
    EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{{0, 0, -3}, {0, 0, 8}}), 0.25f);
    EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{{0, 0, -3}, {0, 0, 1e-3f}}), 2000);
}

// From as far away as single precision still tells the sphere from a point, it is met or missed by the rounding of the
// origin alone.
TEST(SphereEdges, FromFarAway) {
    for (const float distance : {1e2f, 1e4f, 1e6f}) {
        EXPECT_FLOAT_EQ(Sphere{}.intersect(Rayf{{0.8f, 0, -distance}, {0, 0, 1}}), distance - 0.6f);
        EXPECT_LT(Sphere{}.intersect(Rayf{{0.9999f, 0, -distance}, {0, 0, 1}}), infinity);
        EXPECT_EQ(Sphere{}.intersect(Rayf{{1.0001f, 0, -distance}, {0, 0, 1}}), infinity);
    }
}

TEST(BoxEdges, AlongAnAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float zero : {0.f, -0.f}) {
            Vec3f up(zero), from(0.25f);
            up[axis] = 1;
            from[axis] = -2;
            EXPECT_EQ(Box{}.intersect(Rayf{from, up}), 2);
            EXPECT_EQ(Box{}.intersect(Rayf{from, -up}), infinity);
            from[axis] = 3;
            EXPECT_EQ(Box{}.intersect(Rayf{from, -up}), 2);
            EXPECT_EQ(Box{}.intersect(Rayf{from, up}), infinity);
            from[axis] = 0.75f;
            EXPECT_EQ(Box{}.intersect(Rayf{from, up}), 0.25f) << "from within";
            EXPECT_EQ(Box{}.intersect(Rayf{from, -up}), 0.75f) << "from within";
            from = Vec3f(0.25f);
            from[axis] = -2;
            from[(axis + 1) % 3] = 1.5f;
            EXPECT_EQ(Box{}.intersect(Rayf{from, up}), infinity) << "beside it";
            from[(axis + 1) % 3] = -1e-6f;
            EXPECT_EQ(Box{}.intersect(Rayf{from, up}), infinity) << "beside it";
        }
    }
}

// The faces and edges belong to the box, at 0 as at 1, whichever zero the direction has.
TEST(BoxEdges, InTheFacesPlanes) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float zero : {0.f, -0.f}) {
            for (const float u : {0.f, -0.f, 1.f, 0.5f}) {
                for (const float v : {0.f, -0.f, 1.f, 0.5f}) {
                    Vec3f from, up(zero);
                    from[axis] = -1;
                    from[(axis + 1) % 3] = u;
                    from[(axis + 2) % 3] = v;
                    up[axis] = 1;
                    EXPECT_EQ(Box{}.intersect(Rayf{from, up}), 1) << axis << " " << zero << " " << u << " " << v;
                }
            }
        }
    }
}

TEST(BoxEdges, FromWithinToEveryCorner) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3f target(corner & 1, corner >> 1 & 1, corner >> 2);
        for (const Vec3f& from : {Vec3f(0.5f), Vec3f(0.25f, 0.5f, 0.75f), Vec3f(0.1f, 0.9f, 0.3f)})
            EXPECT_NEAR(Box{}.intersect(Rayf{from, target - from}), 1, 1e-6f);
    }
}

TEST(SquareEdges, FromBothSidesUpToItsEdges) {
    for (const float side : {-1.f, 1.f}) {
        EXPECT_EQ(Square{}.intersect(Rayf{{0, -2 * side, 0}, {0, side, 0}}), 2);
        EXPECT_EQ(Square{}.intersect(Rayf{{0.5f, -2 * side, 0.5f}, {0, side, 0}}), 2);
        EXPECT_EQ(Square{}.intersect(Rayf{{-0.5f, -2 * side, 0}, {0, side, 0}}), 2);
        EXPECT_EQ(Square{}.intersect(Rayf{{0.500001f, -2 * side, 0}, {0, side, 0}}), infinity);
        EXPECT_EQ(Square{}.intersect(Rayf{{0, -2 * side, -0.500001f}, {0, side, 0}}), infinity);
        EXPECT_EQ(Square{}.intersect(Rayf{{0, 2 * side, 0}, {0, side, 0}}), infinity) << "behind the ray";
    }
}

TEST(SquareEdges, IsNotMetEdgeOn) {
    for (const float y : {-1.f, 0.f, 1.f}) {
        EXPECT_EQ(Square{}.intersect(Rayf{{-2, y, 0}, {1, 0, 0}}), infinity);
        EXPECT_EQ(Square{}.intersect(Rayf{{0, y, 0}, {1, -0.f, 1}}), infinity);
    }
}

TEST(PolyhedronEdges, ACubeAlongAnAxis) {
    const PolyhedronNode cube = polyhedronNode(cubeMesh());
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.f, 1.f}) {
            Vec3f way(0);
            way[axis] = side;
            // Through the middle of a face, across its diagonal, along its edges and through its corners.
            for (const float u : {0.f, 0.3f, -1.f, 1.f}) {
                for (const float v : {0.f, 0.3f, -0.2f, -1.f, 1.f}) {
                    Vec3f from = -3.f * way;
                    from[(axis + 1) % 3] = u;
                    from[(axis + 2) % 3] = v;
                    EXPECT_EQ(meet(*cube.polyhedron, {from, way}), 2) << axis << " " << u << " " << v;
                    EXPECT_EQ(meet(*cube.polyhedron, {from, -way}), infinity);
                    from[axis] = 0.5f * side;
                    EXPECT_EQ(meet(*cube.polyhedron, {from, way}), 0.5f) << "from within";
                    from[(axis + 1) % 3] = 1.000001f;
                    EXPECT_EQ(meet(*cube.polyhedron, {from, way}), infinity) << "beside it";
                }
            }
        }
    }
}

TEST(PolyhedronEdges, ATriangleHasTwoSidesAndNoEdge) {
    const PolyhedronNode triangle = polyhedronNode({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    EXPECT_EQ(meet(*triangle.polyhedron, {{0.25f, 0.25f, 2}, {0, 0, -1}}), 2);
    EXPECT_EQ(meet(*triangle.polyhedron, {{0.25f, 0.25f, -2}, {0, 0, 1}}), 2);
    EXPECT_EQ(meet(*triangle.polyhedron, {{-1, 0.25f, 0}, {1, 0, 0}}), infinity);
    EXPECT_EQ(meet(*triangle.polyhedron, {{-1, 0, 0}, {1, 0, 0}}), infinity);
    EXPECT_EQ(meet(*triangle.polyhedron, {{0.6f, 0.6f, -2}, {0, 0, 1}}), infinity);
}

TEST(Shapes, AreMetBeforeTMaxOnly) {
    const PolyhedronNode cube = polyhedronNode(cubeMesh());
    const auto shorten = [](Rayf ray, float tMax) {
        ray.tMax = tMax;
        return ray;
    };
    const Rayf ray{{0.25f, -3, 0.25f}, {0, 1, 0}};
    const float tSphere = Sphere{}.intersect(ray);
    for (const bool before : {false, true}) {
        const auto end = [&](float t) { return before ? std::nextafter(t, infinity) : t; };
        EXPECT_EQ(Sphere{}.intersect(shorten(ray, end(tSphere))), before ? tSphere : infinity);
        EXPECT_EQ(Box{}.intersect(shorten(ray, end(3))), before ? 3 : infinity);
        EXPECT_EQ(Square{}.intersect(shorten(ray, end(3))), before ? 3 : infinity);
        EXPECT_EQ(meet(*cube.polyhedron, shorten(ray, end(2))), before ? 2 : infinity);
    }
}

}  // namespace
}  // namespace gr
