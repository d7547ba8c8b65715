// What an error says, and that it changed nothing.
#pragma once

#include "gr/database.h"

#include <gtest/gtest.h>

namespace gr {

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

template<class Action>
void expectError(const Database& database, Action&& action, const std::string& expected) {
    const std::string before = database.print(":");
    const std::size_t nodes = database.nodeCount();
    EXPECT_EQ(errorOf(action), expected);
    EXPECT_EQ(database.print(":"), before);
    EXPECT_EQ(database.nodeCount(), nodes);
}

}  // namespace gr
