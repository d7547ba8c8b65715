#include "grsh/picture_words.h"

#include "gr/fingerprint.h"
#include "grsh/render_report.h"
#include "render/accumulate/tile.h"

namespace grsh {
namespace {

image::Metadata viewWords(const RenderJob& job, const gr::Scene& scene) {
    const auto vector = [](const glm::dvec3& v) {
        return core::numberText(v.x) + " " + core::numberText(v.y) + " " + core::numberText(v.z);
    };
    std::string lights;
    for (const std::string& light : job.lights) lights += (lights.empty() ? "" : " ") + light;
    return {{"fingerprint", std::to_string(gr::fingerprint(scene))},
            {"node", job.node},
            {"width", std::to_string(job.width)},
            {"height", std::to_string(job.height)},
            {"eye", vector(job.eye)},
            {"view", vector(job.view)},
            {"up", vector(job.up)},
            {"fov", core::numberText(job.fieldOfView)},
            {"ambient", core::optionText(job.ambient)},
            {"lights", lights}};
}

image::Metadata optionWords(const RenderJob& job, int samplesPerPixel) {
    render::RenderSettings resolved = job.settings;
    resolved.startLine = job.startLine();
    resolved.stopLine = job.stopLine();
    resolved.startColumn = job.startColumn();
    resolved.stopColumn = job.stopColumn();
    resolved.accelerator = job.settings.acceleratorName();
    resolved.focalDistance = job.focalDistance();
    resolved.samplesPerPixel = samplesPerPixel;
    image::Metadata words;
    for (const auto& row : render::RenderSettings::options())
        if (row.inPicture) words.emplace_back(std::string(row.name), core::optionText(row, resolved));
    return words;
}

}  // namespace

image::Metadata metadataOf(const RenderJob& job, const gr::Scene& scene, const render::RenderResult& result,
                           const std::string& script) {
    image::Metadata metadata{{"Software", "grsh " GRSH_VERSION}, {"Scene", script}};
    for (const auto& words : {viewWords(job, scene), optionWords(job, result.samplesPerPixel)})
        for (const auto& [name, value] : words) metadata.emplace_back("grsh:" + name, value);
    metadata.emplace_back("grsh:stopped", stoppedText(result.stoppedBy));
    if (result.noise) {
        metadata.emplace_back("grsh:noise", render::noiseText(*result.noise));
        const image::Window part = job.window(), whole{0, 0, job.width, job.height};
        if (part != whole && render::hasWholeTiles(part, job.width))
            metadata.emplace_back("grsh:noisesums", result.noiseSums->text());
    }
    return metadata;
}

render::StateWords stateWordsOf(const RenderJob& job, const gr::Scene& scene) {
    render::StateWords words{{"version of grsh", GRSH_VERSION}};
    // The report's samples lie on a grid that counts on how many there will be.
    const bool isSpread = job.settings.integrator == "report" && job.settings.antialiasing;
    for (const auto& some : {viewWords(job, scene), optionWords(job, isSpread ? job.settings.samplesSpread() : 0)})
        for (const auto& [name, value] : some) words.emplace_back(name == "fingerprint" ? "scene" : name, value);
    for (const auto& row : render::RenderSettings::options())
        if (row.name == "layers") words.emplace_back("layers", core::optionText(row, job.settings));
    return words;
}

}  // namespace grsh
