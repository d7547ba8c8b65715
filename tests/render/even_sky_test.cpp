// Clear dielectrics in an even sky are invisible, whatever their shape and however they overlap: what a surface
// reflects it takes from one part of the sky and what it lets through from another, and both are alike.
// Seen to fail without the change of radiance with n^2 and with n for n^2, the indices the other way round, an outer
// dielectric that is forgotten, one left for the other where two overlap, one met from inside that is entered twice,
// weights that leave out how often a method is drawn, and with paths that Russian roulette ends by their radiance in
// glass, as it is there or less by n^4.
#include "render/converges.h"
#include "render/each_integrator.h"

namespace render {
namespace {

using materials::Dielectric;

constexpr core::Rgbf sky{5, 3, 2};

struct SkyScene : TestScene {
    SkyScene() {
        settings.globalIllumination = true;
        settings.pathLength = 400;
        settings.background = sky;
    }
    void addGlass(const std::string& name, const gr::NodeContent& content, double index) {
        add(name, content, Dielectric{.index = index, .sampling = sampling});
    }
    void turn(const std::string& node) {
        database.rotate(node, 0, 40);
        database.rotate(node, 1, -25);
        database.rotate(node, 2, 11);
    }

    std::optional<core::Weights> sampling{};
};

const gr::BoxNode oblong{{-0.6, -0.4, -0.8}, {1.2, 0.8, 1.6}};

// From all round the origin, to places about it.
core::Rayf rayOf(int i) {
    constexpr double goldenAngle = 2.399963;
    const double z = 0.93 - 0.31 * (i % 7), radius = std::sqrt(1 - z * z);
    const glm::dvec3 from(radius * std::cos(goldenAngle * i), radius * std::sin(goldenAngle * i), z);
    const glm::dvec3 target(std::cos(1.7 * i), std::sin(2.3 * i), std::cos(3.1 * i));
    return rayTowards(4.0 * from, 0.55 * target);
}

// Without sampling given, a surface goes on by what it reflects and lets through, and each single path brings the sky,
// however much less of it glass shows to what is inside: Russian roulette takes no path for a poor one because of that.
void expectNothingSeen(const SkyScene& scene, double index = 0) {
    for (int i = 0; i < 40; ++i) {
        const core::Rayf ray = rayOf(i);
        const Radiometer radiometer(scene, ray.origin);
        for (int path = 0; path < 50; ++path)
            ASSERT_TRUE(isNear(radiometer.sample(ray, 1, path), sky)) << "ray " << i << ", n " << index;
    }
}

class EvenSky : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, EvenSky, eachIntegrator, integratorName);

TEST_P(EvenSky, HidesAGlassSphere) {
    for (const double index : {1.5, 1 / 1.5, 1.0, 1.7, 2.4, 1 / 2.4, 20.}) {
        SkyScene scene;
        scene.addGlass("ball", gr::SphereNode{{0.1, 0, -0.2}, 1}, index);
        expectNothingSeen(scene, index);
    }
}

TEST_P(EvenSky, HidesAGlassBoxTurnedOddly) {
    for (const double index : {1.5, 2.4}) {
        SkyScene scene;
        scene.addGlass("box", oblong, index);
        scene.turn(":box");
        expectNothingSeen(scene, index);
    }
}

// With weights of their own single paths bring more or less, and only their mean is the sky.
TEST_P(EvenSky, HidesAGlassSphereOfAnySampling) {
    const std::pair<double, core::Weights> cases[] = {{1.5, {0, 0.5f, 0.5f, 0}}, {1 / 1.5, {0, 0.3f, 0.7f, 0}}};
    for (const auto& [index, weights] : cases) {
        SkyScene scene;
        scene.sampling = weights;
        scene.addGlass("ball", gr::SphereNode{{0.1, 0, -0.2}, 1}, index);
        EXPECT_TRUE(converges(Radiometer(scene, rayOf(1).origin), rayOf(1), sky)) << index;
    }
}

TEST_P(EvenSky, HidesAGlassBoxOfAnySampling) {
    SkyScene scene;
    scene.sampling = core::Weights{0, 0.3f, 0.7f, 0};
    scene.addGlass("box", oblong, 1.5);
    scene.turn(":box");
    EXPECT_TRUE(converges(Radiometer(scene, rayOf(0).origin), rayOf(0), sky));
}

TEST_P(EvenSky, HidesAGlassMesh) {
    SkyScene scene;
    gr::MeshRepairs repairs;
    const gr::PolygonMesh prism{{{-1, -0.8, -1}, {1, -0.8, -1}, {0, 0.9, -1}, {-1, -0.8, 1}, {1, -0.8, 1}, {0, 0.9, 1}},
                                {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
    scene.addGlass("prism", gr::PolyhedronNode{gr::Polyhedron::make(prism, repairs)}, 1.5);
    expectNothingSeen(scene);
}

TEST_P(EvenSky, HidesGlassInGlass) {
    SkyScene scene;
    scene.addGlass("water", gr::SphereNode{{0, 0, 0}, 1.2}, 1.33);
    scene.addGlass("glass", gr::SphereNode{{0.1, 0.2, 0}, 0.7}, 1.6);
    scene.addGlass("air", gr::SphereNode{{0.1, 0.3, 0.1}, 0.4}, 1);
    expectNothingSeen(scene);
}

TEST_P(EvenSky, HidesDielectricsThatOverlap) {
    SkyScene scene;
    scene.addGlass("ball", gr::SphereNode{{-0.3, 0, 0}, 0.8}, 1.5);
    scene.addGlass("box", gr::BoxNode{{-0.2, -0.5, -0.6}, {1.3, 0.9, 1.1}}, 1.2);
    scene.turn(":box");
    expectNothingSeen(scene);
}

// Each in part in the other.
TEST_P(EvenSky, HidesOneMaterialTwice) {
    SkyScene scene;
    scene.addGlass("ball", gr::SphereNode{{-0.3, 0, 0}, 0.8}, 1.5);
    scene.database.create(":", "other", gr::SphereNode{{0.4, 0.1, 0.2}, 0.7});
    scene.database.setMaterial(":other", "ball");
    expectNothingSeen(scene);
}

// From inside glass the sky is brighter by the square of the index: less of it is seen, and as much light arrives.
TEST_P(EvenSky, IsBrighterByTheSquareOfTheIndexInsideGlass) {
    for (const double index : {1.5, 1 / 1.5, 2.4}) {
        SkyScene scene;
        scene.addGlass("ball", gr::SphereNode{{0, 0, 0}, 2}, index);
        const glm::dvec3 eye(0.5, 0.3, -0.2);
        const Radiometer radiometer(scene, eye);
        for (int i = 0; i < 20; ++i) {
            const core::Rayf ray{core::Vec3f(eye), rayOf(i).direction};
            for (int path = 0; path < 50; ++path)
                ASSERT_TRUE(isNear(radiometer.sample(ray, 1, path), glm::dvec3(sky) * index * index)) << index;
        }
    }
}

}  // namespace
}  // namespace render
