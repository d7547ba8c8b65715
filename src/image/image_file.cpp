#include "image/image_file.h"

#include "core/error.h"
#include "image/image_readers.h"
#include "image/image_writers.h"
#include "image/temporary_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

namespace image {
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

// Also for who may write everything.
bool isReadOnly(const fs::path& target) {
    struct stat there;
    if (stat(target.c_str(), &there) != 0) return false;
    constexpr mode_t anyWrite = S_IWUSR | S_IWGRP | S_IWOTH;
    return (there.st_mode & anyWrite) == 0 || access(target.c_str(), W_OK) != 0;
}

struct Format {
    std::string_view ending;
    bool holdsLayers, holdsFloats;
    Image (*read)(std::FILE*);
    // Null: it is only read.
    void (*writeFilm)(std::FILE*, const Film&, const ViewTransform&, const Metadata&) = nullptr;
    void (*writeImage)(std::FILE*, const Image&) = nullptr;
};

constexpr std::array<Format, 5> formats{{
    {".png", false, false, readPng, writePng, writePng},
    {".exr", true, true, readExr, writeExr, writeExr},
    {".pfm", false, true, readPfm, writePfm, writePfm},
    {".hdr", false, true, readHdr},
    {".pic", false, true, readHdr},
}};

std::string endingOf(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

// verb: what is to be done to files with them, "read" or "write".
std::string endingsFor(std::string_view verb) {
    std::vector<std::string_view> endings;
    for (const Format& format : formats)
        if (verb == "read" || format.writeImage != nullptr) endings.push_back(format.ending);
    return core::listed(endings);
}

const Format* findFormat(const std::string& path) {
    const auto found = std::ranges::find(formats, endingOf(path), &Format::ending);
    return found == formats.end() ? nullptr : &*found;
}

// verb: what is to be done to the file.
const Format& formatOf(const std::string& path, std::string_view verb) {
    const Format* format = findFormat(path);
    if (format != nullptr && (verb == "read" || format->writeImage != nullptr)) return *format;
    throw core::Error(
        "FILE", "ENDING", path,
        "cannot " + std::string(verb) + " \"" + path + "\": the file's ending must be " + endingsFor(verb));
}

}  // namespace

void checkEndingToWrite(const std::string& name) {
    formatOf(name, "write");
}

bool hasPictureEnding(const std::string& name) {
    return findFormat(name) != nullptr;
}

std::string pictureEndings() {
    return endingsFor("read");
}

ImageFile::ImageFile(const FileName& file, std::span<const Layer> layers) : file_(file) {
    const std::string& name = file.name;
    const Format& format = formatOf(name, "write");
    if (!layers.empty() && !format.holdsLayers)
        throw core::Error("FILE", "LAYERS", name,
                          "cannot write \"" + name + "\": with layers the file's ending must be .exr");
    target_ = file.open ? fs::path(file.path) : resolve(name);
    if (isReadOnly(target_)) fail(name, "it is read-only");
    removeAbandonedFiles(target_.parent_path());
    // The one sure way to know whether a file can be made in a folder, for every user and every file system.
    TemporaryFile probe(target_, name);
}

template<class Write>
void ImageFile::writeWith(const Write& write) const {
    TemporaryFile file(target_, file_.name);
    try {
        write(formatOf(file_.name, "write"), file.stream());
    } catch (const core::Error& error) {
        fail(file_.name, error.what());
    }
    file.publish();
}

void ImageFile::write(const Film& film, const ViewTransform& view, const Metadata& metadata) const {
    writeWith([&](const Format& format, std::FILE* file) { format.writeFilm(file, film, view, metadata); });
}

void ImageFile::write(const Image& image) const {
    if (image.partsLeftOut > 0)
        fail(file_.name, "what it is made from has " + std::to_string(image.partsLeftOut + 1) +
                             " parts, of which all but one would be lost");
    writeWith([&](const Format& format, std::FILE* file) { format.writeImage(file, image); });
}

void ImageFile::checkIsNot(const FileName& input) const {
    std::error_code failed;
    if (fs::equivalent(target_, input.path, failed))
        throw core::Error("FILE", "SAME", file_.name,
                          "cannot write \"" + file_.name + "\": it is the same file as \"" + input.name + "\"");
}

void ImageFile::checkAgainst(const FileName& input) const {
    checkIsNot(input);
    const Format& from = formatOf(input.name, "read");
    const auto refuse = [&](const std::string& why) {
        throw core::Error("FILE", "ENDING", file_.name,
                          "cannot write \"" + file_.name + "\": its ending must be " + why);
    };
    if (from.writeImage == nullptr) {
        if (!formatOf(file_.name, "write").holdsFloats)
            refuse(".exr or .pfm, as \"" + input.name + "\" has floats and its format is not written");
    } else if (endingOf(file_.name) != from.ending) {
        refuse(endingOf(input.name) + ", that of \"" + input.name + "\"");
    }
}

Image readImage(const FileName& from) {
    const auto refuse = [&](const std::string& why) {
        throw core::Error("FILE", "READ", from.name, "cannot read \"" + from.name + "\": " + why);
    };
    const Format& format = formatOf(from.name, "read");
    std::error_code failed;
    const fs::file_status status = fs::status(from.path, failed);
    if (fs::exists(status) && !fs::is_regular_file(status)) refuse("it is not a file");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(from.path.c_str(), "rb"), std::fclose);
    if (file == nullptr) refuse(std::strerror(errno));
    try {
        return format.read(file.get());
    } catch (const core::Error& error) {
        throw core::Error(error.topic, error.reason, from.name, "cannot read \"" + from.name + "\": " + error.what());
    }
}

}  // namespace image
