#include "core/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

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

// In a process of its own, for a limit that is lowered stays so.
TEST(AvailableMemory, KnowsTheLimitOfAddressSpace) {
    const auto lowerAndAsk = [] {
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const std::uint64_t used = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
        const auto limit = used + static_cast<std::uint64_t>(64 * megabyte);
        const rlimit lower = {limit, limit};
        if (setrlimit(RLIMIT_AS, &lower) != 0) _exit(2);
        const std::uint64_t available = availableMemory();
        _exit(available > 32 * megabyte && available <= 64 * megabyte ? 0 : 1);
    };
    EXPECT_EXIT(lowerAndAsk(), testing::ExitedWithCode(0), "");
}

class CgroupMemory : public testing::Test {
protected:
    CgroupMemory() { std::filesystem::create_directories(folder_); }
    ~CgroupMemory() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text << "\n";
    }
    std::uint64_t left() const { return cgroupMemory(folder_ / "groups", folder_); }

    static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

private:
    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("grsh-cgroup-test-" + std::to_string(getpid()));
};

TEST_F(CgroupMemory, IsUnlimitedWithoutGroups) {
    EXPECT_EQ(left(), unlimited);
    write("groups", "0::/a");
    EXPECT_EQ(left(), unlimited);
    write("a/memory.max", "max");
    write("a/memory.current", "100");
    EXPECT_EQ(left(), unlimited);
}

TEST_F(CgroupMemory, IsTheLeastOfAGroupAndThoseAboveIt) {
    write("groups", "0::/a/b");
    write("a/b/memory.max", "1000");
    write("a/b/memory.current", "100");
    EXPECT_EQ(left(), 900u);
    write("a/memory.max", "500");
    write("a/memory.current", "200");
    EXPECT_EQ(left(), 300u);
    write("memory.max", "400");
    write("memory.current", "390");
    EXPECT_EQ(left(), 10u);
    write("memory.current", "410");
    EXPECT_EQ(left(), 0u);
}

TEST_F(CgroupMemory, CountsCachesAsFree) {
    write("groups", "0::/");
    write("memory.max", "1000");
    write("memory.current", "900");
    write("memory.stat", "anon 500\ninactive_file 300\nactive_file 100");
    EXPECT_EQ(left(), 400u);
}

TEST_F(CgroupMemory, KnowsTheFirstVersion) {
    write("groups", "5:cpu,cpuacct:/c\n4:memory:/a\n0::/");
    write("memory/a/memory.limit_in_bytes", "1000");
    write("memory/a/memory.usage_in_bytes", "700");
    write("memory/a/memory.stat", "inactive_file 1\ntotal_inactive_file 50");
    EXPECT_EQ(left(), 350u);
}

// A container's list may name a group that only the host sees; what is mounted is then the container's own.
TEST_F(CgroupMemory, FindsTheContainersOwn) {
    write("groups", "0::/docker/0123");
    write("memory.max", "1000");
    write("memory.current", "700");
    EXPECT_EQ(left(), 300u);
}

}  // namespace
}  // namespace core
