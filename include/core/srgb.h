// The curve of sRGB (IEC 61966-2-1).
#pragma once

#include <cmath>

namespace core {

// What a screen is given for light, and its inverse. Both are from 0 to 1.
inline double encodeSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
inline double decodeSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace core
