// A script that can be read only once: standard input, a pipe with a name, or a word of the command line. Tcl knows the
// lines of files only, so each piece that is evaluated is a file for it, in a file system of our own, and what was read
// is kept to find errors in.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "grsh/place.h"

namespace grsh {

// The whole of standard input has this name; nothing of a machine's own does.
inline constexpr const char* standardInputPath = "/dev/grsh/input";
// And the script of -e this one.
inline constexpr const char* commandLinePath = "/dev/grsh/word";

class PipedScript {
public:
    // path: of the whole, normalized. typed: the script's name as scripts are to see it. There is one at a time.
    PipedScript(const std::string& path, const std::string& typed);
    ~PipedScript();
    PipedScript(const PipedScript&) = delete;
    PipedScript& operator=(const PipedScript&) = delete;

    // Adds text behind what there is. Tcl_FSEvalFile finds it, the last one that was added, under the name returned.
    std::string add(std::string_view text);
};

// A place in a piece as the place in the whole; any other stays as it is.
Place inWhole(Place place);

// A stack trace for a person to read: the pieces' names in it become that of the whole, as it was typed.
std::string withoutPieces(std::string trace);

// What there is of a piped script, if the path is one's.
std::optional<std::string_view> pipedText(const std::string& path);

}  // namespace grsh
