#include "grsh/limits.h"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>

namespace grsh {

void limitMemory(std::uint64_t bytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    // Sanitizers reserve all addresses there are.
    (void)bytes;
#else
    // Each arena reserves addresses for more than it will use, and it is addresses that are counted.
    mallopt(M_ARENA_MAX, 2);
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    limit.rlim_max = limit.rlim_cur;
    setrlimit(RLIMIT_AS, &limit);
#endif
}

}  // namespace grsh
