// What a CSG object costs beside the objects that are its operands, tested for themselves: rays at random through one
// object, and through twenty in a heap, all at once in lanes and one by one. A program for each instruction set.
#include "gr/random_shapes.h"
#include "trace_contestants.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace {

using gr::Database, gr::NodeContent;

struct Kind {
    const char* name;
    std::function<void(Database&, const std::string& parent)> build;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"box less ball",
         [](Database& database, const std::string& parent) {
             database.create(parent, "box", gr::BoxNode{{-1, -1, -1}, {2, 2, 2}});
             database.create(parent, "ball", gr::SphereNode{{0, 0, 0}, 1.25});
         }},
        {"box less 8 balls",
         [](Database& database, const std::string& parent) {
             database.create(parent, "box", gr::BoxNode{{-1, -1, -1}, {2, 2, 2}});
             for (int i = 0; i < 8; ++i)
                 database.create(parent, "ball" + std::to_string(i),
                                 gr::SphereNode{{2 * (i & 1) - 1, (i & 2) - 1, (i & 4) / 2 - 1}, 0.5});
         }},
        {"torus less cylinder and cone", [](Database& database, const std::string& parent) {
             database.create(parent, "torus", gr::TorusNode{glm::dvec3(0), 1, 0.4});
             database.create(parent, "cylinder", gr::CylinderNode{{0, -1, 0}, 0.9, 2});
             database.create(parent, "cone", gr::ConeNode{{0, -1, 0}, 0.9, 2, 0.1});
         }}};
    return all;
}

gr::Scene sceneOf(const Kind& kind, int count, const NodeContent& top) {
    Database database;
    support::TestRandom random(3);
    for (int i = 0; i < count; ++i) {
        const std::string name = database.create(":", "n" + std::to_string(i), top).path();
        if (count > 1) database.translate(name, 4. * gr::randomPoint(random, -1, 1));
        kind.build(database, name);
    }
    return gr::compile(database, ":", {});
}

bench::RayPacks randomRays() {
    constexpr int count = 1 << 17;
    support::TestRandom random(5);
    bench::RayPacks rays;
    for (int i = 0; i < count; ++i) {
        const core::Vec3f origin(6. * gr::randomDirection(random));
        rays.add({origin, core::Vec3f(3. * gr::randomPoint(random, -1, 1)) - origin, core::infinity});
    }
    rays.finish();
    return rays;
}

double cpuSeconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// One who answers all rays, and the least time that it took.
struct Contestant {
    gr::Scene scene;
    // For lanes, which test all by themselves, and for one ray at a time.
    std::unique_ptr<gr::Accelerator> none = gr::makeAccelerator("off", scene, 1, true);
    std::unique_ptr<gr::Accelerator> accelerator = gr::makeAccelerator("off", scene, 1, false);
    bench::OurTracer tracer{scene, *none};
    double seconds = core::infinity;

    void takeTurn(const bench::RayPacks& rays, bool inLanes, std::vector<float>& answers) {
        const double start = cpuSeconds();
        if (inLanes)
            tracer.answer(rays, bench::Question::nearest, answers.data());
        else
            answerOneByOne(rays, answers.data());
        seconds = std::min(seconds, cpuSeconds() - start);
    }

private:
    void answerOneByOne(const bench::RayPacks& rays, float* answers) const {
        for (const bench::RayPack& pack : rays.packs())
            for (int place = 0; place < bench::RayPack::width; ++place) {
                const auto hit = accelerator->intersect(pack.at(place));
                *answers++ = hit ? hit->t : core::infinity;
            }
    }
};

void trace(benchmark::State& state, const Kind& kind, int count, bool inLanes) {
    static const bench::RayPacks rays = randomRays();
    std::vector<float> answers(rays.size());
    Contestant whole{sceneOf(kind, count, gr::DifferenceNode{})}, operands{sceneOf(kind, count, gr::TransformNode{})};
    for (auto _ : state) {
        whole.takeTurn(rays, inLanes, answers);
        operands.takeTurn(rays, inLanes, answers);
    }
    const double perRay = 1e9 / static_cast<double>(rays.size());
    state.counters["ns a ray"] = whole.seconds * perRay;
    state.counters["operands' ns"] = operands.seconds * perRay;
    state.counters["ratio"] = whole.seconds / operands.seconds;
}

}  // namespace

int main(int count, char** words) {
    benchmark::Initialize(&count, words);
    if (benchmark::ReportUnrecognizedArguments(count, words)) return 1;
    constexpr int turns = 9;
    for (const Kind& kind : kinds())
        for (const int objects : {1, 20})
            for (const bool inLanes : {true, false}) {
                if (objects > 1 && !inLanes) continue;  // packs of shapes would be compared with what is one by one
                const std::string name = "csg/" + std::string(kind.name) + "/" + std::to_string(objects) +
                                         (inLanes ? "/lanes" + std::to_string(core::Lanes::size) : "/one by one");
                benchmark::RegisterBenchmark(
                    name.c_str(), [&kind, objects, inLanes](auto& state) { trace(state, kind, objects, inLanes); })
                    ->Iterations(turns)
                    ->Unit(benchmark::kMillisecond);
            }
    benchmark::RunSpecifiedBenchmarks();
}
