// The integrators on a Cornell box, beside the bare loop over the same box, on one thread.
#include "bare_loop.h"
#include "gr/database/database.h"
#include "render/render.h"
#include "render/transport/lanes_choice.h"

#include <benchmark/benchmark.h>

namespace {

// A Cornell box like that of scenes/cornell1.gr: walls of polygons, two blocks, a lamp.
void buildCornell(gr::Database& database) {
    const auto material = [&](const char* name, const core::Rgbf& colour) {
        database.addMaterial(name, materials::Diffuse{.reflectance = colour});
    };
    material("white", core::Rgbf(0.73f));
    material("red", {0.65f, 0.05f, 0.05f});
    material("green", {0.12f, 0.45f, 0.15f});
    const auto polyhedron = [&](const char* name, const char* colour, std::vector<std::vector<int>> faces) {
        gr::PolygonMesh mesh;
        for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1 ? 555 : 0, i & 2 ? 555 : 0, i & 4 ? 555 : 0);
        mesh.faces = std::move(faces);
        gr::MeshRepairs repairs;
        database.create(":", name, gr::PolyhedronNode{gr::Polyhedron::make(std::move(mesh), repairs)});
        database.setMaterial(std::string(":") + name, colour);
    };
    polyhedron("shell", "white", {{0, 4, 5, 1}, {4, 6, 7, 5}, {2, 3, 7, 6}});
    polyhedron("left", "red", {{1, 5, 7, 3}});
    polyhedron("right", "green", {{0, 2, 6, 4}});
    database.create(":", "light", gr::AreaLightNode{{17, 12, 4}, {0, 0, 0}, 105});
    database.translate(":light", {278, 554, 279.5});
    database.scale(":light", {0, 0, 0}, {130 / 105., 1, 1});
    const auto block = [&](const char* name, double height, double x, double z, double degrees) {
        database.create(":", name, gr::BoxNode{{-82.5, 0, -82.5}, {165, height, 165}});
        const std::string path = std::string(":") + name;
        database.setMaterial(path, "white");
        database.translate(path, {x, 0, z});
        database.rotate(path, 1, degrees);
    };
    block("short", 165, 186, 169, -17);
    block("tall", 330, 368, 351, 17);
}

// What the integrator named in the settings makes of it.
void renderCornell(benchmark::State& state, render::RenderSettings settings) {
    gr::Database database;
    buildCornell(database);
    const gr::Scene scene = gr::compile(database, ":", {});
    const auto accelerator = gr::makeNoAccelerator(scene);
    settings.globalIllumination = true;
    settings.antialiasing = true;
    settings.pathLength = 6;
    settings.samplesPerPixel = 4;
    const core::Vec3f eye(278, 278, -800);
    std::unique_ptr<render::Integrator> integrator;
    if (settings.integrator == "report")
        integrator = render::makeReportIntegrator(scene, *accelerator, settings, core::Rgbf(0), eye);
    else
        integrator = render::makePathIntegrator(scene, *accelerator, settings, core::Rgbf(0), eye);
    const render::Camera camera(glm::dvec3(eye), {0, 0, 1}, {0, 1, 0}, 38, 128, 128);
    std::uint64_t rays = 0;
    const std::atomic<bool> stop{false};
    for (auto _ : state) {
        image::Film film(128, 128, 0, 128);
        render::Progress progress;
        rays += render::render(*integrator, camera, settings, film, progress, stop).rays.total();
    }
    state.counters["Mrays/s"] = benchmark::Counter(static_cast<double>(rays) * 1e-6, benchmark::Counter::kIsRate);
}

void cornellReport(benchmark::State& state) {
    render::RenderSettings settings;
    settings.integrator = "report";
    settings.threads = static_cast<int>(state.range(0));
    renderCornell(state, settings);
}
BENCHMARK(cornellReport)
    ->Name("cornell/report/float/threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void cornellPath(benchmark::State& state, core::Word lanes, int threads) {
    render::RenderSettings settings;
    settings.lanes = lanes;
    settings.threads = threads;
    try {
        render::checkLanes(lanes);
    } catch (const core::Error& error) {
        state.SkipWithError(error.what());
        return;
    }
    renderCornell(state, settings);
}
void addPath(const char* name, core::Word lanes, int threads) {
    benchmark::RegisterBenchmark(name, cornellPath, lanes, threads)->UseRealTime()->Unit(benchmark::kMillisecond);
}
const bool pathsAreAdded = [] {
    addPath("cornell/path/float", "float", 1);
    addPath("cornell/path/sse4.2", "sse4.2", 1);
    addPath("cornell/path/avx2", "avx2", 1);
    addPath("cornell/path/avx512", "avx512", 1);
    addPath("cornell/path/auto/threads/1", "auto", 1);
    addPath("cornell/path/auto/threads/2", "auto", 2);
    return true;
}();

void cornellBareLoop(benchmark::State& state) {
    std::uint64_t rays = 0;
    std::uint32_t seed = 1;
    for (auto _ : state) rays += bench::bareLoop<float>(65536, seed++).rays;
    state.counters["Mrays/s"] = benchmark::Counter(static_cast<double>(rays) * 1e-6, benchmark::Counter::kIsRate);
}
BENCHMARK(cornellBareLoop)->Name("cornell/bare_loop/float")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
