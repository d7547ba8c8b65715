// How the light is found that comes along a ray.
#pragma once

#include "gr/scene.h"
#include "render/sampler.h"
#include "render/settings.h"

namespace render {

// The rays that were traced, by what for.
struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;
    std::uint64_t diffuse = 0;
    std::uint64_t reflective = 0;  // mirrored, sharply or not
    std::uint64_t refractive = 0;
    gr::TraversalCounts traversal;

    std::uint64_t total() const { return camera + shadow + diffuse + reflective + refractive; }
    RayCounts& operator+=(const RayCounts& other) {
        camera += other.camera;
        shadow += other.shadow;
        diffuse += other.diffuse;
        reflective += other.reflective;
        refractive += other.refractive;
        traversal += other.traversal;
        return *this;
    }
};

// What a camera ray met first, for the picture's layers.
struct FirstSurface {
    float distance = core::infinity;  // along the ray; infinite where it met nothing
    core::Rgbf albedo{0};  // 0 for a light
    core::Vec3f normal{0};  // the shading normal, in the world, facing the eye

    bool isMet() const { return distance < core::infinity; }
};

class Integrator {
public:
    virtual ~Integrator() = default;

    // One sample of the radiance that arrives at the ray's origin, against its direction. first: where the ray meets
    // something it is told here, unless null.
    virtual core::Rgbf radiance(const core::Rayf& cameraRay, Sampler& sampler, RayCounts& rays,
                                FirstSurface* first) const = 0;
    core::Rgbf radiance(const core::Rayf& cameraRay, Sampler& sampler, RayCounts& rays) const {
        return radiance(cameraRay, sampler, rays, nullptr);
    }
};

// The report's own (section 5.2): plain, scalar, the oracle. Scene and accelerator must outlive it.
// ambient: times R_d, it is added where a path ends because it holds all the surface points it may.
// eye: where camera rays start, or near there; what it is inside of is found once.
std::unique_ptr<Integrator> makeReportIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator,
                                                 const RenderSettings& settings, const core::Rgbf& ambient,
                                                 const core::Vec3f& eye);

}  // namespace render
