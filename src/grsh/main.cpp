// grsh's command line.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "grsh/last_resort.h"
#include "grsh/shell.h"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

constexpr const char* kHelp =
    R"(usage: grsh [options] [script.gr [arg ...]]

Runs a scene script, a Tcl script with the gr_* commands besides. Without a script it shows a prompt, or runs
standard input where that is no terminal.

  -          run standard input as the script
  --         end of the options: the next word is the script whatever it begins with
  --trace    show Tcl's stack trace after the message of an error
  -encoding NAME  read the script in that encoding, not in UTF-8
  --help     show this text
  --version  show the version

The script finds its further words in argv. An error is shown as "file:line: message" and exits 1, wrong usage
exits 2, Ctrl-C exits 130.

  grsh scenes/hello.gr           renders the smallest scene
  echo 'puts [gr_help]' | grsh -    lists the commands; 'puts [gr_help gr_render]' explains one
)";

int wrongUsage(const std::string& message) {
    std::fprintf(stderr, "grsh: %s\nusage: grsh [options] [script.gr [arg ...]]; grsh --help shows more\n",
                 message.c_str());
    return kWrongUsage;
}

bool isOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-';
}

// --help and --version stand alone.
int answer(const std::vector<std::string>& words) {
    constexpr std::array<std::string_view, 2> kOptions = {"--help", "--version"};
    const std::string& option = words[0];
    if (option != "--help" && option != "--version")
        return wrongUsage("unknown option \"" + option + "\"" + core::didYouMean(option, kOptions));
    if (words.size() > 1) return wrongUsage("unexpected word \"" + words[1] + "\" after " + option);
    std::fputs(option == "--help" ? kHelp : "grsh " GRSH_VERSION "\n", stdout);
    return 0;
}

struct Options {
    std::string encoding = "utf-8";
    bool trace = false;
};

// The options before a script, taken from the words.
Options takeOptions(std::vector<std::string>& words) {
    Options options;
    while (!words.empty()) {
        const std::size_t count = words[0] == "--trace" ? 1 : words[0] == "-encoding" && words.size() > 1 ? 2 : 0;
        if (count == 0) break;
        if (count == 1) options.trace = true;
        if (count == 2) options.encoding = words[1];
        words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return options;
}

int run(const std::string& program, std::vector<std::string> words) {
    const Options options = takeOptions(words);
    const bool endsOptions = !words.empty() && words[0] == "--";
    if (!words.empty() && !endsOptions && isOption(words[0])) return answer(words);
    if (endsOptions) words.erase(words.begin());
    grsh::Shell shell(program);
    if (!shell.setEncoding(options.encoding)) return wrongUsage("unknown encoding \"" + options.encoding + "\"");
    shell.showTrace(options.trace);
    if (words.empty()) return isatty(STDIN_FILENO) ? shell.runPrompt(program) : shell.runStandardInput(program, {});
    const std::string script = words[0];
    words.erase(words.begin());
    if (script == "-" && !endsOptions) return shell.runStandardInput(script, words);
    return shell.runScript(script, words);
}

}  // namespace

int main(int argc, char** argv) {
    grsh::installLastResort();
    try {
        return run(argv[0], {argv + 1, argv + argc});
    } catch (const std::bad_alloc&) {
        grsh::releaseReserve();
        std::fputs("grsh: out of memory\n", stderr);
        return kFailed;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "grsh: %s\n", error.what());
        return kFailed;
    }
}
