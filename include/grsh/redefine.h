// -redefine, which stands before the name of a material or a light.
#pragma once

#include "core/error.h"
#include "grsh/commands.h"

#include <array>

namespace grsh {

inline constexpr std::string_view redefineOption = "-redefine";

inline bool redefines(const Call& call) {
    return call.words.text(0) == redefineOption;
}

// For a call that makes no sense as it stands: throws where its first word is spelled like the option. A name may be.
inline void checkRedefineSpelling(const Call& call) {
    constexpr std::array<std::string_view, 1> options{redefineOption};
    const std::string word(call.words.text(0));
    if (const std::string hint = core::didYouMean(word, options); word != redefineOption && !hint.empty())
        throw core::Error("OPTION", "UNKNOWN", word, "no such option " + quoted(word) + hint);
}

}  // namespace grsh
