#include "grsh/last_resort.h"

#include <tcl.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

namespace grsh {
namespace {

constexpr std::size_t kReserveBytes = std::size_t{2} << 20;
void* reserve = nullptr;

// Allocates nothing.
[[noreturn]] void end(const char* message) {
    char line[300];
    const int length = std::snprintf(line, sizeof line - 1, "grsh: %s\n", message);
    if (length > 0) {
        const auto size = std::strlen(line);
        if (line[size - 1] != '\n') line[size - 1] = '\n';
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line, size);
    }
    _exit(1);
}

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
    end(isOutOfMemory(message) ? "out of memory" : message);
}

[[noreturn]] void terminate() {
    releaseReserve();
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
        end("out of memory");
    } catch (const std::exception& error) {
        end(error.what());
    } catch (...) {
    }
    end("ended by an error of its own");
}

}  // namespace

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
