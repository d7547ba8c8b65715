// The upper hemisphere as a unit square in which even a narrow lobe is wide: for histograms and integrals over it.
#pragma once

#include <cmath>
#include <numbers>

#include "core/vec.h"

namespace materials {

// The numbers from least to most as those from 0 to 1, drawn apart near a centre: scale there, ever less further off.
class Stretch {
public:
    Stretch(double least, double most, double centre, double scale)
        : centre_(centre),
          scale_(scale),
          first_(std::asinh((least - centre) / scale)),
          span_(std::asinh((most - centre) / scale) - first_) {}

    double toUnit(double x) const { return (std::asinh((x - centre_) / scale_) - first_) / span_; }
    double fromUnit(double s) const { return centre_ + scale_ * std::sinh(first_ + span_ * s); }
    double slope(double s) const { return scale_ * span_ * std::cosh(first_ + span_ * s); }

private:
    double centre_, scale_, first_, span_;
};

struct Place {
    double s, t;
};
struct MappedDirection {
    core::Vec3f w;
    double solidAngle;  // per area of the square
};

// By height above the surface and by longitude: the horizon is an edge of the square.
class LobeMap {
public:
    // centre: of the lobe, above the surface; width: its half width in radians.
    LobeMap(const core::Vec3f& centre, double width)
        : LobeMap(std::hypot(centre.x, centre.y), std::atan2(centre.y, centre.x), centre.z, width) {}

    // Outside the square where the direction is below the horizon.
    Place placeOf(const core::Vec3f& w) const {
        // Near the normal z has lost the digits that x and y still have.
        const double x = w.x, y = w.y;
        const double z = w.z > 0.7f ? std::sqrt(1 - x * x - y * y) : w.z;
        const double longitude = std::remainder(std::atan2(y, x) - longitude_, 2 * std::numbers::pi);
        return {height_.toUnit(z), turn_.toUnit(longitude)};
    }

    MappedDirection at(double s, double t) const {
        const double z = height_.fromUnit(s), phi = turn_.fromUnit(t) + longitude_;
        const double sine = std::sqrt(std::max(0.0, (1 - z) * (1 + z)));
        return {core::Vec3f(sine * std::cos(phi), sine * std::sin(phi), z), height_.slope(s) * turn_.slope(t)};
    }

private:
    LobeMap(double sine, double longitude, double z, double width)
        : longitude_(longitude),
          height_(0, 1, z, width * sine + width * width / 2),
          turn_(-std::numbers::pi, std::numbers::pi, 0, width / std::max(sine, width)) {}

    double longitude_;
    Stretch height_, turn_;
};

// By the half vector between wo and the direction, seen along the normal: a highlight whose half vectors are spread
// unevenly about the normal lies along the edges of the square. The square also holds what is below the horizon.
class HalfVectorMap {
public:
    // widths: of the half vectors, in radians, along x and y.
    HalfVectorMap(const core::Vec3f& wo, double widthX, double widthY)
        : wo_(wo), x_(-1, 1, 0, widthX), y_(-1, 1, 0, widthY) {}

    Place placeOf(const core::Vec3f& w) const {
        const glm::dvec3 h = glm::normalize(wo_ + glm::dvec3(w));
        return w.z > 0 ? Place{x_.toUnit(h.x), y_.toUnit(h.y)} : Place{-1, -1};
    }

    MappedDirection at(double s, double t) const {
        const double x = x_.fromUnit(s), y = y_.fromUnit(t), z2 = 1 - x * x - y * y;
        const glm::dvec3 h(x, y, std::sqrt(std::max(0.0, z2)));
        const double cosine = glm::dot(wo_, h);
        if (z2 <= 0 || cosine <= 0) return {core::Vec3f(0, 0, -1), 0};
        const double halfVectors = x_.slope(s) * y_.slope(t) / h.z;
        return {core::Vec3f(h * (2 * cosine) - wo_), 4 * cosine * halfVectors};
    }

private:
    glm::dvec3 wo_;
    Stretch x_, y_;
};

}  // namespace materials
