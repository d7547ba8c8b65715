// Meshes turned on a lathe: areas, volumes, normals, places on them, and that they are closed and face outwards.
// Seen to fail with a profile that is not turned where it runs downwards, with normals that are not the mean at a
// smooth point, or are at a sharp one, with a longitude that starts at +z, with u of the last segment back at 0, with u
// at a pole that is its face's edge, and with parts on the axis that count or touch.
#include "gr/mesh/lathe.h"
#include "gr/error_of.h"

#include "gr/mesh/mesh_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

namespace gr {
namespace {

using std::numbers::pi;
using Profile = std::vector<ProfilePoint>;
constexpr double packing = 1e-4;  // what a packed normal is off by, at most

Profile halfCircle(int parts) {
    Profile profile;
    for (int i = 0; i <= parts; ++i) {
        const double angle = pi * (static_cast<double>(i) / parts - 0.5);
        profile.push_back({i == 0 || i == parts ? 0 : std::cos(angle), std::sin(angle)});
    }
    return profile;
}

Profile circle(double radius, double tube, int parts) {
    Profile profile;
    for (int i = 0; i < parts; ++i)
        profile.push_back({radius + tube * std::cos(2 * pi * i / parts), tube * std::sin(2 * pi * i / parts)});
    profile.push_back(profile.front());
    return profile;
}

double area(const FlatMesh& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) sum += glm::length(faceNormal(mesh.vertices, mesh.face(f))) / 2;
    return sum;
}

double volume(const FlatMesh& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        sum += glm::dot(mesh.vertices[mesh.face(f)[0]], faceNormal(mesh.vertices, mesh.face(f))) / 6;
    return sum;
}

// Of the bodies between regular polygons that the mesh consists of.
double frustaArea(const Profile& profile, int n) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const auto& [r, y] = profile[i];
        const double slant = std::hypot((profile[i + 1].r - r) * std::cos(pi / n), profile[i + 1].y - y);
        sum += n * std::sin(pi / n) * (r + profile[i + 1].r) * slant;
    }
    return sum;
}
double frustaVolume(const Profile& profile, int n) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const double r = profile[i].r, s = profile[i + 1].r;
        sum += n * std::sin(2 * pi / n) / 6 * (profile[i + 1].y - profile[i].y) * (r * r + r * s + s * s);
    }
    return sum;
}

// Every edge belongs to two faces that run along it in opposite ways, and no face is without area.
void expectClosed(const FlatMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        EXPECT_GT(glm::length(faceNormal(mesh.vertices, face)), 0);
        for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
}

// As the polyhedron is made of it: nothing is to be mended.
void expectWhole(const FlatMesh& mesh) {
    MeshRepairs repairs;
    Polyhedron::make(FlatMesh(mesh), repairs);
    EXPECT_EQ(repairs.text(), "");
}

// Calls function(place, normal, uv) for each corner.
template<class Function>
void forEachCorner(const FlatMesh& mesh, Function&& function) {
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        function(mesh.vertices[mesh.corners[i]], glm::dvec3(unpackNormal(mesh.normals[i])), mesh.uvs[i]);
}

const Profile goblet{{0, 0},     {1, 0},   {0.9, 0.2}, {0.2, 0.4}, {0.2, 1},
                     {0.9, 1.5}, {1, 2.5}, {0.9, 2.5}, {0.8, 1.6}, {0, 1.1}};

TEST(Lathe, HasTheAreaAndVolumeOfFrustaBetweenPolygons) {
    for (const Profile& profile : {goblet, halfCircle(9), circle(2, 0.5, 11), Profile{{0, 0}, {1, 1}, {0, 3}}})
        for (const int n : {3, 4, 7, 100}) {
            const FlatMesh mesh = latheMesh(profile, n);
            EXPECT_NEAR(area(mesh), frustaArea(profile, n), 1e-12 * area(mesh));
            EXPECT_NEAR(volume(mesh), std::abs(frustaVolume(profile, n)), 1e-12 * area(mesh));
            expectClosed(mesh);
            expectWhole(mesh);
        }
}

TEST(Lathe, OfAHalfCircleBecomesTheSphere) {
    double last = 1;
    for (const int n : {16, 32, 64, 128}) {
        const FlatMesh mesh = latheMesh(halfCircle(n / 2), n);
        const double off = 1 - area(mesh) / (4 * pi), offVolume = 1 - volume(mesh) / (4 * pi / 3);
        EXPECT_GT(off, 0);
        EXPECT_LT(off, 10. / (n * n));
        EXPECT_LT(std::abs(offVolume), 20. / (n * n));
        EXPECT_TRUE(n == 16 || std::abs(off / last - 0.25) < 0.02) << n;  // with the square of the segments' length
        last = off;
        forEachCorner(mesh, [](const glm::dvec3& place, const glm::dvec3& normal, const core::Vec2f&) {
            EXPECT_LT(glm::distance(place, normal), packing);
        });
    }
}

TEST(Lathe, OfACircleIsATorus) {
    const FlatMesh mesh = latheMesh(circle(2, 0.5, 64), 96);
    // A regular polygon of 64 sides is 0.0004 shorter than its circle, and one of 96 0.0002.
    EXPECT_NEAR(area(mesh), 4 * pi * pi * 2 * 0.5, 0.04);
    EXPECT_NEAR(volume(mesh), 2 * pi * pi * 2 * 0.25, 0.03);
    EXPECT_EQ(mesh.faceCount(), 2 * 64 * 96);
    forEachCorner(mesh, [](const glm::dvec3& place, const glm::dvec3& normal, const core::Vec2f&) {
        const glm::dvec3 middle = 2. * glm::normalize(glm::dvec3(place.x, 0, place.z));
        EXPECT_LT(glm::distance(normal, (place - middle) / 0.5), packing);
    });
}

TEST(Lathe, FacesOutwardsWhicheverWayTheProfileRuns) {
    for (Profile profile : {goblet, halfCircle(9), circle(2, 0.5, 11)}) {
        const double forth = volume(latheMesh(profile, 12));
        std::ranges::reverse(profile);
        const FlatMesh back = latheMesh(profile, 12);
        EXPECT_GT(forth, 0);
        EXPECT_NEAR(volume(back), forth, 1e-12);
        expectWhole(back);
    }
    // An open one faces away from the axis.
    for (const Profile& profile : {Profile{{1, 0}, {1, 2}}, Profile{{1, 2}, {1, 0}}})
        forEachCorner(latheMesh(profile, 12), [](const glm::dvec3& place, const glm::dvec3& normal,
                                                 const core::Vec2f&) { EXPECT_GT(glm::dot(place, normal), 0.9); });
}

TEST(Lathe, IsFlatAndSharpOnACylindersEnds) {
    forEachCorner(latheMesh(Profile{{0, 0}, {1, 0}, {1, 2}, {0, 2}}, 24),
                  [](const glm::dvec3& place, const glm::dvec3& normal, const core::Vec2f& uv) {
                      const bool isSide = uv.y > 0.24f && uv.y < 0.76f && std::abs(normal.y) < 0.5;
                      const glm::dvec3 expected =
                          isSide ? glm::dvec3(place.x, 0, place.z) : glm::dvec3(0, place.y < 1 ? -1 : 1, 0);
                      EXPECT_LT(glm::distance(normal, expected), packing);
                  });
}

// A corner of a little less than 40 degrees is round, and one of a little more is not.
TEST(Lathe, IsSmoothUpToFortyDegrees) {
    for (const double turn : {39.9, 40.1}) {
        const double angle = turn * pi / 180;
        const Profile profile{{1, 0}, {1, 1}, {1 + std::sin(angle), 1 + std::cos(angle)}};
        int round = 0;
        forEachCorner(latheMesh(profile, 8),
                      [&](const glm::dvec3& place, const glm::dvec3& normal, const core::Vec2f&) {
                          if (place.y == 1) round += std::abs(normal.y + std::sin(angle / 2)) < packing;
                      });
        EXPECT_EQ(round, turn < 40 ? 8 * 6 : 0);
    }
}

// At the tip of a cone each face has the normal of its middle; at the pole of a dome there is one.
TEST(Lathe, HasOneNormalAtAPoleUnlessThatIsPointed) {
    const auto normalsAtPole = [](const Profile& profile) {
        std::vector<glm::dvec3> normals;
        forEachCorner(latheMesh(profile, 8),
                      [&](const glm::dvec3& place, const glm::dvec3& normal, const core::Vec2f&) {
                          if (place.x == 0 && place.z == 0) normals.push_back(normal);
                      });
        return normals;
    };
    for (const glm::dvec3& normal : normalsAtPole({{1, 0}, {0, 0.36}}))
        EXPECT_LT(glm::distance(normal, {0, 1, 0}), packing);
    const auto tip = normalsAtPole({{1, 0}, {0, 0.37}});
    ASSERT_EQ(tip.size(), 8u);
    for (const glm::dvec3& normal : tip) {
        EXPECT_NEAR(normal.y, 1 / std::hypot(1, 0.37), packing);
        EXPECT_NEAR(std::abs(std::atan2(normal.x, normal.z)),
                    pi / 8 * std::round(std::abs(std::atan2(normal.x, normal.z)) / (pi / 8)), 1e-3);
    }
}

// u by the longitude as on spheres, v by length, each from 0 to 1; at a pole u is that of the face's middle.
TEST(Lathe, HasLongitudeAndLengthAsUv) {
    const Profile profile{{0, 0}, {3, 0}, {3, 6}, {2, 6}};
    float most = 0;
    forEachCorner(latheMesh(profile, 8), [&](const glm::dvec3& place, const glm::dvec3&, const core::Vec2f& uv) {
        const double v = place.y == 6   ? (12 - std::hypot(place.x, place.z)) / 10
                         : place.y == 0 ? std::hypot(place.x, place.z) / 10
                                        : 0;
        EXPECT_NEAR(uv.y, v, 1e-6);
        if (std::hypot(place.x, place.z) > 0) {
            EXPECT_NEAR(std::sin(2 * pi * uv.x) * std::hypot(place.x, place.z), -place.x, 1e-5);
            EXPECT_NEAR(std::cos(2 * pi * uv.x) * std::hypot(place.x, place.z), -place.z, 1e-5);
        } else {
            EXPECT_NEAR(std::fmod(uv.x * 8, 1), 0.5, 1e-5);
        }
        most = std::max(most, uv.x);
    });
    EXPECT_EQ(most, 1);
}

TEST(Lathe, MakesNothingOfWhatLiesOnTheAxis) {
    const FlatMesh closedByHand = latheMesh(Profile{{0, 0}, {1, 0}, {0, 2}, {0, 0}}, 8);
    expectClosed(closedByHand);
    EXPECT_EQ(closedByHand.faceCount(), latheMesh(Profile{{0, 0}, {1, 0}, {0, 2}}, 8).faceCount());
    // A place on the axis may be come to again.
    expectClosed(latheMesh(Profile{{0, 0}, {2, 1}, {0, 2}, {0.2, 1}, {1, 1}, {0, 2}}, 8));
    expectWhole(latheMesh(Profile{{0, -1}, {0, 0}, {1, 1}, {0, 2}, {0, 3}, {1, 4}, {0, 5}}, 8));
}

// A hollow ball of one profile, which comes to the axis between its shells.
TEST(Lathe, LeavesACavityAsItIsWound) {
    Profile profile = halfCircle(12);
    Profile inner = halfCircle(12);
    std::ranges::reverse(inner);
    for (const ProfilePoint& point : inner) profile.push_back({point.r / 2, point.y / 2});
    const FlatMesh mesh = latheMesh(profile, 24);
    EXPECT_NEAR(volume(mesh), frustaVolume(halfCircle(12), 24) * 7 / 8, 1e-12);
    expectClosed(mesh);
    expectWhole(mesh);
}

TEST(Lathe, RefusesWhatIsNoProfile) {
    const auto error = [](const Profile& profile, int segments = 8) {
        const std::string text = support::errorOf([&] { latheMesh(profile, segments); });
        return text.substr(text.find("] ") + 2);  // behind topic, reason and word
    };
    EXPECT_EQ(error({{0, 0}, {0, 1}}), "the profile never leaves the axis: at least one r must be greater than 0");
    EXPECT_EQ(error({{0, 0}, {1, 0}, {1, 0}}), "the profile has the same point twice, 1 and 2");
    EXPECT_EQ(error({{1, 0}, {2, 2}, {2, 0}, {1, 2}}),
              "the profile crosses or touches itself: from point 0 to 1 and from point 2 to 3");
    EXPECT_EQ(error({{1, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0}}),
              "the profile crosses or touches itself: from point 0 to 1 and from point 3 to 4");
    EXPECT_EQ(error({{1, 0}, {2, 0}, {1.5, 0}, {1.5, 1}}),
              "the profile crosses or touches itself: from point 0 to 1 and from point 1 to 2");
    EXPECT_EQ(error({{1, 0}, {2, 1}, {3, 0}, {2, 1}, {1, 2}}),
              "the profile crosses or touches itself: from point 0 to 1 and from point 2 to 3");
    EXPECT_EQ(error({{1, 0}, {2, 0}, {1, 0}}),
              "the profile crosses or touches itself: from point 0 to 1 and from point 1 to 2");
    EXPECT_EQ(error(halfCircle(1000), 10000),
              "1000 parts of the profile in 10000 segments are more than 5000000 faces");
}

}  // namespace
}  // namespace gr
