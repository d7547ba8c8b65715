// Light on and in solids made of solids, with each integrator: Beer's law along the parts of a ray that are in the
// glass, what the eye is inside of, and the same picture as of a mesh of the same shape. Seen to fail with operands
// that count by themselves for the eye or for the lens, with crossings that only leave, and with glass that does not
// grow where an operand stands on the floor.
#include "render/converges.h"
#include "render/each_integrator.h"
#include "render/same_light.h"

namespace render {
namespace {

using core::Vec3f;
using materials::Dielectric;

class CsgGlass : public EachIntegrator {
protected:
    CsgGlass() {
        scene.settings.globalIllumination = true;
        scene.settings.background = core::Rgbf(1);
        scene.settings.pathLength = 10;
    }
    // A block 2 wide, less a ball of radius 0.5 in its middle and a hole along z; of an index that bends nothing.
    void addBlock() {
        scene.database.addMaterial("glass", Dielectric{.index = 1, .absorption = {1, 0, 0.5f}});
        scene.database.create(":", "d", gr::DifferenceNode{});
        scene.database.setMaterial(":d", "glass");
        scene.database.create(":d", "block", gr::BoxNode{{-1, -1, -1}, {2, 2, 2}});
        scene.database.create(":d", "ball", gr::SphereNode{glm::dvec3(0), 0.5});
        scene.database.create(":d", "hole", gr::CylinderNode{{0, -1, 0}, 0.2, 2});
        scene.database.rotate(":d:hole", 0, 90);
    }
    static glm::dvec3 left(double length) { return glm::exp(-length * glm::dvec3(1, 0, 0.5)); }

    TestScene scene;
};
INSTANTIATE_TEST_SUITE_P(By, CsgGlass, eachIntegrator, integratorName);

TEST_P(CsgGlass, AbsorbsWhereItIs) {
    addBlock();
    const Radiometer radiometer(scene, {0, 0, -5});
    const auto through = [&](double x) { return radiometer.sample(rayTowards({x, 0.03, -5}, {x, 0.03, 5}), 1, 0); };
    EXPECT_TRUE(isNear(through(0.1), left(0))) << "along the hole";
    EXPECT_TRUE(isNear(through(0.4), left(2 - 2 * std::sqrt(0.25 - 0.16 - 0.0009)))) << "through the ball's place";
    EXPECT_TRUE(isNear(through(0.8), left(2))) << "beside both";
}

TEST_P(CsgGlass, IsKnownFromWithin) {
    addBlock();
    // In the glass, in the hollow, and in the hole; each looks along x.
    struct Place {
        glm::dvec3 eye;
        double lengthInGlass;
    };
    for (const Place& place : {Place{{0.8, 0.1, 0}, 0.2}, Place{{0.3, 0.02, 0.01}, 1 - std::sqrt(0.25 - 0.0005)},
                               Place{{0.05, 0, 0.9}, 0.8}}) {
        const Radiometer radiometer(scene, place.eye);
        const core::Rayf ray{Vec3f(place.eye), {1, 0, 0}};
        EXPECT_TRUE(isNear(radiometer.sample(ray, 1, 0), left(place.lengthInGlass))) << "eye at " << place.eye.x;
    }
}

// A lens that the glass cuts through: a ray knows which part it comes from.
TEST_P(CsgGlass, IsKnownAllOverTheLens) {
    addBlock();
    scene.settings.depthOfField = true;
    scene.settings.aperture = 0.3;
    const Radiometer radiometer(scene, {0.4, 0, 0});
    const core::Rgbf in = radiometer.sample({{0.6f, 0, 0}, {1, 0, 0}}, 1, 0);
    const core::Rgbf hollow = radiometer.sample({{0.4f, 0, 0}, {1, 0, 0}}, 1, 0);
    EXPECT_TRUE(isNear(in, left(0.4)));
    EXPECT_TRUE(isNear(hollow, left(0.5)));
    // And with the eye in the glass.
    const Radiometer fromGlass(scene, {0.6, 0, 0});
    EXPECT_TRUE(isNear(fromGlass.sample({{0.4f, 0, 0}, {1, 0, 0}}, 1, 0), left(0.5)));
}

// Cut flat, on a floor that it touches: light that enters it finds the floor, not what is below. With the floor made
// first and last.
TEST_P(CsgGlass, StandsOnTheFloor) {
    for (const bool floorFirst : {true, false}) {
        TestScene glassOnFloor;
        glassOnFloor.settings = scene.settings;
        const auto addFloor = [&] {
            glassOnFloor.add("floor", gr::BoxNode{{-3, -1, -3}, {6, 1, 6}}, core::Rgbf(0.5f));
        };
        if (floorFirst) addFloor();
        glassOnFloor.database.addMaterial("glass", Dielectric{.index = 1, .absorption = {0, 0, 0}});
        glassOnFloor.database.create(":", "i", gr::IntersectionNode{});
        glassOnFloor.database.setMaterial(":i", "glass");
        glassOnFloor.database.create(":i", "ball", gr::SphereNode{glm::dvec3(0), 1});
        glassOnFloor.database.create(":i", "cut", gr::PlaneNode{glm::dvec3(0), {0, -1, 0}});
        if (!floorFirst) addFloor();
        // An even sky over a floor of one half: it shines by one half, under glass that bends nothing, too.
        glassOnFloor.settings.pathLength = 8;
        const Radiometer radiometer(glassOnFloor, {0, 3, 0});
        for (const glm::dvec3& target : {glm::dvec3(0.1, 0, 0.2), {-0.6, 0, 0.3}, {2, 0, 0}})
            EXPECT_TRUE(converges(radiometer, rayTowards({0, 3, 0}, target), glm::dvec3(0.5))) << floorFirst;
    }
}

// A frame, once as a block less a block and once as a mesh: the same light on all of it, by both integrators.
TEST(CsgLight, IsThatOfAMeshOfTheSameShape) {
    const auto furnish = [](SameLight& light) {
        light.scene.add("room", gr::BoxNode{{-2, -2, -2}, {4, 4, 4}}, core::Rgbf(0.7f, 0.6f, 0.5f));
        light.scene.addAreaLight("lamp", core::Rgbf(4, 3, 2), {0.3, 1.9, 0.2}, 2);
        light.scene.settings.globalIllumination = true;
        light.scene.settings.antialiasing = true;
        light.scene.settings.pathLength = 4;
    };
    SameLight csg, mesh;
    furnish(csg);
    furnish(mesh);
    csg.scene.add("frame", gr::DifferenceNode{}, core::Rgbf(0.8f, 0.3f, 0.2f));
    csg.scene.database.create(":frame", "block", gr::BoxNode{{-1, -1, -0.2}, {2, 2, 0.4}});
    csg.scene.database.create(":frame", "hole", gr::BoxNode{{-0.6, -0.6, -0.2}, {1.2, 1.2, 0.4}});
    std::vector<glm::dvec3> vertices;
    for (const double z : {-0.2, 0.2})
        for (const double size : {1., 0.6})
            for (const glm::dvec2& corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
                vertices.push_back({size * corner.x, size * corner.y, z});
    std::vector<std::vector<int>> faces;
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) % 4;
        faces.push_back({i, i + 4, next + 4, next});  // back
        faces.push_back({8 + i, 8 + next, 12 + next, 12 + i});  // front
        faces.push_back({i, next, 8 + next, 8 + i});  // outside
        faces.push_back({4 + i, 12 + i, 12 + next, 4 + next});  // inside
    }
    gr::MeshRepairs repairs;
    mesh.scene.add("frame", gr::PolyhedronNode{gr::Polyhedron::make({vertices, faces}, repairs)},
                   core::Rgbf(0.8f, 0.3f, 0.2f));
    EXPECT_EQ(repairs.text(), "");
    for (SameLight* one : {&csg, &mesh}) {
        one->scene.database.translate(":frame", {0, -0.3, -0.3});
        one->scene.database.rotate(":frame", 1, 35);
    }
    const auto render = [](const SameLight& light, bool byPath, std::uint64_t seed, int pictures) {
        const gr::Scene compiled = gr::compile(light.scene.database, ":", {});
        const auto accelerator = gr::makeAccelerator("off", compiled, 1);
        const Vec3f from(light.eye);
        const auto& settings = light.scene.settings;
        const Camera camera(light.eye, light.view, {0, 1, 0}, 70, sameLightWidth, sameLightHeight);
        const auto path = makePathIntegrator(compiled, *accelerator, settings, light.scene.ambient, from);
        const auto report = makeReportIntegrator(compiled, *accelerator, settings, light.scene.ambient, from);
        return PictureMean(byPath ? *path : static_cast<const Integrator&>(*report), camera, true, pictures, seed);
    };
    for (const bool byPath : {true, false}) {
        support::ImageComparison result;
        for (const int factor : {1, 4}) {
            const auto seed = static_cast<std::uint64_t>(1'000'000 * factor);
            const int pictures = factor * gr::rayCount(byPath ? 150 : 400);
            result = compare(render(csg, byPath, seed, pictures), render(mesh, byPath, seed + 500'000, pictures));
            if (result.accepted) break;
        }
        EXPECT_TRUE(result.accepted) << result.text;
    }
}

TEST(CsgLight, IsTheSameByBothIntegrators) {
    SameLight light;
    light.scene.add("room", gr::BoxNode{{-2, -2, -2}, {4, 4, 4}}, core::Rgbf(0.7f, 0.6f, 0.5f));
    light.scene.addAreaLight("lamp", core::Rgbf(4, 3, 2), {0.3, 1.9, 0.2}, 2);
    light.scene.settings.globalIllumination = true;
    light.scene.settings.antialiasing = true;
    light.scene.settings.pathLength = 6;
    light.scene.add("cup", gr::DifferenceNode{}, Dielectric{.index = 1.4, .absorption = {0.2f, 0.5f, 1}});
    light.scene.database.create(":cup", "out", gr::CylinderNode{{-0.6, -1.5, -0.4}, 0.8, 1.2});
    light.scene.database.create(":cup", "in", gr::SphereNode{{-0.6, -0.3, -0.4}, 0.7});
    light.scene.add("bricks", gr::UnionNode{}, core::Rgbf(0.6f, 0.5f, 0.2f));
    light.scene.database.create(":bricks", "a", gr::BoxNode{{0.4, -2, -0.5}, {0.5, 1, 0.9}});
    light.scene.database.create(":bricks", "b", gr::BoxNode{{0.9, -2, -0.5}, {0.5, 1, 0.9}});
    light.scene.database.rotate(":bricks", 1, 20);
    EXPECT_TRUE(light.holds());
}

}  // namespace
}  // namespace render
