#include "image/flip.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace image {
namespace {

using core::Rgbf;
using Kernel = std::vector<double>;  // from -radius to radius
using Plane = std::vector<float>;

// XYZ of linear sRGB, and back (IEC 61966-2-1). Its white is (1, 1, 1).
const glm::dmat3 xyzFromRgb = glm::transpose(glm::dmat3(0.4123907993, 0.3575843394, 0.1804807884,  //
                                                        0.2126390059, 0.7151686788, 0.0721923154,  //
                                                        0.0193308187, 0.1191947798, 0.9505321522));
const glm::dmat3 rgbFromXyz = glm::inverse(xyzFromRgb);
const glm::dvec3 white = xyzFromRgb * glm::dvec3(1);

// The opponent space in which contrast is filtered: luminance, red-green and blue-yellow.
glm::dvec3 opponentOf(const glm::dvec3& rgb) {
    const glm::dvec3 t = xyzFromRgb * rgb / white;
    return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}
glm::dvec3 rgbOf(const glm::dvec3& opponent) {
    const double y = (opponent.x + 16) / 116;
    return rgbFromXyz * (glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200) * white);
}

// CIELAB, with colours the weaker the darker they are: the Hunt effect.
glm::dvec3 huntLabOf(const glm::dvec3& rgb) {
    const auto f = [](double t) {
        constexpr double delta = 6. / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4. / 29;
    };
    const glm::dvec3 t = xyzFromRgb * rgb / white;
    const double lightness = 116 * f(t.y) - 16;
    return {lightness, 0.01 * lightness * 500 * (f(t.x) - f(t.y)), 0.01 * lightness * 200 * (f(t.y) - f(t.z))};
}

// The distance HyAB.
double distance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// From 0 to 1: small differences get most of the room.
double colourDifference(const glm::dvec3& a, const glm::dvec3& b) {
    constexpr double exponent = 0.7, knee = 0.4, kneeHeight = 0.95;
    static const double largest =
        std::pow(distance(huntLabOf(glm::dvec3(0, 1, 0)), huntLabOf(glm::dvec3(0, 0, 1))), exponent);
    const double d = std::pow(distance(huntLabOf(a), huntLabOf(b)), exponent), bend = knee * largest;
    return d < bend ? d * kneeHeight / bend : kneeHeight + (d - bend) / (largest - bend) * (1 - kneeHeight);
}

Kernel kernelOf(int radius, const std::function<double(double)>& value) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) kernel.push_back(value(x));
    return kernel;
}

// Positive values sum to 1, and negative ones to -1.
Kernel normalised(Kernel kernel) {
    double positive = 0, negative = 0;
    for (const double x : kernel) (x > 0 ? positive : negative) += std::abs(x);
    for (double& x : kernel) x /= x > 0 ? positive : negative;
    return kernel;
}

double sum(const Kernel& kernel) {
    double all = 0;
    for (const double x : kernel) all += x;
    return all;
}

// Beyond an edge the picture goes on as it is there.
class Filter {
public:
    Filter(int width, int height) : width_(width), height_(height) {}

    Plane operator()(const Plane& plane, const Kernel& across, const Kernel& down) const {
        Plane between(plane.size()), filtered(plane.size());
        pass(plane, between, across, 1, 0);
        pass(between, filtered, down, 0, 1);
        return filtered;
    }

private:
    void pass(const Plane& from, Plane& to, const Kernel& kernel, int dx, int dy) const {
        const int radius = static_cast<int>(kernel.size() / 2);
        core::parallelFor(height_, core::threadCount(0), [&](int y) {
            for (int x = 0; x < width_; ++x) {
                double value = 0;
                for (int i = -radius; i <= radius; ++i)
                    value +=
                        kernel[static_cast<std::size_t>(i + radius)] *
                        static_cast<double>(
                            from[at(std::clamp(x + i * dx, 0, width_ - 1), std::clamp(y + i * dy, 0, height_ - 1))]);
                to[at(x, y)] = static_cast<float>(value);
            }
        });
    }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_, height_;
};

// A picture as the eye has it: what is too fine to be seen is gone.
class Seen {
public:
    Seen(std::span<const Rgbf> picture, const Filter& filter, double pixelsPerDegree) {
        for (Plane& plane : opponent_) plane.resize(picture.size());
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const glm::dvec3 value = opponentOf(glm::clamp(glm::dvec3(picture[i]), 0., 1.));
            for (int axis = 0; axis < 3; ++axis) opponent_[axis][i] = static_cast<float>(value[axis]);
        }
        findFeatures(filter, pixelsPerDegree);
        filterContrast(filter, pixelsPerDegree);
    }

    glm::dvec3 rgb(std::size_t pixel) const {
        const glm::dvec3 opponent(opponent_[0][pixel], opponent_[1][pixel], opponent_[2][pixel]);
        return glm::clamp(rgbOf(opponent), 0., 1.);
    }
    double edge(std::size_t pixel) const { return edge_[pixel]; }
    double point(std::size_t pixel) const { return point_[pixel]; }

private:
    // First and second derivatives of a Gaussian as wide as the eye detects features.
    void findFeatures(const Filter& filter, double pixelsPerDegree) {
        const double deviation = 0.5 * 0.082 * pixelsPerDegree;
        const int radius = static_cast<int>(std::ceil(3 * deviation));
        const auto gauss = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
        const Kernel smooth = normalised(kernelOf(radius, gauss));
        Plane luminance = opponent_[0];
        for (float& y : luminance) y = (y + 16) / 116;
        const auto gradient = [&](const Kernel& kernel) {
            Plane length = filter(luminance, kernel, smooth);
            const Plane down = filter(luminance, smooth, kernel);
            for (std::size_t i = 0; i < length.size(); ++i) length[i] = std::hypot(length[i], down[i]);
            return length;
        };
        edge_ = gradient(normalised(kernelOf(radius, [&](double x) { return -x * gauss(x); })));
        point_ = gradient(
            normalised(kernelOf(radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gauss(x); })));
    }

    // The eye's contrast sensitivity, as sums of Gaussians.
    void filterContrast(const Filter& filter, double pixelsPerDegree) {
        struct Gaussian {
            double amplitude, width;
        };
        constexpr Gaussian sensitivity[3][2] = {{{1, 0.0047}, {}}, {{1, 0.0053}, {}}, {{34.1, 0.04}, {13.5, 0.025}}};
        constexpr double pi = core::pi, widest = 0.04;
        const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixelsPerDegree));
        for (int axis = 0; axis < 3; ++axis) {
            Plane filtered(opponent_[axis].size());
            double weights = 0;
            for (const auto& [amplitude, spread] : sensitivity[axis]) {
                const double width = spread;
                if (amplitude == 0) continue;
                const Kernel kernel = kernelOf(radius, [&](double x) {
                    const double degrees = x / pixelsPerDegree;
                    return std::exp(-pi * pi * degrees * degrees / width);
                });
                const double weight = amplitude * std::sqrt(pi / width), weightSum = weight * sum(kernel) * sum(kernel);
                const Plane part = filter(opponent_[axis], kernel, kernel);
                for (std::size_t i = 0; i < part.size(); ++i) filtered[i] += static_cast<float>(weight) * part[i];
                weights += weightSum;
            }
            for (float& value : filtered) value /= static_cast<float>(weights);
            opponent_[axis] = std::move(filtered);
        }
    }

    Plane opponent_[3];
    Plane edge_, point_;
};

}  // namespace

std::vector<float> flip(std::span<const Rgbf> reference, std::span<const Rgbf> test, int width, int height,
                        double pixelsPerDegree) {
    const Filter filter(width, height);
    const Seen a(reference, filter, pixelsPerDegree), b(test, filter, pixelsPerDegree);
    std::vector<float> differences(reference.size());
    core::parallelFor(height, core::threadCount(0), [&](int y) {
        const std::size_t line = static_cast<std::size_t>(width), start = static_cast<std::size_t>(y) * line;
        for (std::size_t i = start; i < start + line; ++i) {
            const double colour = colourDifference(a.rgb(i), b.rgb(i));
            const double feature =
                std::max(std::abs(a.edge(i) - b.edge(i)), std::abs(a.point(i) - b.point(i))) / std::sqrt(2.);
            differences[i] = static_cast<float>(std::pow(colour, 1 - std::sqrt(std::clamp(feature, 0., 1.))));
        }
    });
    return differences;
}

}  // namespace image
