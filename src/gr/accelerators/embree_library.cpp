#include "gr/accelerators/embree_library.h"

#include "core/error.h"

#include <dlfcn.h>

namespace gr {
namespace {

template<class Function>
void find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr)
        throw core::Error("ACCELERATOR", "EMBREE", name, std::string("Embree has no function \"") + name + "\"");
}

EmbreeLibrary load() {
    const std::string version = std::to_string(RTC_VERSION_MAJOR);
    const std::string file = "libembree" + version + ".so." + version;
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        throw core::Error("ACCELERATOR", "EMBREE", file, std::string("cannot load Embree: ") + dlerror());
    EmbreeLibrary functions;
    const auto findIn = [&](const char* name, auto& function) { find(library, name, function); };
    findIn("rtcNewDevice", functions.rtcNewDevice);
    findIn("rtcReleaseDevice", functions.rtcReleaseDevice);
    findIn("rtcGetDeviceError", functions.rtcGetDeviceError);
    findIn("rtcSetDeviceMemoryMonitorFunction", functions.rtcSetDeviceMemoryMonitorFunction);
    findIn("rtcNewBVH", functions.rtcNewBVH);
    findIn("rtcReleaseBVH", functions.rtcReleaseBVH);
    findIn("rtcBuildBVH", functions.rtcBuildBVH);
    findIn("rtcThreadLocalAlloc", functions.rtcThreadLocalAlloc);
    return functions;
}

}  // namespace

const EmbreeLibrary& EmbreeLibrary::get() {
    static const EmbreeLibrary library = load();
    return library;
}

}  // namespace gr
