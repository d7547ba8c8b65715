// How much of the light that goes out along wo comes from all directions together: eval over the hemisphere.
#pragma once

#include "materials/bsdf_checks.h"

namespace materials {

// The integral of f(direction) over the upper hemisphere.
template<class Map, class Function>
double integrateOver(const Map& map, const Function& f) {
    constexpr int pieces = 8, mostPanels = 400;
    constexpr double tolerance = 1e-6 / (pieces * pieces), size = 1.0 / pieces;
    const auto integrand = [&](double s, double t) {
        const MappedDirection direction = map.at(s, t);
        return f(direction.w) * direction.solidAngle;
    };
    double sum = 0;
    for (int i = 0; i < pieces; ++i)
        for (int j = 0; j < pieces; ++j)
            sum += support::estimate2d(integrand, i * size, (i + 1) * size, j * size, (j + 1) * size, tolerance,
                                       mostPanels)
                       .value;
    return sum;
}

inline double mean(const core::Rgbf& c) {
    return (static_cast<double>(c.x) + c.y + c.z) / 3;
}

// value: the number that is made of the colour that eval gives.
template<class M, class Value>
double albedo(const M& material, const core::Vec3f& wo, const Value& value) {
    const auto bsdf = bsdfOf(material);
    const auto reflected = [&](const core::Vec3f& wi) { return value(bsdf.eval(wo, wi)); };
    return withMap(material, wo, [&](const auto& map) { return integrateOver(map, reflected); });
}

// Over the cone of the perturbed reflection alone.
template<class M, class Value>
double albedoInCone(const M& material, const core::Vec3f& wo, const Value& value) {
    const double height = 1 - std::cos(material.perturbation * std::numbers::pi / 180), turn = 2 * std::numbers::pi;
    const core::Frame<double> frame{glm::dvec3(mirrored(wo))};
    const auto bsdf = bsdfOf(material);
    const auto integrand = [&](double depth, double phi) {
        const double radius = std::sqrt(depth * (2 - depth));
        const glm::dvec3 local(radius * std::cos(phi), radius * std::sin(phi), 1 - depth);
        return value(bsdf.eval(wo, core::Vec3f(frame.toWorld(local))));
    };
    return support::estimate2d(integrand, 0, height, 0, turn, 1e-9, 4000).value;
}

// Whether samples go wherever light is reflected to; otherwise they go to the cone alone.
template<class M>
bool samplesEverything(const M& material) {
    const auto& sampling = material.sampling;
    return !sampling || (*sampling)[0] > 0 || (M::canSample[3] && (*sampling)[3] > 0);
}

// What the mean weight should be.
template<class M>
double expectedWeight(const M& material, const core::Vec3f& wo) {
    return samplesEverything(material) ? albedo(material, wo, mean) : albedoInCone(material, wo, mean);
}

template<class M>
support::RunningMean sampledWeight(const M& material, const core::Vec3f& wo) {
    support::RunningMean weight;
    support::TestRandom random(4);
    for (int i = 0; i < 250'000; ++i) {
        const BsdfSample<float> sample = draw(material, wo, random);
        weight.add(sample.valid && !sample.isDelta ? mean(sample.weight) : 0);
    }
    return weight;
}

// Whether the mean of the weights passes the suite's z-test.
template<class M>
bool albedoIsAccepted(const M& material, const core::Vec3f& wo) {
    return support::zTest(sampledWeight(material, wo), expectedWeight(material, wo)).accepted;
}

}  // namespace materials
