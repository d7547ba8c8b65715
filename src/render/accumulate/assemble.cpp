#include "render/accumulate/assemble.h"

#include "core/error.h"
#include "render/accumulate/noise.h"

#include <algorithm>
#include <charconv>

namespace render {
namespace {

constexpr std::string_view startLine = "grsh:startline", stopLine = "grsh:stopline";
constexpr std::string_view noise = "grsh:noise", noiseSums = "grsh:noisesums";
// What a strip says of itself alone.
constexpr std::string_view ownTexts[] = {startLine, stopLine, noise, noiseSums};

[[noreturn]] void fail(std::string_view reason, const std::string& path, const std::string& why) {
    throw core::Error("STRIP", std::string(reason), path, why);
}

std::string quoted(const std::string& path) {
    return "\"" + path + "\"";
}

std::string linesText(int first, int last) {
    if (first == last) return "line " + std::to_string(first);
    return "lines " + std::to_string(first) + " to " + std::to_string(last);
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

int firstLine(const Strip& strip) {
    return numberIn(strip, startLine);
}
int lastLine(const Strip& strip) {
    return numberIn(strip, stopLine);
}

void checkSelf(const Strip& strip) {
    const int width = numberIn(strip, "grsh:width"), height = numberIn(strip, "grsh:height");
    const int first = firstLine(strip), last = lastLine(strip);
    const image::Window& held = strip.image.held;
    if (first > last || last >= height || held != image::Window{0, first, width, last - first + 1})
        fail("NONE", strip.path,
             quoted(strip.path) + " is no strip as it was written: it says that it is " + linesText(first, last) +
                 " of " + std::to_string(width) + " x " + std::to_string(height) + " pixels, and has " +
                 linesText(held.top, held.top + held.height - 1) + " of width " + std::to_string(held.width));
}

// Whether both come from the same render: all that they say of it, but for the lines and their noise.
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

// strips: in the order of their lines.
void checkLines(const std::vector<Strip>& strips) {
    const int height = numberIn(strips[0], "grsh:height");
    int next = 0;
    std::string above = "the top";
    const auto checkGap = [&](int line, const std::string& below) {
        if (line > next)
            fail("GAP", strips[0].path,
                 "no strip has " + linesText(next, line - 1) + ", between " + above + " and " + below);
    };
    for (std::size_t i = 0; i < strips.size(); ++i) {
        const int first = firstLine(strips[i]), last = lastLine(strips[i]);
        if (first < next)
            fail("OVERLAP", strips[i].path,
                 quoted(strips[i - 1].path) + " and " + quoted(strips[i].path) + " both have " +
                     linesText(first, std::min(last, next - 1)));
        checkGap(first, quoted(strips[i].path));
        next = last + 1;
        above = quoted(strips[i].path);
    }
    checkGap(height, "the bottom");
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

// What the whole says of its noise; nothing where no strip says anything, as of too few samples.
std::optional<std::string> wholeNoise(const std::vector<Strip>& strips) {
    const auto says = [](const Strip& strip) { return textOf(strip.image, noise) != nullptr; };
    if (std::ranges::none_of(strips, says)) return std::nullopt;
    if (strips.size() == 1) return *textOf(strips[0].image, noise);
    NoiseSums sums = noiseSumsOf(strips[0]);
    for (std::size_t i = 1; i < strips.size(); ++i) sums += noiseSumsOf(strips[i]);
    const int samples = numberIn(strips[0], "grsh:samplesperpixel");
    const double pixels = double(numberIn(strips[0], "grsh:width")) * numberIn(strips[0], "grsh:height");
    return noiseText(estimateNoise(sums, samples, pixels).error);
}

void append(image::PixelNumbers& to, const image::PixelNumbers& from) {
    const auto add = [&]<class Number>(std::vector<Number>& numbers) {
        const auto& more = std::get<std::vector<Number>>(from);
        numbers.insert(numbers.end(), more.begin(), more.end());
    };
    std::visit(add, to);
}

}  // namespace

image::Image assemble(std::vector<Strip> strips) {
    for (const Strip& strip : strips) {
        checkSelf(strip);
        checkSameRender(strips[0], strip);
    }
    std::sort(strips.begin(), strips.end(), [](const Strip& a, const Strip& b) {
        return std::pair(firstLine(a), lastLine(a)) < std::pair(firstLine(b), lastLine(b));
    });
    checkLines(strips);
    const int height = numberIn(strips[0], "grsh:height");
    const std::optional<std::string> noiseOfAll = wholeNoise(strips);
    image::Image whole = std::move(strips[0].image);
    for (std::size_t i = 1; i < strips.size(); ++i) {
        for (std::size_t c = 0; c < whole.channels.size(); ++c)
            append(whole.channels[c].samples, strips[i].image.channels[c].samples);
        strips[i].image.channels.clear();
        whole.partsLeftOut = std::max(whole.partsLeftOut, strips[i].image.partsLeftOut);
    }
    whole.held = whole.whole = {0, 0, whole.held.width, height};
    whole.isPart = false;
    std::erase_if(whole.metadata, [](const auto& text) { return text.first == noiseSums; });
    for (auto& [key, value] : whole.metadata) {
        if (key == startLine) value = "0";
        if (key == stopLine) value = std::to_string(height - 1);
        if (key == noise) value = *noiseOfAll;
    }
    return whole;
}

}  // namespace render
