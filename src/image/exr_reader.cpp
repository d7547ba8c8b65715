#include "core/reader_process.h"
#include "image/announced.h"
#include "image/exr_message.h"
#include "image/image_readers.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace image {
namespace {

core::ReaderWork workOn(std::FILE* file) {
    core::ReaderWork work{
        .program = "grsh_exr", .name = "reader of OpenEXR files", .words = {}, .inputs = {fileno(file)}};
    struct stat status;
    if (fstat(work.inputs[0], &status) != 0) failReading(std::strerror(errno));
    // It asks for no more than what its header says; and it unpacks 50 MB a second or more, 100 times the file at most
    // but for pictures that are all alike.
    const double megabytes = static_cast<double>(status.st_size) / 1e6;
    work.megabytes = 1e9;
    work.seconds = 20 + 20 * megabytes;
    return work;
}

std::string readText(core::ReaderProcess& reader) {
    std::uint32_t length = 0;
    reader.read(&length, sizeof length);
    std::string text(length, ' ');
    reader.read(text.data(), text.size());
    return text;
}

// All but the numbers.
Image readHeader(core::ReaderProcess& reader, const ExrMessage& message) {
    Image image;
    image.held = message.held;
    image.whole = message.whole;
    image.isPart = image.held != image.whole;
    image.partsLeftOut = message.partsLeftOut;
    for (std::uint32_t i = 0; i < message.channels; ++i)
        image.channels.push_back({readText(reader), std::vector<float>()});
    for (std::uint32_t i = 0; i < message.texts; ++i) {
        std::string name = readText(reader);
        image.metadata.emplace_back(std::move(name), readText(reader));
    }
    return image;
}

}  // namespace

Image readExr(std::FILE* file) {
    core::ReaderProcess reader(workOn(file));
    reader.readOutcome();
    ExrMessage message;
    reader.read(&message, sizeof message);
    Image image = readHeader(reader, message);
    checkMemory(image.held, static_cast<double>(image.channels.size() * sizeof(float)));
    for (ImageChannel& channel : image.channels) channel.samples = std::vector<float>(image.pixels());
    const std::size_t width = static_cast<std::size_t>(image.held.width);
    for (int line = 0; line < image.held.height; line += message.linesAtOnce) {
        reader.readOutcome();
        const int lines = std::min(message.linesAtOnce, image.held.height - line);
        for (ImageChannel& channel : image.channels) {
            auto& numbers = std::get<std::vector<float>>(channel.samples);
            reader.read(&numbers[static_cast<std::size_t>(line) * width],
                        static_cast<std::size_t>(lines) * width * sizeof(float));
        }
    }
    return image;
}

}  // namespace image
