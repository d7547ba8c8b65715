// Files of tests/corpus/meshes, each with what must become of it, from tests/corpus/meshes.txt.
#include "gr/error_of.h"
#include "gr/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace gr {
namespace {

// file | triangles | low corner | high corner | area | volume | what else is known | what is mended
// file | reason why it is refused
struct Row {
    std::vector<std::string> cells;
};

std::vector<Row> rowsOf(const std::string& path) {
    std::vector<Row> rows;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        Row& row = rows.emplace_back();
        std::stringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '|');) {
            const std::size_t first = cell.find_first_not_of(' ');
            row.cells.push_back(first == cell.npos ? "" : cell.substr(first, cell.find_last_not_of(' ') + 1 - first));
        }
    }
    return rows;
}

glm::dvec3 cornerOf(const Polyhedron& mesh, std::uint32_t triangle, int k) {
    return mesh.origin() + glm::dvec3(mesh.vertex(triangle, k));
}

double areaOf(const Polyhedron& mesh) {
    double sum = 0;
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i)
        sum += glm::length(
            glm::cross(cornerOf(mesh, i, 1) - cornerOf(mesh, i, 0), cornerOf(mesh, i, 2) - cornerOf(mesh, i, 0)));
    return sum / 2;
}

// Positive where a closed mesh faces outwards.
double volumeOf(const Polyhedron& mesh) {
    double sum = 0;
    const glm::dvec3 origin = cornerOf(mesh, 0, 0);
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i)
        sum += glm::dot(cornerOf(mesh, i, 0) - origin,
                        glm::cross(cornerOf(mesh, i, 1) - origin, cornerOf(mesh, i, 2) - origin));
    return sum / 6;
}

std::string knownOf(const Polyhedron& mesh) {
    std::string text;
    if (mesh.hasNormals()) text += "normals ";
    if (!mesh.uvs().empty()) text += "uv ";
    if (!mesh.colours().empty()) text += "colours ";
    for (const MeshGroup& group : mesh.groups()) text += "[" + group.name + "/" + group.material + "] ";
    if (!text.empty()) text.pop_back();
    return text;
}

glm::dvec3 vectorOf(const std::string& text) {
    glm::dvec3 vector(0);
    std::stringstream(text) >> vector.x >> vector.y >> vector.z;
    return vector;
}

void expectNear(const glm::dvec3& is, const glm::dvec3& should) {
    // Of coordinates that are parts of 32767 or sums of products.
    EXPECT_LT(glm::distance(is, should), 1e-4) << is.x << ' ' << is.y << ' ' << is.z;
}

TEST(MeshCorpus, EachFileBecomesWhatItSays) {
    const std::string corpus = GRSH_CORPUS;
    const std::vector<Row> rows = rowsOf(corpus + "/meshes.txt");
    ASSERT_GT(rows.size(), 60u);
    for (const auto& [cells] : rows) {
        SCOPED_TRACE(cells[0]);
        MeshFiles files;
        MeshRepairs repairs;
        std::shared_ptr<const Polyhedron> mesh;
        const std::string error =
            errorOf([&] { mesh = files.read(corpus + "/meshes/" + cells[0], cells[0], repairs); });
        if (cells.size() == 2) {
            EXPECT_EQ(error.substr(std::min(error.find("\": ") + 3, error.size())), cells[1]);
            continue;
        }
        ASSERT_GE(cells.size(), 6u);
        ASSERT_NE(mesh, nullptr) << error;
        EXPECT_EQ(std::to_string(mesh->triangleCount()), cells[1]);
        expectNear(mesh->origin() + glm::dvec3(mesh->bounds().low), vectorOf(cells[2]));
        expectNear(mesh->origin() + glm::dvec3(mesh->bounds().high), vectorOf(cells[3]));
        EXPECT_NEAR(areaOf(*mesh), std::stod(cells[4]), 1e-4);
        EXPECT_NEAR(volumeOf(*mesh), std::stod(cells[5]), 1e-4);
        EXPECT_EQ(knownOf(*mesh), cells.size() > 6 ? cells[6] : "");
        EXPECT_EQ(repairs.text(), cells.size() > 7 ? cells[7] : "");
    }
}

TEST(MeshCorpus, EachFileHasALine) {
    const std::string corpus = GRSH_CORPUS;
    std::set<std::string> named{"a buffer.bin"};  // which percent.gltf names
    for (const auto& [cells] : rowsOf(corpus + "/meshes.txt")) named.insert(cells[0]);
    for (const auto& entry : std::filesystem::directory_iterator(corpus + "/meshes"))
        EXPECT_TRUE(named.contains(entry.path().filename())) << entry.path();
}

}  // namespace
}  // namespace gr
