#include "render/image_file.h"

#include "core/error.h"
#include "render/image_writers.h"
#include "render/temporary_file.h"

#include <algorithm>
#include <array>

namespace render {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    throw core::Error("FILE", "WRITE", path, "cannot write \"" + path + "\": " + why);
}

// The file that a path means: links are followed, also to what is not there yet, so that the link stays and what it
// names is written.
fs::path resolve(const std::string& path) {
    constexpr int mostLinks = 40;  // as Linux has it
    fs::path target(path);
    std::error_code failed;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, failed)); ++links) {
        if (links == mostLinks) fail(path, std::make_error_code(std::errc::too_many_symbolic_link_levels).message());
        target = target.parent_path() / fs::read_symlink(target, failed);
    }
    const fs::file_status status = fs::status(target, failed);
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "it is not a file");
    if (failed && status.type() != fs::file_type::not_found) fail(path, failed.message());
    return target;
}

struct Format {
    std::string_view ending;
    bool holdsLayers;
    void (*write)(std::FILE*, const Film&, double exposure, const Metadata&);
};

constexpr std::array<Format, 3> formats{{
    {".png", false, writePng},
    {".exr", true, writeExr},
    {".pfm", false, writePfm},
}};

const Format& formatOf(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    std::vector<std::string_view> endings;
    for (const Format& format : formats) {
        if (ending == format.ending) return format;
        endings.push_back(format.ending);
    }
    throw core::Error("FILE", "ENDING", path,
                      "cannot write \"" + path + "\": the file's ending must be " + core::listed(endings));
}

}  // namespace

ImageFile::ImageFile(const std::string& path, std::span<const Layer> layers) : path_(path) {
    const Format& format = formatOf(path);
    if (!layers.empty() && !format.holdsLayers)
        throw core::Error("FILE", "LAYERS", path,
                          "cannot write \"" + path + "\": with layers the file's ending must be .exr");
    target_ = resolve(path);
    // The one sure way to know whether a file can be made in a folder, for every user and every file system.
    TemporaryFile probe(target_, path);
}

void ImageFile::write(const Film& film, double exposure, const Metadata& metadata) const {
    TemporaryFile file(target_, path_);
    try {
        formatOf(path_).write(file.stream(), film, exposure, metadata);
    } catch (const core::Error& error) {
        fail(path_, error.what());
    }
    file.publish();
}

}  // namespace render
