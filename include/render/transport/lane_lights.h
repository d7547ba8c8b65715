// The light that comes to the paths' surface points straight from the lights, by multiple importance sampling (Veach
// 1997, 9.2) with two techniques. In light sampling a surface point asks a light. In BSDF sampling the material draws a
// direction, and the ray that goes there may meet a light. Light that both can bring they share by the balance
// heuristic.
#pragma once

#include "core/lanes.h"
#include "core/ray.h"
#include "core/vec.h"
#include "core/warp.h"
#include "gr/light.h"
#include "gr/tracer.h"
#include "render/transport/integrator.h"
#include "render/transport/lane_paths.h"
#include "render/transport/owen_sobol.h"
#include "render/transport/path_scene.h"
#include "render/transport/path_setup.h"

#include <cstddef>
#include <cstdint>

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

    // BSDF sampling: what the lights' fronts send along the rays that have met them, weighted.
    Rgb emitted(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask& hitsLight) const {
        const Real index = core::select(hitsLight, points.surface.light, Real(0));
        Real pdfWLight(0);
        Rgb emitted(Real(0));
        forEachKindOf(index, hitsLight, [&]<class Light>(const Light& light, const Mask& here) {
            if constexpr (Light::canBeMet && !Light::isEndless) {
                pdfWLight = core::select(here, light.pdfW(paths.ray.direction, points.surface.t), pdfWLight);
                emitted = core::select(here, light.emitted(), emitted);
            }
        });
        pdfWLight = pdfWLight * timesAsked(paths.ray.origin, index);
        const Real weight = core::select(paths.cannotBeAsked, Real(1), balanceHeuristic(paths.pdfWBsdf, pdfWLight));
        const Mask brings = hitsLight & points.fromOutside & !paths.countedByLights;
        return core::select(brings, emitted * weight, Rgb(Real(0)));
    }

    // BSDF sampling, too: what endless lights send along the rays that leave the scene, weighted.
    Rgb fromBeyond(const Paths<Real>& paths, const Mask& leaves) const {
        Rgb sum(Real(0));
        std::size_t number = 0;
        scene_.scene.lights.forEach([&]<class Light>(const Light& light) {
            if constexpr (Light::isEndless) {
                if constexpr (Light::canBeMet) {
                    const gr::Seen<Real> seen = gr::broadcast<Real>(light).seen(paths.ray.direction);
                    const Real pdfWLight = seen.pdfW * Real(timesEndlessAsked(number));
                    const Real weight =
                        core::select(paths.cannotBeAsked, Real(1), balanceHeuristic(paths.pdfWBsdf, pdfWLight));
                    sum += seen.radiance * weight;
                }
                ++number;
            }
        });
        return core::select(leaves & !paths.countedByLights, sum, Rgb(Real(0)));
    }

    // Light sampling: what surface points reflect of what the lights send them, weighted. A few lights are all asked,
    // of many chance picks some. isLast: whether the path goes on from there no more.
    Rgb direct(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask& isLast, RayCounts& rays) const {
        Rgb sum(Real(0));
        const Vec3 start = points.startAbove();
        const auto add = [&](const Answer& answer) { sum += reflected(paths, points, answer, isLast, rays); };
        if (setup_.picksLights) {
            for (int i = 0; i < setup_.lightSamples; ++i) add(answerOfPicked(points, start, drawn(paths, i)));
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
    // The weight of a sample that another technique could have drawn, too (Veach 1997, 9.2.2). A density is that of all
    // samples of its technique together. Where both are 0 there is no such sample, and no weight.
    static Real balanceHeuristic(const Real& pdfW, const Real& otherPdfW) {
        const Real sum = pdfW + otherPdfW;
        return core::select(sum > Real(0), pdfW / sum, Real(0));
    }

    // How often, on average, a surface point asks a light that rays can meet.
    Real timesAsked(const Vec3& at, const Real& light) const {
        const Real samples(static_cast<float>(setup_.lightSamples));
        return setup_.picksLights ? scene_.lights.probability(at, light) * samples : samples;
    }

    // Likewise the endless light of that number.
    float timesEndlessAsked(std::size_t number) const {
        const auto samples = static_cast<float>(setup_.lightSamples);
        return setup_.picksLights ? scene_.lights.endlessProbability(number) * samples : samples;
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

    // What a light answers to a surface point that asks it. The density is that of all the times together that the
    // point asks.
    struct Answer {
        gr::LightSample<Real> sample;
        core::Ray<Real> shadow;
        Mask cannotBeMet;  // BSDF sampling brings nothing of this light, since no ray meets it
    };
    // times: how often, on average, the point asks. The light of one answer is divided by that.
    template<class Light>
    static Answer answerOf(Light light, const Real& times, const ShadingPoints<Real>& points, const Vec3& start,
                           const Draw& place) {
        light.divideBy(times);
        gr::LightSample<Real> sample = light.sample(points.surface.lifted, place);
        sample.pdfW = sample.pdfW * times;
        return {sample, gr::shadowRay(start, light, sample.target), Mask(!Light::canBeMet)};
    }
    // The answer of a light that chance picks. u: the place on the light, and which light.
    Answer answerOfPicked(const ShadingPoints<Real>& points, const Vec3& start, const Vec3& u) const {
        const auto pick = scene_.lights.pick(start, u.z);
        const Real times = pick.probability * Real(static_cast<float>(setup_.lightSamples));
        Answer answer{{start, points.normal, Rgb(Real(0)), Real(0)}, {start, Vec3(Real(0)), Real(1)}, Mask(false)};
        forEachKindOf(pick.light, times > Real(0), [&](const auto& light, const Mask& here) {
            const Answer found = answerOf(light, times, points, start, Draw(u.x, u.y));
            const Mask cannotBeMet = answer.cannotBeMet | (here & found.cannotBeMet);
            answer = {{core::select(here, found.sample.target, answer.sample.target),
                       core::select(here, found.sample.wi, answer.sample.wi),
                       core::select(here, found.sample.weight, answer.sample.weight),
                       core::select(here, found.sample.pdfW, answer.sample.pdfW)},
                      {start, core::select(here, found.shadow.direction, answer.shadow.direction),
                       core::select(here, found.shadow.tMax, answer.shadow.tMax)},
                      cannotBeMet};
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

    // What the surfaces reflect of a light sample towards the eye, weighted; black where something stands between.
    Rgb reflected(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Answer& answer, const Mask& isLast,
                  RayCounts& rays) const {
        const gr::LightSample<Real>& sample = answer.sample;
        const Vec3 wi = points.frame.toLocal(sample.wi);
        Rgb f(Real(0));
        Real pdfWBsdf(0);
        points.forEachBsdf([&](const auto& bsdf, const Mask& here) {
            f = core::select(here, bsdf.eval(points.wo, wi), f);
            pdfWBsdf = core::select(here, bsdf.template pdfW<PathHemisphere>(points.wo, wi), pdfWBsdf);
        });
        const Real pdfWLight = sample.pdfW;
        // From a path's last surface point no ray goes on: light sampling brings all, as it does of a point light.
        const Mask byLightsAlone = isLast | answer.cannotBeMet;
        const Real weight = core::select(byLightsAlone, Real(1), balanceHeuristic(pdfWLight, pdfWBsdf));
        const Rgb light = f * sample.weight * weight;
        const Mask shines = paths.alive & (light.x + light.y + light.z > Real(0));
        if (!core::any(shines)) return Rgb(Real(0));
        rays.shadow += static_cast<std::uint64_t>(core::countOf(shines));
        const core::Ray<Real>& shadow = answer.shadow;
        const Mask isDark = tracer_.occluded(shadow, shines, rays.traversal);
        const Rgb arriving = scene_.hasInteriors
                                 ? light * paths.media.transmittance(glm::length(shadow.direction) * shadow.tMax)
                                 : light;
        return core::select(shines & !isDark, arriving, Rgb(Real(0)));
    }

    const PathSetup& setup_;
    const PathScene& scene_;
    const gr::Tracer<Real>& tracer_;
};

}  // namespace render
