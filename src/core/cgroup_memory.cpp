#include "core/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string_view>

namespace core {
namespace {

// The files of a version of control groups; caches in them are given up when the memory is needed.
struct Version {
    const char* limit;
    const char* used;
    std::string_view cache;
};
constexpr Version kFirst = {"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file"};
constexpr Version kSecond = {"/memory.max", "/memory.current", "inactive_file"};

// False where there is no number: "max", or no such file.
bool read(const std::string& path, std::uint64_t& value) {
    return static_cast<bool>(std::ifstream(path) >> value);
}

std::uint64_t cacheOf(const std::string& folder, std::string_view cache) {
    std::ifstream file(folder + "/memory.stat");
    std::uint64_t value = 0;
    for (std::string name; file >> name >> value;)
        if (name == cache) return value;
    return 0;
}

std::uint64_t leftIn(const std::string& folder, const Version& version) {
    std::uint64_t limit = 0, used = 0;
    if (!read(folder + version.limit, limit) || !read(folder + version.used, used))
        return std::numeric_limits<std::uint64_t>::max();
    used -= std::min(used, cacheOf(folder, version.cache));
    return limit > used ? limit - used : 0;
}

// A group's limit holds for all below it. Where a container shows only its own groups, those above are not there.
std::uint64_t leftAlong(const std::string& mount, std::string group, const Version& version) {
    std::uint64_t left = leftIn(mount, version);
    while (group.size() > 1) {
        left = std::min(left, leftIn(mount + group, version));
        group.erase(group.rfind('/'));
    }
    return left;
}

bool hasWord(std::string_view list, std::string_view word) {
    return ("," + std::string(list) + ",").find("," + std::string(word) + ",") != std::string::npos;
}

}  // namespace

// Lines are "number:controllers:group"; the second version has the number 0 and no controllers.
std::uint64_t cgroupMemory(const std::string& groups, const std::string& mount) {
    std::uint64_t left = std::numeric_limits<std::uint64_t>::max();
    std::ifstream file(groups);
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == line.npos || second == line.npos || line[second + 1] != '/') continue;
        const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
        if (hasWord(controllers, "memory")) left = std::min(left, leftAlong(mount + "/memory", group, kFirst));
        if (!controllers.empty()) continue;
        left = std::min(left, leftAlong(mount, group, kSecond));
        left = std::min(left, leftAlong(mount + "/unified", group, kSecond));
    }
    return left;
}

}  // namespace core
