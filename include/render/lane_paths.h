// Many paths at once, and the surface points that they have come to.
#pragma once

#include "core/frame.h"
#include "gr/tracer.h"
#include "render/lane_media.h"
#include "render/owen_sobol.h"

namespace render {

// Which four random numbers of a path serve what.
template<class Real>
struct PathNumbers {
    using UInt = core::UInt<Real>;

    static constexpr std::uint32_t camera = 0;  // the place in the pixel, and that on the lens, or
    static constexpr std::uint32_t light = 1;  // the first surface point's light
    // The direction in which a path leaves its n-th surface point, and the light where it arrives.
    static UInt way(const UInt& surfacePoints) { return surfacePoints + UInt(1); }
    static UInt method(const UInt& surfacePoints) { return surfacePoints + UInt(1u << 16); }
    // All light samples of a surface point but its first.
    static UInt moreLight(const UInt& surfacePoints, int sample) {
        return mixed(UInt(surfacePoints + UInt(mixed(static_cast<std::uint32_t>(sample)))));
    }
};

// Paths on their way, one in each lane.
template<class Real>
struct Paths {
    std::array<std::uint32_t, mostLanes> x{}, y{}, sample{};
    std::array<std::size_t, mostLanes> slot{};  // where its radiance belongs in the block
    OwenSobol<Real> random{};
    core::Ray<Real> ray{};
    core::Rgb<Real> radiance{Real(0)};
    core::Rgb<Real> throughput{Real(0)};  // what is left of light that comes along the ray, when it arrives at the eye
    Real indexSquared = Real(1);  // of refraction, over that where the path began: refraction divides throughput by it
    Real surfacePoints = Real(0);
    // Of the ray's direction; infinity where light sampling cannot bring what the ray brings, 0 where it has.
    Real pdfW = Real(0);
    core::Vec3<Real> lightDraw{Real(0)};  // for the next surface point: the place on a light, and which light
    core::Mask<Real> alive = Real(0) > Real(0);
    LaneMedia<Real> media;
};

// Surface points as the paths see them: the normals are turned to where each comes from.
template<class Real>
struct ShadingPoints {
    const gr::Scene& scene;
    const gr::SurfacePoint<Real>& surface;
    std::uint32_t lanes;  // that are shaded
    core::Mask<Real> fromOutside;
    core::Vec3<Real> normal;
    core::Frame<Real> frame;
    core::Vec3<Real> wo;

    ShadingPoints(const PathScene& scene, const core::Ray<Real>& ray, const gr::SurfacePoint<Real>& surface,
                  const core::Mask<Real>& shaded)
        : scene(scene.scene),
          surface(surface),
          lanes(core::bitsOf(shaded)),
          fromOutside(glm::dot(ray.direction, surface.normal) < Real(0)),
          normal(core::select(fromOutside, surface.normal, -surface.normal)),
          frame(core::select(fromOutside, surface.shadingNormal, -surface.shadingNormal)) {
        if (scene.hasAnisotropy) turnFrame();
        wo = frame.toLocal(-ray.direction);
    }

    // Calls f(bsdf, mask) for each material that any lane's surface is made of.
    template<class F>
    void forEachMaterial(F&& f) const {
        const core::LaneArray<Real> index(surface.material);
        for (std::uint32_t rest = lanes; rest != 0;) {
            const float material = index[std::countr_zero(rest)];
            const core::Mask<Real> here = surface.material == Real(material);
            rest &= ~core::bitsOf(here);
            std::visit([&](const auto& bsdf) { f(bsdf, here); }, scene.materials[static_cast<std::size_t>(material)]);
        }
    }
    // Light from there would shine through the surface: it is above as the surface is shaded and below as it lies, or
    // the other way round.
    core::Mask<Real> isOnWrongSide(const core::Vec3<Real>& direction, const core::Vec3<Real>& wi) const {
        return surface.isSmooth & core::differ(glm::dot(direction, normal) > Real(0), wi.z > Real(0));
    }
    core::Vec3<Real> offset(const core::Vec3<Real>& side) const { return surface.offset(side); }

private:
    void turnFrame() {
        const core::Frame<Real> turned(frame.z, surface.tangent);
        forEachMaterial([&](const auto& bsdf, const core::Mask<Real>& here) {
            if (!bsdf.isAnisotropic()) return;
            frame.x = core::select(here, turned.x, frame.x);
            frame.y = core::select(here, turned.y, frame.y);
        });
    }
};

}  // namespace render
