#include "grsh/last_resort.h"

#include <tcl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

namespace grsh {
namespace {

constexpr std::size_t kReserveBytes = std::size_t{2} << 20;
void* reserve = nullptr;

// Tcl's own words for it: "unable to alloc 123 bytes" and the like.
bool isOutOfMemory(const char* message) {
    return std::strstr(message, "alloc") != nullptr;
}

[[noreturn]] void panic(const char* format, ...) {
    char message[250];
    std::va_list words;
    va_start(words, format);
    std::vsnprintf(message, sizeof message, format, words);
    va_end(words);
    giveUp(isOutOfMemory(message) ? "out of memory" : message);
}

[[noreturn]] void terminate() {
    releaseReserve();
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
        giveUp("out of memory");
    } catch (const std::exception& error) {
        giveUp(error.what());
    } catch (...) {
    }
    giveUp("ended by an error of its own");
}

}  // namespace

void giveUp(const char* message) {
    constexpr std::string_view program = "grsh: ";
    char line[300];
    const std::size_t length = std::min(std::strlen(message), sizeof line - program.size() - 1);
    std::memcpy(line, program.data(), program.size());
    std::memcpy(line + program.size(), message, length);
    line[program.size() + length] = '\n';
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line, program.size() + length + 1);
    _exit(1);
}

void installLastResort() {
    Tcl_SetPanicProc(panic);
    std::set_terminate(terminate);
    takeReserve();
}

void takeReserve() noexcept {
    if (reserve == nullptr) reserve = std::malloc(kReserveBytes);
}

void releaseReserve() noexcept {
    std::free(reserve);
    reserve = nullptr;
}

}  // namespace grsh
