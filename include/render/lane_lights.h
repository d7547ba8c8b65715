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
    LaneLights(const PathSetup& setup, const gr::Tracer<Real>& tracer)
        : setup_(setup), scene_(setup.scene), tracer_(tracer) {}

    // What the lights' fronts send along the rays that have met them, as far as it is for the rays to bring.
    Rgb emitted(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask& hitsLight) const {
        const Real index = core::select(hitsLight, points.surface.light, Real(0));
        Real lightPdfW(0);
        Rgb emitted(Real(0));
        forEachKindOf(index, hitsLight, [&]<class Light>(const Light& light, const Mask& here) {
            if constexpr (Light::canBeMet) {
                lightPdfW = core::select(here, light.pdfW(paths.ray.direction, points.surface.t), lightPdfW);
                emitted = core::select(here, light.emitted(), emitted);
            }
        });
        lightPdfW = lightPdfW * timesAsked(paths.ray.origin, index);
        const Real part = core::select(paths.pdfW < Real(core::infinity), balance(paths.pdfW, lightPdfW), Real(1));
        return core::select(hitsLight & points.fromOutside, emitted * part, Rgb(Real(0)));
    }

    // What surface points reflect of what the lights send them. isLast: of paths that go on from there no more.
    // Of a few lights each is asked, of many those that chance picks.
    Rgb direct(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask& isLast, RayCounts& rays) const {
        Rgb sum(Real(0));
        const Vec3 start = points.offset(points.normal);
        const auto add = [&](const Answer& answer) { sum += reflected(paths, points, start, answer, isLast, rays); };
        if (setup_.picksLights) {
            for (int i = 0; i < setup_.lightSamples; ++i) add(answerOfOne(points, start, drawn(paths, i)));
            return sum;
        }
        int draws = 0;
        scene_.scene.lights.forEach([&]<class Light>(const Light& light) {
            const int samples = Light::hasPlaces ? setup_.lightSamples : 1;
            for (int i = 0; i < samples; ++i) {
                const Vec3 u = Light::hasPlaces ? drawn(paths, draws++) : Vec3(Real(0));
                const Real times(static_cast<float>(samples));
                add(answerOf(gr::broadcast<Real>(light), times, points, start, Draw(u.x, u.y)));
            }
        });
        return sum;
    }

private:
    // How much a sample counts that another way of sampling could have drawn, too: the balance heuristic (Veach 1997,
    // 9.2.2). Of no weight where neither can.
    static Real balance(const Real& pdf, const Real& otherPdf) {
        const Real sum = pdf + otherPdf;
        return core::select(sum > Real(0), pdf / sum, Real(0));
    }

    // How often a surface point asks a light for light, on average. Of a light that a ray can meet.
    Real timesAsked(const Vec3& at, const Real& light) const {
        const Real samples(static_cast<float>(setup_.lightSamples));
        return setup_.picksLights ? scene_.lights.probability(at, light) * samples : samples;
    }

    // Calls f(light, here) for each kind of light that has lanes: theirs, and which they are.
    template<class F>
    void forEachKindOf(const Real& index, const Mask& lanes, F&& f) const {
        scene_.scene.lights.forEachKind([&](const auto& all, std::size_t firstIndex) {
            const Real first(static_cast<float>(firstIndex)), count(static_cast<float>(all.size()));
            const Mask here = lanes & (index >= first) & (index < first + count);
            if (!core::any(here)) return;
            f(gr::gathered<Real>(all.data(), core::toUInt(core::select(here, index - first, Real(0)))), here);
        });
    }

    // What a light sends a surface point that asks it so many times on average: over that number, but for the density.
    struct Answer {
        gr::LightSample<Real> sample;
        Vec3 shadowEnd;
    };
    template<class Light>
    static Answer answerOf(Light light, const Real& times, const ShadingPoints<Real>& points, const Vec3& start,
                           const Draw& place) {
        light.divideBy(times);
        gr::LightSample<Real> sample = light.sample(points.surface.position, place);
        sample.pdfW = sample.pdfW * times;
        return {sample, light.shadowEnd(start, sample.target)};
    }
    // u: the place on the light, and which light.
    Answer answerOfOne(const ShadingPoints<Real>& points, const Vec3& start, const Vec3& u) const {
        const auto pick = scene_.lights.pick(start, u.z);
        const Real times = pick.probability * Real(static_cast<float>(setup_.lightSamples));
        Answer answer{{start, points.normal, Rgb(Real(0)), Real(0)}, start};
        forEachKindOf(pick.light, times > Real(0), [&](const auto& light, const Mask& here) {
            const Answer of = answerOf(light, times, points, start, Draw(u.x, u.y));
            answer = {{core::select(here, of.sample.target, answer.sample.target),
                       core::select(here, of.sample.wi, answer.sample.wi),
                       core::select(here, of.sample.weight, answer.sample.weight),
                       core::select(here, of.sample.pdfW, answer.sample.pdfW)},
                      core::select(here, of.shadowEnd, answer.shadowEnd)};
        });
        return answer;
    }

    // A surface point's random numbers for a light sample.
    Vec3 drawn(const Paths<Real>& paths, int sample) const {
        if (sample == 0) return paths.lightDraw;
        const Point4<Real> more =
            paths.random.point(PathNumbers<Real>::moreLight(core::toUInt(paths.surfacePoints), sample));
        return {more[0], more[1], more[2]};
    }

    // What the surfaces reflect of a light sample towards the eye, black where something stands between. Its density is
    // that of all samples together; where it is 0, light comes from there in no other way. A path that goes on would
    // find a light that has one, too; the last point of one has this way alone.
    Rgb reflected(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Vec3& start, const Answer& answer,
                  const Mask& isLast, RayCounts& rays) const {
        const gr::LightSample<Real>& sample = answer.sample;
        const Vec3 wi = points.frame.toLocal(sample.wi);
        Rgb f(Real(0));
        Real pdfW(0);
        points.forEachMaterial([&](const auto& bsdf, const Mask& here) {
            f = core::select(here, bsdf.eval(points.wo, wi), f);
            pdfW = core::select(here, bsdf.template pdfW<Real, PathHemisphere>(points.wo, wi), pdfW);
        });
        const Real lightPdfW = core::select(isLast, Real(0), sample.pdfW);
        const Real part = core::select(lightPdfW > Real(0), balance(lightPdfW, pdfW), Real(1));
        const Rgb light = f * sample.weight * part;
        const Mask shines =
            paths.alive & (light.x + light.y + light.z > Real(0)) & !points.isOnWrongSide(sample.wi, wi);
        if (!core::any(shines)) return Rgb(Real(0));
        rays.shadow += static_cast<std::uint64_t>(core::countOf(shines));
        const core::Ray<Real> shadow{start, answer.shadowEnd - start, Real(1)};
        const Mask isDark = tracer_.occluded(shadow, shines, rays.traversal);
        const Rgb arriving =
            scene_.hasInteriors ? light * paths.media.transmittance(glm::length(shadow.direction)) : light;
        return core::select(shines & !isDark, arriving, Rgb(Real(0)));
    }

    const PathSetup& setup_;
    const PathScene& scene_;
    const gr::Tracer<Real>& tracer_;
};

}  // namespace render
