#include "grsh/command_text.h"

#include <tcl.h>

namespace grsh {

void CommandText::addLine(std::string_view line) {
    text_ += line;
}

// Within braces only braces and backslashes count, so there is no need to begin anew at each line.
bool CommandText::isBraceOpen() {
    while (depth_ > 0 && scanned_ < text_.size()) {
        const char c = text_[scanned_++];
        if (c == '\\') ++scanned_;
        if (c == '{') ++depth_;
        if (c == '}') --depth_;
    }
    return depth_ > 0;
}

bool CommandText::isContinued() const {
    if (!text_.ends_with("\\\n")) return false;
    const std::size_t before = text_.find_last_not_of('\\', text_.size() - 2);
    const std::size_t first = before == text_.npos ? 0 : before + 1;
    return (text_.size() - 1 - first) % 2 == 1;
}

bool CommandText::isComplete() {
    if (isBraceOpen() || isContinued()) return false;
    Tcl_Parse parse;
    const char* at = text_.data();
    const char* end = at + text_.size();
    while (Tcl_ParseCommand(nullptr, at, static_cast<int>(end - at), 0, &parse) == TCL_OK) {
        at = parse.commandStart + parse.commandSize;
        const bool isIncomplete = parse.incomplete;
        Tcl_FreeParse(&parse);
        if (at >= end) return !isIncomplete;
    }
    if (parse.errorType == TCL_PARSE_MISSING_BRACE && *parse.term == '{') {
        scanned_ = static_cast<std::size_t>(parse.term - text_.data()) + 1;
        depth_ = 1;
        isBraceOpen();
    }
    return !parse.incomplete;
}

}  // namespace grsh
