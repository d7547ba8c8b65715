// What the commands that make nodes have in common.
#pragma once

#include "grsh/commands.h"

namespace grsh {

inline constexpr double mostCoordinate = 1e18;  // its square is still a float
inline constexpr core::Range coordinate{.least = -mostCoordinate, .most = mostCoordinate};
inline constexpr core::Range length{.least = 0, .most = mostCoordinate, .leastIncluded = false};

inline glm::dvec3 position(Call& call, std::size_t i, std::string_view what) {
    return call.words.vector(i, what, coordinate);
}

// Parent and name are looked at first: they come first in the script.
inline void checkNew(Call& call) {
    call.session.database.checkNew(call.words.text(0), call.words.text(1));
}

inline Tcl_Obj* create(Call& call, gr::NodeContent content) {
    auto& database = call.session.database;
    const gr::Node& node = database.create(call.words.text(0), call.words.text(1), std::move(content), call.kind);
    return textObject(node.path());
}

}  // namespace grsh
