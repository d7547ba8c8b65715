#include "core/parallel.h"
#include "grsh/commands.h"
#include "grsh/environment.h"
#include "grsh/interrupt.h"
#include "grsh/option_words.h"
#include "grsh/picture_words.h"
#include "grsh/place.h"
#include "grsh/progress.h"
#include "grsh/render_job.h"
#include "grsh/render_report.h"
#include "grsh/rescue.h"
#include "grsh/resumption.h"
#include "image/image_file.h"
#include "render/render.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace grsh {
namespace {

// Not from a variable, whose trace would run a script between the render and its file.
std::string scriptName(Tcl_Interp* interp) {
    const MainScript* script = mainScript(interp);
    return script == nullptr ? "" : std::filesystem::path(script->typed).filename().string();
}

std::unique_ptr<render::Integrator> makeIntegrator(const RenderJob& job, const gr::Scene& scene,
                                                   const gr::Accelerator& accelerator, const render::Camera& camera) {
    if (job.settings.integrator == "report")
        return render::makeReportIntegrator(scene, accelerator, job.settings, job.ambient, camera.starts());
    return render::makePathIntegrator(scene, accelerator, job.settings, job.ambient, camera.starts());
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Whether a path may find any light at all.
bool hasLight(const RenderJob& job, const gr::Scene& scene) {
    const auto shines = [](const core::Rgbf& light) { return light != core::Rgbf(0); };
    bool anyShines = shines(job.settings.background) || shines(job.ambient);
    scene.lights.forEach([&](const auto& light) { anyShines |= light.power() > 0; });
    return anyShines;
}

// What came out otherwise than it was asked for.
void warnOfNoise(Call& call, const RenderJob& job, const render::RenderResult& result) {
    if (job.settings.noise == 0 || result.stoppedBy != render::StoppedBy::samplesPerPixel) return;
    warn(call, "gr_render: " + job.file + ": noise " + core::numberText(job.settings.noise) + " is not reached with " +
                   std::to_string(result.samplesPerPixel) + " samples per pixel, " +
                   (result.noise ? "but " + render::noiseText(*result.noise) : "too few to tell what is"));
}

// The lights of gr_light and gr_sun that the command does not name, which is what most often makes a picture black.
std::string lightsLeftOut(const RenderJob& job, const gr::Database& database) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const std::string& name : database.lightNames())
        if (std::find(job.lights.begin(), job.lights.end(), name) == job.lights.end())
            names.push_back(grsh::quoted(name));
    if (names.empty()) return "";
    const std::size_t more = names.size() > most ? names.size() - most : 0;
    names.resize(names.size() - more);
    if (more > 0) names.push_back(std::to_string(more) + " more");
    const std::vector<std::string_view> words(names.begin(), names.end());
    return "; gr_render does not name the lights that there are: " + core::listed(words, "and");
}

void warnOfScene(Call& call, const RenderJob& job, const gr::Scene& scene) {
    if (!hasLight(job, scene))
        warn(call, "gr_render: " + job.file +
                       ": nothing shines, the picture is black: no lamp and no light named has " +
                       "radiance, and background and ambient are black" + lightsLeftOut(job, call.session.database));
    for (const std::string& text : scene.warnings) warn(call, "gr_render: " + job.file + ": " + text);
}

render::Camera cameraOf(const RenderJob& job, const gr::Scene& scene) {
    render::Camera camera({job.eye - scene.origin, job.view, job.up, job.fieldOfView, job.width, job.height,
                           render::projectionNamed(job.settings.projection), job.focalDistance()});
    if (job.settings.depthOfField) camera.setLens(job.settings.aperture, job.focalDistance());
    return camera;
}

render::RenderResult renderOn(render::Accumulation& accumulation, const RenderJob& job,
                              const render::Integrator& integrator, const render::Camera& camera,
                              const render::Checkpoints& checkpoints) {
    render::Progress progress;
    std::optional<ProgressLine> line;
    if (job.settings.progress) line.emplace(job.file, progress);
    return render::render(accumulation, integrator, camera, job.settings, progress, interrupted(), checkpoints);
}

// The picture as it is now, in its place; and what is needed to go on with it.
void publish(const image::ImageFile& file, const FileAccess& files, const RenderJob& job,
             const render::RenderResult& result, const render::Accumulation& accumulation, const Resumption& resumption,
             const image::Film& film, const image::Metadata& metadata) {
    if (result.samplesPerPixel == 0) {
        resumption.end(result, accumulation, false);
        throw core::Error("RENDER", "INTERRUPTED", job.file,
                          "interrupted before each pixel had a sample: \"" + job.file + "\" is not written");
    }
    try {
        writeOrRescue(file, files, job, film, metadata);
    } catch (const core::Error&) {
        // Where the picture is counts for more than that this has no place either.
        try {
            resumption.end(result, accumulation, false);
        } catch (const core::Error&) {
        }
        throw;
    }
    resumption.end(result, accumulation, true);
}

Tcl_Obj* renderCommand(Call& call) {
    const auto start = std::chrono::steady_clock::now();
    // Everything that can be wrong is found before the first ray.
    const RenderJob job = readRenderJob(call);
    const gr::Sky sky{readEnvironment(job, *call.session.files, call.session.database),
                      job.settings.environmentRotation};
    const gr::Scene scene = gr::compile(call.session.database, job.node, job.lights, gr::Origin::isNear, sky);
    // Ctrl-C is ours to see from here on, until no temporary file is left behind.
    const InterruptScope scope(call.interp);
    const image::ImageFile file(call.session.files->toWrite(job.file), job.layers());
    image::Film film(job.width, job.height, job.window(), job.layers());
    render::Accumulation accumulation(film);
    Resumption resumption(job, *call.session.files, scene);
    resumption.read(accumulation);
    warnOfScene(call, job, scene);

    // Render.
    const auto buildStart = std::chrono::steady_clock::now();
    const auto accelerator =
        gr::makeAccelerator(job.settings.acceleratorName(), scene, core::threadCount(job.settings.threads),
                            job.settings.integrator == "path");
    const double buildSeconds = secondsSince(buildStart);
    const render::Camera camera = cameraOf(job, scene);
    const auto integrator = makeIntegrator(job, scene, *accelerator, camera);
    const auto renderStart = std::chrono::steady_clock::now();
    const render::RenderResult result =
        renderOn(accumulation, job, *integrator, camera, resumption.checkpoints(call, accumulation));
    const double renderSeconds = secondsSince(renderStart);

    // Write the picture, and say what was done.
    accumulation.store(film);
    call.session.overrides->takeFile();
    publish(file, *call.session.files, job, result, accumulation, resumption, film,
            metadataOf(job, scene, result, scriptName(call.interp)));
    warnOfNoise(call, job, result);
    const double sumBytes = render::Accumulation::bytesFor(job.columns(), job.lines(), film.hasLayers());
    const RenderReport report{result,
                              *accelerator,
                              buildSeconds,
                              renderSeconds,
                              secondsSince(start),
                              scene.bytes(),
                              accelerator->bytes() + integrator->bytes(),
                              film.bytes() + static_cast<std::size_t>(sumBytes)};
    if (job.settings.progress) printSummary(report, job);
    if (result.stoppedBy == render::StoppedBy::interrupt)
        throw core::Error("RENDER", "INTERRUPTED", job.file, "interrupted");
    call.session.lastRender = hold(reportDict(report, job));
    return call.session.lastRender.get();
}

// The defaults as a list of option and value.
Tcl_Obj* defaultsList(const RenderDefaults& defaults) {
    Tcl_Obj* list = Tcl_NewListObj(0, nullptr);
    for (const auto& [option, value] : defaults.words) {
        Tcl_ListObjAppendElement(nullptr, list, textObject(option));
        Tcl_ListObjAppendElement(nullptr, list, value.get());
    }
    return list;
}

Tcl_Obj* defaultCommand(Call& call) {
    RenderDefaults& defaults = call.session.defaults;
    if (call.words.size() == 0) return defaultsList(defaults);
    render::RenderSettings settings = defaults.settings;
    readRenderOptions(call, 0, settings);
    defaults.settings = settings;
    for (std::size_t i = 0; i < call.words.size(); i += 2) {
        const std::string_view option = findOption(render::RenderSettings::options(), call.words.text(i))->name;
        const auto known = std::ranges::find(defaults.words, option, [](const auto& word) { return word.first; });
        Value value = hold(call.words.object(i + 1));
        if (known == defaults.words.end())
            defaults.words.emplace_back(option, std::move(value));
        else
            known->second = std::move(value);
    }
    return nullptr;
}

constexpr std::array<Command, 2> rows{{
    {"gr_render", "", "node file width height {eye} {view} {up} fov ?{ambient} ?{lights}?? ?option value ...?", 8,
     anyNumberOfWords, renderCommand, "renders the subtree at node into a picture file and returns what it did",
     "eye is a point, view and up are directions; lookat {x y z} in place of {view} looks at a point\n"
     "fov is the vertical field of view in degrees, between 0 and 180\n"
     "ambient is added where a path ends because it is as long as it may be\n"
     "lights are the names of the lights of gr_light and gr_sun that shine\n"
     "of an option that is given twice the last value counts"},
    {"gr_default", "", "?option value ...?", 0, anyNumberOfWords, defaultCommand,
     "sets options for every gr_render that follows and does not say otherwise; without words, returns those set",
     "the options are those of gr_render; gr_reset forgets them"},
}};

}  // namespace

std::span<const Command> renderCommands() {
    return rows;
}

std::vector<OptionHelp> renderOptionsHelp() {
    return optionsHelp(render::RenderSettings::options());
}

}  // namespace grsh
