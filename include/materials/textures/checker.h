// Two colours in turns.
#pragma once

#include "core/floor.h"
#include "materials/textures/colour_map.h"

#include <span>
#include <string_view>

namespace materials {

// Cubes, the first colour where the sum of their whole coordinates is even.
struct Checker : Mapping {
    static constexpr std::string_view typeName = "checker";

    core::ColourPair colours{core::Rgbf(0), core::Rgbf(1)};
    double size = 1;  // of a cube

    static std::span<const core::OptionRow<Checker>> options() {
        static const auto rows = withMapping<Checker>(
            std::array<core::OptionRow<Checker>, 2>{{{.name = "colours",
                                                      .member = &Checker::colours,
                                                      .range = {.least = 0, .most = 1e18},
                                                      .defaultText = "{black white}",
                                                      .help = "the two colours; textures may stand for them"},
                                                     {.name = "size",
                                                      .member = &Checker::size,
                                                      .range = {.least = 0, .most = 1e18, .leastIncluded = false},
                                                      .help = "how wide a field is"}}});
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> p = own * Real(static_cast<float>(1 / size));
        const auto cell = [&](int axis) { return core::Whole<Real>(p[axis] + Real(onFace)).number; };
        const core::UInt<Real> one(1), odd = (cell(0) + cell(1) + cell(2)) & one;
        const core::Mask<Real> isSecond = core::toReal(odd) > Real(0);
        if (!core::any(isSecond)) return colourAt<Real>(colours[0], place);
        if (core::all(isSecond)) return colourAt<Real>(colours[1], place);
        return core::select(isSecond, colourAt<Real>(colours[1], place), colourAt<Real>(colours[0], place));
    }
};

}  // namespace materials
