#include "gr/mesh/heightfield.h"

#include <cmath>

namespace gr {
namespace {

class Heightfield {
public:
    explicit Heightfield(const HeightGrid& grid) : grid_(grid) {
        const std::size_t points = grid.heights.size();
        mesh_.vertices.resize(points);
        normals_.resize(points);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) setPoint(column, row);
    }

    FlatMesh made() && {
        const std::size_t corners = 6 * static_cast<std::size_t>(grid_.columns - 1) * (grid_.rows - 1);
        mesh_.corners.reserve(corners);
        mesh_.normals.reserve(corners);
        mesh_.uvs.reserve(corners);
        for (int row = 0; row + 1 < grid_.rows; ++row)
            for (int column = 0; column + 1 < grid_.columns; ++column) addCell(column, row);
        return std::move(mesh_);
    }

private:
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
               static_cast<std::size_t>(column);
    }
    double height(int column, int row) const { return grid_.heights[number(column, row)]; }

    // How steep it is at place i of a line of `count` heights, which reach over a length of 1.
    template<class HeightAt>
    static double slope(int i, int count, const HeightAt& at) {
        const double perUnit = count - 1;
        if (count == 2) return at(1) - at(0);
        if (i == 0) return (-1.5 * at(0) + 2 * at(1) - 0.5 * at(2)) * perUnit;
        if (i == count - 1) return (1.5 * at(i) - 2 * at(i - 1) + 0.5 * at(i - 2)) * perUnit;
        return (at(i + 1) - at(i - 1)) * 0.5 * perUnit;
    }

    void setPoint(int column, int row) {
        const std::size_t i = number(column, row);
        mesh_.vertices[i] = {column / double(grid_.columns - 1), height(column, row), row / double(grid_.rows - 1)};
        const double alongX = slope(column, grid_.columns, [&](int other) { return height(other, row); });
        const double alongZ = slope(row, grid_.rows, [&](int other) { return height(column, other); });
        normals_[i] = packNormal(core::Vec3f(glm::normalize(glm::dvec3(-alongX, 1, -alongZ))));
    }

    void addCell(int column, int row) {
        const int at = static_cast<int>(number(column, row));
        const int northWest = at, northEast = at + 1, southWest = at + grid_.columns, southEast = southWest + 1;
        const auto steepness = [&](int a, int b) { return std::abs(grid_.heights[a] - grid_.heights[b]); };
        if (steepness(northWest, southEast) <= steepness(northEast, southWest)) {
            addTriangle(northWest, southWest, southEast);
            addTriangle(northWest, southEast, northEast);
        } else {
            addTriangle(northWest, southWest, northEast);
            addTriangle(northEast, southWest, southEast);
        }
    }
    void addTriangle(int a, int b, int c) {
        for (const int vertex : {a, b, c}) {
            mesh_.corners.push_back(vertex);
            mesh_.normals.push_back(normals_[vertex]);
            const glm::dvec3& place = mesh_.vertices[vertex];
            mesh_.uvs.push_back({static_cast<float>(place.x), static_cast<float>(1 - place.z)});
        }
    }

    const HeightGrid& grid_;
    std::vector<PackedNormal> normals_;  // of each vertex
    FlatMesh mesh_;
};

}  // namespace

FlatMesh heightfieldMesh(const HeightGrid& grid) {
    return Heightfield(grid).made();
}

}  // namespace gr
