#include "grsh/render_job.h"

#include "core/memory.h"
#include "grsh/css_colours.h"
#include "grsh/environment.h"
#include "grsh/option_words.h"
#include "grsh/place.h"
#include "image/film.h"
#include "render/render.h"
#include "render/transport/lanes_choice.h"

namespace grsh {
namespace {

// Where some of the words stand; next: those behind fov.
struct CameraWords {
    std::size_t view, up, fov, next;
};

constexpr std::array<std::string_view, 1> inPlaceOfView{"lookat"};

// In place of {view} there may stand lookat {x y z}, the option being written as options are.
CameraWords cameraWords(Call& call) {
    constexpr std::size_t view = 5;
    const std::size_t more = withoutDash(call.words.text(view)) == inPlaceOfView[0] ? 1 : 0;
    if (call.words.size() < 8 + more) throwWrongWords();
    return {view, view + 1 + more, view + 2 + more, view + 3 + more};
}

constexpr core::Range coordinate{.least = -1e18, .most = 1e18};

// What is spelled like lookat was meant for it.
glm::dvec3 readView(Call& call, std::size_t i) {
    if (const std::string hint = core::didYouMean(withoutDash(call.words.text(i)), inPlaceOfView); !hint.empty())
        throwBadValue("view", "{x y z}, or two words lookat {x y z}", call.words.object(i), hint);
    return call.words.vector(i, "view", coordinate);
}

void readCamera(Call& call, const CameraWords& at, RenderJob& job) {
    job.width = call.words.integer(2, "width", pixelRange);
    job.height = call.words.integer(3, "height", pixelRange);
    job.eye = call.words.vector(4, "eye", coordinate);
    if (at.up == at.view + 1)
        job.view = readView(call, at.view);
    else
        job.settings.lookAt = call.words.vector(at.view + 1, "lookat", coordinate);
    job.up = call.words.vector(at.up, "up", coordinate);
    job.fieldOfView =
        call.words.number(at.fov, "fov", {.least = 0, .most = 180, .leastIncluded = false, .mostIncluded = false});
}

// The square of a length may vanish where the length does not.
bool hasLength(const glm::dvec3& v) {
    return glm::dot(v, v) >= std::numeric_limits<double>::min();
}

// Once it is known what is looked at.
void checkView(Call& call, const CameraWords& at, RenderJob& job) {
    Tcl_Obj* const up = call.words.object(at.up);
    if (job.settings.lookAt) {
        job.view = *job.settings.lookAt - job.eye;
        if (!hasLength(job.view)) {
            const std::string point = core::optionText(job.settings.lookAt);
            throw core::Error("VALUE", "RANGE", point, "lookat must be another point than eye, not \"" + point + "\"");
        }
    } else if (!hasLength(job.view)) {
        throwBadValue("view", "a direction, not of length 0", call.words.object(at.view));
    }
    if (!hasLength(job.up)) throwBadValue("up", "a direction, not of length 0", up);
    // About the sine of the angle between them; nearer than this, rounding would decide where right is.
    const double across = glm::length(glm::cross(glm::normalize(job.view), glm::normalize(job.up)));
    if (!(across > 1e-9))
        throwBadValue("up",
                      job.settings.lookAt ? "a direction not parallel to the way from eye to lookat"
                                          : "a direction not parallel to view",
                      up);
    if (job.settings.depthOfField && job.settings.projection == "panorama")
        throw core::Error("VALUE", "LENS", "panorama",
                          "depthoffield must be off with projection panorama, which has no plane in focus");
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

// Whether a word is a list of names of lights, none of which can be meant as a colour.
bool namesLights(Call& call, std::size_t i) {
    const std::vector<std::string> known = call.session.database.lightNames();
    const auto isLight = [&](Tcl_Obj* word) {
        double number = 0;
        const bool isColour = Tcl_GetDoubleFromObj(nullptr, word, &number) == TCL_OK || cssColour(textOf(word));
        return !isColour && std::ranges::count(known, textOf(word)) > 0;
    };
    return call.words.listLength(i) > 0 && std::ranges::all_of(elementsOf(call.words.object(i), "lights", ""), isLight);
}

// Lights in the place of ambient: somebody who needs none forgets easily that it stands before them.
void checkAmbientGiven(Call& call, std::size_t i) {
    if (i >= call.words.size() || isOption(call, i) || !namesLights(call, i)) return;
    const std::string text(call.words.text(i));
    throw core::Error("VALUE", "LIGHTS", text,
                      "ambient must be given before the lights " + quoted(text) + ", as in " + "0 {" + text + "}");
}

// ?{ambient} ?{lights}?? ?option value ...?
void readTail(Call& call, std::size_t next, RenderJob& job) {
    checkAmbientGiven(call, next);
    if (isAmbient(call, next)) {
        job.ambient = call.words.colour(next++, "ambient", {.least = 0, .most = 1e18});
        if (isLights(call, next)) job.lights = call.words.strings(next++, "lights");
    }
    readRenderOptions(call, next, job.settings);
}

// first, last: a pair of options, and what they come to; of how many lines or columns there are.
void checkStrip(std::string_view first, int start, std::string_view last, int stop, std::string_view what, int count) {
    const auto refuse = [](std::string_view option, int number, const std::string& allowed) {
        const std::string given = std::to_string(number);
        throw core::Error("VALUE", "RANGE", given,
                          std::string(option) + " must be " + allowed + ", not \"" + given + "\"");
    };
    const std::string least = "less than the " + std::string(what) + " " + std::to_string(count);
    if (start >= count) refuse(first, start, least);
    if (stop >= count) refuse(last, stop, least);
    if (start > stop) refuse(first, start, "at most " + std::string(last) + " " + std::to_string(stop));
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
    const double needed = image::Film::bytesFor(job.columns(), job.lines(), job.layers()) +
                          render::Accumulation::bytesFor(job.columns(), job.lines(), !job.settings.layers.empty());
    const double available = static_cast<double>(core::availableMemory());
    if (needed > available)
        throw core::Error("MEMORY", "PICTURE", job.file,
                          "a picture of " + std::to_string(job.columns()) + " x " + std::to_string(job.lines()) +
                              " pixels takes " + core::memoryText(needed) + " of memory; " +
                              core::memoryText(available) + " are free");
}

}  // namespace

void readRenderOptions(Call& call, std::size_t first, render::RenderSettings& settings) {
    readOptions(call.words, first, "no such option", settings);
    for (std::size_t i = first; i < call.words.size(); i += 2)
        if (findOption(render::RenderSettings::options(), call.words.text(i))->name == "environment")
            settings.environmentPath = besideScript(call.interp, call.words.text(i + 1));
}

RenderJob readRenderJob(Call& call) {
    const CameraWords at = cameraWords(call);
    RenderJob job;
    job.settings = call.session.defaults.settings;
    job.settings.resume |= call.session.resumes;
    job.node = call.words.text(0);
    call.session.database.find(job.node);
    job.file = call.words.fileName(1, "file");
    readCamera(call, at, job);
    readTail(call, at.next, job);
    call.session.overrides->apply(job);
    checkView(call, at, job);
    checkEnvironment(job.settings);
    checkStrip("startline", job.startLine(), "stopline", job.stopLine(), "height", job.height);
    checkStrip("startcolumn", job.startColumn(), "stopcolumn", job.stopColumn(), "width", job.width);
    applyLimits(job, call.session.limits);
    render::checkLanes(job.settings.lanes);
    checkMemory(job);
    return job;
}

}  // namespace grsh
