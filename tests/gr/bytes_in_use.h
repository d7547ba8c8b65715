// Memory that this program's tests have allocated, counted in database_memory_test.cpp; not under a sanitizer, whose
// own operator new and delete find the errors there.
#pragma once

#include <atomic>
#include <cstdint>

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GRSH_COUNTS_BYTES

extern std::atomic<std::int64_t> bytesInUse;
extern std::atomic<std::int64_t> mostBytesInUse;  // since a test set it

#endif
