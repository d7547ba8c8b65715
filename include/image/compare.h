// How far two pictures lie apart.
#pragma once

#include "core/option.h"
#include "image/film.h"
#include "image/image.h"

namespace image {

// What gr_compare is asked for: one row each. To add one: a member with its default, and a row.
struct CompareSettings {
    core::Word metric = "mse";
    std::optional<double> tolerance;
    std::string difference;

    static std::span<const core::OptionRow<CompareSettings>> options();
};

// The colours of a picture: linear, a line after the other from the top. Where it is transparent they are those that
// show before black.
struct Colours {
    int width = 0, height = 0;
    std::vector<core::Rgbf> pixels;
    std::vector<float> coverage;  // of each pixel; empty: it is 1 everywhere
    bool isFilmic = false;  // what a filmic curve shows, not the radiance

    float coverageAt(std::size_t pixel) const { return coverage.empty() ? 1 : coverage[pixel]; }
};

// An OpenEXR file's R, G and B; grey is a colour, too. Throws core::Error, naming the file, for a picture that has
// none, or holds numbers that are not finite.
Colours coloursOf(const Image& image, const std::string& path);

struct Comparison {
    // Means over pixels and channels of (a-b)^2, and of (a-b)^2/(b^2 + 0.01), b being the reference. Where a picture is
    // transparent in places, how much pixels cover is a fourth channel.
    double mse = 0, relmse = 0;
    double psnr = 0;  // of what a PNG would show, in decibels; infinite for pictures that show the same
    double largest = 0;  // |a-b|
    int x = 0, y = 0;  // where that is, from the top
};

// Both of the same size.
Comparison compare(const Colours& a, const Colours& b);

// What a PNG would show, linear again: cut to [0, 1].
std::vector<core::Rgbf> shown(const Colours& colours);

}  // namespace image
