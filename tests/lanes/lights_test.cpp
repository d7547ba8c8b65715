#include <gtest/gtest.h>

#include <algorithm>

#include "gr/light.h"
#include "gr/sky_pictures.h"
#include "lanes/both_widths.h"
#include "render/transport/light_node.h"

namespace lanes {
namespace {

constexpr int count = 50'000;

template<class Real>
std::array<Real, 10> numbersOf(const gr::LightSample<Real>& sample) {
    return {sample.target.x, sample.target.y, sample.target.z, sample.wi.x,     sample.wi.y,
            sample.wi.z,     sample.weight.x, sample.weight.y, sample.weight.z, sample.pdfW};
}

gr::AreaLight areaLight(const core::Vec3f& corner, const core::Vec3f& edge1, const core::Vec3f& edge2) {
    const core::Vec3f normal = glm::cross(edge1, edge2);
    const float area = glm::length(normal);
    return {.corner = corner,
            .edge1 = edge1,
            .edge2 = edge2,
            .normal = normal / area,
            .radiance = {17, 0.5f, 0},
            .area = area,
            .error = 0,
            .errorPerUnit = 0};
}

// From in front, from behind, in the plane of the light, and on it.
TEST(LanesAreaLight, GivesTheSameLight) {
    const gr::AreaLight lights[] = {areaLight({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1}),
                                    areaLight({0.1f, -0.3f, 2}, {0.7f, 0.2f, -0.1f}, {-0.3f, 1.1f, 0.4f})};
    for (const gr::AreaLight& light : lights) {
        Inputs inputs(12);
        const auto points = makeInputs<5>(count, [&] {
            const float u = inputs.unit(), v = inputs.unit();
            core::Vec3f from = inputs.point(3);
            if (inputs.chance(0.1)) from = light.corner + light.edge1 * u + light.edge2 * v;
            if (inputs.chance(0.1)) from = light.corner + light.edge1 * from.x + light.edge2 * from.y;
            return Numbers<5>{from.x, from.y, from.z, u, v};
        });
        const auto samples = expectSame(points, [&]<class Real>(const std::array<Real, 5>& x) {
            return numbersOf(gr::broadcast<Real>(light).sample(vectorAt(x.data()), core::Vec2<Real>(x[3], x[4])));
        });
        const auto lit = std::count_if(samples.begin(), samples.end(), [](const auto& s) { return s[9] > 0; });
        EXPECT_GT(lit, count / 10);
        EXPECT_LT(lit, count * 9 / 10);
    }
}

TEST(LanesPointLight, GivesTheSameLight) {
    const gr::PointLight lights[] = {{{0, 0, 0}, {1, 2, 3}, {1, 0, 0}}, {{0.1f, 2, -1}, {0.3f, 0, 5}, {0, 0.2f, 0.7f}}};
    for (const gr::PointLight& light : lights) {
        Inputs inputs(13);
        const auto points = makeInputs<3>(count, [&] {
            const core::Vec3f from = inputs.chance(0.05) ? light.position : inputs.point(5);
            return Numbers<3>{from.x, from.y, from.z};
        });
        const auto samples = expectSame(points, [&]<class Real>(const std::array<Real, 3>& x) {
            return numbersOf(gr::broadcast<Real>(light).sample(vectorAt(x.data())));
        });
        const auto dark = std::count_if(samples.begin(), samples.end(), [](const auto& s) { return s[8] == 0; });
        EXPECT_GT(dark, 0);
        EXPECT_LT(dark, count / 10);
    }
}

// Each lane its own light.
TEST(LanesPointLight, IsGathered) {
    Inputs inputs(14);
    std::vector<gr::PointLight> lights;
    for (int i = 0; i < 100; ++i)
        lights.push_back({inputs.point(5), glm::abs(inputs.point(9)), {inputs.unit(), 0, inputs.unit()}});
    const auto points = makeInputs<4>(count, [&] {
        const core::Vec3f from = inputs.point(5);
        return Numbers<4>{from.x, from.y, from.z, std::floor(inputs.uniform(0, 99.9f))};
    });
    expectSame(points, [&]<class Real>(const std::array<Real, 4>& x) {
        auto light = gr::gathered<Real>(lights.data(), core::toUInt(x[3]));
        light.divideBy(x[0]);
        const auto sample = light.sample(vectorAt(x.data()));
        const core::Vec3<Real> end = light.shadowEnd(vectorAt(x.data()), sample.target);
        std::array<Real, 13> numbers;
        std::copy_n(numbersOf(sample).begin(), 10, numbers.begin());
        for (int axis = 0; axis < 3; ++axis) numbers[static_cast<std::size_t>(10 + axis)] = end[axis];
        return numbers;
    });
}

std::array<gr::SunLight, 2> suns() {
    return {gr::SunLight::make({1, -2, 0.3}, {3, 2, 1}, 0.53), gr::SunLight::make({0, 0, 1}, {0, 2, 1}, 150)};
}

// What endless lights send to where they are seen, and what they answer.
TEST(LanesEndlessLight, GivesTheSameLight) {
    const gr::SkyGrid smooth = gr::smoothSky(), spotted = gr::spottedSky();
    const gr::SkyLight skies[] = {gr::lightOf(smooth, 0.3), gr::lightOf(spotted)};
    const auto check = [](const auto& light) {
        Inputs inputs(16);
        const auto points = makeInputs<5>(count, [&] {
            core::Vec3f wi = glm::normalize(inputs.point(1));
            if (inputs.chance(0.1)) wi = {0, inputs.chance(0.5) ? 1 : -1, 0};
            if (inputs.chance(0.1)) wi = {0, 0, inputs.chance(0.5) ? 1 : -1};
            return Numbers<5>{wi.x, wi.y, wi.z, inputs.unit(), inputs.unit()};
        });
        expectSame(points, [&]<class Real>(const std::array<Real, 5>& x) {
            const auto lights = gr::broadcast<Real>(light);
            const auto seen = lights.seen(vectorAt(x.data()));
            std::array<Real, 14> numbers;
            std::copy_n(numbersOf(lights.sample(vectorAt(x.data()), core::Vec2<Real>(x[3], x[4]))).begin(), 10,
                        numbers.begin());
            numbers[10] = seen.radiance.x;
            numbers[11] = seen.radiance.y;
            numbers[12] = seen.radiance.z;
            numbers[13] = seen.pdfW;
            return numbers;
        });
    };
    for (const gr::SkyLight& sky : skies) check(sky);
    for (const gr::SunLight& sun : suns()) check(sun);
}

// Each lane its own, where chance has picked them.
TEST(LanesEndlessLight, IsGathered) {
    const gr::SkyGrid grid = gr::smoothSky();
    const std::vector<gr::SkyLight> skies{gr::lightOf(grid, 0.1)};
    const auto all = suns();
    Inputs inputs(17);
    const auto points = makeInputs<4>(count, [&] {
        return Numbers<4>{inputs.unit(), inputs.unit(), inputs.unit(), std::floor(inputs.uniform(0, 1.99f))};
    });
    expectSame(points, [&]<class Real>(const std::array<Real, 4>& x) {
        auto sky = gr::gathered<Real>(skies.data(), core::UInt<Real>(0));
        auto sun = gr::gathered<Real>(all.data(), core::toUInt(x[3]));
        sky.divideBy(x[2]);
        sun.divideBy(x[2]);
        std::array<Real, 20> numbers;
        const core::Vec2<Real> u(x[0], x[1]);
        std::copy_n(numbersOf(sky.sample(vectorAt(x.data()), u)).begin(), 10, numbers.begin());
        std::copy_n(numbersOf(sun.sample(vectorAt(x.data()), u)).begin(), 10, numbers.begin() + 10);
        return numbers;
    });
}

TEST(LanesSpotLight, GivesTheSameLight) {
    Inputs inputs(18);
    std::vector<gr::SpotLight> lights;
    for (int i = 0; i < 100; ++i)
        lights.push_back(gr::SpotLight::make(
            {inputs.point(5), glm::abs(inputs.point(9)), {inputs.unit(), 0, inputs.unit()}},
            glm::dvec3(inputs.point(1)), 180 * inputs.unit() + 1e-3, inputs.chance(0.2) ? 0 : inputs.unit()));
    const auto points = makeInputs<4>(count, [&] {
        const core::Vec3f from = inputs.point(5);
        return Numbers<4>{from.x, from.y, from.z, std::floor(inputs.uniform(0, 99.9f))};
    });
    const auto samples = expectSame(points, [&]<class Real>(const std::array<Real, 4>& x) {
        return numbersOf(gr::gathered<Real>(lights.data(), core::toUInt(x[3])).sample(vectorAt(x.data())));
    });
    const auto dark = std::count_if(samples.begin(), samples.end(), [](const auto& s) { return s[6] == 0; });
    EXPECT_GT(dark, count / 10);
    EXPECT_LT(dark, count * 99 / 100);
}

// From within the ball, on its rim, before, beside and behind it; with narrow cones, wide ones and whole spheres.
TEST(LanesLightNode, HasTheSameImportance) {
    Inputs inputs(15);
    const auto points = makeInputs<9>(count, [&] {
        const core::Vec3f at = inputs.point(3);
        const float cosine = inputs.chance(0.3) ? -1 : inputs.uniform(-1, 1);
        const float x = inputs.chance(0.5) ? 0 : inputs.unit(), y = inputs.chance(0.5) ? 0 : inputs.unit();
        return Numbers<9>{at.x,
                          at.y,
                          at.z,
                          inputs.unit(),
                          cosine,
                          inputs.chance(0.1) ? 0 : inputs.unit(),
                          x,
                          y,
                          inputs.chance(0.3) ? 0.f : 1.f};
    });
    const auto importances = expectSame(points, [&]<class Real>(const std::array<Real, 9>& x) {
        const Real sine = core::sqrt(Real(1) - x[4] * x[4]);
        const render::LightNode<Real> node{core::broadcast<Real>(core::Vec3f(0.1f, -0.2f, 0)),
                                           x[3],
                                           core::broadcast<Real>(core::Vec3f(0.6f, 0, -0.8f)),
                                           x[4],
                                           sine,
                                           x[5],
                                           {x[6], x[7], x[8]},
                                           x[3] * Real(0.6f)};
        return std::array<Real, 1>{node.importance(vectorAt(x.data()))};
    });
    for (const auto& importance : importances) ASSERT_TRUE(importance[0] >= 0 && importance[0] <= 0x1p100f);
    const auto dark = std::count_if(importances.begin(), importances.end(), [](const auto& i) { return i[0] == 0; });
    EXPECT_GT(dark, count / 10);
    EXPECT_LT(dark, count / 2);
}

}  // namespace
}  // namespace lanes
