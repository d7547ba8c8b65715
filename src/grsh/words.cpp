#include "grsh/words.h"

#include "grsh/css_colours.h"
#include "grsh/tcl_value.h"
#include "grsh/word_hints.h"

namespace grsh {
namespace {

// a finite number, a finite number greater than 0, an integer from 1 to 16
std::string describe(std::string_view kind, const core::Range& range) {
    const std::string text = core::rangeText(range);
    if (text.empty()) return std::string(kind);
    const bool isInterval = text[0] == '-' || (text[0] >= '0' && text[0] <= '9');
    return std::string(kind) + (isInterval ? " from " : " ") + text;
}

std::string countText(std::size_t count) {
    constexpr std::string_view counts[] = {"one", "two", "three", "four"};
    return count <= std::size(counts) ? std::string(counts[count - 1]) : std::to_string(count);
}

// Whether the list has just so many numbers, all within the range.
bool readNumbers(Tcl_Obj* object, const core::Range& range, std::span<double> numbers) {
    int count = 0;
    Tcl_Obj** elements = nullptr;
    if (Tcl_ListObjGetElements(nullptr, object, &count, &elements) != TCL_OK) return false;
    if (static_cast<std::size_t>(count) != numbers.size()) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool isNumber = Tcl_GetDoubleFromObj(nullptr, elements[i], &numbers[i]) == TCL_OK;
        if (!isNumber || !range.contains(numbers[i])) return false;
    }
    return true;
}

}  // namespace

std::string quoted(std::string_view word) {
    constexpr std::size_t most = 60;
    std::string text;
    for (const char c : word) {
        if (text.size() > most) break;
        const bool isSpace = c == ' ' || (c >= '\t' && c <= '\r');
        if (!isSpace)
            text += c;
        else if (!text.ends_with(' '))
            text += ' ';
    }
    if (text.size() <= most) return "\"" + text + "\"";
    std::size_t cut = most;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;  // not within a UTF-8 letter
    return "\"" + text.substr(0, cut) + "...\"";
}

void throwBadValue(std::string_view what, std::string_view expected, Tcl_Obj* word, std::string_view suggestion) {
    const std::string_view text = textOf(word);
    throw core::Error("VALUE", "RANGE", std::string(text),
                      std::string(what) + " must be " + std::string(expected) + ", not " + quoted(text) +
                          std::string(suggestion) + octalHint(text) + bracesHint(text));
}

std::string_view textOf(Tcl_Obj* object) {
    int length = 0;
    const char* text = Tcl_GetStringFromObj(object, &length);
    return {text, static_cast<std::size_t>(length)};
}

std::span<Tcl_Obj* const> elementsOf(Tcl_Obj* object, std::string_view what, std::string_view expected) {
    int count = 0;
    Tcl_Obj** elements = nullptr;
    if (Tcl_ListObjGetElements(nullptr, object, &count, &elements) != TCL_OK) throwBadValue(what, expected, object);
    return {elements, static_cast<std::size_t>(count)};
}

double numberFrom(Tcl_Obj* object, std::string_view what, const core::Range& range) {
    double x = 0;
    // Tcl refuses NaN by itself, but takes "Inf".
    if (Tcl_GetDoubleFromObj(nullptr, object, &x) != TCL_OK || !range.contains(x))
        throwBadValue(what, describe("a finite number", range), object);
    return x;
}

int integerFrom(Tcl_Obj* object, std::string_view what, const core::Range& range) {
    Tcl_WideInt x = 0;
    if (Tcl_GetWideIntFromObj(nullptr, object, &x) != TCL_OK || !range.contains(static_cast<double>(x)))
        throwBadValue(what, describe("an integer", range), object);
    return static_cast<int>(x);
}

void numbersFrom(Tcl_Obj* object, std::string_view what, const core::Range& range, std::span<double> numbers) {
    if (readNumbers(object, range, numbers)) return;
    // Made only when it is needed: a scene may hold a million vectors.
    const std::string kind = countText(numbers.size()) + " finite numbers";
    const bool isBounded = !core::rangeText(range).empty();
    throwBadValue(what, describe(isBounded ? kind + ", each" : kind, range), object);
}

void oneOrMoreFrom(Tcl_Obj* object, std::string_view what, const core::Range& range, std::span<double> numbers) {
    if (readNumbers(object, range, numbers.first(1))) {
        std::fill(numbers.begin(), numbers.end(), numbers[0]);
        return;
    }
    if (readNumbers(object, range, numbers)) return;
    const std::string kind = "one or " + countText(numbers.size()) + " finite numbers";
    throwBadValue(what, describe(kind + ", each", range), object);
}

glm::dvec3 vectorFrom(Tcl_Obj* object, std::string_view what, const core::Range& range) {
    std::array<double, 3> v;
    numbersFrom(object, what, range, v);
    return {v[0], v[1], v[2]};
}

core::Rgbf channelsFrom(Tcl_Obj* object, std::string_view what, const core::Range& range) {
    std::array<double, 3> v;
    oneOrMoreFrom(object, what, range, v);
    return core::Rgbf(glm::dvec3(v[0], v[1], v[2]));
}

core::Rgbf colourFrom(Tcl_Obj* object, std::string_view what, const core::Range& range) {
    // The most frequent form first: there may be one for each vertex of a mesh.
    int length = 0;
    if (Tcl_ListObjLength(nullptr, object, &length) == TCL_OK && length == 3)
        return core::Rgbf(vectorFrom(object, what, range));
    double grey = 0;
    if (readNumbers(object, range, {&grey, 1})) return core::Rgbf(static_cast<float>(grey));
    if (const auto colour = cssColour(textOf(object))) return *colour;
    const std::string numbers = describe("{r g b} or one number, each", range);
    throwBadValue(what, "a colour (" + numbers + ", #rrggbb or a CSS name)", object,
                  core::didYouMean(textOf(object), cssColourNames()));
}

std::string fileNameFrom(Tcl_Obj* object, std::string_view what) {
    const std::string_view text = textOf(object);
    Tcl_DString native;
    Tcl_UtfToExternalDString(nullptr, text.data(), static_cast<int>(text.size()), &native);
    const std::string name(Tcl_DStringValue(&native), static_cast<std::size_t>(Tcl_DStringLength(&native)));
    Tcl_DStringFree(&native);
    if (name.find('\0') != std::string::npos) throwBadValue(what, "a name without NUL", object);
    return name;
}

std::string_view Words::text(std::size_t i) const {
    return textOf(words_[i]);
}

double Words::number(std::size_t i, std::string_view what, const core::Range& range) const {
    return numberFrom(words_[i], what, range);
}

int Words::integer(std::size_t i, std::string_view what, const core::Range& range) const {
    return integerFrom(words_[i], what, range);
}

glm::dvec3 Words::vector(std::size_t i, std::string_view what, const core::Range& range) const {
    return vectorFrom(words_[i], what, range);
}

core::Rgbf Words::colour(std::size_t i, std::string_view what, const core::Range& range) const {
    return colourFrom(words_[i], what, range);
}

bool Words::isColour(std::size_t i) const {
    double number = 0;
    return listLength(i) != 1 || Tcl_GetDoubleFromObj(nullptr, words_[i], &number) == TCL_OK || cssColour(text(i));
}

std::string Words::textFrom(std::size_t i) const {
    const auto words = words_.subspan(i);
    return stringOf(hold(Tcl_NewListObj(static_cast<int>(words.size()), words.data())).get());
}

std::vector<std::string> Words::strings(std::size_t i, std::string_view what) const {
    std::vector<std::string> texts;
    for (Tcl_Obj* element : elementsOf(words_[i], what, "a list of names")) texts.emplace_back(textOf(element));
    return texts;
}

std::string Words::fileName(std::size_t i, std::string_view what) const {
    return fileNameFrom(words_[i], what);
}

std::size_t Words::listLength(std::size_t i) const {
    int length = 0;
    return Tcl_ListObjLength(nullptr, words_[i], &length) == TCL_OK ? static_cast<std::size_t>(length) : 0;
}

}  // namespace grsh
