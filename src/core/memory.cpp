#include "core/memory.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

namespace core {

std::uint64_t availableMemory() {
    // "MemAvailable:  23456789 kB" (proc(5))
    std::ifstream file("/proc/meminfo");
    for (std::string line; std::getline(file, line);) {
        unsigned long long kilobytes = 0;
        if (std::sscanf(line.c_str(), "MemAvailable: %llu", &kilobytes) == 1) return kilobytes * 1024;
    }
    return std::numeric_limits<std::uint64_t>::max();
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
