// A sample's random numbers are the same in every lane as at float. Seen to fail with a lane's number taken from its
// neighbour.
#include "render/transport/owen_sobol.h"

#include "lanes/both_widths.h"

namespace lanes {
namespace {

using core::UInt;

TEST(LanesOwenSobol, DrawsTheSameNumbers) {
    support::TestRandom random(21);
    const auto next = [&] { return static_cast<std::uint32_t>(random.nextBits()); };
    for (int i = 0; i < 20'000; ++i) {
        // Numbers of every size: what overflows must overflow alike.
        std::array<std::uint32_t, width> pixel, sample, number;
        const int bits = 1 + static_cast<int>(next() % 31);
        for (std::size_t lane = 0; lane < width; ++lane) {
            pixel[lane] = next();
            sample[lane] = next() >> (32 - bits);
            number[lane] = next() >> (next() % 32);
        }
        const auto lanesOf = [](const auto& row) { return core::loadUInt<Lanes>(row.data()); };
        const render::Point4<Lanes> point =
            render::OwenSobol<Lanes>(lanesOf(pixel), lanesOf(sample), bits).point(lanesOf(number));
        for (std::size_t d = 0; d < 4; ++d) {
            const core::LaneArray<Lanes> coordinate(point[d]);
            for (std::size_t lane = 0; lane < width; ++lane)
                ASSERT_EQ(coordinate[static_cast<int>(lane)],
                          render::OwenSobol<float>(pixel[lane], sample[lane], bits).point(number[lane])[d])
                    << "coordinate " << d << " of sample " << sample[lane] << " in lane " << lane;
        }
    }
}

}  // namespace
}  // namespace lanes
