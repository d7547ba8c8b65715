// Finding what rays meet: lattices of spheres that fill the same part of the picture however many they are, and a mesh.
// Each benchmark traces a picture's camera rays, and from what they meet a shadow ray each, on one thread.
#include "gr/accelerators/grid_walk.h"
#include "gr/database/database.h"
#include "gr/scene.h"
#include "gr/uv_sphere_mesh.h"
#include "native_embree.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <map>
#include <random>

namespace {

using core::Vec3f;

gr::Scene sphereLattice(int n) {
    gr::Database database;
    const double step = 2. / n;
    for (int x = 0; x < n; ++x)
        for (int z = 0; z < n; ++z)
            database.create(":", "s" + std::to_string(x * n + z),
                            gr::SphereNode{{step * (x + 0.5) - 1, 0, step * (z + 0.5) - 1}, 0.4 * step});
    return gr::compile(database, ":", {});
}

// Another resolution along than round makes the triangles even, but at the poles.
gr::Scene meshScene() {
    gr::MeshRepairs repairs;
    gr::Database database;
    database.create(":", "mesh", gr::PolyhedronNode{gr::Polyhedron::make(gr::uvSphereMesh(160, 314), repairs)});
    return gr::compile(database, ":", {});
}

// Every scene is made once.
const gr::Scene& sceneOf(int n) {
    static std::map<int, gr::Scene> scenes;
    const auto [entry, isNew] = scenes.try_emplace(n);
    if (isNew) entry->second = n == 0 ? meshScene() : sphereLattice(n);
    return entry->second;
}

std::vector<core::Rayf> cameraRays() {
    constexpr int size = 256;
    const Vec3f eye(0.3f, 3, -3), forward = glm::normalize(-eye);
    const Vec3f right = glm::normalize(glm::cross(forward, Vec3f(0, 1, 0))), up = glm::cross(right, forward);
    std::vector<core::Rayf> rays;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / size - 0.5f,
                        v = (static_cast<float>(y) + 0.5f) / size - 0.5f;
            rays.push_back({eye, glm::normalize(forward + (right * u + up * v) * 0.6f)});
        }
    return rays;
}

// Traces the picture and returns how many rays that took.
template<class Intersect, class Occluded>
int trace(const std::vector<core::Rayf>& rays, Intersect&& intersect, Occluded&& occluded) {
    const Vec3f light(4, 6, -1);
    int count = 0;
    for (const core::Rayf& ray : rays) {
        ++count;
        const float t = intersect(ray);
        if (t == core::infinity) continue;
        const Vec3f start = ray.origin + ray.direction * (t * 0.9999f);
        benchmark::DoNotOptimize(occluded(core::Rayf{start, light - start, 1}));
        ++count;
    }
    return count;
}

void setRate(benchmark::State& state, int raysEach) {
    state.counters["Mrays/s"] =
        benchmark::Counter(1e-6 * raysEach * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

std::size_t objectCount(const gr::Scene& scene) {
    std::size_t count = 0;
    for (const auto& polyhedron : scene.polyhedra) count += polyhedron->triangleCount();
    return count > 0 ? count : scene.instances.size();
}

void traceScene(benchmark::State& state, const char* name, int n) {
    const gr::Scene& scene = sceneOf(n);
    const auto accelerator = gr::makeAccelerator(name, scene, 1);
    const std::vector<core::Rayf> rays = cameraRays();
    gr::TraversalCounts counts;
    const auto intersect = [&](const core::Rayf& ray) {
        const auto hit = accelerator->intersect(ray, counts);
        return hit ? hit->t : core::infinity;
    };
    const auto occluded = [&](const core::Rayf& ray) { return accelerator->occluded(ray, counts); };
    int count = trace(rays, intersect, occluded);
    counts = {};
    for (auto _ : state) count = trace(rays, intersect, occluded);
    setRate(state, count);
    const double all = static_cast<double>(count) * static_cast<double>(state.iterations());
    state.counters["tests/ray"] = static_cast<double>(counts.tests) / all;
    state.counters["cells/ray"] = static_cast<double>(counts.cells) / all;
}

void traceNative(benchmark::State& state) {
    const gr::Polyhedron& polyhedron = *sceneOf(0).polyhedra[0];
    std::vector<bench::Triangle> triangles;
    for (std::uint32_t i = 0; i < polyhedron.triangleCount(); ++i)
        triangles.push_back({polyhedron.vertex(i, 0), polyhedron.vertex(i, 1), polyhedron.vertex(i, 2)});
    const bench::NativeTriangles mesh(triangles);
    const std::vector<core::Rayf> rays = cameraRays();
    int count = 0;
    for (auto _ : state)
        count = trace(
            rays, [&](const core::Rayf& ray) { return mesh.intersect(ray); },
            [&](const core::Rayf& ray) { return mesh.occluded(ray); });
    setRate(state, count);
}

void build(benchmark::State& state, const char* name, int n) {
    const gr::Scene& scene = sceneOf(n);
    std::size_t bytes = 0;
    for (auto _ : state) bytes = gr::makeAccelerator(name, scene, 1)->bytes();
    const auto objects = static_cast<double>(objectCount(scene));
    state.counters["bytes each"] = static_cast<double>(bytes) / objects;
    state.counters["scene's, each"] = static_cast<double>(scene.bytes()) / objects;
}

// Balls of many sizes at random.
gr::Scene randomBalls() {
    constexpr int count = 50000;
    gr::Database database;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1, 1), size(0.002, 0.014);
    for (int i = 0; i < count; ++i) {
        const double x = place(random), y = place(random), z = place(random);
        database.create(":", "s" + std::to_string(i), gr::SphereNode{{x, y, z}, size(random)});
    }
    return gr::compile(database, ":", {});
}

// The grid over the scene's objects, or the packs of its mesh, with more or fewer cells than it takes by itself: the
// choice is good where no other is much faster.
void refine(benchmark::State& state, const gr::Scene& scene, double refinement) {
    const gr::Polyhedron* mesh = scene.polyhedra.empty() ? nullptr : scene.polyhedra[0].get();
    std::vector<core::Bounds> bounds(mesh != nullptr ? mesh->packCount() : scene.instances.size());
    for (std::uint32_t i = 0; i < bounds.size(); ++i)
        bounds[i] = mesh != nullptr ? mesh->packBounds(i).widened(1e-5f) : scene.instances[i].bounds();
    const gr::Grid grid(bounds, 0x1p-19f, 1, refinement);
    const auto intersect = [&](const core::Rayf& ray) {
        gr::Hit nearest;
        gr::TraversalCounts counts;
        const gr::PackRay packRay(ray);
        grid.walk(ray, nearest.t, counts, [&](std::uint32_t i) {
            if (mesh != nullptr)
                mesh->intersect(packRay, i, 0, nearest);
            else
                nearest.t = std::min(nearest.t, gr::Sphere{}.intersect(scene.instances[i].place.toObject(ray)));
            return false;
        });
        return nearest.t;
    };
    const std::vector<core::Rayf> rays = cameraRays();
    int count = 0;
    for (auto _ : state)
        count = trace(rays, intersect, [&](const core::Rayf& ray) { return intersect(ray) < ray.tMax; });
    setRate(state, count);
    state.counters["bytes each"] = static_cast<double>(grid.bytes()) / static_cast<double>(bounds.size());
}

void addRefinements() {
    for (const char* name : {"lattice", "random", "mesh"})
        for (const double refinement : {1. / 64, 1. / 16, 1. / 4, 1., 4., 16., 64.})
            benchmark::RegisterBenchmark(
                ("cells/" + std::string(name) + "/" + std::to_string(refinement)).c_str(),
                [=](auto& s) {
                    static const gr::Scene random = randomBalls();
                    refine(s, name[0] == 'l' ? sceneOf(320) : name[0] == 'm' ? sceneOf(0) : random, refinement);
                })
                ->Unit(benchmark::kMillisecond);
}

void addAll() {
    addRefinements();
    for (const char* name : {"off", "grid", "embree"}) {
        for (const int n : {2, 4, 10, 32, 100, 320, 1000}) {
            if (std::string(name) == "off" && n > 32) continue;
            const std::string label = "/" + std::string(name) + "/" + std::to_string(n * n);
            benchmark::RegisterBenchmark(("spheres" + label).c_str(), [=](auto& s) {
                traceScene(s, name, n);
            })->Unit(benchmark::kMillisecond);
        }
        if (std::string(name) == "off") continue;
        const std::string label = std::string("/") + name;
        benchmark::RegisterBenchmark(("mesh" + label).c_str(), [=](auto& s) {
            traceScene(s, name, 0);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("build spheres" + label + "/1000000").c_str(), [=](auto& s) {
            build(s, name, 1000);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("build mesh" + label).c_str(), [=](auto& s) {
            build(s, name, 0);
        })->Unit(benchmark::kMillisecond);
    }
    // Embree's own triangles, whose hits are not bit by bit those of the others.
    benchmark::RegisterBenchmark("mesh/embree's own triangles", traceNative)->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int count, char** words) {
    benchmark::Initialize(&count, words);
    if (benchmark::ReportUnrecognizedArguments(count, words)) return 1;
    addAll();
    benchmark::RunSpecifiedBenchmarks();
}
