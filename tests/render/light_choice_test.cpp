// Which lights chance picks where some of them are endless.
// Seen to fail with a share that is not divided, and with endless lights counted from 0.
#include "render/transport/light_choice.h"
#include "gr/sky_pictures.h"
#include "render/test_scene.h"
#include "support/chi_square.h"
#include "support/test_random.h"

#include <gtest/gtest.h>

namespace render {
namespace {

TEST(LightChoice, PicksWithTheProbabilityThatItTells) {
    const gr::SkyGrid grid = gr::smoothSky();
    for (const int lamps : {0, 1, 6}) {
        gr::Lights lights;
        for (int i = 0; i < lamps; ++i)
            lights.of<gr::PointLight>().push_back(
                {{static_cast<float>(i), 2, 0}, core::Rgbf(static_cast<float>(1 + i)), {0, 0, 1}});
        for (int i = 0; i < 3; ++i)
            lights.of<gr::SunLight>().push_back(
                gr::SunLight::make({0, -1, 0.1 * i}, core::Rgbf(static_cast<float>(1 + 2 * i)), 1));
        lights.of<gr::SkyLight>().push_back(gr::lightOf(grid));
        const LightChoice choice(lights);
        const core::Vec3f at(0.5f, 0, 1);
        constexpr int picks = 100'000;
        std::vector<double> observed(lights.size()), expected(lights.size());
        const std::size_t placed = lights.placed();
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const float probability =
                i < placed ? choice.probability(at, static_cast<float>(i)) : choice.endlessProbability(i - placed);
            expected[i] = picks * double{probability};
        }
        support::TestRandom random(8);
        for (int i = 0; i < picks; ++i) {
            const auto pick = choice.pick(at, static_cast<float>(random.nextBits() >> 40) * 0x1p-24f);
            const auto light = static_cast<std::size_t>(pick.light);
            ASSERT_LT(light, lights.size());
            ++observed[light];
            ASSERT_NEAR(pick.probability * picks, expected[light], 1e-4 * expected[light]);
        }
        const auto result = support::chiSquareTest(observed, expected);
        EXPECT_TRUE(result.accepted) << lamps << " lamps: " << result.text;
    }
}

}  // namespace
}  // namespace render
