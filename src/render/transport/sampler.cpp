#include "render/transport/sampler.h"

#include <numeric>

namespace render {

PixelGrid::PixelGrid(int samples) {
    rows_ = static_cast<int>(std::sqrt(static_cast<double>(samples)));
    while (samples % rows_ != 0) --rows_;
    columns_ = samples / rows_;
    stride_ = std::llround(samples / 1.6180339887498949);
    while (std::gcd(stride_, std::int64_t{samples}) != 1) ++stride_;
    cellWidth_ = 1.f / static_cast<float>(columns_);
    cellHeight_ = 1.f / static_cast<float>(rows_);
}

}  // namespace render
