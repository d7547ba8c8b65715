#include "render/transport/media.h"

#include "gr/solid.h"

#include <algorithm>

namespace render {

float Media::indexBeyond(const materials::Interior& interior, bool enters) const {
    if (enters) return interior.index;
    const bool staysInside = inside_.empty() || inside_.back() != &interior;
    if (staysInside) return index();
    return inside_.size() == 1 ? 1.f : inside_[inside_.size() - 2]->index;
}

void Media::cross(const materials::Interior& interior, bool enters) {
    if (enters) {
        inside_.push_back(&interior);
        return;
    }
    const auto last = std::find(inside_.rbegin(), inside_.rend(), &interior);
    if (last != inside_.rend()) inside_.erase(std::next(last).base());
}

void Media::meetFromInside(const materials::Interior& interior) {
    if (std::find(inside_.begin(), inside_.end(), &interior) == inside_.end()) inside_.push_back(&interior);
}

namespace {

// One time that a point is in a solid.
struct Stay {
    double exit;  // how far along the ray it ends
    const materials::Interior* interior;
};

// A ray's crossings of one solid come to this: each exit that no entry before it makes up for ends a stay at the ray's
// start.
void addStays(std::vector<gr::SolidCrossing>& crossings, const materials::Interior& interior,
              std::vector<Stay>& stays) {
    const auto isFarther = [](const auto& a, const auto& b) { return a.t > b.t; };
    std::sort(crossings.begin(), crossings.end(), isFarther);
    const std::size_t first = stays.size();
    for (const gr::SolidCrossing& crossing : crossings) {
        if (!crossing.enters)
            stays.push_back({crossing.t, &interior});
        else if (stays.size() > first)
            stays.pop_back();
    }
}

}  // namespace

Media mediaAt(const core::Vec3f& point, const gr::Scene& scene) {
    const core::Vec3f anyDirection(0.48f, 0.64f, 0.6f);
    std::vector<Stay> stays;
    std::vector<gr::SolidCrossing> crossings;
    for (const gr::Instance& instance : scene.instances) {
        const materials::Interior* interior = scene.interiorOf(instance.material);
        if (interior == nullptr || instance.isOperand) continue;
        crossings.clear();
        gr::addCrossings(scene, instance, {point, anyDirection}, crossings);
        addStays(crossings, *interior, stays);
    }
    // What is left last was entered first.
    std::stable_sort(stays.begin(), stays.end(), [](const Stay& a, const Stay& b) { return a.exit > b.exit; });
    Media media;
    for (const Stay& stay : stays) media.cross(*stay.interior, true);
    return media;
}

}  // namespace render
