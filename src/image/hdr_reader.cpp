// Radiance's pictures: red, green and blue as 8 bits each with one exponent for all three. The format is that of
//     G. Ward, "Real Pixels", in Graphics Gems II (1991)
// and of Radiance's own reference, filefmts.pdf.
#include "image/announced.h"
#include "image/image_readers.h"
#include "image/primaries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

struct Header {
    std::array<double, 3> factors{1, 1, 1};  // what the numbers were multiplied by
};

// Along one axis of the picture: whether it is x, whether its pixels come from the right or from the bottom, and their
// number.
struct Axis {
    bool isX = false, isTurned = false;
    int length = 0;
};

std::string readLine(std::FILE* file) {
    constexpr std::size_t longest = 10'000;
    std::string line;
    for (int c = std::fgetc(file); c != '\n'; c = std::fgetc(file)) {
        if (c == EOF) failReading("it ends too early");
        if (line.size() == longest) failReading("its header has a line of more than 10000 letters");
        line += static_cast<char>(c);
    }
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

// The numbers behind a keyword.
template<std::size_t count>
std::array<double, count> numbersOf(const std::string& keyword, const std::string& text) {
    std::array<double, count> numbers{};
    const char* at = text.c_str();
    for (double& number : numbers) {
        char* end = nullptr;
        number = std::strtod(at, &end);
        if (end == at || !std::isfinite(number))
            failReading("its " + keyword + " has not " + std::to_string(count) + " numbers: \"" + text.substr(0, 60) +
                        "\"");
        at = end;
    }
    return numbers;
}

void multiply(Header& header, const std::string& keyword, const std::array<double, 3>& factors) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(factors[c] > 0)) failReading("its " + keyword + " is not above 0");
        header.factors[c] *= factors[c];
    }
}

void readVariable(const std::string& line, Header& header) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return;
    const std::string keyword = line.substr(0, equals);
    std::string value = line.substr(equals + 1);
    value.erase(0, value.find_first_not_of(" \t"));
    value.erase(value.find_last_not_of(" \t") + 1);
    if (keyword == "FORMAT") {
        if (value == "32-bit_rle_xyze") failReading("its colours are those of CIE XYZ, not those of sRGB");
        if (value != "32-bit_rle_rgbe")
            failReading("its FORMAT is \"" + value.substr(0, 60) + "\", not \"32-bit_rle_rgbe\"");
    } else if (keyword == "EXPOSURE") {
        const double factor = numbersOf<1>(keyword, value)[0];
        multiply(header, keyword, {factor, factor, factor});
    } else if (keyword == "COLORCORR") {
        multiply(header, keyword, numbersOf<3>(keyword, value));
    } else if (keyword == "PRIMARIES") {
        if (const auto why = otherThanSrgb(numbersOf<8>(keyword, value))) failReading(*why);
    }
}

Header readHeader(std::FILE* file) {
    char kind[2] = "";
    if (std::fread(kind, 1, 2, file) != 2 || kind[0] != '#' || kind[1] != '?')
        failReading("it is no picture of Radiance: it does not begin with #?");
    readLine(file);
    Header header;
    for (std::string line = readLine(file); !line.empty(); line = readLine(file)) readVariable(line, header);
    for (const double factor : header.factors)
        if (!(factor > 0 && factor < 1e30)) failReading("its EXPOSURE and COLORCORR are too far from 1");
    return header;
}

// -Y 480 +X 640: lines from the top to the bottom, in each of which pixels go from the left to the right.
std::array<Axis, 2> readAxes(std::FILE* file) {
    const std::string line = readLine(file);
    std::array<char, 4> signs{};
    std::array<Axis, 2> axes;
    int end = 0;
    const int read = std::sscanf(line.c_str(), "%c%c %7d %c%c %7d%n", &signs[0], &signs[1], &axes[0].length, &signs[2],
                                 &signs[3], &axes[1].length, &end);
    bool isRight = read == 6 && static_cast<std::size_t>(end) == line.size();
    for (std::size_t i = 0; i < 2; ++i) {
        const char sign = signs[2 * i], letter = signs[2 * i + 1];
        isRight &= (sign == '+' || sign == '-') && (letter == 'X' || letter == 'Y');
        axes[i].isX = letter == 'X';
        // x grows to the right, y upwards.
        axes[i].isTurned = sign == (axes[i].isX ? '-' : '+');
    }
    if (!isRight || axes[0].isX == axes[1].isX)
        failReading("its line of axes is \"" + line.substr(0, 60) + "\", not one like \"-Y 480 +X 640\"");
    for (const Axis& axis : axes)
        if (axis.length < 1 || axis.length > 1'000'000) failReading("its size is not from 1 to 1000000 pixels");
    return axes;
}

std::uint8_t readByte(std::FILE* file) {
    const int byte = getc_unlocked(file);
    if (byte == EOF) failReading("it ends too early");
    return static_cast<std::uint8_t>(byte);
}

Rgbe readPixel(std::FILE* file) {
    return {readByte(file), readByte(file), readByte(file), readByte(file)};
}

// Pixels as they are, or runs: 1 1 1 n repeats the one before n times, and such a one right behind it 256 n times, ...
void readOldLine(std::FILE* file, Rgbe first, std::vector<Rgbe>& line) {
    std::size_t x = 0;
    int shift = 0;
    for (Rgbe pixel = first;; pixel = readPixel(file)) {
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            line[x++] = pixel;
            shift = 0;
        } else {
            const std::size_t count = shift < 32 ? static_cast<std::size_t>(pixel[3]) << shift : line.size() + 1;
            if (x == 0) failReading("its first pixel of a line repeats one before it");
            if (count > line.size() - x) failReading("its pixels go beyond the end of a line");
            std::fill_n(&line[x], count, line[x - 1]);
            x += count;
            shift += 8;
        }
        if (x == line.size()) return;
    }
}

// Each of the four bytes of all pixels by itself: runs of one byte, of 128 + n, or n bytes as they are.
void readNewLine(std::FILE* file, std::vector<Rgbe>& line) {
    for (std::size_t part = 0; part < 4; ++part) {
        for (std::size_t x = 0; x < line.size();) {
            std::size_t count = readByte(file);
            const bool isRun = count > 128;
            if (isRun) count -= 128;
            if (count == 0 || count > line.size() - x) failReading("its bytes go beyond the end of a line");
            std::uint8_t byte = 0;
            for (std::size_t i = 0; i < count; ++i) {
                if (i == 0 || !isRun) byte = readByte(file);
                line[x++][part] = byte;
            }
        }
    }
}

void readLineOf(std::FILE* file, std::vector<Rgbe>& line) {
    const Rgbe first = readPixel(file);
    const std::size_t length = static_cast<std::size_t>(first[2]) << 8 | first[3];
    const bool isNew = first[0] == 2 && first[1] == 2 && first[2] < 128 && line.size() >= 8 && line.size() < 32768;
    if (!isNew) return readOldLine(file, first, line);
    if (length != line.size()) failReading("its lines are not as long as it announces");
    readNewLine(file, line);
}

// The middle of what is rounded to the number, as Radiance reads it. No exponent is black.
float radianceOf(const Rgbe& pixel, std::size_t channel, const Header& header) {
    if (pixel[3] == 0) return 0;
    return static_cast<float>(std::ldexp(pixel[channel] + 0.5, pixel[3] - (128 + 8)) / header.factors[channel]);
}

}  // namespace

Image readHdr(std::FILE* file) {
    const Header header = readHeader(file);
    const auto [slow, fast] = readAxes(file);
    Image image;
    image.held.width = slow.isX ? slow.length : fast.length;
    image.held.height = slow.isX ? fast.length : slow.length;
    image.whole = image.held;
    // A line takes one pixel at least, and another one to repeat it.
    const double least = slow.length * (fast.length > 1 ? 8. : 4.) + static_cast<double>(ftello(file));
    checkAnnounced(image.held.width, image.held.height, least, sizeOf(file));
    checkMemory(image.held, 3 * sizeof(float));
    std::array<std::vector<float>, 3> channels;
    for (auto& channel : channels) channel.resize(image.pixels());
    std::vector<Rgbe> line(static_cast<std::size_t>(fast.length));
    const auto place = [](const Axis& axis, int i) { return axis.isTurned ? axis.length - 1 - i : i; };
    for (int i = 0; i < slow.length; ++i) {
        readLineOf(file, line);
        for (int j = 0; j < fast.length; ++j) {
            const int a = place(slow, i), b = place(fast, j), x = slow.isX ? a : b, y = slow.isX ? b : a;
            const auto at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(image.held.width) + static_cast<std::size_t>(x);
            for (std::size_t c = 0; c < 3; ++c)
                channels[c][at] = radianceOf(line[static_cast<std::size_t>(j)], c, header);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) image.channels.push_back({std::string(1, "RGB"[c]), std::move(channels[c])});
    return image;
}

}  // namespace image
