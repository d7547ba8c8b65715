#include "core/reader_child.h"

#include "core/open_below.h"

#include <linux/landlock.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>

namespace core::reader {
namespace {

// All that the first version of Landlock can forbid.
constexpr __u64 kEverything = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;

void setLimit(decltype(RLIMIT_AS) resource, double most) {
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_cur = std::min(static_cast<rlim_t>(most), limit.rlim_max);
    setrlimit(resource, &limit);
}

}  // namespace

Limits begin(char** words) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const Limits limits{std::strtod(words[1], nullptr), std::strtod(words[2], nullptr)};
    setLimit(RLIMIT_CORE, 0);
    limitMemory(limits.megabytes);
    limitSeconds(limits.seconds);
    return limits;
}

void limitMemory(double megabytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    setLimit(RLIMIT_AS, megabytes * (1 << 20));
#else
    (void)megabytes;
#endif
}

void limitSeconds(double seconds) {
    setLimit(RLIMIT_CPU, seconds);
}

void confineTo(int folder) {
    const landlock_ruleset_attr rules = {.handled_access_fs = kEverything};
    const Descriptor ruleset(static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0)));
    if (!ruleset.isOpen()) return;
    landlock_path_beneath_attr reads = {};
    reads.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    reads.parent_fd = folder;
    if (folder >= 0 && syscall(SYS_landlock_add_rule, ruleset.number(), LANDLOCK_RULE_PATH_BENEATH, &reads, 0) != 0)
        return;
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    syscall(SYS_landlock_restrict_self, ruleset.number(), 0);
}

void put(const void* data, std::size_t bytes) {
    for (const char* at = static_cast<const char*>(data); bytes > 0;) {
        const ssize_t count = write(channel, at, bytes);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) _exit(1);
        at += count;
        bytes -= static_cast<std::size_t>(count);
    }
}

void putSuccess() {
    constexpr std::uint32_t none = 0;
    put(&none, sizeof none);
}

void putError(std::string_view reason) {
    if (reason.empty()) reason = "it is not told why";
    const auto length = static_cast<std::uint32_t>(reason.size());
    put(&length, sizeof length);
    put(reason.data(), reason.size());
}

}  // namespace core::reader
