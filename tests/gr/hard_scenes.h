// Scenes that no grid keeps apart, or that one could spend any time and memory on.
#pragma once

#include "gr/accelerator_checks.h"

namespace gr {

struct HardScene {
    const char* name;
    void (*add)(Database& database, int count, support::TestRandom& random);
};

// Named so that GoogleTest tells which of them failed.
inline std::ostream& operator<<(std::ostream& out, const HardScene& scene) {
    return out << scene.name;
}

inline void addTurnedBox(Database& database, const glm::dvec3& centre, const glm::dvec3& size,
                         const glm::dvec3& degrees) {
    const std::string path = database.create(":", nextName(database), BoxNode{-0.5 * size, size}).path();
    for (int axis = 0; axis < 3; ++axis) database.rotate(path, axis, degrees[axis]);
    database.translate(path, centre);
}

// A wire along an axis.
inline void addWire(Database& database, glm::dvec3 corner, int axis, double length) {
    glm::dvec3 size(1e-4);
    size[axis] = length;
    corner[axis] = -0.5 * length;
    addBox(database, corner, size);
}

inline constexpr HardScene hardScenes[]{
    {"SpheresInOnePlace",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i) addSphere(d, glm::dvec3(0), 1);
     }},
    {"ShellsOfOneCentre",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i) addSphere(d, glm::dvec3(0.1), 1 + 1. * i / n);
     }},
    {"ShellsOfEverySize",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i) addSphere(d, glm::dvec3(0.1), std::pow(1e5, 1. * i / n));
     }},
    {"WiresSideBySide",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i) addWire(d, {0, 1e-3 * i, -3}, 0, 2000);
     }},
    {"WiresAlongAllAxes",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i) addWire(d, randomPoint(random, -1, 1), i % 3, 2);
     }},
    {"WiresAcross",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i) addTurnedBox(d, glm::dvec3(1e-3 * i, 0, 0), {2000, 1e-4, 1e-4}, {0, 30, 40});
     }},
    {"NeedlesThroughOnePlace",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i) addTurnedBox(d, glm::dvec3(0), {2, 1e-3, 1e-3}, randomPoint(random, 0, 180));
     }},
    {"NeedlesEverywhere",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i)
             addTurnedBox(d, randomPoint(random, -1, 1), {1, 1e-3, 1e-3}, randomPoint(random, 0, 180));
     }},
    {"BoxesOverOneAnother",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i) addBox(d, randomPoint(random, -1, 0), 1. + randomPoint(random, 0, 0.2));
     }},
    {"BoxesOverTheirNeighbours",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i) addBox(d, randomPoint(random, -1, 1), randomPoint(random, 0, 0.5));
     }},
    {"PlatesBehindOneAnother",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i) addBox(d, {-1, -1, 2 * random.next() - 1}, {2, 2, 1e-6});
     }},
    {"LampsInOnePlace",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i)
             d.create(":", nextName(d), AreaLightNode{core::Rgbf(1), glm::dvec3(0, i % 3, 0), 1});
     }},
    {"TwoFarClusters",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i)
             addSphere(d, randomPoint(random, -1, 1) + (i % 2 == 0 ? 0 : 1e5), 0.5 / std::cbrt(n));
     }},
    {"ManyInHuge",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i)
             addSphere(d, randomPoint(random, -1, 1), i % 50 == 0 ? 1e4 + i : 0.5 / std::cbrt(n));
     }},
    {"ClustersWithinClusters",
     [](Database& d, int n, support::TestRandom& random) {
         for (int i = 0; i < n; ++i) {
             const double size = std::pow(1e-5, random.next());
             addSphere(d, size * randomPoint(random, -1, 1), 0.3 * size);
         }
     }},
    {"PlacesThatHalve",
     [](Database& d, int n, support::TestRandom&) {
         for (int i = 0; i < n; ++i) {
             const double x = std::exp2(-40. * i / n);
             addSphere(d, {x, 0, 0}, 1e-3 * x);
         }
     }},
};

inline Scene hardScene(const HardScene& scene, int count) {
    Database database;
    support::TestRandom random(21);
    scene.add(database, count, random);
    return compile(database, ":", {});
}

}  // namespace gr
