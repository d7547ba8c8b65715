// Textures give the same bits in lanes as at float.

#include <gtest/gtest.h>

#include "lanes/both_widths.h"
#include "materials/textures/texture.h"

namespace lanes {
namespace {

using materials::Texture;
using materials::TexturePlace;

// Near and far places, on faces of the lattice and off them.
std::vector<Numbers<3>> places() {
    Inputs inputs(7);
    return makeInputs<3>(10'000, [&inputs] {
        const float reach = inputs.oneOf({1.f, 1.f, 30.f, 1e6f, 1e12f});
        Numbers<3> place;
        for (float& x : place) {
            x = inputs.uniform(-reach, reach);
            if (inputs.chance(0.2)) x = std::floor(x);
        }
        return place;
    });
}

template<class T>
void fill(T& type) {
    if constexpr (std::derived_from<T, materials::Picture>) {
        materials::Texels texels{7, 5, {}};
        for (int i = 0; i < 35; ++i) texels.colours.emplace_back(0.01f * static_cast<float>(i * i % 97));
        type.texels = std::make_shared<materials::Texels>(std::move(texels));
    }
    if constexpr (std::derived_from<T, materials::Pattern>) {
        type.turbulence = 0.7;
        type.octaves = 3;
        type.map = {{0.2, core::Rgbf(1, 0, 0.5f)}, {0.5, core::Rgbf(0, 0.25f, 3)}, {0.5, core::Rgbf(1)}};
    }
}

void expectSameAt(const Texture& texture) {
    expectSame(places(), [&]<class Real>(const std::array<Real, 3>& x) {
        const core::Vec3<Real> p = vectorAt(x.data());
        const core::Rgb<Real> colour = texture.at<Real>(TexturePlace<Real>{{p.x, p.y}, p, p});
        return std::array<Real, 3>{colour.x, colour.y, colour.z};
    });
}

TEST(Textures, AreTheSameInLanes) {
    materials::forEachTextureType([]<class T>() {
        T type;
        fill(type);
        SCOPED_TRACE(T::typeName);
        expectSameAt({type, {}});
    });
}

TEST(Textures, PicturesAreTheSameInLanesHoweverTheyGoOn) {
    for (const core::Word filter : materials::filterNames)
        for (const core::Word wrap : materials::wrapNames) {
            materials::ImageTexture picture;
            fill(picture);
            picture.filter = filter;
            picture.wrap = wrap;
            SCOPED_TRACE(std::string(filter) + " " + std::string(wrap));
            expectSameAt({picture, {}});
        }
}

TEST(Textures, NestedOnesAreTheSameInLanes) {
    materials::Marble marble;
    const auto inner = std::make_shared<Texture>(Texture{marble, {}});
    materials::Checker checker;
    checker.colours = {core::Textured<core::Rgbf>(inner, 0), core::Rgbf(0.5f)};
    expectSameAt({checker, {}});
}

}  // namespace
}  // namespace lanes
