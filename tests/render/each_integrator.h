// Tests of light that must come out with each integrator:
//     class Suite : public EachIntegrator {};
//     INSTANTIATE_TEST_SUITE_P(By, Suite, eachIntegrator, integratorName);
//     TEST_P(Suite, Name) { ... Radiometer ... }
// What the tests' files say they were seen to fail with is of the report's. All together were seen to fail with a path
// integrator that takes the cosine's density for uniform or 2 % larger, ends paths at random and does not make up for
// it or by 1 % too little, counts a lamp in full by both ways to find it, weighs the last light sample as if the path
// went on, forgets lamps in mirrors or counts them beside their highlight, does not divide by the samples of a light,
// goes one point too far, adds ambient light at every point, draws places on the lens uniform in their radius, both
// numbers of a direction alike, leaves out shadows, or a lamp's dark back, or absorption on either kind of ray, bends
// the wrong way, starts on the wrong side of glass, does not enter or leave it, forgets that it began in it or is met
// from inside, takes the eye's medium for all of the lens, and lets light through a mesh that is shaded with other
// normals.
#pragma once

#include "render/test_scene.h"

#include <gtest/gtest.h>

namespace render {

class EachIntegrator : public testing::TestWithParam<const char*> {
protected:
    EachIntegrator() { Radiometer::measuresWith = GetParam(); }
    ~EachIntegrator() override { Radiometer::measuresWith = "report"; }
};

inline const auto eachIntegrator = testing::Values("report", "path");
inline const auto integratorName = [](const auto& info) { return std::string(info.param); };

}  // namespace render
