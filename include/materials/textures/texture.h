// THE list of textures. To add one: write its header here beside checker.h, with a typeName, options and `at`, which
// gives the colour at a place, and add its name to TextureType. gr_texture, its help, its errors, both integrators, the
// fingerprint and the tests in tests/materials/ walk this list.
#pragma once

#include "materials/textures/cells.h"
#include "materials/textures/checker.h"
#include "materials/textures/gradient.h"
#include "materials/textures/marble.h"
#include "materials/textures/noise.h"
#include "materials/textures/picture.h"
#include "materials/textures/wood.h"

#include <concepts>
#include <cstdint>
#include <variant>

namespace materials {

using TextureType = std::variant<ImageTexture, Checker, Gradient, Noise, Marble, Wood, Cells, ScriptTexture>;

template<class T>
concept CompleteTexture = std::derived_from<T, Mapping> &&
    requires(const T& texture, core::Vec3<core::Lanes> own, TexturePlace<core::Lanes> place) {
    { T::typeName } -> std::convertible_to<std::string_view>;
    { T::options() } -> std::same_as<std::span<const core::OptionRow<T>>>;
    { texture.template at<core::Lanes>(own, place) } -> std::same_as<core::Rgb<core::Lanes>>;
};

// A texture that scripts can name: linear colours, no number of which is negative or not finite.
struct Texture {
    TextureType type;
    core::Transform toOwn;  // from its coordinates to its own space
    std::uint64_t fingerprint = 0;  // of all that it is made of

    // Not inlined: it stands in the way of every surface point, and most scenes have none.
    template<class Real>
    [[gnu::noinline]] core::Rgb<Real> at(const TexturePlace<Real>& place) const {
        return std::visit(
            [&](const auto& t) { return t.template at<Real>(toOwn.point(t.template placeIn<Real>(place)), place); },
            type);
    }
};

template<class Real>
core::Rgb<Real> colourAt(const core::Textured<core::Rgbf>& colour, const TexturePlace<Real>& place) {
    return colour.texture != nullptr ? colour.texture->template at<Real>(place) : core::broadcast<Real>(colour.value);
}

// Calls f.operator()<T>() for each type of the list, in its order.
template<class F>
void forEachTextureType(F&& f) {
    [&]<class... Types>(std::type_identity<std::variant<Types...>>) {
        static_assert((CompleteTexture<Types> && ...), "a texture of the list lacks something");
        (f.template operator()<Types>(), ...);
    }(std::type_identity<TextureType>{});
}

}  // namespace materials
