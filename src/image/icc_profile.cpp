#include "image/icc_profile.h"

#include "image/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace image {
namespace {

// All that lies beyond the end is 0.
std::uint32_t wholeNumber(ProfileBytes bytes, std::size_t at, std::size_t size) {
    std::uint32_t number = 0;
    for (std::size_t i = at; i < at + size; ++i) number = number << 8 | (i < bytes.size() ? bytes[i] : 0);
    return number;
}

double fixedPoint(ProfileBytes bytes, std::size_t at) {
    return static_cast<std::int32_t>(wholeNumber(bytes, at, 4)) / 65536.;
}

bool isNamed(ProfileBytes bytes, std::size_t at, std::string_view name) {
    return at + name.size() <= bytes.size() && std::equal(name.begin(), name.end(), bytes.begin() + std::ptrdiff_t(at));
}

// A tag's bytes, of which the first four are its type; none where there is no such tag.
ProfileBytes tag(ProfileBytes profile, std::string_view name) {
    constexpr std::size_t table = 128, row = 12, mostTags = 1000;
    const std::size_t count = std::min<std::size_t>(wholeNumber(profile, table, 4), mostTags);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = table + 4 + i * row;
        if (!isNamed(profile, at, name)) continue;
        const std::size_t from = wholeNumber(profile, at + 4, 4), size = wholeNumber(profile, at + 8, 4);
        if (from + size <= profile.size()) return profile.subspan(from, size);
    }
    return {};
}

// A table of equal steps, or a power where it has one number only.
double sampledCurve(ProfileBytes curve, double x) {
    const std::size_t count = wholeNumber(curve, 8, 4);
    if (count == 0) return x;
    if (count == 1) return std::pow(x, wholeNumber(curve, 12, 2) / 256.);
    if (12 + 2 * count > curve.size()) return std::numeric_limits<double>::quiet_NaN();
    const double place = x * static_cast<double>(count - 1);
    const auto step = std::min(static_cast<std::size_t>(place), count - 2);
    const auto value = [&](std::size_t i) { return wholeNumber(curve, 12 + 2 * i, 2) / 65535.; };
    return std::lerp(value(step), value(step + 1), place - static_cast<double>(step));
}

// (a x + b)^g + e from x = d on, and c x + f below; which of them a profile gives depends on the kind.
double parametricCurve(ProfileBytes curve, double x) {
    std::array<double, 7> p{};
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = fixedPoint(curve, 12 + 4 * i);
    const auto [g, a, b, c, d, e, f] = p;
    switch (wholeNumber(curve, 8, 2)) {
        case 0:
            return std::pow(x, g);
        case 1:
            return a * x + b >= 0 ? std::pow(a * x + b, g) : 0;
        case 2:
            return a * x + b >= 0 ? std::pow(a * x + b, g) + c : c;
        case 3:
            return x >= d ? std::pow(a * x + b, g) : c * x;
        case 4:
            return x >= d ? std::pow(a * x + b, g) + e : c * x + f;
        default:
            return std::numeric_limits<double>::quiet_NaN();
    }
}

// Profiles with a table of 26 rows, made to be small, are 0.0005 off; a gamma of 2.2 is 0.007 off.
bool isSrgbCurve(ProfileBytes curve) {
    constexpr double most = 0.002;
    const bool isSampled = isNamed(curve, 0, "curv"), isParametric = isNamed(curve, 0, "para");
    if (!isSampled && !isParametric) return false;
    for (int i = 0; i <= 255; ++i) {
        const double x = i / 255., y = isSampled ? sampledCurve(curve, x) : parametricCurve(curve, x);
        if (!(std::abs(y - decodeSrgb(x)) < most)) return false;
    }
    return true;
}

// Profiles are relative to the white of D50; this is sRGB's red, green or blue there (IEC 61966-2-1, with Bradford's
// adaptation).
bool isColour(ProfileBytes colour, const std::array<double, 3>& xyz) {
    constexpr double most = 0.002;
    if (!isNamed(colour, 0, "XYZ ") || colour.size() < 20) return false;
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(fixedPoint(colour, 8 + 4 * i) - xyz[i]) < most)) return false;
    return true;
}

}  // namespace

bool isSrgbProfile(ProfileBytes profile) {
    // A profile with tables of colours goes by those.
    if (!isNamed(profile, 36, "acsp") || !isNamed(profile, 20, "XYZ ") || !tag(profile, "A2B0").empty()) return false;
    if (isNamed(profile, 16, "GRAY")) return isSrgbCurve(tag(profile, "kTRC"));
    return isNamed(profile, 16, "RGB ") && isColour(tag(profile, "rXYZ"), {0.4361, 0.2225, 0.0139}) &&
           isColour(tag(profile, "gXYZ"), {0.3851, 0.7169, 0.0971}) &&
           isColour(tag(profile, "bXYZ"), {0.1431, 0.0606, 0.7141}) && isSrgbCurve(tag(profile, "rTRC")) &&
           isSrgbCurve(tag(profile, "gTRC")) && isSrgbCurve(tag(profile, "bTRC"));
}

std::string nameOfProfile(ProfileBytes profile) {
    const ProfileBytes description = tag(profile, "desc");
    // One text of ASCII; or a list of texts in UTF-16, of which the first is taken.
    const bool isAscii = isNamed(description, 0, "desc");
    if (!isAscii && !isNamed(description, 0, "mluc")) return "";
    const std::size_t step = isAscii ? 1 : 2, from = isAscii ? 12 : wholeNumber(description, 24, 4);
    const std::size_t length = wholeNumber(description, isAscii ? 8 : 20, 4);
    constexpr std::size_t longest = 60;
    std::string name;
    for (std::size_t at = from; at < from + length && name.size() < longest; at += step) {
        const std::uint32_t letter = wholeNumber(description, at, step);
        if (letter == 0) break;
        name += letter < ' ' || letter > '~' ? '?' : static_cast<char>(letter);
    }
    return name;
}

}  // namespace image
