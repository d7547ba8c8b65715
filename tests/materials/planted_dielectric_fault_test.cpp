// The checks of dielectric_checks.h are seen to fail: on glass with one fault each.
#include <gtest/gtest.h>

#include "materials/dielectric_checks.h"
#include "support/statistics.h"

namespace materials {
namespace {

using core::Vec3;

TEST(PlantedDielectricFault, NoneIsFoundInDielectric) {
    EXPECT_EQ(firstInterfaceFault(Dielectric{}), "");
}

// Changes the weight of what is refracted.
struct WithoutIndexSquared : Dielectric {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Dielectric::sample(wo, u, n);
        sample.weight *= core::select(sample.wi.z < Real(0), n * n, Real(1));
        return sample;
    }
};

TEST(PlantedDielectricFault, RefractionWithoutTheChangeOfRadianceIsFound) {
    EXPECT_NE(firstInterfaceFault(WithoutIndexSquared{}), "");
}

// Schlick's approximation of what is reflected.
struct SchlicksFresnel : Dielectric {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Dielectric::sample(wo, u, n);
        const Real root = (n - Real(1)) / (n + Real(1)), f0 = root * root, x = Real(1) - wo.z;
        sample.weight = core::Rgb<Real>(
            core::select(sample.wi.z > Real(0), f0 + (Real(1) - f0) * x * x * x * x * x, sample.weight.x));
        return sample;
    }
};

TEST(PlantedDielectricFault, ApproximateFresnelIsFound) {
    EXPECT_NE(firstInterfaceFault(SchlicksFresnel{}), "");
}

// The index of the other side: light bends away from the normal where it should bend towards it.
struct OtherSide : Dielectric {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        return Dielectric::sample(wo, u, Real(1) / n);
    }
};

TEST(PlantedDielectricFault, TheIndexOfTheOtherSideIsFound) {
    EXPECT_NE(firstInterfaceFault(OtherSide{}), "");
}

// Refracts at total internal reflection too.
struct NeverTotal : Dielectric {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Dielectric::sample(wo, u, n);
        sample.valid = sample.valid | (sample.wi.z <= Real(0));
        return sample;
    }
};

TEST(PlantedDielectricFault, RefractionBeyondTheCriticalAngleIsFound) {
    EXPECT_NE(firstInterfaceFault(NeverTotal{}), "");
}

// Reflects 2 % (of the whole) too seldom: the z-test of how often.
TEST(PlantedDielectricFault, AReflectionTooSeldomIsFound) {
    support::RunningMean reflections;
    support::TestRandom random(9);
    for (int i = 0; i < 250'000; ++i) {
        BsdfDraw<float> u = nextDraw(random);
        u.method *= 1 / 0.98f;
        reflections.add(Dielectric{}.sample(directionAt(0.7), u, 1 / 1.5f).wi.z > 0 ? 1 : 0);
    }
    EXPECT_FALSE(support::zTest(reflections, textbookReflectance(0.7, 1 / 1.5f)).accepted);
}

}  // namespace
}  // namespace materials
