// The list of lights: what a light must tell to be in it, and how its lights are counted.
#include "gr/light.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

// A light that lacks one thing is no light of the list.
struct WithoutSample : PointLight {
    void sample(const core::Vec3f&, const core::Vec2f&) const = delete;
};
struct WithoutShadowEnd : PointLight {
    void shadowEnd(const core::Vec3f&, const core::Vec3f&) const = delete;
};
struct WithoutDivideBy : PointLight {
    void divideBy(float) = delete;
};
struct WithoutBounds : PointLight {
    void bounds() const = delete;
};
struct WithoutPower : PointLight {
    void power() const = delete;
};
struct WithoutFalloff : PointLight {
    void falloff() const = delete;
};
struct WithoutText : PointLight {
    void text() const = delete;
};
struct WithOneNumberUntold : PointLight {
    float radius;
};
struct MetWithoutDensity : PointLight {
    static constexpr bool canBeMet = true;
    core::Rgbf emitted() const { return intensity; }
};
struct MetWithoutEmission : PointLight {
    static constexpr bool canBeMet = true;
    float pdfW(const core::Vec3f&, float) const { return 1; }
};
struct MetAndComplete : MetWithoutDensity {
    float pdfW(const core::Vec3f&, float) const { return 1; }
};
struct ANode : PointLight {
    static constexpr bool isNamed = false;
    void text() const = delete;
};

// An endless light needs no place, but tells what is seen of it.
struct Beyond : PointLight {
    static constexpr bool isEndless = true;
    void shadowEnd(const core::Vec3f&, const core::Vec3f&) const = delete;
    void bounds() const = delete;
    void falloff() const = delete;
    void moveBy(const core::Vec3f&) = delete;
};
struct UnseenThoughMet : Beyond {
    static constexpr bool canBeMet = true;
};
struct SeenBeyond : UnseenThoughMet {
    Seen<float> seen(const core::Vec3f&) const { return {}; }
};
static_assert(CompleteLight<Beyond> && !CompleteLight<UnseenThoughMet> && CompleteLight<SeenBeyond>);

static_assert(CompleteLight<AreaLight> && CompleteLight<PointLight> && CompleteLight<MetAndComplete> &&
              CompleteLight<ANode>);
static_assert(!CompleteLight<WithoutSample> && !CompleteLight<WithoutShadowEnd> && !CompleteLight<WithoutDivideBy> &&
              !CompleteLight<WithoutBounds> && !CompleteLight<WithoutPower> && !CompleteLight<WithoutFalloff> &&
              !CompleteLight<WithoutText> && !CompleteLight<WithOneNumberUntold> && !CompleteLight<MetWithoutDensity> &&
              !CompleteLight<MetWithoutEmission>);

static_assert(std::is_same_v<NamedLight, std::variant<PointLight, SpotLight, SunLight, ParallelLight>>);

TEST(LightList, CountsKindAfterKind) {
    Lights lights;
    EXPECT_EQ(lights.size(), 0u);
    EXPECT_EQ(lights.bytes(), 0u);
    lights.of<PointLight>().push_back({core::Vec3f(1), core::Rgbf(1), {0, 0, 1}});
    for (int i = 0; i < 3; ++i) lights.of<AreaLight>().push_back({});
    lights.of<PointLight>().push_back({core::Vec3f(2), core::Rgbf(1), {0, 0, 1}});
    lights.of<ParallelLight>().push_back(ParallelLight::make({0, -1, 0}, core::Rgbf(1)));
    EXPECT_EQ(lights.size(), 6u);
    EXPECT_EQ(lights.placed(), 5u);
    EXPECT_GE(lights.bytes(), 3 * sizeof(AreaLight) + 2 * sizeof(PointLight));

    // Lamps come first: a surface knows its lamp by the index in their array.
    std::vector<std::size_t> firsts, counts;
    lights.forEachKind([&](const auto& all, std::size_t first) {
        firsts.push_back(first);
        counts.push_back(all.size());
    });
    EXPECT_EQ(firsts, (std::vector<std::size_t>{0, 3, 5, 5, 5, 6}));
    EXPECT_EQ(counts, (std::vector<std::size_t>{3, 2, 0, 0, 1, 0}));

    std::vector<double> powers;
    lights.forEach([&](const auto& light) { powers.push_back(light.power()); });
    ASSERT_EQ(powers.size(), 6u);
    EXPECT_EQ(powers[2], 0);
    EXPECT_NEAR(powers[3], M_PI, 1e-6);
}

}  // namespace
}  // namespace gr
