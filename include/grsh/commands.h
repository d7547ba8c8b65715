// The commands that the shell adds to Tcl: rows of tables, one table a topic.
#pragma once

#include "gr/database/database.h"
#include "grsh/file_access.h"
#include "grsh/limits.h"
#include "grsh/overrides.h"
#include "grsh/tcl_value.h"
#include "grsh/words.h"
#include "render/settings.h"

#include <tcl.h>

#include <span>
#include <string>

namespace grsh {

// What gr_default has set.
struct RenderDefaults {
    render::RenderSettings settings;
    std::vector<std::pair<std::string_view, Value>> words;  // option and value, in the order of their first setting
};

// What belongs to one interpreter.
struct Session {
    gr::Database database;
    Value lastRender;  // what the last gr_render returned, or null
    const FileAccess* files = nullptr;  // never null where commands run
    Limits limits;
    bool resumes = false;  // the default of gr_render's option resume
    RenderDefaults defaults;
    Overrides* overrides = nullptr;  // never null where commands run
};

// One call of a command.
struct Call {
    Tcl_Interp* interp;
    Session& session;
    Words words;
    std::string_view kind;  // the command's name without its gr_: what #auto counts
};

// To add a command: write its function and a row in the file of its topic. Word counts, usage errors, gr_help and
// docs/language.md come from the row.
struct Command {
    std::string_view name;
    std::string_view alias;  // an older name, or empty
    std::string_view usage;  // the words behind the name
    std::size_t leastWords;
    std::size_t mostWords;
    // Returns the command's result, or null for none. Throws core::Error, without the command's name.
    Tcl_Obj* (*function)(Call& call);
    std::string_view help;
    std::string_view details = {};  // lines that gr_help adds, e.g. what the words mean
};

inline constexpr std::size_t anyNumberOfWords = ~std::size_t{0};

std::span<const Command> shapeCommands();
std::span<const Command> meshCommands();
std::span<const Command> nodeCommands();
std::span<const Command> transformCommands();
std::span<const Command> textureCommands();
std::span<const Command> materialCommands();
std::span<const Command> lightCommands();
std::span<const Command> renderCommands();
std::span<const Command> imageCommands();
std::span<const Command> statsCommands();
std::span<const Command> helpCommands();
// Those that are Tcl's own without --safe.
std::span<const Command> safeCommands();
// All of ours, in the order in which help lists them.
std::vector<const Command*> allCommands();

// What is known of the options that a command takes.
struct OptionHelp;
std::vector<OptionHelp> materialOptionsHelp();
std::vector<OptionHelp> textureOptionsHelp();
std::vector<OptionHelp> renderOptionsHelp();
std::vector<OptionHelp> compareOptionsHelp();
std::vector<OptionHelp> meshOptionsHelp();
std::vector<OptionHelp> polyhedronOptionsHelp();
std::vector<OptionHelp> lightOptionsHelp();
std::vector<OptionHelp> sunOptionsHelp();

// Creates the commands, and a session that lives as long as the interpreter; files and overrides live longer.
void registerCommands(Tcl_Interp* interp, const FileAccess& files, Overrides& overrides, const Limits& limits,
                      bool resumes);

inline Tcl_Obj* textObject(std::string_view text) {
    return Tcl_NewStringObj(text.data(), static_cast<int>(text.size()));
}

// Prints a warning with the place in the script to standard error.
void warn(Call& call, const std::string& text);

// Thrown by a command that has run a script, with that script's error or other end as the result.
struct ScriptEnded {
    int code;
};

// "wrong # args", for word counts that lie between a row's least and most but are none of the command's.
[[noreturn]] void throwWrongWords();

}  // namespace grsh
