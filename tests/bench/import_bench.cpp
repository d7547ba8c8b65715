// A mesh of a million triangles from an OBJ file: assimp alone, then what gr_mesh does, then with what finds rays'
// hits.
#include "gr/database.h"
#include "gr/scene.h"
#include "gr/uv_sphere_mesh.h"
#include "support/temporary_folder.h"

#include <benchmark/benchmark.h>
#include <assimp/Importer.hpp>

#include <cstdio>

namespace {

// Written once.
const std::string& meshFile() {
    static const support::TemporaryFolder folder;
    static const std::string path = [] {
        const std::string file = folder / "mesh.obj";
        std::FILE* out = std::fopen(file.c_str(), "w");
        const gr::PolygonMesh mesh = gr::uvSphereMesh(501, 1000);
        for (const glm::dvec3& v : mesh.vertices) std::fprintf(out, "v %.6f %.6f %.6f\n", v.x, v.y, v.z);
        for (const std::vector<int>& face : mesh.faces)
            for (std::size_t i = 2; i < face.size(); ++i)
                std::fprintf(out, "f %d %d %d\n", face[0] + 1, face[i - 1] + 1, face[i] + 1);
        std::fclose(out);
        return file;
    }();
    return path;
}

void readByAssimp(benchmark::State& state) {
    for (auto _ : state) {
        Assimp::Importer importer;
        if (importer.ReadFile(meshFile(), 0) == nullptr) state.SkipWithError("assimp cannot read it");
    }
}

void readMesh(benchmark::State& state, const char* accelerator) {
    for (auto _ : state) {
        gr::Database database;
        gr::MeshRepairs repairs;
        database.create(":", "mesh", gr::PolyhedronNode{database.readMesh(meshFile(), "mesh.obj", repairs)});
        if (accelerator == nullptr) continue;
        const gr::Scene scene = gr::compile(database, ":", {});
        benchmark::DoNotOptimize(gr::makeAccelerator(accelerator, scene, 1)->bytes());
    }
}

}  // namespace

BENCHMARK(readByAssimp)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readMesh, alone, nullptr)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readMesh, embree, "embree")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readMesh, grid, "grid")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
