#include "gr/many_rays.h"

#include <algorithm>

namespace gr {
namespace {

// Half of a box's surface.
double surface(const core::Bounds& box) {
    const glm::dvec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Takes the object with the largest box out of `bodies`, if it is a fair part of the box round all: in a tree nearly
// every ray would have to be tested against it, too, but one by one. boxes: of the bodies. Returns whether it did.
bool takeLargest(Scene& scene, std::vector<core::Bounds>& boxes) {
    constexpr double fairPart = 0.125;
    core::Bounds all;
    double most = 0;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        all.include(boxes[i]);
        if (isOneByOne(scene.instances[scene.bodies[i]].shape) || surface(boxes[i]) <= most) continue;
        most = surface(boxes[i]);
        largest = i;
    }
    if (most == 0 || most < fairPart * surface(all)) return false;
    scene.large.push_back(scene.bodies[largest]);
    scene.bodies.erase(scene.bodies.begin() + static_cast<std::ptrdiff_t>(largest));
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(largest));
    return true;
}

}  // namespace

void sortForManyRays(Scene& scene, const std::vector<core::Bounds>& all) {
    constexpr std::size_t mostLarge = 12;
    scene.faces = facesOf(scene);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        if (scene.instances[i].isOperand) continue;
        if (isEndless(scene.instances[i].shape))
            scene.large.push_back(i);
        else if (scene.faces.isFlat.empty() || !scene.faces.isFlat[i])
            scene.bodies.push_back(i);
    }
    std::vector<core::Bounds> boxes(scene.bodies.size());
    std::transform(scene.bodies.begin(), scene.bodies.end(), boxes.begin(), [&](std::uint32_t i) { return all[i]; });
    for (std::size_t taken = 0; taken < mostLarge && takeLargest(scene, boxes);) ++taken;
    std::sort(scene.large.begin(), scene.large.end());
}

}  // namespace gr
