// Counter-based random numbers: the n-th number is a function of n, so nobody has to be asked in any order.
#pragma once

#include <array>
#include <cstdint>

namespace core {

using RandomBlock = std::array<std::uint32_t, 4>;
using RandomKey = std::array<std::uint32_t, 2>;

// Philox4x32-10. Salmon et al., "Parallel Random Numbers: As Easy as 1, 2, 3" (SC 2011); it passes TestU01's BigCrush.
inline RandomBlock philox(RandomBlock counter, RandomKey key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
        const auto high = [](std::uint64_t product) { return static_cast<std::uint32_t>(product >> 32); };
        counter = {high(b) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b), high(a) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(a)};
        key[0] += 0x9E3779B9;
        key[1] += 0xBB67AE85;
    }
    return counter;
}

// The upper 24 bits as a number in [0, 1): every float of that spacing, each as likely, and never 1.
inline float toUnitInterval(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

}  // namespace core
