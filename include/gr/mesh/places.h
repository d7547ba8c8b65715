// Finds out which of many places were there before.
#pragma once

#include "core/vec.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace gr {

// A hash table of numbers of places. It keeps the numbers only: the places are its caller's.
template<class Place>
class PlaceTable {
public:
    // Makes room for so many different places, which would else be made bit by bit.
    void reserve(std::size_t places) { slots_.assign(std::bit_ceil(2 * places + 2), free); }

    // The number of the first place that equals places[number]: that number itself where there is none before.
    int firstLike(const Place* places, int number) { return firstLike(places, number, hash(places[number])); }

    // The same in three steps, for many places one after the other: the memory that is needed can be on its way while
    // earlier ones are looked for.
    static std::uint64_t hash(const Place& place) {
        std::uint64_t h = 0;
        for (int axis = 0; axis < 3; ++axis) {
            // -0 is at the same place as 0.
            h = (h ^ std::bit_cast<std::uint64_t>(static_cast<double>(place[axis]) + 0.0)) * 0x9E3779B97F4A7C15;
            h ^= h >> 32;
        }
        return h;
    }
    void fetchSlot(std::uint64_t hash) const {
        if (!slots_.empty()) __builtin_prefetch(&slots_[hash & (slots_.size() - 1)]);
    }
    void fetchPlace(const Place* places, std::uint64_t hash) const {
        const int number = slots_.empty() ? free : slots_[hash & (slots_.size() - 1)];
        if (number != free) __builtin_prefetch(&places[number]);
    }
    int firstLike(const Place* places, int number, std::uint64_t hash) {
        if (2 * (count_ + 1) > slots_.size()) grow(places);
        int& slot = find(places, places[number], hash);
        if (slot == free) {
            slot = number;
            ++count_;
        }
        return slot;
    }

private:
    static constexpr int free = -1;

    int& find(const Place* places, const Place& place, std::uint64_t hash) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = hash & mask;
        while (slots_[i] != free && places[slots_[i]] != place) i = (i + 1) & mask;
        return slots_[i];
    }

    void grow(const Place* places) {
        const std::vector<int> old = std::move(slots_);
        slots_.assign(old.empty() ? 1024 : 2 * old.size(), free);
        for (const int number : old)
            if (number != free) find(places, places[number], hash(places[number])) = number;
    }

    std::vector<int> slots_;
    std::size_t count_ = 0;
};

}  // namespace gr
