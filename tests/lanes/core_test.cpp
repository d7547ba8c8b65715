#include <gtest/gtest.h>

#include <cmath>

#include "core/elementary.h"
#include "core/frame.h"
#include "core/transform.h"
#include "core/warp.h"
#include "lanes/both_widths.h"

namespace lanes {
namespace {

constexpr int count = 50'000;

TEST(LanesWarp, HasTheSameSinesAndCosines) {
    Inputs inputs(3);
    expectSame(makeInputs<1>(count, [&] { return Numbers<1>{inputs.unit()}; }),
               []<class Real>(const std::array<Real, 1>& turns) {
                   const core::SinCos<Real> result = core::sinCosTurns(turns[0]);
                   return std::array<Real, 2>{result.sin, result.cos};
               });
}

TEST(LanesWarp, HasTheSameHemispheres) {
    Inputs inputs(4);
    const auto points = makeInputs<2>(count, [&] {
        const float u = inputs.unit(), v = inputs.unit();
        return Numbers<2>{u, v};
    });
    expectSame(points, []<class Real>(const std::array<Real, 2>& u) {
        const core::Vec2<Real> place(u[0], u[1]);
        const core::Vec3<Real> d = core::squareToUniformHemisphere(place), e = core::squareToCosineHemisphere(place);
        return std::array<Real, 8>{d.x, d.y, d.z, core::uniformHemispherePdfW(d),
                                   e.x, e.y, e.z, core::cosineHemispherePdfW(e)};
    });
}

TEST(LanesWarp, HasTheSameDiscAndCone) {
    Inputs inputs(19);
    const auto points = makeInputs<3>(count, [&] {
        const float u = inputs.unit(), v = inputs.unit();
        return Numbers<3>{u, v, inputs.oneOf({1, 0.3f, 0.0038f, 1.5e-10f, 2})};
    });
    expectSame(points, []<class Real>(const std::array<Real, 3>& u) {
        const core::Vec2<Real> place(u[0], u[1]), disc = core::squareToUniformDisc(place);
        const core::Vec3<Real> d = core::squareToUniformCone(place, u[2]), axis(Real(0), Real(0), Real(1));
        return std::array<Real, 8>{
            disc.x, disc.y, core::uniformDiscPdfA(disc),          d.x,
            d.y,    d.z,    core::uniformConePdfW(axis, d, u[2]), core::uniformConePdfW(axis, d, u[2] * Real(0.5f))};
    });
}

TEST(LanesWarp, HasTheSamePdfs) {
    Inputs inputs(5);
    const auto numbers = makeInputs<3>(count, [&] {
        const float a = inputs.any(), b = inputs.any(), c = inputs.any();
        return Numbers<3>{a, b, c};
    });
    expectSame(numbers, []<class Real>(const std::array<Real, 3>& x) {
        return std::array<Real, 2>{core::uniformHemispherePdfW(vectorAt(x.data())), core::pdfAtoW(x[0], x[1], x[2])};
    });
}

TEST(LanesFrame, IsTheSame) {
    Inputs inputs(6);
    const auto vectors = makeInputs<6>(count, [&] {
        const core::Vec3f normal =
            inputs.chance(0.05) ? core::Vec3f(0, -0.f, inputs.oneOf({1, -1})) : inputs.direction();
        const core::Vec3f v = inputs.point(2);
        return Numbers<6>{normal.x, normal.y, normal.z, v.x, v.y, v.z};
    });
    expectSame(vectors, []<class Real>(const std::array<Real, 6>& x) {
        const core::Frame<Real> frame(vectorAt(x.data()));
        const core::Vec3<Real> local = frame.toLocal(vectorAt(x.data() + 3));
        const core::Vec3<Real> world = frame.toWorld(vectorAt(x.data() + 3));
        return std::array<Real, 15>{frame.x.x, frame.x.y, frame.x.z, frame.y.x, frame.y.y,
                                    frame.y.z, frame.z.x, frame.z.y, frame.z.z, local.x,
                                    local.y,   local.z,   world.x,   world.y,   world.z};
    });
}

TEST(LanesFrame, IsTheSameWithATangent) {
    Inputs inputs(17);
    const auto vectors = makeInputs<6>(count, [&] {
        const core::Vec3f normal = inputs.direction(), tangent = inputs.point(3);
        return Numbers<6>{normal.x, normal.y, normal.z, tangent.x, tangent.y, tangent.z};
    });
    expectSame(vectors, []<class Real>(const std::array<Real, 6>& x) {
        const core::Frame<Real> frame(vectorAt(x.data()), vectorAt(x.data() + 3));
        return std::array<Real, 9>{frame.x.x, frame.x.y, frame.x.z, frame.y.x, frame.y.y,
                                   frame.y.z, frame.z.x, frame.z.y, frame.z.z};
    });
}

// Every size, both sides of where the logarithm's mantissa turns, and the ends of the exponential's range.
TEST(LanesElementary, CalculatesTheSame) {
    Inputs inputs(18);
    const auto numbers = makeInputs<2>(count, [&] {
        const float whole = std::trunc(inputs.uniform(-126, 128)), mantissa = inputs.uniform(1, 2);
        const float turning = inputs.oneOf({0.70710671f, 0.70710677f, 0.70710683f, 1, 0.99999994f});
        const float ends = inputs.oneOf({0, -0.f, -87, -87.000008f, -86.99999f, 88, -1e30f, -core::infinity, 1e-30f});
        return Numbers<2>{std::ldexp(inputs.chance(0.2) ? turning : mantissa, static_cast<int>(whole)),
                          inputs.chance(0.1) ? ends : inputs.uniform(-90, 88)};
    });
    expectSame(numbers, []<class Real>(const std::array<Real, 2>& x) {
        return std::array<Real, 4>{core::log(x[0]), core::exp(x[1]), core::expm1(x[1]), core::atan2<Real>(x[1], x[0])};
    });
}

TEST(LanesTransform, MovesTheSame) {
    Inputs inputs(7);
    for (int i = 0; i < 20; ++i) {
        glm::dmat4 m(1);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) m[column][row] = inputs.chance(0.2) ? 0 : inputs.uniform(-3, 3);
        const core::Transform transform = i == 0 ? core::Transform() : core::Transform(m);
        const auto vectors = makeInputs<3>(count / 20, [&] {
            const float x = inputs.any(), y = inputs.any(), z = inputs.any();
            return Numbers<3>{x, y, z};
        });
        expectSame(vectors, [&]<class Real>(const std::array<Real, 3>& x) {
            const core::Vec3<Real> v = vectorAt(x.data());
            const core::Vec3<Real> point = transform.point(v);
            const core::Vec3<Real> vector = transform.vector(v);
            const core::Vec3<Real> transposed = transform.transposed(v);
            return std::array<Real, 9>{point.x,  point.y,      point.z,      vector.x,    vector.y,
                                       vector.z, transposed.x, transposed.y, transposed.z};
        });
    }
}

// Another map in each lane.
TEST(LanesTransform, MovesTheSameByAMapOfItsOwn) {
    Inputs inputs(14);
    const auto mapsAndVectors = makeInputs<15>(count, [&] {
        Numbers<15> x;
        for (float& number : x) number = inputs.any();
        return x;
    });
    expectSame(mapsAndVectors, []<class Real>(const std::array<Real, 15>& x) {
        core::AffineMap<Real> map;
        map.x = vectorAt(&x[0]);
        map.y = vectorAt(&x[3]);
        map.z = vectorAt(&x[6]);
        map.translation = vectorAt(&x[9]);
        const core::Vec3<Real> v = vectorAt(&x[12]);
        const core::Vec3<Real> point = map.point(v), vector = map.vector(v), transposed = map.transposed(v);
        return std::array<Real, 9>{point.x,  point.y,      point.z,      vector.x,    vector.y,
                                   vector.z, transposed.x, transposed.y, transposed.z};
    });
}

}  // namespace
}  // namespace lanes
