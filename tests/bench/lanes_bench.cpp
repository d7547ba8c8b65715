// What is a template over Real, at the width that this program is compiled for and at float.
#include "bare_loop.h"
#include "gr/light.h"
#include "gr/shape.h"
#include "gr/triangle.h"
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
void perItem(benchmark::State& state) {
    const double items = 1024.0 * core::RealTraits<Real>::lanes;
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
    const gr::AreaLight light{{0, 4, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, core::Rgbf(1), 1, 0};
    for (auto _ : state)
        for (const auto& ray : rays)
            benchmark::DoNotOptimize(light.sample(ray.origin, core::Vec2<Real>(ray.direction.x, ray.direction.y)));
    perItem<Real>(state);
}

template<class Real, class Material>
void sampleMaterial(benchmark::State& state) {
    Random<Real> random(2);
    std::vector<core::Vec2<Real>> places;
    for (int i = 0; i < 1024; ++i) {
        const Real x = random.next();
        const Real y = random.next();
        places.emplace_back(x, y);
    }
    const Material material{};
    const Vec3<Real> wo(Real(0.6f), Real(0), Real(0.8f));
    for (auto _ : state)
        for (const auto& u : places) benchmark::DoNotOptimize(material.sample(wo, u));
    perItem<Real>(state);
}

template<class Real, class Material>
void evalMaterial(benchmark::State& state) {
    const auto rays = makeRays<Real>();
    const Material material{};
    const Vec3<Real> wo(Real(0.6f), Real(0), Real(0.8f));
    for (auto _ : state)
        for (const auto& ray : rays) {
            benchmark::DoNotOptimize(material.eval(wo, ray.direction));
            benchmark::DoNotOptimize(material.pdfW(wo, ray.direction));
        }
    perItem<Real>(state);
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
