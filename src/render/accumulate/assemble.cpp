#include "render/accumulate/assemble.h"

#include "core/error.h"
#include "render/accumulate/cover.h"
#include "render/accumulate/noise.h"
#include "render/accumulate/tile.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>

namespace render {
namespace {

constexpr std::string_view startLine = "grsh:startline", stopLine = "grsh:stopline";
constexpr std::string_view startColumn = "grsh:startcolumn", stopColumn = "grsh:stopcolumn";
constexpr std::string_view noise = "grsh:noise", noiseSums = "grsh:noisesums";
// What a strip says of itself alone.
constexpr std::string_view ownTexts[] = {startLine, stopLine, startColumn, stopColumn, noise, noiseSums};

[[noreturn]] void fail(std::string_view reason, const std::string& path, const std::string& why) {
    throw core::Error("STRIP", std::string(reason), path, why);
}

std::string quoted(const std::string& path) {
    return "\"" + path + "\"";
}

const std::string* textOf(const image::Image& image, std::string_view keyword) {
    for (const auto& [key, value] : image.metadata)
        if (key == keyword) return &value;
    return nullptr;
}

int numberIn(const Strip& strip, std::string_view keyword) {
    const std::string* text = textOf(strip.image, keyword);
    int number = -1;
    if (text == nullptr ||
        std::from_chars(text->data(), text->data() + text->size(), number).ptr != text->data() + text->size() ||
        number < 0)
        fail("NONE", strip.path,
             quoted(strip.path) + " does not say which lines of which render it has (no text " + std::string(keyword) +
                 "), as a .png or an .exr of gr_render does");
    return number;
}

int widthOf(const Strip& strip) {
    return numberIn(strip, "grsh:width");
}
int heightOf(const Strip& strip) {
    return numberIn(strip, "grsh:height");
}

// What it says that it has of the whole picture. Older strips say nothing of columns and have all.
image::Window windowOf(const Strip& strip) {
    const bool saysColumns = textOf(strip.image, startColumn) != nullptr;
    const int left = saysColumns ? numberIn(strip, startColumn) : 0;
    const int right = saysColumns ? numberIn(strip, stopColumn) : widthOf(strip) - 1;
    const int top = numberIn(strip, startLine), bottom = numberIn(strip, stopLine);
    const auto count = [](int first, int last) {
        constexpr std::int64_t most = std::numeric_limits<int>::max();
        return static_cast<int>(std::min(std::int64_t{last} - first + 1, most));
    };
    return {left, top, count(left, right), count(top, bottom)};
}

std::string windowText(const image::Window& window, int width) {
    const std::string lines = rangeText("line", window.top, window.top + (window.height - 1));
    if (window.left == 0 && window.width == width) return lines;
    return lines + ", " + rangeText("column", window.left, window.left + (window.width - 1));
}

void checkSelf(const Strip& strip) {
    const int width = widthOf(strip), height = heightOf(strip);
    const image::Window says = windowOf(strip), &held = strip.image.held;
    const bool isWithin =
        says.width > 0 && says.height > 0 && says.width <= width - says.left && says.height <= height - says.top;
    if (isWithin && held == says) return;
    fail("NONE", strip.path,
         quoted(strip.path) + " is no strip as it was written: it says that it is " + windowText(says, width) + " of " +
             std::to_string(width) + " x " + std::to_string(height) + " pixels, and has " +
             windowText(held, held.width) + " of width " + std::to_string(held.width));
}

// Whether both come from the same render: all that they say of it, but for what they have of it and its noise.
void checkSameRender(const Strip& first, const Strip& strip) {
    const auto refuse = [&](const std::string& what, const std::string& here, const std::string& there) {
        fail("RENDER", strip.path,
             quoted(strip.path) + " is of another render than " + quoted(first.path) + ": " + what + " is \"" + here +
                 "\", not \"" + there + "\"");
    };
    const auto check = [&](const Strip& a, std::string_view key) {
        if (std::ranges::find(ownTexts, key) != std::end(ownTexts)) return;
        const std::string *here = textOf(strip.image, key), *there = textOf(first.image, key);
        const std::string name(key.starts_with("grsh:") ? key.substr(5) : key);
        if (here == nullptr || there == nullptr)
            fail("RENDER", strip.path,
                 quoted(strip.path) + " is of another render than " + quoted(first.path) + ": only " + quoted(a.path) +
                     " has a text " + name);
        if (*here != *there) refuse(name, *here, *there);
    };
    for (const auto& [key, value] : first.image.metadata) check(first, key);
    for (const auto& [key, value] : strip.image.metadata) check(strip, key);
    if (strip.image.channelNames() != first.image.channelNames())
        refuse("what it has of each pixel", strip.image.channelNames(), first.image.channelNames());
    if (strip.image.channels[0].samples.index() != first.image.channels[0].samples.index())
        fail("RENDER", strip.path, quoted(strip.path) + " has other numbers of bits than " + quoted(first.path));
    if (strip.image.gamma != first.image.gamma)
        fail("RENDER", strip.path, quoted(strip.path) + " has another gamma than " + quoted(first.path));
}

NoiseSums noiseSumsOf(const Strip& strip) {
    const std::string* text = textOf(strip.image, noiseSums);
    const auto sums = text == nullptr ? std::nullopt : NoiseSums::fromText(*text);
    if (!sums)
        fail("NONE", strip.path,
             quoted(strip.path) + " does not say how noisy it is (text " + std::string(noiseSums) +
                 "), as a strip of gr_render does");
    return *sums;
}

// What the whole says of its noise; nothing where no strip says anything, as of too few samples, or where no sums of
// theirs are those of the whole.
std::optional<std::string> wholeNoise(const std::vector<Strip>& strips) {
    const auto says = [](const Strip& strip) { return textOf(strip.image, noise) != nullptr; };
    if (std::ranges::none_of(strips, says)) return std::nullopt;
    if (strips.size() == 1) return *textOf(strips[0].image, noise);
    const auto isWhole = [](const Strip& strip) { return hasWholeTiles(strip.image.held, widthOf(strip)); };
    if (!std::ranges::all_of(strips, isWhole)) return std::nullopt;
    NoiseSums sums = noiseSumsOf(strips[0]);
    for (std::size_t i = 1; i < strips.size(); ++i) sums += noiseSumsOf(strips[i]);
    const int samples = numberIn(strips[0], "grsh:samplesperpixel");
    const double pixels = double(widthOf(strips[0])) * heightOf(strips[0]);
    return noiseText(estimateNoise(sums, samples, pixels).error);
}

// The numbers of a channel, each strip's in their places; the strips lose theirs.
image::PixelNumbers wholeChannel(std::vector<Strip>& strips, std::size_t channel, int width, int height) {
    const auto put = [&]<class Number>(const std::vector<Number>&) -> image::PixelNumbers {
        std::vector<Number> whole(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (Strip& strip : strips) {
            const image::Window& held = strip.image.held;
            auto& part = std::get<std::vector<Number>>(strip.image.channels[channel].samples);
            for (int line = 0; line < held.height; ++line) {
                const auto from = part.begin() + std::ptrdiff_t{line} * held.width;
                std::copy(from, from + held.width, whole.begin() + std::ptrdiff_t{held.top + line} * width + held.left);
            }
            part = {};
        }
        return whole;
    };
    // The strips' own vectors go while the whole is made: only their kind is asked for.
    const image::PixelNumbers kind = std::visit(
        []<class Number>(const std::vector<Number>&) -> image::PixelNumbers { return std::vector<Number>(); },
        strips[0].image.channels[channel].samples);
    return std::visit(put, kind);
}

}  // namespace

image::Image assemble(std::vector<Strip> strips) {
    std::vector<Part> parts;
    for (const Strip& strip : strips) {
        checkSelf(strip);
        checkSameRender(strips[0], strip);
        parts.push_back({strip.path, strip.image.held});
    }
    const int width = widthOf(strips[0]), height = heightOf(strips[0]);
    checkCover(std::move(parts), width, height);
    const std::optional<std::string> noiseOfAll = wholeNoise(strips);
    image::Image whole;
    whole.held = whole.whole = {0, 0, width, height};
    whole.gamma = strips[0].image.gamma;
    for (std::size_t c = 0; c < strips[0].image.channels.size(); ++c)
        whole.channels.push_back({strips[0].image.channels[c].name, wholeChannel(strips, c, width, height)});
    for (const Strip& strip : strips) whole.partsLeftOut = std::max(whole.partsLeftOut, strip.image.partsLeftOut);
    whole.metadata = std::move(strips[0].image.metadata);
    std::erase_if(whole.metadata,
                  [&](const auto& text) { return text.first == noiseSums || (text.first == noise && !noiseOfAll); });
    for (auto& [key, value] : whole.metadata) {
        if (key == startLine || key == startColumn) value = "0";
        if (key == stopLine) value = std::to_string(height - 1);
        if (key == stopColumn) value = std::to_string(width - 1);
        if (key == noise) value = *noiseOfAll;
    }
    return whole;
}

}  // namespace render
