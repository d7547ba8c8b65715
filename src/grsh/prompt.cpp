#include "grsh/prompt.h"

#include <poll.h>
#include <unistd.h>

#include <string>

#include "grsh/error_place.h"
#include "grsh/interrupt.h"
#include "grsh/prompt_input.h"
#include "grsh/shell.h"
#include "grsh/tcl_value.h"

namespace grsh {
namespace {

enum class Read { line, interrupt, end };

// Tcl reads on after a signal, so the waiting is done here; false after a Ctrl-C.
bool waitForInput(Tcl_Channel input) {
    constexpr int kMilliseconds = 250;  // a signal may come just before poll() begins
    pollfd keyboard = {STDIN_FILENO, POLLIN, 0};
    while (Tcl_InputBuffered(input) == 0 && poll(&keyboard, 1, kMilliseconds) <= 0)
        if (interrupted()) return false;
    return true;
}

Read readLine(std::string& command) {
    const Tcl_Channel input = Tcl_GetStdChannel(TCL_STDIN);
    if (!input) return Read::end;
    if (!waitForInput(input)) return Read::interrupt;
    const Value line = hold(Tcl_NewObj());
    if (Tcl_GetsObj(input, line.get()) < 0) return Read::end;
    command += stringOf(line.get()) + "\n";
    return interrupted() ? Read::interrupt : Read::line;
}

// The variables tcl_prompt1 and tcl_prompt2 hold scripts that print a prompt in place of ours.
void showPrompt(Tcl_Interp* interp, bool isContinued) {
    const char* variable = isContinued ? "tcl_prompt2" : "tcl_prompt1";
    if (Tcl_Obj* script = Tcl_GetVar2Ex(interp, variable, nullptr, TCL_GLOBAL_ONLY)) {
        const int code = Tcl_EvalObjEx(interp, hold(script).get(), TCL_EVAL_GLOBAL);
        interrupted() = false;
        if (code == TCL_OK) return print(TCL_STDOUT, "");
        print(TCL_STDERR, stringOf(Tcl_GetObjResult(interp)) + "\n");
    }
    if (!isContinued) print(TCL_STDOUT, "% ");
}

void evaluate(Tcl_Interp* interp, const std::string& command) {
    const int code = Tcl_RecordAndEvalObj(interp, textValue(command).get(), TCL_EVAL_GLOBAL);
    const std::string result = stringOf(Tcl_GetObjResult(interp));
    if (code == TCL_OK) {
        if (!result.empty()) print(TCL_STDOUT, result + "\n");
        return;
    }
    // A command that was waiting may tell in its own way that it was not to go on.
    if (interrupted()) return print(TCL_STDERR, "interrupted\n");
    const std::string where = errorPlace(interp);
    print(TCL_STDERR, (where.empty() ? "" : where + ": ") + result + "\n");
}

// Words that somebody types who does not know gr_help; a script's own commands of these names stay.
void addHelp(Tcl_Interp* interp) {
    Tcl_CmdInfo info;
    for (const char* name : {"help", "?"})
        if (!Tcl_GetCommandInfo(interp, name, &info)) Tcl_CreateAlias(interp, name, interp, "gr_help", 0, nullptr);
}

}  // namespace

int runPrompt(Tcl_Interp* interp) {
    makeInterruptible(interp);
    addHelp(interp);
    std::string command;
    while (true) {
        if (endsThePrompt()) return ending().code;
        interrupted() = false;
        showPrompt(interp, !command.empty());
        const Read read = readLine(command);
        if (read == Read::line && !Tcl_CommandComplete(command.c_str())) continue;
        if (read == Read::line) evaluate(interp, command);
        if (read != Read::line) print(TCL_STDOUT, "\n");
        if (read == Read::end) return 0;
        command.clear();
    }
}

}  // namespace grsh
