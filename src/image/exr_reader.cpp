#include "core/error.h"
#include "image/image_readers.h"

#include <openexr.h>

#include <sys/stat.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace image {
namespace {

[[noreturn]] void fail(const std::string& why) {
    throw core::Error("FILE", "READ", "", why);
}

// Where the library reads from, and what it says is wrong there. It is C: nothing may be thrown through it.
struct Stream {
    std::FILE* file;
    std::string failure;
};

int64_t readBytes(exr_const_context_t, void* userData, void* bytes, std::uint64_t size, std::uint64_t offset,
                  exr_stream_error_func_ptr_t) {
    const auto& stream = *static_cast<Stream*>(userData);
    if (fseeko(stream.file, static_cast<off_t>(offset), SEEK_SET) != 0) return -1;
    return static_cast<int64_t>(std::fread(bytes, 1, size, stream.file));
}

int64_t sizeOf(exr_const_context_t, void* userData) {
    struct stat status;
    return fstat(fileno(static_cast<Stream*>(userData)->file), &status) == 0 ? status.st_size : -1;
}

void keepMessage(exr_const_context_t context, exr_result_t, const char* message) {
    void* userData = nullptr;
    if (exr_get_user_data(context, &userData) != EXR_ERR_SUCCESS || userData == nullptr) return;
    auto& stream = *static_cast<Stream*>(userData);
    if (stream.failure.empty()) stream.failure = message;
}

Window windowOf(const exr_attr_box2i_t& box) {
    // A sum beyond int is a file's mistake, not ours.
    const auto side = [](int64_t from, int64_t to) {
        if (to < from || to - from >= 1'000'000) fail("its size is not from 1 to 1000000 pixels");
        return static_cast<int>(to - from + 1);
    };
    return {box.min.x, box.min.y, side(box.min.x, box.max.x), side(box.min.y, box.max.y)};
}

class ExrReader {
public:
    explicit ExrReader(std::FILE* file) : stream_{file, ""} {
        exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
        start.user_data = &stream_;
        start.read_fn = readBytes;
        start.size_fn = sizeOf;
        start.error_handler_fn = keepMessage;
        check(exr_start_read(&context_, "picture", &start));
    }
    ~ExrReader() { exr_finish(&context_); }
    ExrReader(const ExrReader&) = delete;
    ExrReader& operator=(const ExrReader&) = delete;

    Image read() {
        int parts = 0;
        check(exr_get_count(context_, &parts));
        if (parts != 1) fail("it has " + std::to_string(parts) + " parts; only one is read");
        exr_storage_t storage{};
        check(exr_get_storage(context_, part, &storage));
        if (storage != EXR_STORAGE_SCANLINE) fail("it is tiled or deep; only lines are read");
        Image image;
        readPlace(image);
        readAttributes(image);
        makeChannels(image);
        readChunks(image);
        return image;
    }

private:
    static constexpr int part = 0;

    void readPlace(Image& image) {
        exr_attr_box2i_t data, display;
        check(exr_get_data_window(context_, part, &data));
        check(exr_get_display_window(context_, part, &display));
        image.held = windowOf(data);
        image.whole = windowOf(display);
        image.isPart = image.held != image.whole;
    }

    void readAttributes(Image& image) {
        std::int32_t count = 0;
        check(exr_get_attribute_count(context_, part, &count));
        for (std::int32_t i = 0; i < count; ++i) {
            const exr_attribute_t* attribute = nullptr;
            check(exr_get_attribute_by_index(context_, part, EXR_ATTR_LIST_FILE_ORDER, i, &attribute));
            const std::string_view name = attribute->name;
            if (attribute->type == EXR_ATTR_CHROMATICITIES) checkColours(*attribute->chromaticities);
            // The kind of part is the format's own.
            if (attribute->type == EXR_ATTR_STRING && name != "type")
                image.metadata.emplace_back(
                    name, std::string(attribute->string->str, static_cast<std::size_t>(attribute->string->length)));
        }
    }

    static void checkColours(const exr_attr_chromaticities_t& c) {
        const std::array<float, 8> is{c.red_x, c.red_y, c.green_x, c.green_y, c.blue_x, c.blue_y, c.white_x, c.white_y};
        const std::array<float, 8> srgb{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
        for (std::size_t i = 0; i < is.size(); ++i)
            if (!(std::abs(is[i] - srgb[i]) < 0.001f)) fail("its primaries are other than those of sRGB");
    }

    void makeChannels(Image& image) {
        const exr_attr_chlist_t* list = nullptr;
        check(exr_get_channels(context_, part, &list));
        checkMemory(image.held, static_cast<double>(list->num_channels) * sizeof(float));
        for (int i = 0; i < list->num_channels; ++i) {
            const exr_attr_chlist_entry_t& channel = list->entries[i];
            const std::string name(channel.name.str, static_cast<std::size_t>(channel.name.length));
            if (channel.pixel_type == EXR_PIXEL_UINT) fail("its channel \"" + name + "\" holds whole numbers");
            if (channel.x_sampling != 1 || channel.y_sampling != 1)
                fail("its channel \"" + name + "\" does not have a number for each pixel");
            image.channels.push_back({name, std::vector<float>(image.pixels())});
        }
    }

    struct Decoder {
        explicit Decoder(exr_context_t context) : context(context) {}
        ~Decoder() { exr_decoding_destroy(context, &pipeline); }
        Decoder(const Decoder&) = delete;
        Decoder& operator=(const Decoder&) = delete;

        exr_context_t context;
        exr_decode_pipeline_t pipeline = EXR_DECODE_PIPELINE_INITIALIZER;
    };

    void readChunks(Image& image) {
        int linesPerChunk = 0;
        check(exr_get_scanlines_per_chunk(context_, part, &linesPerChunk));
        Decoder decoder(context_);
        for (int line = 0; line < image.held.height; line += linesPerChunk) readChunk(image, line, decoder.pipeline);
    }

    // line: the chunk's first, counted in what the file holds.
    void readChunk(Image& image, int line, exr_decode_pipeline_t& decoder) {
        exr_chunk_info_t chunk;
        check(exr_read_scanline_chunk_info(context_, part, image.held.top + line, &chunk));
        check(line == 0 ? exr_decoding_initialize(context_, part, &chunk, &decoder)
                        : exr_decoding_update(context_, part, &chunk, &decoder));
        const std::size_t width = static_cast<std::size_t>(image.held.width);
        for (int i = 0; i < decoder.channel_count; ++i) {
            auto& samples = std::get<std::vector<float>>(image.channels[static_cast<std::size_t>(i)].samples);
            exr_coding_channel_info_t& to = decoder.channels[i];
            to.decode_to_ptr = reinterpret_cast<std::uint8_t*>(&samples[static_cast<std::size_t>(line) * width]);
            to.user_pixel_stride = sizeof(float);
            to.user_line_stride = static_cast<std::int32_t>(width * sizeof(float));
            to.user_bytes_per_element = sizeof(float);
            to.user_data_type = EXR_PIXEL_FLOAT;
        }
        if (line == 0) check(exr_decoding_choose_default_routines(context_, part, &decoder));
        check(exr_decoding_run(context_, part, &decoder));
    }

    void check(exr_result_t result) {
        if (result == EXR_ERR_SUCCESS) return;
        if (stream_.failure.empty()) stream_.failure = exr_get_default_error_message(result);
        fail("OpenEXR: " + stream_.failure);
    }

    Stream stream_;
    exr_context_t context_ = nullptr;
};

}  // namespace

Image readExr(std::FILE* file) {
    return ExrReader(file).read();
}

}  // namespace image
