// grsh's own words: its options, the script and the script's words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grsh/limits.h"

namespace grsh {

struct CommandLine {
    enum class Asks { run, help, version };

    Asks asks = Asks::run;
    bool isSafe = false;
    std::vector<std::string> readFolders, writeFolders;  // beside the script's and the current one
    Limits limits;
    bool resumes = false;
    bool traces = false;
    std::string encoding = "utf-8";  // of the script
    std::vector<std::string> sets;  // option=value each

    std::optional<std::string> script;  // none: a prompt, or standard input
    bool isStandardInput = false;  // the script was given as "-"
    std::optional<std::string> text;  // the script itself; its name is -e then
    std::vector<std::string> words;  // the script's own
};

// words: all behind the program's name. Throws core::Error, whose topic is USAGE.
CommandLine readCommandLine(const std::vector<std::string>& words);

std::string usageLine();
// What --help shows.
std::string helpText();

// How many words an option takes that may stand before a script, itself included; 0 for what is none.
std::size_t wordsOfOption(const std::string& word);

}  // namespace grsh
