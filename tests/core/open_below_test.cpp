#include "core/open_below.h"

#include "support/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace core {
namespace {

namespace fs = std::filesystem;

// inside/a/file and outside/file; links lead from inside to both.
class OpenBelow : public testing::Test {
protected:
    OpenBelow() {
        fs::create_directories(folder / "inside/a");
        fs::create_directories(folder / "outside");
        std::ofstream(folder / "inside/a/file") << "inside";
        std::ofstream(folder / "outside/file") << "outside";
        fs::create_symlink("a", folder / "inside/near");
        fs::create_symlink("../outside", folder / "inside/far");
        fs::create_symlink(folder / "inside/a/file", folder / "inside/absolute");
        fs::create_symlink("../../outside/file", folder / "inside/a/far");
        mkfifo((folder / "inside/pipe").c_str(), 0600);
        inside = Descriptor(open((folder / "inside").c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    }

    // What is in the file, or why it cannot be opened.
    static std::string read(const Descriptor& file) {
        if (!file.isOpen()) return std::strerror(errno);
        char text[100];
        const ssize_t count = ::read(file.number(), text, sizeof text);
        return count < 0 ? std::strerror(errno) : std::string(text, static_cast<std::size_t>(count));
    }
    std::string openFile(const std::string& path) { return read(openFileBelow(inside.number(), path)); }
    std::string walk(const std::string& path) { return read(openBelowByWalking(inside.number(), path, O_RDONLY)); }

    support::TemporaryFolder folder;
    Descriptor inside;
    const std::string leadsOut = std::strerror(EXDEV);
};

TEST_F(OpenBelow, FindsWhatIsThere) {
    for (const char* path : {"a/file", "./a//file", "a/./file"}) {
        EXPECT_EQ(openFile(path), "inside") << path;
        EXPECT_EQ(walk(path), "inside") << path;
    }
    EXPECT_EQ(openFile("nosuch"), std::strerror(ENOENT));
    EXPECT_EQ(walk("nosuch/file"), std::strerror(ENOENT));
    EXPECT_EQ(walk("a/file/x"), std::strerror(ENOTDIR));
}

TEST_F(OpenBelow, NeverLeadsOut) {
    for (const std::string path :
         {"../outside/file", "far/file", "a/far", "absolute", "a/../../outside/file", "/etc/passwd"}) {
        EXPECT_EQ(openFile(path), leadsOut) << path;
        EXPECT_EQ(walk(path), leadsOut) << path;
    }
}

TEST_F(OpenBelow, OpensRegularFilesOnlyAndWaitsForNothing) {
    EXPECT_EQ(openFile("pipe"), std::strerror(EINVAL));
    EXPECT_EQ(openFile("a"), std::strerror(EISDIR));
    EXPECT_EQ(openFile("."), std::strerror(EISDIR));
}

TEST_F(OpenBelow, TakesNoNul) {
    EXPECT_EQ(openFile(std::string("a/file\0x", 8)), std::strerror(EINVAL));
    EXPECT_EQ(walk(std::string("a/file\0x", 8)), leadsOut);
}

TEST_F(OpenBelow, KeepsWhatItHasOpened) {
    const Descriptor file = openFileBelow(inside.number(), "a/file");
    fs::remove(folder / "inside/a/file");
    fs::create_symlink("../../outside/file", folder / "inside/a/file");
    EXPECT_EQ(read(Descriptor(open(file.path().c_str(), O_RDONLY | O_CLOEXEC))), "inside");
}

TEST(PathBelow, IsWhatFollowsTheFolder) {
    EXPECT_EQ(pathBelow("/a/b", "/a/b/c/d"), "c/d");
    EXPECT_EQ(pathBelow("/a/b", "/a/b"), ".");
    EXPECT_EQ(pathBelow("/", "/a"), "a");
    EXPECT_EQ(pathBelow("/a/b", "/a/bc"), std::nullopt);
    EXPECT_EQ(pathBelow("/a/b", "/a"), std::nullopt);
}

}  // namespace
}  // namespace core
