// The light that comes to the paths' surface points straight from the lights. A light is found in two ways: a point
// asks it, or a path meets it. Each way counts for its part.
#pragma once

#include "render/lane_paths.h"
#include "render/path_setup.h"

namespace render {

// From which paths draw the directions in which diffuse surfaces send them on.
using PathHemisphere = core::CosineHemisphere;

template<class Real>
class LaneLights {
    using Mask = core::Mask<Real>;
    using Vec3 = core::Vec3<Real>;
    using Rgb = core::Rgb<Real>;
    using Draw = core::Vec2<Real>;

public:
    LaneLights(const PathSetup& setup, const LaneTracer<Real>& tracer)
        : setup_(setup), scene_(setup.scene), tracer_(tracer) {}

    // What the lights' fronts send along the rays that have met them, as far as it is for the rays to bring.
    Rgb emitted(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask& hitsLight) const {
        const Real index = core::select(hitsLight, points.surface.light, Real(0));
        const auto light = gr::gathered<Real>(scene_.scene.areaLights.data(), core::toUInt(index));
        const Real times = timesAsked(paths.ray.origin, index);
        const Real lightPdfW = light.pdfW(paths.ray.direction, points.surface.t) * times;
        const Real part = core::select(paths.pdfW < Real(core::infinity), balance(paths.pdfW, lightPdfW), Real(1));
        return core::select(hitsLight & points.fromOutside, light.radiance * part, Rgb(Real(0)));
    }

    // What surface points reflect of what the lights send them. isLast: of paths that go on from there no more.
    Rgb direct(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask& isLast, RayCounts& rays) const {
        Rgb sum(Real(0));
        const Vec3 start = points.offset(points.normal);
        for (int i = 0; i < setup_.lightDraws; ++i) {
            const Question asked = question(paths, start, i);
            gr::LightSample<Real> sample = asked.light.sample(points.surface.position, asked.place);
            // A path that goes on would find the light, too; the last point of one has this way alone.
            sample.pdfW = core::select(isLast, Real(0), sample.pdfW * asked.times);
            sum += reflected(paths, points, sample, gr::shadowRay(start, asked.light, sample.target), rays);
        }
        for (const gr::PointLight& light : scene_.scene.pointLights) {
            const gr::LightSample<Real> sample = light.sample<Real>(points.surface.position);
            const core::Ray<Real> shadow{start, sample.target - start, Real(1)};
            sum += reflected(paths, points, sample, shadow, rays);
        }
        return sum;
    }

private:
    // How much a sample counts that another way of sampling could have drawn, too: the balance heuristic (Veach 1997,
    // 9.2.2). Of no weight where neither can.
    static Real balance(const Real& pdf, const Real& otherPdf) {
        const Real sum = pdf + otherPdf;
        return core::select(sum > Real(0), pdf / sum, Real(0));
    }

    // How often a surface point asks a light for light, on average.
    Real timesAsked(const Vec3& at, const Real& light) const {
        if (!setup_.picksLights) return Real(static_cast<float>(setup_.lightSamples));
        return scene_.lights.probability(at, light) * Real(static_cast<float>(setup_.lightDraws));
    }

    // Which light a sample asks, and where. Of a few lights each is asked, of many those that chance picks. Its
    // radiance is over how often the point asks it.
    struct Question {
        gr::AreaLightOf<Real> light;
        Real times;  // that it is asked, on average
        Draw place;
    };
    Question question(const Paths<Real>& paths, const Vec3& at, int sample) const {
        Vec3 u = paths.lightDraw;
        if (sample > 0) {
            const Point4<Real> more =
                paths.random.point(PathNumbers<Real>::moreLight(core::toUInt(paths.surfacePoints), sample));
            u = Vec3(more[0], more[1], more[2]);
        }
        const Draw place(u.x, u.y);
        const gr::AreaLight* lights = scene_.scene.areaLights.data();
        Question question;
        if (setup_.picksLights) {
            const auto pick = scene_.lights.pick(at, u.z);
            question = {gr::gathered<Real>(lights, core::toUInt(pick.light)),
                        pick.probability * Real(static_cast<float>(setup_.lightDraws)), place};
        } else {
            question = {gr::broadcast<Real>(lights[sample / setup_.lightSamples]),
                        Real(static_cast<float>(setup_.lightSamples)), place};
        }
        Rgb& radiance = question.light.radiance;
        radiance = core::select(question.times > Real(0), radiance / question.times, Rgb(Real(0)));
        return question;
    }

    // What the surfaces reflect of a light sample towards the eye, black where something stands between. Its density is
    // that of all samples together; where it is 0, light comes from there in no other way.
    Rgb reflected(const Paths<Real>& paths, const ShadingPoints<Real>& points, const gr::LightSample<Real>& sample,
                  const core::Ray<Real>& shadow, RayCounts& rays) const {
        const Vec3 wi = points.frame.toLocal(sample.wi);
        Rgb f(Real(0));
        Real pdfW(0);
        points.forEachMaterial([&](const auto& bsdf, const Mask& here) {
            f = core::select(here, bsdf.eval(points.wo, wi), f);
            pdfW = core::select(here, bsdf.template pdfW<Real, PathHemisphere>(points.wo, wi), pdfW);
        });
        const Real part = core::select(sample.pdfW > Real(0), balance(sample.pdfW, pdfW), Real(1));
        const Rgb light = f * sample.weight * part;
        const Mask shines =
            paths.alive & (light.x + light.y + light.z > Real(0)) & !points.isOnWrongSide(sample.wi, wi);
        if (!core::any(shines)) return Rgb(Real(0));
        rays.shadow += static_cast<std::uint64_t>(core::countOf(shines));
        const Mask isDark = tracer_.occluded(shadow, shines, rays.traversal);
        const Rgb arriving =
            scene_.hasInteriors ? light * paths.media.transmittance(glm::length(shadow.direction)) : light;
        return core::select(shines & !isDark, arriving, Rgb(Real(0)));
    }

    const PathSetup& setup_;
    const PathScene& scene_;
    const LaneTracer<Real>& tracer_;
};

}  // namespace render
