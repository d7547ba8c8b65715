#include "core/error.h"
#include "image/image_writers.h"

#include <openexr.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace image {
namespace {

// Where the library writes to, and what went wrong there. It is C: nothing may be thrown through it.
struct Stream {
    std::FILE* file;
    std::string failure;
};

int64_t writeBytes(exr_const_context_t, void* userData, const void* bytes, std::uint64_t size, std::uint64_t offset,
                   exr_stream_error_func_ptr_t) {
    auto& stream = *static_cast<Stream*>(userData);
    const bool written = fseeko(stream.file, static_cast<off_t>(offset), SEEK_SET) == 0 &&
                         std::fwrite(bytes, 1, size, stream.file) == size;
    if (written) return static_cast<int64_t>(size);
    stream.failure = std::strerror(errno);
    return -1;
}

// The library may hold a context's lock while it tells of an error: asking the context for its stream would wait for
// ever.
thread_local Stream* written = nullptr;

void keepMessage(exr_const_context_t, exr_result_t, const char* message) {
    if (written != nullptr && written->failure.empty()) written->failure = std::string("OpenEXR: ") + message;
}

// A channel: its numbers of a line lie `stride` floats apart, lines follow each other.
struct Channel {
    std::string name;
    const float* firstLine;
    int stride;
};

struct Picture {
    Window held, whole;
    std::vector<Channel> channels;
};

Picture pictureOf(const Film& film) {
    std::vector<Channel> channels;
    const Window& held = film.held();
    const float* radiance = &film.at(held.left, held.top).x;
    for (const char* name : {"R", "G", "B"}) channels.push_back({name, radiance++, 3});
    for (std::size_t i = 0; i < layerCount; ++i) {
        const auto layer = static_cast<Layer>(i);
        const std::span<const float> numbers = film.at(layer, held.left, held.top);
        for (std::size_t c = 0; c < numbers.size(); ++c)
            channels.push_back({std::string(channelsOf(layer)[c]), &numbers[c], static_cast<int>(numbers.size())});
    }
    return {held, {0, 0, film.width(), film.height()}, channels};
}

Picture pictureOf(const Image& image) {
    Picture picture{image.held, image.whole, {}};
    for (const ImageChannel& channel : image.channels)
        picture.channels.push_back({channel.name, std::get<std::vector<float>>(channel.samples).data(), 1});
    return picture;
}

exr_attr_box2i_t boxOf(const Window& window) {
    return {{window.left, window.top}, {window.left + window.width - 1, window.top + window.height - 1}};
}

class ExrWriter {
public:
    explicit ExrWriter(std::FILE* file) : stream_{file, ""} {
        written = &stream_;
        exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
        start.user_data = &stream_;
        start.write_fn = writeBytes;
        start.error_handler_fn = keepMessage;
        check(exr_start_write(&context_, "picture", EXR_WRITE_FILE_DIRECTLY, &start));
    }
    ~ExrWriter() {
        exr_finish(&context_);
        written = nullptr;
    }
    ExrWriter(const ExrWriter&) = delete;
    ExrWriter& operator=(const ExrWriter&) = delete;

    void write(const Picture& picture, const Metadata& metadata) {
        writeHeader(picture, metadata);
        writeChunks(picture);
        // The table of where the chunks are.
        check(exr_finish(&context_));
    }

private:
    static constexpr int part = 0;

    void writeHeader(const Picture& picture, const Metadata& metadata) {
        allowLongNames(picture, metadata);
        int added = part;
        check(exr_add_part(context_, nullptr, EXR_STORAGE_SCANLINE, &added));
        const exr_attr_box2i_t whole = boxOf(picture.whole), held = boxOf(picture.held);
        const exr_attr_v2f_t centre{0, 0};
        check(exr_initialize_required_attr(context_, part, &whole, &held, 1, &centre, 1, EXR_LINEORDER_INCREASING_Y,
                                           EXR_COMPRESSION_ZIP));
        for (const Channel& channel : picture.channels)
            check(exr_add_channel(context_, part, channel.name.c_str(), EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC,
                                  1, 1));
        // The primaries and the white of sRGB (ITU-R BT.709).
        const exr_attr_chromaticities_t srgb{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
        check(exr_attr_set_chromaticities(context_, part, "chromaticities", &srgb));
        for (const auto& [name, value] : metadata)
            check(exr_attr_set_string(context_, part, name.c_str(), value.c_str()));
        check(exr_write_header(context_));
    }

    // Names of more than 31 letters take a mark in the file, which old programs do not know.
    void allowLongNames(const Picture& picture, const Metadata& metadata) {
        constexpr std::size_t shortest = 32, longest = 255;
        std::size_t length = 0;
        const auto look = [&](const std::string& name) {
            if (name.size() > longest)
                throw core::Error("FILE", "WRITE", "",
                                  "the name \"" + name.substr(0, 31) + "...\" has more than 255 letters");
            length = std::max(length, name.size());
        };
        for (const Channel& channel : picture.channels) look(channel.name);
        for (const auto& [name, value] : metadata) look(name);
        if (length >= shortest) check(exr_set_longname_support(context_, 1));
    }

    struct Encoder {
        explicit Encoder(exr_context_t context) : context(context) {}
        ~Encoder() { exr_encoding_destroy(context, &pipeline); }
        Encoder(const Encoder&) = delete;
        Encoder& operator=(const Encoder&) = delete;

        exr_context_t context;
        exr_encode_pipeline_t pipeline = EXR_ENCODE_PIPELINE_INITIALIZER;
    };

    void writeChunks(const Picture& picture) {
        int linesPerChunk = 0;
        check(exr_get_scanlines_per_chunk(context_, part, &linesPerChunk));
        Encoder encoder(context_);
        for (int line = 0; line < picture.held.height; line += linesPerChunk)
            writeChunk(picture, line, encoder.pipeline);
    }

    // line: the chunk's first, counted in what is held.
    void writeChunk(const Picture& picture, int line, exr_encode_pipeline_t& encoder) {
        exr_chunk_info_t chunk;
        check(exr_write_scanline_chunk_info(context_, part, picture.held.top + line, &chunk));
        check(line == 0 ? exr_encoding_initialize(context_, part, &chunk, &encoder)
                        : exr_encoding_update(context_, part, &chunk, &encoder));
        for (int i = 0; i < encoder.channel_count; ++i) {
            exr_coding_channel_info_t& to = encoder.channels[i];
            const auto from = std::find_if(picture.channels.begin(), picture.channels.end(),
                                           [&](const Channel& channel) { return channel.name == to.channel_name; });
            const std::size_t lineSize =
                static_cast<std::size_t>(picture.held.width) * static_cast<std::size_t>(from->stride);
            const float* numbers = from->firstLine + static_cast<std::size_t>(line) * lineSize;
            to.user_pixel_stride = from->stride * static_cast<int>(sizeof(float));
            to.user_line_stride = picture.held.width * to.user_pixel_stride;
            to.encode_from_ptr = reinterpret_cast<const std::uint8_t*>(numbers);
        }
        if (line == 0) check(exr_encoding_choose_default_routines(context_, part, &encoder));
        check(exr_encoding_run(context_, part, &encoder));
    }

    void check(exr_result_t result) {
        if (result == EXR_ERR_SUCCESS) return;
        if (stream_.failure.empty()) stream_.failure = exr_get_default_error_message(result);
        throw core::Error("FILE", "WRITE", "", stream_.failure);
    }

    Stream stream_;
    exr_context_t context_ = nullptr;
};

}  // namespace

void writeExr(std::FILE* file, const Film& film, const ViewTransform&, const Metadata& metadata) {
    ExrWriter(file).write(pictureOf(film), metadata);
}

void writeExr(std::FILE* file, const Image& image) {
    ExrWriter(file).write(pictureOf(image), image.metadata);
}

}  // namespace image
