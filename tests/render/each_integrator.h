// Tests of light that must come out with each integrator:
//     class Suite : public EachIntegrator {};
//     INSTANTIATE_TEST_SUITE_P(By, Suite, eachIntegrator, integratorName);
//     TEST_P(Suite, Name) { ... Radiometer ... }
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
