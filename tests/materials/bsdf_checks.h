// What holds for every BSDF (materials/bsdf.h), measured. A delta's directions have no density: they count as draws
// that give no sample.
#pragma once

#include <array>
#include <sstream>
#include <string>

#include "core/frame.h"
#include "materials/bsdf_of.h"
#include "materials/directions.h"
#include "materials/lobe_map.h"
#include "materials/methods.h"
#include "support/histogram.h"

namespace materials {

constexpr int samples = 1'000'000;

// How wide the narrowest part of a material's pdf and eval is, in radians.
template<class M>
double lobeWidth(const M& material) {
    double width = 1;
    if (material.sampling && (*material.sampling)[1] > 0 && material.perturbation > 0)
        width = material.perturbation * std::numbers::pi / 180;
    if constexpr (requires { material.exponents; })
        width = std::min(width, 2 / std::sqrt(std::max(material.exponents.value.x, material.exponents.value.y) + 1.0));
    return std::min(width, 1.0);
}

// use(map), with the map that shows the material's lobe best.
template<class M, class Use>
auto withMap(const M& material, const core::Vec3f& wo, const Use& use) {
    if constexpr (requires { material.exponents; }) {
        const core::Vec2f& n = material.exponents.value;
        if (core::max(n.x, n.y) > 500)
            return use(HalfVectorMap(wo, 1 / std::sqrt(n.x + 1.0), 1 / std::sqrt(n.y + 1.0)));
    }
    return use(LobeMap(mirrored(wo), lobeWidth(material)));
}

template<class M>
BsdfSample<float> draw(const M& material, const core::Vec3f& wo, support::TestRandom& random) {
    return bsdfOf(material).sample(wo, nextDraw(random), 1.f);
}

template<class M, class Map>
support::DistributionResult testSampling(const M& material, const core::Vec3f& wo, const Map& map) {
    support::SquareHistogram histogram(25, 25);
    support::TestRandom random(1);
    for (int i = 0; i < samples; ++i) {
        const BsdfSample<float> sample = draw(material, wo, random);
        const Place place = map.placeOf(sample.wi);
        if (sample.valid && !sample.isDelta)
            histogram.add(place.s, place.t);
        else
            histogram.addMiss();
    }
    const auto bsdf = bsdfOf(material);
    return histogram.test([&](double s, double t) {
        const MappedDirection direction = map.at(s, t);
        return bsdf.pdfW(wo, direction.w) * direction.solidAngle;
    });
}

// Whether samples are spread as the pdf says, and how much of the upper hemisphere the pdf covers. Where no draw gives
// a sample the pdf has to be 0.
template<class M>
support::DistributionResult testSampling(const M& material, const core::Vec3f& wo) {
    auto result = withMap(material, wo, [&](const auto& map) { return testSampling(material, wo, map); });
    if (result.missed == 1) result.accepted = result.integral == 0;
    return result;
}

// Whether the pdf's integral and the draws without a sample make 1: the former to 10^-3, the latter have noise.
inline bool sumsToOne(const support::DistributionResult& result) {
    const double noise = std::sqrt(result.missed * (1 - result.missed) / samples);
    return std::abs(result.integral + result.missed - 1) < 1e-3 + 4 * noise;
}

// |a - b|, relative to the larger.
inline bool agree(float a, float b, float relative) {
    return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

// What is wrong with a sample: its direction, or that it disagrees with pdfW and eval. Empty where nothing is.
template<class M>
std::string sampleFault(const M& material, const core::Vec3f& wo, const BsdfSample<float>& sample) {
    constexpr float relative = 1e-4f;
    if (!sample.valid) return "";
    const core::Vec3f& wi = sample.wi;
    std::ostringstream fault;
    if (!(std::abs(glm::length(wi) - 1) < 1e-5f)) fault << "its length is " << glm::length(wi) << "; ";
    const auto bsdf = bsdfOf(material);
    const float pdf = bsdf.pdfW(wo, wi);
    if (!agree(sample.pdfW, pdf, relative)) fault << "its pdf is " << sample.pdfW << ", pdfW says " << pdf << "; ";
    if (sample.isDelta == (pdf > 0)) fault << "it is where the pdf is " << pdf << "; ";
    const core::Rgbf expected = sample.isDelta ? sample.weight : bsdf.eval(wo, wi) / pdf;
    for (int channel = 0; channel < 3; ++channel)
        if (!agree(sample.weight[channel], expected[channel], relative) || !(sample.weight[channel] >= 0))
            fault << "its weight is " << text(sample.weight) << ", f * |cos| / pdf is " << text(expected) << "; ";
    return fault.str().empty() ? "" : "wo " + text(wo) + ", wi " + text(wi) + ": " + fault.str();
}

// The first fault among many samples.
template<class M>
std::string firstSampleFault(const M& material, const core::Vec3f& wo) {
    support::TestRandom random(2);
    std::string fault;
    for (int i = 0; i < 50'000 && fault.empty(); ++i) fault = sampleFault(material, wo, draw(material, wo, random));
    return fault;
}

// Helmholtz: light that goes the other way is reflected as much, for two directions on the same side.
template<class M>
std::string firstReciprocityFault(const M& material) {
    const auto bsdf = bsdfOf(material);
    support::TestRandom random(3);
    for (int i = 0; i < 100'000; ++i) {
        const core::Vec3f a = nextDirection(random);
        // Most light goes near the mirror's direction.
        const bool isNear = i % 2 == 0;
        const core::Vec3f b =
            isNear ? nextDirectionNear(mirrored(a), lobeWidth(material), random) : nextDirection(random);
        if (a.z <= 0 || b.z <= 0) continue;
        const core::Rgbf there = bsdf.eval(a, b) / b.z;
        const core::Rgbf back = bsdf.eval(b, a) / a.z;
        for (int channel = 0; channel < 3; ++channel)
            if (!agree(there[channel], back[channel], 1e-5f))
                return text(a) + " to " + text(b) + " is " + text(there) + ", back it is " + text(back);
    }
    return "";
}

// Neither light nor samples go through an opaque surface, or from below to below.
template<class M>
std::string firstFaultBelow(const M& material) {
    const auto bsdf = bsdfOf(material);
    support::TestRandom random(5);
    for (int i = 0; i < 50'000; ++i) {
        const core::Vec3f a = nextDirection(random), b = nextDirection(random);
        const core::Vec3f below(a.x, a.y, -a.z), alsoBelow(b.x, b.y, -b.z);
        for (const auto& [wo, wi] : {std::pair(below, b), std::pair(b, below), std::pair(below, alsoBelow)})
            if (bsdf.eval(wo, wi) != core::Rgbf(0) || bsdf.pdfW(wo, wi) != 0)
                return "there is light or a pdf from " + text(wo) + " to " + text(wi);
    }
    return "";
}

}  // namespace materials
