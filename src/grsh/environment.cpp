#include "grsh/environment.h"

#include "gr/lights/sky_light.h"
#include "image/image_file.h"
#include "image/radiances.h"
#include "materials/textures/texture.h"

#include <algorithm>

namespace grsh {
namespace {

// A picture's texels are the sky's pixels; of what has none there are enough for a third of a degree.
glm::ivec2 sizeOf(const materials::TextureType& texture) {
    return std::visit(
        []<class T>(const T& t) -> glm::ivec2 {
            if constexpr (std::derived_from<T, materials::Picture>) return {t.texels->width, t.texels->height};
            return {1024, 512};
        },
        texture);
}

// Places are u and v of the sky's picture, v upwards, and directions of unit length.
std::shared_ptr<const gr::SkyGrid> skyOf(const materials::Texture& texture, const std::string& name) {
    const glm::ivec2 size = sizeOf(texture.type);
    std::vector<core::Rgbf> radiances;
    radiances.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; y < size.y; ++y) {
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.y);
        for (int x = 0; x < size.x; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.x);
            const core::Vec3f wi = gr::SkyDirection<float>(v, u < 0.5f ? u + 0.5f : u - 0.5f).wi;
            radiances.push_back(texture.at<float>({{u, 1 - v}, wi, wi}));
        }
    }
    if (std::ranges::all_of(radiances, [](const core::Rgbf& c) { return c == core::Rgbf(0); }))
        throw core::Error("VALUE", "BLACK", name, "the texture \"" + name + "\" is a black environment all over");
    return std::make_shared<gr::SkyGrid>(size.x, size.y, std::move(radiances));
}

}  // namespace

std::shared_ptr<const gr::SkyGrid> readEnvironment(const RenderJob& job, const FileAccess& files,
                                                   const gr::Database& database) {
    const std::string& name = job.settings.environment;
    if (name.empty()) return nullptr;
    if (const auto texture = database.findTexture(name)) return skyOf(*texture, name);
    if (!image::hasPictureEnding(name))
        throw core::Error("VALUE", "FILE", name,
                          "environment must be a texture or a picture file, " + image::pictureEndings() + ", not " +
                              grsh::quoted(name) + core::didYouMean(name, database.textureNames()));
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
