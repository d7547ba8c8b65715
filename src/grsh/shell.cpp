#include "grsh/shell.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "grsh/commands.h"
#include "grsh/error_place.h"
#include "grsh/interrupt.h"
#include "grsh/prompt.h"
#include "grsh/safe_files.h"
#include "grsh/safe_interp.h"
#include "grsh/tcl_value.h"
#include "grsh/time_limit.h"
#include "image/image_file.h"

namespace grsh {
namespace {

constexpr int kFailed = 1;

// The command line's bytes as Tcl has them.
Value argumentValue(const std::string& argument) {
    Tcl_DString text;
    Tcl_ExternalToUtfDString(nullptr, argument.data(), static_cast<int>(argument.size()), &text);
    Value value = textValue({Tcl_DStringValue(&text), static_cast<std::size_t>(Tcl_DStringLength(&text))});
    Tcl_DStringFree(&text);
    return value;
}

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

int sayInterrupted() {
    print(TCL_STDERR, ending().message);
    return ending().code;
}

// The script's folder and the current one, and those that the line adds.
FileAccess filesOf(const CommandLine& line) {
    if (!line.isSafe) return {};
    const bool isFile = line.script && !line.isStandardInput;
    const std::size_t slash = isFile ? line.script->rfind('/') : std::string::npos;
    std::vector<std::string> reads = {slash == std::string::npos ? "." : line.script->substr(0, slash + 1)};
    std::vector<std::string> writes = {"."};
    reads.insert(reads.end(), line.readFolders.begin(), line.readFolders.end());
    writes.insert(writes.end(), line.writeFolders.begin(), line.writeFolders.end());
    return FileAccess(reads, writes);
}

// 0, or why the file cannot be read. It is not opened: a pipe can be read only once.
int readError(const std::string& path) {
    struct stat status;
    if (stat(path.c_str(), &status) != 0) return errno;
    if (S_ISDIR(status.st_mode)) return EISDIR;
    return access(path.c_str(), R_OK) != 0 ? errno : 0;
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// False where standard input cannot be read, errno telling why.
bool readStandardInput(std::string& text) {
    char buffer[65536];
    while (true) {
        const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
        if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
        if (count == 0) return true;
        if (count < 0 && (errno != EINTR || interrupted())) return false;
    }
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
    interp = line.isSafe ? makeSafeInterp(parent) : parent;
    if (line.isSafe) confineTcl(files, parent);
    registerCommands(interp, files, line.limits, line.resumes);
}

Shell::~Shell() {
    Tcl_DeleteInterp(parent);
    // Writes out what scripts have printed.
    Tcl_Finalize();
}

int Shell::run() {
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
    return runFile(script, script);
}

int Shell::runStandardInput(const std::string& argv0, const std::vector<std::string>& words) {
    const InterruptHandler handler(interp, InterruptHandler::Runs::script);
    const TimeLimit limit(line.limits.seconds);
    std::string text;
    const bool isRead = readStandardInput(text);
    if (interrupted()) return sayInterrupted();
    if (!isRead) return cannotRead("standard input", errno);
    // Tcl knows the lines of files only, so the text becomes one, whose name scripts are not to see.
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    text.insert(0, "info script -;");
    const File file(std::tmpfile());
    if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() || std::fflush(file.get()) != 0)
        return cannotRead("standard input", errno);
    fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC);
    setArguments(interp, argv0, words, false);
    const std::string path = "/dev/fd/" + std::to_string(fileno(file.get()));
    files.letTclRead(path);
    return runFile("-", path);
}

int Shell::runPrompt(const std::string& argv0) {
    const InterruptHandler handler(interp, InterruptHandler::Runs::prompt);
    const TimeLimit limit(line.limits.seconds);
    setArguments(interp, argv0, {}, true);
    return grsh::runPrompt(interp);
}

int Shell::runFile(const std::string& typed, const std::string& path) {
    setMainScript(interp, typed, path);
    const int code = Tcl_FSEvalFileEx(interp, argumentValue(path).get(), "utf-8");
    if (interrupted()) return sayInterrupted();
    if (code == TCL_OK) return 0;
    const std::string message = stringOf(Tcl_GetObjResult(interp));
    std::string where = errorPlace(interp);
    // A script may return an error with a trace of its own making.
    if (where.empty()) where = typed + ":" + std::to_string(Tcl_GetErrorLine(interp));
    print(TCL_STDERR, where + ": " + message + "\n");
    return kFailed;
}

}  // namespace grsh
