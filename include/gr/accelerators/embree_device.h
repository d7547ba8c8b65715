// Embree, as far as it makes our trees.
#pragma once

#include <atomic>
#include <cstddef>

struct RTCDeviceTy;

namespace gr {

// Loads the library when the first one is made: it is so large that every start of the program would feel it.
class EmbreeDevice {
public:
    EmbreeDevice();  // throws core::Error where Embree cannot be loaded
    ~EmbreeDevice();
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    RTCDeviceTy* get() const { return device_; }
    std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }
    void check() const;  // throws what went wrong since the last time

private:
    RTCDeviceTy* device_ = nullptr;
    std::atomic<std::ptrdiff_t> bytes_{0};
};

}  // namespace gr
