// Between a point of a convex shape and a light that it faces nothing stands, not the shape itself and not the light.
// GRSH_TEST_RAYS=100 traces 10^8 segments.

#include "gr/convex_places.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Vec3f;

// A light of 0.001 to 0.5 times its distance, which the shape sees mostly from its edge. Where the shape is far from
// the origin, half of the lights are near the origin and half near the shape: each rounds on its own.
void addLight(Database& database, const ConvexPlace& place, support::TestRandom& random) {
    const glm::dvec3 shape = place.matrix[3];
    const bool atOrigin = place.distance > 0 && random.next() < 0.5;
    const glm::dvec3 aside = randomDirection(random) * place.size;
    const glm::dvec3 light = atOrigin ? aside : shape + aside * std::pow(10, 0.5 + 2.5 * random.next());
    const double away = glm::length(shape - light);

    // Its -y axis, to where it shines, turns to the shape, then off it by `tilt`.
    const glm::dvec3 to = (shape - light) / away;
    const double grazing = std::pow(10, 1.5 - 7 * random.next());
    const double tilt = random.next() < 0.7 ? 90 + (random.next() < 0.5 ? grazing : -grazing) : 80 * random.next();
    database.create(":", "light", TransformNode{});
    database.translate(":light", light);
    database.rotate(":light", 1, glm::degrees(std::atan2(-to.z, to.x)));
    database.rotate(":light", 2, glm::degrees(std::acos(-to.y)));
    database.rotate(":light", 1, 360 * random.next());
    database.rotate(":light", 0, tilt);
    const double width = 0.5 * away * std::pow(10, -2.7 * random.next());
    const double squeezeX = random.next(), squeezeZ = random.next();
    database.scale(":light", glm::dvec3(0), {width * std::exp(-2 * squeezeX), width, width * std::exp(-2 * squeezeZ)});
    database.rotate(":light", 1, 360 * random.next());
    database.create(":light", "square", AreaLightNode{core::Rgbf(1), glm::dvec3(0), 1});
}

class ShadowRayTest : public testing::TestWithParam<std::size_t> {};

// Without its share for how far away the ray starts, the light itself was in the way of one segment in a hundred.
TEST_P(ShadowRayTest, NothingIsInTheWay) {
    const ConvexShape shape = convexSolids()[GetParam()];
    support::TestRandom random(3);
    Violations blocked;
    int segments = 0;
    const auto light = [&](Database& database, const ConvexPlace& place) { addLight(database, place, random); };
    forEachPlace(shape, rayCount(60), random, light, [&](const ConvexPlace& place) {
        const AreaLight& light = place.scene.lights.of<AreaLight>().front();
        for (int i = 0; i < 120; ++i) {
            const core::Rayf ray = place.rayFromOutside(random);
            const std::optional<Hit> hit = place.accelerator->intersect(ray);
            if (!hit) continue;
            const SurfacePoint surface = place.scene.surfaceAt(ray, *hit);
            if (surface.light >= 0) continue;
            const Vec3f start = surface.offset(surface.normal);
            for (int j = 0; j < 4; ++j) {
                const float u = static_cast<float>(random.next()), v = static_cast<float>(random.next());
                const LightSample<float> sample = light.sample(surface.position, core::Vec2f(u, v));
                const float cosine = glm::dot(surface.normal, sample.wi);
                if (sample.pdfW == 0 || !(cosine > 0)) continue;
                ++segments;
                const core::Rayf shadow = shadowRay(start, light, sample.target);
                if (place.accelerator->occluded(shadow))
                    blocked.add(place.text(), ": cosine ", cosine, ", at the light ",
                                -glm::dot(light.normal, sample.wi), ", distance ", glm::length(shadow.direction),
                                ", light.error ", light.error);
            }
        }
    });
    EXPECT_EQ(blocked.count(), 0) << "of " << segments << " segments\n" << blocked.text();
    EXPECT_GT(segments, 80'000);
}

INSTANTIATE_TEST_SUITE_P(All, ShadowRayTest, testing::Range<std::size_t>(0, convexSolids().size()),
                         [](const auto& info) { return std::string(convexSolids()[info.param].name); });

// The end is a hair before the light, whatever the light's distance: so what touches the light still casts its shadow.
TEST(ShadowRay, EndsCloseToTheLight) {
    Database database;
    database.create(":", "light", AreaLightNode{core::Rgbf(1), {0, 0, 0}, 1});
    const Scene scene = compile(database, ":", {});
    for (const float distance : {1e-3f, 1.f, 1e3f, 1e6f}) {
        const Vec3f start{0.3f * distance, -distance, 0.2f * distance}, target{0.1f, 0, -0.2f};
        const core::Rayf ray = shadowRay(start, scene.lights.of<AreaLight>()[0], target);
        EXPECT_EQ(ray.origin, start);
        EXPECT_EQ(ray.tMax, 1);
        const glm::dvec3 end = glm::dvec3(ray.origin) + glm::dvec3(ray.direction);
        EXPECT_LT(end.y, 0) << distance;
        EXPECT_LT(glm::length(end - glm::dvec3(target)), 1e-5 * (1 + distance)) << distance;
    }
}

}  // namespace
}  // namespace gr
