#include "grsh/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace grsh {
namespace {

std::size_t terminalColumns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

template<class... Values>
std::string format(const char* pattern, Values... values) {
    char text[128];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

}  // namespace

std::string durationText(double seconds) {
    if (seconds < 9.95) return format(seconds < 0.995 ? "%.2f s" : "%.1f s", seconds);
    const long whole = std::lround(seconds);
    if (whole < 60) return format("%ld s", whole);
    if (whole < 3600) return format("%ld min %02ld s", whole / 60, whole % 60);
    return format("%ld h %02ld min", whole / 3600, whole % 3600 / 60);
}

std::string rateText(std::uint64_t rays, double seconds) {
    const double rate = seconds > 0 ? static_cast<double>(rays) / seconds : 0;
    if (rate < 1e3) return format("%.0f rays/s", rate);
    const bool isMega = rate >= 1e6;
    const double shown = rate * (isMega ? 1e-6 : 1e-3);
    const int decimals = shown < 9.995 ? 2 : shown < 99.95 ? 1 : 0;
    return format("%.*f %s", decimals, shown, isMega ? "Mrays/s" : "krays/s");
}

std::string progressText(const std::string& title, std::uint64_t done, std::uint64_t expected, std::uint64_t rays,
                         double seconds, std::size_t columns) {
    constexpr int barLength = 16;
    const double part = expected == 0 ? 0 : std::min(static_cast<double>(done) / static_cast<double>(expected), 1.0);
    const int filled = static_cast<int>(part * barLength);
    std::string line = title + " [" + std::string(static_cast<std::size_t>(filled), '#') +
                       std::string(static_cast<std::size_t>(barLength - filled), '.') + "] " +
                       format("%3.0f %%", std::floor(100 * part));
    // What is most wanted comes first: a narrow terminal cuts the rest off.
    if (part > 0) line += "  " + durationText(seconds * (1 - part) / part) + " left";
    line += "  " + rateText(rays, seconds);
    line += format("  %.3g", static_cast<double>(done) * 1e-6);
    if (expected > 0) line += format(" of %.3g", static_cast<double>(std::max(done, expected)) * 1e-6);
    line += " Msamples";
    // The last column stays free: some terminals go on to the next line once it is written.
    line.resize(std::min(line.size(), columns - 1));
    return line;
}

ProgressLine::ProgressLine(std::string title, const render::Progress& progress)
    : title_(std::move(title)), progress_(progress) {
    if (isatty(STDERR_FILENO)) thread_ = std::thread([this] { drawUntilDone(); });
}

ProgressLine::~ProgressLine() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    changed_.notify_one();
    thread_.join();
    std::fputs("\r\033[K", stderr);
}

void ProgressLine::drawUntilDone() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, std::chrono::milliseconds(100), [this] { return done_; })) draw();
}

void ProgressLine::draw() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    const std::string line = progressText(title_, progress_.samples, progress_.expectedSamples, progress_.rays,
                                          passed.count(), terminalColumns());
    std::fprintf(stderr, "\r%s\033[K", line.c_str());
    std::fflush(stderr);
}

}  // namespace grsh
