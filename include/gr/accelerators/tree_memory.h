// Memory for the nodes and leaves of a tree.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace gr {

// Blocks at multiples of 64 bytes, which stay until it goes.
class TreeMemory {
public:
    void* allocate(std::size_t bytes) {
        blocks_.reserve(blocks_.size() + 1);
        auto* block = static_cast<std::byte*>(::operator new(bytes, alignment));
        blocks_.emplace_back(block);
        bytes_ += bytes;
        return block;
    }
    std::size_t bytes() const { return bytes_ + blocks_.capacity() * sizeof(blocks_[0]); }

private:
    static constexpr std::align_val_t alignment{64};
    struct Release {
        void operator()(std::byte* block) const { ::operator delete(block, alignment); }
    };

    std::vector<std::unique_ptr<std::byte, Release>> blocks_;
    std::size_t bytes_ = 0;
};

}  // namespace gr
