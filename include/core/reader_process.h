// Files from anywhere may make a large library crash, hang or ask for all memory. Where one reads them it is linked to
// a program of its own, which stands beside this one and reads one file at a time: only that program suffers then, and
// grsh starts without the library. What such a program does on its side is in core/reader_child.h.
#pragma once

#include "core/open_below.h"

#include <sys/types.h>

#include <string>
#include <vector>

namespace core {

struct ReaderWork {
    std::string program;  // its name beside this program
    std::string name;  // what messages call it
    std::vector<std::string> words;  // what it is to do
    int input = -1;  // what is open for it, at reader::input; -1: nothing
    double megabytes = 0, seconds = 0;  // of memory and of a processor's time, at most
};

// Such a program at work. All of its failures are thrown as core::Error, whose text tells why the file is not read.
class ReaderProcess {
public:
    explicit ReaderProcess(const ReaderWork& work);
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    // The program tells before each part of what it writes whether it has succeeded; where it has not, this throws.
    void readOutcome();
    void read(void* to, std::size_t bytes);
    template<class T>
    void read(std::vector<T>& values, std::size_t count) {
        values.resize(count);
        read(values.data(), count * sizeof(T));
    }

private:
    void start(const ReaderWork& work, int toChild);
    int end();
    [[noreturn]] void failed();

    std::string name_;
    Descriptor channel_;
    pid_t process_ = 0;
};

}  // namespace core
