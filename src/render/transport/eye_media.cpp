#include "render/transport/eye_media.h"

#include <algorithm>

namespace render {
namespace {

struct Crossing : gr::SolidCrossing {
    const materials::Interior* interior;
};

bool contains(const core::Bounds& box, const core::Vec3f& point) {
    return !box.intersection({point, point}).isEmpty();
}

}  // namespace

EyeMedia::EyeMedia(const gr::Scene& scene, const RayStarts& starts)
    : scene_(&scene), starts_(starts), media_(mediaAt(starts.eye, scene)) {
    if (starts.isOnePoint()) return;
    for (const gr::Instance& instance : scene.instances) {
        const materials::Interior* interior = scene.interiorOf(instance.material);
        if (interior == nullptr || instance.isOperand) continue;
        gr::NearSolid solid(scene, instance, starts.box);
        if (!solid.isBeyond()) near_.push_back({std::move(solid), interior});
    }
}

// The straight way from the eye crosses the same surfaces as any other.
Media EyeMedia::at(const core::Vec3f& place) const {
    if (scene_ == nullptr || place == starts_.eye) return media_;
    if (!contains(starts_.box, place)) return mediaAt(place, *scene_);
    if (near_.empty()) return media_;
    std::vector<Crossing> way;
    std::vector<gr::SolidCrossing> crossings;
    for (const Near& near : near_) {
        crossings.clear();
        near.solid.addCrossings({starts_.eye, place - starts_.eye, 1.f}, crossings);
        for (const gr::SolidCrossing& crossing : crossings) way.push_back({crossing, near.interior});
    }
    std::stable_sort(way.begin(), way.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    Media media = media_;
    for (const Crossing& crossing : way) media.cross(*crossing.interior, crossing.enters);
    return media;
}

}  // namespace render
