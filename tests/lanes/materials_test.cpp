#include <gtest/gtest.h>

#include "lanes/both_widths.h"
#include "materials/parameter_sets.h"

namespace lanes {
namespace {

constexpr int count = 30'000;

template<class M>
class LanesMaterial : public testing::Test {};
TYPED_TEST_SUITE(LanesMaterial, materials::EveryMaterial, materials::MaterialName);

TYPED_TEST(LanesMaterial, ReflectsTheSame) {
    Inputs inputs(8);
    const auto directions = makeInputs<6>(count, [&] {
        const core::Vec3f wo = inputs.direction(), wi = inputs.direction();
        return Numbers<6>{wo.x, wo.y, wo.z, wi.x, wi.y, wi.z};
    });
    for (const TypeParam& material : materials::parameterSets<TypeParam>()) {
        expectSame(directions, [&]<class Real>(const std::array<Real, 6>& x) {
            const core::Vec3<Real> wo = vectorAt(x.data()), wi = vectorAt(x.data() + 3);
            const core::Rgb<Real> f = material.template eval<Real>(wo, wi);
            return std::array<Real, 4>{f.x, f.y, f.z, material.template pdfW<Real>(wo, wi)};
        });
    }
}

TYPED_TEST(LanesMaterial, DrawsTheSame) {
    Inputs inputs(9);
    const auto draws = makeInputs<5>(count, [&] {
        const core::Vec3f wo = inputs.direction();
        const float u = inputs.unit(), v = inputs.unit();
        return Numbers<5>{wo.x, wo.y, wo.z, u, v};
    });
    for (const TypeParam& material : materials::parameterSets<TypeParam>()) {
        const auto results = expectSame(draws, [&]<class Real>(const std::array<Real, 5>& x) {
            const auto sample = material.template sample<Real>(vectorAt(x.data()), core::Vec2<Real>(x[3], x[4]));
            // What an invalid sample carries does not matter.
            const auto ifValid = [&](const Real& number) { return core::select(sample.valid, number, Real(0)); };
            return std::array<Real, 9>{asNumber<Real>(sample.valid), ifValid(sample.wi.x),     ifValid(sample.wi.y),
                                       ifValid(sample.wi.z),         ifValid(sample.weight.x), ifValid(sample.weight.y),
                                       ifValid(sample.weight.z),     ifValid(sample.pdfW),     Real(sample.isDelta)};
        });
        EXPECT_TRUE(std::any_of(results.begin(), results.end(), [](const auto& sample) { return sample[0] == 1; }));
    }
}

}  // namespace
}  // namespace lanes
