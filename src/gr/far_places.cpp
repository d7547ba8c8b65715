#include "gr/far_places.h"

#include "gr/database/node.h"

#include <cmath>
#include <cstdio>

namespace gr {
namespace {

// How far apart the floats are there.
double gridAt(double coordinate) {
    return coordinate == 0 ? 0 : std::ldexp(1, std::ilogb(coordinate) - 23);
}

std::string shortText(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", number);
    return text;
}

}  // namespace

void FarPlaces::note(const Node& node, const Shape& shape, const glm::dmat4& matrix) {
    if (isEndless(shape)) return;
    const core::Bounds box = boundsOf(shape);
    const glm::dvec3 low(box.low), high(box.high), across = high - low;
    const glm::dvec3 middle(matrix * glm::dvec4(0.5 * (low + high), 1));
    glm::dvec3 size(0);
    for (int axis = 0; axis < 3; ++axis) size += glm::abs(glm::dvec3(matrix[axis])) * across[axis];
    constexpr double mostOfSize = 0.01;
    const double grid = gridAt(core::largestComponent(middle)), ratio = grid / core::largestComponent(size);
    if (!(ratio > mostOfSize)) return;
    ++count_;
    if (ratio <= ratio_) return;
    worst_ = &node;
    ratio_ = ratio;
    grid_ = grid;
    distance_ = glm::length(middle);
}

std::string FarPlaces::warning(const glm::dvec3& origin) const {
    if (count_ == 0) return "";
    const std::string kind = std::visit([](const auto& content) { return std::string(content.kind); }, worst_->content);
    std::string text = kind + " \"" + worst_->path() + "\" lies " + shortText(distance_) + " from " +
                       (origin == glm::dvec3(0) ? "the origin" : "the scene's middle") +
                       ", where single precision rounds places to " + shortText(grid_);
    if (count_ > 1) text += "; " + std::to_string(count_ - 1) + " more are as far away for their size";
    return text;
}

}  // namespace gr
