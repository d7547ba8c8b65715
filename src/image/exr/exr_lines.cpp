#include "image/exr/exr_lines.h"

#include "image/announced.h"

#include <ImfChannelList.h>
#include <half.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

namespace image::exr {
namespace {

// How many lines are packed together.
int linesOf(Imf::Compression compression) {
    return compression == Imf::ZIP_COMPRESSION ? 16 : 1;
}

// Each byte is the difference from the one before it, 128 being none.
void addUp(std::vector<char>& bytes) {
    unsigned sum = 128;
    for (char& byte : bytes) {
        sum += static_cast<unsigned char>(byte) - 128u;
        byte = static_cast<char>(sum);
    }
}

// Of each two bytes the first ones come before all second ones.
void interleave(const std::vector<char>& from, std::vector<char>& to) {
    const std::size_t half = (from.size() + 1) / 2;
    for (std::size_t i = 0; i < from.size() / 2; ++i) {
        to[2 * i] = from[i];
        to[2 * i + 1] = from[half + i];
    }
    if (from.size() % 2 == 1) to.back() = from[half - 1];
}

void copyNumbers(const char* from, Imf::PixelType type, std::span<float> to) {
    static_assert(std::endian::native == std::endian::little);
    if (type == Imf::FLOAT) {
        std::memcpy(to.data(), from, to.size_bytes());
        return;
    }
    for (float& number : to) {
        half part;
        std::memcpy(&part, from, sizeof part);
        number = part;
        from += sizeof part;
    }
}

}  // namespace

bool canReadLines(const Imf::Header& header) {
    const Imf::Compression compression = header.compression();
    const bool isSimple = compression == Imf::NO_COMPRESSION || compression == Imf::ZIPS_COMPRESSION ||
                          compression == Imf::ZIP_COMPRESSION;
    if (!isSimple || header.hasTileDescription()) return false;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
        if (channel.channel().type == Imf::UINT || channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            return false;
    return true;
}

LineReader::LineReader(Imf::InputPart& part) : part_(part) {
    const Imath::Box2i window = part.header().dataWindow();
    width_ = static_cast<std::size_t>(window.max.x - window.min.x) + 1;
    const Imf::ChannelList& channels = part.header().channels();
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        types_.push_back(channel.channel().type);
        bytesPerLine_ += width_ * (types_.back() == Imf::HALF ? sizeof(half) : sizeof(float));
    }
}

void LineReader::read(int first, int last, std::vector<std::vector<float>>& channels) {
    const int together = linesOf(part_.header().compression());
    for (int line = first; line <= last; line += together) {
        const int lines = std::min(together, last - line + 1);
        const char* packed = nullptr;
        int size = 0;
        part_.rawPixelData(line, packed, size);
        if (size < 0) failReading("a piece of it has less than no bytes");
        const auto start = static_cast<std::size_t>(line - first) * width_;
        const char* at =
            unpack({packed, static_cast<std::size_t>(size)}, bytesPerLine_ * static_cast<std::size_t>(lines)).data();
        for (std::size_t y = 0; y < static_cast<std::size_t>(lines); ++y) {
            for (std::size_t c = 0; c < types_.size(); ++c) {
                copyNumbers(at, types_[c], std::span(channels[c]).subspan(start + y * width_, width_));
                at += width_ * (types_[c] == Imf::HALF ? sizeof(half) : sizeof(float));
            }
        }
    }
}

// What would not get smaller is not packed.
std::span<const char> LineReader::unpack(std::span<const char> packed, std::size_t size) {
    if (packed.size() == size) return packed;
    inflated_.resize(size);
    ordered_.resize(size);
    uLongf count = size;
    const int result = part_.header().compression() == Imf::NO_COMPRESSION
                           ? Z_DATA_ERROR
                           : uncompress(reinterpret_cast<Bytef*>(inflated_.data()), &count,
                                        reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (result != Z_OK || count != size) failReading("a piece of it cannot be unpacked: it is damaged");
    addUp(inflated_);
    interleave(inflated_, ordered_);
    return ordered_;
}

}  // namespace image::exr
