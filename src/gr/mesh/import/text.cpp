#include "gr/mesh/import/text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace gr::importer {

bool isUtf16(std::string_view text) {
    // Text has no zeros; of UTF-16 every other byte is one, as long as it holds English words and figures.
    const auto isZero = [&](std::size_t i) { return text[i] == 0; };
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
           (text.size() >= 4 && isZero(0) != isZero(1) && isZero(0) == isZero(2) && isZero(1) == isZero(3));
}

std::string_view withoutByteOrderMark(std::string_view text) {
    if (isUtf16(text)) throw Failure("its text is in UTF-16; it must be in UTF-8");
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

std::string shown(std::string_view word) {
    constexpr std::size_t most = 40;
    std::string text(word.substr(0, most));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return text;
}

bool TextLines::next(std::string_view& line) {
    if (at_ == text_.size()) return false;
    // Looked for once only where there is none for long: text may have \r alone.
    if (newline_ < at_) newline_ = text_.find('\n', at_);
    line = text_.substr(at_, newline_ - at_);
    line = line.substr(0, line.find('\r'));
    at_ += line.size();
    at_ = std::min(at_ + (rest().starts_with("\r\n") ? 2 : 1), text_.size());
    ++number_;
    return true;
}

void TextLines::fail(const std::string& what) const {
    throw Failure("line " + std::to_string(number_) + ": " + what);
}

bool isWord(std::string_view word, std::string_view lower) {
    if (word.size() != lower.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(word[i])) != lower[i]) return false;
    return true;
}

bool readNumber(std::string_view word, double& number) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, number);
    if (error == std::errc::result_out_of_range) number = std::strtod(std::string(word).c_str(), nullptr);
    return at == end && error != std::errc::invalid_argument && !word.empty();
}

}  // namespace gr::importer
