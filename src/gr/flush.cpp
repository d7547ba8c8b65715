#include "gr/flush.h"

#include "gr/placing.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>

namespace gr {
namespace {

// How far rounding may move the place where rays meet something: 2^-24 of the coordinates on the way there, a few times
// over. This is more.
double beyondRounding(double reach) {
    return 0x1p-19 * reach;
}

// Of what objects touch, the one that asks them to keep the farthest off it. Of many only those are looked at that ask
// most; none of the others asks for more than the last of those.
class Touching {
public:
    // asked: by each instance.
    Touching(const Scene& scene, const std::vector<core::Bounds>& boxes, std::vector<float> asked)
        : boxes_(boxes), asked_(std::move(asked)) {
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            (isEndless(scene.instances[i].shape) ? endless_ : most_).push_back(i);
        if (most_.size() <= mostLookedAt) return;
        const auto isMore = [&](std::uint32_t a, std::uint32_t b) {
            return asked_[a] != asked_[b] ? asked_[a] > asked_[b] : a < b;
        };
        const auto end = most_.begin() + static_cast<std::ptrdiff_t>(mostLookedAt);
        std::partial_sort(most_.begin(), end, most_.end(), isMore);
        most_.erase(end, most_.end());
        last_ = asked_[most_.back()];
    }

    // 0 where it touches nothing. What has no end asks for as much as the object itself, being as far away.
    float askedOf(std::uint32_t object) const {
        const auto touches = [&](std::uint32_t other) {
            return other != object && !boxes_[other].intersection(boxes_[object]).isEmpty();
        };
        float most = std::any_of(endless_.begin(), endless_.end(), touches) ? asked_[object] : last_;
        for (const std::uint32_t other : most_)
            if (touches(other)) most = std::max({most, asked_[other], asked_[object]});
        return most;
    }

private:
    static constexpr std::size_t mostLookedAt = 64;

    const std::vector<core::Bounds>& boxes_;
    const std::vector<float> asked_;
    std::vector<std::uint32_t> most_, endless_;
    float last_ = 0;
};

glm::dmat4 matrixOf(const core::Transform& map) {
    const auto column = [](const core::Vec3f& v, double last) { return glm::dvec4(glm::dvec3(v), last); };
    return {column(map.x, 0), column(map.y, 0), column(map.z, 0), column(map.translation, 1)};
}

// Makes an object larger about its middle, so that each side moves by so much in the world, but by no more than a
// thousandth of half its size. What has no end moves by so much.
void grow(Instance& instance, double by, Scene& scene) {
    constexpr double most = 1. / 1024;
    const glm::dmat4 matrix = matrixOf(instance.place.worldFromObject());
    if (isEndless(instance.shape)) {
        const double length = glm::length(glm::dvec3(matrix[1]));
        placeAt(instance, glm::translate(matrix, glm::dvec3(0, by / length, 0)), scene);
        return;
    }
    const core::Bounds box = boundsOf(instance.shape);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)), half = 0.5 * glm::dvec3(box.size());
    glm::dvec3 factor(1);
    for (int axis = 0; axis < 3; ++axis) {
        const double length = glm::length(glm::dvec3(matrix[axis])) * half[axis];
        if (length > 0) factor[axis] += std::min(by / length, most);
    }
    placeAt(instance, glm::translate(glm::scale(glm::translate(matrix, middle), factor), -middle), scene);
}

// What has no end is cut off only as an operand.
bool mayGrow(const Instance& instance) {
    return !isEndless(instance.shape) || instance.isOperand;
}

}  // namespace

std::vector<float> growTouching(Scene& scene, std::span<const Contact> contacts, std::vector<core::Bounds>& boxes) {
    std::vector<float> grown(boxes.size(), 0);
    for (const Contact& contact : contacts) {
        if (contact.first == contact.second) continue;
        const std::uint32_t pair[] = {contact.first->instance, contact.second->instance};
        // Beyond the gap, and by so much that whatever rounding does they overlap. What has no end has no reach.
        double most = 0;
        for (const std::uint32_t i : pair) most = std::max(most, beyondRounding(double{boxes[i].reach()}));
        const double by = contact.gap + std::min(2 * contact.error, most);
        for (const std::uint32_t i : pair)
            if (scene.interiors[scene.instances[i].material] && mayGrow(scene.instances[i]))
                grown[i] = std::max(grown[i], static_cast<float>(by));
    }
    for (std::size_t i = 0; i < grown.size(); ++i) {
        if (grown[i] == 0) continue;
        grow(scene.instances[i], double{grown[i]}, scene);
        boxes[i] = scene.instances[i].bounds();
    }
    for (const auto& csg : scene.csgs) csg->place(scene);
    return grown;
}

void liftLamps(Scene& scene, std::span<const Lamp> lamps, const std::vector<float>& grown,
               std::vector<core::Bounds>& boxes) {
    if (lamps.empty()) return;
    // Farther than rounding, and farther than an object in whose plane it was has grown.
    std::vector<float> asked(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        asked[i] = static_cast<float>(beyondRounding(boxes[i].reach())) + 2 * grown[i];
    const Touching touching(scene, boxes, asked);
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const float by = touching.askedOf(lamps[i].instance);
        if (by == 0) continue;
        Instance& instance = scene.instances[lamps[i].instance];
        const glm::dmat4 matrix =
            glm::translate(glm::dmat4(1), lampNormal(lamps[i].matrix) * double{by}) * lamps[i].matrix;
        placeAt(instance, matrix, scene);
        AreaLight& light = scene.lights.of<AreaLight>()[i];
        light = lampAt(matrix, light.radiance, instance);
    }
    for (const Lamp& lamp : lamps) boxes[lamp.instance] = scene.instances[lamp.instance].bounds();
}

}  // namespace gr
