// What went wrong, said where it was seen; and how the nearest spelling is found.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace core {

// topic and reason, upper case, become Tcl's errorCode: GR <TOPIC> <REASON> <word>, e.g. GR NODE UNKNOWN :arn.
class Error : public std::runtime_error {
public:
    Error(std::string topic, std::string reason, std::string word, const std::string& message)
        : std::runtime_error(message), topic(std::move(topic)), reason(std::move(reason)), word(std::move(word)) {}

    std::string topic;
    std::string reason;
    std::string word;
};

// The candidate that is spelled most like word, capitals or not, or empty when none is near enough to be meant: at most
// a third of its letters, and at least one, changed, added, left out or swapped with a neighbour. Where more than one
// letter is, or none is so near, it is the only candidate that begins with the word, if that has three letters.
std::string nearest(std::string_view word, std::span<const std::string_view> candidates);

// " (did you mean "gold"?)", or nothing.
std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates);

// a, b or c; last: the word before the last one.
std::string listed(std::span<const std::string_view> words, std::string_view last = "or");

}  // namespace core
