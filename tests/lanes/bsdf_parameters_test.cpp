// BSDFs whose parameters differ from lane to lane: each lane's is that of a float with the same parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "lanes/both_widths.h"
#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/shirley.h"

namespace lanes {
namespace {

constexpr int count = 30'000;

// make: from numbers of [0, 1], an array of Reals, to a BSDF.
template<std::size_t parameters, class Make>
void expectSameBsdf(const Make& make) {
    Inputs inputs(23);
    const auto draws = makeInputs<10 + parameters>(count, [&] {
        const core::Vec3f wo = inputs.direction(), wi = inputs.direction();
        Numbers<10 + parameters> x{wo.x, wo.y, wo.z, wi.x, wi.y, wi.z};
        for (std::size_t i = 6; i < x.size(); ++i) x[i] = inputs.unit();
        return x;
    });
    const auto results = expectSame(draws, [&]<class Real>(const std::array<Real, 10 + parameters>& x) {
        const auto bsdf = make(x.data() + 10);
        const core::Vec3<Real> wo = vectorAt(x.data()), wi = vectorAt(x.data() + 3);
        const core::Rgb<Real> f = bsdf.eval(wo, wi);
        const auto sample = bsdf.sample(wo, {x[6], {x[7], x[8]}}, Real(0.5f) + x[9]);
        // What an invalid sample carries does not matter.
        const auto ifValid = [&](const Real& number) { return core::select(sample.valid, number, Real(0)); };
        return std::array<Real, 9>{f.x,
                                   f.y,
                                   f.z,
                                   bsdf.pdfW(wo, wi),
                                   ifValid(sample.weight.x),
                                   ifValid(sample.weight.y),
                                   ifValid(sample.weight.z),
                                   ifValid(sample.wi.z),
                                   ifValid(asNumber<Real>(sample.isLit))};
    });
    const auto isBright = [](const auto& result) { return result[0] > 0 && result[0] != result[1]; };
    EXPECT_TRUE(std::any_of(results.begin(), results.end(), isBright));
}

const std::optional<core::Weights> mixtures[] = {std::nullopt, core::Weights{0.3f, 0.3f, 0.1f, 0.3f}};

TEST(LanesBsdfParameters, OfDiffuseMayDiffer) {
    for (const auto& sampling : mixtures)
        expectSameBsdf<3>([&]<class Real>(const Real* p) {
            return materials::DiffuseBsdf<Real>{vectorAt(p), sampling, 30};
        });
}

TEST(LanesBsdfParameters, OfDielectricMayDiffer) {
    for (const auto& sampling : mixtures)
        expectSameBsdf<3>([&]<class Real>(const Real* p) {
            return materials::DielectricBsdf<Real>{vectorAt(p), sampling, 10};
        });
}

TEST(LanesBsdfParameters, OfShirleyMayDiffer) {
    for (const auto& sampling : mixtures)
        expectSameBsdf<8>([&]<class Real>(const Real* p) {
            const Real most(1000);
            return materials::ShirleyBsdf<Real>{vectorAt(p), vectorAt(p + 3), {p[6] * most, p[7] * most}, sampling, 10};
        });
}

}  // namespace
}  // namespace lanes
