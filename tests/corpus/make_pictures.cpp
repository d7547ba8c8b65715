// Writes the pictures of tests/corpus/pictures into the folder that it is given. They are kept as files, so that they
// stay what they are whatever library is installed. To make them again:
//     g++ -std=c++20 tests/corpus/make_pictures.cpp $(pkg-config --cflags --libs OpenEXR libpng) -o /tmp/make_pictures
//     /tmp/make_pictures tests/corpus/pictures
// All show the same 12 x 10 pixels: red is x/16, green y/16, blue (x + y)/32.
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <png.h>

#include <cmath>
#include <fstream>
#include <vector>

namespace {

constexpr int width = 12, height = 10;
std::string folder;

float colour(int x, int y, int channel) {
    return channel == 0 ? float(x) / 16 : channel == 1 ? float(y) / 16 : float(x + y) / 32;
}

void writePfm() {
    std::ofstream file(folder + "/plain.pfm", std::ios::binary);
    file << "PF\n" << width << ' ' << height << "\n-1.0\n";
    for (int y = height; y-- > 0;)
        for (int i = 0; i < 3 * width; ++i) {
            const float number = colour(i / 3, y, i % 3);
            file.write(reinterpret_cast<const char*>(&number), sizeof number);
        }
}

// A line as Radiance packs it: here runs of one byte each. Mantissas of 2^-5 steps at the exponent of 2^0.
// isTurned: from the lower right corner on.
void writeHdr(const std::string& name, bool isPacked, bool isTurned) {
    std::ofstream file(folder + "/" + name, std::ios::binary);
    file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" << (isTurned ? "+Y 10 -X 12\n" : "-Y 10 +X 12\n");
    for (int y = 0; y < height; ++y) {
        std::vector<unsigned char> bytes[4];
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float number = isTurned ? colour(width - 1 - x, height - 1 - y, c) : colour(x, y, c);
                bytes[c].push_back(static_cast<unsigned char>(128 * number));
            }
            bytes[3].push_back(129);
        }
        if (isPacked) file << '\2' << '\2' << '\0' << char(width);
        for (int x = 0; x < width && !isPacked; ++x)
            for (const auto& part : bytes) file << char(part[std::size_t(x)]);
        for (int c = 0; c < 3 && isPacked; ++c) {
            file << char(width);
            for (const unsigned char byte : bytes[c]) file << char(byte);
        }
        if (isPacked) file << char(128 + width) << char(129);
    }
}

void writePng(const std::string& name, int bits, double gamma) {
    std::FILE* file = std::fopen((folder + "/" + name).c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, width, height, bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7, 0, 0);
    png_set_gAMA(png, info, gamma);
    png_write_info(png, info);
    std::vector<std::vector<png_byte>> lines(height);
    std::vector<png_bytep> rows;
    for (int y = 0; y < height; ++y) {
        for (int i = 0; i < 3 * width; ++i) {
            const int number = int(std::pow(colour(i / 3, y, i % 3), gamma) * ((1 << bits) - 1) + 0.5);
            if (bits == 16) lines[std::size_t(y)].push_back(png_byte(number >> 8));
            lines[std::size_t(y)].push_back(png_byte(number & 255));
        }
        rows.push_back(lines[std::size_t(y)].data());
    }
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

std::vector<float> numbers[3];

Imf::FrameBuffer colours(Imf::Header& header) {
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
        const std::string name(1, "RGB"[c]);
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers[c].data()), 4, 4 * width));
    }
    return buffer;
}

void writeExrs() {
    const char* const names[] = {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"};
    for (int i = 0; i < 10; ++i) {
        Imf::Header header(width, height);
        header.compression() = Imf::Compression(i);
        const Imf::FrameBuffer buffer = colours(header);
        Imf::OutputFile file((folder + "/" + names[i] + ".exr").c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    }
    Imf::Header tiled(width, height);
    tiled.setTileDescription(Imf::TileDescription(5, 4, Imf::MIPMAP_LEVELS));
    const Imf::FrameBuffer buffer = colours(tiled);
    Imf::TiledOutputFile file((folder + "/mipmap.exr").c_str(), tiled);
    file.setFrameBuffer(buffer);
    for (int level = 0; level < file.numLevels(); ++level)
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    std::vector<Imf::Header> parts(2, Imf::Header(width, height));
    parts[0].setName("depth");
    parts[1].setName("colour");
    for (Imf::Header& part : parts) part.setType("scanlineimage");
    parts[0].channels().insert("Z", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer depth;
    depth.insert("Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers[0].data()), 4, 4 * width));
    const Imf::FrameBuffer colour = colours(parts[1]);
    Imf::MultiPartOutputFile both((folder + "/parts.exr").c_str(), parts.data(), 2);
    for (int i = 0; i < 2; ++i) {
        Imf::OutputPart part(both, i);
        part.setFrameBuffer(i == 0 ? depth : colour);
        part.writePixels(height);
    }
}

void writeChroma() {
    Imf::Array2D<Imf::Rgba> pixels(height, width);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) pixels[y][x] = Imf::Rgba(colour(x, y, 0), colour(x, y, 1), colour(x, y, 2), 1);
    Imf::RgbaOutputFile file((folder + "/chroma.exr").c_str(), width, height, Imf::WRITE_YC);
    file.setFrameBuffer(&pixels[0][0], 1, width);
    file.writePixels(height);
}

}  // namespace

int main(int, char** argv) {
    folder = argv[1];
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < width * height; ++i) numbers[c].push_back(colour(i % width, i / width, c));
    writePfm();
    writeHdr("packed.hdr", true, false);
    writeHdr("flat.hdr", false, false);
    writeHdr("turned.hdr", true, true);
    writePng("gamma22.png", 8, 1 / 2.2);
    writePng("linear.png", 16, 1);
    writeExrs();
    writeChroma();
}
