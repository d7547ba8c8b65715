#include "core/option.h"

namespace core {
namespace {

template<class Number>
std::string shortest(Number x) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, x).ptr;
    return {text, end};
}

}  // namespace

std::string numberText(double x) {
    return shortest(x);
}
std::string numberText(float x) {
    return shortest(x);
}

namespace {

// 1000000, not 1e+06: what a person would write.
std::string boundText(double x) {
    const bool isShortInteger = x == std::trunc(x) && std::abs(x) < 1e15;
    return isShortInteger ? std::to_string(static_cast<long long>(x)) : numberText(x);
}

}  // namespace

std::string rangeText(const Range& range) {
    const bool below = std::isfinite(range.least);
    const bool above = std::isfinite(range.most);
    if (below && above && range.leastIncluded && range.mostIncluded)
        return boundText(range.least) + " to " + boundText(range.most);
    const std::string least = (range.leastIncluded ? "at least " : "greater than ") + boundText(range.least);
    const std::string most = (range.mostIncluded ? "at most " : "less than ") + boundText(range.most);
    if (below && above) return least + " and " + most;
    if (below) return least;
    return above ? most : "";
}

}  // namespace core
