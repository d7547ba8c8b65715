// What is round about the y axis and straight along it, from y = 0 to y = 1: the maths of cylinders and cones.
#pragma once

#include "gr/shapes/surface.h"

#include <array>

namespace gr {

// The radius is 1 at the foot and 1 + slope at the top, which is not less than 0.
template<class Real>
struct Frustum {
    Real slope;

    Real radiusAt(const Real& y) const { return Real(1) + slope * y; }

    Real level(const core::Vec3<Real>& p) const {
        return core::max(sideLevel(p), core::max(Real(-p.y), Real(p.y - Real(1))));
    }

    std::array<Interval<Real>, 1> spans(const core::Ray<Real>& ray) const {
        const Interval<Real> side = alongSide(ray), caps = betweenCaps(ray);
        const Real enter = core::max(side.enter, caps.enter), leave = core::min(side.leave, caps.leave);
        // As a Box has it: a ray through the edge does not slip between side and cap.
        const core::Mask<Real> exists = side.exists & (enter <= leave * Real(1 + 4 * 0x1p-23f));
        return {{{enter, leave, exists}}};
    }

    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>& outside) const {
        const Real zero(0), one(1), half(0.5f);
        const Interval<Real> side = alongSide(ray), caps = betweenCaps(ray);
        const core::Mask<Real> entersCap = caps.enter >= side.enter, leavesCap = caps.leave <= side.leave;
        const core::Mask<Real> isCap = (outside & entersCap) | (leavesCap & !outside);

        // Keep away from the edges: on a cap also by how much narrower it gets a step further in.
        const core::Vec3<Real> hit = ray.origin + ray.direction * t;
        const Real sideways = core::sqrt(margin.x * margin.x + margin.z * margin.z),
                   upwards = core::min(margin.y, half);
        const Real cap = core::select(core::differ(ray.direction.y > zero, outside), one, zero);
        const Real widest = radiusAt(cap), steepness = core::abs(slope);
        const Real capRadius = core::max(widest - sideways - steepness * upwards, widest * half);
        const Real y =
            awayFromApex(core::min(core::max(hit.y, upwards), one - upwards), sideways + steepness * upwards);
        const Real sideRadius = radiusAt(y);
        // Seen from within, the side comes nearer sideways, by half the square of how far over the radius.
        const Real sagitta =
            core::select(outside, zero, core::min(half * sideways * sideways / sideRadius, half * sideRadius));

        const Real fromAxis = core::sqrt(hit.x * hit.x + hit.z * hit.z);
        const core::Mask<Real> isOff = fromAxis > zero;
        const Real inverse = one / core::select(isOff, fromAxis, one);
        const core::Vec3<Real> onCap(hit.x, cap, hit.z), away(hit.x * inverse, zero, hit.z * inverse);
        const Real shrunk = core::min(capRadius * inverse, one);
        core::Vec3<Real> onSide = away * (sideRadius - sagitta);
        onSide.y = y;
        // The side's normal leans up where it becomes narrower. At the very apex it is the axis.
        const core::Vec3<Real> leaning(away.x, -slope, away.z);
        return {core::select(isCap, core::Vec3<Real>(onCap.x * shrunk, cap, onCap.z * shrunk), onSide),
                core::select(isCap, core::Vec3<Real>(zero, cap + cap - one, zero), leaning), outside};
    }

    // Of the side the longitude, and v as high as it goes; on a cap the square round it.
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        const core::Vec3<Real>& p = point.position;
        const core::Mask<Real> isCap = core::abs(point.normal.x) + core::abs(point.normal.z) <= Real(0);
        const Coordinates<Real> flat = flatCoordinates<Real>(p, point.normal);
        const Real scale = Real(0.5f) / core::max(radiusAt(p.y), Real(0x1p-100f));
        return {{core::select(isCap, Real(0.5f) + flat.uv.x * scale, longitudeOf<Real>(p)),
                 core::select(isCap, Real(0.5f) + flat.uv.y * scale, p.y)},
                core::select(isCap, flat.tangent, eastOf<Real>(core::Vec3<Real>(p.x, Real(0), p.z)))};
    }

private:
    Real sideLevel(const core::Vec3<Real>& p) const {
        const Real radius = radiusAt(p.y);
        return (p.x * p.x + p.z * p.z) - radius * radius;
    }

    // Where a line is inside of the side, if that went on for ever. a t^2 - 2 b t + c <= 0, in the way Sphere does it:
    // the roots without cancellation, so that the sign of c tells the sides apart, and the discriminant, which is the
    // same whatever point of the line t counts from, from a point that is near.
    Interval<Real> alongSide(const core::Ray<Real>& ray) const {
        using core::select;
        const core::Vec3<Real>&o = ray.origin, &d = ray.direction;
        const Real zero(0), none(core::infinity), widening = slope * d.y;
        const Real a = (d.x * d.x + d.z * d.z) - widening * widening;
        const Real b = widening * radiusAt(o.y) - (o.x * d.x + o.z * d.z);
        const Real c = sideLevel(o);

        const Real toNear = glm::dot(core::Vec3<Real>(zero, Real(0.5f), zero) - o, d) / glm::dot(d, d);
        const core::Vec3<Real> near = o + d * toNear;
        const Real nearB = widening * radiusAt(near.y) - (near.x * d.x + near.z * d.z);
        const Real discriminant = nearB * nearB - a * sideLevel(near);

        const Real root = core::sqrt(core::max(discriminant, zero));
        const Real q = b + select(b < zero, -root, root);
        const Real t1 = c / q, t2 = q / a;
        const Real first = core::min(t1, t2), last = core::max(t1, t2);
        // A line steeper than the side is in both of its nappes: that where the radius is positive counts.
        const core::Mask<Real> isSteep = a<zero, isLast = widening> zero;
        // One along the axis of a cylinder is inside all the way, or nowhere.
        const core::Mask<Real> isParallel = (a == zero) & (b == zero), isWithin = c <= zero;
        const Real enter = select(isSteep, select(isLast, last, -none), first);
        const Real leave = select(isSteep, select(isLast, none, first), last);
        const core::Mask<Real> isThrough = isSteep | (discriminant >= zero);
        const core::Mask<Real> exists = (isParallel & isWithin) | (isThrough & !isParallel);
        return {select(isParallel, -none, enter), select(isParallel, none, leave), exists};
    }

    Interval<Real> betweenCaps(const core::Ray<Real>& ray) const {
        const Real inverse = Real(1) / ray.direction.y;
        const Real t0 = -ray.origin.y * inverse, t1 = (Real(1) - ray.origin.y) * inverse;
        const core::Mask<Real> upwards = inverse > Real(0);
        const Real enter = core::max(core::select(upwards, t0, t1), Real(-core::infinity));
        return {enter, core::min(core::select(upwards, t1, t0), Real(core::infinity)), enter < Real(core::infinity)};
    }

    // Where the radius is so small that a step inwards would come out on the other side, y is moved to where it is not.
    Real awayFromApex(const Real& y, const Real& step) const {
        const Real least = core::min(Real(4) * step, Real(0.5f));
        const core::Mask<Real> isNarrow = (slope < Real(0)) & (radiusAt(y) < least);
        return core::select(isNarrow, (least - Real(1)) / core::select(isNarrow, slope, Real(1)), y);
    }
};

}  // namespace gr
