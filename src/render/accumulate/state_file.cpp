#include "render/accumulate/state_file.h"

#include "core/error.h"
#include "core/parallel.h"
#include "image/temporary_file.h"
#include "render/accumulate/byte_planes.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <memory>

namespace render {
namespace {

constexpr std::string_view magic = "grsh state 1\n";
constexpr std::size_t tilesInABlock = 64;

[[noreturn]] void damaged() {
    throw core::Error("STATE", "DAMAGED", "", "it is damaged");
}

// Whole numbers and texts one behind the other.
class Writer {
public:
    void add(std::uint64_t number) {
        for (int byte = 0; byte < 8; ++byte) bytes.push_back(static_cast<char>(number >> (8 * byte)));
    }
    void add(const std::string& text) {
        add(std::uint64_t{text.size()});
        bytes += text;
    }

    std::string bytes;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    std::uint64_t number() {
        std::uint64_t number = 0;
        const std::string_view eight = take(8);
        for (int byte = 0; byte < 8; ++byte)
            number |= static_cast<std::uint64_t>(static_cast<unsigned char>(eight[static_cast<std::size_t>(byte)]))
                      << (8 * byte);
        return number;
    }
    std::string_view text() { return take(number()); }
    bool isOver() const { return bytes_.empty(); }

private:
    std::string_view take(std::uint64_t count) {
        if (count > bytes_.size()) damaged();
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }

    std::string_view bytes_;
};

// Whatever has numbers in it, one after the other: the same way for both directions.
template<class F>
void forEachCount(RayCounts& rays, const F& f) {
    for (std::uint64_t* count : {&rays.camera, &rays.shadow, &rays.diffuse, &rays.reflective, &rays.refractive,
                                 &rays.traversal.tests, &rays.traversal.cells})
        f(*count);
}

void addNoise(Writer& writer, const NoiseSteps& noise) {
    writer.add(std::uint64_t{noise.doublings.size()});
    const auto add = [&](const NoiseStep& step) {
        writer.add(step.moved.text());
        writer.add(step.squares.text());
    };
    add(noise.rest);
    for (const NoiseStep& step : noise.doublings) add(step);
}

NoiseSteps readNoise(Reader& reader) {
    const std::uint64_t doublings = reader.number();
    const auto sum = [&] {
        const std::string_view text = reader.text();
        if (text.empty()) return core::AnyOrderSum{};
        const auto read = core::AnyOrderSum::fromText(text);
        if (!read) damaged();
        return *read;
    };
    const auto step = [&] {
        NoiseStep read;
        read.moved = sum();
        read.squares = sum();
        return read;
    };
    NoiseSteps noise;
    noise.rest = step();
    for (std::uint64_t i = 0; i < doublings; ++i) noise.doublings.push_back(step());
    return noise;
}

// The pixels of some tiles. A sum is told by how its digits differ from the neighbour's, and the mean at the last power
// of two by how they differ from the mean of today.
std::string packed(const std::vector<Tile>& tiles, std::size_t first, std::size_t end) {
    std::vector<std::uint64_t> sums[3];
    std::vector<std::uint32_t> left, before[3];
    std::vector<std::uint64_t> layers[PixelLayers::numberCount];
    for (std::size_t i = first; i < end; ++i) {
        const Tile& tile = tiles[i];
        if (tile.samples == 0) continue;
        for (const PixelSum& pixel : tile.pixels) {
            left.push_back(static_cast<std::uint32_t>(tile.samples - pixel.kept));
            const core::Rgbf mean = pixel.mean();
            for (int c = 0; c < 3; ++c) {
                sums[c].push_back(std::bit_cast<std::uint64_t>(pixel.sum[c]));
                before[c].push_back(std::bit_cast<std::uint32_t>(pixel.before[c]) -
                                    std::bit_cast<std::uint32_t>(mean[c]));
            }
        }
        for (PixelLayers pixel : tile.layers) {
            std::size_t number = 0;
            pixel.forEachNumber([&](double& x) { layers[number++].push_back(std::bit_cast<std::uint64_t>(x)); });
        }
    }
    PlanePacker packer;
    packer.add(left);
    for (auto& channel : sums) packer.add(channel);
    // A small number of either sign has the same upper bytes once the sign is its last bit.
    for (auto& channel : before) {
        for (std::uint32_t& x : channel) x = x << 1 ^ (x >> 31 != 0 ? ~std::uint32_t{0} : 0);
        packer.add(channel);
    }
    for (const auto& number : layers) packer.add(number);
    return packer.packed();
}

void unpack(std::string_view bytes, std::vector<Tile>& tiles, std::size_t first, std::size_t end) {
    std::size_t pixels = 0, withLayers = 0;
    for (std::size_t i = first; i < end; ++i) {
        if (tiles[i].samples > 0) tiles[i].begin();
        pixels += tiles[i].pixels.size();
        withLayers += tiles[i].layers.size();
    }
    PlaneReader reader(bytes, pixels * (4 + 3 * 8 + 3 * 4) + withLayers * PixelLayers::numberCount * 8);
    const auto left = reader.next<std::uint32_t>(pixels);
    std::vector<std::uint64_t> sums[3], layers[PixelLayers::numberCount];
    std::vector<std::uint32_t> before[3];
    for (auto& channel : sums) channel = reader.next<std::uint64_t>(pixels);
    for (auto& channel : before) channel = reader.next<std::uint32_t>(pixels);
    for (auto& number : layers) number = reader.next<std::uint64_t>(withLayers);
    std::size_t at = 0, layersAt = 0;
    for (std::size_t i = first; i < end; ++i) {
        for (PixelSum& pixel : tiles[i].pixels) {
            pixel.kept = tiles[i].samples - static_cast<int>(left[at]);
            for (int c = 0; c < 3; ++c) pixel.sum[c] = std::bit_cast<double>(sums[c][at]);
            const core::Rgbf mean = pixel.mean();
            for (int c = 0; c < 3; ++c) {
                const std::uint32_t x = before[c][at], way = x >> 1 ^ ((x & 1) != 0 ? ~std::uint32_t{0} : 0);
                pixel.before[c] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(mean[c]) + way);
            }
            ++at;
        }
        for (PixelLayers& pixel : tiles[i].layers) {
            std::size_t number = 0;
            pixel.forEachNumber([&](double& x) { x = std::bit_cast<double>(layers[number++][layersAt]); });
            ++layersAt;
        }
    }
}

void checkWords(Reader& reader, const StateWords& words) {
    const std::uint64_t count = reader.number();
    StateWords there;
    for (std::uint64_t i = 0; i < count; ++i) {
        std::string name(reader.text());
        there.emplace_back(std::move(name), reader.text());
    }
    const std::size_t least = std::min(there.size(), words.size());
    for (std::size_t i = 0; i < least; ++i) {
        if (there[i] == words[i]) continue;
        const auto& [name, value] = words[i];
        const bool isSame = there[i].first == name;
        throw core::Error(
            "STATE", "OTHER", name,
            "it was rendered with another " + name +
                (isSame && value.size() < 64 ? ", \"" + there[i].second + "\", not \"" + value + "\"" : ""));
    }
    if (there.size() != words.size()) throw core::Error("STATE", "OTHER", "", "it was rendered by another grsh");
}

void readTiles(Reader& reader, Accumulation& accumulation) {
    std::vector<Tile>& tiles = accumulation.tiles;
    if (reader.number() != tiles.size()) damaged();
    for (Tile& tile : tiles) tile.samples = static_cast<int>(reader.number());
    for (std::size_t first = 0; first < tiles.size(); first += tilesInABlock)
        unpack(reader.text(), tiles, first, std::min(first + tilesInABlock, tiles.size()));
    if (!reader.isOver()) damaged();
}

void read(std::string_view bytes, const StateWords& words, int most, Accumulation& accumulation) {
    constexpr std::size_t checksumSize = 8;
    if (bytes.size() < magic.size() + checksumSize || !bytes.starts_with(magic)) damaged();
    const std::string_view body = bytes.substr(magic.size() + checksumSize);
    if (Reader(bytes.substr(magic.size(), checksumSize)).number() != checksum(body)) damaged();
    Reader reader(body);
    checkWords(reader, words);
    accumulation.end = static_cast<int>(reader.number());
    accumulation.samples = reader.number();
    accumulation.dropped = reader.number();
    forEachCount(accumulation.rays, [&](std::uint64_t& count) { count = reader.number(); });
    accumulation.noise = readNoise(reader);
    readTiles(reader, accumulation);
    for (const Tile& tile : accumulation.tiles)
        if (tile.samples > most)
            throw core::Error("STATE", "SAMPLES", std::to_string(most),
                              "it has " + std::to_string(tile.samples) + " samples per pixel already, more than the " +
                                  std::to_string(most) + " asked for");
}

}  // namespace

void writeState(const image::FileName& name, const StateWords& words, const Accumulation& accumulation, int threads) {
    const std::vector<Tile>& tiles = accumulation.tiles;
    std::vector<std::string> blocks((tiles.size() + tilesInABlock - 1) / tilesInABlock);
    core::parallelFor(static_cast<int>(blocks.size()), threads, [&](int i) {
        const std::size_t first = static_cast<std::size_t>(i) * tilesInABlock;
        blocks[static_cast<std::size_t>(i)] = packed(tiles, first, std::min(first + tilesInABlock, tiles.size()));
    });
    Writer body;
    body.add(std::uint64_t{words.size()});
    for (const auto& [name, value] : words) {
        body.add(name);
        body.add(value);
    }
    body.add(static_cast<std::uint64_t>(accumulation.end));
    body.add(accumulation.samples);
    body.add(accumulation.dropped);
    RayCounts rays = accumulation.rays;
    forEachCount(rays, [&](std::uint64_t& count) { body.add(count); });
    addNoise(body, accumulation.noise);
    body.add(std::uint64_t{tiles.size()});
    for (const Tile& tile : tiles) body.add(static_cast<std::uint64_t>(tile.samples));
    for (const std::string& block : blocks) body.add(block);
    Writer head;
    head.bytes = magic;
    head.add(std::uint64_t{checksum(body.bytes)});

    image::TemporaryFile file(name.path, name.name);
    for (const std::string* part : {&head.bytes, &body.bytes})
        std::fwrite(part->data(), 1, part->size(), file.stream());
    file.publish();
}

bool readState(const image::FileName& name, const StateWords& words, int most, Accumulation& accumulation) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.path.c_str(), "rb"), std::fclose);
    const auto refuse = [&](const core::Error& error) {
        throw core::Error("STATE", error.reason, name.name,
                          "cannot resume from \"" + name.name + "\": " + error.what());
    };
    if (file == nullptr) {
        if (errno == ENOENT) return false;
        refuse(core::Error("STATE", "READ", "", std::strerror(errno)));
    }
    std::string bytes;
    char buffer[1 << 16];
    for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;)
        bytes.append(buffer, count);
    try {
        read(bytes, words, most, accumulation);
    } catch (const core::Error& error) {
        refuse(error);
    }
    return true;
}

}  // namespace render
