#include "image/exr/exr_header.h"

#include "image/announced.h"
#include "image/primaries.h"

#include <ImfChannelList.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>

namespace image::exr {
namespace {

bool has(const Imf::ChannelList& channels, const char* name) {
    return channels.findChannel(name) != nullptr;
}

bool isHalved(const Imf::Channel* channel) {
    return channel != nullptr && channel->xSampling == 2 && channel->ySampling == 2;
}

Window windowOf(const Imath::Box2i& box) {
    // A difference beyond int is a file's mistake, not ours.
    const auto side = [](std::int64_t from, std::int64_t to) {
        if (to < from || to - from >= 1'000'000) failReading("its size is not from 1 to 1000000 pixels");
        return static_cast<int>(to - from + 1);
    };
    return {box.min.x, box.min.y, side(box.min.x, box.max.x), side(box.min.y, box.max.y)};
}

void checkColours(const Imf::Header& header) {
    if (!Imf::hasChromaticities(header)) return;
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    const Primaries primaries{c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
    if (const auto why = otherThanSrgb(primaries)) failReading(*why);
}

Metadata textsOf(const Imf::Header& header, const std::vector<std::string>& order) {
    Metadata texts;
    for (const std::string& name : order) {
        const auto* text = header.findTypedAttribute<Imf::StringAttribute>(name);
        // The kind of part is the format's own.
        if (text != nullptr && name != "type") texts.emplace_back(name, text->value());
    }
    return texts;
}

void addChannels(const Imf::ChannelList& channels, Image& image) {
    const bool isChroma = hasLuminanceAndChroma(channels);
    const auto add = [&](const std::string& name) { image.channels.push_back({name, std::vector<float>()}); };
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        const std::string name = channel.name();
        if (channel.channel().type == Imf::UINT) failReading("its channel \"" + name + "\" holds whole numbers");
        if (isChroma && (name == "Y" || name == "RY" || name == "BY")) continue;
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            failReading("its channel \"" + name + "\" does not have a number for each pixel");
        if (isChroma && isColour(name)) failReading("it has the channel \"" + name + "\" beside luminance and chroma");
        add(name);
    }
    if (!isChroma) return;
    for (const char* name : {"B", "G", "R"}) add(name);
    std::ranges::sort(image.channels, {}, &ImageChannel::name);
}

// How many times as many bytes a compression may make of some. Deflate stays below 1032, other codes below 514; DWA has
// two bytes of 128 at least before deflate, the flat blocks of B44A 3 of 32.
double mostTimes(Imf::Compression compression) {
    switch (compression) {
        case Imf::NO_COMPRESSION:
            return 1;
        case Imf::B44_COMPRESSION:
        case Imf::B44A_COMPRESSION:
            return 11;
        case Imf::DWAA_COMPRESSION:
        case Imf::DWAB_COMPRESSION:
            return 1 << 17;
        default:
            return 4096;
    }
}

}  // namespace

bool hasLuminanceAndChroma(const Imf::ChannelList& channels) {
    return has(channels, "Y") && isHalved(channels.findChannel("RY")) && isHalved(channels.findChannel("BY"));
}

int partToRead(const Imf::MultiPartInputFile& file) {
    int flat = -1;
    for (int i = 0; i < file.parts(); ++i) {
        const Imf::Header& header = file.header(i);
        if (header.hasType() && Imf::isDeepData(header.type())) continue;
        if (flat < 0) flat = i;
        const Imf::ChannelList& channels = header.channels();
        if ((has(channels, "R") && has(channels, "G") && has(channels, "B")) || has(channels, "Y")) return i;
    }
    if (flat < 0) failReading("it is deep: each of its pixels may have many numbers; only flat pictures are read");
    return flat;
}

Image imageOf(const Imf::Header& header, const std::vector<std::string>& order) {
    Image image;
    image.held = windowOf(header.dataWindow());
    image.whole = windowOf(header.displayWindow());
    image.isPart = image.held != image.whole;
    checkColours(header);
    image.metadata = textsOf(header, order);
    addChannels(header.channels(), image);
    return image;
}

void checkSize(const Imf::Header& header, bool isComplete, std::uint64_t bytes) {
    const Window held = windowOf(header.dataWindow());
    double unpacked = 0;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        const Imf::Channel& c = channel.channel();
        unpacked += (c.type == Imf::HALF ? 2. : 4.) / c.xSampling / c.ySampling * held.width * held.height;
    }
    checkAnnounced(held.width, held.height, unpacked / mostTimes(header.compression()), bytes);
    if (!isComplete) failReading("it is not complete: its table does not say where all of its pixels are");
}

std::string printable(std::string_view message) {
    std::string text(message.substr(0, 300));
    while (text.ends_with('.') || text.ends_with('\n')) text.pop_back();
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    return text.empty() ? "it does not tell why" : text;
}

}  // namespace image::exr
