#include "image/layer.h"

#include <algorithm>
#include <array>

namespace image {
namespace {

using core::Word;

constexpr std::array<Word, layerCount> names{"albedo", "normal", "depth", "variance", "samples"};

constexpr std::array<Word, 3> albedo{"albedo.R", "albedo.G", "albedo.B"};
constexpr std::array<Word, 3> normal{"normal.X", "normal.Y", "normal.Z"};
constexpr std::array<Word, 1> depth{"Z"};  // the format's own name for it
constexpr std::array<Word, 3> variance{"variance.R", "variance.G", "variance.B"};
constexpr std::array<Word, 1> samples{"samples"};
constexpr std::array<std::span<const Word>, layerCount> channels{albedo, normal, depth, variance, samples};

}  // namespace

std::span<const Word> layerNames() {
    return names;
}

std::span<const Word> channelsOf(Layer layer) {
    return channels[static_cast<std::size_t>(layer)];
}

std::vector<Layer> layersNamed(std::span<const Word> wanted) {
    std::vector<Layer> layers;
    for (const Word name : wanted)
        layers.push_back(static_cast<Layer>(std::find(names.begin(), names.end(), name) - names.begin()));
    return layers;
}

}  // namespace image
