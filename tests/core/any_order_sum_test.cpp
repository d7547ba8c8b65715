// Sums that do not depend on the order.
// Seen to fail with counts in double, a unit of 2^-8, sizes one too large, a text that loses a bit, and sizes without
// bound.
#include "core/any_order_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace core {
namespace {

AnyOrderSum sumOf(const std::vector<double>& numbers) {
    AnyOrderSum sum;
    for (const double x : numbers) sum.add(x);
    return sum;
}

// Numbers of sizes from 2^-60 to 2^60.
std::vector<double> manyNumbers(std::mt19937& random) {
    std::vector<double> numbers(2000);
    std::uniform_real_distribution<double> exponent(-60, 60);
    for (double& x : numbers) x = std::exp2(exponent(random));
    return numbers;
}

TEST(AnyOrderSum, IsTheSameInAnyOrderAndOfAnyParts) {
    std::mt19937 random(1);
    std::vector<double> numbers = manyNumbers(random);
    const AnyOrderSum sum = sumOf(numbers);
    for (int i = 0; i < 20; ++i) {
        std::shuffle(numbers.begin(), numbers.end(), random);
        EXPECT_EQ(sumOf(numbers).value(), sum.value());
        const auto cut = numbers.begin() + 100 * i;
        AnyOrderSum parts = sumOf({cut, numbers.end()});
        parts += sumOf({numbers.begin(), cut});
        EXPECT_EQ(parts, sum);
    }
}

TEST(AnyOrderSum, IsTrueFromTheSmallestToTheLargestNumber) {
    for (const double x : {1., 255.9, 256., 3.14e-9, 1e-300, 1e300, std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::min(), 4 * std::numeric_limits<double>::denorm_min()}) {
        EXPECT_NEAR(sumOf({x}).value() / x, 1, 0x1p-24) << x;
        EXPECT_NEAR(sumOf({x / 4, x / 2}).value() / (x / 4 + x / 2), 1, 0x1p-24) << x;
    }
    EXPECT_EQ(sumOf({}).value(), 0);
    EXPECT_EQ(sumOf({0, 0}).value(), 0);
    std::mt19937 random(2);
    const std::vector<double> numbers = manyNumbers(random);
    EXPECT_NEAR(sumOf(numbers).value() / std::accumulate(numbers.begin(), numbers.end(), 0.), 1, 0x1p-24);
}

TEST(AnyOrderSum, ComesBackFromItsText) {
    std::mt19937 random(3);
    for (const AnyOrderSum& sum : {sumOf({}), sumOf({5}), sumOf({1e-300, 1, 1e300}), sumOf(manyNumbers(random))})
        EXPECT_EQ(AnyOrderSum::fromText(sum.text()), sum);
    EXPECT_EQ(sumOf({}).text(), "0:0");
    EXPECT_EQ(sumOf({1, 2, 256}).text(), "0:50331648,1:16777216");
}

TEST(AnyOrderSum, IsReadFromNoOtherText) {
    for (const char* text : {"", "1", "1:", ":1", "1:2,", ",1:2", "1:-2", "1:2.5", "1:2 ", "201:1", "-2147483648:1",
                             "x", "1:99999999999999999999", "1:2;3:4"})
        EXPECT_FALSE(AnyOrderSum::fromText(text)) << text;
}

}  // namespace
}  // namespace core
