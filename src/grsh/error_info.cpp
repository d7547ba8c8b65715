#include "grsh/error_info.h"

#include <charconv>

#include "grsh/script_text.h"

namespace grsh {
namespace {

constexpr std::string_view kFirst = "\n    while executing\n\"";
constexpr std::string_view kNext = "\n    invoked from within\n\"";
constexpr std::string_view kNote = "\n    (";
constexpr std::size_t kShownBytes = 150;

std::size_t nextCommand(std::string_view info, std::size_t from) {
    const std::size_t first = info.find(kFirst, from);
    const std::size_t next = info.find(kNext, from);
    if (first < next) return first + kFirst.size();
    return next == info.npos ? info.npos : next + kNext.size();
}

// The quote that closes a command: what follows it is the trace's own.
std::size_t closingQuote(std::string_view info, std::size_t from) {
    for (std::size_t at = info.find('"', from); at != info.npos; at = info.find('"', at + 1)) {
        const std::string_view rest = info.substr(at + 1);
        if (rest.empty() || rest.starts_with(kNote) || rest.starts_with(kNext)) return at;
    }
    return info.npos;
}

// Notes stand between two commands, e.g. ("foreach" body line 3); those with a line name a unit.
std::vector<ErrorUnit> readUnits(std::string_view notes) {
    constexpr std::string_view kLine = " line ";
    std::vector<ErrorUnit> units;
    std::size_t open = notes.find(kNote);
    for (std::size_t at = notes.find(kLine); at != notes.npos; at = notes.find(kLine, at + 1)) {
        int line = 0;
        const char* end = notes.data() + notes.size();
        const auto [after, error] = std::from_chars(notes.data() + at + kLine.size(), end, line);
        const std::string_view rest(after, end);
        if (error != std::errc() || open > at || (rest != ")" && !rest.starts_with(")\n    "))) continue;
        const std::size_t name = open + kNote.size();
        units.push_back({std::string(notes.substr(name, at - name)), line});
        open = notes.find(kNote, at);
    }
    return units;
}

ErrorLevel readCommand(std::string_view command) {
    ErrorLevel level;
    if (command.size() >= kShownBytes && command.ends_with("...")) {
        level.cut = true;
        command.remove_suffix(3);
        // The cut may go through a character.
        while (!command.empty() && (command.back() & 0x80)) command.remove_suffix(1);
    }
    level.command = joinLines(command).text;
    const std::size_t last = level.command.find_last_not_of(" \t\n");
    level.command.resize(last == std::string::npos ? 0 : last + 1);
    return level;
}

}  // namespace

std::vector<ErrorLevel> errorLevels(std::string_view errorInfo, std::string_view message) {
    std::vector<ErrorLevel> levels;
    std::size_t at = nextCommand(errorInfo, errorInfo.starts_with(message) ? message.size() : 0);
    while (at != errorInfo.npos) {
        const std::size_t close = closingQuote(errorInfo, at);
        if (close == errorInfo.npos) break;
        levels.push_back(readCommand(errorInfo.substr(at, close - at)));
        const std::size_t next = errorInfo.find(kNext, close);
        levels.back().units = readUnits(errorInfo.substr(close + 1, next - close - 1));
        at = next == errorInfo.npos ? next : next + kNext.size();
    }
    return levels;
}

}  // namespace grsh
