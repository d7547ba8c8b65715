#include "grsh/rescue.h"

#include "core/error.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

namespace grsh {
namespace {

namespace fs = std::filesystem;

// A name of which there is no file yet.
fs::path freeName(const fs::path& folder, const fs::path& name) {
    std::error_code failed;
    for (int number = 1;; ++number) {
        const std::string suffix = number == 1 ? ".rescued" : ".rescued-" + std::to_string(number);
        const fs::path path = folder / (name.stem().string() + suffix + name.extension().string());
        if (!fs::exists(fs::symlink_status(path, failed))) return path;
    }
}

std::optional<std::string> rescued(const FileAccess& files, const RenderJob& job, const image::Film& film,
                                   const image::Metadata& metadata) {
    std::vector<fs::path> folders{"."};
    if (const char* temporary = std::getenv("TMPDIR"); temporary != nullptr) folders.emplace_back(temporary);
    folders.emplace_back("/tmp");
    for (const fs::path& folder : folders) {
        try {
            const fs::path place = freeName(folder, fs::path(job.file).filename());
            image::ImageFile(files.toWrite(place.string()), job.layers()).write(film, job.viewTransform(), metadata);
            return place.string();
        } catch (const core::Error&) {
        }
    }
    return std::nullopt;
}

}  // namespace

void writeOrRescue(const image::ImageFile& file, const FileAccess& files, const RenderJob& job, const image::Film& film,
                   const image::Metadata& metadata) {
    try {
        file.write(film, job.viewTransform(), metadata);
    } catch (const core::Error& error) {
        const std::optional<std::string> place = rescued(files, job, film, metadata);
        if (!place) throw;
        throw core::Error(error.topic, error.reason, error.word,
                          std::string(error.what()) + "; the picture is in \"" + *place + "\"");
    }
}

}  // namespace grsh
