#include "grsh/shell.h"

#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <new>
#include <stdexcept>

#include "grsh/command_text.h"
#include "grsh/commands.h"
#include "grsh/error_place.h"
#include "grsh/interrupt.h"
#include "grsh/main_loop.h"
#include "grsh/piped_script.h"
#include "grsh/place.h"
#include "grsh/prompt.h"
#include "grsh/safe_files.h"
#include "grsh/safe_interp.h"
#include "grsh/script_input.h"
#include "grsh/tcl_value.h"
#include "grsh/time_limit.h"
#include "image/image_file.h"

namespace grsh {
namespace {

constexpr int kFailed = 1;

void setArguments(Tcl_Interp* interp, const std::string& argv0, const std::vector<std::string>& words,
                  bool isInteractive) {
    const Value argv = hold(Tcl_NewListObj(0, nullptr));
    for (const std::string& word : words) Tcl_ListObjAppendElement(nullptr, argv.get(), argumentValue(word).get());
    const auto set = [&](const char* name, Tcl_Obj* value) {
        Tcl_SetVar2Ex(interp, name, nullptr, value, TCL_GLOBAL_ONLY);
    };
    set("argv0", argumentValue(argv0).get());
    set("argv", argv.get());
    set("argc", hold(Tcl_NewIntObj(static_cast<int>(words.size()))).get());
    set("tcl_interactive", hold(Tcl_NewIntObj(isInteractive)).get());
}

int cannotRead(const std::string& what, int error) {
    std::string reason = std::strerror(error);
    reason[0] = static_cast<char>(std::tolower(reason[0]));
    print(TCL_STDERR, "grsh: cannot read " + what + ": " + reason + "\n");
    return kFailed;
}

// The script's folder and the current one, and those that the line adds.
FileAccess filesOf(const CommandLine& line) {
    if (!line.isSafe) return {};
    const bool isFile = line.script && !line.isStandardInput && !line.text;
    const std::size_t slash = isFile ? line.script->rfind('/') : std::string::npos;
    std::vector<std::string> reads = {slash == std::string::npos ? "." : line.script->substr(0, slash + 1)};
    std::vector<std::string> writes = {"."};
    reads.insert(reads.end(), line.readFolders.begin(), line.readFolders.end());
    writes.insert(writes.end(), line.writeFolders.begin(), line.writeFolders.end());
    return FileAccess(reads, writes);
}

}  // namespace

void print(int standardChannel, const std::string& text) {
    // What a script has printed before comes before an error.
    if (standardChannel == TCL_STDERR) print(TCL_STDOUT, "");
    const Tcl_Channel channel = Tcl_GetStdChannel(standardChannel);
    if (!channel) return;
    Tcl_WriteChars(channel, text.data(), static_cast<int>(text.size()));
    Tcl_Flush(channel);
}

namespace {

// Empty where there is not even memory to look for it.
std::string placeOfError(Tcl_Interp* interp) {
    try {
        return errorPlace(interp);
    } catch (const std::bad_alloc&) {
        return "";
    }
}

}  // namespace

int sayInterrupted() {
    print(TCL_STDERR, ending().message);
    return ending().code;
}

Shell::Shell(const std::string& program, const CommandLine& line) : program(program), line(line), files(filesOf(line)) {
    Tcl_FindExecutable(program.c_str());
    // Scripts are UTF-8 whatever the locale is.
    Tcl_SetSystemEncoding(nullptr, "utf-8");
    parent = Tcl_CreateInterp();
    if (Tcl_Init(parent) != TCL_OK) {
        const std::string reason = stringOf(Tcl_GetObjResult(parent));
        Tcl_DeleteInterp(parent);
        throw std::runtime_error(reason);
    }
    if (const Tcl_Encoding found = Tcl_GetEncoding(nullptr, line.encoding.c_str()))
        Tcl_FreeEncoding(found);
    else
        throw core::Error("USAGE", "ENCODING", line.encoding, "unknown encoding \"" + line.encoding + "\"");
    overrides = Overrides(line.sets);
    interp = line.isSafe ? makeSafeInterp(parent) : parent;
    if (line.isSafe) confineTcl(files, parent);
    registerCommands(interp, files, overrides, line.limits, line.resumes);
}

Shell::~Shell() {
    overrides = {};
    Tcl_DeleteInterp(parent);
    // Writes out what scripts have printed.
    Tcl_Finalize();
}

int Shell::run() {
    if (line.text) return runText(*line.text, line.words);
    if (line.isStandardInput) return runStandardInput(*line.script, line.words);
    if (line.script) return runScript(*line.script, line.words);
    return isatty(STDIN_FILENO) ? runPrompt(program) : runStandardInput(program, {});
}

int Shell::runScript(const std::string& script, const std::vector<std::string>& words) {
    const InterruptHandler handler(interp, InterruptHandler::Runs::script);
    const TimeLimit limit(line.limits.seconds);
    if (const int error = readError(script)) return cannotRead("\"" + script + "\"", error);
    files.toRead(script);
    setArguments(interp, script, words, false);
    UnreadWords unread(interp, script, inShell(script), words);
    const std::string path = stringOf(argumentValue(script).get());
    setMainScript(interp, path, path);
    if (isRegularFile(script))
        return finish(Tcl_FSEvalFileEx(interp, argumentValue(script).get(), line.encoding.c_str()), unread);
    std::string text;
    if (!readAll(path, line.encoding, text)) return cannotRead("\"" + script + "\"", errno);
    PipedScript piped(normalized(path), path);
    return finish(evaluate(piped, text), unread);
}

int Shell::runText(const std::string& text, const std::vector<std::string>& words) {
    const InterruptHandler handler(interp, InterruptHandler::Runs::script);
    const TimeLimit limit(line.limits.seconds);
    setArguments(interp, "-e", words, false);
    UnreadWords unread(interp, "-e", "-e ...", words);
    setMainScript(interp, "-e", commandLinePath);
    PipedScript piped(commandLinePath, "-e");
    return finish(evaluate(piped, stringOf(argumentValue(text).get())), unread);
}

int Shell::runStandardInput(const std::string& argv0, const std::vector<std::string>& words) {
    const InterruptHandler handler(interp, InterruptHandler::Runs::script);
    const TimeLimit limit(line.limits.seconds);
    setArguments(interp, argv0, words, false);
    UnreadWords unread(interp, "-", "-", words);
    setMainScript(interp, "-", standardInputPath);
    if (const Tcl_Channel input = Tcl_GetStdChannel(TCL_STDIN))
        Tcl_SetChannelOption(nullptr, input, "-encoding", line.encoding.c_str());
    PipedScript piped(standardInputPath, "-");
    CommandText command;
    int code = TCL_OK;
    bool isMore = true;
    while (code == TCL_OK && isMore && !interrupted()) {
        isMore = readLine(command);
        // What is still open at the end is an error, which Tcl tells.
        if (isMore ? !command.isComplete() : command.text().empty()) continue;
        code = evaluate(piped, command.text());
        command.clear();
    }
    return finish(code, unread);
}

int Shell::runPrompt(const std::string& argv0) {
    const InterruptHandler handler(interp, InterruptHandler::Runs::prompt);
    const TimeLimit limit(line.limits.seconds);
    setArguments(interp, argv0, {}, true);
    return grsh::runPrompt(interp);
}

int Shell::evaluate(PipedScript& script, const std::string& text) {
    return Tcl_FSEvalFileEx(interp, textValue(script.add(text)).get(), "utf-8");
}

int Shell::finish(int code, UnreadWords& unread) {
    if (interrupted() || code != TCL_OK) unread.drop();
    if (interrupted()) return sayInterrupted();
    if (code != TCL_OK) return fail();
    unread.tell();
    if (overrides.areUnused()) print(TCL_STDERR, "grsh: warning: --set has no effect: the script renders nothing\n");
    runMainLoop(interp);
    return 0;
}

int Shell::fail() {
    const std::string message = stringOf(Tcl_GetObjResult(interp));
    const Value options = hold(Tcl_GetReturnOptions(interp, TCL_ERROR));
    std::string where = placeOfError(interp);
    // A script may return an error with a trace of its own making.
    if (where.empty()) where = mainScript(interp)->typed + ":" + std::to_string(Tcl_GetErrorLine(interp));
    print(TCL_STDERR, where + ": " + message + "\n");
    Tcl_Obj* trace = nullptr;
    if (line.traces) Tcl_DictObjGet(nullptr, options.get(), textValue("-errorinfo").get(), &trace);
    if (trace) print(TCL_STDERR, withoutPieces(stringOf(trace)) + "\n");
    return kFailed;
}

}  // namespace grsh
