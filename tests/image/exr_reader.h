// An OpenEXR file as it is, read by the library's C++ half; grsh writes it with the C one.
#pragma once

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <map>
#include <string>
#include <vector>

namespace image {

struct Exr {
    Imath::Box2i dataWindow, displayWindow;
    Imf::Compression compression;
    Imf::Chromaticities chromaticities;
    bool isComplete;
    std::map<std::string, Imf::PixelType> types;  // of its channels
    std::map<std::string, std::vector<float>> channels;  // pixel after pixel, line after line
    std::map<std::string, std::string> texts;
    std::vector<std::string> attributes;  // the names of all

    // Throws std::exception for what is no OpenEXR file.
    explicit Exr(const std::string& path);

    int width() const { return dataWindow.max.x - dataWindow.min.x + 1; }
    int lines() const { return dataWindow.max.y - dataWindow.min.y + 1; }
    // x, y: in the whole picture.
    float at(const std::string& channel, int x, int y) const {
        return channels.at(channel).at(static_cast<std::size_t>((y - dataWindow.min.y) * width() + x));
    }
};

inline Exr::Exr(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    dataWindow = header.dataWindow();
    displayWindow = header.displayWindow();
    compression = header.compression();
    chromaticities = Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities({}, {}, {}, {});
    isComplete = file.isComplete();
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        attributes.emplace_back(attribute.name());
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
        if (text != nullptr) texts[attribute.name()] = text->value();
    }
    Imf::FrameBuffer buffer;
    const std::size_t line = static_cast<std::size_t>(width());
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        types[channel.name()] = channel.channel().type;
        std::vector<float>& numbers = channels[channel.name()];
        numbers.resize(line * static_cast<std::size_t>(lines()));
        buffer.insert(channel.name(),
                      Imf::Slice::Make(Imf::FLOAT, numbers.data(), dataWindow, sizeof(float), line * sizeof(float)));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(dataWindow.min.y, dataWindow.max.y);
}

}  // namespace image
