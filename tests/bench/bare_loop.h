// The floor that integrators are measured against: a path tracer for one Cornell box of quads, with nothing in it but
// the loop. Templated over Real like the renderer's maths: float, or as many paths side by side as there are lanes.
#pragma once

#include "core/frame.h"
#include "core/ray.h"
#include "core/warp.h"

#include <array>
#include <cstdint>

namespace bench {

using core::Mask;
using core::Vec3;
using core::Vec3f;

struct Quad {
    Vec3f corner, normal, toU, toV;  // toU, toV: what a point's distance from the corner is multiplied with for u, v
    Vec3f colour;

    Quad(const Vec3f& corner, const Vec3f& e0, const Vec3f& e1, const Vec3f& colour) : corner(corner), colour(colour) {
        const Vec3f n = glm::cross(e0, e1);
        normal = glm::normalize(n);
        toU = glm::cross(e1, n) / glm::dot(n, n);
        toV = glm::cross(n, e0) / glm::dot(n, n);
    }
};

inline const std::array<Quad, 16>& cornellQuads() {
    static const Vec3f white(0.73f), red(0.65f, 0.05f, 0.05f), green(0.12f, 0.45f, 0.15f);
    // A block's four sides from the corners of its footprint, and its top.
    const auto side = [](const Vec3f& a, const Vec3f& b, float height) {
        return Quad(a, b - a, {0, height, 0}, white);
    };
    const auto top = [](Vec3f a, Vec3f b, Vec3f d, float height) {
        const Vec3f up(0, height, 0);
        return Quad(a + up, b - a, d - a, white);
    };
    static const Vec3f s[] = {{130, 0, 65}, {290, 0, 113}, {242, 0, 273}, {82, 0, 225}};
    static const Vec3f t[] = {{423, 0, 247}, {471, 0, 407}, {311, 0, 455}, {263, 0, 295}};
    static const std::array<Quad, 16> quads{
        Quad({213, 554, 227}, {130, 0, 0}, {0, 0, 105}, Vec3f(0)),  // the light comes first
        Quad({0, 0, 0}, {0, 0, 555}, {555, 0, 0}, white),
        Quad({0, 555, 0}, {555, 0, 0}, {0, 0, 555}, white),
        Quad({0, 0, 555}, {0, 555, 0}, {555, 0, 0}, white),
        Quad({0, 0, 0}, {0, 555, 0}, {0, 0, 555}, green),
        Quad({555, 0, 0}, {0, 0, 555}, {0, 555, 0}, red),
        side(s[0], s[1], 165),
        side(s[1], s[2], 165),
        side(s[2], s[3], 165),
        side(s[3], s[0], 165),
        top(s[0], s[1], s[3], 165),
        side(t[0], t[1], 330),
        side(t[1], t[2], 330),
        side(t[2], t[3], 330),
        side(t[3], t[0], 330),
        top(t[0], t[1], t[3], 330)};
    return quads;
}

// Plain random numbers, a stream a lane (Marsaglia's xorshift).
template<class Real>
class Random {
public:
    explicit Random(std::uint32_t seed) {
        for (std::uint32_t& state : states_) state = seed = seed * 747796405u + 2891336453u;
    }
    Real next() {
        alignas(64) float u[lanes];
        for (int i = 0; i < lanes; ++i) {
            std::uint32_t& s = states_[static_cast<std::size_t>(i)];
            s ^= s << 13;
            s ^= s >> 17;
            s ^= s << 5;
            u[i] = static_cast<float>(s >> 8) * 0x1p-24f;
        }
        if constexpr (lanes == 1)
            return u[0];
        else
            return Real::load_aligned(u);
    }

private:
    static constexpr int lanes = core::RealTraits<Real>::lanes;
    std::array<std::uint32_t, static_cast<std::size_t>(lanes)> states_;
};

template<class Real>
Real intersectQuad(const Quad& quad, const core::Ray<Real>& ray) {
    const Vec3<Real> n = core::broadcast<Real>(quad.normal);
    const Vec3<Real> fromCorner = ray.origin - core::broadcast<Real>(quad.corner);
    const Real t = -glm::dot(n, fromCorner) / glm::dot(n, ray.direction);
    const Vec3<Real> p = fromCorner + ray.direction * t;
    const Real u = glm::dot(p, core::broadcast<Real>(quad.toU));
    const Real v = glm::dot(p, core::broadcast<Real>(quad.toV));
    const Mask<Real> hits =
        (t > Real(1e-3f)) & (t < ray.tMax) & (u >= Real(0)) & (u <= Real(1)) & (v >= Real(0)) & (v <= Real(1));
    return core::select(hits, t, Real(core::infinity));
}

inline std::array<float, 1> lanesOf(float x) {
    return {x};
}
template<class Arch>
auto lanesOf(const xsimd::batch<float, Arch>& x) {
    std::array<float, xsimd::batch<float, Arch>::size> lanes;
    x.store_unaligned(lanes.data());
    return lanes;
}

template<class Real>
std::uint64_t count(const Mask<Real>& mask) {
    float lanes = 0;
    for (const float one : lanesOf(core::select(mask, Real(1), Real(0)))) lanes += one;
    return static_cast<std::uint64_t>(lanes);
}

struct LoopResult {
    Vec3f mean{0};
    std::uint64_t rays = 0;
};

// Traces `paths` times as many paths as Real has lanes, each of at most 6 surface points.
template<class Real>
LoopResult bareLoop(int paths, std::uint32_t seed) {
    const auto& quads = cornellQuads();
    const Vec3<Real> eye(Real(278), Real(278), Real(-800));
    const Vec3<Real> lightNormal(Real(0), Real(-1), Real(0));
    const Vec3<Real> emitted(Real(17), Real(12), Real(4));
    Random<Real> random(seed);
    Vec3<Real> sum(Real(0));
    LoopResult result;
    for (int path = 0; path < paths; ++path) {
        const Real px = random.next(), py = random.next();
        const Real halfView(0.3443276f);  // tan(19 degrees)
        core::Ray<Real> ray{
            eye, glm::normalize(Vec3<Real>((Real(1) - px - px) * halfView, (Real(1) - py - py) * halfView, Real(1)))};
        Vec3<Real> throughput(Real(1));
        Mask<Real> alive = Real(0) < Real(1);
        for (int points = 1; points <= 6 && core::any(alive); ++points) {
            // The nearest quad, its normal and colour.
            result.rays += count<Real>(alive);
            Real nearest(core::infinity);
            Vec3<Real> normal(Real(0)), colour(Real(0));
            Mask<Real> isLight = Real(1) < Real(0);
            for (std::size_t i = 0; i < quads.size(); ++i) {
                const Real t = intersectQuad(quads[i], ray);
                const Mask<Real> nearer = t < nearest;
                nearest = core::select(nearer, t, nearest);
                normal = core::select(nearer, core::broadcast<Real>(quads[i].normal), normal);
                colour = core::select(nearer, core::broadcast<Real>(quads[i].colour), colour);
                if (i == 0)
                    isLight = nearer;
                else
                    isLight = isLight & !nearer;
            }
            const Mask<Real> facesLight = isLight & (glm::dot(ray.direction, lightNormal) < Real(0));
            if (points == 1) sum += core::select(alive & facesLight, throughput * emitted, Vec3<Real>(Real(0)));
            alive = alive & (nearest < Real(core::infinity)) & !isLight;
            const Vec3<Real> p = ray.origin + ray.direction * core::select(alive, nearest, Real(0));
            normal = core::select(glm::dot(normal, ray.direction) > Real(0), -normal, normal);

            // Light, from a place uniform on it.
            const Real lu = random.next(), lv = random.next();
            const Vec3<Real> toLight =
                Vec3<Real>(Real(213) + Real(130) * lu, Real(554), Real(227) + Real(105) * lv) - p;
            const Real distance2 = glm::dot(toLight, toLight);
            const Vec3<Real> wi = toLight / core::sqrt(distance2);
            const Real cosines = glm::dot(wi, normal) * wi.y;
            const Mask<Real> lit = alive & (glm::dot(wi, normal) > Real(0)) & (wi.y > Real(0));
            result.rays += count<Real>(lit);
            const core::Ray<Real> shadow{p, toLight, Real(0.9999f)};
            Mask<Real> blocked = !lit;
            for (std::size_t i = 1; i < quads.size() && !core::all(blocked); ++i)
                blocked = blocked | (intersectQuad(quads[i], shadow) < Real(core::infinity));
            const Real geometry = cosines / distance2 * Real(130.f * 105.f / core::pi);
            sum += core::select(!blocked, throughput * colour * emitted * geometry, Vec3<Real>(Real(0)));

            // Go on, uniformly over the hemisphere.
            const Real du = random.next(), dv = random.next();
            const Vec3<Real> local = core::squareToUniformHemisphere(core::Vec2<Real>(du, dv));
            throughput *= colour * (local.z + local.z);
            ray = {p, core::Frame<Real>(normal).toWorld(local)};
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        float total = 0;
        for (const float lane : lanesOf(sum[axis])) total += lane;
        result.mean[axis] = total / static_cast<float>(paths * core::RealTraits<Real>::lanes);
    }
    return result;
}

}  // namespace bench
