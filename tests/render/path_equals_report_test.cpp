// The path integrator and the report's, which is the oracle, find the same light: with each material and each way to go
// on, and with each option that changes which light there is.
// Seen to fail with light that both ways to find it bring in full, light met again after a mirror that has a highlight,
// Russian roulette that is not made up for, a hemisphere's density 2 % too large, walls and lamps that cast no shadow,
// shadow rays that nothing absorbs, an eye's medium taken for all of the lens, a pane met from inside that does not
// count, several samples of a light weighed as one, lights that chance picks weighed as if each were asked, point
// lights that it picks not made up for, ambient light at every point, refraction that starts on the wrong side, and
// bounces through a surface that is shaded with other normals.
#include "render/room.h"

#include "materials/parameter_sets.h"

namespace render {
namespace {

using materials::Dielectric;

template<class M>
class PathEqualsReport : public testing::Test {};
TYPED_TEST_SUITE(PathEqualsReport, materials::EveryMaterial, materials::MaterialName);

TYPED_TEST(PathEqualsReport, WithEveryWayToGoOn) {
    const core::Weights ways[] = {{1, 0, 0, 0},
                                  {0, 1, 0, 0},
                                  {0, 0, 1, 0},
                                  {0, 0, 0, 1},
                                  {0.5f, 0.5f, 0, 0},
                                  {0, 0.3f, 0.7f, 0},
                                  {0.4f, 0, 0, 0.6f},
                                  {0.1f, 0.2f, 0.3f, 0.4f},
                                  {0.25f, 0.25f, 0.25f, 0.25f}};
    TypeParam material;
    if constexpr (requires { material.exponents; }) material.exponents = {10, 60};
    if constexpr (requires { material.specular; }) material.specular = core::Rgbf(0.3f, 0.5f, 0.7f);
    for (const double perturbation : {material.perturbation, 40.}) {
        material.perturbation = perturbation;
        material.sampling = std::nullopt;
        for (std::size_t i = 0; i <= std::size(ways); ++i) {
            if (i > 0) material.sampling = ways[i - 1];
            Room room;
            room.addBodies(material);
            EXPECT_TRUE(room.holds()) << "sampling " << core::optionText(material.sampling) << ", perturbation "
                                      << perturbation;
        }
    }
}

// Where a highlight is narrow, few of the report's samples find a light: their mean is not normal for a long time.
constexpr float steepest = 300;

TYPED_TEST(PathEqualsReport, WithAllItsParameters) {
    std::vector<TypeParam> sets = materials::parameterSets<TypeParam>();
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if constexpr (requires { sets[i].exponents; }) sets[i].exponents = glm::min(sets[i].exponents.value, steepest);
        Room room;
        room.addBodies(sets[i]);
        EXPECT_TRUE(room.holds()) << "set " << i;
    }
}

// A name, and what it does to a room that has everything.
struct Change {
    const char* name;
    void (*make)(Room& room);

    friend std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.name; }
};

constexpr Change changes[] = {
    {"None", [](Room&) {}},
    {"DirectLightOnly", [](Room& r) { r.scene.settings.globalIllumination = false; }},
    {"PathLength1", [](Room& r) { r.scene.settings.pathLength = 1; }},
    {"PathLength2", [](Room& r) { r.scene.settings.pathLength = 2; }},
    {"PathLength3", [](Room& r) { r.scene.settings.pathLength = 3; }},
    {"PathLength6", [](Room& r) { r.scene.settings.pathLength = 6; }},
    {"PixelCentres", [](Room& r) { r.scene.settings.antialiasing = false; }},
    {"Lens",
     [](Room& r) {
         r.scene.settings.depthOfField = true;
         r.scene.settings.aperture = 0.15;
         r.scene.settings.focalDistance = 2.5;
     }},
    {"SamplesPerLightSource3", [](Room& r) { r.scene.settings.samplesPerLightSource = 3; }},
    {"Background",
     [](Room& r) {
         r.scene.database.remove(":room");
         r.scene.add("floor", gr::BoxNode{{-9, -2.1, -9}, {18, 0.1, 18}}, core::Rgbf(0.6f));
         r.scene.settings.background = core::Rgbf(0.5f, 0.7f, 0.9f);
     }},
    {"Ambient",
     [](Room& r) {
         r.scene.ambient = core::Rgbf(0.3f, 0.2f, 0.5f);
         r.scene.settings.pathLength = 2;
     }},
    {"PointLights",
     [](Room& r) {
         r.scene.addPointLight("near", {{-1.5f, 1.5f, 1.2f}, core::Rgbf(0.5f), {0.1f, 0.2f, 0.5f}});
         r.scene.addPointLight("far", {{1.5f, 0, 1.6f}, core::Rgbf(0.2f, 0.4f, 0.6f), {1, 0, 0}});
     }},
    {"PointLightsAlone",
     [](Room& r) {
         r.scene.database.remove(":lamp");
         r.scene.addPointLight("only", {{-1.5f, 1.5f, 1.2f}, core::Rgbf(0.5f), {0, 0, 1}});
     }},
    {"ManyLights",
     [](Room& r) {
         // One of them turned to the wall behind it, one aslant, one dim.
         r.addLamp("second", core::Rgbf(1, 2, 4), {-1.9, 0, 0}, 0.8, 2, -90);
         r.addLamp("third", core::Rgbf(6), {1, 1.2, -1}, 0.4, 0, 35);
         r.addLamp("fourth", core::Rgbf(0.1f), {0, -1.95, 1.5}, 0.4, 2, 180);
     }},
    {"ManyLights3Samples",
     [](Room& r) {
         r.addLamp("second", core::Rgbf(1, 2, 4), {0.2, 0.6, 0.1}, 0.8, 0, 50);
         r.scene.settings.samplesPerLightSource = 3;
     }},
    {"LightsThatChancePicks", [](Room& r) { r.addLampsAllAround(); }},
    {"LightsThatChancePicks3Samples",
     [](Room& r) {
         r.addLampsAllAround();
         r.scene.settings.samplesPerLightSource = 3;
     }},
    {"LightsThatChancePicksThroughALens",
     [](Room& r) {
         r.addLampsAllAround();
         r.scene.settings.depthOfField = true;
         r.scene.settings.aperture = 0.15;
         r.scene.settings.focalDistance = 2.5;
     }},
    {"PointLightsThatChancePicks",
     [](Room& r) {
         r.scene.database.remove(":lamp");
         r.addPointsAllAround();
     }},
    {"PointLightsThatChancePicks3Samples",
     [](Room& r) {
         r.scene.database.remove(":lamp");
         r.addPointsAllAround();
         r.scene.settings.samplesPerLightSource = 3;
     }},
    {"LampsAndPointLightsThatChancePicks",
     [](Room& r) {
         r.addLampsAllAround();
         r.addPointsAllAround();
     }},
    {"LampsAndPointLightsThatChancePicks3Samples",
     [](Room& r) {
         r.addLampsAllAround();
         r.addPointsAllAround();
         r.scene.settings.samplesPerLightSource = 3;
     }},
    {"FourLampsAndPointLightsEachAsked",
     [](Room& r) {
         r.addLamp("second", core::Rgbf(1, 2, 4), {-1.9, 0, 0}, 0.8, 2, -90);
         r.scene.addPointLight("one", {{-1.5f, 1.5f, 1.2f}, core::Rgbf(0.5f), {0, 0, 1}});
         r.scene.addPointLight("two", {{1.5f, 0, 1.6f}, core::Rgbf(0.2f, 0.4f, 0.6f), {1, 0, 0}});
         r.scene.settings.samplesPerLightSource = 3;
     }},
    {"Sky", [](Room& r) { r.openToSky(); }},
    {"Sky3Samples",
     [](Room& r) {
         r.openToSky();
         r.scene.settings.samplesPerLightSource = 3;
     }},
    {"SkyOnALens",
     [](Room& r) {
         r.openToSky();
         r.scene.settings.depthOfField = true;
         r.scene.settings.aperture = 0.15;
         r.scene.settings.focalDistance = 2.5;
     }},
    {"SkyAndBackground",
     [](Room& r) {
         r.openToSky();
         r.scene.settings.background = core::Rgbf(0.5f, 0.2f, 0.1f);
     }},
    {"SkySunsAndSpot",
     [](Room& r) {
         r.openToSky();
         r.scene.addLight("disc", gr::SunLight::make({-1, -1, 0.4}, core::Rgbf(0.7f, 0.5f, 0.3f), 20));
         r.scene.addLight("point", gr::ParallelLight::make({0.3, -1, -0.4}, core::Rgbf(0.1f, 0.2f, 0.4f)));
         r.scene.addLight("spot", gr::SpotLight::make({{0, 2, 1}, core::Rgbf(2), {0, 0, 1}}, {0, -1, -0.4}, 60, 0.5));
     }},
    {"SkySunsAndLampsThatChancePicks",
     [](Room& r) {
         r.openToSky();
         r.addLampsAllAround();
         r.scene.addLight("disc", gr::SunLight::make({-1, -1, 0.4}, core::Rgbf(0.7f, 0.5f, 0.3f), 20));
         r.scene.addLight("point", gr::ParallelLight::make({0.3, -1, -0.4}, core::Rgbf(0.1f, 0.2f, 0.4f)));
         r.scene.settings.samplesPerLightSource = 2;
     }},
    {"SunsAloneThatChancePicks",
     [](Room& r) {
         r.openToSky();
         r.scene.aroundIt = {};
         for (int i = 0; i < 6; ++i)
             r.scene.addLight("sun" + std::to_string(i),
                              gr::SunLight::make({i - 2.5, -2, 0.7 * i - 2}, core::Rgbf(0.2f), 3 + 9 * i));
     }},
    {"Spots",
     [](Room& r) {
         for (int i = 0; i < 6; ++i)
             r.scene.addLight(
                 "spot" + std::to_string(i),
                 gr::SpotLight::make({{0.5f * static_cast<float>(i) - 1, 1.5f, 0}, core::Rgbf(0.5f), {0, 0, 1}},
                                     {i - 3., -2, 0.5}, 20 + 25 * i, 0.2 * i));
     }},
    {"MeshWithNormals",
     [](Room& r) {
         // Few faces: where it is bright the light would often shine through.
         r.addSmoothBall(core::Rgbf(0.8f), {0, -0.2, 0.3});
         r.scene.addPointLight("behind", {{0.5f, 1.4f, -1.8f}, core::Rgbf(2), {0, 0, 1}});
     }},
    {"SheetWithNormals",
     [](Room& r) {
         // Light behind it is above the horizon of the tilted normals.
         gr::FlatMesh mesh(gr::PolygonMesh{{{-1, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {-1, 1, 0.5}}, {{0, 1, 2, 3}}});
         for (const int corner : mesh.corners)
             mesh.normals.push_back(gr::packNormal(core::Vec3f(mesh.vertices[corner].x > 0 ? 0.95f : -0.95f, 0, 0.3f)));
         gr::MeshRepairs repairs;
         r.scene.add("sheet", gr::PolyhedronNode{gr::Polyhedron::make(std::move(mesh), repairs)}, core::Rgbf(0.8f));
         r.scene.addPointLight("behind", {{1.8f, 0, -1}, core::Rgbf(2), {0, 0, 1}});
     }},
    {"MeshOfMetalWithNormals",
     [](Room& r) {
         r.addSmoothBall(core::Rgbf(0.2f), {0, -0.2, 0.3});
         r.scene.database.setMaterial(":smooth", "metal");
     }},
    {"SmoothGlass",
     [](Room& r) {
         r.addSmoothBall(core::Rgbf(0.2f), {0, 0, 0.1});
         r.scene.database.setMaterial(":smooth", "glass");
     }},
    {"EyeInGlass",
     [](Room& r) {
         r.scene.add("visor", gr::BoxNode{{-1, -1, 0.9}, {2, 2, 1.05}}, Dielectric{.absorption = {0.3f, 0.1f, 0}});
     }},
    {"OpenGlass",
     [](Room& r) {
         // Its outer side is the far one: what is on this side of it is inside.
         r.scene.addPolygon("pane", {{-1.5, -1.5, 0.5}, {-1.5, 1.5, 0.5}, {1.5, 1.5, 0.5}, {1.5, -1.5, 0.5}},
                            Dielectric{.absorption = {0.3f, 0.1f, 0}});
     }},
    {"LensInGlass",
     [](Room& r) {
         r.scene.add("visor", gr::BoxNode{{0.02, -1, 1.2}, {1, 2, 0.75}}, Dielectric{.absorption = {0.9f, 0.1f, 0}});
         r.scene.settings.depthOfField = true;
         r.scene.settings.aperture = 0.2;
         r.scene.add("pebble", gr::SphereNode{{0.3, 0, 1.4}, 0.15}, core::Rgbf(0.9f));
         r.scene.addPointLight("spark", {{0.6f, 0.4f, 1.7f}, core::Rgbf(1), {0, 0, 1}});
     }},
    {"Orthographic", [](Room& r) { r.projection = Projection::orthographic; }},
    {"OrthographicLens",
     [](Room& r) {
         r.projection = Projection::orthographic;
         r.scene.settings.depthOfField = true;
         r.scene.settings.aperture = 0.15;
         r.scene.settings.focalDistance = 1.3;
     }},
    {"OrthographicHalfInGlass",
     [](Room& r) {
         r.projection = Projection::orthographic;
         r.scene.add("visor", gr::BoxNode{{0.02, -1, 1.2}, {1, 2, 0.75}}, Dielectric{.absorption = {0.9f, 0.1f, 0}});
     }},
    {"Panorama", [](Room& r) { r.projection = Projection::panorama; }},
    {"PanoramaInGlass",
     [](Room& r) {
         r.projection = Projection::panorama;
         r.scene.add("visor", gr::BoxNode{{-1, -1, 0.9}, {2, 2, 1.05}}, Dielectric{.absorption = {0.3f, 0.1f, 0}});
     }},
    {"AllInFog",
     [](Room& r) {
         r.scene.add("fog", gr::BoxNode{glm::dvec3(-1.99), glm::dvec3(3.98)},
                     Dielectric{.index = 1, .absorption = {0.4f, 0.2f, 0.1f}});
         r.scene.addPointLight("point", {{-1.5f, 0, 1.2f}, core::Rgbf(0.5f), {0, 0, 1}});
     }},
    {"OverlappingGlass",
     [](Room& r) {
         r.scene.add("outer", gr::SphereNode{{0, 0, 0}, 0.8}, Dielectric{.absorption = {0.5f, 0, 0}});
         r.scene.add("inner", gr::SphereNode{{0.5, 0.2, 0.2}, 0.6},
                     Dielectric{.index = 1.3, .absorption = {0, 0.5f, 0}});
         r.scene.add("pebble", gr::SphereNode{{0, 0, 0.3}, 0.3}, core::Rgbf(0.9f));
         r.scene.settings.pathLength = 7;
     }},
    {"LightThroughGlass",
     [](Room& r) {
         r.scene.add("shade", gr::BoxNode{{-1.5, 1.2, -1.2}, {3.4, 0.3, 2.6}}, Dielectric{.absorption = {1, 0.1f, 0}});
         r.scene.settings.pathLength = 6;
     }},
    {"LightInAMirror",
     [](Room& r) {
         r.scene.add("mirror", gr::BoxNode{{-1.9, -1.5, -1.9}, {3.8, 3, 0.1}},
                     Dielectric{.index = 1e6, .sampling = core::Weights{0, 1, 0, 0}});
     }},
    {"LightInAShinyMirror",
     [](Room& r) {
         r.scene.add("mirror", gr::BoxNode{{-1.9, -1.5, -1.9}, {3.8, 3.3, 0.1}},
                     Dielectric{.specular = core::Rgbf(0.3f), .index = 1e6, .sampling = core::Weights{0, 1, 0, 0}});
         r.scene.database.remove(":block");
         r.addLamp("second", core::Rgbf(2, 3, 4), {0, 0, 1.95}, 2, 0, 90);
         r.eye = {0, 0, 1.5};
     }},
    {"Highlight",
     [](Room& r) {
         r.scene.add("shiny", gr::SphereNode{{0, 0, -0.2}, 0.7}, Dielectric{.specular = core::Rgbf(0.5f, 0.3f, 0.1f)});
     }},
    {"BlurredHighlight",
     [](Room& r) {
         r.scene.add("shiny", gr::SphereNode{{0, 0, -0.2}, 0.7},
                     Dielectric{.specular = core::Rgbf(0.5f, 0.3f, 0.1f), .perturbation = 25});
     }},
    {"WhiteAndDark",
     [](Room& r) {
         // Roulette ends no path of white, and most of black.
         r.scene.add("dark", gr::SphereNode{{0, 0, -0.2}, 0.7}, core::Rgbf(0.02f, 0.01f, 0.05f));
         r.scene.add("white", gr::BoxNode{{-1.9, -1.9, -1.9}, {0.5, 3.8, 3.8}}, core::Rgbf(1));
         r.scene.settings.pathLength = 12;
     }},
};

using ChangeAndAccelerator = std::tuple<Change, const char*>;
class PathEqualsReportWith : public testing::TestWithParam<ChangeAndAccelerator> {};

TEST_P(PathEqualsReportWith, InARoomOfAllMaterials) {
    Room room;
    room.addAll();
    room.scene.settings.accelerator = std::get<1>(GetParam());
    std::get<0>(GetParam()).make(room);
    EXPECT_TRUE(room.holds());
}

INSTANTIATE_TEST_SUITE_P(All, PathEqualsReportWith,
                         testing::Combine(testing::ValuesIn(changes), testing::Values("off", "grid", "embree")),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param);
                         });

}  // namespace
}  // namespace render
