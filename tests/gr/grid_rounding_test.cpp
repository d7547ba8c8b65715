// What a grid rounds, in cells that are far larger than what is in them. Seen to fail where GridLevel::rounding is
// 2^-24 of the reach.

#include "gr/accelerator_checks.h"

namespace gr {
namespace {

// Where two cells meet that is nearest to the origin, along an axis, as a grid of so many cells has it.
float wallNearOrigin(const core::Bounds& box, int cells, int axis) {
    const float low = box.low[axis], cell = box.size()[axis] / static_cast<float>(cells);
    return low + std::round(-low / cell) * cell;
}

// Tiny balls lie in the walls of a grid that reaches very far, and short rays go along the walls to them, all near the
// origin: there a ray and a ball are where they are to a hundred-thousandth of what the grid rounds.
TEST(GridRounding, TinyBallsInTheWallsOfLargeCells) {
    support::TestRandom random(31);
    for (int round = 0; round < rayCount(150); ++round) {
        const double reach = 1000 * (1 + random.next());
        const int side = 4 + 2 * (round % 4);
        Database database;
        for (int x = 0; x < side; ++x)
            for (int y = 0; y < side; ++y)
                for (int z = 0; z < side; ++z)
                    addSphere(database, reach * (glm::dvec3(2 * x + 1, 2 * y + 1, 2 * z + 1) / (1. * side) - 1.),
                              0.6 * reach / side);
        const Scene lattice = compile(database, ":", {});
        const auto cells = makeAccelerator("grid", lattice, 1)->resolution();
        ASSERT_TRUE(cells);
        std::vector<glm::dvec3> places;
        for (int i = 0; i < 6; ++i) {
            glm::dvec3 place;
            for (int axis = 0; axis < 3; ++axis)
                place[axis] =
                    wallNearOrigin(boundsOf(lattice), (*cells)[axis], axis) + reach * 0x1p-22 * (2 * random.next() - 1);
            addSphere(database, places.emplace_back(place), 1e-9 * reach);
        }
        const Scene scene = compile(database, ":", {});
        SameHits same(scene);
        for (int i = 0; i < 200; ++i) {
            const core::Vec3f to(places[static_cast<std::size_t>(i) % places.size()]);
            core::Vec3f from(glm::dvec3(to) + reach * std::pow(0.01, 1 + random.next()) * randomPoint(random, -1, 1));
            // In one wall or two.
            const int axis = static_cast<int>(3 * random.next());
            from[axis] = to[axis];
            if (random.next() < 0.5) from[(axis + 1) % 3] = to[(axis + 1) % 3];
            same.check({from, to - from, 1.5f});
        }
        EXPECT_GT(same.hits(), 0);
    }
}

}  // namespace
}  // namespace gr
