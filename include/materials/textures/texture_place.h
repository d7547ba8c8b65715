// Where textures are looked up.
#pragma once

#include "core/option.h"
#include "core/transform.h"
#include "core/vec.h"

#include <array>

namespace materials {

// A place on a surface, or one in each lane, as each way to count places has it.
template<class Real>
struct TexturePlace {
    core::Vec2<Real> uv;  // on the surface
    core::Vec3<Real> object;  // in the space of the node that made the object, without the node's own transform
    core::Vec3<Real> world;
};

inline constexpr std::array<core::Word, 3> coordinateNames{"uv", "object", "world"};

// Faces often lie just where cells meet, and rounding puts their places on both sides. So cells begin a hair, a
// thousandth of their size, before their place.
inline constexpr float onFace = 0x1p-10f;

// What a texture is told of where it lies: the options that all textures have. In its coordinates it is first scaled,
// then rotated about x, y and z, then translated.
struct Mapping {
    core::Word coordinates = "object";
    core::Scaling scale;
    glm::dvec3 rotate{0};  // degrees, counter-clockwise seen from the tips of the axes
    glm::dvec3 translate{0};

    // From its coordinates to its own space.
    core::Transform toTexture() const;

    template<class Real>
    core::Vec3<Real> placeIn(const TexturePlace<Real>& place) const {
        if (coordinates == "uv") return {place.uv.x, place.uv.y, Real(0)};
        return coordinates == "object" ? place.object : place.world;
    }
};

// The rows of those options, for a texture that has them beside others of its own.
template<class T>
std::array<core::OptionRow<T>, 4> mappingRows() {
    constexpr core::Range coordinate{.least = -1e18, .most = 1e18};
    return {{{.name = "coordinates",
              .member = static_cast<core::Word T::*>(&T::coordinates),
              .words = coordinateNames,
              .help = "which places it lies on: of the surface, of the object or of the world"},
             {.name = "scale",
              .member = static_cast<core::Scaling T::*>(&T::scale),
              .range = {.least = 0, .most = 1e18, .leastIncluded = false},
              .help = "makes it larger along its axes, first of all"},
             {.name = "rotate",
              .member = static_cast<glm::dvec3 T::*>(&T::rotate),
              .range = {.least = -1e6, .most = 1e6},
              .unit = "degrees",
              .help = "then turns it about the x, the y and the z axis, in this order"},
             {.name = "translate",
              .member = static_cast<glm::dvec3 T::*>(&T::translate),
              .range = coordinate,
              .help = "then moves it"}}};
}

// All rows of a texture: its own, then those.
template<class T, std::size_t n>
std::array<core::OptionRow<T>, n + 4> withMapping(const std::array<core::OptionRow<T>, n>& own) {
    std::array<core::OptionRow<T>, n + 4> rows;
    const auto mapping = mappingRows<T>();
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i < n ? own[i] : mapping[i - n];
    return rows;
}

}  // namespace materials
