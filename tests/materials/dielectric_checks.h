// What a smooth dielectric does, by the textbook, against what a material's samples do.
#pragma once

#include <sstream>
#include <string>

#include "materials/bsdf_of.h"
#include "materials/dielectric.h"
#include "materials/directions.h"

namespace materials {

// At this angle to the normal, n being the index beyond over that on this side. Fresnel's sine and tangent laws (Born
// and Wolf, 1.5.2).
inline double textbookReflectance(double angle, double n) {
    const double sine = std::sin(angle) / n;
    if (sine >= 1) return 1;
    const double beyond = std::asin(sine);
    // At the normal both laws are 0 / 0.
    if (angle < 1e-6) return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    const double across = std::sin(angle - beyond) / std::sin(angle + beyond);
    const double along = std::tan(angle - beyond) / std::tan(angle + beyond);
    return (across * across + along * along) / 2;
}

inline core::Vec3f directionAt(double angle, double phi = 0.4) {
    return {std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)};
}

// The sample of one method alone.
template<class M>
BsdfSample<float> sampleBy(const M& material, const core::Weights& method, const core::Vec3f& wo, float n) {
    M alone = material;
    alone.sampling = method;
    return bsdfOf(alone).sample(wo, BsdfDraw<float>{0.5f, {0.3f, 0.6f}}, n);
}

// What is wrong with the weights that reflection and refraction carry at this angle, and with the refracted direction.
// Empty where they are right.
template<class M>
std::string interfaceFault(const M& material, double angle, float n) {
    constexpr double relative = 2e-5;
    const core::Vec3f wo = directionAt(angle);
    // The angle that wo has after rounding; from its sine where that knows it better.
    const double x = wo.x, y = wo.y, z = wo.z, sine = std::hypot(x, y);
    const double rounded = std::atan2(sine, z), reflectance = textbookReflectance(rounded, n);
    const auto reflected = sampleBy(material, {0, 1, 0, 0}, wo, n), refracted = sampleBy(material, {0, 0, 1, 0}, wo, n);
    std::ostringstream fault;
    const auto expect = [&](const char* what, double is, double expected, double tolerance) {
        if (!(std::abs(is - expected) <= tolerance)) fault << what << " is " << is << ", not " << expected << "; ";
    };

    if (!reflected.valid || !reflected.isDelta) fault << "nothing is reflected; ";
    if (reflected.wi != core::Vec3f(-wo.x, -wo.y, wo.z)) fault << "reflected to " << text(reflected.wi) << "; ";
    // Near the critical angle rounding shows in what little is left of the cosine beyond.
    const double sineBeyond = sine / n, cosineBeyond = std::sqrt(std::max(1e-6, 1 - sineBeyond * sineBeyond));
    const double tolerance = relative * std::max(reflectance, 0.05) + 3e-7 / cosineBeyond;
    expect("reflectance", reflected.weight.x, reflectance, tolerance);
    // Rounding decides just at the critical angle.
    if (std::abs(sineBeyond - 1) > 1e-6 && refracted.valid != (sineBeyond < 1)) fault << "wrongly total or not; ";
    if (refracted.valid && sineBeyond < 0.9999) {
        expect("transmittance", refracted.weight.x, (1 - reflectance) / n / n, tolerance / n / n);
        expect("Snell's x", refracted.wi.x, -x / n, 1e-6);
        expect("Snell's y", refracted.wi.y, -y / n, 1e-6);
        expect("the cosine beyond", refracted.wi.z, -std::sqrt(1 - sineBeyond * sineBeyond), 1e-4);
        expect("its length", glm::length(glm::dvec3(refracted.wi)), 1, 1e-6);
    }
    if (fault.str().empty()) return "";
    std::ostringstream place;
    place << "n " << n << ", " << angle * 180 / std::numbers::pi << " degrees: " << fault.str();
    return place.str();
}

// The first fault over all angles, from either side of some surfaces.
template<class M>
std::string firstInterfaceFault(const M& material) {
    std::string fault;
    for (const float n : {1.5f, 1 / 1.5f, 1.f, 1.33f, 2.4f, 0.3f, 1.001f, 0.999f, 20.f, 0.05f})
        for (int i = 0; i <= 9000 && fault.empty(); ++i)
            fault = interfaceFault(material, (i < 9000 ? i / 100.0 : 89.995) * std::numbers::pi / 180, n);
    return fault;
}

}  // namespace materials
