// Bodies within bodies: which of them bound cavities.
// Seen to fail without the search for what lies round a body, with its answer turned round, with every body within
// another taken for a cavity, and with none.
#include "gr/mesh/nesting.h"
#include "gr/mesh/mesh_repair.h"
#include "gr/uv_sphere_mesh.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>

namespace gr {
namespace {

// Bodies one after the other in one mesh.
class Builder {
public:
    // Returns the number of its first face.
    int ball(const glm::dvec3& centre, double radius, bool isOutwards, int rings = 6) {
        return add(uvSphereMesh(rings, 2 * rings), isOutwards,
                   [&](const glm::dvec3& p) { return centre + radius * p; });
    }
    // Round the y axis.
    int torus(double radius, double tube) {
        constexpr int around = 24, across = 12;
        PolygonMesh ring;
        for (int i = 0; i < around; ++i)
            for (int k = 0; k < across; ++k) {
                const double u = 2 * M_PI * i / around, v = 2 * M_PI * k / across, r = radius + tube * std::cos(v);
                ring.vertices.emplace_back(r * std::cos(u), tube * std::sin(v), r * std::sin(u));
                const auto number = [](int a, int b) { return a % around * across + b % across; };
                ring.faces.push_back({number(i, k), number(i, k + 1), number(i + 1, k + 1), number(i + 1, k)});
            }
        return add(ring, true, [](const glm::dvec3& p) { return p; });
    }
    void turn(std::size_t face) { std::reverse(mesh.faces[face].begin(), mesh.faces[face].end()); }

    PolygonMesh mesh;

private:
    template<class Map>
    int add(const PolygonMesh& body, bool isOutwards, Map&& map) {
        const int firstVertex = static_cast<int>(mesh.vertices.size()), firstFace = static_cast<int>(mesh.faces.size());
        for (const glm::dvec3& p : body.vertices) mesh.vertices.push_back(map(p));
        for (std::vector<int> face : body.faces) {
            for (int& v : face) v += firstVertex;
            if (!isOutwards) std::reverse(face.begin(), face.end());
            mesh.faces.push_back(face);
        }
        return firstFace;
    }
};

double volumeOf(const FlatMesh& mesh) {
    double six = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        six += glm::dot(faceNormal(mesh.vertices, mesh.face(f)), mesh.vertices[mesh.face(f)[0]]);
    return six / 6;
}

struct Oriented {
    double volume;
    int turned;
};
Oriented orient(const PolygonMesh& given) {
    FlatMesh mesh(given);
    MeshRepairs repairs;
    orientFaces(mesh, repairs);
    return {volumeOf(mesh), repairs.turnedFaces};
}

// Balls round one another, of radius 3, 2 and 1: O faces outwards in the file, I inwards. What comes out is told alike.
std::string orientBalls(const std::string& said) {
    Builder builder;
    std::vector<int> first;
    for (std::size_t i = 0; i < said.size(); ++i)
        first.push_back(builder.ball({0.1 * static_cast<double>(i), 0, 0}, 3 - static_cast<double>(i), said[i] == 'O'));
    FlatMesh mesh(builder.mesh);
    MeshRepairs repairs;
    orientFaces(mesh, repairs);
    std::string result;
    int turned = 0;
    for (std::size_t i = 0; i < said.size(); ++i) {
        const glm::dvec3 centre(0.1 * static_cast<double>(i), 0, 0);
        const int size = mesh.faceCount() / static_cast<int>(said.size());
        int outwards = 0;
        for (int f = first[i]; f < first[i] + size; ++f)
            outwards += glm::dot(faceNormal(mesh.vertices, mesh.face(f)), mesh.vertices[mesh.face(f)[0]] - centre) > 0;
        EXPECT_TRUE(outwards == 0 || outwards == size) << said;
        result += outwards > 0 ? 'O' : 'I';
        if (result.back() != said[i]) turned += size;
    }
    EXPECT_EQ(repairs.turnedFaces, turned) << said;
    return result;
}

TEST(Nesting, KeepsACavity) {
    EXPECT_EQ(orientBalls("OI"), "OI");
    EXPECT_EQ(orientBalls("OIO"), "OIO") << "a ball in a hollow one";
    EXPECT_EQ(orientBalls("OOI"), "OOI") << "overlapping, then hollow";
}

TEST(Nesting, KeepsABallWithinABall) {
    EXPECT_EQ(orientBalls("OO"), "OO");
    EXPECT_EQ(orientBalls("OOO"), "OOO");
}

TEST(Nesting, TurnsAFileThatIsInsideOutAsAWhole) {
    EXPECT_EQ(orientBalls("I"), "O");
    EXPECT_EQ(orientBalls("IO"), "OI");
    EXPECT_EQ(orientBalls("II"), "OO");
    EXPECT_EQ(orientBalls("IOI"), "OIO");
}

TEST(Nesting, TakesNothingFromACavity) {
    EXPECT_EQ(orientBalls("OII"), "OIO");
}

TEST(Nesting, DoesNotDependOnTheOrderOfBodies) {
    Builder builder;
    builder.ball({0.2, 0, 0}, 1, true);
    builder.ball({0.1, 0, 0}, 2, false);
    builder.ball({0, 0, 0}, 3, true);
    const double unit = orient([] {
                            Builder one;
                            one.ball({0, 0, 0}, 1, true);
                            return one.mesh;
                        }())
                            .volume;
    const Oriented result = orient(builder.mesh);
    EXPECT_EQ(result.turned, 0);
    EXPECT_NEAR(result.volume, unit * (27 - 8 + 1), 1e-9);
}

// Of each shell some faces are the wrong way round: most of its faces tell how it is meant.
TEST(Nesting, MendsEachShellByMostOfItsFaces) {
    Builder builder;
    const int outer = builder.ball({0, 0, 0}, 3, true), inner = builder.ball({0.5, 0.5, 0}, 1, false);
    const double volume = orient(builder.mesh).volume;
    for (const int first : {outer, inner})
        for (int i = 0; i < 20; ++i) builder.turn(static_cast<std::size_t>(first + i));
    const Oriented mended = orient(builder.mesh);
    EXPECT_EQ(mended.turned, 40);
    EXPECT_NEAR(mended.volume, volume, 1e-9);
    EXPECT_LT(volume, 27 * 4.2);
}

// The box round a ring holds the ball, but the ring does not.
TEST(Nesting, ABallInTheHoleOfARingIsOutside) {
    for (const bool isOutwards : {true, false}) {
        Builder builder;
        builder.torus(3, 1);
        const int first = builder.ball({0, 0, 0}, 0.9, isOutwards);
        const int faces = static_cast<int>(builder.mesh.faces.size()) - first;
        EXPECT_EQ(orient(builder.mesh).turned, isOutwards ? 0 : faces);
    }
    Builder builder;
    builder.torus(3, 1);
    builder.ball({3, 0, 0}, 0.4, false);
    EXPECT_EQ(orient(builder.mesh).turned, 0) << "within the tube";
}

// The rays from the small ball run along the large one's edges and through its vertices.
TEST(Nesting, RaysThroughEdgesCountOnce) {
    for (const double size : {1e-6, 1., 1e6})
        for (const glm::dvec3& away : {glm::dvec3(0), glm::dvec3(1e3, -2e3, 5e2)}) {
            Builder builder;
            builder.ball(away, size, true, 8);
            for (int i = 0; i < 8; ++i)
                builder.ball(away + size * glm::dvec3(0.1 * (i - 4), 0, 0), 0.02 * size, false, 4);
            builder.ball(away + size * glm::dvec3(0, 0.4, 0), 0.25 * size, false, 8);
            EXPECT_EQ(orient(builder.mesh).turned, 0) << size;
        }
}

TEST(Nesting, EnclosingIsTheSmallestRound) {
    Builder builder;
    std::vector<int> ends;
    const auto ball = [&](const glm::dvec3& centre, double radius) {
        builder.ball(centre, radius, true);
        ends.push_back(static_cast<int>(builder.mesh.faces.size()));
    };
    ball({0, 0, 0}, 1);
    ball({0, 0, 0}, 4);
    ball({0, 0, 0}, 2);
    ball({10, 0, 0}, 1);
    ball({3.2, 0, 0}, 0.3);
    const FlatMesh mesh(builder.mesh);
    std::vector<int> faces(static_cast<std::size_t>(mesh.faceCount()));
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = static_cast<int>(i);
    std::vector<Solid> solids;
    const double volumes[] = {1, 64, 8, 1, 0.027};
    for (std::size_t i = 0, begin = 0; i < ends.size(); begin = static_cast<std::size_t>(ends[i++]))
        solids.push_back({std::span(faces).subspan(begin, static_cast<std::size_t>(ends[i]) - begin), volumes[i]});
    EXPECT_EQ(enclosing(mesh, solids), (std::vector<int>{2, -1, 1, -1, 1}));
}

// Ten thousand balls side by side, and as many in one: in a time that would not do for each pair.
TEST(Nesting, OfManyBodiesTakesLittleTime) {
    for (const bool inOne : {false, true}) {
        Builder builder;
        for (int i = 0; i < 10'000; ++i)
            builder.ball({i % 22, i / 22 % 22, i / 484}, 0.4, !inOne, 3);  // NOLINT(bugprone-integer-division)
        if (inOne) builder.ball({10, 10, 10}, 40, true, 60);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(orient(builder.mesh).turned, 0);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << inOne;
    }
}

}  // namespace
}  // namespace gr
