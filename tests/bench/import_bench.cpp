// A mesh of a million triangles from an OBJ file: what gr_mesh does, then with what finds rays' hits, against assimp
// alone. assimp gives each corner a vertex of its own unless it is asked to join them, as gr_mesh does; both are told:
// of_assimp is our time over assimp's without any step behind the reading, of_joined over assimp's with an indexed
// mesh.
#include "core/parallel.h"
#include "gr/database/database.h"
#include "gr/scene.h"
#include "gr/uv_sphere_mesh.h"
#include "support/temporary_folder.h"

#include <assimp/postprocess.h>
#include <benchmark/benchmark.h>
#include <assimp/Importer.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace {

bool writeMesh(const std::string& file) {
    std::FILE* out = std::fopen(file.c_str(), "w");
    const gr::PolygonMesh mesh = gr::uvSphereMesh(501, 1000);
    for (const glm::dvec3& v : mesh.vertices) std::fprintf(out, "v %.6f %.6f %.6f\n", v.x, v.y, v.z);
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 2; i < face.size(); ++i)
            std::fprintf(out, "f %d %d %d\n", face[0] + 1, face[i - 1] + 1, face[i] + 1);
    return std::fclose(out) == 0;
}

const std::string& meshFile() {
    static const support::TemporaryFolder folder;
    static const std::string path = folder / "mesh.obj";
    return path;
}

bool readByAssimp(unsigned steps) {
    Assimp::Importer importer;
    return importer.ReadFile(meshFile(), steps) != nullptr;
}

bool readMesh(const char* accelerator) {
    gr::Database database;
    gr::MeshRepairs repairs;
    database.create(":", "mesh", gr::PolyhedronNode{database.readMesh(meshFile(), "mesh.obj", repairs)});
    if (accelerator == nullptr) return true;
    const gr::Scene scene = gr::compile(database, ":", {});
    return gr::makeAccelerator(accelerator, scene, core::threadCount(0))->bytes() > 0;
}

// How long a process takes that does nothing else: in one that has done it before, memory need not be made ready again.
// A negative number when it fails.
template<class Function>
double secondsOf(Function&& function) {
    const auto start = std::chrono::steady_clock::now();
    const pid_t process = fork();
    if (process == 0) {
        bool isDone = false;
        try {
            isDone = function();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
        }
        _exit(isDone ? 0 : 1);
    }
    int status = 1;
    if (process < 0 || waitpid(process, &status, 0) != process || status != 0) return -1;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

constexpr int rounds = 7;

// Ours and assimp's take turns; the joining, which takes three times the memory, comes behind both.
void importMesh(benchmark::State& state, const char* accelerator) {
    static const bool isWritten = secondsOf([&file = meshFile()] { return writeMesh(file); }) > 0;
    std::vector<double> ours, assimp, joined;
    for (auto _ : state) {
        assimp.push_back(secondsOf([] { return readByAssimp(0); }));
        ours.push_back(secondsOf([accelerator] { return readMesh(accelerator); }));
        state.SetIterationTime(ours.back());
    }
    for (int i = 0; i < 3; ++i)
        joined.push_back(
            secondsOf([] { return readByAssimp(aiProcess_Triangulate | aiProcess_JoinIdenticalVertices); }));
    for (const std::vector<double>& seconds : {ours, assimp, joined})
        if (!isWritten || *std::min_element(seconds.begin(), seconds.end()) < 0)
            return state.SkipWithError("the mesh cannot be read");
    state.counters["of_assimp"] = median(ours) / median(assimp);
    state.counters["of_joined"] = median(ours) / median(joined);
}

}  // namespace

BENCHMARK_CAPTURE(importMesh, alone, nullptr)->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(importMesh, grid, "grid")->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(importMesh, embree, "embree")->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(importMesh, auto, "auto") -> UseManualTime() -> Iterations(rounds) -> Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
