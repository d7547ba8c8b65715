// Files below a folder, opened so that no name and no link leads out of it, whoever changes them meanwhile.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace core {

// A file descriptor that is closed at the end.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    int number() const { return number_; }
    bool isOpen() const { return number_ >= 0; }
    void close();
    // A name of what is open, for whoever opens by name: it stays what it is when its own name goes to another file.
    std::string path() const { return "/proc/self/fd/" + std::to_string(number_); }

private:
    int number_;
};

// A folder that is open, and its path.
struct Folder {
    Descriptor descriptor;
    std::string path;  // absolute, without links
};

// The path from the folder, where that is how the absolute path begins: "." for the folder itself.
std::optional<std::string> pathBelow(std::string_view folder, std::string_view path);

// As open(2), with a path from the folder. What leads out of it, an absolute link among them, fails with EXDEV.
Descriptor openBelow(int folder, const std::string& path, int flags);

// The same where Linux is older than 5.6, and what openBelow then does: any link fails, and "..".
Descriptor openBelowByWalking(int folder, const std::string& path, int flags);

// A regular file, for reading; waits for nothing. What is something else fails with EISDIR or EINVAL.
Descriptor openFileBelow(int folder, const std::string& path);

}  // namespace core
