// The older point light: pi * intensity / (c0 + c1 d + c2 d^2) on a surface that faces it.

#include "gr/light.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Rgbf;
using core::Vec3f;

TEST(PointLight, IrradianceOfASurfaceThatFacesIt) {
    const Vec3f place{1, -2, 3}, direction{2 / 7.f, -3 / 7.f, 6 / 7.f};
    const Rgbf intensity{3, 0.5f, 0};
    for (const Vec3f& attenuation : {Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1), Vec3f(0.5f, 0.2f, 0.1f)}) {
        for (const float distance : {0.01f, 1.f, 2.5f, 1000.f}) {
            const PointLight light{place, intensity, attenuation};
            const LightSample<float> sample = light.sample(place - direction * distance);
            const double d = distance;
            const double falloff = attenuation.x + attenuation.y * d + attenuation.z * d * d;
            for (int channel = 0; channel < 3; ++channel) {
                const double expected = M_PI * intensity[channel] / falloff;
                EXPECT_NEAR(sample.weight[channel], expected, 1e-4 * expected) << distance;
                EXPECT_NEAR(sample.wi[channel], direction[channel], 1e-4) << distance;
            }
            EXPECT_EQ(sample.target, place);
            EXPECT_EQ(sample.pdfW, 0) << "it has no density";
        }
    }
}

TEST(PointLight, FallsOffWithTheSquareOfTheDistance) {
    const PointLight light{Vec3f(0), Rgbf(1), {0, 0, 1}};
    const float near = light.sample(Vec3f{0, -3, 0}).weight.x, far = light.sample(Vec3f{0, -6, 0}).weight.x;
    EXPECT_FLOAT_EQ(near, 4 * far);
    EXPECT_FLOAT_EQ(near, core::pi / 9);
}

// Not where it stands itself: no direction leads there.
TEST(PointLight, IsDarkAtItsOwnPlace) {
    const PointLight light{{1, 2, 3}, Rgbf(1), {1, 1, 1}};
    EXPECT_EQ(light.sample(Vec3f{1, 2, 3}).weight, Rgbf(0));
    EXPECT_GT(light.sample(Vec3f{1, 2, 3.001f}).weight.x, 0);
}

}  // namespace
}  // namespace gr
