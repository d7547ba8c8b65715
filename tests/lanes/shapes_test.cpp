#include <gtest/gtest.h>

#include <algorithm>

#include "gr/mesh/triangle.h"
#include "gr/shape.h"
#include "lanes/both_widths.h"

namespace lanes {
namespace {

constexpr int count = 100'000;

template<class Real>
core::Ray<Real> rayAt(const Real* x) {
    return {vectorAt(x), vectorAt(x + 3), x[6]};
}

using RayNumbers = Numbers<7>;

RayNumbers numbersOf(const core::Rayf& ray) {
    return {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.tMax};
}

// Where rays start: all round, far off, inside, in the planes and at the corners of every shape.
core::Vec3f origin(Inputs& inputs) {
    const float size = inputs.chance(0.05) ? 1e4f : 2.f;
    core::Vec3f p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = inputs.chance(0.3) ? inputs.oneOf({0, -0.f, 1, -1, 0.5f, -0.5f, 1 + 0x1p-23f, -1e-6f, 1e-6f})
                                     : inputs.uniform(-size, size);
    return p;
}

// Half of them look at a point of [-1, 1]^3, by a direction that is not of unit length; the others anywhere, often
// along an axis or a diagonal, where no axis is the longest.
core::Rayf ray(Inputs& inputs) {
    const core::Vec3f from = origin(inputs);
    core::Vec3f direction = inputs.direction();
    if (inputs.chance(0.1)) {
        const float x = inputs.oneOf({1, -1, 0.5f}), y = inputs.oneOf({1, -1, 0}), z = inputs.oneOf({1, -1, 0});
        direction = {x, y, z};
    }
    if (inputs.chance(0.5)) {
        const core::Vec3f to = inputs.point(1);
        if (glm::length(to - from) > 1e-3f) direction = to - from;
    }
    const float tMax = inputs.chance(0.3) ? inputs.uniform(0, 2) : core::infinity;
    return {from, direction, tMax};
}

std::vector<RayNumbers> rays(std::uint64_t seed) {
    Inputs inputs(seed);
    return makeInputs<7>(count, [&] { return numbersOf(ray(inputs)); });
}

template<std::size_t m>
double shareOfHits(const std::vector<Numbers<m>>& results) {
    const auto isHit = [](const Numbers<m>& result) { return result[0] < core::infinity; };
    return static_cast<double>(std::count_if(results.begin(), results.end(), isHit)) /
           static_cast<double>(results.size());
}

// Rays that end where they hit, at the float before and at the one after.
template<std::size_t n, std::size_t m>
std::vector<Numbers<n>> endingAtTheHit(const std::vector<Numbers<n>>& rays, const std::vector<Numbers<m>>& hits) {
    std::vector<Numbers<n>> ending;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const float t = hits[i][0];
        if (t == core::infinity) continue;
        for (const float tMax : {std::nextafter(t, 0.f), t, std::nextafter(t, core::infinity)}) {
            ending.push_back(rays[i]);
            ending.back()[6] = tMax;
        }
    }
    return ending;
}

template<std::size_t n, class Formula>
void expectSameHits(const std::vector<Numbers<n>>& rays, const Formula& formula) {
    const auto hits = expectSame(rays, formula);
    EXPECT_GT(shareOfHits(hits), 0.05);
    EXPECT_LT(shareOfHits(hits), 0.95);
    // t < tMax: of each three, only the last is hit.
    const auto atTheEnd = expectSame(endingAtTheHit(rays, hits), formula);
    EXPECT_NEAR(shareOfHits(atTheEnd), 1 / 3., 1e-12);
}

// All of the list but meshes and CSG objects.
template<class>
struct TypesOf;
template<class... Shapes>
struct TypesOf<std::variant<const gr::Polyhedron*, const gr::Csg*, Shapes...>> {
    using Type = testing::Types<Shapes...>;
};

template<class Shape>
class LanesShape : public testing::Test {};
using Shapes = TypesOf<gr::Shape>::Type;
TYPED_TEST_SUITE(LanesShape, Shapes);

TYPED_TEST(LanesShape, IsHitTheSame) {
    expectSameHits(rays(10), []<class Real>(const std::array<Real, 7>& x) {
        return std::array<Real, 1>{TypeParam{}.intersect(rayAt(x.data()))};
    });
}

// A shape in each lane, as packs hold them, is hit as one shape by many rays.
TYPED_TEST(LanesShape, IsHitTheSameWhereLanesHoldShapes) {
    expectSame(rays(12), []<class Real>(const std::array<Real, 7>& x) {
        typename TypeParam::template With<Real> shapes;
        std::apply([](auto&... part) { ((part = Real(0.375f)), ...); }, shapes.parts(shapes));
        return std::array<Real, 1>{shapes.intersect(rayAt(x.data()))};
    });
}

// Which parts of a line a shape holds, as far as they are ahead; none, where it is no solid.
template<class Shape, class Real>
std::array<Real, 4> spansOf(const Shape& shape, const core::Ray<Real>& ray) {
    const Real zero(0);
    std::array<Real, 4> all{zero, zero, zero, zero};
    if constexpr (Shape::isSolid) {
        std::size_t place = 0;
        for (const gr::Interval<Real>& span : shape.spans(ray)) {
            const core::Mask<Real> isAhead = span.exists & (span.leave > zero);
            all[place++] = core::select(isAhead, core::max(span.enter, zero), Real(-1));
            all[place++] = core::select(isAhead, span.leave, Real(-1));
        }
    }
    return all;
}
TYPED_TEST(LanesShape, TellsTheSameSpans) {
    expectSame(rays(14),
               []<class Real>(const std::array<Real, 7>& x) { return spansOf(TypeParam{}, rayAt<Real>(x.data())); });
}

template<class Shape, class Real>
core::Mask<Real> isFront(const Shape& shape, const core::Ray<Real>& ray) {
    if constexpr (Shape::isSolid)
        return shape.level(ray.origin) > Real(0);
    else
        return Real(0) <= Real(0);
}

// The point of the surface, and where on it that is; of a miss nothing is said.
TYPED_TEST(LanesShape, TellsTheSameSurface) {
    expectSame(rays(13), []<class Real>(const std::array<Real, 7>& x) {
        const core::Ray<Real> ray = rayAt(x.data());
        const TypeParam shape;
        const Real t = shape.intersect(ray);
        const core::Mask<Real> isMet = t < Real(core::infinity);
        const gr::ShapePoint<Real> point =
            shape.surfaceAt(ray, core::select(isMet, t, Real(1)), core::Vec3<Real>(Real(1e-5f)), isFront(shape, ray));
        const gr::Coordinates<Real> at = shape.coordinatesAt(point);
        std::array<Real, 12> all{point.position.x, point.position.y, point.position.z,
                                 point.normal.x,   point.normal.y,   point.normal.z,
                                 at.uv.x,          at.uv.y,          at.tangent.x,
                                 at.tangent.y,     at.tangent.z,     core::select(point.front, Real(1), Real(0))};
        for (Real& number : all) number = core::select(isMet, number, Real(0));
        return all;
    });
}

// Triangles small, large and thin, some without area.
void makeTriangle(Inputs& inputs, float* x) {
    for (int i = 0; i < 9; ++i)
        x[i] = inputs.chance(0.3) ? inputs.oneOf({0, -0.f, 1, -1, 0.5f}) : inputs.uniform(-2, 2);
}

// Rays are aimed at corners, edges and the inside.
TEST(LanesTriangle, IsHitTheSame) {
    Inputs inputs(11);
    const auto raysAndTriangles = makeInputs<16>(count, [&] {
        Numbers<16> x;
        makeTriangle(inputs, &x[7]);
        core::Rayf ray = lanes::ray(inputs);
        const float b1 = inputs.unit(), b2 = inputs.unit() * (1 - b1);
        const core::Vec3f to = vectorAt(&x[7]) * (1 - b1 - b2) + vectorAt(&x[10]) * b1 + vectorAt(&x[13]) * b2;
        if (inputs.chance(0.6) && glm::length(to - ray.origin) > 1e-3f) ray.direction = to - ray.origin;
        const RayNumbers numbers = numbersOf(ray);
        std::copy(numbers.begin(), numbers.end(), x.begin());
        return x;
    });
    expectSameHits(raysAndTriangles, []<class Real>(const std::array<Real, 16>& x) {
        const gr::TriangleRay<Real> ray(rayAt(x.data()));
        const auto hit = ray.intersect(vectorAt(&x[7]), vectorAt(&x[10]), vectorAt(&x[13]));
        return std::array<Real, 3>{hit.t, hit.b1, hit.b2};
    });
}

// The same ray in every lane.
TEST(LanesTriangle, IsHitTheSameByOneRay) {
    Inputs inputs(15);
    double hits = 0;
    for (int i = 0; i < 500; ++i) {
        const gr::TriangleRay<float> ray(lanes::ray(inputs));
        const auto triangles = makeInputs<9>(200, [&] {
            Numbers<9> x;
            makeTriangle(inputs, x.data());
            return x;
        });
        const auto intersect = [&]<class Real>(const std::array<Real, 9>& x) {
            const gr::TriangleRay<Real, gr::UniformAxes> sameRay(ray);
            const auto hit = sameRay.intersect(vectorAt(&x[0]), vectorAt(&x[3]), vectorAt(&x[6]));
            return std::array<Real, 3>{hit.t, hit.b1, hit.b2};
        };
        hits += shareOfHits(expectSame(triangles, intersect)) / 500;
    }
    EXPECT_GT(hits, 0.01);
}

}  // namespace
}  // namespace lanes
