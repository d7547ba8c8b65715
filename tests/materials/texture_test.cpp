// Textures against what their words say, place by place.
// Seen to fail with v downwards, texels half a texel off, a mirror image a texel off, rotations in the other order,
// colours mixed beyond the last stop, cells that begin just at their place, a lattice of noise whose cells do not meet,
// and numbers that are not cut to their range.

#include "materials/material.h"
#include "support/test_random.h"

#include <gtest/gtest.h>

namespace materials {
namespace {

using core::Rgbf;
using core::Vec3f;

template<class T>
Texture made(const T& type) {
    return {type, type.toTexture()};
}

// In object coordinates.
template<class T>
Rgbf at(const T& type, const Vec3f& place) {
    return made(type).template at<float>({{0, 0}, place, {0, 0, 0}});
}

template<class T>
Rgbf atUv(const T& type, float u, float v) {
    return made(type).template at<float>({{u, v}, {0, 0, 0}, {0, 0, 0}});
}

// 2 x 2 texels: red and green above, blue and white below.
template<class T = ImageTexture>
T fourTexels(core::Word filter, core::Word wrap = "repeat") {
    T picture;
    picture.filter = filter;
    picture.wrap = wrap;
    picture.texels = std::make_shared<Texels>(Texels{2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}});
    return picture;
}

TEST(Texture, CheckerTakesTurnsAlongEachAxis) {
    const Checker checker;
    for (int x = -3; x < 3; ++x)
        for (int y = -3; y < 3; ++y)
            for (int z = -3; z < 3; ++z) {
                const Rgbf expected((x + y + z) % 2 == 0 ? 0.f : 1.f);
                EXPECT_EQ(at(checker, Vec3f(x, y, z) + Vec3f(0.5f, 0.25f, 0.9f)), expected)
                    << x << " " << y << " " << z;
                // A face where cells meet, wherever rounding has put it.
                EXPECT_EQ(at(checker, Vec3f(x, y, z) + Vec3f(0.5f, -1e-6f, 0.5f)), expected);
                EXPECT_EQ(at(checker, Vec3f(x, y, z) + Vec3f(0.5f, 1e-6f, 0.5f)), expected);
            }
}

TEST(Texture, CheckerIsAsLargeAsItsSizeAndItsScaleSay) {
    Checker checker;
    checker.size = 0.5;
    checker.scale.by = {4, 1, 1};
    EXPECT_EQ(at(checker, {1.9f, 0.1f, 0.1f}), Rgbf(0));
    EXPECT_EQ(at(checker, {2.1f, 0.1f, 0.1f}), Rgbf(1));
    EXPECT_EQ(at(checker, {0.1f, 0.6f, 0.1f}), Rgbf(1));
}

// Scaled, then turned about x, y and z, then moved: what is at (1, 0, 0) comes to rest where that leads.
TEST(Texture, IsScaledThenRotatedThenTranslated) {
    Gradient gradient;
    gradient.scale.by = {2, 4, 8};
    gradient.rotate = {90, 90, 0};
    gradient.translate = {10, 20, 30};
    // Its own (0, 1/4, 0) is scaled to (0, 1, 0), turned about x to (0, 0, 1) and about y to (1, 0, 0).
    EXPECT_NEAR(at(gradient, {11, 20, 30}).x, 0.25f, 1e-5f);
    EXPECT_NEAR(at(gradient, {12, 25, 37}).x, 0.5f, 1e-5f);
}

TEST(Texture, MapMixesBetweenItsStopsAndKeepsItsEnds) {
    Gradient gradient;
    gradient.map = {{0.25, Rgbf(1, 0, 0)}, {0.5, Rgbf(0, 1, 0)}, {0.5, Rgbf(0, 0, 1)}, {0.75, Rgbf(1, 1, 1)}};
    const auto is = [&](float y, const Rgbf& expected) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(at(gradient, {0, y, 0})[i], expected[i], 1e-5f) << y;
    };
    is(0.125f, {1, 0, 0});
    is(0.375f, {0.5f, 0.5f, 0});
    is(0.499f, {0.004f, 0.996f, 0});
    is(0.5f, {0, 0, 1});
    is(0.625f, {0.5f, 0.5f, 1});
    is(0.9f, {1, 1, 1});
    is(1.375f, {0.5f, 0.5f, 0});
    is(-0.625f, {0.5f, 0.5f, 0});
}

TEST(Texture, PictureHasItsTexelsWhereTheyAre) {
    for (const core::Word filter : filterNames) {
        const ImageTexture picture = fourTexels(filter);
        EXPECT_EQ(atUv(picture, 0.25f, 0.75f), Rgbf(1, 0, 0));
        EXPECT_EQ(atUv(picture, 0.75f, 0.75f), Rgbf(0, 1, 0));
        EXPECT_EQ(atUv(picture, 0.25f, 0.25f), Rgbf(0, 0, 1));
        EXPECT_EQ(atUv(picture, 0.75f, 0.25f), Rgbf(1, 1, 1));
    }
    EXPECT_EQ(atUv(fourTexels("nearest"), 0.45f, 0.55f), Rgbf(1, 0, 0));
    EXPECT_EQ(atUv(fourTexels("linear"), 0.5f, 0.5f), Rgbf(0.5f));
    EXPECT_EQ(atUv(fourTexels("linear"), 0.5f, 0.75f), Rgbf(0.5f, 0.5f, 0));
}

TEST(Texture, PictureGoesOnBeyondItsEdgesAsItIsTold) {
    EXPECT_EQ(atUv(fourTexels("nearest", "repeat"), 1.25f, -0.25f), Rgbf(1, 0, 0));
    EXPECT_EQ(atUv(fourTexels("nearest", "clamp"), 1.25f, -0.25f), Rgbf(1, 1, 1));
    EXPECT_EQ(atUv(fourTexels("nearest", "mirror"), 1.25f, -0.25f), Rgbf(1, 1, 1));
    EXPECT_EQ(atUv(fourTexels("nearest", "mirror"), 1.75f, 0.25f), Rgbf(0, 0, 1));
    EXPECT_EQ(atUv(fourTexels("linear", "repeat"), 0, 0.75f), Rgbf(0.5f, 0.5f, 0));
    EXPECT_EQ(atUv(fourTexels("linear", "clamp"), 0, 0.75f), Rgbf(1, 0, 0));
    EXPECT_EQ(atUv(fourTexels("linear", "mirror"), 0, 0.75f), Rgbf(1, 0, 0));
}

TEST(Texture, MarbleAndWoodRiseAndFall) {
    Marble marble;
    marble.turbulence = 0;
    EXPECT_NEAR(at(marble, {0.25f, 7, 9}).x, 0.5f, 1e-6f);
    EXPECT_NEAR(at(marble, {-0.5f, 7, 9}).x, 1, 1e-6f);
    Wood wood;
    wood.turbulence = 0;
    wood.frequency = 2;
    EXPECT_NEAR(at(wood, {0.3f, 0.4f, 9}).x, 0, 1e-5f);
    EXPECT_NEAR(at(wood, {0.15f, 0.2f, 9}).x, 1, 1e-5f);
}

TEST(Texture, CellsAreEvenlyDrawnAndEachOfOneColour) {
    const Cells cells;
    double sum = 0, squares = 0;
    constexpr int count = 20;
    for (int x = 0; x < count; ++x)
        for (int y = 0; y < count; ++y)
            for (int z = 0; z < count; ++z) {
                const Vec3f corner(static_cast<float>(x - 10), static_cast<float>(y - 10), static_cast<float>(z - 10));
                const float number = at(cells, corner + Vec3f(0.1f)).x;
                EXPECT_EQ(at(cells, corner + Vec3f(0.9f)).x, number);
                sum += number;
                squares += double{number} * number;
            }
    constexpr double all = count * count * count;
    // Four standard errors of a uniform number's mean, and of its square's.
    EXPECT_NEAR(sum / all, 0.5, 4 * std::sqrt(1 / 12. / all));
    EXPECT_NEAR(squares / all, 1 / 3., 4 * std::sqrt(4 / 45. / all));
}

// Across the faces of the lattice, too, neither noise nor its slope jumps.
TEST(Texture, NoiseIsSmoothZeroOnTheLatticeAndFillsItsRange) {
    support::TestRandom random(1);
    const auto coordinate = [&] { return static_cast<float>(random.next() * 20 - 10); };
    float least = 1, most = -1;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f p(coordinate(), coordinate(), coordinate());
        const float here = LatticeNoise<float>::at(p, 1);
        least = std::min(least, here);
        most = std::max(most, here);
        const Vec3f face(std::floor(p.x), p.y, p.z);
        constexpr float step = 1e-3f;
        const auto beside = [&](float x) { return LatticeNoise<float>::at(face + Vec3f(x, 0, 0), 1); };
        EXPECT_NEAR(beside(-step), beside(step), 4e-3f);
        EXPECT_NEAR(beside(0) - beside(-step), beside(step) - beside(0), 3e-5f);
        EXPECT_EQ(LatticeNoise<float>::at(glm::floor(p), 1), 0);
    }
    EXPECT_LT(least, -0.8f);
    EXPECT_GT(most, 0.8f);
}

TEST(Texture, AnotherSeedIsAnotherPattern) {
    Noise one, other;
    other.seed = 1;
    int same = 0;
    for (int i = 0; i < 100; ++i)
        same += at(one, Vec3f(static_cast<float>(i) * 0.37f)) == at(other, Vec3f(static_cast<float>(i) * 0.37f));
    EXPECT_LE(same, 2);
}

// Far beyond what floats tell apart, patterns are something finite.
TEST(Texture, FarPlacesAreFinite) {
    forEachTextureType([]<class T>() {
        T type;
        if constexpr (std::derived_from<T, Picture>) type = fourTexels<T>("linear");
        for (const float far : {1e10f, -1e18f, 3e38f}) {
            const Rgbf colour = made(type).template at<float>({{far, far}, Vec3f(far), Vec3f(far)});
            EXPECT_TRUE(core::isFinite(colour)) << T::typeName << " at " << far;
        }
    });
}

// The slots of a material's textures are their rows' numbers.
TEST(Texture, EveryMaterialHasSlotsForAllItsTextures) {
    forEachMaterialType([]<class M>() {
        for (std::size_t i = 0; i < M::options().size(); ++i)
            std::visit(
                [&]<class Value>(Value M::*) {
                    if constexpr (core::isTextured<Value>) {
                        EXPECT_LT(i, core::TextureValues<float>::mostSlots) << M::typeName;
                    }
                },
                M::options()[i].member);
    });
}

TEST(Texture, StandsForAColourAndForANumber) {
    core::TextureValues<float> values;
    values.slots[3] = {0.2f, 0.4f, 0.6f};
    const struct { core::TextureValues<float> textures; } point{values};
    const auto any = std::make_shared<Texture>(made(Checker{}));
    EXPECT_EQ((core::Textured<Rgbf>(any, 3).at<float>(point)), Rgbf(0.2f, 0.4f, 0.6f));
    const float luminance = 0.2126f * 0.2f + 0.7152f * 0.4f + 0.0722f * 0.6f;
    EXPECT_FLOAT_EQ((core::Textured<double>(any, 3).at<float>(point)), luminance);
    EXPECT_FLOAT_EQ((core::Textured<core::Vec2f>(any, 3).at<float>(point)).y, luminance);
    EXPECT_EQ((core::Textured<Rgbf>(0.1f, 0.2f, 0.3f).at<float>(point)), Rgbf(0.1f, 0.2f, 0.3f));
}

// Beyond the range of what it stands for it is cut off.
TEST(Texture, IsKeptInTheRangeOfWhatItStandsFor) {
    Checker checker;
    checker.colours = {Rgbf(7, 0.5f, 0), Rgbf(1)};
    const auto texture = std::make_shared<Texture>(made(checker));
    const Material material = Diffuse{.reflectance = {texture, 0}};
    const std::vector<TextureUse> uses = textureUses(material);
    ASSERT_EQ(uses.size(), 1u);
    EXPECT_EQ(uses[0].at<float>({{0, 0}, {0.5f, 0.5f, 0.5f}, {0, 0, 0}}), Rgbf(1, 0.5f, 0));
}

}  // namespace
}  // namespace materials
