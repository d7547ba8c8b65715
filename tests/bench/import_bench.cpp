// A mesh of a million triangles from files: what gr_mesh does, then with what finds rays' hits, against assimp alone.
// assimp gives each corner a vertex of its own unless it is asked to join them, as gr_mesh does; both are told:
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
#include <map>
#include <memory>
#include <vector>

namespace {

struct Triangles {
    std::vector<core::Vec3f> places;
    std::vector<int> corners;
};

Triangles millionTriangles() {
    const gr::PolygonMesh mesh = gr::uvSphereMesh(501, 1000);
    Triangles triangles;
    triangles.places.assign(mesh.vertices.begin(), mesh.vertices.end());
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 2; i < face.size(); ++i)
            triangles.corners.insert(triangles.corners.end(), {face[0], face[i - 1], face[i]});
    return triangles;
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

template<class Value>
void put(std::FILE* file, const std::vector<Value>& values) {
    std::fwrite(values.data(), sizeof(Value), values.size(), file);
}

void writeObj(std::FILE* file, const Triangles& mesh) {
    for (const core::Vec3f& v : mesh.places) std::fprintf(file, "v %.6f %.6f %.6f\n", v.x, v.y, v.z);
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3)
        std::fprintf(file, "f %d %d %d\n", mesh.corners[i] + 1, mesh.corners[i + 1] + 1, mesh.corners[i + 2] + 1);
}

void writePly(std::FILE* file, const Triangles& mesh) {
    std::fprintf(file,
                 "ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty float x\nproperty float y\n"
                 "property float z\nelement face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                 mesh.places.size(), mesh.corners.size() / 3);
    put(file, mesh.places);
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
        std::fputc(3, file);
        std::fwrite(&mesh.corners[i], sizeof(int), 3, file);
    }
}

void writeGlb(std::FILE* file, const Triangles& mesh) {
    const std::size_t places = mesh.places.size() * sizeof(core::Vec3f), corners = mesh.corners.size() * sizeof(int);
    const auto text = [](std::size_t number) { return std::to_string(number); };
    std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":)" +
        text(places + corners) + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + text(places) +
        R"(},{"buffer":0,"byteOffset":)" + text(places) + R"(,"byteLength":)" + text(corners) +
        R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + text(mesh.places.size()) +
        R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" + text(mesh.corners.size()) + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto size = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
    put(file, std::vector{0x46546C67u, 2u, size(28 + json.size() + places + corners), size(json.size()), 0x4E4F534Au});
    std::fwrite(json.data(), 1, json.size(), file);
    put(file, std::vector{size(places + corners), 0x004E4942u});
    put(file, mesh.places);
    put(file, mesh.corners);
}

// The file of a format, which is written when it is first asked for.
const std::string& meshFile(const std::string& ending) {
    static const support::TemporaryFolder folder;
    static std::map<std::string, std::string> written;
    std::string& path = written[ending];
    if (!path.empty()) return path;
    path = folder / ("mesh" + ending);
    const File file(std::fopen(path.c_str(), "wb"), std::fclose);
    const auto write = ending == ".obj" ? writeObj : ending == ".ply" ? writePly : writeGlb;
    if (file != nullptr) write(file.get(), millionTriangles());
    return path;
}

bool readByAssimp(const std::string& file, unsigned steps) {
    Assimp::Importer importer;
    return importer.ReadFile(file, steps) != nullptr;
}

bool readMesh(const std::string& file, const char* accelerator) {
    gr::Database database;
    gr::MeshRepairs repairs;
    database.create(":", "mesh", gr::PolyhedronNode{database.readMesh(file, "mesh", repairs)});
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
void importMesh(benchmark::State& state, const char* ending, const char* accelerator) {
    const std::string file = meshFile(ending);
    std::vector<double> ours, assimp, joined;
    for (auto _ : state) {
        assimp.push_back(secondsOf([&] { return readByAssimp(file, 0); }));
        ours.push_back(secondsOf([&] { return readMesh(file, accelerator); }));
        state.SetIterationTime(ours.back());
    }
    for (int i = 0; i < 3; ++i)
        joined.push_back(
            secondsOf([&] { return readByAssimp(file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices); }));
    for (const std::vector<double>& seconds : {ours, assimp, joined})
        if (*std::min_element(seconds.begin(), seconds.end()) < 0)
            return state.SkipWithError("the mesh cannot be read");
    state.counters["of_assimp"] = median(ours) / median(assimp);
    state.counters["of_joined"] = median(ours) / median(joined);
}

void measured(benchmark::internal::Benchmark* benchmark) {
    benchmark->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);
}

}  // namespace

BENCHMARK_CAPTURE(importMesh, obj, ".obj", nullptr)->Apply(measured);
BENCHMARK_CAPTURE(importMesh, ply, ".ply", nullptr)->Apply(measured);
BENCHMARK_CAPTURE(importMesh, glb, ".glb", nullptr)->Apply(measured);
BENCHMARK_CAPTURE(importMesh, obj_grid, ".obj", "grid")->Apply(measured);
BENCHMARK_CAPTURE(importMesh, obj_embree, ".obj", "embree")->Apply(measured);
BENCHMARK_CAPTURE(importMesh, obj_auto, ".obj", "auto")->Apply(measured);
BENCHMARK_MAIN();
