#include "core/reader_process.h"

#include "core/error.h"
#include "core/memory.h"
#include "core/reader_child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace core {
namespace {

[[noreturn]] void fail(const std::string& reason) {
    throw Error("FILE", "READ", "", reason);
}

// The program's environment. Readers make millions of small things, for which large pages are quicker.
std::vector<const char*> environment() {
    std::vector<const char*> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
    if (std::getenv("GLIBC_TUNABLES") == nullptr) variables.push_back("GLIBC_TUNABLES=glibc.malloc.hugetlb=1");
    variables.push_back(nullptr);
    return variables;
}

// The input goes by way of a number that the channel is not at, nor goes to.
void addDescriptors(posix_spawn_file_actions_t& actions, int toChild, int input) {
    const int aside = std::max({toChild, input, reader::input}) + 1;
    if (input >= 0) posix_spawn_file_actions_adddup2(&actions, input, aside);
    posix_spawn_file_actions_adddup2(&actions, toChild, reader::channel);
    if (input >= 0) {
        posix_spawn_file_actions_adddup2(&actions, aside, reader::input);
        posix_spawn_file_actions_addclose(&actions, aside);
    }
    for (const int number : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, number, "/dev/null", O_WRONLY, 0);
}

}  // namespace

ReaderProcess::ReaderProcess(const ReaderWork& work) : name_(work.name) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail(std::strerror(errno));
    channel_ = Descriptor(ends[0]);
    const Descriptor toChild(ends[1]);
    fcntl(ends[0], F_SETPIPE_SZ, 1 << 20);
    start(work, ends[1]);
}

ReaderProcess::~ReaderProcess() {
    if (process_ > 0) kill(process_, SIGKILL);
    end();
}

void ReaderProcess::start(const ReaderWork& work, int toChild) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / work.program;
    const double megabytes = std::min(work.megabytes, static_cast<double>(availableMemory()) / 1e6);
    std::vector<std::string> texts{program, std::to_string(std::llround(megabytes)),
                                   std::to_string(std::llround(work.seconds))};
    texts.insert(texts.end(), work.words.begin(), work.words.end());
    std::vector<char*> words;
    for (std::string& text : texts) words.push_back(text.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    addDescriptors(actions, toChild, work.input);
    const int error = posix_spawn(&process_, program.c_str(), &actions, nullptr, words.data(),
                                  const_cast<char* const*>(environment().data()));
    posix_spawn_file_actions_destroy(&actions);
    if (error == 0) return;
    process_ = 0;
    fail("the program \"" + program + "\" cannot be started: " + std::strerror(error));
}

void ReaderProcess::readOutcome() {
    std::uint32_t length = 0;
    read(&length, sizeof length);
    if (length == 0) return;
    std::string reason(length, ' ');
    read(reason.data(), reason.size());
    fail(reason);
}

void ReaderProcess::read(void* to, std::size_t bytes) {
    for (std::size_t done = 0; done < bytes;) {
        const ssize_t count = ::read(channel_.number(), static_cast<char*>(to) + done, bytes - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) failed();
        done += static_cast<std::size_t>(count);
    }
}

// Waits for the program's end and returns how it ended.
int ReaderProcess::end() {
    int status = 0;
    while (process_ > 0 && waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return status;
}

void ReaderProcess::failed() {
    const int status = end();
    const int cause = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (cause == SIGINT) fail("interrupted");
    if (cause == SIGXCPU) fail("reading takes longer than a file of its size should");
    fail("the " + name_ + " crashed on it");
}

}  // namespace core
