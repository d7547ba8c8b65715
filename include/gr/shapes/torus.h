#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/shape_node.h"
#include "gr/shapes/surface.h"

#include <array>
#include <tuple>

namespace gr {

// A ring of radius 1 round the y axis, made of a tube.
template<class Number>
struct TorusOf {
    template<class Other>
    using With = TorusOf<Other>;
    static constexpr bool isSolid = true, isEndless = false, isAxisFaced = false;

    Number tube = Number(0.25f);  // its radius, less than 1

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.tube);
    }

    template<class Real>
    Real level(const core::Vec3<Real>& p) const {
        const Real fromRing = core::sqrt(p.x * p.x + p.z * p.z) - Real(1), radius(tube);
        return fromRing * fromRing + p.y * p.y - radius * radius;
    }

    // Along a line the surface is where a quartic is 0. Between two of its turning points there is one root or none,
    // which the signs of level() at both tell. The first such piece of the ray is searched.
    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        using core::select;
        const Pieces<Real> pieces(*this, ray);
        if (!core::any(pieces.isNear)) return Real(core::infinity);
        const core::Mask<Real> isOutside = pieces.isOutside[0];
        core::Mask<Real> meets = !isOutside;
        Real from = pieces.place[3], to = pieces.place[4];
        for (int i = 3; i >= 1; --i) {
            const core::Mask<Real> isBeyond = core::differ(pieces.isOutside[i], isOutside);
            from = select(isBeyond, pieces.place[i - 1], from);
            to = select(isBeyond, pieces.place[i], to);
            meets = meets | isBeyond;
        }
        meets = meets & pieces.isNear;
        if (!core::any(meets)) return Real(core::infinity);
        const Real t = crossing(ray, from, to, isOutside, meets);
        return select(meets & (t < ray.tMax), t, Real(core::infinity));
    }

    // A root in each piece at whose ends the signs differ. From outside the first two bound a part of the line, and so
    // do the next two; from inside the first one ends one that began before.
    template<class Real>
    std::array<Interval<Real>, 2> spans(const core::Ray<Real>& ray) const {
        using core::select;
        const Real never(core::infinity), none(-1);
        const core::Mask<Real> no = Real(0) > Real(0);
        std::array<Interval<Real>, 2> spans{{{none, never, no}, {none, never, no}}};
        const Pieces<Real> pieces(*this, ray);
        if (!core::any(pieces.isNear)) return spans;
        // Which end the next root is: of the first part its beginning, its end, and so on.
        Real end = select(pieces.isOutside[0], Real(0), Real(1));
        spans[0].exists = pieces.isNear & !pieces.isOutside[0];
        for (int i = 1; i <= 4; ++i) {
            const core::Mask<Real> isRoot = pieces.isNear & core::differ(pieces.isOutside[i], pieces.isOutside[i - 1]);
            if (!core::any(isRoot)) continue;
            const Real t = crossing(ray, pieces.place[i - 1], pieces.place[i], pieces.isOutside[i - 1], isRoot);
            for (int k = 0; k < 2; ++k) {
                const core::Mask<Real> begins = isRoot & (end == Real(static_cast<float>(2 * k)));
                const core::Mask<Real> ends = isRoot & (end == Real(static_cast<float>(2 * k + 1)));
                spans[k].enter = select(begins, t, spans[k].enter);
                spans[k].exists = spans[k].exists | begins;
                spans[k].leave = select(ends, t, spans[k].leave);
            }
            end = select(isRoot, end + Real(1), end);
        }
        return spans;
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>& front) const {
        const core::Vec3<Real> hit = ray.origin + ray.direction * t;
        const Real radius(tube), inverse = Real(1) / core::sqrt(hit.x * hit.x + hit.z * hit.z);
        const core::Vec3<Real> ring(hit.x * inverse, Real(0), hit.z * inverse);
        const core::Vec3<Real> normal = glm::normalize(hit - ring);
        // It comes nearer sideways by half the square of how far over the radius: from within the tube's, and from
        // outside that of the hole.
        const Real narrowest = core::select(front, Real(1) - radius, radius);
        const Real sagitta = core::min(Real(0.5f) * glm::dot(margin, margin) / narrowest, Real(0.5f) * narrowest);
        return {ring + normal * (radius + core::select(front, sagitta, -sagitta)), normal, front};
    }

    // Round the tube v begins at the hole, and goes down first.
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        const core::Vec3<Real>&p = point.position, &n = point.normal;
        const Real fromAxis = core::sqrt(p.x * p.x + p.z * p.z);
        const Real outwards = (n.x * p.x + n.z * p.z) / fromAxis;
        const Real v = Real(0.5f) + core::atan2<Real>(n.y, outwards) * Real(0.5f / core::pi);
        return {{longitudeOf(p), v}, eastOf<Real>({p.x, Real(0), p.z})};
    }

    std::vector<FlatSide> flatSides() const { return {}; }
    core::Bounds bounds() const { return {{-outer(), -tube, -outer()}, {outer(), tube, outer()}}; }
    // The ring, and a ball of the tube's radius at each of its points.
    core::Vec3f reachUnder(const core::Transform& map) const {
        const core::Vec3f ring = map.x * map.x + map.z * map.z;
        return glm::sqrt(ring) + glm::sqrt(ring + map.y * map.y) * tube;
    }

private:
    float outer() const { return 1 + tube; }

    // A ray cut where its quartic turns.
    template<class Real>
    struct Pieces {
        std::array<Real, 5> place;  // its start, the three turning points, and where it is outside for good
        std::array<core::Mask<Real>, 5> isOutside;  // there
        core::Mask<Real> isNear;  // whether it comes near; if none does, the rest says nothing

        Pieces(const TorusOf& torus, const core::Ray<Real>& ray) {
            const Real zero(0), outer = Real(1) + Real(torus.tube);
            const Real square = glm::dot(ray.direction, ray.direction), inverse = Real(1) / core::sqrt(square);
            const Real toNear = -glm::dot(ray.origin, ray.direction) / square;
            const core::Vec3<Real> near = ray.origin + ray.direction * toNear;
            const Real past = outer * outer - glm::dot(near, near);
            isNear = past >= zero;
            if (!core::any(isNear)) return;
            // A little beyond the ball that holds the torus.
            const Real half = core::sqrt(core::max(past, zero)) + Real(0x1p-8f);
            const Real end = core::max(toNear + half * inverse, zero);
            const std::array<Real, 3> turns = torus.turningPoints<Real>(near, ray.direction * inverse, half);
            place = {zero, zero, zero, zero, end};
            for (int i = 0; i < 3; ++i) place[i + 1] = core::min(core::max(toNear + turns[i] * inverse, zero), end);
            isOutside[0] = torus.level(ray.origin) > zero;
            for (int i = 1; i <= 3; ++i) isOutside[i] = torus.level<Real>(ray.origin + ray.direction * place[i]) > zero;
            isOutside[4] = zero <= zero;
        }
    };

    // Of the quartic T^4 + 2 (k - 2 (1 - v^2)) T^2 + 8 h v T + ..., where T counts from the line's point nearest to the
    // centre, h is its height, v how much the line rises, and k = nearest^2 + 1 - tube^2: the roots of T^3 + A T + B,
    // smallest first. Those beyond `half` are moved there; of one that is not real another stands in its place.
    template<class Real>
    std::array<Real, 3> turningPoints(const core::Vec3<Real>& near, const core::Vec3<Real>& direction,
                                      const Real& half) const {
        const Real zero(0), radius(tube), rise = direction.y;
        const Real a = (glm::dot(near, near) + Real(1) - radius * radius) - Real(2) * (Real(1) - rise * rise);
        const Real b = Real(2) * near.y * rise;
        // The root farthest from 0 lies on the side that b is not on. From beyond it Newton's steps never pass it.
        const Real size = core::abs(b);
        Real farthest = half;
        for (int step = 0; step < 12; ++step) {
            const Real square = farthest * farthest;
            const Real value = farthest * (square + a) - size, slope = Real(3) * square + a;
            const core::Mask<Real> isBeyond = (value > zero) & (slope > zero);
            farthest = core::select(isBeyond, farthest - value / core::select(isBeyond, slope, Real(1)), farthest);
        }
        const Real one = core::select(b > zero, -farthest, farthest);
        // Divided by it, a quadratic is left.
        const Real discriminant = -(Real(3) * one * one + Real(4) * a);
        const Real root = core::sqrt(core::max(discriminant, zero));
        const core::Mask<Real> isReal = discriminant >= zero;
        const Real lower = core::select(isReal, Real(-0.5f) * (one + root), one);
        const Real upper = core::select(isReal, Real(-0.5f) * (one - root), one);
        return {core::min(one, lower), core::max(lower, core::min(one, upper)), core::max(one, upper)};
    }

    // Where the ray crosses the surface between `from`, where it is where it starts, and `to`, where it is beyond:
    // Newton's steps, or halves where these lead astray. A lane that has it waits for the others.
    template<class Real>
    Real crossing(const core::Ray<Real>& ray, Real from, Real to, const core::Mask<Real>& startsOutside,
                  core::Mask<Real> searches) const {
        constexpr int mostSteps = 40;
        const Real half(0.5f);
        Real t = (from + to) * half;
        for (int step = 0; step < mostSteps && core::any(searches); ++step) {
            const core::Vec3<Real> p = ray.origin + ray.direction * t;
            const Real fromAxis = core::sqrt(p.x * p.x + p.z * p.z), value = level(p);
            const Real outwards = (p.x * ray.direction.x + p.z * ray.direction.z) / fromAxis;
            const Real slope = Real(2) * ((fromAxis - Real(1)) * outwards + p.y * ray.direction.y);
            const core::Mask<Real> isBeyond = core::differ(value > Real(0), startsOutside);
            from = core::select(isBeyond, from, t);
            to = core::select(isBeyond, t, to);
            const Real newton = t - value / slope, middle = (from + to) * half;
            const Real next = core::select((newton > from) & (newton < to), newton, middle);
            const core::Mask<Real> isThere = core::abs(next - t) <= t * Real(0x1p-23f);
            t = core::select(searches, next, t);
            searches = searches & !isThere;
        }
        // Never 0, which would be no hit: of a ray that starts inside there is one.
        return core::max(t, Real(0x1p-100f));
    }
};
using Torus = TorusOf<float>;

struct TorusNode {
    static constexpr core::Word kind = "torus", plural = "tori";

    glm::dvec3 centre{0};
    double radius = 1;  // of the ring
    double tube = 0.25;  // its radius, less than the ring's

    Torus shape() const { return {static_cast<float>(tube / radius)}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const { return shapePlace(around, centre, glm::dvec3(radius)); }
    std::string text() const { return nodeText(centre, radius, tube); }
};

}  // namespace gr
