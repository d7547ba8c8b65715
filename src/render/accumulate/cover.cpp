#include "render/accumulate/cover.h"

#include "core/error.h"

#include <algorithm>
#include <cstdint>

namespace render {
namespace {

int rightOf(const Part& part) {
    return part.window.left + part.window.width;
}
int bottomOf(const Part& part) {
    return part.window.top + part.window.height;
}

std::string quoted(const Part& part) {
    return "\"" + part.path + "\"";
}

void checkOverlap(const Part& one, const Part& other, int width) {
    const int left = std::max(one.window.left, other.window.left), right = std::min(rightOf(one), rightOf(other));
    const int top = std::max(one.window.top, other.window.top), bottom = std::min(bottomOf(one), bottomOf(other));
    if (left >= right || top >= bottom) return;
    const bool isWide = right - left == width;
    throw core::Error("STRIP", "OVERLAP", other.path,
                      quoted(one) + " and " + quoted(other) + " both have " + rangeText("line", top, bottom - 1) +
                          (isWide ? "" : ", " + rangeText("column", left, right - 1)));
}

// parts: from the top. Only those side by side with a part may have the same pixels.
void checkOverlaps(const std::vector<Part>& parts, int width) {
    std::vector<const Part*> beside;
    for (const Part& part : parts) {
        std::erase_if(beside, [&](const Part* above) { return bottomOf(*above) <= part.window.top; });
        for (const Part* other : beside) checkOverlap(*other, part, width);
        beside.push_back(&part);
    }
}

[[noreturn]] void failGap(const std::vector<Part>& parts, const std::string& what) {
    throw core::Error("STRIP", "GAP", parts[0].path, "no strip has " + what);
}

// The lines top to bottom - 1 lie alike in all parts.
void checkBand(const std::vector<Part>& parts, int width, int top, int bottom) {
    std::vector<const Part*> here;
    for (const Part& part : parts)
        if (part.window.top <= top && bottomOf(part) >= bottom) here.push_back(&part);
    if (here.empty()) {
        const auto above =
            std::find_if(parts.rbegin(), parts.rend(), [&](const Part& p) { return bottomOf(p) <= top; });
        const auto below = std::ranges::find_if(parts, [&](const Part& part) { return part.window.top >= bottom; });
        failGap(parts, rangeText("line", top, bottom - 1) + ", between " +
                           (above == parts.rend() ? "the top" : quoted(*above)) + " and " +
                           (below == parts.end() ? "the bottom" : quoted(*below)));
    }
    std::ranges::sort(here, {}, [](const Part* part) { return part->window.left; });
    int next = 0;
    const auto checkColumns = [&](int left) {
        if (left > next)
            failGap(parts, rangeText("column", next, left - 1) + " of " + rangeText("line", top, bottom - 1));
    };
    for (const Part* part : here) {
        checkColumns(part->window.left);
        next = rightOf(*part);
    }
    checkColumns(width);
}

void checkGaps(const std::vector<Part>& parts, int width, int height) {
    std::int64_t pixels = 0;
    for (const Part& part : parts) pixels += std::int64_t{part.window.width} * part.window.height;
    if (pixels == std::int64_t{width} * height) return;
    std::vector<int> cuts{0, height};
    for (const Part& part : parts) cuts.insert(cuts.end(), {part.window.top, bottomOf(part)});
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) checkBand(parts, width, cuts[i], cuts[i + 1]);
}

}  // namespace

void checkCover(std::vector<Part> parts, int width, int height) {
    std::ranges::stable_sort(parts, {}, [](const Part& p) { return std::pair(p.window.top, p.window.left); });
    checkOverlaps(parts, width);
    checkGaps(parts, width, height);
}

std::string rangeText(const std::string& what, int first, int last) {
    if (first == last) return what + " " + std::to_string(first);
    return what + "s " + std::to_string(first) + " to " + std::to_string(last);
}

}  // namespace render
