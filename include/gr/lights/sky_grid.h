// A sky of radiances, as a picture has them, and how directions are drawn in proportion to its brightness: by
// inversion, row first and then column, so that numbers that are spread evenly make directions that are (Pharr, Jakob
// and Humphreys, "Physically Based Rendering", 4th ed., 12.5 and A.5; there cells are even, here they are bilinear).
#pragma once

#include "core/vec.h"

#include <cstddef>
#include <vector>

namespace gr {

// A place of the picture is (u, v), both from 0 to 1: u to the right, v downwards; u goes once round. The radiance is
// bilinear between the middles of the pixels, which are the nodes, round the edge on the left and right too; above the
// uppermost nodes, and below the lowest, it is theirs.
//
// A place is drawn with a density over (u, v) in proportion to the bilinear function that has at the nodes the radiance
// (its channels' mean) times the sine of the angle from above, and 0 at the poles: over solid angle that is about the
// radiance. It consists of cells, each between four nodes: how likely they are is a table, in whole multiples of 2^-24,
// as many bits as a random number has; within a cell it is linear in v and then in u. No cell in which something shines
// is without a share.
class SkyGrid {
public:
    // What pictures may hold: the most width or height, pixels, and radiance.
    static constexpr int mostSide = 1 << 16;
    static constexpr std::size_t mostPixels = std::size_t{1} << 28;
    static constexpr float mostRadiance = 1e18f;

    // radiances: line after line from above; as many as width * height, each from 0 to mostRadiance, not all 0.
    SkyGrid(int width, int height, std::vector<core::Rgbf> radiances);

    int width() const { return width_; }
    int height() const { return height_; }
    // All others are relative to it: a power of two, so that nothing is rounded. The largest is then between 1/2 and 1.
    float unit() const { return unit_; }
    // The mean of the channels over all directions, in units.
    double mean() const { return mean_; }
    const std::vector<core::Rgbf>& radiances() const { return radiances_; }  // in units
    std::size_t bytes() const;

    template<class Real>
    struct Place {
        Real u, v;
        core::Rgb<Real> radiance;  // there, in units
        Real density;  // with which it is drawn, over (u, v)
    };

    // numbers: uniform in the unit square.
    template<class Real>
    Place<Real> draw(const core::Vec2<Real>& numbers) const {
        using UInt = core::UInt<Real>;
        const Found<Real> row = find(rows_.data(), UInt(0), static_cast<std::uint32_t>(height_) + 1, numbers.y);
        const UInt first = row.cell * UInt(static_cast<std::uint32_t>(width_) + 1);
        const Found<Real> column = find(columns_.data(), first, static_cast<std::uint32_t>(width_), numbers.x);
        const Cell<Real> cell(*this, row.cell, column.cell);
        const Real down = linear(cell.weight[0] + cell.weight[1], cell.weight[2] + cell.weight[3], row.rest);
        const Real right =
            linear(mix(cell.weight[0], cell.weight[2], down), mix(cell.weight[1], cell.weight[3], down), column.rest);
        const Real rowNumber = core::toReal(row.cell);
        const Real top = core::max(rowNumber - Real(0.5f), Real(0)), size = sizeOf(rowNumber);
        const Real u = (core::toReal(column.cell) + Real(0.5f) + right) * Real(1 / static_cast<float>(width_));
        return {core::select(u >= Real(1), u - Real(1), u), (top + down * size) * Real(1 / static_cast<float>(height_)),
                cell.radianceAt(right, down), densityAt(cell, row.cell, column.cell, right, down)};
    }

    // u, v: from 0 to 1.
    template<class Real>
    Place<Real> at(const Real& u, const Real& v) const {
        const Real last(static_cast<float>(width_ - 1)), end(static_cast<float>(height_));
        const Real x = u * Real(static_cast<float>(width_)) - Real(0.5f);
        const Real aroundX = core::select(x < Real(0), x + Real(static_cast<float>(width_)), x);
        const Real column = core::min(core::wholePart(core::max(aroundX, Real(0))), last);
        const Real y = v * end + Real(0.5f);
        const Real row = core::min(core::wholePart(core::max(y, Real(0.5f))), end);
        const Real right = core::min(core::max(aroundX - column, Real(0)), Real(1));
        const Real rest = core::select(row == Real(0), y - Real(0.5f), y - row) / sizeOf(row);
        const Real down = core::min(core::max(rest, Real(0)), Real(1));
        const core::UInt<Real> rowCell = core::toUInt(row), columnCell = core::toUInt(column);
        const Cell<Real> cell(*this, rowCell, columnCell);
        return {u, v, cell.radianceAt(right, down), densityAt(cell, rowCell, columnCell, right, down)};
    }

private:
    template<class Real>
    static Real mix(const Real& a, const Real& b, const Real& t) {
        return a + (b - a) * t;
    }

    // A row of cells lies between two lines of nodes; the first and the last lie beyond them and are half as high. A
    // column of cells begins at a column of nodes.
    template<class Real>
    struct Cell {
        core::Rgb<Real> node[4];  // upper left, upper right, lower left, lower right
        Real weight[4];  // the density there, but for a factor

        Cell(const SkyGrid& grid, const core::UInt<Real>& row, const core::UInt<Real>& column) {
            using UInt = core::UInt<Real>;
            const Real rowNumber = core::toReal(row), columnNumber = core::toReal(column);
            const Real last(static_cast<float>(grid.height_ - 1)), width(static_cast<float>(grid.width_));
            const UInt upper = core::toUInt(core::max(rowNumber - Real(1), Real(0)));
            const UInt lower = core::toUInt(core::min(rowNumber, last));
            const Real next = columnNumber + Real(1);
            const UInt right = core::toUInt(core::select(next < width, next, Real(0)));
            const UInt pixels(static_cast<std::uint32_t>(grid.width_));
            const UInt places[] = {upper * pixels + column, upper * pixels + right, lower * pixels + column,
                                   lower * pixels + right};
            const Real upperSine = core::gather(grid.sines_.data(), row);
            const Real lowerSine = core::gather(grid.sines_.data() + 1, row);
            for (int i = 0; i < 4; ++i) {
                node[i] = core::GatheredRow<Real, core::Rgbf>(grid.radiances_.data(), places[i]).vector(0);
                weight[i] = (node[i].x + node[i].y + node[i].z) * (i < 2 ? upperSine : lowerSine);
            }
        }
        core::Rgb<Real> radianceAt(const Real& right, const Real& down) const {
            const core::Rgb<Real> upper = node[0] + (node[1] - node[0]) * right;
            const core::Rgb<Real> lower = node[2] + (node[3] - node[2]) * right;
            return upper + (lower - upper) * down;
        }
        // Over the cell's own unit square.
        Real densityAt(const Real& right, const Real& down) const {
            const Real sum = weight[0] + weight[1] + weight[2] + weight[3];
            const Real here = mix(mix(weight[0], weight[1], right), mix(weight[2], weight[3], right), down);
            return core::select(sum > Real(0), Real(4) * here / core::max(sum, Real(0x1p-126f)), Real(0));
        }
    };

    template<class Real>
    Real densityAt(const Cell<Real>& cell, const core::UInt<Real>& row, const core::UInt<Real>& column,
                   const Real& right, const Real& down) const {
        const core::UInt<Real> place = row * core::UInt<Real>(static_cast<std::uint32_t>(width_) + 1) + column;
        const Real share = core::gather(columns_.data() + 1, place) - core::gather(columns_.data(), place);
        const Real perWidth = share * Real(static_cast<float>(width_));
        return core::gather(rowDensities_.data(), row) * perWidth * cell.densityAt(right, down);
    }

    // How high a row of cells is, in pixels.
    template<class Real>
    Real sizeOf(const Real& row) const {
        const core::Mask<Real> isHalf = (row == Real(0)) | (row == Real(static_cast<float>(height_)));
        return core::select(isHalf, Real(0.5f), Real(1));
    }

    // Which of a row of cells a number in [0, 1) falls into, and where there, from 0 to 1.
    template<class Real>
    struct Found {
        core::UInt<Real> cell;
        Real rest;
    };
    // sums: from `first` on, one more than there are cells, from 0 to 1.
    template<class Real>
    static Found<Real> find(const float* sums, const core::UInt<Real>& first, std::uint32_t count, const Real& number) {
        using UInt = core::UInt<Real>;
        UInt cell(0);
        Real low(0), high(1);
        for (std::uint32_t step = std::bit_floor(count); step > 0; step /= 2) {
            const UInt next = cell + UInt(step);
            const UInt last(count - 1);
            const core::Mask<Real> isThere = core::isLess(next, UInt(count));
            const Real sum = core::gather(sums, UInt(first + core::selectUInt<Real>(isThere, next, last)));
            cell = core::selectUInt<Real>(isThere & (sum <= number), next, cell);
        }
        low = core::gather(sums, UInt(first + cell));
        high = core::gather(sums + 1, UInt(first + cell));
        // A number stands for all within its step.
        const Real rest = (number - low + Real(0x1p-25f)) / core::max(high - low, Real(0x1p-24f));
        return {cell, core::min(core::max(rest, Real(0)), Real(1))};
    }

    // Where a density that goes from a to b, linear from 0 to 1, has had the part `number` of its whole.
    template<class Real>
    static Real linear(const Real& a, const Real& b, const Real& number) {
        const Real root = core::sqrt(mix(a * a, b * b, number));
        return core::min(number * (a + b) / core::max(a + root, Real(0x1p-126f)), Real(1));
    }

    int width_, height_;
    float unit_;
    double mean_;
    std::vector<core::Rgbf> radiances_;
    std::vector<float> sines_;  // of the angle from above: of the pole, the lines of nodes, and the other pole
    std::vector<float> rows_;  // of the rows of cells: how likely those above them are together
    std::vector<float> rowDensities_;  // how likely each is, over its height in v
    std::vector<float> columns_;  // of each row of cells, one after the other, the same as rows_
};

}  // namespace gr
