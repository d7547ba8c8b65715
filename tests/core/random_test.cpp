#include "core/random.h"

#include <gtest/gtest.h>

#include <limits>

namespace core {
namespace {

// The known answers that Random123, the paper's own code, publishes for philox4x32-10.
TEST(Philox, GivesTheKnownAnswers) {
    constexpr std::uint32_t ones = 0xffffffff;
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (RandomBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
              (RandomBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    // The digits of pi.
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (RandomBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(ToUnitInterval, ReachesZeroAndNeverOne) {
    EXPECT_EQ(toUnitInterval(0), 0.f);
    EXPECT_EQ(toUnitInterval(std::numeric_limits<std::uint32_t>::max()), 1 - 0x1p-24f);
    EXPECT_EQ(toUnitInterval(0x80000000), 0.5f);
}

TEST(ToUnitInterval, IsDecidedByTheUpper24Bits) {
    EXPECT_EQ(toUnitInterval(0xff), 0.f);
    EXPECT_EQ(toUnitInterval(0x100), 0x1p-24f);
    EXPECT_EQ(toUnitInterval(0x1ff), 0x1p-24f);
    for (std::uint32_t i = 0; i < 1u << 24; i += 997) EXPECT_EQ(toUnitInterval(i << 8) * 0x1p24, i);
}

}  // namespace
}  // namespace core
