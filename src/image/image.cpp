#include "image/image.h"

#include "core/error.h"
#include "core/memory.h"

namespace image {

const ImageChannel* Image::find(const std::string& name) const {
    for (const ImageChannel& channel : channels)
        if (channel.name == name) return &channel;
    return nullptr;
}

std::string Image::channelNames() const {
    std::string names;
    for (const ImageChannel& channel : channels) names += (names.empty() ? "" : " ") + channel.name;
    return names;
}

void checkMemory(const Window& held, double bytesPerPixel) {
    const double needed = bytesPerPixel * held.width * held.height;
    const double available = static_cast<double>(core::availableMemory());
    if (needed > available)
        throw core::Error("MEMORY", "PICTURE", "",
                          "a picture of " + std::to_string(held.width) + " x " + std::to_string(held.height) +
                              " pixels takes " + core::memoryText(needed) + " of memory; " +
                              core::memoryText(available) + " are free");
}

}  // namespace image
