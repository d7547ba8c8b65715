#include "gr/mesh/mesh_import.h"

#include "core/error.h"
#include "core/memory.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace gr {
namespace {

[[noreturn]] void fail(const std::string& reason) {
    throw core::Error("MESH", "FILE", "", reason);
}

// Beside this program.
std::string importer() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "grsh_import";
}

// The importer's environment. It makes millions of small things, for which large pages are quicker.
std::vector<const char*> environment() {
    std::vector<const char*> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
    if (std::getenv("GLIBC_TUNABLES") == nullptr) variables.push_back("GLIBC_TUNABLES=glibc.malloc.hugetlb=1");
    variables.push_back(nullptr);
    return variables;
}

// The importer at work on a file.
class Import {
public:
    Import(const std::string& path, const core::Folder* below) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) fail(std::strerror(errno));
        channel_ = core::Descriptor(ends[0]);
        const core::Descriptor toChild(ends[1]);
        fcntl(ends[0], F_SETPIPE_SZ, 1 << 20);
        start(path, ends[1], below);
    }
    ~Import() {
        if (process_ > 0) kill(process_, SIGKILL);
        end();
    }

    template<class T>
    void read(std::vector<T>& values, std::size_t count) {
        values.resize(count);
        read(values.data(), count * sizeof(T));
    }
    void read(void* to, std::size_t bytes) {
        for (std::size_t done = 0; done < bytes;) {
            const ssize_t count = ::read(channel_.number(), static_cast<char*>(to) + done, bytes - done);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) failed();
            done += static_cast<std::size_t>(count);
        }
    }

private:
    void start(const std::string& path, int toChild, const core::Folder* below) {
        const std::string program = importer();
        // What importers need grows with the file: 20 times its size is common, and 10 MB a second.
        const double megabytes = std::ceil(static_cast<double>(std::filesystem::file_size(path)) / 1e6);
        const double most = std::min(1000 + 100 * megabytes, static_cast<double>(core::availableMemory()) / 1e6);
        const std::string memory = std::to_string(std::llround(most)),
                          seconds = std::to_string(std::llround(10 + megabytes));
        const char* const words[] = {program.c_str(),
                                     path.c_str(),
                                     memory.c_str(),
                                     seconds.c_str(),
                                     below != nullptr ? below->path.c_str() : nullptr,
                                     nullptr};
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        addDescriptors(actions, toChild, below);
        for (const int number : {STDOUT_FILENO, STDERR_FILENO})
            posix_spawn_file_actions_addopen(&actions, number, "/dev/null", O_WRONLY, 0);
        const int error = posix_spawn(&process_, program.c_str(), &actions, nullptr, const_cast<char* const*>(words),
                                      const_cast<char* const*>(environment().data()));
        posix_spawn_file_actions_destroy(&actions);
        if (error == 0) return;
        process_ = 0;
        fail("the program \"" + program + "\" cannot be started: " + std::strerror(error));
    }

    // The folder goes by way of a number that the channel is not at, nor goes to.
    static void addDescriptors(posix_spawn_file_actions_t& actions, int toChild, const core::Folder* below) {
        const int folder = below != nullptr ? below->descriptor.number() : -1;
        const int aside = std::max({toChild, folder, importFolder}) + 1;
        if (below != nullptr) posix_spawn_file_actions_adddup2(&actions, folder, aside);
        posix_spawn_file_actions_adddup2(&actions, toChild, importChannel);
        if (below == nullptr) return;
        posix_spawn_file_actions_adddup2(&actions, aside, importFolder);
        posix_spawn_file_actions_addclose(&actions, aside);
    }

    // Waits for the importer's end and returns how it ended.
    int end() {
        int status = 0;
        while (process_ > 0 && waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        return status;
    }

    [[noreturn]] void failed() {
        const int status = end();
        const int cause = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        if (cause == SIGINT) fail("interrupted");
        if (cause == SIGXCPU) fail("reading takes longer than a file of its size should");
        fail("the importer crashed on it");
    }

    core::Descriptor channel_;
    pid_t process_ = 0;
};

}  // namespace

FlatMesh importMesh(const std::string& path, MeshRepairs& repairs, const core::Folder* below) {
    Import import(path, below);
    ImportHeader header;
    import.read(&header, sizeof header);
    if (header.errorLength > 0) {
        std::string reason(header.errorLength, ' ');
        import.read(reason.data(), reason.size());
        fail(reason);
    }
    repairs.linesAndPoints += static_cast<int>(header.linesAndPoints);
    FlatMesh mesh;
    std::vector<core::Vec3f> vertices;
    import.read(vertices, header.vertices);
    mesh.vertices.assign(vertices.begin(), vertices.end());
    import.read(mesh.corners, header.corners);
    import.read(mesh.ends, header.ends);
    import.read(mesh.normals, header.normals);
    return mesh;
}

}  // namespace gr
