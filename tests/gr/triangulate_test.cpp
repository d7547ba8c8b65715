#include "gr/error_of.h"
#include "gr/mesh/mesh_repair.h"

#include <algorithm>
#include <numbers>
#include <random>

namespace gr {
namespace {

using Outline = std::vector<glm::dvec2>;

// As vertices; a face that crosses itself is an error.
std::vector<glm::ivec3> triangulate(const PolygonMesh& mesh) {
    const FlatMesh flat(mesh);
    MeshRepairs repairs;
    std::vector<glm::ivec3> triangles = gr::triangulate(flat, Crossing::isAnError, repairs);
    for (glm::ivec3& triangle : triangles)
        triangle = {flat.corners[triangle.x], flat.corners[triangle.y], flat.corners[triangle.z]};
    return triangles;
}

glm::dvec3 faceNormal(const PolygonMesh& mesh, const std::vector<int>& face) {
    return gr::faceNormal(mesh.vertices, face);
}

Outline star(int points, double inner) {
    Outline outline;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points, radius = i % 2 == 0 ? 1 : inner;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

// A back with teeth to the right.
Outline comb(int teeth) {
    Outline outline{{0, 0}};
    for (int i = 0; i < teeth; ++i) {
        outline.insert(outline.end(), {{10, 2 * i}, {10, 2 * i + 1}, {1, 2 * i + 1}, {1, 2 * i + 2}});
    }
    outline.back() = {0, 2.0 * teeth - 1};
    outline.erase(outline.end() - 2);
    return outline;
}

// A band that winds inwards.
Outline spiral(double turns, int corners) {
    Outline outline;
    const auto add = [&](int i, double width) {
        const double angle = 2 * std::numbers::pi * turns * i / corners;
        const double radius = 20 - 2 * angle / (2 * std::numbers::pi) - width;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i <= corners; ++i) add(i, 0);
    for (int i = corners; i >= 0; --i) add(i, 1);
    return outline;
}

double areaOf(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

// The outline as the one face of a mesh in the plane that u and v span.
PolygonMesh faceOf(const Outline& outline, const glm::dvec3& u = {1, 0, 0}, const glm::dvec3& v = {0, 1, 0}) {
    PolygonMesh mesh;
    std::vector<int>& face = mesh.faces.emplace_back();
    for (const glm::dvec2& p : outline) {
        face.push_back(static_cast<int>(mesh.vertices.size()));
        mesh.vertices.push_back(glm::dvec3(5, -3, 2) + u * p.x + v * p.y);
    }
    return mesh;
}

std::vector<int> corners(const glm::ivec3& triangle) {
    return {triangle.x, triangle.y, triangle.z};
}

// All triangles face as the face does, so that areas that add up to its own neither overlap nor leave a gap.
void expectCovers(const PolygonMesh& mesh, const std::string& what) {
    const glm::dvec3 whole = faceNormal(mesh, mesh.faces[0]);
    const auto triangles = triangulate(mesh);
    EXPECT_LE(triangles.size(), mesh.faces[0].size() - 2) << what;
    double sum = 0;
    for (const glm::ivec3& triangle : triangles) {
        const glm::dvec3 normal = faceNormal(mesh, corners(triangle));
        EXPECT_GT(glm::dot(normal, whole), 0) << what;
        sum += glm::length(normal);
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-9 * glm::length(whole)) << what;
}

void expectCoversInEveryPlane(const Outline& outline, const std::string& what) {
    ASSERT_GT(areaOf(outline), 0) << what;
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const glm::dvec3 oblique = glm::normalize(glm::dvec3(1, 2, -3)), across = glm::normalize(glm::dvec3(3, 0, 1));
    const glm::dvec3 planes[][2] = {{x, y}, {y, x}, {y, z}, {z, y}, {z, x}, {x, z}, {oblique, across}, {across, x + y}};
    for (const auto& [u, v] : planes) {
        const PolygonMesh mesh = faceOf(outline, u, v);
        EXPECT_NEAR(glm::length(faceNormal(mesh, mesh.faces[0])), 2 * areaOf(outline) * glm::length(glm::cross(u, v)),
                    1e-9 * areaOf(outline));
        expectCovers(mesh, what);
    }
}

std::string crossing(const std::string& face) {
    return "MESH CROSSING [" + face + "] the outline of face {" + face + "} crosses itself";
}

TEST(Triangulate, ATriangleStaysAsItIs) {
    const PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 2, 0}}};
    EXPECT_EQ(triangulate(mesh), std::vector<glm::ivec3>{glm::ivec3(1, 2, 0)});
}

TEST(Triangulate, Convex) {
    expectCoversInEveryPlane({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "square");
    expectCoversInEveryPlane(star(6, 0.99), "nearly round");
}

TEST(Triangulate, Concave) {
    expectCoversInEveryPlane({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, "arrow");
    expectCoversInEveryPlane({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, "L");
    expectCoversInEveryPlane(star(5, 0.3), "star");
    expectCoversInEveryPlane(star(40, 0.02), "star of needles");
    expectCoversInEveryPlane(comb(12), "comb");
    expectCoversInEveryPlane(spiral(4.5, 90), "spiral");
}

TEST(Triangulate, FromEveryFirstCorner) {
    for (Outline outline : {star(5, 0.3), comb(4), Outline{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            std::rotate(outline.begin(), outline.begin() + 1, outline.end());
            expectCovers(faceOf(outline), "first corner " + std::to_string(i));
        }
    }
}

TEST(Triangulate, CornersOnAStraightEdge) {
    const Outline outline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    expectCoversInEveryPlane(outline, "rectangle");
    expectCoversInEveryPlane({{0, 0}, {1, 0}, {2, 0}, {0, 2}}, "triangle of four corners");
    expectCoversInEveryPlane({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {0, 2}}, "triangle of six corners");
}

// A hole cut open: the outline runs along the cut twice.
TEST(Triangulate, AHoleBehindACut) {
    const Outline outline{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    EXPECT_EQ(areaOf(outline), 12);
    expectCovers(faceOf(outline), "frame");
}

TEST(Triangulate, AThousandCorners) {
    Outline round, jagged = star(500, 0.5);
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 1000;
        round.emplace_back(std::cos(angle), std::sin(angle));
    }
    expectCovers(faceOf(round), "round");
    expectCovers(faceOf(jagged), "jagged");
    EXPECT_EQ(triangulate(faceOf(round)).size(), 998u);
}

// Star-shaped about the origin, so simple whatever the radii are.
TEST(Triangulate, RandomOutlines) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> radius(0.05, 1);
    for (int trial = 0; trial < 300; ++trial) {
        Outline outline;
        const int count = 4 + trial % 30;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count, r = radius(random);
            outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        expectCoversInEveryPlane(outline, "trial " + std::to_string(trial));
    }
}

// The triangles of a face that is not flat still cover it as seen along its normal, and share its edges.
TEST(Triangulate, QuadsThatAreNotQuiteFlat) {
    for (const double lift : {1e-12, 1e-6, 0.01, 0.3}) {
        PolygonMesh mesh = faceOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        mesh.vertices[2].z += lift;
        const auto triangles = triangulate(mesh);
        ASSERT_EQ(triangles.size(), 2u);
        double sum = 0;
        for (const glm::ivec3& triangle : triangles) sum += faceNormal(mesh, corners(triangle)).z;
        EXPECT_NEAR(sum, 2, 1e-12);
    }
}

// Folded, steep, or seen to cross itself from wherever: four corners that are not in a plane make two triangles.
TEST(Triangulate, QuadsThatAreFarFromFlat) {
    const auto cut = [](const std::vector<glm::dvec3>& vertices) { return triangulate({vertices, {{0, 1, 2, 3}}}); };
    using Triangles = std::vector<glm::ivec3>;
    const Triangles across13{{3, 0, 1}, {3, 1, 2}}, across02{{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.5, 1}}), across13) << "folded";
    EXPECT_EQ(cut({{0, 0, 0}, {0, 1, 5}, {1, 1, 0.5}, {1, 0, 9}}), across13) << "steep";
    EXPECT_EQ(cut({{1, 0, 9}, {0, 0, 0}, {0, 1, 5}, {1, 1, 0.5}}), across02) << "steep, from another corner";
    EXPECT_EQ(cut({{0, 0, 0}, {4, 0, 0}, {1, 1, 1}, {3, 2, 0}}), across02) << "a bow tie, by its shorter diagonal";
    EXPECT_EQ(cut({{3, 2, 0}, {0, 0, 0}, {4, 0, 0}, {1, 1, 1}}), across13) << "likewise";
}

TEST(Triangulate, AnyFourCornersThatAreNotInAPlane) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    int hidden = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        PolygonMesh mesh{{}, {{0, 1, 2, 3}}};
        for (int i = 0; i < 4; ++i)
            mesh.vertices.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        const auto triangles = triangulate(mesh);
        ASSERT_EQ(triangles.size(), 2u);
        const glm::dvec3 whole = faceNormal(mesh, mesh.faces[0]);
        const glm::dvec3 first = faceNormal(mesh, corners(triangles[0])),
                         second = faceNormal(mesh, corners(triangles[1]));
        EXPECT_LT(glm::distance(first + second, whole), 1e-12);
        hidden += glm::dot(first, whole) <= 0 || glm::dot(second, whole) <= 0;
    }
    EXPECT_GT(hidden, 20);
    EXPECT_LT(hidden, 1000);
}

// What a file's digits leave of a plane is still one.
TEST(Triangulate, ABowTieThatIsNotQuiteFlatIsRefused) {
    for (const double lift : {1e-12, 1e-7}) {
        PolygonMesh mesh = faceOf({{0, 0}, {4, 0}, {1, 1}, {3, 2}});
        mesh.vertices[2].z += lift;
        EXPECT_EQ(errorOf([&] { triangulate(mesh); }), crossing("0 1 2 3"));
    }
}

// Seen along the axis that their normal is nearest to they cross themselves: the first two do not along the normal, the
// others from the side.
TEST(Triangulate, PolygonsThatAreFarFromFlat) {
    const std::vector<std::vector<glm::dvec3>> outlines{{{3, 3, 2}, {3, 0, 1}, {2, 1, 4}, {0, 3, 1}, {4, 2, 4}},
                                                        {{2, 0, 2}, {1, 1, 0}, {0, 1, 3}, {2, 3, 1}, {1, 3, 3}},
                                                        {{0, 0, 2}, {4, 2, 1}, {1, 3, 2}, {3, 0, 3}, {3, 4, 4}},
                                                        {{2, 0, 1}, {4, 1, 4}, {2, 1, 2}, {3, 0, 3}, {2, 3, 2}}};
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const PolygonMesh mesh{outlines[i], {{0, 1, 2, 3, 4}}};
        const auto triangles = triangulate(mesh);
        ASSERT_EQ(triangles.size(), 3u) << i;
        glm::dvec3 sum(0);
        for (const glm::ivec3& triangle : triangles) {
            const glm::dvec3 normal = faceNormal(mesh, corners(triangle));
            if (i < 2) {
                EXPECT_GT(glm::dot(normal, faceNormal(mesh, mesh.faces[0])), 0);
            }
            sum += normal;
        }
        EXPECT_LT(glm::distance(sum, faceNormal(mesh, mesh.faces[0])), 1e-12);
    }
}

TEST(Triangulate, EveryFaceOfAMesh) {
    PolygonMesh mesh = faceOf({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    mesh.faces = {{0, 1, 2, 3}, {0, 1, 2}, {3, 2, 1, 0}};
    const auto triangles = triangulate(mesh);
    ASSERT_EQ(triangles.size(), 5u);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(faceNormal(mesh, corners(triangles[i])).z, i < 3 ? 4 : -4);
}

TEST(Triangulate, OutlinesThatCrossThemselvesAreRefused) {
    const auto errorFor = [](const Outline& outline) { return errorOf([&] { triangulate(faceOf(outline)); }); };
    EXPECT_EQ(errorFor({{0, 0}, {4, 0}, {1, 1}, {3, 2}}), crossing("0 1 2 3"));
    EXPECT_EQ(errorFor({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}), crossing("0 1 2 3 4"));
    EXPECT_EQ(errorFor({{0, 0}, {4, 0}, {4, 4}, {3, -1}, {2, 4}, {0, 4}}), crossing("0 1 2 3 4 5"));
}

TEST(Triangulate, ACrossingFaceIsNamedByItsVertices) {
    PolygonMesh mesh = faceOf({{0, 0}, {4, 0}, {1, 1}, {3, 2}});
    mesh.vertices.insert(mesh.vertices.begin(), {9, 9, 9});
    mesh.faces = {{1, 2, 3, 4}};
    MeshRepairs repairs;
    EXPECT_EQ(errorOf([&] { Polyhedron::make(mesh, repairs); }), crossing("1 2 3 4"));
}

// A bow tie: as much area one way as the other, so that it must not pass for a face without any.
TEST(Triangulate, ABowTieIsCrossingNotWithoutArea) {
    const PolygonMesh mesh = faceOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
    MeshRepairs repairs;
    EXPECT_EQ(errorOf([&] { Polyhedron::make(mesh, repairs); }), crossing("0 1 2 3"));
}

}  // namespace
}  // namespace gr
