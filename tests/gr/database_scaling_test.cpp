// No step of making, looking at and deleting a large scene is slower than linear.

#include "gr/database/database.h"
#include "gr/scene.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

namespace gr {
namespace {

struct Step {
    const char* name;
    void (*run)(Database& database, int count);
};

const std::string& nodePath(int i) {
    static std::string path;
    return path = ":s" + std::to_string(i);
}

// In this order on one database.
constexpr Step steps[] = {
    {"make spheres",
     [](Database& database, int count) {
         for (int i = 0; i < count; ++i) database.create(":", "s" + std::to_string(i), SphereNode{});
     }},
    {"move them",
     [](Database& database, int count) {
         for (int i = 0; i < count; ++i) database.translate(nodePath(i), {1, 2, 3});
     }},
    {"make more without a name",
     [](Database& database, int count) {
         for (int i = 0; i < count; ++i) database.create(":", "#auto", SphereNode{}, "s");
     }},
    {"instance one",
     [](Database& database, int count) {
         for (int i = 0; i < count; ++i) database.createInstance(":", "i" + std::to_string(i), ":s0");
     }},
    {"print", [](Database& database, int) { EXPECT_FALSE(database.print(":").empty()); }},
    {"compile",
     [](Database& database, int count) { EXPECT_EQ(compile(database, ":", {}).instances.size(), 3u * count); }},
    {"delete the instances",
     [](Database& database, int count) {
         for (int i = 0; i < count; ++i) database.remove(":i" + std::to_string(i));
     }},
    {"delete the first half",
     [](Database& database, int count) {
         for (int i = 0; i < count / 2; ++i) database.remove(nodePath(i));
     }},
    {"forget the rest", [](Database& database, int) { database.reset(); }},
};

std::vector<double> secondsOf(int count) {
    Database database;
    std::vector<double> seconds;
    for (const Step& step : steps) {
        const std::clock_t start = std::clock();
        step.run(database, count);
        seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return seconds;
}

// Ten times as much takes ten times as long, twenty where it no longer fits a cache, and a hundred were it quadratic.
TEST(DatabaseScaling, TenTimesAsManyNodesTakeNoHundredTimesAsLong) {
    const std::vector<double> few = secondsOf(100'000), many = secondsOf(1'000'000);
    for (std::size_t i = 0; i < std::size(steps); ++i) {
        const double ratio = many[i] / std::max(few[i], 0.01);
        std::printf("%-22s %6.3f s, ten times as many %6.3f s\n", steps[i].name, few[i], many[i]);
        EXPECT_LT(ratio, 50) << steps[i].name;
    }
}

}  // namespace
}  // namespace gr
