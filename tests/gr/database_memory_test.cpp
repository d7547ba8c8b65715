// What a node costs. Global operator new and delete are replaced to count it, for all of this program's tests.
#include "gr/bytes_in_use.h"
#include "gr/database/database.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <cstdlib>
#include <new>

#ifdef GRSH_COUNTS_BYTES

std::atomic<std::int64_t> bytesInUse{0}, mostBytesInUse{0};

namespace {

// What glibc takes for an allocation: the memory itself and the size in front of it.
std::int64_t chunkSize(void* memory) {
    return memory == nullptr ? 0 : static_cast<std::int64_t>(malloc_usable_size(memory) + sizeof(std::size_t));
}

void countNew(std::int64_t chunk) {
    const std::int64_t now = bytesInUse.fetch_add(chunk, std::memory_order_relaxed) + chunk;
    std::int64_t most = mostBytesInUse.load(std::memory_order_relaxed);
    while (now > most && !mostBytesInUse.compare_exchange_weak(most, now, std::memory_order_relaxed)) {
    }
}

}  // namespace

// The array, nothrow and sized forms call these two; over-aligned memory is not counted. None of them is inlined: else
// g++ takes free for that of another kind of memory.
[[gnu::noinline]] void* operator new(std::size_t size) {
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) throw std::bad_alloc();
    countNew(chunkSize(memory));
    return memory;
}

[[gnu::noinline]] void operator delete(void* memory) noexcept {
    bytesInUse.fetch_sub(chunkSize(memory), std::memory_order_relaxed);
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}

namespace gr {
namespace {

TEST(DatabaseMemory, TheCountIsThatOfTheAllocator) {
    const std::int64_t before = bytesInUse;
    auto small = std::make_unique<char>();
    EXPECT_EQ(bytesInUse - before, 32);
    auto larger = std::make_unique<char[]>(100);
    EXPECT_GE(bytesInUse - before, 32 + 112);
    small.reset();
    larger.reset();
    EXPECT_EQ(bytesInUse, before);
}

TEST(DatabaseMemory, AMillionSpheresTakeLessThan300BytesEach) {
    constexpr int count = 1000000;
    const std::int64_t before = bytesInUse;
    {
        Database database;
        for (int i = 0; i < count; ++i) database.create(":", "s" + std::to_string(i), SphereNode{{i, 0, 0}, 0.5});
        EXPECT_EQ(database.nodeCount(), count + 1u);
        const double each = static_cast<double>(bytesInUse - before) / count;
        EXPECT_LT(each, 300);
        EXPECT_GT(each, sizeof(Node));  // or else nothing was counted
        database.reset();
        database.create(":", "s0", SphereNode{});
    }
    EXPECT_EQ(bytesInUse, before);
}

TEST(DatabaseMemory, WhatIsRemovedIsFreed) {
    Database database;
    const auto addAndRemove = [&] {
        database.create(":", "group", TransformNode{});
        for (int i = 0; i < 1000; ++i) {
            const std::string path =
                database.create(":group", "aNameTooLongForAShortString" + std::to_string(i), SphereNode{}).path();
            database.translate(path, {1, 2, 3});
        }
        database.createInstance(":", "copy", ":group");
        database.remove(":copy");
        database.remove(":group");
    };
    addAndRemove();  // the tables have grown
    const std::int64_t before = bytesInUse;
    for (int i = 0; i < 3; ++i) addAndRemove();
    EXPECT_EQ(bytesInUse, before);
}

}  // namespace
}  // namespace gr

#endif
