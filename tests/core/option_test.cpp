#include "core/option.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <limits>

#include "support/test_random.h"

namespace core {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Range, ContainsItsBoundsWhereTheyAreIncluded) {
    const Range closed{.least = -1, .most = 2};
    const Range open{.least = -1, .most = 2, .leastIncluded = false, .mostIncluded = false};
    for (const double inside : {-1 + 1e-15, 0.0, 2 - 1e-15}) {
        EXPECT_TRUE(closed.contains(inside)) << inside;
        EXPECT_TRUE(open.contains(inside)) << inside;
    }
    for (const double bound : {-1.0, 2.0}) {
        EXPECT_TRUE(closed.contains(bound)) << bound;
        EXPECT_FALSE(open.contains(bound)) << bound;
    }
    for (const double outside : {-1 - 1e-15, 2 + 1e-15, -1e300, 1e300}) {
        EXPECT_FALSE(closed.contains(outside)) << outside;
        EXPECT_FALSE(open.contains(outside)) << outside;
    }
}

TEST(Range, IsWithoutABoundWhereNoneIsGiven) {
    constexpr double most = std::numeric_limits<double>::max();
    for (const double x : {-most, -1.0, -0.0, 0.0, 5e-324, most}) EXPECT_TRUE(anyNumber.contains(x)) << x;
    EXPECT_TRUE(notNegative.contains(most));
    EXPECT_TRUE(notNegative.contains(-0.0));
    EXPECT_FALSE(notNegative.contains(-5e-324));
    EXPECT_TRUE(positive.contains(5e-324));
    EXPECT_FALSE(positive.contains(0));
    EXPECT_FALSE(positive.contains(-0.0));
    EXPECT_TRUE(unitInterval.contains(0) && unitInterval.contains(1));
    EXPECT_FALSE(unitInterval.contains(1 + 1e-15));
}

TEST(Range, NeverContainsWhatIsNotANumberOrInfinite) {
    for (const Range& range : {anyNumber, positive, notNegative, unitInterval})
        for (const double x : {notANumber, -notANumber, inf, -inf}) EXPECT_FALSE(range.contains(x)) << x;
}

TEST(RangeText, SaysWhatIsAllowed) {
    EXPECT_EQ(rangeText(anyNumber), "");
    EXPECT_EQ(rangeText(positive), "greater than 0");
    EXPECT_EQ(rangeText(notNegative), "at least 0");
    EXPECT_EQ(rangeText(unitInterval), "0 to 1");
    EXPECT_EQ(rangeText({.least = -64.5, .most = 64}), "-64.5 to 64");
    EXPECT_EQ(rangeText({.most = 5}), "at most 5");
    EXPECT_EQ(rangeText({.most = 5, .mostIncluded = false}), "less than 5");
    EXPECT_EQ(rangeText({.least = 0, .most = 180, .leastIncluded = false, .mostIncluded = false}),
              "greater than 0 and less than 180");
    EXPECT_EQ(rangeText({.least = 0, .most = 90, .leastIncluded = false}), "greater than 0 and at most 90");
    EXPECT_EQ(rangeText({.least = 0, .most = 90, .mostIncluded = false}), "at least 0 and less than 90");
    EXPECT_EQ(rangeText({.least = 1, .most = 2147483647}), "1 to 2147483647");
}

TEST(NumberText, IsTheShortestThatReadsBack) {
    EXPECT_EQ(numberText(0.0), "0");
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(-2.5), "-2.5");
    EXPECT_EQ(numberText(1 / 3.0), "0.3333333333333333");
    EXPECT_EQ(numberText(0.1f), "0.1");
    EXPECT_EQ(numberText(1 / 3.f), "0.33333334");
    EXPECT_EQ(numberText(16777216.f), "16777216");
    EXPECT_EQ(numberText(1e-7), "1e-07");
    // Not the shortest decimal of the double that 0.1f is.
    EXPECT_EQ(numberText(static_cast<double>(0.1f)), "0.10000000149011612");
}

TEST(NumberText, ReadsBackWhateverTheBits) {
    support::TestRandom random(5);
    for (int i = 0; i < 100'000; ++i) {
        const auto x = std::bit_cast<double>(random.nextBits());
        const auto y = std::bit_cast<float>(static_cast<std::uint32_t>(random.nextBits()));
        ASSERT_TRUE(!std::isfinite(x) || std::strtod(numberText(x).c_str(), nullptr) == x) << numberText(x);
        ASSERT_TRUE(!std::isfinite(y) || std::strtof(numberText(y).c_str(), nullptr) == y) << numberText(y);
    }
}

constexpr std::array<Word, 3> colours{"red", "green", "blue"};

struct Owner {
    bool flag = true;
    int count = -7;
    std::uint64_t seed = 18446744073709551615u;
    double size = 0.1;
    Rgbf colour{0.5f, 0.1f, 1};
    std::optional<int> line;
    Vec2f pair{100, 0.1f};
    std::optional<Weights> weights;
    Word word = colours[1];
    WordList some;
};

using Row = OptionRow<Owner>;

const Row flagRow{.name = "flag", .member = &Owner::flag};
const Row countRow{.name = "count", .member = &Owner::count};
const Row seedRow{.name = "seed", .member = &Owner::seed};
const Row sizeRow{.name = "size", .member = &Owner::size};
const Row colourRow{.name = "colour", .member = &Owner::colour};
const Row lineRow{.name = "line", .member = &Owner::line, .defaultText = "height-1"};
const Row pairRow{.name = "pair", .member = &Owner::pair, .form = "{nu nv}"};
const Row weightsRow{.name = "weights", .member = &Owner::weights, .form = "{a b c d}", .defaultText = "{1 0 0 0}"};
const Row absorptionRow{.name = "absorption", .member = &Owner::colour, .form = "{ar ag ab}"};
const Row wordRow{.name = "word", .member = &Owner::word, .words = colours};
const Row someRow{.name = "some", .member = &Owner::some, .words = colours};

TEST(OptionText, WritesTheValueOfARow) {
    Owner owner;
    EXPECT_EQ(optionText(flagRow, owner), "on");
    EXPECT_EQ(optionText(countRow, owner), "-7");
    EXPECT_EQ(optionText(seedRow, owner), "18446744073709551615");
    EXPECT_EQ(optionText(sizeRow, owner), "0.1");
    EXPECT_EQ(optionText(colourRow, owner), "0.5 0.1 1");
    EXPECT_EQ(optionText(lineRow, owner), "");
    EXPECT_EQ(optionText(pairRow, owner), "100 0.1");
    EXPECT_EQ(optionText(weightsRow, owner), "");
    EXPECT_EQ(optionText(wordRow, owner), "green");
    EXPECT_EQ(optionText(someRow, owner), "");
    owner.flag = false;
    owner.line = 12;
    owner.weights = Weights{0.25f, 0, 1 / 3.f, 1e-6f};
    owner.word = colours[2];
    EXPECT_EQ(optionText(flagRow, owner), "off");
    EXPECT_EQ(optionText(lineRow, owner), "12");
    EXPECT_EQ(optionText(weightsRow, owner), "0.25 0 0.33333334 1e-06");
    EXPECT_EQ(optionText(wordRow, owner), "blue");
    owner.some = {colours[2], colours[0]};
    EXPECT_EQ(optionText(someRow, owner), "blue red");
}

TEST(DefaultText, IsTheDefaultOfTheOwnerUnlessTheRowHasWordsForIt) {
    EXPECT_EQ(defaultText(flagRow), "on");
    EXPECT_EQ(defaultText(countRow), "-7");
    EXPECT_EQ(defaultText(seedRow), "18446744073709551615");
    EXPECT_EQ(defaultText(sizeRow), "0.1");
    EXPECT_EQ(defaultText(colourRow), "{0.5 0.1 1}");
    EXPECT_EQ(defaultText(lineRow), "height-1");
    EXPECT_EQ(defaultText(pairRow), "{100 0.1}");
    EXPECT_EQ(defaultText(weightsRow), "{1 0 0 0}");
    EXPECT_EQ(defaultText(absorptionRow), "{0.5 0.1 1}");
    EXPECT_EQ(defaultText(wordRow), "green");
    EXPECT_EQ(defaultText(someRow), "{}");
}

TEST(TypeText, SaysWhatAnOptionTakes) {
    EXPECT_EQ(typeText(flagRow), "on/off");
    EXPECT_EQ(typeText(countRow), "integer");
    EXPECT_EQ(typeText(seedRow), "integer");
    EXPECT_EQ(typeText(sizeRow), "number");
    EXPECT_EQ(typeText(colourRow), "{r g b}");
    EXPECT_EQ(typeText(lineRow), "integer");
    EXPECT_EQ(typeText(pairRow), "{nu nv}");
    EXPECT_EQ(typeText(weightsRow), "{a b c d}");
    EXPECT_EQ(typeText(absorptionRow), "{ar ag ab}");
    EXPECT_EQ(typeText(wordRow), "red|green|blue");
    EXPECT_EQ(typeText(someRow), "list of red|green|blue");
}

}  // namespace
}  // namespace core
