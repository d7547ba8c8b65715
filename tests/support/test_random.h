// Random numbers for tests that must not rest on the project's own.
#pragma once

#include <cstdint>

namespace support {

// splitmix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
class TestRandom {
public:
    explicit TestRandom(std::uint64_t seed) : state_(seed) {}

    std::uint64_t nextBits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    // Uniform in [0, 1).
    double next() { return static_cast<double>(nextBits() >> 11) * 0x1p-53; }

private:
    std::uint64_t state_;
};

}  // namespace support
