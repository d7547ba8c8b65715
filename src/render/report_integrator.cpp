#include "core/frame.h"
#include "render/integrator.h"

namespace render {
namespace {

using core::Rayf;
using core::Rgbf;
using core::Vec3f;

// A surface point as the path sees it: the normal is turned to where the path comes from, so that opaque surfaces
// have two sides.
struct ShadingPoint {
    gr::SurfacePoint surface;
    core::Frame<float> frame;
    Vec3f wo;  // back along the path, in the frame

    ShadingPoint(const gr::SurfacePoint& surface, const Vec3f& direction)
        : surface(surface),
          frame(glm::dot(direction, surface.normal) < 0 ? surface.normal : -surface.normal),
          wo(frame.toLocal(-direction)) {}
};

Rgbf evalBsdf(const ShadingPoint& point, const Vec3f& wi) {
    return std::visit([&](const auto& bsdf) { return bsdf.template eval<float>(point.wo, wi); },
                      *point.surface.material);
}

materials::BsdfSample<float> sampleBsdf(const ShadingPoint& point, const core::Vec2f& u) {
    return std::visit([&](const auto& bsdf) { return bsdf.template sample<float>(point.wo, u); },
                      *point.surface.material);
}

class ReportIntegrator final : public Integrator {
public:
    ReportIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator, const RenderSettings& settings,
                     const Rgbf& ambient)
        : scene_(scene),
          accelerator_(accelerator),
          pathLength_(settings.globalIllumination ? settings.pathLength : 1),
          lightSamples_(settings.samplesPerLightSource),
          background_(settings.background),
          ambient_(ambient) {}

    Rgbf radiance(const Rayf& cameraRay, Sampler& sampler, RayCounts& rays) const override {
        Rgbf radiance(0);
        Rgbf throughput(1);  // what is left of light that comes along `ray`, when it arrives at the eye
        Rayf ray = cameraRay;
        bool countsEmission = true;  // false after a bounce for which lights were sampled already
        ++rays.camera;
        for (int surfacePoints = 1;; ++surfacePoints) {
            // Find the nearest surface; a path that leaves the scene ends in the background.
            const std::optional<gr::Hit> hit = accelerator_.intersect(ray);
            if (!hit) return radiance + throughput * background_;
            const gr::SurfacePoint surface = scene_.surfaceAt(ray, *hit);

            // A path ends at a light. Its back is dark.
            if (surface.light != nullptr) {
                const bool emits = glm::dot(ray.direction, surface.normal) < 0;
                if (emits && countsEmission) radiance += throughput * surface.light->radiance;
                return radiance;
            }

            // Add the light that comes straight from the lights.
            const ShadingPoint point(surface, ray.direction);
            radiance += throughput * directLight(point, sampler, rays);
            if (surfacePoints == pathLength_) return radiance + throughput * ambientLight(point);

            // Go on in a direction drawn by the material.
            const core::Vec2f u = sampler.next2D();
            const materials::BsdfSample<float> next = sampleBsdf(point, u);
            if (!next.valid) return radiance;
            throughput *= next.weight;
            countsEmission = next.isDelta;
            ray = {surface.offset(point.frame.z), point.frame.toWorld(next.wi)};
            ++rays.diffuse;
        }
    }

private:
    Rgbf directLight(const ShadingPoint& point, Sampler& sampler, RayCounts& rays) const {
        Rgbf sum(0);
        const Vec3f start = point.surface.offset(point.frame.z);
        for (const gr::AreaLight& light : scene_.areaLights) {
            // The mean of M samples, each of them f * cos * radiance / pdf.
            Rgbf lightSum(0);
            for (int i = 0; i < lightSamples_; ++i) {
                const core::Vec2f u = sampler.next2D();
                const gr::LightSample<float> sample = light.sample<float>(point.surface.position, u);
                lightSum += reflected(point, sample, scene_.shadowRay(start, light, sample.target), rays);
            }
            sum += lightSum / static_cast<float>(lightSamples_);
        }
        for (const gr::PointLight& light : scene_.pointLights) {
            const gr::LightSample<float> sample = light.sample<float>(point.surface.position);
            sum += reflected(point, sample, {start, sample.target - start, 1.f}, rays);
        }
        return sum;
    }

    // What the surface reflects of a light sample towards the eye, black where something stands between.
    Rgbf reflected(const ShadingPoint& point, const gr::LightSample<float>& sample, const Rayf& shadowRay,
                   RayCounts& rays) const {
        const Vec3f wi = point.frame.toLocal(sample.wi);
        const Rgbf light = evalBsdf(point, wi) * std::abs(wi.z) * sample.weight;
        if (light == Rgbf(0)) return light;
        ++rays.shadow;
        return accelerator_.occluded(shadowRay) ? Rgbf(0) : light;
    }

    Rgbf ambientLight(const ShadingPoint& point) const {
        return ambient_ *
               std::visit([](const auto& bsdf) { return bsdf.ambientReflectance(); }, *point.surface.material);
    }

    const gr::Scene& scene_;
    const gr::Accelerator& accelerator_;
    int pathLength_;
    int lightSamples_;
    Rgbf background_;
    Rgbf ambient_;
};

}  // namespace

std::unique_ptr<Integrator> makeReportIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator,
                                                 const RenderSettings& settings, const Rgbf& ambient) {
    return std::make_unique<ReportIntegrator>(scene, accelerator, settings, ambient);
}

}  // namespace render
