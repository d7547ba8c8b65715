#include "grsh/environment.h"

#include "image/image_file.h"
#include "image/radiances.h"

namespace grsh {

std::shared_ptr<const gr::SkyGrid> readEnvironment(const RenderJob& job, const FileAccess& files) {
    const std::string& name = job.settings.environment;
    if (name.empty()) return nullptr;
    if (!image::hasPictureEnding(name))
        throw core::Error(
            "VALUE", "FILE", name,
            "environment must be a picture file, " + image::pictureEndings() + ", not " + grsh::quoted(name));
    const image::Image picture = image::readImage(files.toRead(job.settings.environmentPath, name));
    const int width = picture.held.width, height = picture.held.height;
    constexpr int most = gr::SkyGrid::mostSide;
    if (width > most || height > most || picture.pixels() > gr::SkyGrid::mostPixels)
        throw core::Error("VALUE", "RANGE", name,
                          "the environment \"" + name + "\" must have at most " + std::to_string(most) +
                              " pixels a side and " + std::to_string(gr::SkyGrid::mostPixels) + " in all, not " +
                              std::to_string(width) + " x " + std::to_string(height));
    std::vector<core::Rgbf> radiances = image::radiancesOf(picture, name, gr::SkyGrid::mostRadiance);
    return std::make_shared<gr::SkyGrid>(width, height, std::move(radiances));
}

void checkEnvironment(const render::RenderSettings& settings) {
    if (settings.environment.empty() || settings.background == core::Rgbf(0)) return;
    throw core::Error("OPTION", "CONFLICT", "environment",
                      "environment " + grsh::quoted(settings.environment) + " and background {" +
                          core::optionText(settings.background) +
                          "} cannot be given together: either is all that lies around the scene");
}

}  // namespace grsh
