// Options in a command's words, read by their rows.
#pragma once

#include "grsh/texture_words.h"
#include "grsh/words.h"

#include <optional>

namespace grsh {

// The option's name without its leading dash, which may be written or not.
inline std::string_view withoutDash(std::string_view word) {
    if (word.starts_with('-')) word.remove_prefix(1);
    return word;
}

template<class Owner>
const core::OptionRow<Owner>* findOption(std::span<const core::OptionRow<Owner>> rows, std::string_view word) {
    const std::string_view name = withoutDash(word);
    for (const auto& row : rows)
        if (!name.empty() && (name == row.name || name == row.alias)) return &row;
    return nullptr;
}

// One reader for each type that an option can have; `what` is the option's name.
inline void readOption(bool& value, Tcl_Obj* word, std::string_view what, const core::Range&,
                       std::span<const core::Word>) {
    // Tcl takes every number for on or off; one that is neither 1 nor 0 was meant for another option.
    double number = 0;
    const bool isNumber = Tcl_GetDoubleFromObj(nullptr, word, &number) == TCL_OK;
    int flag = 0;
    if ((isNumber && number != 0 && number != 1) || Tcl_GetBooleanFromObj(nullptr, word, &flag) != TCL_OK)
        throwBadValue(what, "on or off", word);
    value = flag != 0;
}
inline void readOption(int& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = integerFrom(word, what, range);
}
inline void readOption(std::optional<int>& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = integerFrom(word, what, range);
}
inline void readOption(std::uint64_t& value, Tcl_Obj* word, std::string_view what, const core::Range&,
                       std::span<const core::Word>) {
    Tcl_WideInt number = 0;
    if (Tcl_GetWideIntFromObj(nullptr, word, &number) != TCL_OK || number < 0)
        throwBadValue(what, "an integer from 0 to 9223372036854775807", word);
    value = static_cast<std::uint64_t>(number);
}
inline void readOption(double& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = numberFrom(word, what, range);
}
inline void readOption(std::optional<double>& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = numberFrom(word, what, range);
}
inline void readOption(std::optional<glm::dvec3>& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = vectorFrom(word, what, range);
}
inline void readOption(std::string& value, Tcl_Obj* word, std::string_view what, const core::Range&,
                       std::span<const core::Word>) {
    value = fileNameFrom(word, what);
}
inline void readOption(core::Rgbf& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = colourFrom(word, what, range);
}
inline void readOption(core::Vec2f& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    std::array<double, 2> numbers;
    oneOrMoreFrom(word, what, range, numbers);
    value = {static_cast<float>(numbers[0]), static_cast<float>(numbers[1])};
}
// Lists of vectors: the message calls the third of the normals "normal 2".
template<class Value, class Read>
void readList(std::vector<Value>& values, Tcl_Obj* word, std::string_view what, const char* form, const Read& read) {
    const auto elements = elementsOf(word, what, std::string("a list of ") + form);
    values.clear();
    values.reserve(elements.size());
    const std::string one(what.substr(0, what.size() - what.ends_with('s')));
    for (Tcl_Obj* element : elements) read(element, one + " " + std::to_string(values.size()));
}
inline void readOption(std::vector<glm::dvec3>& values, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    readList(values, word, what, "{x y z}",
             [&](Tcl_Obj* element, const std::string& name) { values.push_back(vectorFrom(element, name, range)); });
}
inline void readOption(std::vector<core::Rgbf>& values, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    readList(values, word, what, "{r g b}",
             [&](Tcl_Obj* element, const std::string& name) { values.push_back(colourFrom(element, name, range)); });
}
inline void readOption(std::vector<core::Vec2f>& values, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    readList(values, word, what, "{u v}", [&](Tcl_Obj* element, const std::string& name) {
        std::array<double, 2> uv;
        numbersFrom(element, name, range, uv);
        values.emplace_back(static_cast<float>(uv[0]), static_cast<float>(uv[1]));
    });
}
// Scaled to sum to 1.
inline void readOption(std::optional<core::Weights>& value, Tcl_Obj* word, std::string_view what,
                       const core::Range& range, std::span<const core::Word>) {
    std::array<double, 4> numbers;
    numbersFrom(word, what, range, numbers);
    const double largest = *std::max_element(numbers.begin(), numbers.end());
    if (largest == 0) throwBadValue(what, "weights that are not all 0", word);
    double sum = 0;
    for (const double number : numbers) sum += number / largest;
    value.emplace();
    for (std::size_t i = 0; i < value->size(); ++i) (*value)[i] = static_cast<float>(numbers[i] / largest / sum);
}
// what: what a message says must be one of the words.
inline core::Word wordFrom(Tcl_Obj* word, std::string_view what, std::span<const core::Word> words) {
    const auto found = std::find(words.begin(), words.end(), textOf(word));
    if (found == words.end())
        throw core::Error("VALUE", "WORD", std::string(textOf(word)),
                          std::string(what) + " must be " + core::listed(words) + ", not " + quoted(textOf(word)) +
                              core::didYouMean(textOf(word), words));
    return *found;
}
inline void readOption(core::Word& value, Tcl_Obj* word, std::string_view what, const core::Range&,
                       std::span<const core::Word> words) {
    value = wordFrom(word, what, words);
}
inline void readOption(core::WordList& value, Tcl_Obj* word, std::string_view what, const core::Range&,
                       std::span<const core::Word> words) {
    value.clear();
    for (Tcl_Obj* element : elementsOf(word, what, "a list of " + core::listed(words))) {
        const core::Word one = wordFrom(element, "each of " + std::string(what), words);
        if (std::find(value.begin(), value.end(), one) != value.end())
            throw core::Error("VALUE", "TWICE", std::string(one), std::string(what) + " has " + quoted(one) + " twice");
        value.push_back(one);
    }
}

inline void readOption(glm::dvec3& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    value = vectorFrom(word, what, range);
}
inline void readOption(core::Scaling& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                       std::span<const core::Word>) {
    std::array<double, 3> numbers;
    oneOrMoreFrom(word, what, range, numbers);
    value.by = {numbers[0], numbers[1], numbers[2]};
}
inline void readOption(core::Script& value, Tcl_Obj* word, std::string_view, const core::Range&,
                       std::span<const core::Word>) {
    value.body = textOf(word);
}

// Where textures may stand, too; the row's place in its table is the slot.
template<class Value>
inline constexpr bool takesTextures =
    core::isTextured<Value> || std::is_same_v<Value, core::ColourPair> || std::is_same_v<Value, core::ColourStops>;
template<class Value>
void readTextured(core::Textured<Value>& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                  const Textures* textures, std::size_t slot) {
    if (auto texture = textureFrom(word, textures)) {
        value = {std::move(texture), slot};
        return;
    }
    Value plain{};
    try {
        readOption(plain, word, what, range, {});
    } catch (const core::Error& error) {
        throwNoTexture(error, word, textures);
    }
    value = plain;
}
inline void readTextured(core::ColourPair& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                         const Textures* textures, std::size_t slot) {
    const auto elements = elementsOf(word, what, "a list of two colours");
    if (elements.size() != 2) throwBadValue(what, "a list of two colours", word);
    for (std::size_t i = 0; i < 2; ++i)
        readTextured(value[i], elements[i], "each of " + std::string(what), range, textures, slot);
}
inline void readTextured(core::ColourStops& value, Tcl_Obj* word, std::string_view what, const core::Range& range,
                         const Textures* textures, std::size_t slot) {
    constexpr std::string_view expected = "a list of places and colours, {0 colour ... 1 colour}";
    const auto elements = elementsOf(word, what, expected);
    if (elements.empty() || elements.size() % 2 != 0) throwBadValue(what, expected, word);
    value.clear();
    for (std::size_t i = 0; i < elements.size(); i += 2) {
        const std::string number = std::to_string(i / 2);
        core::ColourStop& stop = value.emplace_back();
        stop.place = numberFrom(elements[i], "place " + number + " of " + std::string(what), core::unitInterval);
        if (i > 0 && stop.place < value[i / 2 - 1].place)
            throwBadValue("place " + number + " of " + std::string(what), "at least the one before it", elements[i]);
        readTextured(stop.colour, elements[i + 1], "colour " + number + " of " + std::string(what), range, textures,
                     slot);
    }
}

template<class Value>
inline constexpr bool mayBeNone =
    std::is_same_v<Value, std::string> || std::is_same_v<Value, double> ||
    std::is_same_v<Value, std::optional<double>> || std::is_same_v<Value, std::optional<glm::dvec3>>;

// An option's value, into owner. textures: those that the word may name, or null.
template<class Owner>
void readOption(const core::OptionRow<Owner>& row, Tcl_Obj* word, Owner& owner, const Textures* textures = nullptr) {
    // Three amounts with a form of their own, like {ar ag ab}, are no colour.
    if (const auto* channels = std::get_if<core::Rgbf Owner::*>(&row.member);
        channels != nullptr && !row.form.empty()) {
        owner.*(*channels) = channelsFrom(word, row.name, row.range);
        return;
    }
    // The word "none" takes back a number, which then is 0, or a point or a file, which then is absent, that gr_default
    // or a word before it has set.
    const bool isNone = row.defaultText == "none" && textOf(word) == "none";
    const auto read = [&]<class Value>(Value Owner::*member) {
        if constexpr (mayBeNone<Value>) {
            if (isNone) {
                owner.*member = Value{};
                return;
            }
        }
        if constexpr (takesTextures<Value>) {
            const auto slot = static_cast<std::size_t>(&row - Owner::options().data());
            readTextured(owner.*member, word, row.name, row.range, textures, slot);
        } else {
            readOption(owner.*member, word, row.name, row.range, row.words);
        }
    };
    std::visit(read, row.member);
}

// Throws for an option that there is not. noOption: what the message says before its name, e.g. "a diffuse material has
// no option". more: names that are allowed there, too, before those of the rows.
template<class Owner>
[[noreturn]] void throwNoOption(std::string_view word, std::string_view noOption,
                                std::vector<std::string_view> more = {}) {
    for (const auto& row : Owner::options()) more.push_back(row.name);
    throw core::Error("OPTION", "UNKNOWN", std::string(word),
                      std::string(noOption) + " " + quoted(word) + core::didYouMean(withoutDash(word), more) +
                          ": must be " + core::listed(more));
}

// Reads the pairs of option and value from word `first` on into owner. Of an option that stands there twice the last
// value counts, as everywhere in Tcl; so words may be put behind others to change what those say.
template<class Owner>
void readOptions(const Words& words, std::size_t first, std::string_view noOption, Owner& owner,
                 const Textures* textures = nullptr) {
    for (std::size_t i = first; i < words.size(); i += 2) {
        const std::string word(words.text(i));
        const auto* row = findOption(Owner::options(), word);
        if (row == nullptr) throwNoOption<Owner>(word, noOption);
        if (i + 1 == words.size()) throw core::Error("OPTION", "VALUE", word, "option \"" + word + "\" needs a value");
        readOption(*row, words.object(i + 1), owner, textures);
    }
}

// What gr_help says of an option.
struct OptionHelp {
    std::string_view name, alias;
    std::string_view type;  // the material's that has it; empty for the options of other commands
    std::string text;  // lines: name, type, range, unit, default, and below them the meaning
};

template<class Owner>
std::vector<OptionHelp> optionsHelp(std::span<const core::OptionRow<Owner>> rows, std::string_view type = {}) {
    std::vector<OptionHelp> options;
    for (const auto& row : rows) {
        std::string line = "  " + std::string(row.name);
        line.resize(std::max<std::size_t>(line.size() + 1, 25), ' ');
        line += core::typeText(row);
        if (const std::string range = core::rangeText(row.range); !range.empty()) line += " " + range;
        if (!row.unit.empty()) line += ", " + std::string(row.unit);
        line += " (default " + core::defaultText(row) + ")";
        options.push_back({row.name, row.alias, type, line + "\n      " + std::string(row.help)});
    }
    return options;
}

}  // namespace grsh
