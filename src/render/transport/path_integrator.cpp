#include "core/lanes.h"
#include "core/ray.h"
#include "core/vec.h"
#include "gr/scene.h"
#include "gr/shape.h"
#include "gr/surface_point.h"
#include "gr/tracer.h"
#include "materials/bsdf.h"
#include "materials/material.h"
#include "render/transport/camera.h"
#include "render/transport/integrator.h"
#include "render/transport/lane_lights.h"
#include "render/transport/lane_paths.h"
#include "render/transport/media.h"
#include "render/transport/owen_sobol.h"
#include "render/transport/path_scene.h"
#include "render/transport/path_setup.h"

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

namespace render {
namespace {

using materials::BsdfSample;
template<class Real>
using Mask = core::Mask<Real>;
template<class Real>
using Vec3 = core::Vec3<Real>;
template<class Real>
using Rgb = core::Rgb<Real>;

template<class Real>
BsdfSample<Real> select(const Mask<Real>& mask, const BsdfSample<Real>& yes, const BsdfSample<Real>& no) {
    const auto either = [&](const Mask<Real>& a, const Mask<Real>& b) -> Mask<Real> {
        return (mask & a) | (b & !mask);
    };
    return {core::select(mask, yes.wi, no.wi),     core::select(mask, yes.weight, no.weight),
            core::select(mask, yes.pdfW, no.pdfW), either(yes.valid, no.valid),
            either(yes.isDelta, no.isDelta),       either(yes.isLit, no.isLit),
            either(yes.isDiffuse, no.isDiffuse)};
}

template<class Real>
Mask<Real> none() {
    return Real(0) > Real(0);
}

template<class Real>
class PathIntegrator final : public Integrator {
public:
    explicit PathIntegrator(PathSetup&& setup)
        : setup_(std::move(setup)),
          scene_(setup_.scene),
          tracer_(scene_.scene, scene_.accelerator, scene_.hasAnisotropy || scene_.hasTextures),
          lights_(setup_, tracer_) {}

    std::size_t bytes() const override { return scene_.bytes(); }

    void render(const View& view, const SampleBlock& block, Samples& samples,
                const std::atomic<bool>& stop) const override {
        Paths<Real> paths;
        for (SampleWalk next(block); !stop.load(std::memory_order_relaxed);) {
            // Lanes whose path has ended begin with the next sample.
            if (!core::all(paths.alive)) start(paths, view, next, samples.rays);
            const std::uint32_t before = core::bitsOf(paths.alive);
            if (before == 0) return;
            goOn(paths, view.camera, samples);
            store(paths, before & ~core::bitsOf(paths.alive), samples);
        }
    }

private:
    using Draw = core::Vec2<Real>;
    using UInt = core::UInt<Real>;

    static constexpr std::uint32_t allLanes = static_cast<std::uint32_t>((1ull << core::laneCount<Real>)-1);

    // Begins paths in the lanes where none is on its way, as long as there are samples left.
    void start(Paths<Real>& paths, const View& view, SampleWalk& next, RayCounts& rays) const {
        std::uint32_t begun = 0;
        core::forEachLane(allLanes & ~core::bitsOf(paths.alive), [&](int lane) {
            if (next.isOver()) return;
            const auto i = static_cast<std::size_t>(lane);
            paths.x[i] = static_cast<std::uint32_t>(next.x);
            paths.y[i] = static_cast<std::uint32_t>(next.y);
            paths.sample[i] = static_cast<std::uint32_t>(next.sample);
            paths.slot[i] = next.place;
            next.next();
            begun |= 1u << lane;
        });
        if (begun == 0) return;

        const UInt x = core::loadUInt<Real>(paths.x.data()), y = core::loadUInt<Real>(paths.y.data());
        const std::uint32_t seed =
            mixed(static_cast<std::uint32_t>(view.seed) + mixed(static_cast<std::uint32_t>(view.seed >> 32)));
        paths.random = {mixed(UInt(x + mixed(UInt(y + UInt(seed))))), core::loadUInt<Real>(paths.sample.data()),
                        static_cast<int>(std::bit_width(static_cast<std::uint32_t>(next.block.end - 1)))};
        const Point4<Real> u = paths.random.point(UInt(PathNumbers<Real>::camera));
        const Draw inPixel = view.antialiasing ? Draw(u[0], u[1]) : Draw(Real(0.5f));
        const Draw place = Draw(core::toReal(x), core::toReal(y)) + inPixel;
        const bool hasLens = view.camera.hasLens();
        const core::Ray<Real> ray = hasLens ? view.camera.ray(place, Draw(u[2], u[3])) : view.camera.ray(place);
        Vec3<Real> light(u[2], u[3], Real(0));
        if (hasLens || setup_.picksLights) {
            const Point4<Real> more = paths.random.point(UInt(PathNumbers<Real>::light));
            light = hasLens ? Vec3<Real>(more[2], more[3], more[0]) : Vec3<Real>(u[2], u[3], more[0]);
        }
        const Mask<Real> here = core::maskOf<Real>(begun);
        paths.ray.origin = core::select(here, ray.origin, paths.ray.origin);
        paths.ray.direction = core::select(here, ray.direction, paths.ray.direction);
        paths.ray.tMax = Real(core::infinity);
        paths.radiance = core::select(here, Rgb<Real>(Real(0)), paths.radiance);
        paths.throughput = core::select(here, Rgb<Real>(Real(1)), paths.throughput);
        paths.indexSquared = core::select(here, Real(1), paths.indexSquared);
        paths.surfacePoints = core::select(here, Real(0), paths.surfacePoints);
        paths.lightDraw = core::select(here, light, paths.lightDraw);
        paths.alive = paths.alive | here;
        // The eye asks no lights.
        paths.cannotBeAsked = paths.cannotBeAsked | here;
        paths.countedByLights = paths.countedByLights & !here;
        rays.camera += static_cast<std::uint64_t>(std::popcount(begun));
        if (scene_.hasInteriors) startMedia(paths, begun);
    }

    void startMedia(Paths<Real>& paths, std::uint32_t begun) const {
        const core::LaneArray<Real> x(paths.ray.origin.x), y(paths.ray.origin.y), z(paths.ray.origin.z);
        core::forEachLane(begun, [&](int lane) {
            paths.media.change(lane) = setup_.eyeMedia.at({x[lane], y[lane], z[lane]});
        });
        paths.media.update();
    }

    // Takes every path to its next surface point, and on from there: physics.md in a page.
    void goOn(Paths<Real>& paths, const Camera& camera, Samples& samples) const {
        // Find the nearest surface; the first one goes into the picture's layers.
        const gr::HitOf<Real> hit = tracer_.nearest(paths.ray, paths.alive, samples.rays.traversal);
        const gr::SurfacePoint<Real> surface = tracer_.surfaceAt(paths.ray, hit);
        const Mask<Real> isMet = paths.alive & surface.isMet();
        const ShadingPoints<Real> points(scene_, paths.ray, surface, isMet & (surface.light < Real(0)));
        if (!samples.first.empty()) tellFirst(paths, points, camera.depth(paths.ray, surface.t), isMet, samples);

        // Let the medium on the way there absorb.
        if (scene_.hasInteriors) {
            meetFromInside(paths, points);
            paths.throughput *= paths.media.transmittance(surface.t);
        }

        // Add the background and the endless lights where a path leaves the scene, and end the path.
        const Mask<Real> leaves = paths.alive & !isMet;
        if (core::any(leaves)) {
            const Rgb<Real> beyond = core::broadcast<Real>(setup_.background) + lights_.fromBeyond(paths, leaves);
            paths.radiance += core::select(leaves, paths.throughput * beyond, Rgb<Real>(Real(0)));
        }

        // Add what a light emits where a path meets its front, by multiple importance sampling, and end the path.
        const Mask<Real> hitsLight = isMet & (surface.light >= Real(0));
        if (core::any(hitsLight)) {
            const Rgb<Real> light = paths.throughput * lights_.emitted(paths, points, hitsLight);
            paths.radiance += core::select(hitsLight, light, Rgb<Real>(Real(0)));
        }
        paths.alive = isMet & !hitsLight;
        if (!core::any(paths.alive)) return;

        // Sample the lights and add what the surface reflects of them, by multiple importance sampling, too.
        paths.surfacePoints += Real(1);
        const Mask<Real> isLast = paths.surfacePoints >= Real(static_cast<float>(setup_.pathLength));
        const Rgb<Real> direct = paths.throughput * lights_.direct(paths, points, isLast, samples.rays);
        paths.radiance += core::select(paths.alive, direct, Rgb<Real>(Real(0)));

        // End a path that is as long as it may be, in the ambient light.
        if (setup_.ambient != core::Rgbf(0)) addAmbient(paths, points, isLast);
        paths.alive = paths.alive & !isLast;
        if (!core::any(paths.alive)) return;

        // Sample the BSDF, which is the material's, for a direction in which to go on.
        const UInt number = core::toUInt(paths.surfacePoints);
        const Point4<Real> u = paths.random.point(PathNumbers<Real>::way(number));
        const Point4<Real> more = paths.random.point(PathNumbers<Real>::method(number));
        const Real indexBeyond = scene_.hasInteriors ? indicesBeyond(paths, points) : Real(1);
        const BsdfSample<Real> next = sampled(points, {more[0], {u[0], u[1]}}, indexBeyond);
        const Mask<Real> isThrough = next.wi.z < Real(0);
        const Vec3<Real> direction = points.frame.toWorld(next.wi);
        paths.throughput *= next.weight;
        paths.indexSquared *= core::select(isThrough, indexBeyond * indexBeyond, Real(1));
        paths.alive = paths.alive & next.valid & !points.staysOutside(direction, next.wi);

        // Play Russian roulette where less than a third of the light is left; survivors count for the others.
        const Rgb<Real> left = paths.throughput * paths.indexSquared;
        const Real survival = core::min(core::max(left.x, core::max(left.y, left.z)) * Real(3), Real(1));
        paths.alive = paths.alive & (more[1] < survival);
        paths.throughput /= core::select(paths.alive, survival, Real(1));

        // Start the next ray, on the side to which it goes.
        if (scene_.hasInteriors) crossSurfaces(paths, points, isThrough);
        paths.ray.origin = core::select(isThrough, points.startBelow(), points.startAbove());
        paths.ray.direction = direction;
        paths.lightDraw = Vec3<Real>(u[2], u[3], more[2]);
        count(samples.rays, paths.alive, next);

        // Remember how its direction was drawn, for the balance heuristic at a light that it meets.
        paths.pdfWBsdf = next.pdfW;
        paths.cannotBeAsked = !next.isLit;
        paths.countedByLights = next.isLit & next.isDelta;
    }

    void tellFirst(const Paths<Real>& paths, const ShadingPoints<Real>& points, const Real& depth,
                   const Mask<Real>& isMet, Samples& samples) const {
        const std::uint32_t first = core::bitsOf(isMet & (paths.surfacePoints == Real(0)));
        if (first == 0) return;
        Rgb<Real> albedo(Real(0));  // that of a light
        points.forEachMaterial([&](const auto& material, const Mask<Real>& here) {
            albedo =
                core::select(here & (points.surface.light < Real(0)), material.template albedo<Real>(points), albedo);
        });
        const core::LaneArray<Real> t(depth), x(points.frame.z.x), y(points.frame.z.y), z(points.frame.z.z),
            r(albedo.x), g(albedo.y), b(albedo.z);
        core::forEachLane(first, [&](int lane) {
            samples.first[paths.slot[static_cast<std::size_t>(lane)]] = {
                t[lane], {r[lane], g[lane], b[lane]}, {x[lane], y[lane], z[lane]}};
        });
    }

    void addAmbient(Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask<Real>& isLast) const {
        points.forEachMaterial([&](const auto& material, const Mask<Real>& here) {
            const Rgb<Real> light =
                core::broadcast<Real>(setup_.ambient) * material.template ambientReflectance<Real>(points);
            paths.radiance += core::select(here & paths.alive & isLast, paths.throughput * light, Rgb<Real>(Real(0)));
        });
    }

    BsdfSample<Real> sampled(const ShadingPoints<Real>& points, const materials::BsdfDraw<Real>& u,
                             const Real& indexBeyond) const {
        BsdfSample<Real> next{{Real(0), Real(0), Real(1)},
                              Rgb<Real>(Real(0)),
                              Real(0),
                              none<Real>(),
                              none<Real>(),
                              none<Real>(),
                              none<Real>()};
        points.forEachBsdf([&](const auto& bsdf, const Mask<Real>& here) {
            next = select<Real>(here, bsdf.template sample<PathHemisphere>(points.wo, u, indexBeyond), next);
        });
        return next;
    }

    // Calls f(lane, interior) for the lanes of a mask whose surface has one.
    template<class F>
    void forEachInterior(const ShadingPoints<Real>& points, std::uint32_t lanes, F&& f) const {
        const core::LaneArray<Real> material(points.surface.material);
        core::forEachLane(lanes & points.lanes, [&](int lane) {
            if (const auto* interior = scene_.scene.interiorOf(static_cast<std::uint32_t>(material[lane])))
                f(lane, *interior);
        });
    }

    void meetFromInside(Paths<Real>& paths, const ShadingPoints<Real>& points) const {
        forEachInterior(points, ~core::bitsOf(points.fromOutside),
                        [&](int lane, const auto& interior) { paths.media.change(lane).meetFromInside(interior); });
        paths.media.update();
    }

    // The index of refraction beyond each surface over that on this side of it.
    Real indicesBeyond(const Paths<Real>& paths, const ShadingPoints<Real>& points) const {
        core::LaneArray<Real> index(Real(1));
        const std::uint32_t fromOutside = core::bitsOf(points.fromOutside);
        forEachInterior(points, allLanes, [&](int lane, const auto& interior) {
            const Media& media = paths.media.at(lane);
            index[lane] = media.indexBeyond(interior, fromOutside >> lane & 1) / media.index();
        });
        return index.real();
    }

    void crossSurfaces(Paths<Real>& paths, const ShadingPoints<Real>& points, const Mask<Real>& isThrough) const {
        const std::uint32_t fromOutside = core::bitsOf(points.fromOutside);
        forEachInterior(points, core::bitsOf(isThrough & paths.alive), [&](int lane, const auto& interior) {
            paths.media.change(lane).cross(interior, fromOutside >> lane & 1);
        });
        paths.media.update();
    }

    static void count(RayCounts& rays, const Mask<Real>& alive, const BsdfSample<Real>& next) {
        const auto all = static_cast<std::uint64_t>(core::countOf(alive));
        const auto through = static_cast<std::uint64_t>(core::countOf(alive & (next.wi.z < Real(0))));
        const auto diffuse = static_cast<std::uint64_t>(core::countOf(alive & !(next.wi.z < Real(0)) & next.isDiffuse));
        rays.refractive += through;
        rays.diffuse += diffuse;
        rays.reflective += all - through - diffuse;
    }

    // The radiance of paths that have ended.
    static void store(const Paths<Real>& paths, std::uint32_t ended, Samples& samples) {
        if (ended == 0) return;
        const core::LaneArray<Real> r(paths.radiance.x), g(paths.radiance.y), b(paths.radiance.z);
        core::forEachLane(ended, [&](int lane) {
            samples.radiance[paths.slot[static_cast<std::size_t>(lane)]] = {r[lane], g[lane], b[lane]};
        });
    }

    const PathSetup setup_;
    const PathScene& scene_;
    const gr::Tracer<Real> tracer_;
    const LaneLights<Real> lights_;
};

}  // namespace
}  // namespace render

// The build says for how many lanes, and under which name.
render::Integrator* GRSH_PATH_INTEGRATOR(render::PathSetup&& setup) {
    return new render::PathIntegrator<GRSH_REAL>(std::move(setup));
}
