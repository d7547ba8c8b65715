// The random numbers of a path: what they depend on, and that nothing else connects them.
// Seen to fail with a sampler that ignores the seed's upper half, one that knows a pixel by x + y, one that repeats its
// numbers, one that goes on with the next sample's, two rounds of Philox, and numbers squeezed towards 0 by 0.5 %.
#include "render/transport/sampler.h"

#include "support/histogram.h"

#include <gtest/gtest.h>

#include <set>

namespace render {
namespace {

std::vector<float> numbers(Sampler sampler, int count) {
    std::vector<float> values(static_cast<std::size_t>(count));
    for (float& value : values) value = sampler.next1D();
    return values;
}

TEST(Sampler, GivesTheSameNumbersForTheSamePath) {
    EXPECT_EQ(numbers(Sampler(7, 3, 2, 1), 1000), numbers(Sampler(7, 3, 2, 1), 1000));
    // Two paths at once: neither disturbs the other.
    Sampler a(7, 3, 2, 1), b(7, 3, 2, 2);
    std::vector<float> valuesA, valuesB;
    for (int i = 0; i < 100; ++i) {
        valuesA.push_back(a.next1D());
        for (int k = 0; k < i % 3; ++k) valuesB.push_back(b.next1D());
    }
    EXPECT_EQ(valuesA, numbers(Sampler(7, 3, 2, 1), 100));
    EXPECT_EQ(valuesB, numbers(Sampler(7, 3, 2, 2), static_cast<int>(valuesB.size())));
}

TEST(Sampler, DrawsAPairAsTwoNumbers) {
    Sampler pairs(1, 2, 3, 4);
    const std::vector<float> single = numbers(Sampler(1, 2, 3, 4), 12);
    for (std::size_t i = 0; i < 12; i += 2) EXPECT_EQ(pairs.next2D(), core::Vec2f(single[i], single[i + 1]));
}

// Every bit of what names a path changes its numbers, and no two paths have four of them in common, nor a path twice.
TEST(Sampler, GivesOtherNumbersForEveryOtherPath) {
    std::set<std::vector<float>> seen;
    std::size_t drawn = 0;
    const auto draw = [&](std::uint64_t seed, int x, int y, int sample) {
        Sampler sampler(seed, x, y, sample);
        for (int i = 0; i < 20; ++i, ++drawn) {
            const core::Vec2f a = sampler.next2D();
            const core::Vec2f b = sampler.next2D();
            seen.insert({a.x, a.y, b.x, b.y});
        }
    };
    draw(0, 0, 0, 0);
    for (int bit = 0; bit < 64; ++bit) draw(std::uint64_t{1} << bit, 0, 0, 0);
    for (int bit = 0; bit < 31; ++bit) {
        draw(0, 1 << bit, 0, 0);
        draw(0, 0, 1 << bit, 0);
        draw(0, 0, 0, 1 << bit);
    }
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            for (int sample = 0; sample < 10; ++sample) draw(100, x, y, sample);
    EXPECT_EQ(seen.size(), drawn);
}

// Along each of the ways in which a renderer draws: many numbers of one path, and the first of many paths.
struct Walk {
    const char* name;
    std::function<Sampler(int)> path;
    int perPath;
};
constexpr int draws = 1'000'000;
const Walk walks[] = {
    {"one path", [](int) { return Sampler(1, 5, 9, 0); }, draws},
    {"the samples of a pixel", [](int i) { return Sampler(1, 5, 9, i); }, 4},
    {"a line of pixels", [](int i) { return Sampler(1, i, 9, 0); }, 4},
    {"a column of pixels", [](int i) { return Sampler(1, 5, i, 0); }, 4},
    {"seeds", [](int i) { return Sampler(static_cast<std::uint64_t>(i), 5, 9, 0); }, 4},
};

TEST(Sampler, FillsTheSquareEvenly) {
    for (const Walk& walk : walks) {
        support::SquareHistogram histogram;
        for (int i = 0; i * walk.perPath < draws; ++i) {
            Sampler sampler = walk.path(i);
            for (int k = 0; k < walk.perPath; k += 2) {
                const core::Vec2f u = sampler.next2D();
                histogram.add(u.x, u.y);
            }
        }
        const support::DistributionResult result = histogram.test([](double, double) { return 1; });
        EXPECT_TRUE(result.accepted) << walk.name << ": " << result.text;
    }
}

// The correlation of n independent pairs is normal about 0 with a standard deviation of 1 / sqrt(n).
class Correlation {
public:
    void add(double a, double b) {
        // Uniform numbers have mean 1/2 and variance 1/12.
        products_.add(12 * (a - 0.5) * (b - 0.5));
    }
    support::TestResult test() const {
        return support::zTest(products_.mean(), 1 / std::sqrt(static_cast<double>(products_.count())), 0);
    }

private:
    support::RunningMean products_;
};

TEST(Sampler, DrawsDimensionsThatAreIndependent) {
    for (const std::size_t lag : {1, 2, 3, 4, 5, 8}) {
        Correlation correlation;
        for (int i = 0; i < 20'000; ++i) {
            const std::vector<float> values = numbers(Sampler(2, 5, 9, i), 16 + static_cast<int>(lag));
            for (std::size_t k = 0; k < 16; ++k) correlation.add(values[k], values[k + lag]);
        }
        EXPECT_TRUE(correlation.test().accepted) << "lag " << lag << ": " << correlation.test().text;
    }
}

TEST(Sampler, GivesNeighboursIndependentNumbers) {
    struct Neighbour {
        const char* name;
        int dx, dy, dSample;
        std::uint64_t dSeed;
    };
    const Neighbour neighbours[] = {{"to the right", 1, 0, 0, 0}, {"below", 0, 1, 0, 0},
                                    {"aslant", 1, -1, 0, 0},      {"next sample", 0, 0, 1, 0},
                                    {"next seed", 0, 0, 0, 1},    {"far seed", 0, 0, 0, std::uint64_t{1} << 32},
                                    {"16 pixels on", 16, 0, 0, 0}};
    for (const Neighbour& to : neighbours) {
        Correlation correlation;
        for (int y = 1; y < 65; ++y) {
            for (int x = 0; x < 64; ++x) {
                for (int sample = 0; sample < 8; ++sample) {
                    Sampler here(3, x, y, sample);
                    Sampler there(3 + to.dSeed, x + to.dx, y + to.dy, sample + to.dSample);
                    for (int k = 0; k < 8; ++k) {
                        const double a = here.next1D();
                        const double b = there.next1D();
                        correlation.add(a, b);
                    }
                }
            }
        }
        EXPECT_TRUE(correlation.test().accepted) << to.name << ": " << correlation.test().text;
    }
}

}  // namespace
}  // namespace render
