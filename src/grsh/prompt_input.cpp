#include "grsh/prompt_input.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "grsh/interrupt.h"

namespace grsh {
namespace {

// A channel on top of Tcl's own, which waits in its place and passes everything else on.
struct Input {
    Tcl_Interp* interp;
    Tcl_Channel top = nullptr;
    bool blocks = true;

    Tcl_Channel below() const { return Tcl_GetStackedChannel(top); }
    const Tcl_ChannelType* type() const { return Tcl_GetChannelType(below()); }
    ClientData data() const { return Tcl_GetChannelInstanceData(below()); }
};

Input& inputOf(ClientData data) {
    return *static_cast<Input*>(data);
}

int read(ClientData data, char* buffer, int size, int* error) {
    constexpr int kMilliseconds = 250;  // a signal may come just before poll() begins
    pollfd keyboard = {STDIN_FILENO, POLLIN, 0};
    const InterruptScope scope(inputOf(data).interp);
    while (inputOf(data).blocks && poll(&keyboard, 1, kMilliseconds) <= 0) {
        if (!interrupted()) continue;
        *error = EINTR;
        return -1;
    }
    const int count = Tcl_ReadRaw(inputOf(data).below(), buffer, size);
    if (count < 0) *error = Tcl_GetErrno();
    return count;
}

int setBlocking(ClientData data, int mode) {
    inputOf(data).blocks = mode == TCL_MODE_BLOCKING;
    return 0;
}

int close(ClientData data, Tcl_Interp*) {
    delete &inputOf(data);
    return 0;
}

int setOption(ClientData data, Tcl_Interp* interp, const char* name, const char* value) {
    const auto set = Tcl_ChannelSetOptionProc(inputOf(data).type());
    return set ? set(inputOf(data).data(), interp, name, value) : Tcl_BadChannelOption(interp, name, "");
}

int getOption(ClientData data, Tcl_Interp* interp, const char* name, Tcl_DString* value) {
    const auto get = Tcl_ChannelGetOptionProc(inputOf(data).type());
    if (get) return get(inputOf(data).data(), interp, name, value);
    return name ? Tcl_BadChannelOption(interp, name, "") : TCL_OK;
}

void watch(ClientData data, int mask) {
    Tcl_ChannelWatchProc(inputOf(data).type())(inputOf(data).data(), mask);
}

int getHandle(ClientData data, int direction, ClientData* handle) {
    return Tcl_GetChannelHandle(inputOf(data).below(), direction, handle);
}

int passEvent(ClientData, int mask) {
    return mask;
}

Tcl_ChannelType makeType() {
    Tcl_ChannelType type = {};
    type.typeName = "prompt";
    type.version = TCL_CHANNEL_VERSION_5;
    type.closeProc = close;
    type.inputProc = read;
    type.setOptionProc = setOption;
    type.getOptionProc = getOption;
    type.watchProc = watch;
    type.getHandleProc = getHandle;
    type.blockModeProc = setBlocking;
    type.handlerProc = passEvent;
    return type;
}

const Tcl_ChannelType type = makeType();

}  // namespace

void makeInterruptible(Tcl_Interp* interp) {
    const Tcl_Channel input = Tcl_GetStdChannel(TCL_STDIN);
    if (!input) return;
    auto* state = new Input{interp};
    state->top = Tcl_StackChannel(interp, &type, state, TCL_READABLE, input);
    if (!state->top) delete state;
}

}  // namespace grsh
