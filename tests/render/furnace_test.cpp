// White furnaces: scenes in which every point is lit alike, so that the picture is known however often light bounces.
// Seen to fail with a bounce's cosine dropped, its density doubled, 1 % of its light lost, paths one point too long or
// too short, emission counted again after a bounce, a lamp's area 2 % too large, and rays that start on the surface.
#include "render/converges.h"
#include "render/each_integrator.h"

namespace render {
namespace {

constexpr double goldenAngle = 2.399963;

// Directions that no symmetry favours.
glm::dvec3 direction(int i) {
    const double z = 0.9 - 0.37 * i;
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(goldenAngle * i), radius * std::sin(goldenAngle * i), z};
}

// Inside a diffuse sphere, with a light in its centre that has no falloff, direct light is L_e = R_d * I everywhere.
// Each bounce brings R_d times as much: N surface points show L_e * (1 - R_d^N) / (1 - R_d).
struct Furnace {
    core::Rgbf reflectance;
    glm::dvec3 intensity{3, 2, 1};
    glm::dvec3 centre{1, -2, 3};
    double radius = 2;

    Radiometer radiometer(int pathLength) const {
        TestScene scene;
        scene.add("wall", gr::SphereNode{centre, radius}, reflectance);
        scene.addPointLight("lamp", {centre, intensity, core::Vec3f(1, 0, 0)});
        scene.settings.globalIllumination = true;
        scene.settings.pathLength = pathLength;
        return Radiometer(scene);
    }
    core::Rayf ray() const { return rayTowards(centre + 0.3 * radius * direction(0), centre + radius * direction(2)); }
    glm::dvec3 radiance(int pathLength) const {
        const glm::dvec3 rho(reflectance);
        return intensity * rho * (1.0 - glm::pow(rho, glm::dvec3(pathLength))) / (1.0 - rho);
    }
};

class SphereFurnace : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, SphereFurnace, eachIntegrator, integratorName);

TEST_P(SphereFurnace, ShowsTheSumOfSoManyBounces) {
    const Furnace furnace{.reflectance{0.3f, 0.5f, 0.7f}};
    for (const int pathLength : {1, 2, 3, 5}) {
        EXPECT_TRUE(converges(furnace.radiometer(pathLength), furnace.ray(), furnace.radiance(pathLength)))
            << "pathlength " << pathLength;
    }
}

// 100 points are as good as unlimited: 0.4^100 is nothing in single precision.
TEST_P(SphereFurnace, ShowsAllBounces) {
    const Furnace furnace{.reflectance{0.2f, 0.3f, 0.4f}};
    const glm::dvec3 rho(furnace.reflectance);
    EXPECT_TRUE(converges(furnace.radiometer(100), furnace.ray(), furnace.intensity * rho / (1.0 - rho)));
}

TEST_P(SphereFurnace, IsTheSameAtAnyScale) {
    for (const double scale : {1e-3, 1e4}) {
        Furnace furnace{.reflectance{0.3f, 0.5f, 0.7f}};
        furnace.centre *= scale;
        furnace.radius *= scale;
        EXPECT_TRUE(converges(furnace.radiometer(3), furnace.ray(), furnace.radiance(3))) << scale;
    }
}

struct Convex {
    const char* name;
    gr::NodeContent content;
};

// Round their own origin, so that a camera finds them there.
std::vector<Convex> convexObjects() {
    gr::MeshRepairs repairs;
    const gr::PolygonMesh tetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                      {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
    return {{"sphere", gr::SphereNode{{0.1, 0, 0.2}, 0.9}},
            {"box", gr::BoxNode{{-0.5, -0.4, -0.6}, {1, 0.7, 1.2}}},
            {"polyhedron", gr::PolyhedronNode{gr::Polyhedron::make(tetrahedron, repairs)}}};
}

void squeezeAndTurn(gr::Database& database, const std::string& node) {
    database.rotate(node, 0, 40);
    database.rotate(node, 1, -25);
    database.scale(node, glm::dvec3(0), {1.2, 0.3, 0.8});
}

constexpr core::Rgbf reflectance{0.9f, 0.5f, 0.1f};
constexpr glm::dvec3 surround{5, 3, 2};

class EvenBackground : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, EvenBackground, eachIntegrator, integratorName);

// Whatever is convex sees nothing but the background: R_d of it comes back, after one bounce.
TEST_P(EvenBackground, IsReflectedByWhatIsConvex) {
    for (const Convex& object : convexObjects()) {
        for (const bool isSqueezed : {false, true}) {
            TestScene scene;
            scene.settings.globalIllumination = true;
            scene.settings.background = core::Rgbf(surround);
            scene.add("object", object.content, reflectance);
            if (isSqueezed) squeezeAndTurn(scene.database, ":object");
            const Radiometer radiometer(scene);
            for (int i = 0; i < 2; ++i)
                EXPECT_TRUE(converges(radiometer, rayTowards(7.0 * direction(i), {0, 0, 0}),
                                      surround * glm::dvec3(reflectance)))
                    << object.name << (isSqueezed ? ", squeezed, from " : ", from ") << i;
        }
    }
}

// A closed cube of six lights round the object: as much light from everywhere, but found by light sampling, or, after a
// bounce, met by chance and not to be counted again.
class CubeOfLights : public EachIntegrator {
protected:
    CubeOfLights() {
        scene.settings.pathLength = 3;
        scene.database.create(":", "room", gr::TransformNode{});
        const std::pair<int, double> turns[] = {{0, 0}, {0, 90}, {0, 180}, {0, 270}, {2, 90}, {2, -90}};
        for (const auto& [axis, degrees] : turns) {
            // The unturned one is the ceiling; lights shine down their own y axis.
            const std::string name = "wall" + std::to_string(scene.database.nodeCount());
            scene.database.create(":room", name, gr::AreaLightNode{core::Rgbf(surround), {0, 2, 0}, 4});
            scene.database.rotate(":room:" + name, axis, degrees);
        }
    }

    void expectTheSurround(const gr::NodeContent& object, const char* what) {
        scene.add("object", object, reflectance);
        squeezeAndTurn(scene.database, ":object");
        for (const bool everything : {false, true}) {
            scene.settings.globalIllumination = everything;
            EXPECT_TRUE(converges(Radiometer(scene), rayTowards({1.1, 0.9, -0.8}, {0, 0, 0}),
                                  surround * glm::dvec3(reflectance)))
                << what << (everything ? ", all light" : ", direct light");
        }
    }

    TestScene scene;
};
INSTANTIATE_TEST_SUITE_P(By, CubeOfLights, eachIntegrator, integratorName);

TEST_P(CubeOfLights, IsReflectedByASphere) {
    expectTheSurround(convexObjects()[0].content, "sphere");
}
TEST_P(CubeOfLights, IsReflectedByABox) {
    expectTheSurround(convexObjects()[1].content, "box");
}

// Squares become parallelograms of other sizes; the light that they give together stays the same.
TEST_P(CubeOfLights, IsReflectedWhenItIsSheared) {
    scene.database.scale(":room", glm::dvec3(0), {1, 0.7, 1.5});
    scene.database.rotate(":room", 2, 35);
    scene.database.scale(":room", glm::dvec3(0), {1.3, 1, 1});
    expectTheSurround(convexObjects()[2].content, "polyhedron");
}

// No light but ambient, which is added at a path's last point: R_d^(N-1) of it gets to the eye, and R_d again.
// Outside it is as bright as on the sun, so that a single path that leaks shows.
struct Room : TestScene {
    Room(const gr::NodeContent& room, const core::Rgbf& reflectance) {
        add("room", room, reflectance);
        settings.globalIllumination = true;
        settings.pathLength = 3;
        settings.background = core::Rgbf(1e6f);
        ambient = core::Rgbf(4, 2, 1);
    }
};

const core::Rayf fromInside = rayTowards({0, 0, 0}, {1, 2, 3});

class ClosedRoom : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, ClosedRoom, eachIntegrator, integratorName);

TEST_P(ClosedRoom, ShowsTheAmbientLightOfPathsThatAreAtTheirEnd) {
    const core::Rgbf reflectance(0.7f, 0.5f, 0.2f);
    for (const Convex& room : convexObjects()) {
        const Room scene(room.content, reflectance);
        const glm::dvec3 expected = glm::dvec3(scene.ambient) * glm::pow(glm::dvec3(reflectance), glm::dvec3(3));
        EXPECT_TRUE(converges(Radiometer(scene), fromInside, expected)) << room.name;
    }
}

// Squeezed, the tetrahedron has edges of 26 degrees, and a ray may start very near to one.
TEST_P(ClosedRoom, LeaksNowhere) {
    for (const Convex& room : convexObjects()) {
        Room scene(room.content, core::Rgbf(1));
        scene.settings.pathLength = 200;
        scene.ambient = core::Rgbf(0);
        squeezeAndTurn(scene.database, ":room");
        const Radiometer radiometer(scene);
        int leaks = 0;
        for (int i = 0; i < 10'000; ++i) leaks += radiometer.sample(fromInside, 1, i) == core::Rgbf(0) ? 0 : 1;
        EXPECT_EQ(leaks, 0) << room.name;
    }
}

}  // namespace
}  // namespace render
