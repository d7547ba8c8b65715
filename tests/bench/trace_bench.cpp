// How fast rays are traced in two scenes with a mesh: by our tracer, and by Embree with its own triangles of the same
// scene. A program for each instruction set: what two of them share would be linked from either.
#include "trace_contestants.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace {

using bench::Question;
using bench::RayPacks;

constexpr int turns = 7;

// All that stands in the scene. Of its shapes only meshes are triangles; its lamps are squares.
std::vector<bench::Triangle> trianglesOf(const gr::Scene& scene) {
    std::vector<bench::Triangle> triangles;
    for (const gr::Instance& instance : scene.instances) {
        const auto* mesh = std::get_if<const gr::Polyhedron*>(&instance.shape);
        if (mesh == nullptr) continue;
        const core::Transform map = instance.place.worldFromObject();
        for (std::uint32_t i = 0; i < (*mesh)->triangleCount(); ++i) {
            const auto corner = [&](int k) { return map.point((*mesh)->vertex(i, k)); };
            triangles.push_back({corner(0), corner(1), corner(2)});
        }
    }
    for (const gr::AreaLight& lamp : scene.lights.of<gr::AreaLight>()) {
        const core::Vec3f a = lamp.corner, b = a + lamp.edge1, c = b + lamp.edge2, d = a + lamp.edge2;
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return triangles;
}

struct TracedScene {
    bench::ScriptScene script;
    std::unique_ptr<gr::Accelerator> accelerator;
    bench::NativeTriangles native;
    bench::PathRays rays;

    explicit TracedScene(const std::string& name)
        : script(bench::sceneOf(std::string(GRSH_SCENES) + "/" + name + ".gr")),
          accelerator(gr::makeAccelerator("embree", script.scene, 1, true)),
          native(trianglesOf(script.scene)),
          rays(bench::raysOf(script, *accelerator)) {}
};

// Every scene is made once.
const TracedScene& sceneOf(const std::string& name) {
    static std::map<std::string, TracedScene> scenes;
    return scenes.try_emplace(name, name).first->second;
}

double cpuSeconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// One who traces rays, its last answers, and how long it took for them each time.
struct Contestant {
    std::string name;
    std::function<void(float* answers)> trace;
    std::vector<float> answers;
    std::vector<double> seconds = {};

    double takeTurn() {
        const double start = cpuSeconds();
        trace(answers.data());
        seconds.push_back(cpuSeconds() - start);
        return seconds.back();
    }
    double raysPerSecond() {
        const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
        std::nth_element(seconds.begin(), middle, seconds.end());
        return static_cast<double>(answers.size()) / *middle;
    }
};

std::vector<Contestant> contestantsFor(const TracedScene& scene, const RayPacks& rays, Question question,
                                       bool areCoherent) {
    const std::vector<float> none(rays.size());
    const bench::OurTracer ours(scene.script.scene, *scene.accelerator);
    return {
        {"grsh", [=, &rays](float* answers) { ours.answer(rays, question, answers); }, none},
        {"embree1",
         [=, &scene, &rays](float* answers) { bench::answerOneByOne(scene.native, rays, question, answers); }, none},
        {"embree16",
         [=, &scene, &rays](float* answers) {
             bench::answerSixteen(scene.native, rays, question, areCoherent, answers);
         },
         none}};
}

// The part of the rays for which any two say otherwise, beyond what rounding may do to t.
double disagreement(const std::vector<Contestant>& all, const RayPacks& rays) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const core::Rayf ray = rays.packs()[i / bench::RayPack::width].at(static_cast<int>(i % bench::RayPack::width));
        const float t = all[0].answers[i];
        const float tolerance = 1e-5f * (core::largestComponent(ray.origin) + t);
        count += std::any_of(all.begin() + 1, all.end(), [&](const Contestant& other) {
            return t != other.answers[i] && !(std::abs(t - other.answers[i]) <= tolerance);
        });
    }
    return static_cast<double>(count) / static_cast<double>(rays.size());
}

// An iteration is a turn for each: what else the machine does meanwhile slows all of them.
void trace(benchmark::State& state, const char* name, const RayPacks bench::PathRays::*kind, Question question,
           bool areCoherent) {
    const TracedScene& scene = sceneOf(name);
    const RayPacks& rays = scene.rays.*kind;
    std::vector<Contestant> all = contestantsFor(scene, rays, question, areCoherent);
    for (Contestant& contestant : all) contestant.trace(contestant.answers.data());
    const double disagree = disagreement(all, rays);
    if (disagree > 1e-4) {
        state.SkipWithError(("they disagree about " + std::to_string(disagree) + " of the rays").c_str());
        return;
    }
    for (auto _ : state) {
        double seconds = 0;
        for (Contestant& contestant : all) seconds += contestant.takeTurn();
        state.SetIterationTime(seconds);
    }
    for (Contestant& contestant : all) state.counters[contestant.name + " Mrays/s"] = 1e-6 * contestant.raysPerSecond();
    state.counters["grsh/embree"] = all[0].raysPerSecond() / std::max(all[1].raysPerSecond(), all[2].raysPerSecond());
    state.counters["disagree"] = disagree;
}

void add(const char* scene, const char* rays, RayPacks bench::PathRays::*kind, Question question, bool areCoherent) {
    const std::string name = "trace/" + std::string(scene) + "/" + rays + "/lanes" + std::to_string(core::Lanes::size);
    benchmark::RegisterBenchmark(name.c_str(), [=](auto& state) { trace(state, scene, kind, question, areCoherent); })
        ->Iterations(turns)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int count, char** words) {
    benchmark::Initialize(&count, words);
    if (benchmark::ReportUnrecognizedArguments(count, words)) return 1;
    // Embree is told what makes its packs faster: of the camera's rays that they go the same way, of shadow rays not.
    for (const char* scene : {"reference-d", "reference-e"}) {
        add(scene, "camera", &bench::PathRays::camera, Question::nearest, true);
        add(scene, "shadow", &bench::PathRays::shadow, Question::occluded, false);
        add(scene, "bounce", &bench::PathRays::bounce, Question::nearest, false);
    }
    benchmark::RunSpecifiedBenchmarks();
}
