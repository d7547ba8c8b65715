// The commands that take the place of Tcl's in safe mode.

#include "grsh/commands.h"
#include "image/image_file.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace grsh {
namespace {

// Tcl would put a home folder in place of ~.
void checkHome(std::string_view name) {
    if (name.starts_with('~'))
        throw core::Error("SAFE", "HOME", std::string(name),
                          "cannot use \"" + std::string(name) + "\": --safe knows no home folders");
}

// source ?-encoding name? file. What it may read Tcl opens once more, and no more than that.
Tcl_Obj* sourceCommand(Call& call) {
    const bool hasEncoding = call.words.size() == 3;
    if (call.words.size() == 2 || (hasEncoding && call.words.text(0) != "-encoding")) throwWrongWords();
    const std::size_t at = call.words.size() - 1;
    const std::string name = call.words.fileName(at, "file");
    checkHome(name);
    call.session.files->toRead(name);
    const std::string encoding = hasEncoding ? std::string(call.words.text(1)) : "utf-8";
    const int code = Tcl_FSEvalFileEx(call.interp, call.words.object(at), encoding.c_str());
    if (code != TCL_OK) throw ScriptEnded{code};
    return Tcl_GetObjResult(call.interp);
}

void checkMode(Call& call, const std::string& name) {
    if (name.starts_with('|'))
        throw core::Error("SAFE", "PROGRAM", name, "cannot run \"" + name.substr(1) + "\": --safe starts no program");
    if (call.words.size() < 2) return;
    const std::string_view mode = call.words.text(1);
    constexpr std::array<std::string_view, 4> kReads = {"r", "rb", "RDONLY", "RDONLY BINARY"};
    if (std::find(kReads.begin(), kReads.end(), mode) == kReads.end())
        throw core::Error("SAFE", "WRITE", name,
                          "cannot open \"" + name + "\" as \"" + std::string(mode) +
                              "\": --safe writes only pictures, and opens files for \"r\" and \"rb\"");
}

// open file ?mode?
Tcl_Obj* openCommand(Call& call) {
    const std::string name = call.words.fileName(0, "file");
    checkMode(call, name);
    const image::FileName file = call.session.files->toRead(name);
    const int own = open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
    if (own < 0) throw core::Error("FILE", "READ", name, "cannot read \"" + name + "\": " + std::strerror(errno));
    const auto data = reinterpret_cast<ClientData>(static_cast<std::intptr_t>(own));
    const Tcl_Channel channel = Tcl_MakeFileChannel(data, TCL_READABLE);
    Tcl_RegisterChannel(call.interp, channel);
    const bool isBinary = call.words.size() > 1 && call.words.text(1) != "r" && call.words.text(1) != "RDONLY";
    if (isBinary) Tcl_SetChannelOption(nullptr, channel, "-translation", "binary");
    return textObject(Tcl_GetChannelName(channel));
}

// A name's parts are told whatever it names; what is there is told only of what may be read, see safe_files.cpp.
constexpr std::array<std::string_view, 14> kFileTopics = {
    "dirname",  "exists",   "extension", "isdirectory", "isfile", "join",  "normalize",
    "pathtype", "readable", "rootname",  "separator",   "size",   "split", "tail"};

// file topic ?name ...?, by the parent's command of that topic.
Tcl_Obj* fileCommand(Call& call) {
    const std::string_view topic = call.words.text(0);
    if (std::find(kFileTopics.begin(), kFileTopics.end(), topic) == kFileTopics.end())
        throw core::Error(
            "SAFE", "COMMAND", std::string(topic),
            "--safe leaves out \"file " + std::string(topic) + "\"; there are " + core::listed(kFileTopics));
    std::vector<Value> words;
    words.push_back(textValue("::tcl::file::" + std::string(topic)));
    for (std::size_t i = 1; i < call.words.size(); ++i) {
        checkHome(call.words.text(i));
        words.push_back(textValue(call.words.text(i)));
    }
    // Tcl's own would follow links outside.
    if (topic == "normalize" && words.size() == 2) return textObject(plainPath(call.words.fileName(1, "name")));
    std::vector<Tcl_Obj*> objects;
    for (const Value& word : words) objects.push_back(word.get());
    Tcl_Interp* parent = Tcl_GetMaster(call.interp);
    const int code = Tcl_EvalObjv(parent, static_cast<int>(objects.size()), objects.data(), TCL_EVAL_GLOBAL);
    Tcl_TransferResult(parent, code, call.interp);
    if (code != TCL_OK) throw ScriptEnded{code};
    return Tcl_GetObjResult(call.interp);
}

constexpr std::array<Command, 3> rows{{
    {"file", "", "topic ?name ...?", 1, anyNumberOfWords, fileCommand, "tells a file name's parts, or of a file"},
    {"open", "", "file ?mode?", 1, 2, openCommand, "opens a file to be read"},
    {"source", "", "?-encoding name? file", 1, 3, sourceCommand, "runs a file"},
}};

}  // namespace

std::span<const Command> safeCommands() {
    return rows;
}

}  // namespace grsh
