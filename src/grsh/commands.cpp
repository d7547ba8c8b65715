#include "grsh/commands.h"
#include "grsh/error_place.h"
#include "grsh/last_resort.h"
#include "grsh/word_hints.h"

#include <algorithm>
#include <new>
#include <system_error>

namespace grsh {
namespace {

struct WrongWords {};

// A command under one of its names, in one interpreter.
struct Binding {
    const Command* command;
    std::string_view name;
    Session* session;
};

struct State {
    Session session;
    std::vector<std::unique_ptr<Binding>> bindings;
    Tcl_ObjCmdProc* tclUnknown = nullptr;  // what evaluates Tcl's own procedure `unknown`
};

constexpr const char* stateKey = "grsh";

int wrongWords(Tcl_Interp* interp, const Binding& binding) {
    std::string message = "wrong # args: should be \"" + std::string(binding.name);
    if (!binding.command->usage.empty()) message += " " + std::string(binding.command->usage);
    Tcl_SetObjResult(interp, textObject(message + "\""));
    Tcl_SetErrorCode(interp, "TCL", "WRONGARGS", nullptr);
    return TCL_ERROR;
}

int failed(Tcl_Interp* interp, std::string_view command, const core::Error& error) {
    // A name that is not known may be a variable that nothing has replaced.
    const bool isName = error.reason == "UNKNOWN" || error.reason == "WORD";
    const std::string hint = isName ? bracesHint(error.word) : "";
    Tcl_SetObjResult(interp, textObject(std::string(command) + ": " + error.what() + hint));
    Tcl_SetErrorCode(interp, "GR", error.topic.c_str(), error.reason.c_str(), error.word.c_str(), nullptr);
    return TCL_ERROR;
}

// Those that are Tcl's own have no gr_.
std::string_view kindOf(const Command& command) {
    constexpr std::string_view prefix = "gr_";
    return command.name.starts_with(prefix) ? command.name.substr(prefix.size()) : command.name;
}

// The one place where errors of ours become Tcl's; no exception leaves it.
int run(ClientData data, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) {
    takeReserve();
    const Binding& binding = *static_cast<const Binding*>(data);
    const std::size_t words = static_cast<std::size_t>(objc) - 1;
    if (words < binding.command->leastWords || words > binding.command->mostWords) return wrongWords(interp, binding);
    try {
        Call call{interp, *binding.session, Words(objc, objv), kindOf(*binding.command)};
        Tcl_Obj* result = binding.command->function(call);
        if (result != nullptr) Tcl_SetObjResult(interp, result);
        return TCL_OK;
    } catch (const WrongWords&) {
        return wrongWords(interp, binding);
    } catch (const ScriptEnded& script) {
        return script.code;
    } catch (const core::Error& error) {
        return failed(interp, binding.name, error);
    } catch (const std::bad_alloc&) {
        releaseReserve();
        return failed(interp, binding.name, core::Error("MEMORY", "NONE", "", "out of memory"));
    } catch (const std::system_error& error) {
        return failed(interp, binding.name, core::Error("SYSTEM", "FAILED", "", error.what()));
    } catch (const std::exception& error) {
        return failed(interp, binding.name, core::Error("INTERNAL", "EXCEPTION", "", error.what()));
    }
}

// One of ours that is misspelt, or lacks its gr_, gets a suggestion.
void suggest(Tcl_Interp* interp, const State& state, const std::string& name) {
    std::vector<std::string_view> names;
    for (const auto& binding : state.bindings)
        if (binding->name.starts_with("gr_")) names.push_back(binding->name);
    const std::string whole = name.starts_with("gr_") ? name : "gr_" + name;
    const bool isMeant = whole == name || std::ranges::count(names, whole) > 0;
    const std::string hint = isMeant ? core::didYouMean(whole, names) : "";
    Tcl_SetObjResult(interp, textObject("invalid command name \"" + name + "\"" + hint));
}

// Tcl calls `unknown` for a command that does not exist; this where all that it knows is that there is none.
int unknownCommand(ClientData procedure, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) noexcept {
    const State& state = *static_cast<State*>(Tcl_GetAssocData(interp, stateKey, nullptr));
    const int code = state.tclUnknown(procedure, interp, objc, objv);
    const std::string name(objc > 1 ? textOf(objv[1]) : std::string_view());
    const std::string message = "invalid command name \"" + name + "\"";
    if (code == TCL_ERROR && textOf(Tcl_GetObjResult(interp)) == message) suggest(interp, state, name);
    return code;
}

// A safe interpreter has no `unknown` of Tcl's.
int safeUnknown(ClientData data, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) {
    const std::string name(objc > 1 ? textOf(objv[1]) : std::string_view());
    suggest(interp, *static_cast<const State*>(data), name);
    Tcl_SetErrorCode(interp, "TCL", "LOOKUP", "COMMAND", name.c_str(), nullptr);
    return TCL_ERROR;
}

// It stays Tcl's own procedure, with its body, for every script that looks at it, extends it or brings another.
void wrapUnknown(Tcl_Interp* interp, State& state) {
    if (Tcl_IsSafe(interp)) {
        Tcl_CreateObjCommand(interp, "::unknown", safeUnknown, &state, nullptr);
        return;
    }
    Tcl_CmdInfo info;
    if (!Tcl_GetCommandInfo(interp, "::unknown", &info)) return;
    state.tclUnknown = info.objProc;
    info.objProc = unknownCommand;
    Tcl_SetCommandInfo(interp, "::unknown", &info);
}

void deleteState(ClientData data, Tcl_Interp*) {
    delete static_cast<State*>(data);
}

}  // namespace

void warn(Call& call, const std::string& text) {
    const std::string where = place(call.interp);
    const std::string line = (where.empty() ? "" : where + ": ") + "warning: " + text + "\n";
    Tcl_Channel channel = Tcl_GetStdChannel(TCL_STDERR);
    if (channel != nullptr) Tcl_WriteChars(channel, line.data(), static_cast<int>(line.size()));
}

void throwWrongWords() {
    throw WrongWords{};
}

std::vector<const Command*> allCommands() {
    std::vector<const Command*> commands;
    for (const auto table :
         {shapeCommands(), meshCommands(), nodeCommands(), transformCommands(), textureCommands(), materialCommands(),
          lightCommands(), renderCommands(), imageCommands(), statsCommands(), helpCommands()})
        for (const Command& command : table) commands.push_back(&command);
    return commands;
}

void registerCommands(Tcl_Interp* interp, const FileAccess& files, Overrides& overrides, const Limits& limits,
                      bool resumes) {
    State* state = new State;
    state->session.files = &files;
    state->session.overrides = &overrides;
    state->session.limits = limits;
    state->session.resumes = resumes;
    Tcl_SetAssocData(interp, stateKey, deleteState, state);
    std::vector<const Command*> commands = allCommands();
    if (files.isSafe())
        for (const Command& command : safeCommands()) commands.push_back(&command);
    for (const Command* command : commands) {
        for (const std::string_view name : {command->name, command->alias}) {
            if (name.empty()) continue;
            state->bindings.push_back(std::make_unique<Binding>(Binding{command, name, &state->session}));
            Tcl_CreateObjCommand(interp, std::string(name).c_str(), run, state->bindings.back().get(), nullptr);
        }
    }
    wrapUnknown(interp, *state);
}

}  // namespace grsh
