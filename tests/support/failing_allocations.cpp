// Loaded before grsh (LD_PRELOAD): operator new fails from the call on whose number is in FAIL_FROM, FAIL_COUNT times.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

long numberFrom(const char* variable, long otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::atol(text) : otherwise;
}

void* allocate(std::size_t bytes, std::size_t alignment) {
    static std::atomic<long> calls = 0;
    static const long from = numberFrom("FAIL_FROM", 0), count = numberFrom("FAIL_COUNT", 1);
    const long call = ++calls;
    if (from > 0 && call >= from && call - from < count) throw std::bad_alloc();
    const std::size_t size = (std::max(bytes, std::size_t{1}) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

constexpr std::size_t kUsual = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

// The array forms and those that do not throw call these.
void* operator new(std::size_t bytes) {
    return allocate(bytes, kUsual);
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
