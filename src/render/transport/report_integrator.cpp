#include "core/frame.h"
#include "materials/material.h"
#include "render/transport/eye_media.h"
#include "render/transport/integrator.h"

#include <variant>

namespace render {
namespace {

using core::Rayf;
using core::Rgbf;
using core::Vec3f;
using materials::BsdfSample;
using materials::Interior;

bool isAnisotropic(const materials::Material& material) {
    return std::visit([](const auto& m) { return m.isAnisotropic(); }, material);
}

// A surface point as the path sees it: the normals are turned to where the path comes from.
struct ShadingPoint {
    const materials::Material& material;
    gr::SurfacePoint<float> surface;
    core::TextureValues<float> textures;  // of the material, where it has some
    bool fromOutside;
    Vec3f normal;
    core::Frame<float> frame;  // round the shading normal
    Vec3f wo;  // back along the path, in the frame
    materials::Bsdf<float> bsdf;  // what the material is here
    const Interior* interior;  // null for what is opaque: there both sides are alike

    ShadingPoint(const gr::Scene& scene, const Rayf& ray, const gr::Hit& hit)
        : material(scene.materials[scene.instances[hit.instance].material]),
          surface(scene.surfaceAt(ray, hit, scene.hasTextures() || isAnisotropic(material))),
          textures(valuesAt(scene, hit)),
          fromOutside(glm::dot(ray.direction, surface.normal) < 0),
          normal(fromOutside ? surface.normal : -surface.normal),
          frame(frameRound(fromOutside ? surface.shadingNormal : -surface.shadingNormal)),
          wo(frame.toLocal(-ray.direction)),
          bsdf(materials::bsdfAt<float>(material, *this)),
          interior(scene.interiorOf(scene.instances[hit.instance].material)) {}

    // f * |cos| towards light in a direction of the world.
    Rgbf eval(const Vec3f& direction) const {
        const Vec3f wi = frame.toLocal(direction);
        return std::visit([&](const auto& b) { return b.eval(wo, wi); }, bsdf);
    }
    // One of the material's ways to go on, and a direction that it takes.
    BsdfSample<float> sample(Sampler& sampler, const Media& media) const {
        const float method = sampler.next1D();
        const core::Vec2f place = sampler.next2D();
        const float indexBeyond = interior == nullptr ? 1 : media.indexBeyond(*interior, fromOutside) / media.index();
        return std::visit([&](const auto& b) { return b.sample(wo, {method, place}, indexBeyond); }, bsdf);
    }
    // Whether light that goes through the surface as it is shaded would stay on this side of it as it lies.
    bool staysOutside(const Vec3f& wi) const {
        return surface.isSmooth && wi.z < 0 && glm::dot(frame.toWorld(wi), normal) > 0;
    }
    // Where a ray starts that is reflected.
    Vec3f startAbove() const { return surface.liftedOffset(normal); }
    // The ray that goes on in direction wi of the frame.
    Rayf rayTowards(const Vec3f& wi) const {
        return {wi.z < 0 ? surface.offset(-normal) : startAbove(), frame.toWorld(wi)};
    }
    bool isLight() const { return surface.light >= 0; }
    // A light reflects nothing.
    Rgbf albedo() const {
        if (isLight()) return Rgbf(0);
        return std::visit([&](const auto& m) { return m.template albedo<float>(*this); }, material);
    }
    Rgbf ambientReflectance() const {
        return std::visit([&](const auto& m) { return m.template ambientReflectance<float>(*this); }, material);
    }

private:
    core::TextureValues<float> valuesAt(const gr::Scene& scene, const gr::Hit& hit) const {
        core::TextureValues<float> values;
        if (!scene.hasTextures()) return values;
        const materials::TexturePlace<float> place{surface.uv, surface.inNode, surface.position + Vec3f(scene.origin)};
        for (const materials::TextureUse& use : scene.textures[scene.instances[hit.instance].material])
            values.slots[use.slot] = use.at<float>(place);
        return values;
    }
    core::Frame<float> frameRound(const Vec3f& z) const {
        return isAnisotropic(material) ? core::Frame<float>(z, surface.tangent) : core::Frame<float>(z);
    }
};

void count(RayCounts& rays, const BsdfSample<float>& sample) {
    ++(sample.wi.z < 0 ? rays.refractive : sample.isDiffuse ? rays.diffuse : rays.reflective);
}

class ReportIntegrator final : public ScalarIntegrator {
public:
    ReportIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator, const RenderSettings& settings,
                     const Rgbf& ambient, const RayStarts& starts)
        : scene_(scene),
          accelerator_(accelerator),
          pathLength_(settings.globalIllumination ? settings.pathLength : 1),
          lightSamples_(settings.samplesPerLightSource),
          background_(settings.background),
          ambient_(ambient),
          eyeMedia_(scene, starts) {}

    Rgbf radiance(const Rayf& cameraRay, Sampler& sampler, RayCounts& rays, FirstSurface* first) const override {
        Rgbf radiance(0);
        Rgbf throughput(1);  // what is left of light that comes along `ray`, when it arrives at the eye
        Rayf ray = cameraRay;
        Media media = eyeMedia_.at(cameraRay.origin);
        bool countsEmission = true;  // false after a bounce for which lights were sampled already
        ++rays.camera;
        for (int surfacePoints = 1;; ++surfacePoints) {
            // Find the nearest surface; a path that leaves the scene ends in what lies beyond.
            const std::optional<gr::Hit> hit = accelerator_.intersect(ray, rays.traversal);
            if (!hit) {
                const Rgbf beyond = countsEmission ? background_ + fromBeyond(ray.direction) : background_;
                return radiance + throughput * media.transmittance(core::infinity) * beyond;
            }
            const ShadingPoint point(scene_, ray, *hit);
            if (surfacePoints == 1 && first != nullptr) *first = {hit->t, point.albedo(), point.frame.z};

            // On the way there a medium absorbs.
            if (point.interior != nullptr && !point.fromOutside) media.meetFromInside(*point.interior);
            throughput *= media.transmittance(hit->t);

            // A path ends at a light. Its back is dark.
            if (point.isLight()) {
                const gr::AreaLight& light =
                    scene_.lights.of<gr::AreaLight>()[static_cast<std::size_t>(point.surface.light)];
                if (point.fromOutside && countsEmission) radiance += throughput * light.emitted();
                return radiance;
            }

            // Add the light that comes straight from the lights.
            radiance += throughput * directLight(point, media, sampler, rays);
            if (surfacePoints == pathLength_) return radiance + throughput * ambient_ * point.ambientReflectance();

            // Go on in a direction drawn by the material.
            const BsdfSample<float> next = point.sample(sampler, media);
            if (!next.valid || point.staysOutside(next.wi)) return radiance;
            throughput *= next.weight;
            if (throughput == Rgbf(0)) return radiance;
            countsEmission = !next.isLit;
            if (next.wi.z < 0 && point.interior != nullptr) media.cross(*point.interior, point.fromOutside);
            ray = point.rayTowards(next.wi);
            count(rays, next);
        }
    }

private:
    Rgbf directLight(const ShadingPoint& point, const Media& media, Sampler& sampler, RayCounts& rays) const {
        Rgbf sum(0);
        const Vec3f start = point.startAbove();
        scene_.lights.forEach([&]<class Light>(const Light& light) {
            // The mean of M samples, each of them f * cos * radiance / pdf. Where all would be alike one will do.
            const int samples = Light::hasPlaces ? lightSamples_ : 1;
            Rgbf lightSum(0);
            for (int i = 0; i < samples; ++i) {
                const core::Vec2f u = Light::hasPlaces ? sampler.next2D() : core::Vec2f(0);
                const gr::LightSample<float> sample = light.sample(point.surface.lifted, u);
                lightSum += reflected(point, media, sample, gr::shadowRay(start, light, sample.target), rays);
            }
            sum += lightSum / static_cast<float>(samples);
        });
        return sum;
    }

    // What endless lights send along a ray that meets nothing.
    Rgbf fromBeyond(const Vec3f& direction) const {
        Rgbf sum(0);
        scene_.lights.forEach([&]<class Light>(const Light& light) {
            if constexpr (Light::isEndless && Light::canBeMet) sum += light.seen(direction).radiance;
        });
        return sum;
    }

    // What the surface reflects of a light sample towards the eye, black where something stands between.
    Rgbf reflected(const ShadingPoint& point, const Media& media, const gr::LightSample<float>& sample,
                   const Rayf& shadowRay, RayCounts& rays) const {
        const Rgbf light = point.eval(sample.wi) * sample.weight;
        if (light == Rgbf(0)) return light;
        ++rays.shadow;
        if (accelerator_.occluded(shadowRay, rays.traversal)) return Rgbf(0);
        return light * media.transmittance(glm::length(shadowRay.direction) * shadowRay.tMax);
    }

    const gr::Scene& scene_;
    const gr::Accelerator& accelerator_;
    int pathLength_;
    int lightSamples_;
    Rgbf background_;
    Rgbf ambient_;
    EyeMedia eyeMedia_;
};

}  // namespace

std::unique_ptr<ScalarIntegrator> makeReportIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator,
                                                       const RenderSettings& settings, const Rgbf& ambient,
                                                       const RayStarts& starts) {
    return std::make_unique<ReportIntegrator>(scene, accelerator, settings, ambient, starts);
}

}  // namespace render
