#include "gr/mesh/import/confinement.h"

#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/open_below.h"

namespace gr::importer {
namespace {

// All that the first version of Landlock can forbid.
constexpr __u64 kEverything = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;

}  // namespace

void confineTo(int folder) {
    const landlock_ruleset_attr rules = {.handled_access_fs = kEverything};
    const core::Descriptor ruleset(static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0)));
    if (!ruleset.isOpen()) return;
    landlock_path_beneath_attr reads = {};
    reads.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    reads.parent_fd = folder;
    if (syscall(SYS_landlock_add_rule, ruleset.number(), LANDLOCK_RULE_PATH_BENEATH, &reads, 0) != 0) return;
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    syscall(SYS_landlock_restrict_self, ruleset.number(), 0);
}

}  // namespace gr::importer
