// Building a grid takes time in proportion to n log n and never more than 200 bytes an object, whatever the objects
// are. Time and bytes were seen to fail where levels within levels may take any number of bytes, and where no level has
// fewer than n / 64 cells.

#include "gr/accelerators/grid.h"
#include "gr/bytes_in_use.h"
#include "gr/hard_scenes.h"

namespace gr {
namespace {

std::vector<core::Bounds> allBounds(const Scene& scene) {
    std::vector<core::Bounds> bounds;
    bounds.reserve(scene.instances.size());
    for (const Instance& instance : scene.instances) bounds.push_back(instance.bounds());
    return bounds;
}

constexpr float errorPerUnit = 0x1p-19f;

class GridBuild : public testing::TestWithParam<HardScene> {};
INSTANTIATE_TEST_SUITE_P(, GridBuild, testing::ValuesIn(hardScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

// How much is looked at, not seconds, which other programs change.
TEST_P(GridBuild, TakesTimeForEachObject) {
    for (const int count : {100, 1000, 10'000, 40'000}) {
        const std::vector<core::Bounds> bounds = allBounds(hardScene(GetParam(), count));
        const double steps = static_cast<double>(Grid(bounds, errorPerUnit, 2).buildSteps());
        ASSERT_LT(steps, 40 * count * std::log2(count)) << count;
    }
}

#ifdef GRSH_COUNTS_BYTES
TEST_P(GridBuild, TakesFewBytesForEachObject) {
    for (const int count : {100, 1000, 10'000, 40'000}) {
        const std::int64_t before = bytesInUse;
        const std::vector<core::Bounds> bounds = allBounds(hardScene(GetParam(), count));
        const std::int64_t boundsAlone = bytesInUse - before;
        mostBytesInUse = before + boundsAlone;
        const Grid grid(bounds, errorPerUnit, 2);
        // And a few for what there is once.
        ASSERT_LT(mostBytesInUse - before, 200 * count + 2000) << count;
        ASSERT_LT(grid.bytes(), 100u * static_cast<unsigned>(count)) << count;
    }
}
#endif

// Whether a grid is even is seen without building one that is not. Seen to fail where what every
// resolution costs is found out first.
TEST_P(GridBuild, IsNotTriedWhereItWouldNotBeEven) {
    for (const int count : {100, 1000, 10'000, 40'000}) {
        const std::vector<core::Bounds> bounds = allBounds(hardScene(GetParam(), count));
        const Grid grid(bounds, errorPerUnit, 2, 1, true);
        EXPECT_FALSE(grid.isEven(bounds.size())) << count;
        ASSERT_LT(static_cast<double>(grid.buildSteps()), 30 * count) << count;
    }
}

TEST_P(GridBuild, FindsWhatTheLinearSearchFinds) {
    const Scene scene = hardScene(GetParam(), 500);
    SameHits same(scene);
    RayMaker maker(scene, 1, 3);
    for (int i = 0; i < rayCount(400); ++i) same.checkEnds(maker.next(), maker.random());
    EXPECT_GT(same.hits(), 0);
}

TEST(GridEven, ALatticeIsBuiltAsItIsAnyway) {
    Database database;
    for (int i = 0; i < 8000; ++i) addSphere(database, {i % 20, i / 20 % 20, i / 400}, 0.4);
    const std::vector<core::Bounds> bounds = allBounds(compile(database, ":", {}));
    const Grid even(bounds, errorPerUnit, 2, 1, true), any(bounds, errorPerUnit, 2);
    EXPECT_TRUE(even.isEven(bounds.size()));
    EXPECT_EQ(even.resolution(), any.resolution());
    EXPECT_EQ(even.bytes(), any.bytes());
}

// As far as their bounds can be told apart, which rounding makes 34 spacings wide. Seen to fail where cells are always
// cubes.
TEST(GridShape, WiresAreKeptApartByCellsAsLongAsThey) {
    const std::vector<core::Bounds> bounds = allBounds(hardScene(hardScenes[3], 10'000));
    const Grid grid(bounds, errorPerUnit, 2);
    EXPECT_EQ(grid.resolution()[0], 1);
    EXPECT_GT(grid.resolution()[1], 200);
}

TEST(GridThreads, AnyNumberBuildsTheSame) {
    for (const HardScene& hard : hardScenes) {
        const std::vector<core::Bounds> bounds = allBounds(hardScene(hard, 10'000));
        const Grid one(bounds, errorPerUnit, 1), four(bounds, errorPerUnit, 4);
        EXPECT_EQ(one.resolution(), four.resolution()) << hard.name;
        EXPECT_EQ(one.levelCount(), four.levelCount()) << hard.name;
        EXPECT_EQ(one.bytes(), four.bytes()) << hard.name;
    }
}

}  // namespace
}  // namespace gr
