// How visible the difference of two pictures is to somebody who flips between them:
//     P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild,
//     "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and
//     Interactive Techniques 3, 2 (2020)
#pragma once

#include "core/vec.h"

#include <span>
#include <vector>

namespace image {

// The paper's standard: a screen 0.7 m wide with 3840 pixels, seen from 0.7 m.
inline constexpr double flipPixelsPerDegree = 0.7 * 3840 / 0.7 * core::pi / 180;

// How visible the difference is in each pixel, from 0, where they are the same, to 1. Both pictures are linear sRGB;
// what is shown of them is from 0 to 1.
std::vector<float> flip(std::span<const core::Rgbf> reference, std::span<const core::Rgbf> test, int width, int height,
                        double pixelsPerDegree = flipPixelsPerDegree);

}  // namespace image
