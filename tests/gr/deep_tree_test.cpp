// Trees too deep to walk by recursion.

#include "gr/database/database.h"
#include "gr/scene.h"

#include <gtest/gtest.h>
#include <pthread.h>

namespace gr {
namespace {

// On a stack that has less than 40 bytes for each level of the tree: no function fits in there that calls itself.
constexpr int depth = 5000;
constexpr std::size_t stackSize = 192 * 1024;

template<class Action>
void runOnSmallStack(Action action) {
    const auto run = [](void* argument) -> void* {
        (*static_cast<Action*>(argument))();
        return nullptr;
    };
    pthread_attr_t attributes;
    pthread_t thread;
    ASSERT_EQ(pthread_attr_init(&attributes), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, stackSize), 0);
    ASSERT_EQ(pthread_create(&thread, &attributes, run, &action), 0);
    ASSERT_EQ(pthread_join(thread, nullptr), 0);
    pthread_attr_destroy(&attributes);
}

TEST(DeepTree, NeedsNoDeepStack) {
    runOnSmallStack([] {
        Database database;
        std::string path = ":";
        for (int i = 0; i < depth; ++i) {
            path = database.create(path, "n", TransformNode{}).path();
            database.translate(path, {1, 0, 0});
        }
        database.create(path, "sphere", SphereNode{});
        EXPECT_EQ(path.size(), 2u * depth);

        const Scene scene = compile(database, ":", {});
        ASSERT_EQ(scene.instances.size(), 1u);
        EXPECT_EQ(scene.instances[0].place.worldFromObject().translation, core::Vec3f(depth, 0, 0));

        EXPECT_TRUE(database.print(":").ends_with("\n" + std::string(2 * depth + 2, ' ') + "sphere sphere {0 0 0} 1"));
        EXPECT_THROW(database.createInstance(path, "cycle", ":n"), core::Error);
        EXPECT_THROW(database.find(path + ":spere"), core::Error);
        database.remove(":n");
        EXPECT_EQ(database.nodeCount(), 1u);
    });
}

TEST(DeepTree, IsForgottenWithoutADeepStack) {
    runOnSmallStack([] {
        Database database;
        std::string path = ":";
        for (int i = 0; i < depth; ++i) path = database.create(path, "n", TransformNode{}).path();
    });
}

}  // namespace
}  // namespace gr
