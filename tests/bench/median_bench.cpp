// The median filter beside the plain one that its tests compare it with, on one thread and the same picture.
#include "image/image_samples.h"
#include "image/median.h"
#include "image/plain_median.h"

#include <benchmark/benchmark.h>

#include <ctime>

namespace {

constexpr int side = 2000;

// The processor's seconds: that the machine has other work, too, falls on neither.
double secondsSince(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template<class Number>
void median(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const auto numbers = render::randomNumbers<Number>(side * side, 1);
    const auto start = std::clock();
    const auto expected = render::plainMedianFilter(numbers, side, side, n);
    const double plainSeconds = secondsSince(start);
    double seconds = 0;
    for (auto _ : state) {
        const auto filterStart = std::clock();
        const auto medians = image::medianFilter<Number>(numbers, side, side, n, 1);
        seconds += secondsSince(filterStart);
        if (medians != expected) state.SkipWithError("not the plain filter's picture");
    }
    state.counters["plain_s"] = plainSeconds;
    state.counters["times_faster"] = plainSeconds * static_cast<double>(state.iterations()) / seconds;
}

}  // namespace

BENCHMARK(median<std::uint8_t>)->Name("median/8_bit/n")->Arg(3)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond);
BENCHMARK(median<std::uint16_t>)->Name("median/16_bit/n")->Arg(3)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond);
BENCHMARK(median<float>)->Name("median/float/n")->Arg(3)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
