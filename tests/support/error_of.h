// What an error says.
#pragma once

#include "core/error.h"

#include <string>

namespace support {

// TOPIC REASON [word] message
template<class Action>
std::string errorOf(Action&& action) {
    try {
        action();
    } catch (const core::Error& error) {
        return error.topic + " " + error.reason + " [" + error.word + "] " + error.what();
    }
    return "no error";
}

}  // namespace support
