// Lanes one by one: masks as bits, and numbers that are put into lanes and taken out of them.
// Seen to fail with masks compared as numbers (on SSE), `or` for what differs, the last lane left out, lanes walked
// backwards or twice, the bit of a lane's neighbour, an index one too large, and whole numbers one too large.
#include <gtest/gtest.h>

#include "lanes/both_widths.h"

namespace lanes {
namespace {

constexpr std::uint32_t patterns = 1u << width;

core::Mask<Lanes> maskWith(std::uint32_t bits) {
    Numbers<width> isSet{};
    for (std::size_t lane = 0; lane < width; ++lane) isSet[lane] = (bits >> lane) % 2 == 1 ? 1 : 0;
    return Lanes::load_unaligned(isSet.data()) > Lanes(0);
}

TEST(LanesMask, IsItsBits) {
    EXPECT_EQ(core::bitsOf(true), 1u);
    EXPECT_EQ(core::bitsOf(false), 0u);
    for (std::uint32_t bits = 0; bits < patterns; ++bits) {
        ASSERT_EQ(core::bitsOf(maskWith(bits)), bits);
        ASSERT_EQ(core::countOf(maskWith(bits)), std::popcount(bits));
        ASSERT_EQ(core::bitsOf(core::maskOf<Lanes>(bits)), bits);
    }
    EXPECT_TRUE(core::maskOf<float>(1));
    EXPECT_FALSE(core::maskOf<float>(2));
}

TEST(LanesMask, DiffersWhereJustOneIsTrue) {
    EXPECT_TRUE(core::differ(true, false) && core::differ(false, true));
    EXPECT_FALSE(core::differ(true, true) || core::differ(false, false));
    support::TestRandom random(20);
    for (int i = 0; i < 20'000; ++i) {
        const auto a = static_cast<std::uint32_t>(random.nextBits() % patterns);
        const auto b = static_cast<std::uint32_t>(random.nextBits() % patterns);
        ASSERT_EQ(core::bitsOf(core::differ(maskWith(a), maskWith(b))), a ^ b) << a << " " << b;
    }
}

TEST(LanesMask, IsWalkedFromTheFirstLaneToTheLast) {
    for (const std::uint32_t bits : {0u, 1u, 2u, 0x80u, 0x8421u, 0xffffu, 0x80000001u, 0xffffffffu}) {
        std::vector<int> lanes, expected;
        core::forEachLane(bits, [&](int lane) { lanes.push_back(lane); });
        for (int lane = 0; lane < 32; ++lane)
            if (bits >> lane & 1) expected.push_back(lane);
        EXPECT_EQ(lanes, expected) << std::hex << bits;
    }
}

// A row of whole numbers below a bound, as many as there are lanes.
std::array<std::uint32_t, width> wholeNumbers(support::TestRandom& random, std::uint32_t bound) {
    std::array<std::uint32_t, width> row;
    for (std::uint32_t& number : row) {
        const std::uint64_t bits = random.nextBits();
        number = bits % 8 == 0 ? 0 : bits % 8 == 1 ? bound - 1 : static_cast<std::uint32_t>((bits >> 8) % bound);
    }
    return row;
}

TEST(LanesTable, IsReadWhereEachLaneSays) {
    support::TestRandom random(21);
    std::array<float, 1000> table;
    for (float& number : table) number = static_cast<float>(random.next());
    for (int i = 0; i < 2'000; ++i) {
        const auto indices = wholeNumbers(random, table.size());
        const core::LaneArray<Lanes> found(core::gather(table.data(), core::loadUInt<Lanes>(indices.data())));
        for (std::size_t lane = 0; lane < width; ++lane) {
            ASSERT_EQ(found[static_cast<int>(lane)], table[indices[lane]]) << lane;
            ASSERT_EQ(core::gather(table.data(), indices[lane]), table[indices[lane]]);
        }
    }
}

TEST(LanesWholeNumbers, AreRealsAndBack) {
    support::TestRandom random(22);
    for (int i = 0; i < 2'000; ++i) {
        const auto numbers = wholeNumbers(random, 1u << 24);
        const core::UInt<Lanes> row = core::loadUInt<Lanes>(numbers.data());
        const core::LaneArray<Lanes> reals(core::toReal(row)), back(core::toReal(core::toUInt(reals.real())));
        for (std::size_t lane = 0; lane < width; ++lane) {
            const auto number = static_cast<float>(numbers[lane]);
            ASSERT_EQ(reals[static_cast<int>(lane)], number);
            ASSERT_EQ(back[static_cast<int>(lane)], number);
            ASSERT_EQ(core::toUInt(core::toReal(core::loadUInt<float>(&numbers[lane]))), numbers[lane]);
        }
    }
}

TEST(LaneArray, IsWrittenLaneByLane) {
    core::LaneArray<Lanes> numbers(Lanes(-1));
    for (int lane = 0; lane < static_cast<int>(width); lane += 2) numbers[lane] = static_cast<float>(lane);
    Numbers<width> row;
    numbers.real().store_unaligned(row.data());
    for (std::size_t lane = 0; lane < width; ++lane)
        EXPECT_EQ(row[lane], lane % 2 == 0 ? static_cast<float>(lane) : -1.f);
    EXPECT_EQ(core::LaneArray<float>(3).real(), 3);
}

}  // namespace
}  // namespace lanes
