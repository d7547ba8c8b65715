// What an error says, and that it changed nothing.
#pragma once

#include "gr/database/database.h"
#include "support/error_of.h"

#include <gtest/gtest.h>

namespace gr {

using support::errorOf;

template<class Action>
void expectError(const Database& database, Action&& action, const std::string& expected) {
    const std::string before = database.print(":");
    const std::size_t nodes = database.nodeCount();
    EXPECT_EQ(errorOf(action), expected);
    EXPECT_EQ(database.print(":"), before);
    EXPECT_EQ(database.nodeCount(), nodes);
}

}  // namespace gr
