#include "grsh/word_hints.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace grsh {
namespace {

// Tcl reads a number that begins with 0 as octal, and refuses 08 and 09.
bool isBadOctal(std::string_view number) {
    if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
    return number.starts_with('0') && number.find_first_not_of("0123456789") == std::string_view::npos &&
           number.find_first_of("89") != std::string_view::npos;
}

bool isBlank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// The words of a list as somebody typed it: blanks within brackets or braces do not end one.
std::vector<std::string_view> typedWords(std::string_view text) {
    std::vector<std::string_view> words;
    int depth = 0;
    std::size_t start = std::string_view::npos;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (isBlank(text[i]) && depth == 0) {
            if (start != std::string_view::npos) words.push_back(text.substr(start, i - start));
            start = std::string_view::npos;
            continue;
        }
        if (start == std::string_view::npos) start = i;
        if (text[i] == '[' || text[i] == '{') ++depth;
        if ((text[i] == ']' || text[i] == '}') && depth > 0) --depth;
    }
    if (start != std::string_view::npos) words.push_back(text.substr(start));
    return words;
}

// A $ or a [ that Tcl would have replaced; the price of something, "$ 5", is none.
bool isUnreplaced(std::string_view text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        const char next = text[i + 1];
        const bool startsName =
            std::isalnum(static_cast<unsigned char>(next)) || next == '_' || next == '{' || next == ':';
        if ((text[i] == '$' && startsName) || (text[i] == '[' && text.find(']', i) != std::string_view::npos))
            return true;
    }
    return false;
}

// A formula must be computed, too: $x*2 is [expr {$x*2}].
std::string asCode(std::string_view word) {
    const bool isFormula = word.find('$') != std::string_view::npos && word.find('[') == std::string_view::npos &&
                           word.find_first_of("+-*/%") != std::string_view::npos;
    return isFormula ? "[expr {" + std::string(word) + "}]" : std::string(word);
}

}  // namespace

std::string octalHint(std::string_view word) {
    while (!word.empty()) {
        const std::size_t end = std::min(word.find_first_of(" \t\n{}"), word.size());
        if (isBadOctal(word.substr(0, end))) return " (a leading 0 makes a number octal)";
        word.remove_prefix(std::min(end + 1, word.size()));
    }
    return "";
}

std::string bracesHint(std::string_view word) {
    // An element such as "[list" is the beginning of a command in a list that braces have made.
    const bool isTornApart = word.size() > 1 && word[0] == '[' &&
                             std::isalpha(static_cast<unsigned char>(word[1])) != 0 &&
                             word.find_first_of("] \t\n") == std::string_view::npos;
    if (isTornApart) return " (nothing is replaced in braces: make the list around it by [list ...], too)";
    if (!isUnreplaced(word)) return "";
    constexpr std::size_t most = 60;  // letters; what is longer, or has lines, does not fit the message
    if (word.size() > most || word.find('\n') != std::string_view::npos) return " (nothing is replaced in braces)";
    const std::vector<std::string_view> words = typedWords(word);
    std::string code;
    for (const std::string_view one : words) code += (code.empty() ? "" : " ") + asCode(one);
    if (words.size() > 1) code = "[list " + code + "]";
    return " (nothing is replaced in braces: write " + code + ")";
}

}  // namespace grsh
