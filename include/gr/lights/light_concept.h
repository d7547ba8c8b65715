// What a light tells of itself: what the list of lights asks of each kind in it.
#pragma once

#include "core/bounds.h"

#include <concepts>
#include <string>
#include <tuple>

namespace gr {

// Light that may arrive at a surface point from a place drawn on a light.
template<class Real>
struct LightSample {
    core::Vec3<Real> target;  // the place on the light, to which the shadow ray goes; of an endless light it is wi
    core::Vec3<Real> wi;  // unit direction to it
    core::Rgb<Real> weight;  // radiance / pdfW: times f * cos it estimates the radiance reflected; black: no light
    Real pdfW;  // per steradian as seen from the surface point; 0 for a light that no ray can meet, which has none
};

// What an endless light sends from the side to which a ray leaves the scene.
template<class Real>
struct Seen {
    core::Rgb<Real> radiance;
    Real pdfW;  // the density with which sample() draws that direction
};

// Where a light is, and to which sides it shines.
struct LightBounds {
    core::Bounds box;
    core::Vec3f centre;  // by which lights that lie near each other are found
    core::Vec3f axis;  // unit length
    // Of the half angle of a cone about the axis that holds the normals of all that shines: 1 for a flat light, -1 for
    // one that shines to all sides. At an angle to the cone a light brings at most the cosine of what it brings within.
    float cosine;
};

namespace detail {

template<class Parts>
inline constexpr std::size_t bytesOfParts = 0;
template<class... Parts>
inline constexpr std::size_t bytesOfParts<std::tuple<Parts&...>> = (sizeof(Parts) + ... + 0);

}  // namespace detail

// All numbers of a light, in their order: lanes gather them and the fingerprint hashes them, so none may be missing.
template<class Light>
concept TellsAllItsNumbers = requires(Light& light) {
    requires detail::bytesOfParts<decltype(Light::parts(light))>
    == sizeof(Light);
};

// A light that scripts name tells what gr_print says of it. One that has a place can be moved; of the others their
// nodes are placed.
template<class Light>
concept HasText = !Light::isNamed || requires(const Light& light) {
    { light.text() } -> std::same_as<std::string>;
};
template<class Light>
concept CanBeMoved = !Light::isNamed || requires(Light & moved, core::Vec3f way) {
    { moved.moveBy(way) } -> std::same_as<void>;
};

// A light that a ray can meet tells what it sends back along it, and with which density sample() draws the direction.
template<class Light>
concept CanBeMetOrNot =
    !Light::canBeMet || Light::isEndless || requires(const Light& light, core::Vec3f wi, float distance) {
    { light.emitted() } -> std::same_as<core::Rgbf>;
    { light.pdfW(wi, distance) } -> std::same_as<float>;
};

// One that lies beyond all places is met by rays that leave the scene, and tells at once what they see of it; any other
// has a place.
template<class Light>
concept IsEndlessOrHasPlace = (Light::isEndless && (!Light::canBeMet ||
                                                    requires(const Light& light, core::Vec3f wi) {
                                                        { light.seen(wi) } -> std::same_as<Seen<float>>;
                                                    })) ||
                              (!Light::isEndless && CanBeMoved<Light> &&
                               requires(const Light& light, core::Vec3f point) {
                                   { light.shadowEnd(point, point) } -> std::same_as<core::Vec3f>;
                                   { light.bounds() } -> std::same_as<LightBounds>;
                                   { light.falloff() } -> std::same_as<core::Vec3f>;
                               });

template<class Light>
concept CompleteLight = requires(const Light& light, Light& changed, core::Vec3f point, core::Vec2f u, float times) {
    { Light::isNamed } -> std::convertible_to<bool>;  // by scripts
    { Light::isEndless } -> std::convertible_to<bool>;  // its light comes from beyond all places
    { Light::canBeMet } -> std::convertible_to<bool>;  // by a ray
    { Light::hasPlaces } -> std::convertible_to<bool>;  // to draw; else one sample of it is like the other
    { light.sample(point, u) } -> std::same_as<LightSample<float>>;
    { changed.divideBy(times) } -> std::same_as<void>;
    { light.power() } -> std::same_as<double>;  // of an endless light the irradiance of a surface that faces it
}
&&TellsAllItsNumbers<Light>&& HasText<Light>&& CanBeMetOrNot<Light>&& IsEndlessOrHasPlace<Light>;

}  // namespace gr
