#include "gr/accelerators/embree_device.h"

#include "core/error.h"
#include "gr/accelerators/embree_library.h"

namespace gr {

EmbreeDevice::EmbreeDevice() : device_(EmbreeLibrary::get().rtcNewDevice(nullptr)) {
    if (device_ == nullptr) throw core::Error("ACCELERATOR", "EMBREE", "embree", "Embree does not run here");
    const auto count = [](void* bytes, ssize_t change, bool) {
        static_cast<std::atomic<std::ptrdiff_t>*>(bytes)->fetch_add(change, std::memory_order_relaxed);
        return true;
    };
    EmbreeLibrary::get().rtcSetDeviceMemoryMonitorFunction(device_, count, &bytes_);
}

EmbreeDevice::~EmbreeDevice() {
    EmbreeLibrary::get().rtcReleaseDevice(device_);
}

void EmbreeDevice::check() const {
    const RTCError error = EmbreeLibrary::get().rtcGetDeviceError(device_);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (error != RTC_ERROR_NONE)
        throw core::Error("ACCELERATOR", "EMBREE", std::to_string(error),
                          "Embree cannot build its tree (error " + std::to_string(error) + ")");
}

}  // namespace gr
