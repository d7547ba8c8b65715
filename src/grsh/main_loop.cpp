#include "grsh/main_loop.h"

#include <array>
#include <string>

#include "grsh/interrupt.h"
#include "grsh/place.h"
#include "grsh/shell.h"
#include "grsh/tcl_value.h"

namespace grsh {
namespace {

// Tcl_MainEx sets them anew, but they are the script's.
constexpr std::array<const char*, 4> kVariables = {"argv0", "argv", "argc", "tcl_interactive"};
std::array<Tcl_Obj*, kVariables.size()> kept;

int restoreVariables(Tcl_Interp* interp) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
        Tcl_UnsetVar(interp, kVariables[i], TCL_GLOBAL_ONLY);
        if (kept[i] == nullptr) continue;
        Tcl_SetVar2Ex(interp, kVariables[i], nullptr, kept[i], TCL_GLOBAL_ONLY);
        Tcl_DecrRefCount(kept[i]);
    }
    return TCL_OK;
}

// An event loop goes on when the evaluation of an event is cancelled.
void endWhenInterrupted(ClientData, int) {
    if (interrupted()) Tcl_Exit(sayInterrupted());
}

void checkNothing(ClientData, int) {}

bool hasLoaded(Tcl_Interp* interp) {
    const KeptState state(interp);
    const Value libraries = ask(interp, {"::tcl::info::loaded"});
    return libraries != nullptr && !stringOf(libraries.get()).empty();
}

}  // namespace

// Nothing but Tcl's own main function tells which loop was set, so it is called with a script that does nothing.
void runMainLoop(Tcl_Interp* interp) {
    if (!hasLoaded(interp)) return;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        kept[i] = Tcl_GetVar2Ex(interp, kVariables[i], nullptr, TCL_GLOBAL_ONLY);
        if (kept[i] != nullptr) Tcl_IncrRefCount(kept[i]);
    }
    Tcl_CreateEventSource(endWhenInterrupted, checkNothing, nullptr);
    Tcl_SetStartupScript(Tcl_NewStringObj("/dev/null", -1), nullptr);
    std::string name = "grsh";
    char* words[] = {name.data(), nullptr};
    Tcl_MainEx(1, words, restoreVariables, interp);
}

}  // namespace grsh
