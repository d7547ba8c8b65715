#include "core/parallel.h"
#include "gr/fingerprint.h"
#include "grsh/commands.h"
#include "grsh/interrupt.h"
#include "grsh/option_words.h"
#include "grsh/place.h"
#include "grsh/progress.h"
#include "grsh/render_job.h"
#include "grsh/render_report.h"
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

// What made the picture; nothing that another run of the same render would have different.
image::Metadata metadataOf(const RenderJob& job, const gr::Scene& scene, const render::RenderResult& result,
                           Tcl_Interp* interp) {
    const auto vector = [](const glm::dvec3& v) {
        return core::numberText(v.x) + " " + core::numberText(v.y) + " " + core::numberText(v.z);
    };
    std::string lights;
    for (const std::string& light : job.lights) lights += (lights.empty() ? "" : " ") + light;
    image::Metadata metadata{{"Software", "grsh " GRSH_VERSION},
                             {"Scene", scriptName(interp)},
                             {"grsh:fingerprint", std::to_string(gr::fingerprint(scene))},
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
    resolved.samplesPerPixel = result.samplesPerPixel;
    for (const auto& row : render::RenderSettings::options())
        if (row.inPicture) metadata.emplace_back("grsh:" + std::string(row.name), core::optionText(row, resolved));
    metadata.emplace_back("grsh:stopped", stoppedText(result.stoppedBy));
    if (result.noise) {
        metadata.emplace_back("grsh:noise", render::noiseText(*result.noise));
        if (job.lines() < job.height) metadata.emplace_back("grsh:noisesums", result.noiseSums->text());
    }
    return metadata;
}

std::unique_ptr<render::Integrator> makeIntegrator(const RenderJob& job, const gr::Scene& scene,
                                                   const gr::Accelerator& accelerator) {
    const core::Vec3f eye(job.eye - scene.origin);
    if (job.settings.integrator == "report")
        return render::makeReportIntegrator(scene, accelerator, job.settings, job.ambient, eye);
    return render::makePathIntegrator(scene, accelerator, job.settings, job.ambient, eye);
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

// eye: in the scene's own space.
render::RenderResult renderFilm(const RenderJob& job, const glm::dvec3& eye, const render::Integrator& integrator,
                                image::Film& film) {
    render::Camera camera(eye, job.view, job.up, job.fieldOfView, job.width, job.height);
    if (job.settings.depthOfField) camera.setLens(job.settings.aperture, job.settings.focalDistance);
    render::Progress progress;
    std::optional<ProgressLine> line;
    if (job.settings.progress) line.emplace(job.file, progress);
    return render::render(integrator, camera, job.settings, film, progress, interrupted());
}

Tcl_Obj* renderCommand(Call& call) {
    const auto start = std::chrono::steady_clock::now();
    // Everything that can be wrong is found before the first ray.
    const RenderJob job = readRenderJob(call);
    const gr::Scene scene = gr::compile(call.session.database, job.node, job.lights, gr::Origin::isNear);
    // Ctrl-C is ours to see from here on, until no temporary file is left behind.
    const InterruptScope scope(call.interp);
    const image::ImageFile file(call.session.files->toWrite(job.file), job.layers());
    if (!hasLight(job, scene))
        warn(call, "gr_render: " + job.file +
                       ": nothing shines, the picture is black: no lamp and no light named has " +
                       "radiance, and background and ambient are black");

    for (const std::string& text : scene.warnings) warn(call, "gr_render: " + job.file + ": " + text);

    // Render.
    const auto buildStart = std::chrono::steady_clock::now();
    const auto accelerator = gr::makeAccelerator(
        job.settings.accelerator, scene, core::threadCount(job.settings.threads), job.settings.integrator == "path");
    const double buildSeconds = secondsSince(buildStart);
    const auto integrator = makeIntegrator(job, scene, *accelerator);
    image::Film film(job.width, job.height, job.startLine(), job.lines(), job.layers());
    const auto renderStart = std::chrono::steady_clock::now();
    const render::RenderResult result = renderFilm(job, job.eye - scene.origin, *integrator, film);
    const double renderSeconds = secondsSince(renderStart);
    if (!result.finished) throw core::Error("RENDER", "INTERRUPTED", job.file, "interrupted");

    // Write the picture, and say what was done.
    file.write(film, job.settings.exposure, metadataOf(job, scene, result, call.interp));
    warnOfNoise(call, job, result);
    const std::size_t pictureBytes =
        film.bytes() + static_cast<std::size_t>(render::sumBytesFor(job.settings, job.width, job.lines()));
    const RenderReport report{result,
                              *accelerator,
                              buildSeconds,
                              renderSeconds,
                              secondsSince(start),
                              scene.bytes(),
                              accelerator->bytes() + integrator->bytes(),
                              pictureBytes};
    if (job.settings.progress) printSummary(report, job);
    call.session.lastRender = hold(reportDict(report, call.words.object(1)));
    return call.session.lastRender.get();
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
