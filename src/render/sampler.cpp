#include "render/sampler.h"

namespace render {

PixelGrid::PixelGrid(int samples) {
    rows_ = static_cast<int>(std::sqrt(static_cast<double>(samples)));
    while (samples % rows_ != 0) --rows_;
    columns_ = samples / rows_;
    cellWidth_ = 1.f / static_cast<float>(columns_);
    cellHeight_ = 1.f / static_cast<float>(rows_);
}

}  // namespace render
