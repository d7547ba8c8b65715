#include "gr/direction.h"
#include "grsh/option_words.h"
#include "grsh/redefine.h"

#include <array>

namespace grsh {
namespace {

constexpr core::Range amount{.least = 0, .most = 1e18};
constexpr core::Range place{.least = -1e18, .most = 1e18};

// What makes a spot of a point light: one row each.
struct SpotSettings {
    std::optional<glm::dvec3> towards;
    std::optional<double> angle, softness;  // see spotOf()

    static std::span<const core::OptionRow<SpotSettings>> options();
};

constexpr double defaultAngle = 45, defaultSoftness = 0.15;
constexpr std::array<core::OptionRow<SpotSettings>, 3> spotRows{{
    {.name = "towards",
     .member = &SpotSettings::towards,
     .range = place,
     .defaultText = "none",
     .help = "makes a spot of it, which shines in this direction, of any length"},
    {.name = "angle",
     .member = &SpotSettings::angle,
     .range = {.least = 0, .most = 180, .leastIncluded = false},
     .unit = "degrees",
     .defaultText = "45",
     .help = "of a spot: the whole angle of its cone, from edge to edge"},
    {.name = "softness",
     .member = &SpotSettings::softness,
     .range = core::unitInterval,
     .defaultText = "0.15",
     .help = "of a spot: the part of the cone over which it fades to its edge; 0 is a sharp edge"},
}};
std::span<const core::OptionRow<SpotSettings>> SpotSettings::options() {
    return spotRows;
}

// The disc that a sun is.
struct SunSettings {
    double angle = 0.53;

    static std::span<const core::OptionRow<SunSettings>> options();
};
constexpr std::array<core::OptionRow<SunSettings>, 1> sunRows{{
    {.name = "angle",
     .member = &SunSettings::angle,
     .range = {.least = 0, .most = 180},
     .unit = "degrees",
     .help = "how wide the disc is that is seen in the sky; 0 is a point, which nobody sees, with sharp shadows"},
}};
std::span<const core::OptionRow<SunSettings>> SunSettings::options() {
    return sunRows;
}

// What makes or changes a light: ?-redefine? name, as many words as it needs, and then options.
template<class Settings>
struct LightWords {
    bool changes;
    std::size_t name;
    Settings settings;

    LightWords(Call& call, std::size_t needed) : changes(redefines(call)), name(changes ? 1 : 0) {
        const std::size_t next = name + 1 + needed, count = call.words.size();
        const bool hasRest = count > next && (count - next) % 2 == 1;
        if (hasRest && !changes) checkRedefineSpelling(call);
        if (count < next || (hasRest && findOption(Settings::options(), call.words.text(next)) == nullptr))
            throwWrongWords();
        readOptions(call.words, next, "no such option", settings);
    }

    Tcl_Obj* put(Call& call, const gr::NamedLight& light) const {
        std::string made(call.words.text(name));
        if (changes)
            call.session.database.redefineLight(made, light);
        else
            made = call.session.database.addLight(made, light, call.kind);
        return textObject(made);
    }
};

void checkDirection(const glm::dvec3& direction, std::string_view what) {
    if (direction != glm::dvec3(0)) return;
    throw core::Error("VALUE", "RANGE", "0 0 0",
                      std::string(what) + " must be a direction, not of length 0, not \"0 0 0\"");
}

gr::NamedLight spotOf(const gr::PointLight& point, const SpotSettings& settings) {
    if (settings.towards) {
        checkDirection(*settings.towards, "towards");
        return gr::SpotLight::make(point, *settings.towards, settings.angle.value_or(defaultAngle),
                                   settings.softness.value_or(defaultSoftness));
    }
    if (!settings.angle && !settings.softness) return point;
    const std::string option = settings.angle ? "angle" : "softness";
    throw core::Error("OPTION", "CONFLICT", option,
                      option + " is an option of spots and needs the option towards, as in -towards {0 -1 0}");
}

// gr_light ?-redefine? name {x y z} {r g b} {c0 c1 c2} ?option value ...?
Tcl_Obj* makeLight(Call& call) {
    const LightWords<SpotSettings> words(call, 3);
    gr::PointLight light;
    light.position = core::Vec3f(call.words.vector(words.name + 1, "position", place));
    light.intensity = call.words.colour(words.name + 2, "intensity", amount);
    light.attenuation = core::Vec3f(call.words.vector(words.name + 3, "attenuation", amount));
    if (light.attenuation == core::Vec3f(0))
        throwBadValue("attenuation", "other than all 0", call.words.object(words.name + 3));
    return words.put(call, spotOf(light, words.settings));
}

// gr_sun ?-redefine? name {dx dy dz} {r g b} ?option value ...?
Tcl_Obj* makeSun(Call& call) {
    const LightWords<SunSettings> words(call, 2);
    const glm::dvec3 along = call.words.vector(words.name + 1, "direction", place);
    if (along == glm::dvec3(0))
        throwBadValue("direction", "of a length other than 0", call.words.object(words.name + 1));
    const core::Rgbf colour = call.words.colour(words.name + 2, "colour", amount);
    if (words.settings.angle == 0) return words.put(call, gr::ParallelLight::make(along, colour));
    return words.put(call, gr::SunLight::make(along, colour, words.settings.angle));
}

Tcl_Obj* removeLight(Call& call) {
    call.session.database.removeLight(call.words.text(0));
    return nullptr;
}

constexpr std::array<Command, 3> rows{{
    {"gr_light", "", "?-redefine? name {x y z} {r g b} {c0 c1 c2} ?option value ...?", 4, anyNumberOfWords, makeLight,
     "makes or changes a point light, or a spot; at distance d it shows a white surface {r g b}/(c0 + c1 d + c2 d^2) "
     "bright",
     "-redefine makes another of one that there is; lights shine in the renders that name them"},
    {"gr_sun", "", "?-redefine? name {dx dy dz} {r g b} ?option value ...?", 3, anyNumberOfWords, makeSun,
     "makes or changes parallel light that goes along {dx dy dz}; it shows a white surface that faces it {r g b} "
     "bright",
     "-redefine makes another of a light that there is; suns are named in gr_render like other lights"},
    {"gr_delete_light", "", "name", 1, 1, removeLight, "deletes a light of gr_light or gr_sun"},
}};

}  // namespace

std::span<const Command> lightCommands() {
    return rows;
}

std::vector<OptionHelp> lightOptionsHelp() {
    return optionsHelp(SpotSettings::options());
}

std::vector<OptionHelp> sunOptionsHelp() {
    return optionsHelp(SunSettings::options());
}

}  // namespace grsh
