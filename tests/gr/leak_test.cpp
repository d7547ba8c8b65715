// Light does not leak out of bodies with sharp edges, with many faces, or out of rooms put together from parts.

#include "gr/no_leak.h"

namespace gr {
namespace {

void expectNoLeak(const PolygonMesh& mesh, const glm::dvec3& inside, int rays) {
    expectClosed(inside, rays, [&](Database& database) { database.create(":body", "mesh", polyhedronNode(mesh)); });
}

TEST(Leak, Tetrahedron) {
    const PolygonMesh mesh{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                           {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
    expectNoLeak(mesh, glm::dvec3(0), rayCount(200'000));
}

TEST(Leak, WedgeOf15Degrees) {
    const double height = std::tan(glm::radians(15.));
    const PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, height, 0}, {0, 0, 1}, {1, 0, 1}, {1, height, 1}},
                           {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}};
    expectNoLeak(mesh, {0.7, 0.3 * height, 0.5}, rayCount(200'000));
}

TEST(Leak, Needle) {
    const PolygonMesh mesh{{{-0.05, 0, -0.05}, {0.05, 0, -0.05}, {0.05, 0, 0.05}, {-0.05, 0, 0.05}, {0, 1, 0}},
                           {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}};
    expectNoLeak(mesh, {0, 0.2, 0}, rayCount(200'000));
}

// Where a triangle is long and thin, its areas are small differences of large products: computed like others', t is so
// far off that rays meet the face they have just left, and its normal leans along it.
TEST(Leak, ThinPlank) {
    for (const double width : {0.01, 0.002}) {
        PolygonMesh plank = cubeMesh();
        // Turned, so that no coordinate of an edge is 0.
        const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, 3)),
                         y = glm::normalize(glm::cross(x, glm::dvec3(0, 0, 1)));
        for (glm::dvec3& v : plank.vertices) v = glm::dmat3(x, y, glm::cross(x, y)) * (v * glm::dvec3(1, width, width));
        expectNoLeak(plank, glm::dvec3(0), rayCount(200'000));
    }
}

// Long along one axis by itself, and along another by its scale. Seen to fail with an error bound that takes the
// largest of each, as if the room were a thousand times as long as it is.
TEST(Leak, LongRoomScaledAlongAnotherAxis) {
    PolygonMesh room = cubeMesh();
    for (glm::dvec3& v : room.vertices) v.z *= 1000;
    expectClosed(glm::dvec3(0), rayCount(200'000), [&](Database& database) {
        database.create(":body", "room", polyhedronNode(room));
        database.scale(":body:room", glm::dvec3(0), {1000, 1, 1});
    });
}

TEST(Leak, PrismOfAThousandSides) {
    constexpr int sides = 1000;
    PolygonMesh mesh;
    mesh.faces.resize(2);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * M_PI * i / sides;
        mesh.vertices.push_back({std::cos(angle), 0, std::sin(angle)});
        mesh.vertices.push_back({std::cos(angle), 1, std::sin(angle)});
        const int next = (i + 1) % sides;
        mesh.faces[0].push_back(2 * i);
        mesh.faces[1].push_back(2 * i + 1);
        mesh.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    expectNoLeak(mesh, {0, 0.5, 0}, rayCount(30'000));
}

TEST(Leak, RoomOfSeparateWalls) {
    PolygonMesh room = cubeMesh();
    for (glm::dvec3& v : room.vertices) v = v * glm::dvec3(1.1, 0.7, 1.3) + glm::dvec3(0.03, 0.01, -0.07);
    expectClosed(glm::dvec3(0), rayCount(200'000), [&](Database& database) {
        for (const std::vector<int>& face : room.faces) {
            PolygonMesh wall;
            for (const int v : face) wall.vertices.push_back(room.vertices[v]);
            wall.faces = {{0, 1, 2, 3}};
            database.create(":body", "wall" + std::to_string(database.nodeCount()), polyhedronNode(wall));
        }
    });
}

TEST(Leak, RoomOfOverlappingBoxes) {
    expectClosed(glm::dvec3(0), rayCount(200'000), [](Database& database) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1., 1.}) {
                glm::dvec3 corner(-1.1), size(2.2);
                corner[axis] = side < 0 ? -1.1 : 1;
                size[axis] = 0.1;
                database.create(":body", "wall" + std::to_string(database.nodeCount()), BoxNode{corner, size});
            }
        }
    });
}

}  // namespace
}  // namespace gr
