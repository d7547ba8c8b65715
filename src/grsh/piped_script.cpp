#include "grsh/piped_script.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>

namespace grsh {
namespace {

constexpr std::string_view kPieces = "/dev/grsh/piece/";  // and the piece's first line

struct State {
    std::string path;
    std::string typed;
    std::string text;
    std::string piece;  // what Tcl is to read: the last piece, with a command before it that gives the script its name
    std::size_t read = 0;  // bytes of the piece that Tcl has read
    int lines = 0;
};
State* state = nullptr;

std::string quoted(const std::string& word) {
    int flags = 0;
    std::string text(static_cast<std::size_t>(Tcl_ScanCountedElement(word.data(), -1, &flags)) + 1, '\0');
    // In braces a line break would stay one, and all lines behind it be wrong.
    text.resize(
        static_cast<std::size_t>(Tcl_ConvertCountedElement(word.data(), -1, text.data(), flags | TCL_DONT_USE_BRACES)));
    return text;
}

bool isPiece(std::string_view path) {
    return path.starts_with(kPieces);
}

int claim(Tcl_Obj* path, ClientData*) {
    return state != nullptr && isPiece(Tcl_GetString(path)) ? TCL_OK : -1;
}

int status(Tcl_Obj*, Tcl_StatBuf* buffer) {
    *buffer = {};
    buffer->st_mode = S_IFREG | S_IRUSR;
    return 0;
}

int access(Tcl_Obj*, int mode) {
    if ((mode & (W_OK | X_OK)) == 0) return 0;
    errno = EACCES;
    return -1;
}

// A channel that reads the piece, for no folder may be writable.
int readPiece(ClientData, char* buffer, int size, int*) {
    const std::size_t count = state->piece.copy(buffer, static_cast<std::size_t>(size), state->read);
    state->read += count;
    return static_cast<int>(count);
}

int closePiece(ClientData, Tcl_Interp*) {
    return 0;
}

void watchPiece(ClientData, int) {}

Tcl_ChannelType makeChannelType() {
    Tcl_ChannelType type = {};
    type.typeName = "grsh";
    type.version = TCL_CHANNEL_VERSION_5;
    type.closeProc = closePiece;
    type.inputProc = readPiece;
    type.watchProc = watchPiece;
    return type;
}

const Tcl_ChannelType channelType = makeChannelType();

Tcl_Channel open(Tcl_Interp*, Tcl_Obj*, int, int) {
    static unsigned count = 0;
    state->read = 0;
    return Tcl_CreateChannel(&channelType, ("grsh" + std::to_string(count++)).c_str(), nullptr, TCL_READABLE);
}

Tcl_Filesystem makeFileSystem() {
    Tcl_Filesystem system = {};
    system.typeName = "grsh";
    system.structureLength = sizeof system;
    system.version = TCL_FILESYSTEM_VERSION_1;
    system.pathInFilesystemProc = claim;
    system.statProc = status;
    system.accessProc = access;
    system.openFileChannelProc = open;
    return system;
}

const Tcl_Filesystem fileSystem = makeFileSystem();

}  // namespace

PipedScript::PipedScript(const std::string& path, const std::string& typed) {
    state = new State{path, typed, {}, {}};
    Tcl_FSRegister(nullptr, &fileSystem);
}

PipedScript::~PipedScript() {
    Tcl_FSUnregister(&fileSystem);
    delete state;
    state = nullptr;
}

std::string PipedScript::add(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (state->text.empty() && text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    const std::string name = std::string(kPieces) + std::to_string(state->lines + 1);
    // The ensemble "info" may be the script's own by now.
    state->piece = "::tcl::info::script " + quoted(state->typed) + ";" + std::string(text);
    state->text += text;
    state->lines += static_cast<int>(std::ranges::count(text, '\n'));
    return name;
}

Place inWhole(Place place) {
    if (state == nullptr || !isPiece(place.path)) return place;
    int first = 1;
    std::from_chars(place.path.data() + kPieces.size(), place.path.data() + place.path.size(), first);
    return {state->path, first + place.line - 1};
}

std::string withoutPieces(std::string trace) {
    constexpr std::string_view kLine = "\" line ";
    for (std::size_t at = trace.find(kPieces); state != nullptr && at != trace.npos; at = trace.find(kPieces, at + 1)) {
        const std::size_t quote = trace.find(kLine, at);
        if (quote == trace.npos) break;
        Place place{trace.substr(at, quote - at), 0};
        const char* end = trace.data() + trace.size();
        const auto [after, error] = std::from_chars(trace.data() + quote + kLine.size(), end, place.line);
        if (error != std::errc()) continue;
        const std::string shown = state->typed + std::string(kLine) + std::to_string(inWhole(place).line);
        trace.replace(at, static_cast<std::size_t>(after - trace.data()) - at, shown);
    }
    return trace;
}

std::optional<std::string_view> pipedText(const std::string& path) {
    if (state == nullptr || path != state->path) return std::nullopt;
    return state->text;
}

}  // namespace grsh
