#include "grsh/script_input.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "grsh/tcl_value.h"

namespace grsh {

int readError(const std::string& path) {
    struct stat status;
    if (stat(path.c_str(), &status) != 0) return errno;
    if (S_ISDIR(status.st_mode)) return EISDIR;
    return access(path.c_str(), R_OK) != 0 ? errno : 0;
}

bool isRegularFile(const std::string& path) {
    struct stat status;
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

bool readAll(const std::string& path, const std::string& encoding, std::string& text) {
    const Tcl_Channel channel = Tcl_FSOpenFileChannel(nullptr, textValue(path).get(), "r", 0);
    if (!channel) return false;
    Tcl_SetChannelOption(nullptr, channel, "-encoding", encoding.c_str());
    const Value read = hold(Tcl_NewObj());
    const bool isRead = Tcl_ReadChars(channel, read.get(), -1, 0) >= 0;
    const int error = Tcl_GetErrno();
    Tcl_Close(nullptr, channel);
    text = stringOf(read.get());
    errno = error;
    return isRead;
}

bool readLine(CommandText& command) {
    const Tcl_Channel input = Tcl_GetStdChannel(TCL_STDIN);
    const Value line = hold(Tcl_NewObj());
    if (!input) return false;
    while (Tcl_GetsObj(input, line.get()) < 0) {
        if (!Tcl_InputBlocked(input)) return false;
        // A script may have made it non-blocking for itself.
        pollfd keyboard = {STDIN_FILENO, POLLIN, 0};
        poll(&keyboard, 1, -1);
    }
    command.addLine(stringOf(line.get()) + "\n");
    return true;
}

}  // namespace grsh
