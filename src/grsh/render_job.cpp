#include "grsh/render_job.h"

#include "core/memory.h"
#include "grsh/css_colours.h"
#include "grsh/option_words.h"
#include "image/film.h"
#include "render/render.h"
#include "render/transport/lanes_choice.h"

namespace grsh {
namespace {

void readCamera(Call& call, RenderJob& job) {
    constexpr core::Range pixels{.least = 1, .most = 1000000};
    constexpr core::Range coordinate{.least = -1e18, .most = 1e18};
    job.width = call.words.integer(2, "width", pixels);
    job.height = call.words.integer(3, "height", pixels);
    job.eye = call.words.vector(4, "eye", coordinate);
    job.view = call.words.vector(5, "view", coordinate);
    job.up = call.words.vector(6, "up", coordinate);
    // The square of a length may vanish where the length does not.
    const auto hasLength = [](const glm::dvec3& v) { return glm::dot(v, v) >= std::numeric_limits<double>::min(); };
    if (!hasLength(job.view)) throwBadValue("view", "a direction, not of length 0", call.words.object(5));
    if (!hasLength(job.up)) throwBadValue("up", "a direction, not of length 0", call.words.object(6));
    // About the sine of the angle between them; nearer than this, rounding would decide where right is.
    const double across = glm::length(glm::cross(glm::normalize(job.view), glm::normalize(job.up)));
    if (!(across > 1e-9)) throwBadValue("up", "a direction not parallel to view", call.words.object(6));
    job.fieldOfView =
        call.words.number(7, "fov", {.least = 0, .most = 180, .leastIncluded = false, .mostIncluded = false});
}

bool isOption(Call& call, std::size_t i) {
    return i < call.words.size() && findOption(render::RenderSettings::options(), call.words.text(i)) != nullptr;
}

// No option is written like a colour. What is none of both is the one that it is spelled most like.
bool isAmbient(Call& call, std::size_t i) {
    if (i >= call.words.size() || isOption(call, i)) return false;
    if (call.words.isColour(i)) return true;
    std::vector<std::string_view> options;
    for (const auto& row : render::RenderSettings::options()) options.push_back(row.name);
    const std::string_view word = call.words.text(i);
    return word.starts_with('#') ||
           (core::nearest(withoutDash(word), options).empty() && !core::nearest(word, cssColourNames()).empty());
}

// Behind ambient. One word is the name of a light, or an option misspelt: then the rest makes pairs with it.
bool isLights(Call& call, std::size_t i) {
    if (i >= call.words.size() || isOption(call, i)) return false;
    const bool makesPairs = (call.words.size() - i) % 2 == 0;
    return !makesPairs || call.words.listLength(i) != 1 || isOption(call, i + 1);
}

// ?{ambient} ?{lights}?? ?option value ...?
void readTail(Call& call, RenderJob& job) {
    std::size_t next = 8;
    if (isAmbient(call, next)) {
        job.ambient = call.words.colour(next++, "ambient", {.least = 0, .most = 1e18});
        if (isLights(call, next)) job.lights = call.words.strings(next++, "lights");
    }
    readOptions(call.words, next, "no such option", job.settings);
}

void checkLines(const RenderJob& job) {
    const auto check = [&](std::string_view option, int line) {
        if (line < job.height) return;
        throw core::Error("VALUE", "RANGE", std::to_string(line),
                          std::string(option) + " must be less than the height " + std::to_string(job.height) +
                              ", not \"" + std::to_string(line) + "\"");
    };
    check("startline", job.startLine());
    check("stopline", job.stopLine());
    if (job.startLine() > job.stopLine())
        throw core::Error("VALUE", "RANGE", std::to_string(job.startLine()),
                          "startline must be at most stopline " + std::to_string(job.stopLine()) + ", not \"" +
                              std::to_string(job.startLine()) + "\"");
}

void checkLimits(const RenderJob& job, const Limits& limits) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(job.width) * static_cast<std::uint64_t>(job.height);
    if (limits.pixels && pixels > *limits.pixels)
        throw core::Error("LIMIT", "PIXELS", job.file,
                          "a picture of " + std::to_string(job.width) + " x " + std::to_string(job.height) +
                              " pixels has more than --limit-pixels " + std::to_string(*limits.pixels));
    if (limits.samples && job.settings.mostSamples() > *limits.samples)
        throw core::Error("LIMIT", "SAMPLES", job.file,
                          "samplesperpixel " + std::to_string(job.settings.mostSamples()) +
                              " is more than --limit-samples " + std::to_string(*limits.samples));
}

// Where neither the script nor its words say how many samples there may be, the limit does.
void applyLimits(RenderJob& job, const Limits& limits) {
    if (limits.samples && !job.settings.samplesPerPixel && job.settings.mostSamples() > *limits.samples)
        job.settings.samplesPerPixel = *limits.samples;
    checkLimits(job, limits);
}

void checkMemory(const RenderJob& job) {
    const double needed = image::Film::bytesFor(job.width, job.lines(), job.layers()) +
                          render::Accumulation::bytesFor(job.width, job.lines(), !job.settings.layers.empty());
    const double available = static_cast<double>(core::availableMemory());
    if (needed > available)
        throw core::Error("MEMORY", "PICTURE", job.file,
                          "a picture of " + std::to_string(job.width) + " x " + std::to_string(job.lines()) +
                              " pixels takes " + core::memoryText(needed) + " of memory; " +
                              core::memoryText(available) + " are free");
}

}  // namespace

RenderJob readRenderJob(Call& call) {
    RenderJob job;
    job.settings.resume = call.session.resumes;
    job.node = call.words.text(0);
    call.session.database.find(job.node);
    job.file = call.words.fileName(1, "file");
    readCamera(call, job);
    readTail(call, job);
    checkLines(job);
    applyLimits(job, call.session.limits);
    render::checkLanes(job.settings.lanes);
    checkMemory(job);
    return job;
}

}  // namespace grsh
