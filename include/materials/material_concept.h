// What a material must have to be in the list of materials/material.h, and what the BSDF that it makes at a surface
// point.
#pragma once

#include "core/lanes.h"
#include "core/option.h"
#include "core/vec.h"
#include "core/warp.h"
#include "materials/bsdf.h"
#include "materials/interior.h"

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace materials {

// A BSDF for one surface point or for many, one in each lane: its parameters may differ from lane to lane.
template<class Bsdf, class Real>
concept CompleteBsdf = std::copyable<Bsdf> &&
    requires(const Bsdf& bsdf, core::Vec3<Real> wo, core::Vec3<Real> wi, BsdfDraw<Real> u, Real indexBeyond) {
    // f * |cos|. Black for light that comes or goes below the surface, unless it is let through.
    { bsdf.eval(wo, wi) } -> std::same_as<core::Rgb<Real>>;
    // With which density sample() draws wi, per steradian, of all methods together. The hemisphere is what the diffuse
    // method draws from.
    { bsdf.template pdfW<core::UniformHemisphere>(wo, wi) } -> std::same_as<Real>;
    { bsdf.template pdfW<core::CosineHemisphere>(wo, wi) } -> std::same_as<Real>;
    // A direction in which a path may go on. indexBeyond: of refraction, beyond the surface over this side of it.
    { bsdf.template sample<core::UniformHemisphere>(wo, u, indexBeyond) } -> std::same_as<BsdfSample<Real>>;
    { bsdf.template sample<core::CosineHemisphere>(wo, u, indexBeyond) } -> std::same_as<BsdfSample<Real>>;
};

// It stands for any surface point. One where textures have been looked up has them as `textures`, TextureValues<Real>.
struct SomePoint {};

template<class Material, class Real>
using BsdfOf = decltype(std::declval<const Material&>().template at<Real>(SomePoint{}));

// A material is what the script says.
template<class Material>
concept CompleteMaterial = std::default_initializable<Material> && std::copyable<Material> &&
    requires(const Material& material) {
    { Material::typeName } -> std::convertible_to<std::string_view>;  // in gr_material, behind the name
    // Its parameters, each a member of it; their defaults are those of Material{}.
    { Material::options() } -> std::same_as<std::span<const core::OptionRow<Material>>>;
    // Which of the ways to go on it can take: those of materials/methods.h, in their order.
    { Material::canSample } -> std::convertible_to<std::array<bool, 4>>;
    // How often it is to take each of them, if the script says so. (samplingRow makes the option.)
    { material.sampling } -> std::convertible_to<std::optional<core::Weights>>;
    // What it is at a surface point, or at one in each lane.
    { material.template at<float>(SomePoint{}) } -> CompleteBsdf<float>;
    { material.template at<core::Lanes>(SomePoint{}) } -> CompleteBsdf<core::Lanes>;
    { material.isAnisotropic() } -> std::same_as<bool>;  // whether it asks how the surface's u axis lies
    { material.interior() } -> std::same_as<std::optional<Interior>>;  // none where it is opaque
    // What the albedo layer of a picture shows, each in [0, 1].
    { material.template albedo<float>(SomePoint{}) } -> std::same_as<core::Rgbf>;
    { material.template albedo<core::Lanes>(SomePoint{}) } -> std::same_as<core::Rgb<core::Lanes>>;
    // What `ambient` is multiplied with.
    { material.template ambientReflectance<float>(SomePoint{}) } -> std::same_as<core::Rgbf>;
    { material.template ambientReflectance<core::Lanes>(SomePoint{}) } -> std::same_as<core::Rgb<core::Lanes>>;
};

}  // namespace materials
