#include "image/png_colours.h"

#include "image/announced.h"
#include "image/icc_profile.h"
#include "image/primaries.h"

#include <cmath>
#include <cstring>
#include <optional>
#include <string>

namespace image {
namespace {

constexpr double srgbCurve = 0;

// cICP: numbers of Recommendation ITU-T H.273.
struct CodePoints {
    png_byte primaries, transfer, matrix, isFullRange;
};

std::optional<CodePoints> codePointsOf(png_structp png, png_infop info) {
    png_unknown_chunkp chunks = nullptr;
    const int count = png_get_unknown_chunks(png, info, &chunks);
    for (int i = 0; i < count; ++i)
        if (std::memcmp(chunks[i].name, "cICP", 4) == 0 && chunks[i].size == sizeof(CodePoints))
            return CodePoints{chunks[i].data[0], chunks[i].data[1], chunks[i].data[2], chunks[i].data[3]};
    return std::nullopt;
}

std::string nameOfPrimaries(png_byte number) {
    switch (number) {
        case 9:
            return "those of BT.2020";
        case 11:
            return "those of DCI-P3";
        case 12:
            return "those of Display P3";
        default:
            return "number " + std::to_string(number) + " of H.273";
    }
}

double gammaOf(const CodePoints& points) {
    if (points.primaries != 1) failReading("its primaries are " + nameOfPrimaries(points.primaries) + ", not of sRGB");
    if (points.matrix != 0 || points.isFullRange != 1)
        failReading("its numbers are not red, green and blue of full range");
    switch (points.transfer) {
        case 4:
            return 1 / 2.2;
        case 5:
            return 1 / 2.8;
        case 8:
            return 1;
        case 13:
            return srgbCurve;
        case 16:
            failReading("its curve is PQ, not that of sRGB");
        case 18:
            failReading("its curve is HLG, not that of sRGB");
        default:
            failReading("its curve is number " + std::to_string(points.transfer) + " of H.273, not that of sRGB");
    }
}

void checkProfile(png_structp png, png_infop info) {
    png_charp given = nullptr;
    png_bytep bytes = nullptr;
    png_uint_32 length = 0;
    int compression = 0;
    png_get_iCCP(png, info, &given, &compression, &bytes, &length);
    const ProfileBytes profile(bytes, length);
    if (isSrgbProfile(profile)) return;
    const std::string own = nameOfProfile(profile);
    failReading("its colours are those of the profile \"" + (own.empty() ? std::string(given) : own) +
                "\", not those of sRGB");
}

}  // namespace

void keepColourChunks(png_structp png) {
    constexpr png_byte name[] = "cICP";
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, name, 1);
}

double gammaOf(png_structp png, png_infop info) {
    if (const auto points = codePointsOf(png, info)) return gammaOf(*points);
    int intent = 0;
    if (png_get_sRGB(png, info, &intent) != 0) return srgbCurve;
    if (png_get_valid(png, info, PNG_INFO_iCCP) != 0) {
        checkProfile(png, info);
        return srgbCurve;
    }
    Primaries p{};
    if (png_get_cHRM(png, info, &p[6], &p[7], &p[0], &p[1], &p[2], &p[3], &p[4], &p[5]) != 0)
        if (const auto why = otherThanSrgb(p)) failReading(*why);
    double gamma = 0;
    // Most programs write 0.45455, the power next to it, where they mean the curve of sRGB.
    if (png_get_gAMA(png, info, &gamma) == 0 || std::abs(gamma * 2.2 - 1) <= 0.05) return srgbCurve;
    return gamma;
}

}  // namespace image
