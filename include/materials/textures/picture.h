// Pictures as textures, from a file or from a script.
#pragma once

#include "core/floor.h"
#include "materials/textures/colour_map.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace materials {

// Linear colours, line after line from the top.
struct Texels {
    int width = 0, height = 0;  // at least 1
    std::vector<core::Rgbf> colours;
};

inline constexpr std::array<core::Word, 2> filterNames{"nearest", "linear"};
inline constexpr std::array<core::Word, 3> wrapNames{"repeat", "clamp", "mirror"};
inline constexpr std::array<core::Word, 3> textureCurveNames{"auto", "srgb", "linear"};

// A grid of texels over [0, 1]^2, v upwards, each a square with its colour in the middle.
struct Picture : Mapping {
    core::Word filter = "linear", wrap = "repeat";
    std::shared_ptr<const Texels> texels;  // never null where it is looked up

    Picture() { coordinates = "uv"; }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>&) const {
        const Real x = bounded<Real>(own.x * Real(static_cast<float>(texels->width)));
        const Real y = bounded<Real>((Real(1) - own.y) * Real(static_cast<float>(texels->height)));
        if (filter == "nearest") return texel<Real>(column<Real>(core::floor(x)), line<Real>(core::floor(y)));
        const Real fromX = x - Real(0.5f), fromY = y - Real(0.5f);
        const Real left = core::floor(fromX), top = core::floor(fromY), u = fromX - left, v = fromY - top;
        const Real x0 = column<Real>(left), x1 = column<Real>(left + Real(1));
        const Real y0 = line<Real>(top), y1 = line<Real>(top + Real(1));
        const core::Rgb<Real> above = mixed(texel<Real>(x0, y0), texel<Real>(x1, y0), u);
        const core::Rgb<Real> below = mixed(texel<Real>(x0, y1), texel<Real>(x1, y1), u);
        return mixed(above, below, v);
    }

private:
    // Beyond that floats tell no texels apart.
    template<class Real>
    static Real bounded(const Real& x) {
        return core::min(core::max(x, Real(-0x1p24f)), Real(0x1p24f));
    }
    template<class Real>
    static core::Rgb<Real> mixed(const core::Rgb<Real>& a, const core::Rgb<Real>& b, const Real& part) {
        return a + (b - a) * part;
    }
    template<class Real>
    Real column(const Real& x) const {
        return wrapped<Real>(x, static_cast<float>(texels->width));
    }
    template<class Real>
    Real line(const Real& y) const {
        return wrapped<Real>(y, static_cast<float>(texels->height));
    }
    // A whole number as one from 0 to size - 1.
    template<class Real>
    Real wrapped(const Real& x, float size) const {
        const Real zero(0), last(size - 1);
        Real inside = x;
        if (wrap == "repeat") {
            inside = x - core::floor(x * Real(1 / size)) * Real(size);
        } else if (wrap == "mirror") {
            const Real twice = x - core::floor(x * Real(0.5f / size)) * Real(2 * size);
            inside = core::min(twice, Real(2 * size - 1) - twice);
        }
        return core::min(core::max(inside, zero), last);
    }
    template<class Real>
    core::Rgb<Real> texel(const Real& x, const Real& y) const {
        const core::UInt<Real> index =
            core::toUInt(y) * core::UInt<Real>(static_cast<std::uint32_t>(texels->width)) + core::toUInt(x);
        return core::GatheredRow<Real, core::Rgbf>(texels->colours.data(), index).vector(0);
    }
};

template<class T>
std::array<core::OptionRow<T>, 2> pictureRows() {
    return {{{.name = "filter",
              .member = static_cast<core::Word T::*>(&T::filter),
              .words = filterNames,
              .help = "between the middles of texels: the nearest one's colour, or a mixture of four"},
             {.name = "wrap",
              .member = static_cast<core::Word T::*>(&T::wrap),
              .words = wrapNames,
              .help = "what is outside of [0,1]: the picture again, its edge, or its mirror image"}}};
}

// A picture in a file.
struct ImageTexture : Picture {
    static constexpr std::string_view typeName = "image";

    std::string file;
    core::Word curve = "auto";

    static std::span<const core::OptionRow<ImageTexture>> options() {
        static const auto picture = pictureRows<ImageTexture>();
        static const auto rows = withMapping<ImageTexture>(std::array<core::OptionRow<ImageTexture>, 4>{
            {{.name = "file",
              .member = &ImageTexture::file,
              .defaultText = "must be given",
              .help = "a picture, .png, .exr, .hdr or .pfm; its path is relative to the script's folder"},
             picture[0],
             picture[1],
             {.name = "curve",
              .member = &ImageTexture::curve,
              .words = textureCurveNames,
              .help = "how its numbers stand for light: as the file says, by the curve of sRGB, or in proportion"}}});
        return rows;
    }
};

// A picture as a program.
struct ScriptTexture : Picture {
    static constexpr std::string_view typeName = "script";

    core::Vec2f size{256, 256};
    core::Script body;

    static std::span<const core::OptionRow<ScriptTexture>> options() {
        static const auto picture = pictureRows<ScriptTexture>();
        static const auto rows = withMapping<ScriptTexture>(std::array<core::OptionRow<ScriptTexture>, 4>{
            {{.name = "size",
              .member = &ScriptTexture::size,
              .range = {.least = 1, .most = 16384},
              .form = "{w h}",
              .unit = "texels",
              .help = "for how many places the body is run"},
             {.name = "body",
              .member = &ScriptTexture::body,
              .defaultText = "must be given",
              .help = "run once for each texel with the variables u and v set to its middle, 0 to 1, v upwards; it "
                      "returns a colour"},
             picture[0],
             picture[1]}});
        return rows;
    }
};

}  // namespace materials
