// Regular scenes, where rays go along cell walls and objects touch: every accelerator finds what the linear search
// finds. GRSH_TEST_RAYS=140 traces 10^7 rays in all accelerator tests. All seen to fail where a grid's walk leaves out
// the last slice, or the last cell beside its way through a slice.

#include "gr/accelerator_checks.h"

#include <cstdio>

namespace gr {
namespace {

// Where the cells of the grid's first level end along each axis.
std::array<std::vector<float>, 3> wallsOf(const Scene& scene, const Accelerator& grid) {
    std::array<int, 3> count{};
    EXPECT_EQ(std::sscanf(grid.description().c_str(), "grid of %d x %d x %d", &count[0], &count[1], &count[2]), 3);
    const core::Bounds bounds = boundsOf(scene);
    std::array<std::vector<float>, 3> walls;
    for (int axis = 0; axis < 3; ++axis) {
        const float cell = bounds.size()[axis] / static_cast<float>(count[axis]);
        for (int i = 0; i <= count[axis]; ++i) walls[axis].push_back(bounds.low[axis] + static_cast<float>(i) * cell);
    }
    return walls;
}

// Rays from cell corners and within cell walls, along them or anywhere.
void expectSameHitsAlongWalls(const Scene& scene, int rays) {
    SameHits same(scene);
    RayMaker maker(scene, 1, 2);
    support::TestRandom& random = maker.random();
    const auto walls = wallsOf(scene, same.grid());
    const auto corner = [&] {
        core::Vec3f corner;
        for (int axis = 0; axis < 3; ++axis)
            corner[axis] =
                walls[axis][static_cast<std::size_t>(random.next() * static_cast<double>(walls[axis].size()))];
        return corner;
    };
    for (int i = 0; i < rays; ++i) {
        core::Rayf ray = maker.next();
        const int axis = static_cast<int>(3 * random.next());
        const double kind = random.next();
        if (kind < 0.4) {
            const core::Vec3f to = corner();
            ray.origin = corner();
            if (kind < 0.2 && to != ray.origin) ray.direction = to - ray.origin;
        } else {
            // One or two coordinates stay in walls.
            const core::Vec3f wall = corner();
            ray.direction[axis] = ray.direction[axis] < 0 ? -0.f : 0.f;
            ray.origin[axis] = wall[axis];
            if (kind < 0.7) {
                ray.direction = core::Vec3f(0);
                ray.direction[(axis + 1) % 3] = random.next() < 0.5 ? 1.f : -1.f;
                ray.origin[(axis + 2) % 3] = wall[(axis + 2) % 3];
            }
        }
        if (ray.direction == core::Vec3f(0)) continue;
        same.checkEnds(ray, random);
    }
    EXPECT_GT(same.hits(), 0);
    EXPECT_GT(same.misses(), 0);
}

Scene sphereLattice(const glm::ivec3& count, double radius) {
    Database database;
    for (int x = 0; x < count.x; ++x)
        for (int y = 0; y < count.y; ++y)
            for (int z = 0; z < count.z; ++z) addSphere(database, {x, y, z}, radius);
    return compile(database, ":", {});
}

Scene boxLattice(int count, const glm::dvec3& size) {
    Database database;
    for (int x = 0; x < count; ++x)
        for (int y = 0; y < count; ++y)
            for (int z = 0; z < count; ++z) addBox(database, {x, y, z}, size);
    return compile(database, ":", {});
}

TEST(AcceleratorLattice, SpheresInAPlane) {
    const Scene scene = sphereLattice({16, 1, 16}, 0.4);
    expectSameHits(scene, rayCount(3000));
    expectSameHitsAlongWalls(scene, rayCount(3000));
}

TEST(AcceleratorLattice, SpheresInSpace) {
    const Scene scene = sphereLattice({7, 7, 7}, 0.3);
    expectSameHits(scene, rayCount(3000));
    expectSameHitsAlongWalls(scene, rayCount(3000));
}

TEST(AcceleratorLattice, TouchingSpheres) {
    const Scene scene = sphereLattice({6, 6, 6}, 0.5);
    expectSameHits(scene, rayCount(3000));
    expectSameHitsAlongWalls(scene, rayCount(3000));
}

// Faces lie in each other, and mostly in cell walls: of two that are as near the one made first is found. Seen to fail
// where a walk ends a hair before the nearest hit, and where of two hits the one found first is kept.
TEST(AcceleratorLattice, TouchingBoxes) {
    const Scene scene = boxLattice(6, glm::dvec3(1));
    expectSameHits(scene, rayCount(3000));
    expectSameHitsAlongWalls(scene, rayCount(3000));
}

TEST(AcceleratorLattice, OverlappingAndFlatBoxes) {
    const Scene scene = boxLattice(5, {1.5, 1e-5, 1});
    expectSameHits(scene, rayCount(3000));
    expectSameHitsAlongWalls(scene, rayCount(3000));
}

// More than a cell may hold, and they cannot be kept apart. Seen to fail where of two hits the one found first is kept.
TEST(AcceleratorLattice, CoincidentObjects) {
    Database database;
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 place(i % 3 * 2, 0, 0);
        addSphere(database, place, 1);
        addBox(database, place - 1., glm::dvec3(2));
        database.create(":", nextName(database), AreaLightNode{core::Rgbf(1), place + glm::dvec3(0, 1, 0), 2});
        addSphere(database, place, 1 + 1e-7 * i);
    }
    const Scene scene = compile(database, ":", {});
    expectSameHits(scene, rayCount(3000));
    expectSameHitsAlongWalls(scene, rayCount(3000));
}

}  // namespace
}  // namespace gr
