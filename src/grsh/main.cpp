// grsh's command line.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "core/error.h"
#include "grsh/command_line.h"
#include "grsh/last_resort.h"
#include "grsh/shell.h"
#include "grsh/stack_guard.h"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int wrongUsage(const std::string& message) {
    std::fprintf(stderr, "grsh: %s\n%s; grsh --help shows more\n", message.c_str(), grsh::usageLine().c_str());
    return kWrongUsage;
}

int run(const std::string& program, const grsh::CommandLine& line) {
    using Asks = grsh::CommandLine::Asks;
    if (line.asks == Asks::help) std::fputs(grsh::helpText().c_str(), stdout);
    if (line.asks == Asks::version) std::fputs("grsh " GRSH_VERSION "\n", stdout);
    if (line.asks != Asks::run) return 0;
    if (line.isSafe || line.limits.bytes) grsh::guardStack();
    if (line.limits.bytes) grsh::limitMemory(*line.limits.bytes);
    return grsh::Shell(program, line).run();
}

}  // namespace

int main(int argc, char** argv) {
    grsh::installLastResort();
    try {
        return run(argv[0], grsh::readCommandLine({argv + 1, argv + argc}));
    } catch (const core::Error& error) {
        if (error.topic == "USAGE") return wrongUsage(error.what());
        std::fprintf(stderr, "grsh: %s\n", error.what());
    } catch (const std::bad_alloc&) {
        grsh::releaseReserve();
        std::fputs("grsh: out of memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "grsh: %s\n", error.what());
    }
    return kFailed;
}
