// Colour profiles, made byte by byte.
#pragma once

#include "image/image_file.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace image {

inline std::string bigEndian(std::uint32_t number, int bytes = 4) {
    std::string text;
    for (int i = bytes; i-- > 0;) text += static_cast<char>(number >> (8 * i));
    return text;
}

inline std::string fixedPoint(double number) {
    return bigEndian(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(number * 65536))));
}

// Tags of a profile: a curve as a table of so many numbers, as a power, or as the formula of sRGB.
template<class Curve>
std::string tableCurve(int count, const Curve& curve) {
    std::string tag = std::string("curv") + bigEndian(0) + bigEndian(static_cast<std::uint32_t>(count));
    for (int i = 0; i < count; ++i)
        tag += bigEndian(static_cast<std::uint32_t>(std::lround(65535 * curve(i / (count - 1.)))), 2);
    return tag;
}
inline std::string powerCurve(double power) {
    return std::string("curv") + bigEndian(0) + bigEndian(1) + bigEndian(static_cast<std::uint32_t>(power * 256), 2);
}
inline std::string parametricCurve(std::uint32_t kind, const std::vector<double>& numbers) {
    std::string tag = std::string("para") + bigEndian(0) + bigEndian(kind, 2) + bigEndian(0, 2);
    for (const double number : numbers) tag += fixedPoint(number);
    return tag;
}
inline std::string srgbCurve() {
    return parametricCurve(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});
}

inline std::string colourTag(const std::array<double, 3>& xyz) {
    return std::string("XYZ ") + bigEndian(0) + fixedPoint(xyz[0]) + fixedPoint(xyz[1]) + fixedPoint(xyz[2]);
}

// Version 2 has ASCII, version 4 UTF-16.
inline std::string descriptionTag(const std::string& name, bool isOld = true) {
    if (isOld)
        return std::string("desc") + bigEndian(0) + bigEndian(static_cast<std::uint32_t>(name.size() + 1)) + name +
               std::string(80, '\0');
    std::string letters;
    for (const char letter : name) letters += std::string(1, '\0') + letter;
    return std::string("mluc") + bigEndian(0) + bigEndian(1) + bigEndian(12) + "enUS" +
           bigEndian(static_cast<std::uint32_t>(letters.size())) + bigEndian(28) + letters;
}

using Tags = std::vector<std::pair<std::string, std::string>>;

// space: "RGB " or "GRAY".
inline std::string profileOf(const std::string& space, const Tags& tags) {
    std::string table = bigEndian(static_cast<std::uint32_t>(tags.size())), data;
    for (auto [name, tag] : tags) {
        const auto at = static_cast<std::uint32_t>(128 + 4 + 12 * tags.size() + data.size());
        table += name + bigEndian(at) + bigEndian(static_cast<std::uint32_t>(tag.size()));
        data += tag + std::string((4 - tag.size() % 4) % 4, '\0');
    }
    std::string header = bigEndian(static_cast<std::uint32_t>(128 + table.size() + data.size())) + "test" +
                         bigEndian(0x02100000) + "mntr" + space + "XYZ " + std::string(12, '\0') + "acsp";
    header.resize(68, '\0');
    // The white of all profiles, D50.
    header += fixedPoint(0.9642) + fixedPoint(1) + fixedPoint(0.8249);
    header.resize(128, '\0');
    return header + table + data;
}

inline std::string greyProfile(const std::string& name, const std::string& curve) {
    return profileOf("GRAY",
                     {{"desc", descriptionTag(name)}, {"wtpt", colourTag({0.9642, 1, 0.8249})}, {"kTRC", curve}});
}

struct ProfileColours {
    std::array<double, 3> red{0.43607, 0.22249, 0.01392}, green{0.38515, 0.71687, 0.09708},
        blue{0.14307, 0.06061, 0.71410};
};

inline Tags rgbTags(const std::string& curve, const ProfileColours& colours = {}) {
    return {{"desc", descriptionTag("Mine")},
            {"rXYZ", colourTag(colours.red)},
            {"gXYZ", colourTag(colours.green)},
            {"bXYZ", colourTag(colours.blue)},
            {"rTRC", curve},
            {"gTRC", curve},
            {"bTRC", curve}};
}

}  // namespace image
