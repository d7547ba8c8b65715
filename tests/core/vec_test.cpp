#include "core/vec.h"

#include <gtest/gtest.h>

namespace core {
namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

TEST(LargestComponent, LooksAtSizesNotSigns) {
    EXPECT_EQ(largestComponent({1, 2, 3}), 3);
    EXPECT_EQ(largestComponent({1, -4, 3}), 4);
    EXPECT_EQ(largestComponent({-5, -4, 3}), 5);
    EXPECT_EQ(largestComponent({0, -0.f, 0}), 0);
}

TEST(IsFinite, LooksAtEveryComponent) {
    EXPECT_TRUE(isFinite({1, -2, 3e38f}));
    for (const float bad : {notANumber, infinity, -infinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3f v(1);
            v[axis] = bad;
            EXPECT_FALSE(isFinite(v)) << bad << " on axis " << axis;
        }
    }
}

TEST(Select, TakesAWholeVector) {
    EXPECT_EQ(select(true, Vec3f(1, 2, 3), Vec3f(4, 5, 6)), Vec3f(1, 2, 3));
    EXPECT_EQ(select(false, Vec3f(1, 2, 3), Vec3f(4, 5, 6)), Vec3f(4, 5, 6));
}

// As lanes.h says: the second word wins where nothing can be compared.
TEST(MinAndMax, GiveTheSecondWhereOneIsNotANumber) {
    EXPECT_EQ(min(1.f, 2.f), 1);
    EXPECT_EQ(min(2.f, 1.f), 1);
    EXPECT_EQ(max(1.f, 2.f), 2);
    EXPECT_EQ(max(2.f, 1.f), 2);
    EXPECT_EQ(min(notANumber, 2.f), 2);
    EXPECT_EQ(max(notANumber, 2.f), 2);
    EXPECT_TRUE(std::isnan(min(2.f, notANumber)));
    EXPECT_TRUE(std::isnan(max(2.f, notANumber)));
}

TEST(WholePart, CutsOffTheFraction) {
    EXPECT_EQ(wholePart(0.f), 0);
    EXPECT_EQ(wholePart(0.99999994f), 0);
    EXPECT_EQ(wholePart(1.f), 1);
    EXPECT_EQ(wholePart(4.5f), 4);
    EXPECT_EQ(wholePart(8388607.5f), 8388607);
    EXPECT_EQ(wholePart(2147483520.f), 2147483520);
}

}  // namespace
}  // namespace core
