#include "grsh/command_line.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "core/error.h"
#include "grsh/unread_words.h"

namespace grsh {
namespace {

// An option: its name, what stands behind it or nothing, what it does, and what of a command line it sets.
struct Row {
    std::string_view name;
    std::string_view argument;
    std::string_view help;
    void (*set)(CommandLine& line, const std::string& argument);
};

[[noreturn]] void fail(const std::string& word, const std::string& message) {
    throw core::Error("USAGE", "WRONG", word, message);
}

[[noreturn]] void failValue(std::string_view option, const std::string& allowed, const std::string& given) {
    fail(given, std::string(option) + " must be " + allowed + ", not \"" + given + "\"");
}

double seconds(std::string_view option, const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value > 0 && value <= 1e9))
        failValue(option, "a number greater than 0 and at most 1000000000, seconds", text);
    return value;
}

std::uint64_t count(std::string_view option, const std::string& text, std::uint64_t most) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > most)
        failValue(option, "an integer from 1 to " + std::to_string(most), text);
    return value;
}

// 512M is 512 times 2^20.
std::uint64_t bytes(std::string_view option, const std::string& text) {
    constexpr std::string_view kUnits = "KMGT";
    constexpr std::uint64_t kMost = 1ull << 60;
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string_view unit(end, text.data() + text.size());
    const std::size_t power = unit.empty() ? 0 : kUnits.find(unit) + 1;
    const bool isUnit = unit.empty() || (unit.size() == 1 && power > 0);
    if (error != std::errc() || !isUnit || value < 1 || value > kMost >> (10 * power))
        failValue(option, "bytes, e.g. 500000000, 512M or 2G", text);
    return value << (10 * power);
}

constexpr std::array<Row, 14> rows{{
    {"--safe", "",
     "run a script that is not trusted: it reads only below its own folder, writes only pictures below\n"
     "the current one, and starts no program",
     [](CommandLine& line, const std::string&) { line.isSafe = true; }},
    {"--allow-read", "DIR", "with --safe, let it read below DIR, too; may be given more than once",
     [](CommandLine& line, const std::string& folder) { line.readFolders.push_back(folder); }},
    {"--allow-write", "DIR", "with --safe, let it write pictures below DIR, too; may be given more than once",
     [](CommandLine& line, const std::string& folder) { line.writeFolders.push_back(folder); }},
    {"--limit-time", "SECONDS", "end after so many seconds, whatever goes on",
     [](CommandLine& line, const std::string& text) { line.limits.seconds = seconds("--limit-time", text); }},
    {"--limit-memory", "BYTES", "use no more memory than that; 512M and 2G are understood",
     [](CommandLine& line, const std::string& text) { line.limits.bytes = bytes("--limit-memory", text); }},
    {"--limit-pixels", "N", "render no picture of more pixels, width times height",
     [](CommandLine& line, const std::string& text) {
         line.limits.pixels = count("--limit-pixels", text, 1000000000000);
     }},
    {"--limit-samples", "N", "render no picture with more samples per pixel",
     [](CommandLine& line, const std::string& text) {
         line.limits.samples = static_cast<int>(count("--limit-samples", text, std::numeric_limits<int>::max()));
     }},
    {"--set", "OPTION=VALUE",
     "give gr_render that option, or that file, width or height, whatever the script says; may be given\n"
     "more than once",
     [](CommandLine& line, const std::string& assignment) { line.sets.push_back(assignment); }},
    {"--resume", "", "go on with renders that were interrupted",
     [](CommandLine& line, const std::string&) { line.resumes = true; }},
    {"--trace", "", "show with an error which calls led to it",
     [](CommandLine& line, const std::string&) { line.traces = true; }},
    {"-encoding", "NAME", "read the script in that encoding, not in UTF-8",
     [](CommandLine& line, const std::string& name) { line.encoding = name; }},
    {"-e", "SCRIPT", "run SCRIPT itself, which comes in the place of a file's name",
     [](CommandLine& line, const std::string& text) { line.text = text; }},
    {"--help", "", "show this text",
     [](CommandLine& line, const std::string&) { line.asks = CommandLine::Asks::help; }},
    {"--version", "", "show the version",
     [](CommandLine& line, const std::string&) { line.asks = CommandLine::Asks::version; }},
}};

// An option of gr_render that stands before the script, whose words follow it.
std::string asSet(const std::vector<std::string>& words, std::size_t at, Spelling spelling) {
    const std::string text = setMeant(words, at, spelling);
    return text.empty() || at == words.size() ? "" : " (did you mean \"" + text + "\"?)";
}

// What was meant by an option that there is not.
std::string hint(const std::vector<std::string>& words, std::size_t at) {
    const std::string& option = words[at];
    std::vector<std::string_view> names;
    for (const Row& row : rows) {
        const std::string name(row.name);
        if (!row.argument.empty() && option.starts_with(name + "="))
            return " (did you mean \"" + name + " " + inShell(option.substr(name.size() + 1)) + "\"?)";
        // One letter is as near to any other.
        if (name.size() > 2) names.push_back(row.name);
    }
    if (const std::string text = asSet(words, at, Spelling::right); !text.empty()) return text;
    const std::string text = core::didYouMean(option, names);
    return text.empty() ? asSet(words, at, Spelling::near) : text;
}

const Row& rowAt(const std::vector<std::string>& words, std::size_t at) {
    const auto* const row = std::ranges::find(rows, words[at], &Row::name);
    if (row == rows.end()) fail(words[at], "unknown option \"" + words[at] + "\"" + hint(words, at));
    return *row;
}

bool isOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-' && word != "--";
}

// Reads the option at a word and returns the number of the next word.
std::size_t readOption(CommandLine& line, const std::vector<std::string>& words, std::size_t at) {
    const Row& row = rowAt(words, at);
    std::size_t next = at + 1;
    if (!row.argument.empty() && next == words.size())
        fail(words[at], words[at] + " needs another word, " + std::string(row.argument));
    row.set(line, row.argument.empty() ? "" : words[next++]);
    // --help and --version come last.
    if (line.asks != CommandLine::Asks::run && next < words.size())
        fail(words[next], "unexpected word \"" + words[next] + "\" after " + words[at]);
    return next;
}

void checkTogether(const CommandLine& line) {
    if (line.isSafe) return;
    if (!line.readFolders.empty()) fail("--allow-read", "--allow-read is of use with --safe only");
    if (!line.writeFolders.empty()) fail("--allow-write", "--allow-write is of use with --safe only");
}

}  // namespace

CommandLine readCommandLine(const std::vector<std::string>& words) {
    CommandLine line;
    std::size_t at = 0;
    while (at < words.size() && isOption(words[at]) && !line.text) at = readOption(line, words, at);
    if (line.text) {
        checkTogether(line);
        line.script = "-e";
        line.words.assign(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
        return line;
    }
    const bool endsOptions = at < words.size() && words[at] == "--";
    if (endsOptions) ++at;
    checkTogether(line);
    if (at == words.size()) return line;
    line.isStandardInput = words[at] == "-" && !endsOptions;
    line.script = words[at];
    line.words.assign(words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end());
    return line;
}

std::string usageLine() {
    return "usage: grsh [options] [script.gr [arg ...]]";
}

std::size_t wordsOfOption(const std::string& word) {
    if (word == "-e" || word == "--help" || word == "--version") return 0;
    for (const Row& row : rows)
        if (row.name == word) return row.argument.empty() ? 1 : 2;
    return 0;
}

std::string helpText() {
    constexpr std::size_t kColumn = 26;
    std::string text = usageLine() + R"(

Runs a scene script, a Tcl script with the gr_* commands besides. Without a script it shows a prompt, or runs
standard input where that is no terminal.

)";
    const auto add = [&](std::string left, std::string_view help) {
        left.resize(std::max(left.size() + 1, kColumn), ' ');
        text += left;
        for (const char c : help) text += c == '\n' ? "\n" + std::string(kColumn, ' ') : std::string(1, c);
        text += "\n";
    };
    add("  -", "run standard input as the script");
    add("  --", "end of the options: the next word is the script whatever it begins with");
    for (const Row& row : rows)
        add("  " + std::string(row.name) + (row.argument.empty() ? "" : " " + std::string(row.argument)), row.help);
    return text + R"(
The script finds its further words in argv; one that never looks there gets a warning. An error is shown as
"file:line: message" and exits 1, wrong usage exits 2, a signal n exits 128 + n, so Ctrl-C 130. What --safe keeps from
a script is told in docs/safe-mode.md.

  grsh scenes/hello.gr           renders the smallest scene
  grsh -e 'puts [gr_help]'       lists the commands; 'puts [gr_help gr_render]' explains one
)";
}

}  // namespace grsh
