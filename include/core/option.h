// Options as rows of a table. A row is all that is known of an option: parsing, range errors, spelling suggestions,
// gr_help, docs/language.md and a picture's metadata come from it.
#pragma once

#include "core/textured.h"
#include "core/vec.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace core {

// The numbers that an option takes, each bound included or not.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool leastIncluded = true;
    bool mostIncluded = true;

    // Nothing is comparable with NaN, and infinite numbers are refused everywhere.
    bool contains(double x) const {
        return std::isfinite(x) && (leastIncluded ? x >= least : x > least) && (mostIncluded ? x <= most : x < most);
    }
};

inline constexpr Range anyNumber{};
inline constexpr Range positive{.least = 0, .leastIncluded = false};
inline constexpr Range notNegative{.least = 0};
inline constexpr Range unitInterval{.least = 0, .most = 1};

// One of a few words; it points at the row's own text.
using Word = std::string_view;

// Some of a few words, each at most once.
using WordList = std::vector<Word>;

// Four weights that sum to 1.
using Weights = std::array<float, 4>;

// Factors along three axes, one number standing for all.
struct Scaling {
    glm::dvec3 by{1};
};

// A body of the scene's own language, which is run by who reads it.
struct Script {
    std::string body;
};

// Colours, or textures in their place, at places from 0 to 1 in rising order; between them they are mixed.
struct ColourStop {
    double place = 0;
    Textured<Rgbf> colour;
};
using ColourStops = std::vector<ColourStop>;
using ColourPair = std::array<Textured<Rgbf>, 2>;

// Where in Owner an option is kept, and so its type. Owner's default value is the option's.
template<class Owner>
using OptionMember =
    std::variant<bool Owner::*, int Owner::*, std::uint64_t Owner::*, double Owner::*, Rgbf Owner::*, Vec2f Owner::*,
                 std::optional<int> Owner::*, std::optional<double> Owner::*, std::optional<glm::dvec3> Owner::*,
                 std::optional<Weights> Owner::*, Word Owner::*, WordList Owner::*, std::string Owner::*,
                 std::vector<glm::dvec3> Owner::*, std::vector<Rgbf> Owner::*, std::vector<Vec2f> Owner::*,
                 Textured<Rgbf> Owner::*, Textured<double> Owner::*, Textured<Vec2f> Owner::*, glm::dvec3 Owner::*,
                 Scaling Owner::*, Script Owner::*, ColourPair Owner::*, ColourStops Owner::*>;

template<class Owner>
struct OptionRow {
    std::string_view name = {};
    std::string_view alias = {};  // another spelling that is accepted, or empty
    OptionMember<Owner> member = {};
    Range range = {};
    std::span<const Word> words = {};  // what an option of type Word may be, or what a WordList may hold
    std::string_view form = {};  // how a list is written, e.g. {nu nv}; empty for a colour and a place
    std::string_view unit = {};  // empty where there is none
    std::string_view defaultText = {};  // where the default is worked out; empty: as in Owner{}
    std::string_view help = {};
    bool inPicture = true;  // whether the picture depends on it, and its metadata says it
};

// 0 to 1, greater than 0, ...; empty when every finite number will do.
std::string rangeText(const Range& range);

// The shortest decimal that reads back as the same number.
std::string numberText(double x);
std::string numberText(float x);

inline std::string optionText(bool value) {
    return value ? "on" : "off";
}
inline std::string optionText(int value) {
    return std::to_string(value);
}
inline std::string optionText(std::uint64_t value) {
    return std::to_string(value);
}
inline std::string optionText(double value) {
    return numberText(value);
}
inline std::string optionText(Word value) {
    return std::string(value);
}
inline std::string optionText(const std::string& fileName) {
    return fileName;
}
inline std::string optionText(const WordList& words) {
    std::string text;
    for (const Word word : words) text += (text.empty() ? "" : " ") + std::string(word);
    return text;
}
inline std::string optionText(const Rgbf& c) {
    return numberText(c.x) + " " + numberText(c.y) + " " + numberText(c.z);
}
inline std::string optionText(const Vec2f& v) {
    return numberText(v.x) + " " + numberText(v.y);
}
// Of these there may be a million: a row tells in words what the default is.
template<class Value>
std::string optionText(const std::vector<Value>&) {
    return "";
}
inline std::string optionText(const std::optional<Weights>& value) {
    std::string text;
    if (value)
        for (const float weight : *value) text += (text.empty() ? "" : " ") + numberText(weight);
    return text;
}
inline std::string optionText(const std::optional<int>& value) {
    return value ? std::to_string(*value) : "";
}
inline std::string optionText(const std::optional<double>& value) {
    return value ? numberText(*value) : "";
}
inline std::string optionText(const glm::dvec3& v) {
    return numberText(v.x) + " " + numberText(v.y) + " " + numberText(v.z);
}
inline std::string optionText(const std::optional<glm::dvec3>& v) {
    return v ? optionText(*v) : "";
}

inline std::string optionText(const Scaling& scaling) {
    const glm::dvec3& by = scaling.by;
    return by.x == by.y && by.y == by.z ? numberText(by.x) : optionText(by);
}
inline std::string optionText(const Script& script) {
    return script.body;
}
// A texture has a name, which only the scene knows.
template<class Value>
std::string optionText(const Textured<Value>& value) {
    return value.texture != nullptr ? "texture" : optionText(value.value);
}
inline std::string optionText(const ColourPair& pair) {
    return "{" + optionText(pair[0]) + "} {" + optionText(pair[1]) + "}";
}
inline std::string optionText(const ColourStops& stops) {
    std::string text;
    for (const ColourStop& stop : stops)
        text += (text.empty() ? "" : " ") + numberText(stop.place) + " {" + optionText(stop.colour) + "}";
    return text;
}

// The value that an owner has for a row, as the scene language writes it (a colour without its braces).
template<class Owner>
std::string optionText(const OptionRow<Owner>& row, const Owner& owner) {
    return std::visit([&](auto member) { return optionText(owner.*member); }, row.member);
}

template<class Owner>
std::string defaultText(const OptionRow<Owner>& row) {
    if (!row.defaultText.empty()) return std::string(row.defaultText);
    const std::string text = optionText(row, Owner{});
    const bool isList = std::holds_alternative<Rgbf Owner::*>(row.member) ||
                        std::holds_alternative<Vec2f Owner::*>(row.member) ||
                        std::holds_alternative<Textured<Rgbf> Owner::*>(row.member) ||
                        std::holds_alternative<Textured<Vec2f> Owner::*>(row.member) ||
                        std::holds_alternative<glm::dvec3 Owner::*>(row.member) ||
                        std::holds_alternative<ColourPair Owner::*>(row.member) ||
                        std::holds_alternative<ColourStops Owner::*>(row.member) ||
                        std::holds_alternative<WordList Owner::*>(row.member);
    return isList ? "{" + text + "}" : text;
}

// on/off, integer, number, {r g b} or another list, or the words it may be.
template<class Owner>
std::string typeText(const OptionRow<Owner>& row) {
    struct Name {
        std::span<const Word> words;
        std::string_view form;
        std::string operator()(bool Owner::*) const { return "on/off"; }
        std::string operator()(int Owner::*) const { return "integer"; }
        std::string operator()(std::optional<int> Owner::*) const { return "integer"; }
        std::string operator()(std::uint64_t Owner::*) const { return "integer"; }
        std::string operator()(double Owner::*) const { return "number"; }
        std::string operator()(std::optional<double> Owner::*) const { return "number"; }
        std::string operator()(std::optional<glm::dvec3> Owner::*) const { return "{x y z}"; }
        std::string operator()(std::string Owner::*) const { return "file"; }
        std::string operator()(Rgbf Owner::*) const { return form.empty() ? "{r g b}" : std::string(form); }
        std::string operator()(Vec2f Owner::*) const { return std::string(form); }
        std::string operator()(std::optional<Weights> Owner::*) const { return std::string(form); }
        std::string operator()(std::vector<glm::dvec3> Owner::*) const { return std::string(form); }
        std::string operator()(std::vector<Rgbf> Owner::*) const { return std::string(form); }
        std::string operator()(std::vector<Vec2f> Owner::*) const { return std::string(form); }
        std::string operator()(Textured<Rgbf> Owner::*) const { return "{r g b}|texture"; }
        std::string operator()(Textured<double> Owner::*) const { return "number|texture"; }
        std::string operator()(Textured<Vec2f> Owner::*) const { return std::string(form) + "|texture"; }
        std::string operator()(glm::dvec3 Owner::*) const { return form.empty() ? "{x y z}" : std::string(form); }
        std::string operator()(Scaling Owner::*) const { return "number|{x y z}"; }
        std::string operator()(Script Owner::*) const { return "script"; }
        std::string operator()(ColourPair Owner::*) const { return "{colour colour}"; }
        std::string operator()(ColourStops Owner::*) const { return "{0 colour ... 1 colour}"; }
        std::string operator()(Word Owner::*) const {
            std::string text;
            for (const Word word : words) text += (text.empty() ? "" : "|") + std::string(word);
            return text;
        }
        std::string operator()(WordList Owner::*) const {
            return "list of " + (*this)(static_cast<Word Owner::*>(nullptr));
        }
    };
    return std::visit(Name{row.words, row.form}, row.member);
}

}  // namespace core
