// The name #auto: what it stands for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gr {

inline constexpr std::string_view autoName = "#auto";

struct AutoName {
    std::string name;
    std::size_t number = 0;
};

// kind and the first number after `last` that makes a name which is not taken. The caller keeps the number, so that no
// name is looked at twice and none is given again.
template<class IsTaken>
AutoName nextFree(std::string_view kind, std::size_t last, IsTaken&& isTaken) {
    AutoName free{"", last};
    do free.name = std::string(kind) + std::to_string(++free.number);
    while (isTaken(free.name));
    return free;
}

}  // namespace gr
