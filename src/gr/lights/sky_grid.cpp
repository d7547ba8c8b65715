#include "gr/lights/sky_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace gr {
namespace {

constexpr double steps = 0x1p24;

// What cells before each have together, in multiples of 2^-24; each that has anything gets one of them at least. Where
// all are empty, each the same.
void putSums(std::span<const double> weights, float* sums) {
    const double all = std::accumulate(weights.begin(), weights.end(), 0.);
    const auto shares = static_cast<double>(all > 0 ? std::ranges::count_if(weights, [](double w) { return w > 0; })
                                                    : std::ssize(weights));
    double sum = 0, count = 0;
    for (std::size_t i = 0; i <= weights.size(); ++i) {
        const double part = all > 0 ? std::min(sum / all, 1.) : 0;
        const double whole =
            all > 0 ? count + std::floor((steps - shares) * part + 0.5) : std::floor(count / shares * steps);
        sums[i] = static_cast<float>((i == weights.size() ? steps : whole) / steps);
        if (i == weights.size()) break;
        sum += weights[i];
        count += all > 0 && weights[i] == 0 ? 0 : 1;
    }
}

}  // namespace

SkyGrid::SkyGrid(int width, int height, std::vector<core::Rgbf> radiances)
    : width_(width), height_(height), radiances_(std::move(radiances)) {
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    float most = 0;
    for (const core::Rgbf& radiance : radiances_) most = std::max(most, core::largestComponent(radiance));
    int exponent = 0;
    std::frexp(most, &exponent);
    unit_ = std::ldexp(1.f, exponent);
    for (core::Rgbf& radiance : radiances_) radiance /= unit_;

    sines_.assign(rows + 2, 0.f);
    for (std::size_t y = 0; y < rows; ++y)
        sines_[y + 1] = static_cast<float>(std::sin(M_PI * (static_cast<double>(y) + 0.5) / height));

    // What each node has, and what the cells between four of them.
    const auto weightAt = [&](std::size_t line, std::size_t column) {
        const core::Rgbf& c = radiances_[line * columns + column % columns];
        return double{c.x} + c.y + c.z;
    };
    rows_.resize(rows + 2);
    rowDensities_.resize(rows + 1);
    columns_.resize((rows + 1) * (columns + 1));
    std::vector<double> cells(columns), rowWeights(rows + 1), sizes(rows + 1, 1. / height);
    sizes.front() = sizes.back() = 0.5 / height;
    for (std::size_t y = 0; y <= rows; ++y) {
        const std::size_t upper = y > 0 ? y - 1 : 0, lower = std::min(y, rows - 1);
        for (std::size_t x = 0; x < columns; ++x)
            cells[x] = (weightAt(upper, x) + weightAt(upper, x + 1)) * double{sines_[y]} +
                       (weightAt(lower, x) + weightAt(lower, x + 1)) * double{sines_[y + 1]};
        putSums(cells, &columns_[y * (columns + 1)]);
        rowWeights[y] = std::accumulate(cells.begin(), cells.end(), 0.) * sizes[y];
    }
    putSums(rowWeights, rows_.data());
    for (std::size_t y = 0; y <= rows; ++y)
        rowDensities_[y] = static_cast<float>((double{rows_[y + 1]} - double{rows_[y]}) / sizes[y]);

    // A line of pixels fills cos(upper edge) - cos(lower edge) of the sphere's 2.
    mean_ = 0;
    for (std::size_t y = 0; y < rows; ++y) {
        double line = 0;
        for (std::size_t x = 0; x < columns; ++x) line += weightAt(y, x) / 3;
        const double top = M_PI * static_cast<double>(y) / height, bottom = top + M_PI / height;
        mean_ += line / width * (std::cos(top) - std::cos(bottom)) / 2;
    }
}

std::size_t SkyGrid::bytes() const {
    return sizeof(*this) + radiances_.capacity() * sizeof(core::Rgbf) +
           (sines_.capacity() + rows_.capacity() + rowDensities_.capacity() + columns_.capacity()) * sizeof(float);
}

}  // namespace gr
