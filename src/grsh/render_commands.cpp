#include "core/memory.h"
#include "core/parallel.h"
#include "grsh/commands.h"
#include "grsh/interrupt.h"
#include "grsh/option_words.h"
#include "grsh/place.h"
#include "grsh/progress.h"
#include "render/image_file.h"
#include "render/render.h"

#include <array>
#include <cstdio>
#include <filesystem>

namespace grsh {
namespace {

// A gr_render command, read and checked.
struct RenderJob {
    std::string node;
    std::string file;
    int width = 0, height = 0;
    glm::dvec3 eye{0}, view{0}, up{0};
    double fieldOfView = 0;  // vertical, degrees
    core::Rgbf ambient{0};
    std::vector<std::string> lights;
    render::RenderSettings settings;

    int startLine() const { return settings.startLine.value_or(0); }
    int stopLine() const { return settings.stopLine.value_or(height - 1); }
    int lines() const { return stopLine() - startLine() + 1; }
};

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

// No option is written like a list or a number.
bool isAmbient(Call& call, std::size_t i) {
    double number = 0;
    return i < call.words.size() &&
           (call.words.listLength(i) != 1 || Tcl_GetDoubleFromObj(nullptr, call.words.object(i), &number) == TCL_OK);
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

void checkMemory(const RenderJob& job) {
    const double needed = render::Film::bytesFor(job.width, job.lines());
    const double available = static_cast<double>(core::availableMemory());
    if (needed > available)
        throw core::Error("MEMORY", "PICTURE", job.file,
                          "a picture of " + std::to_string(job.width) + " x " + std::to_string(job.lines()) +
                              " pixels takes " + core::memoryText(needed) + " of memory; " +
                              core::memoryText(available) + " are free");
}

// The name as the system has it: Tcl's own UTF-8 has NUL, and letters beyond the first 65536, in another way.
std::string fileName(Tcl_Obj* word) {
    const std::string_view text = textOf(word);
    Tcl_DString native;
    Tcl_UtfToExternalDString(nullptr, text.data(), static_cast<int>(text.size()), &native);
    const std::string name(Tcl_DStringValue(&native), static_cast<std::size_t>(Tcl_DStringLength(&native)));
    Tcl_DStringFree(&native);
    if (name.find('\0') != std::string::npos) throwBadValue("file", "a name without NUL", word);
    return name;
}

RenderJob readJob(Call& call) {
    RenderJob job;
    job.node = call.words.text(0);
    call.session.database.find(job.node);
    job.file = fileName(call.words.object(1));
    readCamera(call, job);
    readTail(call, job);
    checkLines(job);
    checkMemory(job);
    return job;
}

// Not from a variable, whose trace would run a script between the render and its file.
std::string scriptName(Tcl_Interp* interp) {
    const MainScript* script = mainScript(interp);
    return script == nullptr ? "" : std::filesystem::path(script->typed).filename().string();
}

// What made the picture; nothing that another run of the same render would have different.
render::Metadata metadataOf(const RenderJob& job, Tcl_Interp* interp) {
    const auto vector = [](const glm::dvec3& v) {
        return core::numberText(v.x) + " " + core::numberText(v.y) + " " + core::numberText(v.z);
    };
    std::string lights;
    for (const std::string& light : job.lights) lights += (lights.empty() ? "" : " ") + light;
    render::Metadata metadata{{"Software", "grsh " GRSH_VERSION},
                              {"Scene", scriptName(interp)},
                              {"grsh:node", job.node},
                              {"grsh:width", std::to_string(job.width)},
                              {"grsh:height", std::to_string(job.height)},
                              {"grsh:eye", vector(job.eye)},
                              {"grsh:view", vector(job.view)},
                              {"grsh:up", vector(job.up)},
                              {"grsh:fov", core::numberText(job.fieldOfView)},
                              {"grsh:ambient", core::optionText(job.ambient)},
                              {"grsh:lights", lights}};
    render::RenderSettings resolved = job.settings;
    resolved.startLine = job.startLine();
    resolved.stopLine = job.stopLine();
    for (const auto& row : render::RenderSettings::options())
        if (row.inPicture) metadata.emplace_back("grsh:" + std::string(row.name), core::optionText(row, resolved));
    return metadata;
}

void put(Tcl_Obj* dict, const char* key, Tcl_Obj* value) {
    Tcl_DictObjPut(nullptr, dict, Tcl_NewStringObj(key, -1), value);
}

Tcl_Obj* wide(std::uint64_t number) {
    return Tcl_NewWideIntObj(static_cast<Tcl_WideInt>(number));
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Where memory went.
struct Bytes {
    std::size_t scene, accelerator, picture;
};

struct Seconds {
    double build, whole;  // of the accelerator, of everything
};

Tcl_Obj* report(Call& call, const render::RenderResult& result, const Seconds& seconds,
                const gr::Accelerator& accelerator, const Bytes& bytes) {
    Tcl_Obj* rays = Tcl_NewDictObj();
    put(rays, "camera", wide(result.rays.camera));
    put(rays, "shadow", wide(result.rays.shadow));
    put(rays, "diffuse", wide(result.rays.diffuse));
    put(rays, "reflective", wide(result.rays.reflective));
    put(rays, "refractive", wide(result.rays.refractive));
    Tcl_Obj* dict = Tcl_NewDictObj();
    put(dict, "file", call.words.object(1));
    put(dict, "seconds", Tcl_NewDoubleObj(seconds.whole));
    put(dict, "samples", wide(result.samples));
    put(dict, "rays", rays);
    const double rayCount = static_cast<double>(std::max<std::uint64_t>(result.rays.total(), 1));
    put(dict, "tests", Tcl_NewDoubleObj(static_cast<double>(result.rays.traversal.tests) / rayCount));
    put(dict, "cells", Tcl_NewDoubleObj(static_cast<double>(result.rays.traversal.cells) / rayCount));
    put(dict, "accelerator", textObject(accelerator.description()));
    put(dict, "build", Tcl_NewDoubleObj(seconds.build));
    put(dict, "bytes", wide(bytes.scene + bytes.accelerator + bytes.picture));
    Tcl_Obj* memory = Tcl_NewDictObj();
    put(memory, "scene", wide(bytes.scene));
    put(memory, "accelerator", wide(bytes.accelerator));
    put(memory, "picture", wide(bytes.picture));
    put(dict, "memory", memory);
    put(dict, "threads", Tcl_NewIntObj(result.threads));
    put(dict, "stopped", textObject("samplesperpixel"));
    put(dict, "dropped", wide(result.droppedSamples));
    return dict;
}

void printSummary(const RenderJob& job, const render::RenderResult& result, double seconds) {
    std::string line = job.file + ": " + std::to_string(job.width) + " x " + std::to_string(job.lines()) + " pixels, " +
                       std::to_string(job.settings.samplesPerPixel) + " samples each, " + durationText(seconds) + ", " +
                       rateText(result.rays.total(), seconds);
    if (result.droppedSamples > 0)
        line += ", " + std::to_string(result.droppedSamples) + " samples dropped (not finite)";
    std::fprintf(stderr, "%s\n", line.c_str());
}

render::RenderResult renderFilm(const RenderJob& job, const render::Integrator& integrator, render::Film& film) {
    render::Camera camera(job.eye, job.view, job.up, job.fieldOfView, job.width, job.height);
    if (job.settings.depthOfField) camera.setLens(job.settings.aperture, job.settings.focalDistance);
    render::Progress progress;
    const std::uint64_t samples = static_cast<std::uint64_t>(job.width) * static_cast<std::uint64_t>(job.lines()) *
                                  static_cast<std::uint64_t>(job.settings.samplesPerPixel);
    std::optional<ProgressLine> line;
    if (job.settings.progress) line.emplace(job.file, progress, samples);
    return render::render(integrator, camera, job.settings, film, progress, interrupted());
}

Tcl_Obj* renderCommand(Call& call) {
    // Everything that can be wrong is found before the first ray.
    const RenderJob job = readJob(call);
    const gr::Scene scene = gr::compile(call.session.database, job.node, job.lights);
    // Ctrl-C is ours to see from here on, until no temporary file is left behind.
    const InterruptScope scope(call.interp);
    const render::ImageFile file(job.file);

    // Render.
    const auto start = std::chrono::steady_clock::now();
    const auto accelerator =
        gr::makeAccelerator(job.settings.accelerator, scene, core::threadCount(job.settings.threads));
    const double buildSeconds = secondsSince(start);
    const auto integrator =
        render::makeReportIntegrator(scene, *accelerator, job.settings, job.ambient, core::Vec3f(job.eye));
    render::Film film(job.width, job.height, job.startLine(), job.lines());
    const render::RenderResult result = renderFilm(job, *integrator, film);
    if (!result.finished) throw core::Error("RENDER", "INTERRUPTED", job.file, "interrupted");

    // Write the picture, and say what was done.
    file.write(film, job.settings.exposure, metadataOf(job, call.interp));
    const Seconds seconds{buildSeconds, secondsSince(start)};
    if (job.settings.progress) printSummary(job, result, seconds.whole);
    return report(call, result, seconds, *accelerator, {scene.bytes(), accelerator->bytes(), film.bytes()});
}

constexpr std::array<Command, 1> rows{{
    {"gr_render", "", "node file width height {eye} {view} {up} fov ?{ambient} ?{lights}?? ?option value ...?", 8,
     anyNumberOfWords, renderCommand, "renders the subtree at node into a picture file and returns what it did",
     "eye is a point, view and up are directions\n"
     "fov is the vertical field of view in degrees, between 0 and 180\n"
     "ambient is added where a path ends because it is as long as it may be\n"
     "lights are the names of the gr_light lights that shine"},
}};

}  // namespace

std::span<const Command> renderCommands() {
    return rows;
}

std::string renderOptionsHelp() {
    return optionsHelp(render::RenderSettings::options());
}

}  // namespace grsh
