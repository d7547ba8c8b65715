// The checks of dielectric_checks.h are seen to fail: on glass with one fault each.
#include <gtest/gtest.h>

#include "materials/dielectric_checks.h"
#include "materials/faulty.h"
#include "support/statistics.h"

namespace materials {
namespace {

using core::Vec3f;

TEST(PlantedDielectricFault, NoneIsFoundInDielectric) {
    EXPECT_EQ(firstInterfaceFault(Dielectric{}), "");
}

// Changes the weight of what is refracted.
struct WithoutIndexSquared : DielectricBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DielectricBsdf::sample(wo, u, n);
        sample.weight *= core::select(sample.wi.z < 0, n * n, 1.f);
        return sample;
    }
};

TEST(PlantedDielectricFault, RefractionWithoutTheChangeOfRadianceIsFound) {
    EXPECT_NE(firstInterfaceFault(Faulty<Dielectric, WithoutIndexSquared>{}), "");
}

// Schlick's approximation of what is reflected.
struct SchlicksFresnel : DielectricBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DielectricBsdf::sample(wo, u, n);
        const float root = (n - 1) / (n + 1), f0 = root * root, x = 1 - wo.z;
        sample.weight = core::Rgbf(core::select(sample.wi.z > 0, f0 + (1 - f0) * x * x * x * x * x, sample.weight.x));
        return sample;
    }
};

TEST(PlantedDielectricFault, ApproximateFresnelIsFound) {
    EXPECT_NE(firstInterfaceFault(Faulty<Dielectric, SchlicksFresnel>{}), "");
}

// The index of the other side: light bends away from the normal where it should bend towards it.
struct OtherSide : DielectricBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        return DielectricBsdf::sample(wo, u, 1 / n);
    }
};

TEST(PlantedDielectricFault, TheIndexOfTheOtherSideIsFound) {
    EXPECT_NE(firstInterfaceFault(Faulty<Dielectric, OtherSide>{}), "");
}

// Refracts at total internal reflection too.
struct NeverTotal : DielectricBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DielectricBsdf::sample(wo, u, n);
        sample.valid = sample.valid | (sample.wi.z <= 0);
        return sample;
    }
};

TEST(PlantedDielectricFault, RefractionBeyondTheCriticalAngleIsFound) {
    EXPECT_NE(firstInterfaceFault(Faulty<Dielectric, NeverTotal>{}), "");
}

// Reflects 2 % (of the whole) too seldom: the z-test of how often.
TEST(PlantedDielectricFault, AReflectionTooSeldomIsFound) {
    support::RunningMean reflections;
    support::TestRandom random(9);
    for (int i = 0; i < 250'000; ++i) {
        BsdfDraw<float> u = nextDraw(random);
        u.method *= 1 / 0.98f;
        reflections.add(bsdfOf(Dielectric{}).sample(directionAt(0.7), u, 1 / 1.5f).wi.z > 0 ? 1 : 0);
    }
    EXPECT_FALSE(support::zTest(reflections, textbookReflectance(0.7, 1 / 1.5f)).accepted);
}

}  // namespace
}  // namespace materials
