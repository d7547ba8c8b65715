#include "image/exr/exr_file.h"

#include "image/announced.h"
#include "image/exr/exr_bytes.h"
#include "image/exr/exr_header.h"
#include "image/exr/exr_lines.h"

#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>
#include <ImfThreading.h>
#include <ImfTileDescription.h>

#include <algorithm>
#include <optional>

namespace image::exr {

struct ExrFile::Library {
    explicit Library(std::span<char> bytes) : stream(bytes) {}

    const Imf::Header& header() const { return file->header(number); }
    bool hasEnded() const { return stream.hasEnded() || (chromaStream && chromaStream->hasEnded()); }

    ByteStream stream;
    std::optional<Imf::MultiPartInputFile> file;
    int number = 0;  // of the part that is read
    std::optional<Imf::InputPart> part;
    std::optional<LineReader> lines;  // where they are packed simply
    // Colours of luminance and chroma are put together by the library, which reads the file a second time for that.
    std::optional<ByteStream> chromaStream;
    std::optional<Imf::RgbaInputFile> chroma;
    std::vector<Imf::Rgba> colours;
};

namespace {

// What the library throws becomes the reason why the file is not read.
template<class Library, class Call>
void callLibrary(const Library& library, const Call& call) {
    try {
        call();
    } catch (const core::Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        if (library.hasEnded()) failReading("it ends too early");
        failReading("OpenEXR: " + printable(error.what()));
    }
}

}  // namespace

ExrFile::ExrFile(std::span<char> bytes) : library_(std::make_unique<Library>(bytes)) {
    constexpr std::string_view magic = "\x76\x2f\x31\x01";
    if (!std::string_view(bytes.data(), bytes.size()).starts_with(magic))
        failReading("it is no OpenEXR file: it does not begin with the bytes 76 2F 31 01");
    callLibrary(*library_, [&] { open(bytes); });
}

void ExrFile::open(std::span<char> bytes) {
    Library& library = *library_;
    const std::vector<std::vector<std::string>> names = attributeNames(bytes);
    const Imf::MultiPartInputFile& file = library.file.emplace(library.stream, 0, false);
    library.number = partToRead(file);
    const Imf::Header& header = library.header();
    image_ = imageOf(header, names.at(static_cast<std::size_t>(library.number)));
    image_.partsLeftOut = file.parts() - 1;
    checkSize(header, library.file->partComplete(library.number), bytes.size());
    if (hasLuminanceAndChroma(header.channels()) && library.number != 0)
        failReading("its luminance and chroma are not in its first part");
}

void ExrFile::start(int threads) {
    Library& library = *library_;
    callLibrary(library, [&] {
        // The library settles with the file how many threads work on its parts.
        library.stream.seekg(0);
        library.file.emplace(library.stream, threads, false);
        library.part.emplace(*library.file, library.number);
        if (canReadLines(library.header())) library.lines.emplace(*library.part);
        if (!hasLuminanceAndChroma(library.header().channels())) return;
        library.chromaStream.emplace(library.stream.bytes());
        library.chroma.emplace(*library.chromaStream, threads);
    });
}

ExrFile::~ExrFile() = default;

int ExrFile::linesAtOnce() const {
    // No compression keeps more lines together.
    constexpr int most = 256;
    const Imf::Header& header = library_->header();
    if (!header.hasTileDescription()) return most;
    const int tile = static_cast<int>(header.tileDescription().ySize);
    return std::max(most / tile, 1) * tile;
}

double ExrFile::memory(int threads) const {
    // For each thread the library holds two pieces, each as it was packed, unpacked and put in order; of tiles it holds
    // a row; and there is what was read.
    const double buffers = 3. * std::max(2 * threads, 1) + 3;
    const double lines = std::max(linesAtOnce(), 256);
    return 1.3 * buffers * lines * image_.held.width * sizeof(float) * static_cast<double>(image_.channels.size());
}

void ExrFile::read(int line, int lines, std::vector<std::vector<float>>& channels) {
    Library& library = *library_;
    const std::size_t width = static_cast<std::size_t>(image_.held.width),
                      count = width * static_cast<std::size_t>(lines);
    channels.resize(image_.channels.size());
    const int first = image_.held.top + line, last = first + lines - 1;
    const Imath::Box2i window({image_.held.left, first}, {image_.held.left + image_.held.width - 1, last});
    if (library.lines) {
        for (auto& numbers : channels) numbers.resize(count);
        callLibrary(library, [&] { library.lines->read(first, last, channels); });
        return;
    }
    Imf::FrameBuffer buffer;
    bool isEmpty = true;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c].resize(count);
        const std::string& name = image_.channels[c].name;
        if (library.chroma && isColour(name)) continue;
        buffer.insert(name,
                      Imf::Slice::Make(Imf::FLOAT, channels[c].data(), window, sizeof(float), width * sizeof(float)));
        isEmpty = false;
    }
    callLibrary(library, [&] {
        if (!isEmpty) {
            library.part->setFrameBuffer(buffer);
            library.part->readPixels(first, last);
        }
        if (library.chroma) readColours(line, lines, channels);
    });
}

void ExrFile::readColours(int line, int lines, std::vector<std::vector<float>>& channels) {
    Library& library = *library_;
    const int width = image_.held.width, first = image_.held.top + line;
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(lines);
    library.colours.resize(count);
    // The library wants to know where pixel 0 0 of the whole picture would be.
    const std::ptrdiff_t origin = static_cast<std::ptrdiff_t>(first) * width + image_.held.left;
    library.chroma->setFrameBuffer(library.colours.data() - origin, 1, static_cast<std::size_t>(width));
    library.chroma->readPixels(first, first + lines - 1);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const std::string& name = image_.channels[c].name;
        if (!isColour(name)) continue;
        const half Imf::Rgba::*const part = name == "R" ? &Imf::Rgba::r : name == "G" ? &Imf::Rgba::g : &Imf::Rgba::b;
        for (std::size_t i = 0; i < count; ++i) channels[c][i] = library.colours[i].*part;
    }
}

}  // namespace image::exr
