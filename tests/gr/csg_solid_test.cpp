// What CSG objects hold: volumes by counting how much of random lines is inside, places by the solids' crossings, and
// no way out of what is closed. GRSH_TEST_RAYS=100 traces 2*10^7 rays in each room. Seen to fail where rays start on
// the surface itself, and where an operand's surface is taken from the side on which the ray starts.
#include "gr/no_leak.h"
#include "gr/random_csg.h"
#include "gr/solid.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Rayf;
using core::Vec3f;

// The volume within the box [-2, 2]^3, from random lines along z, and its standard error.
struct Volume {
    double mean, error;
};
Volume volumeOf(const Scene& scene, int lines) {
    const auto accelerator = makeNoAccelerator(scene);
    support::TestRandom random(4);
    double sum = 0, squares = 0;
    for (int i = 0; i < lines; ++i) {
        const glm::dvec3 from = randomPoint(random, -2, 2);
        Rayf ray{Vec3f(static_cast<float>(from.x), static_cast<float>(from.y), -3), {0, 0, 1}};
        double inside = 0;
        bool isInside = false;
        for (int k = 0; k < 100; ++k) {
            const std::optional<Hit> hit = accelerator->intersect(ray);
            if (!hit) break;
            const SurfacePoint surface = scene.surfaceAt(ray, *hit);
            inside += isInside ? surface.position.z : -surface.position.z;
            isInside = !isInside;
            ray.origin = surface.offset(surface.normal.z < 0 ? -surface.normal : surface.normal);
        }
        const double part = 16 * inside;  // of the box: its face is 4 x 4
        sum += part;
        squares += part * part;
    }
    const double mean = sum / lines;
    return {mean, std::sqrt((squares / lines - mean * mean) / lines)};
}

void expectVolume(const Scene& scene, double expected) {
    const Volume volume = volumeOf(scene, rayCount(40'000));
    EXPECT_LT(volume.error, 0.02 * expected);
    EXPECT_NEAR(volume.mean, expected, 4 * volume.error);
}

// Two cylinders of radius 1 across each other hold 16 / 3 together (Archimedes).
TEST(CsgVolume, OfTwoCylindersAcrossEachOther) {
    Database database;
    database.create(":", "i", IntersectionNode{});
    database.create(":i", "a", CylinderNode{{0, -1.5, 0}, 1, 3});
    database.create(":i", "b", CylinderNode{{0, -1.5, 0}, 1, 3});
    database.rotate(":i:b", 0, 90);
    database.rotate(":i", 1, 30);
    database.rotate(":i", 0, 20);
    expectVolume(compile(database, ":", {}), 16 / 3.);
}

// What a drill leaves of a ball depends on the ring's height alone: pi h^3 / 6.
TEST(CsgVolume, OfANapkinRing) {
    Database database;
    database.create(":", "d", DifferenceNode{});
    database.create(":d", "ball", SphereNode{glm::dvec3(0), 1.3});
    database.create(":d", "drill", CylinderNode{{0, -2, 0}, std::sqrt(1.3 * 1.3 - 0.9 * 0.9), 4});
    database.rotate(":d", 0, 50);
    expectVolume(compile(database, ":", {}), M_PI * std::pow(1.8, 3) / 6);
}

// Of two balls of radius 1, their centres 1 apart, each cap is 0.5 high.
TEST(CsgVolume, OfTwoBalls) {
    const double cap = M_PI * 0.25 * 2.5 / 3, ball = 4 * M_PI / 3;
    const double volumes[] = {2 * ball - 2 * cap, 2 * cap, ball - 2 * cap};
    const NodeContent operations[] = {UnionNode{}, IntersectionNode{}, DifferenceNode{}};
    for (std::size_t i = 0; i < 3; ++i) {
        Database database;
        database.create(":", "c", operations[i]);
        database.create(":c", "a", SphereNode{{-0.5, 0, 0}, 1});
        database.create(":c", "b", SphereNode{{0.5, 0, 0}, 1});
        database.rotate(":c", 1, 40);
        expectVolume(compile(database, ":", {}), volumes[i]);
    }
}

// Half a torus, cut by a half space; and a mesh by a torus.
TEST(CsgVolume, OfTori) {
    Database half;
    half.create(":", "i", IntersectionNode{});
    half.create(":i", "torus", TorusNode{glm::dvec3(0), 1, 0.4});
    half.create(":i", "plane", PlaneNode{glm::dvec3(0), {1, 0, 0.3}});
    half.rotate(":i", 0, 70);
    expectVolume(compile(half, ":", {}), M_PI * M_PI * 0.16);
    Database groove;
    groove.create(":", "d", DifferenceNode{});
    groove.create(":d", "cube", polyhedronNode(cubeMesh()));
    groove.create(":d", "torus", TorusNode{{0, 1, 0}, 0.6, 0.3});
    groove.rotate(":d", 0, 50);
    expectVolume(compile(groove, ":", {}), 8 - M_PI * M_PI * 0.6 * 0.09);
}

// A place is in the solid if its crossings say so: what the eye is inside of is found by them.
TEST(CsgSolid, IsCrossedAsTheOracleSaysSo) {
    support::TestRandom random(5);
    int inside = 0, places = 0;
    Violations wrong;
    for (int i = 0; i < 200; ++i) {
        Database database;
        database.create(":", "all", TransformNode{});
        const OracleCsg oracle = RandomCsg(database, random).make(":all", glm::dmat4(1), 3);
        const Scene scene = compile(database, ":", {});
        if (scene.csgs.empty()) continue;
        const Instance& whole = scene.instances.back();
        for (int k = 0; k < rayCount(50); ++k) {
            const Vec3f from(randomPoint(random, -1, 1)), to(randomPoint(random, -1, 1));
            const double first = oracle.at(glm::dvec3(from)), last = oracle.at(glm::dvec3(to));
            if (std::abs(first) < 1e-3 || std::abs(last) < 1e-3) continue;
            ++places;
            inside += first < 0;
            std::vector<SolidCrossing> crossings;
            addCrossings(scene, whole, {from, Vec3f(randomDirection(random))}, crossings);
            int stays = 0;
            for (const SolidCrossing& crossing : crossings) stays += crossing.enters ? -1 : 1;
            if (stays != (first < 0)) wrong.add("stays ", stays, " at level ", first);
            // And from one place to another.
            crossings.clear();
            addCrossings(scene, whole, {from, to - from, 1}, crossings);
            int change = 0;
            for (const SolidCrossing& crossing : crossings) change += crossing.enters ? 1 : -1;
            if (change != (last < 0) - (first < 0)) wrong.add("changed by ", change, " from ", first, " to ", last);
        }
    }
    EXPECT_EQ(wrong.count(), 0) << wrong.text();
    EXPECT_GT(inside, places / 20);
    EXPECT_GT(places, 5000);
}

// As it is, and mirrored.
template<class Build>
void expectNoLeak(Build&& build) {
    for (const double side : {1., -1.})
        expectClosed(glm::dvec3(0), rayCount(50'000), [&](Database& database) {
            database.scale(":body", glm::dvec3(0), {1, 1, side});
            build(database);
        });
}

TEST(CsgLeak, RoomOfABoxLessABox) {
    expectNoLeak([](Database& database) {
        const std::string room = database.create(":body", "d", DifferenceNode{}).path();
        database.create(room, "outer", BoxNode{glm::dvec3(-1), glm::dvec3(2)});
        database.create(room, "inner", BoxNode{glm::dvec3(-0.99), glm::dvec3(1.98)});
    });
}

// Its walls are operands of a union that only touch.
TEST(CsgLeak, RoomOfWallsSideBySide) {
    expectNoLeak([](Database& database) {
        const std::string room = database.create(":body", "u", UnionNode{}).path();
        database.create(room, "left", BoxNode{{-2, -1, -1}, {1, 2, 2}});
        database.create(room, "right", BoxNode{{1, -1, -1}, {1, 2, 2}});
        database.create(room, "floor", BoxNode{{-2, -2, -1}, {4, 1, 2}});
        database.create(room, "top", BoxNode{{-2, 1, -1}, {4, 1, 2}});
        database.create(room, "back", BoxNode{{-2, -2, -2}, {4, 4, 1}});
        database.create(room, "front", BoxNode{{-2, -2, 1}, {4, 4, 1}});
    });
}

// A cave with sharp edges where balls, a cone and a ring meet.
TEST(CsgLeak, CaveOfRoundHoles) {
    expectNoLeak([](Database& database) {
        const std::string rock = database.create(":body", "d", DifferenceNode{}).path();
        database.create(rock, "rock", BoxNode{glm::dvec3(-2), glm::dvec3(4)});
        database.create(rock, "a", SphereNode{{0, 0, 0}, 0.8});
        database.create(rock, "b", SphereNode{{0.9, 0, 0}, 0.7});
        database.create(rock, "c", ConeNode{{0, 0.2, 0}, 0.7, 1.4, 0});
        database.create(rock, "ring", TorusNode{{0, 0, 0}, 1.2, 0.3});
        const std::string both = database.create(rock, "i", IntersectionNode{}).path();
        database.create(both, "d", SphereNode{{-0.9, 0, 0}, 0.7});
        database.create(both, "e", SphereNode{{-0.7, 0.4, 0}, 0.7});
    });
}

}  // namespace
}  // namespace gr
