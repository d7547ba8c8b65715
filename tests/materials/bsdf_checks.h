// What holds for every BSDF (materials/bsdf.h), measured. A mirror's directions have no density: they count as draws
// that give no sample, and f and the pdf stay 0 for them.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "core/warp.h"
#include "materials/bsdf.h"
#include "support/histogram.h"
#include "support/test_random.h"

namespace materials {

// Where the path comes from: along the normal, and flatter and flatter, on different sides.
inline std::array<core::Vec3f, 5> outgoingDirections() {
    std::array<core::Vec3f, 5> directions;
    const double cosines[] = {1, 0.8, 0.5, 0.1, 0.001};
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double sine = std::sqrt(1 - cosines[i] * cosines[i]);
        const double phi = 1.1 * static_cast<double>(i);
        directions[i] = {sine * std::cos(phi), sine * std::sin(phi), cosines[i]};
    }
    return directions;
}

// Uniform in [0, 1), as a renderer draws them: never 1 by rounding.
inline float nextFloat(support::TestRandom& random) {
    return static_cast<float>(random.nextBits() >> 40) * 0x1p-24f;
}
inline core::Vec2f nextPoint(support::TestRandom& random) {
    const float u = nextFloat(random);
    const float v = nextFloat(random);
    return {u, v};
}

// Uniform over the upper hemisphere.
inline core::Vec3f nextDirection(support::TestRandom& random) {
    return core::squareToUniformHemisphere(nextPoint(random));
}

constexpr int samples = 1'000'000;

// Whether samples are spread as the pdf says, and how much of the sphere the pdf covers.
template<class M>
support::DistributionResult testSampling(const M& material, const core::Vec3f& wo) {
    support::SphereHistogram histogram;
    support::TestRandom random(1);
    for (int i = 0; i < samples; ++i) {
        const BsdfSample<float> sample = material.template sample<float>(wo, nextPoint(random));
        if (sample.valid && !sample.isDelta)
            histogram.add(sample.wi.x, sample.wi.y, sample.wi.z);
        else
            histogram.addMiss();
    }
    return histogram.test([&](double x, double y, double z) { return material.pdfW(wo, core::Vec3f(x, y, z)); });
}

// |a - b|, relative to the larger.
inline bool agree(float a, float b, float relative) {
    return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

inline std::string text(const core::Vec3f& v) {
    std::ostringstream text;
    text << "(" << v.x << " " << v.y << " " << v.z << ")";
    return text.str();
}

// What is wrong with a sample: its direction, or that it disagrees with pdfW and eval. Empty where nothing is.
template<class M>
std::string sampleFault(const M& material, const core::Vec3f& wo, const BsdfSample<float>& sample) {
    constexpr float relative = 1e-4f;
    if (!sample.valid || sample.isDelta) return "";
    const core::Vec3f& wi = sample.wi;
    const float pdf = material.pdfW(wo, wi);
    const core::Rgbf expected = material.eval(wo, wi) * (std::abs(wi.z) / pdf);
    std::ostringstream fault;
    if (!(std::abs(glm::length(wi) - 1) < 1e-5f)) fault << "its length is " << glm::length(wi) << "; ";
    if (!(pdf > 0)) fault << "it is where the pdf is " << pdf << "; ";
    if (!agree(sample.pdfW, pdf, relative)) fault << "its pdf is " << sample.pdfW << ", pdfW says " << pdf << "; ";
    for (int channel = 0; channel < 3; ++channel)
        if (!agree(sample.weight[channel], expected[channel], relative) || sample.weight[channel] < 0)
            fault << "its weight is " << text(sample.weight) << ", f * |cos| / pdf is " << text(expected) << "; ";
    return fault.str().empty() ? "" : "wo " + text(wo) + ", wi " + text(wi) + ": " + fault.str();
}

// The first fault among many samples.
template<class M>
std::string firstSampleFault(const M& material, const core::Vec3f& wo) {
    support::TestRandom random(2);
    std::string fault;
    for (int i = 0; i < 200'000 && fault.empty(); ++i)
        fault = sampleFault(material, wo, material.template sample<float>(wo, nextPoint(random)));
    return fault;
}

// Helmholtz: light that goes the other way is reflected as much, for two directions on the same side.
template<class M>
std::string firstReciprocityFault(const M& material) {
    support::TestRandom random(3);
    for (int i = 0; i < 200'000; ++i) {
        const core::Vec3f a = nextDirection(random);
        const core::Vec3f b = nextDirection(random);
        const core::Rgbf there = material.eval(a, b);
        const core::Rgbf back = material.eval(b, a);
        for (int channel = 0; channel < 3; ++channel)
            if (!agree(there[channel], back[channel], 1e-5f))
                return text(a) + " to " + text(b) + " is " + text(there) + ", back it is " + text(back);
    }
    return "";
}

// The part of the light that comes along wo which goes out again, in one channel: f * |cos| over the whole sphere.
template<class M>
double albedo(const M& material, const core::Vec3f& wo, int channel) {
    const auto reflected = [&](double cosine, double phi) {
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const core::Vec3f wi(sine * std::cos(phi), sine * std::sin(phi), cosine);
        return material.eval(wo, wi)[channel] * std::abs(cosine);
    };
    // The horizon is an edge of both domains: f may jump there.
    const double turn = 2 * std::numbers::pi;
    return support::integrate2d(reflected, 0, 1, 0, turn, 1e-6) + support::integrate2d(reflected, -1, 0, 0, turn, 1e-6);
}

// The same by sampling: the mean weight, for each channel.
template<class M>
std::array<support::RunningMean, 3> sampledAlbedo(const M& material, const core::Vec3f& wo) {
    std::array<support::RunningMean, 3> weights;
    support::TestRandom random(4);
    for (int i = 0; i < samples; ++i) {
        const BsdfSample<float> sample = material.template sample<float>(wo, nextPoint(random));
        const bool counts = sample.valid && !sample.isDelta;
        for (int channel = 0; channel < 3; ++channel) weights[channel].add(counts ? sample.weight[channel] : 0);
    }
    return weights;
}

}  // namespace materials
