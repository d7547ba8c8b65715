// Embree 3 or 4, loaded when it is first needed.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace gr {

// Embree's functions under their own names.
struct EmbreeLibrary {
    decltype(&::rtcNewDevice) rtcNewDevice;
    decltype(&::rtcReleaseDevice) rtcReleaseDevice;
    decltype(&::rtcGetDeviceError) rtcGetDeviceError;
    decltype(&::rtcSetDeviceMemoryMonitorFunction) rtcSetDeviceMemoryMonitorFunction;
    decltype(&::rtcNewBVH) rtcNewBVH;
    decltype(&::rtcReleaseBVH) rtcReleaseBVH;
    decltype(&::rtcBuildBVH) rtcBuildBVH;
    decltype(&::rtcThreadLocalAlloc) rtcThreadLocalAlloc;

    // Throws core::Error where it cannot be loaded, and tries again the next time.
    static const EmbreeLibrary& get();
};

}  // namespace gr
