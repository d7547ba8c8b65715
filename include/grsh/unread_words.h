// Whether a script looks at the words behind its name; one that does not is told so, for they were meant for something.
#pragma once

#include <tcl.h>

#include <string>
#include <vector>

namespace grsh {

class UnreadWords {
public:
    // script: its name as typed; written: how it stands on a command line. To be made once argv and argc are set, and
    // to end before the interpreter does.
    UnreadWords(Tcl_Interp* interp, const std::string& script, const std::string& written,
                const std::vector<std::string>& words);
    ~UnreadWords();
    UnreadWords(const UnreadWords&) = delete;
    UnreadWords& operator=(const UnreadWords&) = delete;

    // At the end of a script that has ended well: warns, once, where argv and argc were never read. A script that calls
    // `exit` comes to its end there.
    void tell();
    // At an end of another kind: there is nothing to tell any more.
    void drop() { isSettled_ = true; }

private:
    Tcl_Interp* interp_;
    std::string warning_;
    bool isSettled_ = false;
};

// A word as a shell reads it.
std::string inShell(const std::string& word);

// Whether a name counts that is only spelled almost like an option's.
enum class Spelling { right, near };

// "--set width=640" where the words at `at`, such as --width 640, mean an option of gr_render; else nothing. Goes on to
// the word behind them.
std::string setMeant(const std::vector<std::string>& words, std::size_t& at, Spelling spelling);

}  // namespace grsh
