// What is a template over Real, at the width that this program is compiled for and at float.
#include "bare_loop.h"
#include "gr/light.h"
#include "gr/mesh/triangle.h"
#include "gr/shape.h"
#include "materials/material.h"

#include <benchmark/benchmark.h>

namespace {

using bench::Random;
using core::Lanes;
using core::Vec3;

// Rays that start round the unit cube and go through it.
template<class Real>
std::vector<core::Ray<Real>> makeRays() {
    Random<Real> random(1);
    const auto coordinate = [&] { return random.next() * Real(4) - Real(2); };
    std::vector<core::Ray<Real>> rays;
    for (int i = 0; i < 1024; ++i) {
        Vec3<Real> from, to;
        for (int axis = 0; axis < 3; ++axis) {
            from[axis] = coordinate();
            to[axis] = random.next();
        }
        rays.push_back({from, to - from});
    }
    return rays;
}

// Reports the time for one lane: cpu_time / (items per iteration).
template<class Real>
void perItem(benchmark::State& state, int perIteration = 1024) {
    const double items = perIteration * core::RealTraits<Real>::lanes;
    state.counters["per_item"] =
        benchmark::Counter(items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template<class Real, class Shape>
void intersect(benchmark::State& state) {
    const auto rays = makeRays<Real>();
    const Shape shape{};
    for (auto _ : state)
        for (const auto& ray : rays) benchmark::DoNotOptimize(shape.intersect(ray));
    perItem<Real>(state);
}

template<class Real>
void intersectTriangle(benchmark::State& state) {
    std::vector<gr::TriangleRay<Real>> rays;
    for (const auto& ray : makeRays<Real>()) rays.emplace_back(ray);
    const Vec3<Real> a(Real(0)), b(Real(1), Real(0), Real(0)), c(Real(0), Real(1), Real(1));
    for (auto _ : state)
        for (const auto& ray : rays) benchmark::DoNotOptimize(ray.intersect(a, b, c));
    perItem<Real>(state);
}

template<class Real>
void intersectBareQuad(benchmark::State& state) {
    const auto rays = makeRays<Real>();
    const bench::Quad quad({0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, 0, 0});
    for (auto _ : state)
        for (const auto& ray : rays) benchmark::DoNotOptimize(bench::intersectQuad(quad, ray));
    perItem<Real>(state);
}

template<class Real>
void sampleLight(benchmark::State& state) {
    const auto rays = makeRays<Real>();
    const gr::AreaLight light{{0, 4, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, core::Rgbf(1), 1, 0, 0};
    const auto lanes = gr::broadcast<Real>(light);
    for (auto _ : state)
        for (const auto& ray : rays)
            benchmark::DoNotOptimize(lanes.sample(ray.origin, core::Vec2<Real>(ray.direction.x, ray.direction.y)));
    perItem<Real>(state);
}

// Where a path comes from and goes on to, above the surface; half of the latter are near the mirror's direction.
template<class Real>
struct Directions {
    Vec3<Real> wo, wi;
    materials::BsdfDraw<Real> draw;
    Real indexBeyond;
};

// As many for each width, so that both have as much to read; enough that no branch is learnt by heart.
constexpr int directionCount = 4096;

template<class Real>
std::vector<Directions<Real>> makeDirections() {
    Random<Real> random(2);
    std::vector<Directions<Real>> all;
    for (int i = 0; i < directionCount / core::RealTraits<Real>::lanes; ++i) {
        const auto place = [&] {
            const Real u = random.next();
            return core::Vec2<Real>(u, random.next());
        };
        const auto above = [&] { return core::squareToUniformHemisphere(place()); };
        const Vec3<Real> wo = above(), anywhere = above(), nearby = materials::mirrored(wo) + above() * Real(0.2f);
        const Vec3<Real> wi = core::select(random.next() < Real(0.5f), glm::normalize(nearby), anywhere);
        const Real method = random.next();
        const Real indexBeyond = core::select(random.next() < Real(0.5f), Real(1.5f), Real(1 / 1.5f));
        all.push_back({wo, wi, {method, place()}, indexBeyond});
    }
    return all;
}

template<class Real, class Material>
void sampleMaterial(benchmark::State& state) {
    const auto directions = makeDirections<Real>();
    const auto bsdf = Material{}.template at<Real>(materials::SomePoint{});
    for (auto _ : state)
        for (const auto& d : directions) benchmark::DoNotOptimize(bsdf.sample(d.wo, d.draw, d.indexBeyond));
    perItem<Real>(state, static_cast<int>(directions.size()));
}

template<class Real, class Material>
void evalMaterial(benchmark::State& state) {
    const auto directions = makeDirections<Real>();
    const auto bsdf = Material{}.template at<Real>(materials::SomePoint{});
    for (auto _ : state)
        for (const auto& d : directions) {
            benchmark::DoNotOptimize(bsdf.eval(d.wo, d.wi));
            benchmark::DoNotOptimize(bsdf.pdfW(d.wo, d.wi));
        }
    perItem<Real>(state, static_cast<int>(directions.size()));
}

template<class Real>
void cornellBareLoop(benchmark::State& state) {
    std::uint64_t rays = 0;
    std::uint32_t seed = 1;
    for (auto _ : state) {
        const bench::LoopResult result = bench::bareLoop<Real>(4096, seed++);
        benchmark::DoNotOptimize(result.mean);
        rays += result.rays;
    }
    state.counters["Mrays/s"] = benchmark::Counter(static_cast<double>(rays) * 1e-6, benchmark::Counter::kIsRate);
}

template<class Real>
void registerAll(const std::string& width) {
    const auto add = [&](const std::string& name, void (*function)(benchmark::State&)) {
        benchmark::RegisterBenchmark((name + "/" + width).c_str(), function);
    };
    add("cornell/bare_loop", cornellBareLoop<Real>);
    add("intersect/sphere", intersect<Real, gr::Sphere>);
    add("intersect/box", intersect<Real, gr::Box>);
    add("intersect/square", intersect<Real, gr::Square>);
    add("intersect/triangle", intersectTriangle<Real>);
    add("intersect/bare_quad", intersectBareQuad<Real>);
    add("light/area/sample", sampleLight<Real>);
    materials::forEachMaterialType([&]<class M>() {
        add("material/" + std::string(M::typeName) + "/sample", sampleMaterial<Real, M>);
        add("material/" + std::string(M::typeName) + "/eval+pdf", evalMaterial<Real, M>);
    });
}

}  // namespace

int main(int argc, char** argv) {
    registerAll<float>("float");
    registerAll<Lanes>("lanes" + std::to_string(Lanes::size));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
