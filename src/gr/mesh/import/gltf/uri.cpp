#include "gr/mesh/import/gltf/uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace gr::importer {
namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// A percent sign that no two digits follow stands for itself: many programs write names as they are.
std::string percentDecoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isCode =
            text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
        decoded += isCode ? static_cast<char>(hexDigit(text[i + 1]) << 4 | hexDigit(text[i + 2])) : text[i];
        if (isCode) i += 2;
    }
    return decoded;
}

constexpr std::array<signed char, 256> base64Digits = [] {
    std::array<signed char, 256> digits{};
    digits.fill(-1);
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        digits[static_cast<unsigned char>(alphabet[i])] = static_cast<signed char>(i);
    return digits;
}();

std::optional<std::string> base64Decoded(std::string_view text) {
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;  // of the bits that are waiting
    for (const char c : text) {
        const int digit = base64Digits[static_cast<unsigned char>(c)];
        if (digit < 0) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    return bytes;
}

// Such as "file:" or "http:". No path below a folder begins so: its colon would be written as %3A.
bool hasScheme(std::string_view uri) {
    const auto isPart = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; };
    const auto end = std::find_if_not(uri.begin(), uri.end(), isPart);
    return end != uri.begin() && end != uri.end() && *end == ':';
}

}  // namespace

bool isDataUri(std::string_view uri) {
    constexpr std::string_view scheme = "data:";
    return uri.size() >= scheme.size() && std::equal(scheme.begin(), scheme.end(), uri.begin(),
                                                     [](char a, unsigned char b) { return a == std::tolower(b); });
}

std::optional<std::string> dataOf(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return {};
    const std::string_view data = uri.substr(comma + 1);
    if (!uri.substr(0, comma).ends_with(";base64")) return percentDecoded(data);
    return base64Decoded(data.find('%') == std::string_view::npos ? data : percentDecoded(data));
}

std::optional<std::string> pathOf(std::string_view uri) {
    if (hasScheme(uri)) return {};
    const std::string decoded = percentDecoded(uri);
    if (decoded.empty() || decoded.front() == '/' || decoded.find('\0') != std::string::npos) return {};
    std::vector<std::string_view> folders;
    for (std::string_view rest = decoded; !rest.empty();) {
        const std::size_t end = std::min(rest.find('/'), rest.size());
        const std::string_view name = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (name.empty() || name == ".") continue;
        if (name != "..") {
            folders.push_back(name);
        } else if (folders.empty()) {
            return {};
        } else {
            folders.pop_back();
        }
    }
    std::string path;
    for (const std::string_view name : folders) path.append(path.empty() ? "" : "/").append(name);
    return path.empty() ? std::nullopt : std::optional(path);
}

}  // namespace gr::importer
