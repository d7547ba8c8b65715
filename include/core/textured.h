// A number or a colour of a material that may be another one at each place of a surface.
#pragma once

#include "core/vec.h"

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace materials {
struct Texture;
}

namespace core {

// What the textures of a material give at a surface point, by the slots that they have there: or at one in each lane.
template<class Real>
struct TextureValues {
    static constexpr std::size_t mostSlots = 12;

    std::array<Rgb<Real>, mostSlots> slots;
};

// Of linear red, green and blue (IEC 61966-2-1): what stands for a colour where a number is asked for.
template<class Real>
Real luminance(const Rgb<Real>& c) {
    return Real(0.2126f) * c.x + Real(0.7152f) * c.y + Real(0.0722f) * c.z;
}

// Value: a colour, a number, or a pair of numbers, which then are alike.
template<class Value>
struct Textured {
    Value value{};  // where there is no texture
    std::shared_ptr<const materials::Texture> texture{};
    std::size_t slot = 0;  // in TextureValues, if there is one

    Textured() = default;
    Textured(const Value& value) : value(value) {}
    // Of a colour or a pair, by its numbers.
    template<class... Numbers>
    requires(sizeof...(Numbers) > 1 && (std::is_arithmetic_v<Numbers> && ...)) Textured(Numbers... numbers)
        : value(static_cast<float>(numbers)...) {}
    Textured(std::shared_ptr<const materials::Texture> texture, std::size_t slot)
        : texture(std::move(texture)), slot(slot) {}

    // What it is where the point's textures have been looked up. A point without `textures` is nowhere.
    template<class Real, class Point>
    auto at(const Point& point) const {
        if constexpr (requires { point.textures.slots; })
            if (texture != nullptr) return of<Real>(point.textures.slots[slot]);
        return constant<Real>(value);
    }

private:
    template<class Real>
    static auto of(const Rgb<Real>& found) {
        if constexpr (std::is_same_v<Value, Rgbf>)
            return found;
        else if constexpr (std::is_same_v<Value, Vec2f>)
            return Vec2<Real>(luminance<Real>(found));
        else
            return luminance<Real>(found);
    }
    template<class Real>
    static auto constant(const Rgbf& colour) {
        return broadcast<Real>(colour);
    }
    template<class Real>
    static auto constant(const Vec2f& pair) {
        return Vec2<Real>(Real(pair.x), Real(pair.y));
    }
    template<class Real>
    static auto constant(double number) {
        return Real(static_cast<float>(number));
    }
};

template<class Member>
inline constexpr bool isTextured = false;
template<class Value>
inline constexpr bool isTextured<Textured<Value>> = true;

}  // namespace core
