#include "grsh/place.h"

#include <cstdlib>

#include "grsh/error_place.h"
#include "grsh/piped_script.h"
#include "grsh/words.h"

namespace grsh {
namespace {

constexpr const char* kMainScript = "grsh::mainScript";

void forgetMainScript(ClientData script, Tcl_Interp*) {
    delete static_cast<MainScript*>(script);
}

std::string entry(Tcl_Obj* dict, std::string_view key) {
    Tcl_Obj* value = nullptr;
    Tcl_DictObjGet(nullptr, dict, textValue(key).get(), &value);
    return value ? stringOf(value) : "";
}

}  // namespace

void setMainScript(Tcl_Interp* interp, const std::string& typed, const std::string& path) {
    Tcl_SetAssocData(interp, kMainScript, forgetMainScript, new MainScript{typed, normalized(path)});
}

const MainScript* mainScript(Tcl_Interp* interp) {
    return static_cast<MainScript*>(Tcl_GetAssocData(interp, kMainScript, nullptr));
}

std::string normalized(const std::string& path) {
    const Value given = textValue(path);
    Tcl_Obj* whole = Tcl_FSGetNormalizedPath(nullptr, given.get());
    return whole ? stringOf(whole) : path;
}

bool isLibrary(Tcl_Interp* interp, const std::string& path) {
    const char* library = Tcl_GetVar(interp, "tcl_library", TCL_GLOBAL_ONLY);
    return library && path.starts_with(normalized(library) + "/");
}

std::string shown(Tcl_Interp* interp, const Place& place) {
    const MainScript* script = mainScript(interp);
    const std::string here = normalized(".") + "/";
    std::string name = place.path;
    if (script && place.path == script->path)
        name = script->typed;
    else if (place.path.starts_with(here))
        name.erase(0, here.size());
    return name + ":" + std::to_string(place.line);
}

Value ask(Tcl_Interp* interp, std::initializer_list<std::string_view> words) {
    const Value command = hold(Tcl_NewListObj(0, nullptr));
    for (const std::string_view word : words) Tcl_ListObjAppendElement(nullptr, command.get(), textValue(word).get());
    int count = 0;
    Tcl_Obj** values = nullptr;
    Tcl_ListObjGetElements(nullptr, command.get(), &count, &values);
    // Not as a list or a script: either would put a frame of its own before the frames asked for.
    if (Tcl_EvalObjv(interp, count, values, TCL_EVAL_GLOBAL) != TCL_OK) return nullptr;
    return hold(Tcl_GetObjResult(interp));
}

namespace {

// The innermost command that stands in a file; without a path where there is none.
Place placeOf(Tcl_Interp* interp) {
    constexpr std::string_view kFrame = "::tcl::info::frame";
    const KeptState kept(interp);
    int frames = 0;
    const Value count = ask(interp, {kFrame});
    if (!count || Tcl_GetIntFromObj(nullptr, count.get(), &frames) != TCL_OK) return {};
    for (int i = frames; i > 0; --i) {
        const Value frame = ask(interp, {kFrame, std::to_string(i)});
        if (!frame) return {};
        const std::string path = entry(frame.get(), "file");
        if (path.empty() || isLibrary(interp, path)) continue;
        return inWhole({path, std::atoi(entry(frame.get(), "line").c_str())});
    }
    return {};
}

}  // namespace

std::string place(Tcl_Interp* interp) {
    const Place place = placeOf(interp);
    return place.path.empty() ? "" : shown(interp, place);
}

std::string besideScript(Tcl_Interp* interp, std::string_view file) {
    const std::string script = placeOf(interp).path;
    const bool isNoFile = script == standardInputPath || script == commandLinePath;
    const auto asTheSystemHasIt = [](const std::string& path) {
        return fileNameFrom(textValue(normalized(path)).get(), "file");
    };
    if (script.empty() || isNoFile) return asTheSystemHasIt(std::string(file));
    const Value folder = textValue(script.substr(0, script.rfind('/') + 1)), name = textValue(file);
    Tcl_Obj* const parts[] = {name.get()};
    const Value joined = hold(Tcl_FSJoinToPath(folder.get(), 1, parts));
    return asTheSystemHasIt(stringOf(joined.get()));
}

}  // namespace grsh
