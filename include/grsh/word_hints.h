// What a message adds where a word shows which trap of Tcl's it fell into.
#pragma once

#include <string>
#include <string_view>

namespace grsh {

// For a number that begins with 0 and is therefore octal, but has an 8 or a 9; else empty.
std::string octalHint(std::string_view word);

// For a word or a list with a $ or a [ in it, which Tcl leaves as it is between braces: how it is written so that it
// is replaced, e.g. [list $x 0 0] for {$x 0 0}. Else empty.
std::string bracesHint(std::string_view word);

}  // namespace grsh
