// Links: shell
// Seeds: tests/bad/*.gr
// Scripts in a safe interpreter: commands of grsh, and those of Tcl that neither wait, nor loop, nor make much of
// little.
#include "grsh/commands.h"
#include "grsh/error_place.h"
#include "grsh/safe_interp.h"
#include "grsh/script_text.h"

#include <tcl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

constexpr const char* hidden[] = {"after",     "binary",  "encoding", "exit",   "for",    "format",
                                  "gr_median", "lrepeat", "puts",     "regexp", "regsub", "scan",
                                  "string",    "time",    "timerate", "update", "vwait",  "while"};

// A folder of its own is all that scripts can see of files.
std::string ownFolder() {
    char name[] = "/tmp/grsh-fuzz-XXXXXX";
    if (mkdtemp(name) == nullptr || chdir(name) != 0) std::abort();
    return name;
}

struct Parent {
    Parent() : folder(ownFolder()), files({folder}, {folder}) {
        Tcl_FindExecutable("grsh");
        Tcl_SetSystemEncoding(nullptr, "utf-8");
        interp = Tcl_CreateInterp();
        if (Tcl_Init(interp) != TCL_OK) std::abort();
    }
    ~Parent() {
        std::error_code failed;
        std::filesystem::remove_all(folder, failed);
    }

    std::string folder;
    grsh::FileAccess files;
    Tcl_Interp* interp;
};

void evaluate(Parent& parent, const std::string& script) {
    Tcl_Interp* const interp = grsh::makeSafeInterp(parent.interp);
    grsh::Limits limits;
    limits.pixels = 64;
    limits.samples = 1;
    grsh::Overrides overrides;
    grsh::registerCommands(interp, parent.files, overrides, limits, false);
    for (const char* name : hidden) Tcl_DeleteCommand(interp, name);
    Tcl_LimitSetCommands(interp, 300);
    Tcl_LimitTypeSet(interp, TCL_LIMIT_COMMANDS);
    Tcl_EvalEx(interp, script.data(), static_cast<int>(script.size()), TCL_EVAL_GLOBAL);
    Tcl_DeleteInterp(interp);
}

// What makes a render take long whatever its pixels and samples are.
bool maySlowRenders(const std::string& script) {
    return script.find("samplesperl") != std::string::npos || script.find("pathl") != std::string::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static Parent parent;
    const std::string text(bytes, bytes + size);
    const grsh::ScriptText script = grsh::joinLines(text);
    for (std::size_t at = 0; at < script.text.size();) {
        const grsh::CommandSpan command = grsh::commandAt(script, at);
        if (command.end > script.text.size()) std::abort();
        at = std::max(command.end, at + 1);
    }
    if (!maySlowRenders(text)) evaluate(parent, text);
    return 0;
}
