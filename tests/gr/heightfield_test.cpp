// Heights over a grid: where each lies, normals in closed form, places on a picture.
// Seen to fail with rows along z, with one-sided differences at the border of first order, with v
// downwards, and with all cells cut the same way.
#include "gr/mesh/heightfield.h"

#include "gr/mesh/mesh_repair.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

constexpr double packing = 1e-4;  // what a packed normal is off by, at most

template<class Height>
HeightGrid gridOf(int columns, int rows, const Height& height) {
    HeightGrid grid{columns, rows, {}};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            grid.heights.push_back(height(column / (columns - 1.), row / (rows - 1.)));
    return grid;
}

// Calls function(place, normal, uv) for each corner.
template<class Function>
void forEachCorner(const FlatMesh& mesh, Function&& function) {
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        function(mesh.vertices[mesh.corners[i]], glm::dvec3(unpackNormal(mesh.normals[i])), mesh.uvs[i]);
}

TEST(Heightfield, RowsRunAlongXAndTheFirstIsAtZero) {
    const FlatMesh mesh = heightfieldMesh({3, 2, {1, 2, 3, 4, 5, 6}});
    const std::vector<glm::dvec3> expected{{0, 1, 0}, {0.5, 2, 0}, {1, 3, 0}, {0, 4, 1}, {0.5, 5, 1}, {1, 6, 1}};
    EXPECT_EQ(mesh.vertices, expected);
    EXPECT_EQ(mesh.faceCount(), 4);
    forEachCorner(mesh, [](const glm::dvec3& place, const glm::dvec3&, const core::Vec2f& uv) {
        EXPECT_EQ(uv, core::Vec2f(static_cast<float>(place.x), static_cast<float>(1 - place.z)));
    });
}

TEST(Heightfield, OfAPlaneIsThatPlane) {
    for (const auto& [columns, rows] : {std::pair(2, 2), {2, 5}, {7, 4}}) {
        const FlatMesh mesh =
            heightfieldMesh(gridOf(columns, rows, [](double x, double z) { return 2 + 0.5 * x - 0.25 * z; }));
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, 1, 0.25));
        double area = 0;
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const glm::dvec3 ofFace = faceNormal(mesh.vertices, mesh.face(f));
            EXPECT_LT(glm::distance(glm::normalize(ofFace), normal), 1e-12);
            area += glm::length(ofFace) / 2;
        }
        EXPECT_NEAR(area, std::sqrt(1 + 0.25 + 0.0625), 1e-12);
        forEachCorner(mesh, [&](const glm::dvec3&, const glm::dvec3& given, const core::Vec2f&) {
            EXPECT_LT(glm::distance(given, normal), packing);
        });
    }
}

// Differences of the second order are exact for it, at the border, too.
TEST(Heightfield, OfAParabolaHasItsNormals) {
    const auto height = [](double x, double z) { return x * x - 2 * z * z + 0.5 * x; };
    forEachCorner(heightfieldMesh(gridOf(9, 6, height)),
                  [](const glm::dvec3& place, const glm::dvec3& normal, const core::Vec2f&) {
                      const glm::dvec3 expected(-(2 * place.x + 0.5), 1, 4 * place.z);
                      EXPECT_LT(glm::distance(normal, glm::normalize(expected)), packing);
                  });
}

// A crease across cells is not cut into teeth, whichever way it runs: every face is level or on the slope.
TEST(Heightfield, CutsCellsAlongTheLessSteepDiagonal) {
    for (const double sign : {1., -1.}) {
        const FlatMesh mesh =
            heightfieldMesh(gridOf(5, 5, [&](double x, double z) { return std::max(0., x - 0.5 + sign * (z - 0.5)); }));
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const glm::dvec3 normal = faceNormal(mesh.vertices, mesh.face(f));
            EXPECT_NEAR(normal.z, sign * normal.x, 1e-12);
        }
    }
}

TEST(Heightfield, IsMadeAsItIs) {
    MeshRepairs repairs;
    const auto made =
        Polyhedron::make(heightfieldMesh(gridOf(40, 30, [](double x, double z) { return x * z; })), repairs);
    EXPECT_EQ(repairs.text(), "");
    EXPECT_EQ(made->triangleCount(), 2u * 39 * 29);
    EXPECT_TRUE(made->hasNormals());
}

}  // namespace
}  // namespace gr
