#include <gtest/gtest.h>

#include "lanes/both_widths.h"

namespace lanes {
namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

std::vector<Numbers<3>> threeNumbers() {
    Inputs inputs(1);
    return makeInputs<3>(20'000, [&inputs] {
        const float a = inputs.any(), b = inputs.any(), c = inputs.any();
        return Numbers<3>{a, inputs.chance(0.1) ? a : b, c};
    });
}

// Else this program would test narrower lanes a second time.
TEST(Lanes, AreAsManyAsTheInstructionSetHas) {
#if defined(__AVX512F__)
    EXPECT_EQ(width, 16u);
#elif defined(__AVX__)
    EXPECT_EQ(width, 8u);
#else
    EXPECT_EQ(width, 4u);
#endif
}

// Without what is not a number: on AVX xsimd's != is false for it, where a float's is true. No formula may rest on
// that.
TEST(Lanes, CompareAndSelectLikeFloats) {
    expectSame(threeNumbers(), []<class Real>(const std::array<Real, 3>& x) {
        const Real a = x[0], b = x[1], c = x[2];
        return std::array<Real, 9>{core::select(a < b, a, c),
                                   core::select(a <= b, b, c),
                                   core::select(a == b, c, a),
                                   core::select(a != b, c, b),
                                   core::select((a > b) & (b >= c), a, c),
                                   core::select((a > b) | (b >= c), a, b),
                                   core::select(!(a < b), a, c),
                                   core::min(a, b),
                                   core::max(a, b)};
    });
}

TEST(Lanes, AreUnorderedLikeFloatsWithWhatIsNotANumber) {
    for (const auto& pair :
         {Numbers<2>{1, notANumber}, Numbers<2>{notANumber, 1}, Numbers<2>{notANumber, notANumber}}) {
        const auto results = expectSame(std::vector{pair}, []<class Real>(const std::array<Real, 2>& x) {
            return std::array<Real, 5>{asNumber<Real>(x[0] < x[1]), asNumber<Real>(x[0] <= x[1]),
                                       asNumber<Real>(x[0] > x[1]), asNumber<Real>(x[0] >= x[1]),
                                       asNumber<Real>(x[0] == x[1])};
        });
        EXPECT_EQ(results[0], (Numbers<5>{}));
    }
}

// As lanes.h promises.
TEST(Lanes, MinAndMaxGiveTheSecondWhereOneIsNotANumber) {
    const auto minAndMax = []<class Real>(const std::array<Real, 2>& x) {
        return std::array<Real, 2>{core::min(x[0], x[1]), core::max(x[0], x[1])};
    };
    EXPECT_EQ(expectSame(std::vector{Numbers<2>{notANumber, 2}}, minAndMax)[0], (Numbers<2>{2, 2}));
    const Numbers<2> second = expectSame(std::vector{Numbers<2>{2, notANumber}}, minAndMax)[0];
    EXPECT_TRUE(std::isnan(second[0]) && std::isnan(second[1]));
}

TEST(Lanes, CalculateLikeFloats) {
    expectSame(threeNumbers(), []<class Real>(const std::array<Real, 3>& x) {
        const Real a = x[0], b = x[1], c = x[2];
        return std::array<Real, 8>{a + b, a - b, a * b, a / b, -c, core::abs(a), core::sqrt(core::abs(b)), a * b + c};
    });
}

TEST(Lanes, HaveTheWholePartOfFloats) {
    Inputs inputs(2);
    const auto numbers = makeInputs<1>(20'000, [&] {
        const float exponent = inputs.uniform(-4, 31);
        return Numbers<1>{inputs.chance(0.1) ? inputs.oneOf({0, 0.99999994f, 1, 8388607.5f, 2147483520.f})
                                             : std::min(std::exp2(exponent), 2147483520.f)};
    });
    const auto results = expectSame(
        numbers, []<class Real>(const std::array<Real, 1>& x) { return std::array<Real, 1>{core::wholePart(x[0])}; });
    for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(results[i][0], std::trunc(numbers[i][0]));
}

TEST(Lanes, SelectVectorsLaneByLane) {
    expectSame(threeNumbers(), []<class Real>(const std::array<Real, 3>& x) {
        const core::Vec3<Real> yes(x[0], x[1], x[2]), no(x[2], x[0], x[1]);
        const core::Vec3<Real> v = core::select(x[0] < x[1], yes, no);
        return std::array<Real, 3>{v.x, v.y, v.z};
    });
}

TEST(Lanes, HoldABroadcastVectorInEveryLane) {
    const core::Vec3<Lanes> v = core::broadcast<Lanes>(core::Vec3f(1, 2, 3));
    EXPECT_TRUE(core::all(v.x == Lanes(1)) && core::all(v.y == Lanes(2)) && core::all(v.z == Lanes(3)));
    EXPECT_EQ(core::broadcast<float>(core::Vec3f(1, 2, 3)), core::Vec3f(1, 2, 3));
}

// None, one at each place, all but one, all.
TEST(Lanes, KnowAnyAndAllOfAMask) {
    EXPECT_TRUE(core::any(true) && core::all(true));
    EXPECT_FALSE(core::any(false) || core::all(false));
    EXPECT_FALSE(core::any(Lanes(1) < Lanes(0)));
    EXPECT_TRUE(core::all(Lanes(0) < Lanes(1)));
    for (std::size_t lane = 0; lane < width; ++lane) {
        Numbers<width> one{}, allButOne;
        allButOne.fill(1);
        one[lane] = 1;
        allButOne[lane] = 0;
        const core::Mask<Lanes> isOne = Lanes::load_unaligned(one.data()) == Lanes(1);
        const core::Mask<Lanes> isNotThatOne = Lanes::load_unaligned(allButOne.data()) == Lanes(1);
        EXPECT_TRUE(core::any(isOne)) << lane;
        EXPECT_EQ(core::all(isOne), width == 1) << lane;
        EXPECT_TRUE(core::any(isNotThatOne)) << lane;
        EXPECT_FALSE(core::all(isNotThatOne)) << lane;
        EXPECT_FALSE(core::any(isOne & isNotThatOne)) << lane;
        EXPECT_TRUE(core::all(isOne | isNotThatOne)) << lane;
    }
}

}  // namespace
}  // namespace lanes
