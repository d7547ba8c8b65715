#include "grsh/safe_interp.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "grsh/commands.h"

namespace grsh {
namespace {

// What Tcl's own safe interpreters hide, and what could wait for ever, outlive the script or change the process. A
// script that calls one is told why it fails.
constexpr std::array kLeftOut = {"after", "cd", "encoding", "exec", "exit", "fileevent", "glob", "interp", "load",
                                 "pid", "pwd", "socket", "unload", "update", "vwait",
                                 // The same under their other names, and what their ensembles hold.
                                 "::tcl::chan::create", "::tcl::chan::event", "::tcl::chan::pipe", "::tcl::chan::pop",
                                 "::tcl::chan::postevent", "::tcl::chan::push", "::tcl::encoding::dirs",
                                 "::tcl::encoding::system", "::tcl::info::hostname", "::tcl::info::library",
                                 "::tcl::info::nameofexecutable", "::tcl::unsupported::assemble",
                                 "::tcl::unsupported::inject", "::tcl::zlib::push"};

// As scripts call it, e.g. "chan pipe".
std::string shownName(std::string name) {
    constexpr std::string_view kSpace = "::tcl::";
    if (!name.starts_with(kSpace)) return name;
    name.erase(0, kSpace.size());
    return name.replace(name.find("::"), 2, " ");
}

// command: its name at first, for a script may have given it another one.
int refuse(ClientData command, Tcl_Interp* interp, int, Tcl_Obj* const*) {
    const std::string name = shownName(static_cast<const char*>(command));
    Tcl_SetObjResult(interp, textObject(name + ": --safe leaves this command out"));
    Tcl_SetErrorCode(interp, "GR", "SAFE", "COMMAND", name.c_str(), nullptr);
    return TCL_ERROR;
}

void evaluate(Tcl_Interp* interp, const char* script) {
    if (Tcl_EvalEx(interp, script, -1, TCL_EVAL_GLOBAL) != TCL_OK)
        throw std::runtime_error(stringOf(Tcl_GetObjResult(interp)));
    Tcl_ResetResult(interp);
}

}  // namespace

Tcl_Interp* makeSafeInterp(Tcl_Interp* parent) {
    // The child's clock is the parent's, which loads its parts when they are first needed.
    evaluate(parent, "package require msgcat; clock format 0; clock scan 12:00");
    Tcl_Interp* child = Tcl_CreateSlave(parent, "scene", 1);
    if (child == nullptr) throw std::runtime_error("Tcl makes no safe interpreter");
    for (const char* name : kLeftOut) Tcl_CreateObjCommand(child, name, refuse, const_cast<char*>(name), nullptr);
    // Channels are files below the script's folder, and the two standard ones.
    if (Tcl_ExposeCommand(child, "fconfigure", "fconfigure") != TCL_OK)
        throw std::runtime_error(stringOf(Tcl_GetObjResult(child)));
    for (const int standard : {TCL_STDOUT, TCL_STDERR})
        if (const Tcl_Channel channel = Tcl_GetStdChannel(standard)) Tcl_RegisterChannel(child, channel);
    return child;
}

}  // namespace grsh
