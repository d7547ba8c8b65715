// Albedo, normal and depth against what geometry says.
// Seen to fail with the depth along the ray, the normal not turned to the eye, an albedo for lamps, and the depth a
// mean over all samples.
#include "render/each_integrator.h"
#include "render/layer_picture.h"

namespace render {
namespace {

using core::Rgbf;
using core::Vec3f;

constexpr int width = 40, height = 30;
const glm::dvec3 eye(1, -2, 9), view = glm::normalize(glm::dvec3(-0.1, 0.25, -1));
const Camera camera(eye, view, {0.1, 2, 0.3}, 60, width, height);

// One sample through the centre of each pixel, with either integrator.
class SurfaceLayers : public EachIntegrator {
protected:
    static image::Film picture(const TestScene& scene, const Camera& camera = render::camera,
                               const glm::dvec3& eye = render::eye) {
        RenderSettings settings = scene.settings;
        settings.samplesPerPixel = 1;
        return layersOf(Radiometer(scene, eye).measuringIntegrator(), camera, settings,
                        image::Film(width, height, 0, height, everyLayer));
    }
};
INSTANTIATE_TEST_SUITE_P(By, SurfaceLayers, eachIntegrator, integratorName);

void expectNothing(const image::Film& film, int x, int y) {
    EXPECT_EQ(vectorAt(film, image::Layer::albedo, x, y), Rgbf(0));
    EXPECT_EQ(vectorAt(film, image::Layer::normal, x, y), Vec3f(0));
    EXPECT_EQ(numberAt(film, image::Layer::depth, x, y), core::infinity);
}

TEST_P(SurfaceLayers, AreThoseOfASphere) {
    const glm::dvec3 centre(0.3, -0.2, 0.5);
    const double radius = 2;
    const Rgbf colour(0.8f, 0.3f, 0.1f);
    TestScene scene;
    scene.add("ball", gr::SphereNode{centre, radius}, colour);
    const image::Film film = picture(scene);
    int met = 0, missed = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 d = glm::normalize(glm::dvec3(camera.ray(core::Vec2f(x + 0.5f, y + 0.5f)).direction));
            const double along = glm::dot(centre - eye, d), across = glm::length(centre - eye - along * d);
            if (std::abs(across - radius) < 1e-2) continue;
            if (across > radius) {
                ++missed;
                expectNothing(film, x, y);
                continue;
            }
            ++met;
            const double t = along - std::sqrt(radius * radius - across * across);
            const glm::dvec3 normal = (eye + t * d - centre) / radius;
            EXPECT_LT(glm::distance(glm::dvec3(vectorAt(film, image::Layer::normal, x, y)), normal), 2e-5)
                << x << " " << y;
            EXPECT_NEAR(numberAt(film, image::Layer::depth, x, y), t * glm::dot(d, view), 2e-5) << x << " " << y;
            EXPECT_EQ(vectorAt(film, image::Layer::albedo, x, y), colour);
        }
    }
    EXPECT_GT(met, 50);
    EXPECT_GT(missed, 500);
}

TEST_P(SurfaceLayers, HaveNormalsThatFaceTheEye) {
    TestScene scene;
    scene.add("room", gr::SphereNode{eye + glm::dvec3(0.5, 0, 0), 3}, Rgbf(0.5f));
    scene.settings.globalIllumination = true;  // what comes after the first surface is not told
    scene.settings.pathLength = 3;
    const image::Film film = picture(scene);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const core::Rayf ray = camera.ray(core::Vec2f(x + 0.5f, y + 0.5f));
            const Vec3f normal = vectorAt(film, image::Layer::normal, x, y);
            const double t = numberAt(film, image::Layer::depth, x, y) / glm::dot(glm::dvec3(ray.direction), view);
            const glm::dvec3 inward = (glm::dvec3(0.5, 0, 0) - t * glm::dvec3(ray.direction)) / 3.0;
            EXPECT_LT(glm::dot(normal, ray.direction), 0);
            EXPECT_LT(glm::distance(glm::dvec3(normal), inward), 2e-5);
        }
    }
}

// The same depth all over a wall across the view, through a lens too: what is in focus has the focal distance.
TEST_P(SurfaceLayers, HaveTheDepthAlongTheView) {
    TestScene scene;
    scene.add("wall", gr::BoxNode{{-50, -50, -2}, {100, 100, 1}}, Rgbf(0.5f));
    for (const double aperture : {0.0, 0.5}) {
        Camera camera({3, 2, 6}, {0, 0, -4}, {0.3, 1, 0}, 100, width, height);
        camera.setLens(aperture, 2);
        const image::Film film = picture(scene, camera);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_NEAR(numberAt(film, image::Layer::depth, x, y), 7, 1e-5) << x << " " << y;
    }
}

// What fills the view of a camera at the origin that looks up, exactly: equal numbers have that number as their mean.
image::Film lookUp(const TestScene& scene) {
    const Camera camera({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 40, 2, 2);
    RenderSettings settings = scene.settings;
    settings.antialiasing = true;
    settings.samplesPerPixel = 9;
    return layersOf(Radiometer(scene, {0, 0, 0}).measuringIntegrator(), camera, settings,
                    image::Film(2, 2, 0, 2, everyLayer));
}

image::Film ceiling(const materials::Material& material) {
    TestScene scene;
    scene.add("ceiling", gr::BoxNode{{-50, 3, -50}, {100, 1, 100}}, material);
    scene.addAreaLight("lamp", Rgbf(1), {0, 20, 0}, 1);
    return lookUp(scene);
}

TEST_P(SurfaceLayers, HaveTheAlbedoOfTheMaterial) {
    const Rgbf red(0.9f, 0.2f, 0.1f), gold(0.8f, 0.6f, 0.1f);
    const materials::Shirley metal{.diffuse = red, .specular = gold};
    const std::pair<materials::Material, Rgbf> expected[] = {{materials::Diffuse{red}, red},
                                                             {metal, gold + (1.f - gold) * red},
                                                             {materials::Dielectric{.absorption = red}, Rgbf(1)}};
    for (const auto& [material, albedo] : expected) {
        const image::Film film = ceiling(material);
        EXPECT_EQ(vectorAt(film, image::Layer::albedo, 1, 0), albedo);
        EXPECT_EQ(vectorAt(film, image::Layer::normal, 1, 0), Vec3f(0, -1, 0));
        EXPECT_NEAR(numberAt(film, image::Layer::depth, 1, 0), 3, 1e-6);
        EXPECT_EQ(numberAt(film, image::Layer::samples, 1, 0), 9);
    }
}

TEST_P(SurfaceLayers, HaveLampsThatReflectNothing) {
    TestScene scene;
    scene.addAreaLight("lamp", Rgbf(5, 4, 3), {0, 2, 0}, 9);
    const image::Film film = lookUp(scene);
    EXPECT_EQ(vectorAt(film, image::Layer::albedo, 0, 1), Rgbf(0));
    EXPECT_EQ(vectorAt(film, image::Layer::normal, 0, 1), Vec3f(0, -1, 0));
    EXPECT_NEAR(numberAt(film, image::Layer::depth, 0, 1), 2, 1e-6);
    EXPECT_EQ(vectorAt(film, image::Layer::variance, 0, 1), Rgbf(0)) << "it has no noise";
}

TEST_P(SurfaceLayers, AreThereWhereTheSceneIsNot) {
    TestScene scene;
    scene.settings.background = Rgbf(2);
    const image::Film film = picture(scene);
    expectNothing(film, 3, 4);
    EXPECT_EQ(numberAt(film, image::Layer::samples, 3, 4), 1);
    EXPECT_EQ(vectorAt(film, image::Layer::variance, 3, 4), Rgbf(core::infinity)) << "one sample tells nothing of it";
}

// Pixel (0, 0), from -1 to 0 at distance 1, is half covered; of its 4 x 4 samples, spread evenly, 8 meet the wall.
TEST_P(SurfaceLayers, AreMeansOverThePixel) {
    TestScene scene;
    const Rgbf colour(0.5f, 0.25f, 1);
    scene.addPolygon("wall", {{-9, -9, -2}, {-1, -9, -2}, {-1, 9, -2}, {-9, 9, -2}}, colour);
    scene.settings.antialiasing = true;
    const Camera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90, 2, 2);
    const image::Film film =
        layersOf(Radiometer(scene).measuringIntegrator(), camera, scene.settings, image::Film(2, 2, 0, 2, everyLayer));
    EXPECT_EQ(vectorAt(film, image::Layer::albedo, 0, 0), colour / 2.f);
    EXPECT_EQ(vectorAt(film, image::Layer::normal, 0, 0), Vec3f(0, 0, 0.5f));
    EXPECT_NEAR(numberAt(film, image::Layer::depth, 0, 0), 2, 1e-6) << "over those that met it";
    EXPECT_EQ(numberAt(film, image::Layer::samples, 0, 0), 16);
    expectNothing(film, 1, 1);
}

}  // namespace
}  // namespace render
