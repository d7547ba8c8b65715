#include "core/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace core {

namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

// What is left of the process's own limit of addresses.
std::uint64_t leftOfLimit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, pages * static_cast<std::uint64_t>(getpagesize()));
}

}  // namespace

std::uint64_t availableMemory() {
    const std::uint64_t most = leftOfLimit();
    // "MemAvailable:  23456789 kB" (proc(5))
    std::ifstream file("/proc/meminfo");
    for (std::string line; std::getline(file, line);) {
        unsigned long long kilobytes = 0;
        if (std::sscanf(line.c_str(), "MemAvailable: %llu", &kilobytes) == 1)
            return std::min<std::uint64_t>(most, kilobytes * 1024);
    }
    return most;
}

std::string memoryText(double bytes) {
    static constexpr const char* units[] = {"bytes", "KB", "MB", "GB", "TB", "PB", "EB"};
    int unit = 0;
    while (bytes >= 999.5 && unit < 6) {
        bytes /= 1024;
        ++unit;
    }
    char text[64];
    std::snprintf(text, sizeof text, unit == 0 || bytes >= 99.5 ? "%.0f %s" : "%.2g %s", bytes, units[unit]);
    return text;
}

}  // namespace core
