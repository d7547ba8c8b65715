#include "gr/fingerprint.h"
#include "grsh/option_words.h"
#include "grsh/place.h"
#include "grsh/texture_script.h"
#include "image/image_file.h"
#include "image/radiances.h"
#include "materials/textures/texture.h"

#include <algorithm>
#include <array>

namespace grsh {
namespace {

std::vector<std::string_view> typeNames() {
    std::vector<std::string_view> names;
    materials::forEachTextureType([&]<class T>() { names.push_back(T::typeName); });
    return names;
}

// What may stand for a colour must not be a texture's name.
void checkName(Call& call) {
    const std::string_view name = call.words.text(0);
    if (!name.empty() && call.words.isColour(0))
        throw core::Error("TEXTURE", "NAME", std::string(name),
                          "a texture's name must be one word that is no colour, not " + quoted(name));
}

[[noreturn]] void throwMissing(std::string_view type, std::string_view option) {
    throw core::Error("OPTION", "MISSING", std::string(option),
                      "a texture of type " + std::string(type) + " needs the option " + std::string(option));
}

image::NumberCurve curveNamed(core::Word name) {
    return name == "srgb"     ? image::NumberCurve::srgb
           : name == "linear" ? image::NumberCurve::none
                              : image::NumberCurve::asFile;
}

// What is left to do for a texture once its options are read: pictures are read, scripts run.
void finish(Call&, const auto&) {}
void finish(Call& call, materials::ImageTexture& texture) {
    if (texture.file.empty()) throwMissing(texture.typeName, "file");
    const image::FileName file = call.session.files->toRead(besideScript(call.interp, texture.file), texture.file);
    const image::Image picture = image::readImage(file);
    const auto texels = std::make_shared<materials::Texels>();
    texels->width = picture.held.width;
    texels->height = picture.held.height;
    texels->colours = image::linearColours(picture, texture.file, curveNamed(texture.curve), 1e18f);
    texture.texels = texels;
}
void finish(Call& call, materials::ScriptTexture& texture) {
    if (texture.body.body.empty()) throwMissing(texture.typeName, "body");
    if (texture.size != glm::floor(texture.size))
        throw core::Error("VALUE", "RANGE", core::optionText(texture.size),
                          "size must be two whole numbers, not \"" + core::optionText(texture.size) + "\"");
    texture.texels = runTextureScript(call, texture);
}

materials::TextureType readTyped(Call& call) {
    const std::string type(call.words.text(1));
    std::optional<materials::TextureType> texture;
    materials::forEachTextureType([&]<class T>() {
        if (type != T::typeName) return;
        T parameters;
        readOptions(call.words, 2, "a " + type + " texture has no option", parameters, &call.session.database);
        finish(call, parameters);
        texture = std::move(parameters);
    });
    if (texture) return std::move(*texture);
    throw core::Error("TEXTURE", "TYPE", type,
                      "no such type " + grsh::quoted(type) + core::didYouMean(type, typeNames()) + ": must be " +
                          core::listed(typeNames()));
}

// gr_texture name type ?option value ...?
Tcl_Obj* makeTexture(Call& call) {
    gr::Database& database = call.session.database;
    const std::string name(call.words.text(0)), words = call.words.textFrom(1);
    checkName(call);
    if (database.checkNewTexture(name, words)) return textObject(name);
    materials::TextureType type = readTyped(call);
    const core::Transform toOwn = std::visit([](const auto& t) { return t.toTexture(); }, type);
    const auto texture = std::make_shared<materials::Texture>(materials::Texture{std::move(type), toOwn});
    texture->fingerprint = gr::fingerprint(*texture);
    return textObject(database.addTexture(name, texture, words));
}

constexpr std::array<Command, 1> rows{{
    {"gr_texture", "", "name type ?option value ...?", 2, anyNumberOfWords, makeTexture,
     "makes a texture, whose name then stands wherever a material takes a colour, or a number, which is its luminance",
     "what a texture gives beyond the range of the number or the colour is cut off"},
}};

}  // namespace

std::span<const Command> textureCommands() {
    return rows;
}

std::vector<OptionHelp> textureOptionsHelp() {
    std::vector<OptionHelp> options;
    materials::forEachTextureType([&]<class T>() {
        for (OptionHelp& option : optionsHelp(T::options(), T::typeName)) options.push_back(std::move(option));
    });
    return options;
}

}  // namespace grsh
