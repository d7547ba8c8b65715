// Many paths at once, and the surface points that they have come to.
#pragma once

#include "core/frame.h"
#include "core/lanes.h"
#include "core/ray.h"
#include "core/vec.h"
#include "gr/scene.h"
#include "gr/surface_point.h"
#include "materials/material.h"
#include "render/transport/lane_media.h"
#include "render/transport/owen_sobol.h"
#include "render/transport/path_scene.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace render {

// A path's random numbers come in points of four (OwenSobol::point). Here are the numbers of the points.
template<class Real>
struct PathNumbers {
    using UInt = core::UInt<Real>;

    // The place in the pixel, and the place on the lens. Without a lens the latter two are for the first light sample.
    static constexpr std::uint32_t camera = 0;
    // The first light sample: which light, and with a lens the place on it, too.
    static constexpr std::uint32_t light = 1;
    // The direction in which a path leaves its n-th surface point, and the place of the light sample where it arrives.
    static UInt way(const UInt& surfacePoints) { return surfacePoints + UInt(1); }
    // The material's method there, Russian roulette, and which light is asked where the path arrives.
    static UInt method(const UInt& surfacePoints) { return surfacePoints + UInt(1u << 16); }
    // A surface point's further light samples, each a point of its own.
    static UInt moreLight(const UInt& surfacePoints, int sample) {
        return mixed(UInt(surfacePoints + UInt(mixed(static_cast<std::uint32_t>(sample)))));
    }
};

// Paths on their way, one in each lane.
template<class Real>
struct Paths {
    std::array<std::uint32_t, mostLanes> x{}, y{}, sample{};  // the pixel, and the sample's number in it
    std::array<std::size_t, mostLanes> slot{};  // where its radiance belongs in the block
    OwenSobol<Real> random{};
    core::Ray<Real> ray{};  // to the next surface point
    core::Rgb<Real> radiance{Real(0)};  // what the path has found so far
    core::Rgb<Real> throughput{Real(0)};  // what is left of light that comes along the ray, when it arrives at the eye
    // The square of the index of refraction here over that where the path began. Refraction into glass divides the
    // throughput by it, and refraction out of glass gives it back: so a path is worth the product of the two.
    Real indexSquared = Real(1);
    Real surfacePoints = Real(0);  // how many the path has met
    core::Vec3<Real> lightDraw{Real(0)};  // for the next surface point: the place on a light, and which light
    core::Mask<Real> alive = Real(0) > Real(0);

    // For multiple importance sampling: how the ray's direction was drawn, which decides for how much a light counts
    // that the ray meets. The ray and light sampling share it by their densities, unless one of the masks is set.
    Real pdfWBsdf = Real(0);  // the density with which the material drew the ray's direction, per steradian
    core::Mask<Real> cannotBeAsked = Real(0) > Real(0);  // light sampling brings nothing from there: the ray brings all
    core::Mask<Real> countedByLights = Real(0) > Real(0);  // light sampling has brought all: the ray brings nothing

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
    core::TextureValues<Real> textures;  // of the lanes' materials, where these have some

    ShadingPoints(const PathScene& scene, const core::Ray<Real>& ray, const gr::SurfacePoint<Real>& surface,
                  const core::Mask<Real>& shaded)
        : scene(scene.scene),
          surface(surface),
          lanes(core::bitsOf(shaded)),
          fromOutside(glm::dot(ray.direction, surface.normal) < Real(0)),
          normal(core::select(fromOutside, surface.normal, -surface.normal)),
          frame(core::select(fromOutside, surface.shadingNormal, -surface.shadingNormal)) {
        if (scene.hasTextures) lookUpTextures();
        if (scene.hasAnisotropy) turnFrame();
        wo = frame.toLocal(-ray.direction);
    }

    // Calls f(material, mask) for each material that any lane's surface is made of.
    template<class F>
    void forEachMaterial(F&& f) const {
        forEachMaterialIndex([&](std::size_t material, const core::Mask<Real>& here) {
            std::visit([&](const auto& m) { f(m, here); }, scene.materials[material]);
        });
    }
    // Calls f(bsdf, mask) for what each of them is there. It is made anew for each use: while its parameters are the
    // same in all lanes the processor has them at hand, and to keep it would be to write them out and read them back.
    template<class F>
    void forEachBsdf(F&& f) const {
        forEachMaterial(
            [&](const auto& material, const core::Mask<Real>& here) { f(material.template at<Real>(*this), here); });
    }
    // Whether light that goes through the surface as it is shaded would stay on this side of it as it lies.
    core::Mask<Real> staysOutside(const core::Vec3<Real>& direction, const core::Vec3<Real>& wi) const {
        return surface.isSmooth & (wi.z < Real(0)) & (glm::dot(direction, normal) > Real(0));
    }
    // Where a ray starts that is reflected, and one that goes through.
    core::Vec3<Real> startAbove() const { return surface.liftedOffset(normal); }
    core::Vec3<Real> startBelow() const { return surface.offset(-normal); }

private:
    // Once for all that is asked of the materials here.
    void lookUpTextures() {
        const materials::TexturePlace<Real> place{surface.uv, surface.inNode,
                                                  surface.position + core::broadcast<Real>(core::Vec3f(scene.origin))};
        forEachMaterialIndex([&](std::size_t material, const core::Mask<Real>& here) {
            for (const materials::TextureUse& use : scene.textures[material]) {
                core::Rgb<Real>& values = textures.slots[use.slot];
                values = core::select(here, use.at<Real>(place), values);
            }
        });
    }
    template<class F>
    void forEachMaterialIndex(F&& f) const {
        const core::LaneArray<Real> index(surface.material);
        for (std::uint32_t rest = lanes; rest != 0;) {
            const float material = index[std::countr_zero(rest)];
            const core::Mask<Real> here = surface.material == Real(material);
            rest &= ~core::bitsOf(here);
            f(static_cast<std::size_t>(material), here);
        }
    }
    void turnFrame() {
        const core::Frame<Real> turned(frame.z, surface.tangent);
        forEachMaterial([&](const auto& material, const core::Mask<Real>& here) {
            if (!material.isAnisotropic()) return;
            frame.x = core::select(here, turned.x, frame.x);
            frame.y = core::select(here, turned.y, frame.y);
        });
    }
};

}  // namespace render
