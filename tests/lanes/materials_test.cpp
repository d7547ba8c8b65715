#include <gtest/gtest.h>

#include <algorithm>

#include "lanes/both_widths.h"
#include "materials/bsdf_of.h"
#include "materials/each_hemisphere.h"

namespace lanes {
namespace {

constexpr int count = 30'000;

template<class M>
class LanesMaterial : public testing::Test {};
TYPED_TEST_SUITE(LanesMaterial, materials::EveryMaterial, materials::MaterialName);

TYPED_TEST(LanesMaterial, ReflectsTheSame) {
    Inputs inputs(8);
    const auto directions = makeInputs<6>(count, [&] {
        const core::Vec3f wo = inputs.direction();
        core::Vec3f wi = inputs.direction();
        // Highlights are near the mirror's direction.
        if (inputs.chance(0.5)) wi = glm::normalize(core::Vec3f(-wo.x, -wo.y, wo.z) + wi * inputs.uniform(0, 0.1f));
        return Numbers<6>{wo.x, wo.y, wo.z, wi.x, wi.y, wi.z};
    });
    materials::forEachSetAndHemisphere<TypeParam>([&](const auto& material, const std::string& name) {
        SCOPED_TRACE(name);
        expectSame(directions, [&]<class Real>(const std::array<Real, 6>& x) {
            const core::Vec3<Real> wo = vectorAt(x.data()), wi = vectorAt(x.data() + 3);
            const auto bsdf = materials::bsdfOf<Real>(material);
            const core::Rgb<Real> f = bsdf.eval(wo, wi);
            return std::array<Real, 4>{f.x, f.y, f.z, bsdf.pdfW(wo, wi)};
        });
    });
}

TYPED_TEST(LanesMaterial, DrawsTheSame) {
    Inputs inputs(9);
    const auto draws = makeInputs<7>(count, [&] {
        const core::Vec3f wo = inputs.direction();
        const float method = inputs.unit(), u = inputs.unit(), v = inputs.unit();
        return Numbers<7>{wo.x, wo.y, wo.z, method, u, v, inputs.oneOf({1, 1.5f, 1 / 1.5f, 0.1f, 10})};
    });
    materials::forEachSetAndHemisphere<TypeParam>([&](const auto& material, const std::string& name) {
        SCOPED_TRACE(name);
        const auto results = expectSame(draws, [&]<class Real>(const std::array<Real, 7>& x) {
            const materials::BsdfDraw<Real> u{x[3], {x[4], x[5]}};
            const auto sample = materials::bsdfOf<Real>(material).sample(vectorAt(x.data()), u, x[6]);
            // What an invalid sample carries does not matter.
            const auto ifValid = [&](const Real& number) { return core::select(sample.valid, number, Real(0)); };
            return std::array<Real, 11>{asNumber<Real>(sample.valid),
                                        ifValid(sample.wi.x),
                                        ifValid(sample.wi.y),
                                        ifValid(sample.wi.z),
                                        ifValid(sample.weight.x),
                                        ifValid(sample.weight.y),
                                        ifValid(sample.weight.z),
                                        ifValid(sample.pdfW),
                                        ifValid(asNumber<Real>(sample.isDelta)),
                                        ifValid(asNumber<Real>(sample.isLit)),
                                        ifValid(asNumber<Real>(sample.isDiffuse))};
        });
        const auto isValid = [](const auto& sample) { return sample[0] == 1; };
        const bool canSample = !std::is_same_v<TypeParam, materials::Dielectric> || !material.sampling ||
                               (*material.sampling)[1] + (*material.sampling)[2] > 0;
        EXPECT_EQ(std::any_of(results.begin(), results.end(), isValid), canSample);
    });
}

// Each draw chooses one method, the same at every width.
TEST(LanesMethods, AreChosenTheSame) {
    Inputs inputs(16);
    const auto draws = makeInputs<5>(count, [&] {
        Numbers<5> x;
        for (float& p : x) p = inputs.chance(0.3) ? 0.f : inputs.unit();
        const float sum = x[0] + x[1] + x[2] + x[3];
        for (int method = 0; method < 4; ++method) x[method] = sum > 0 ? x[method] / sum : 0.25f;
        x[4] = std::min(x[4], 1 - 0x1p-24f);
        return x;
    });
    const auto results = expectSame(draws, []<class Real>(const std::array<Real, 5>& x) {
        const auto chosen = materials::choose(materials::Methods<Real>{x[0], x[1], x[2], x[3]}, x[4]);
        return std::array<Real, 4>{asNumber<Real>(chosen.diffuse), asNumber<Real>(chosen.reflective),
                                   asNumber<Real>(chosen.refractive), asNumber<Real>(chosen.shirley)};
    });
    for (const auto& chosen : results) ASSERT_EQ(chosen[0] + chosen[1] + chosen[2] + chosen[3], 1);
}

}  // namespace
}  // namespace lanes
