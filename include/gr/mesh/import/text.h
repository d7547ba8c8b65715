// Lines, words and numbers of mesh files that are text.
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace gr::importer {

// Whether text is in UTF-16, of which nothing here could be read.
bool isUtf16(std::string_view text);

// Without the mark that some editors put before UTF-8. Throws Failure for text in UTF-16.
std::string_view withoutByteOrderMark(std::string_view text);

// A word of a file as messages show it: what cannot be printed is a question mark, and it is not too long.
std::string shown(std::string_view word);

// Lines end in \n, \r\n or \r.
class TextLines {
public:
    explicit TextLines(std::string_view text) : text_(text), newline_(text.find('\n')) {}

    // False when there is none any more.
    bool next(std::string_view& line);
    // What follows the last line.
    std::string_view rest() const { return text_.substr(at_); }
    // Of the last line, from 1.
    int number() const { return number_; }
    // Throws Failure: what is wrong with the last line.
    [[noreturn]] void fail(const std::string& what) const;

private:
    std::string_view text_;
    std::size_t at_ = 0, newline_;  // newline_: where the next one is at or behind at_, or none
    int number_ = 0;
};

inline bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// Cuts the first word off; empty when there is none any more.
inline std::string_view takeWord(std::string_view& line) {
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at != end && isBlank(*at)) ++at;
    const char* const first = at;
    while (at != end && !isBlank(*at)) ++at;
    line = {at, static_cast<std::size_t>(end - at)};
    return {first, static_cast<std::size_t>(at - first)};
}

inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

// Whether two words are the same but for capitals, the second one being in lower case.
bool isWord(std::string_view word, std::string_view lower);

// The whole word as a number, also one like .5, 5. or +1e3; what is too large or too small for a double is infinite or
// 0. False where it is something else.
bool readNumber(std::string_view word, double& number);

}  // namespace gr::importer
