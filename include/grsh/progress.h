// The line that tells how far a render is.
#pragma once

#include "render/render.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace grsh {

// Draws one line on standard error, at most ten times a second, for as long as it lives, and erases it at its end.
// Draws nothing when standard error is no terminal.
class ProgressLine {
public:
    // title: what is rendered.
    ProgressLine(std::string title, const render::Progress& progress);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

private:
    void drawUntilDone();
    void draw() const;

    std::string title_;
    const render::Progress& progress_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::condition_variable changed_;
    bool done_ = false;
    std::thread thread_;
};

// The line's text: done and expected are paths, expected 0 where nobody knows; seconds is since the start. At most
// `columns` letters.
std::string progressText(const std::string& title, std::uint64_t done, std::uint64_t expected, std::uint64_t rays,
                         double seconds, std::size_t columns);

// 0.42 s, 12 s, 3 min 05 s, 2 h 07 min
std::string durationText(double seconds);

// 5.12 Mrays/s, 34.0 krays/s, 56 rays/s
std::string rateText(std::uint64_t rays, double seconds);

}  // namespace grsh
