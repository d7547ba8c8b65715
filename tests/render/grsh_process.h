// The program itself, as somebody runs it.
#pragma once

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace render {

// Runs grsh in a folder, beside whatever else runs.
class GrshProcess {
public:
    GrshProcess(const std::string& folder, std::vector<std::string> words) {
        words.insert(words.begin(), GRSH_PROGRAM);
        std::vector<char*> argv(words.size() + 1);  // the last stays null
        std::transform(words.begin(), words.end(), argv.begin(), [](std::string& word) { return word.data(); });
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
        const int error = posix_spawn(&process_, GRSH_PROGRAM, &actions, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0) throw std::runtime_error("cannot run " GRSH_PROGRAM);
    }
    ~GrshProcess() {
        if (process_ != 0) exitCode();
    }
    GrshProcess(const GrshProcess&) = delete;
    GrshProcess& operator=(const GrshProcess&) = delete;

    // Waits for its end. -1 where a signal ended it.
    int exitCode() {
        int status = 0;
        waitpid(process_, &status, 0);
        process_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t process_ = 0;
};

}  // namespace render
