#include "render/media.h"

#include <algorithm>

namespace render {

float Media::indexBeyond(const materials::Dielectric& material, bool enters) const {
    if (enters) return indexOf(&material);
    const bool staysInside = inside_.empty() || inside_.back() != &material;
    if (staysInside) return index();
    return inside_.size() == 1 ? 1.f : indexOf(inside_[inside_.size() - 2]);
}

void Media::cross(const materials::Dielectric& material, bool enters) {
    if (enters) {
        inside_.push_back(&material);
        return;
    }
    const auto last = std::find(inside_.rbegin(), inside_.rend(), &material);
    if (last != inside_.rend()) inside_.erase(std::next(last).base());
}

void Media::meetFromInside(const materials::Dielectric& material) {
    if (std::find(inside_.begin(), inside_.end(), &material) == inside_.end()) inside_.push_back(&material);
}

namespace {

struct Crossing {
    const materials::Dielectric* material;
    bool enters;
};

// The dielectrics' surfaces along a ray, whatever else is in the way, in their order.
std::vector<Crossing> crossings(core::Rayf ray, const gr::Scene& scene, const gr::Accelerator& accelerator,
                                int& rayCount) {
    std::vector<Crossing> found;
    for (;;) {
        ++rayCount;
        const std::optional<gr::Hit> hit = accelerator.intersect(ray);
        if (!hit) return found;
        const gr::SurfacePoint surface = scene.surfaceAt(ray, *hit);
        const bool enters = glm::dot(ray.direction, surface.normal) < 0;
        const auto* dielectric = std::get_if<materials::Dielectric>(surface.material);
        if (dielectric != nullptr && surface.light == nullptr) found.push_back({dielectric, enters});
        ray = {surface.offset(enters ? -surface.normal : surface.normal), ray.direction, ray.tMax - hit->t};
    }
}

}  // namespace

Media mediaAt(const core::Vec3f& point, const gr::Scene& scene, const gr::Accelerator& accelerator) {
    const core::Vec3f anyDirection(0.48f, 0.64f, 0.6f);
    int rays = 0;
    std::vector<Crossing> found = crossings({point, anyDirection}, scene, accelerator, rays);
    // Come back, from outside of everything.
    Media media;
    std::reverse(found.begin(), found.end());
    for (const Crossing& crossing : found) media.cross(*crossing.material, !crossing.enters);
    return media;
}

int goTo(Media& media, const core::Vec3f& from, const core::Vec3f& to, const gr::Scene& scene,
         const gr::Accelerator& accelerator) {
    int rays = 0;
    for (const Crossing& crossing : crossings({from, to - from, 1.f}, scene, accelerator, rays))
        media.cross(*crossing.material, crossing.enters);
    return rays;
}

}  // namespace render
