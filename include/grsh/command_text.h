// A script's text that comes line by line, until it is a whole command.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grsh {

class CommandText {
public:
    // With its line break.
    void addLine(std::string_view line);
    // Whether Tcl can evaluate it, be it with an error. A long list in braces is looked through once.
    bool isComplete();
    const std::string& text() const { return text_; }
    void clear() { *this = {}; }

private:
    bool isBraceOpen();
    bool isContinued() const;

    std::string text_;
    std::size_t scanned_ = 0;
    int depth_ = 0;  // of the braces that are open at scanned_
};

}  // namespace grsh
