#include "core/error.h"

#include <algorithm>

namespace core {
namespace {

// Damerau and Levenshtein's distance with neighbours swapped at most once ("optimal string alignment").
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(beforeLast, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = last[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = std::min({substituted, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string inSmallLetters(std::string_view word) {
    std::string text(word);
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

// The only candidate that begins with the word; empty where there is none, or more than one.
std::string_view abbreviated(const std::string& word, std::span<const std::string_view> candidates) {
    std::string_view found;
    for (const std::string_view candidate : candidates) {
        if (candidate == found || !inSmallLetters(candidate).starts_with(word)) continue;
        if (!found.empty()) return {};
        found = candidate;
    }
    return found;
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string_view> candidates) {
    constexpr std::size_t leastOfAbbreviation = 3;
    const std::string small = inSmallLetters(word);
    std::string_view best;
    std::size_t bestDistance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
        if (longer - shorter >= bestDistance) continue;
        const std::size_t distance = editDistance(small, inSmallLetters(candidate));
        if (distance >= bestDistance || distance >= longer) continue;
        best = candidate;
        bestDistance = distance;
    }
    // Words are more often cut off than mistaken twice.
    if (word.size() >= leastOfAbbreviation && bestDistance > 1)
        if (const std::string_view whole = abbreviated(small, candidates); !whole.empty()) best = whole;
    return std::string(best);
}

std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates) {
    const std::string near = nearest(word, candidates);
    return near.empty() ? "" : " (did you mean \"" + near + "\"?)";
}

std::string listed(std::span<const std::string_view> words, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
        text += words[i];
    }
    return text;
}

}  // namespace core
