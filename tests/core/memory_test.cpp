#include "core/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace core {
namespace {

constexpr double kilobyte = 1024, megabyte = 1024 * kilobyte, gigabyte = 1024 * megabyte;

TEST(MemoryText, ChoosesTheUnit) {
    EXPECT_EQ(memoryText(0), "0 bytes");
    EXPECT_EQ(memoryText(999), "999 bytes");
    EXPECT_EQ(memoryText(1536), "1.5 KB");
    EXPECT_EQ(memoryText(3 * megabyte), "3 MB");
    EXPECT_EQ(memoryText(2.5 * gigabyte), "2.5 GB");
    EXPECT_EQ(memoryText(1024 * gigabyte), "1 TB");
    EXPECT_EQ(memoryText(1024 * 1024 * gigabyte), "1 PB");
    EXPECT_EQ(memoryText(0x1p60), "1 EB");
}

TEST(MemoryText, HasTwoDigitsOrAllBeforeThePoint) {
    EXPECT_EQ(memoryText(1.234 * megabyte), "1.2 MB");
    EXPECT_EQ(memoryText(12.34 * megabyte), "12 MB");
    EXPECT_EQ(memoryText(99.4 * megabyte), "99 MB");
    EXPECT_EQ(memoryText(123.4 * megabyte), "123 MB");
    EXPECT_EQ(memoryText(999.4 * megabyte), "999 MB");
    EXPECT_EQ(memoryText(1000 * kilobyte), "0.98 MB");
}

// 99.5 to 100 has no two digits to be rounded to.
TEST(MemoryText, RoundsUpToAHundred) {
    EXPECT_EQ(memoryText(99.7 * kilobyte), "100 KB");
    EXPECT_EQ(memoryText(99.99 * gigabyte), "100 GB");
}

// Past the last unit the number grows.
TEST(MemoryText, HasWordsForMoreThanThereIs) {
    EXPECT_EQ(memoryText(5e6 * 0x1p60), "5000000 EB");
}

TEST(AvailableMemory, IsPartOfTheMemoryOfTheMachine) {
    const auto physical =
        static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    const std::uint64_t available = availableMemory();
    EXPECT_GT(available, std::uint64_t{1} << 20);
    EXPECT_LE(available, physical);
}

}  // namespace
}  // namespace core
