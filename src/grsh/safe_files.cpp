#include "grsh/safe_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "grsh/place.h"
#include "grsh/tcl_value.h"

namespace grsh {
namespace {

FileAccess* access = nullptr;

std::string nameOf(Tcl_Obj* path) {
    const char* text = Tcl_FSGetTranslatedStringPath(nullptr, path);
    if (text == nullptr) return "";
    Tcl_DString native;
    Tcl_UtfToExternalDString(nullptr, text, -1, &native);
    std::string name(Tcl_DStringValue(&native), static_cast<std::size_t>(Tcl_DStringLength(&native)));
    Tcl_DStringFree(&native);
    Tcl_Free(const_cast<char*>(text));
    return name;
}

// No exception goes on through Tcl.
core::Descriptor openFor(Tcl_Obj* path, int flags) {
    try {
        const std::string name = nameOf(path);
        if (!name.empty()) return access->openForTcl(name, flags);
    } catch (const std::exception&) {
    }
    errno = EACCES;
    return core::Descriptor();
}

// To Tcl what may not be read is not there: it looks for its own files in many places.
int failed() {
    if (errno == EXDEV) errno = ENOENT;
    return -1;
}

int statFile(Tcl_Obj* path, Tcl_StatBuf* status) {
    const core::Descriptor file = openFor(path, O_PATH);
    return file.isOpen() && fstat(file.number(), status) == 0 ? 0 : failed();
}

int accessFile(Tcl_Obj* path, int mode) {
    const core::Descriptor file = openFor(path, O_PATH);
    if (!file.isOpen()) return failed();
    if ((mode & W_OK) == 0) return ::access(file.path().c_str(), mode);
    errno = EACCES;
    return -1;
}

Tcl_Channel openFile(Tcl_Interp* interp, Tcl_Obj* path, int mode, int) {
    int error = EACCES;
    if ((mode & O_ACCMODE) == O_RDONLY && (mode & (O_CREAT | O_TRUNC)) == 0) {
        const core::Descriptor file = openFor(path, O_RDONLY);
        // The channel closes its own.
        const int own = file.isOpen() ? fcntl(file.number(), F_DUPFD_CLOEXEC, 0) : failed();
        if (own >= 0)
            return Tcl_MakeFileChannel(reinterpret_cast<ClientData>(static_cast<std::intptr_t>(own)), TCL_READABLE);
        error = errno;
    }
    if (interp == nullptr) return nullptr;
    Tcl_SetErrno(error);
    Tcl_SetObjResult(interp, Tcl_ObjPrintf("couldn't open \"%s\": %s", Tcl_GetString(path), Tcl_PosixError(interp)));
    return nullptr;
}

int isOurs(Tcl_Obj*, ClientData*) {
    return TCL_OK;
}

// What has no function here, like deleting, fails.
Tcl_Filesystem makeFilesystem() {
    Tcl_Filesystem system = {};
    system.typeName = "grsh-safe";
    system.structureLength = sizeof system;
    system.version = TCL_FILESYSTEM_VERSION_1;
    system.pathInFilesystemProc = isOurs;
    system.statProc = statFile;
    system.lstatProc = statFile;
    system.accessProc = accessFile;
    system.openFileChannelProc = openFile;
    return system;
}

}  // namespace

void confineTcl(FileAccess& files, Tcl_Interp* interp) {
    static const Tcl_Filesystem system = makeFilesystem();
    // Its packages lie beside its library; its clock reads time zones.
    if (const char* library = Tcl_GetVar(interp, "tcl_library", TCL_GLOBAL_ONLY)) {
        const std::string path = plainPath(normalized(library));
        files.letTclRead(path);
        files.letTclRead(path.substr(0, path.rfind('/')) + "/tcl8");
    }
    files.letTclRead("/usr/share/zoneinfo");
    access = &files;
    Tcl_FSRegister(nullptr, &system);
}

}  // namespace grsh
