#include "gr/mesh/import/gltf/words.h"

#include <algorithm>

namespace gr::importer {

std::string inQuotes(std::string_view text) {
    constexpr std::size_t most = 80;
    std::string shown(text.substr(0, most));
    if (text.size() > most) {
        // No character of several bytes is cut through: those after its first one begin with the bits 10.
        std::size_t end = most;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
        shown.resize(end);
        shown += "...";
    }
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return '"' + shown + '"';
}

}  // namespace gr::importer
