#include "core/srgb.h"

#include <gtest/gtest.h>

namespace core {
namespace {

// A C library may round a power another way in the last bit of a double: no byte's light as a float depends on that.
TEST(Srgb, TheLightOfAByteIsTheSameFloatWhateverTheLastBitOfItsPower) {
    for (int byte = 0; byte < 256; ++byte) {
        const double light = decodeSrgb(byte / 255.0);
        EXPECT_EQ(static_cast<float>(std::nextafter(light, 0.0)), static_cast<float>(light)) << byte;
        EXPECT_EQ(static_cast<float>(std::nextafter(light, 2.0)), static_cast<float>(light)) << byte;
    }
}

}  // namespace
}  // namespace core
