#include "grsh/words.h"

namespace grsh {
namespace {

// a finite number, a finite number greater than 0, an integer from 1 to 16
std::string describe(std::string_view kind, const core::Range& range) {
    const std::string text = core::rangeText(range);
    if (text.empty()) return std::string(kind);
    const bool isInterval = text[0] == '-' || (text[0] >= '0' && text[0] <= '9');
    return std::string(kind) + (isInterval ? " from " : " ") + text;
}

// Tcl reads a number that begins with 0 as octal, and refuses 08 and 09.
bool isBadOctal(std::string_view number) {
    if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
    return number.starts_with('0') && number.find_first_not_of("0123456789") == std::string_view::npos &&
           number.find_first_of("89") != std::string_view::npos;
}

std::string octalHint(std::string_view words) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find_first_of(" \t\n{}"), words.size());
        if (isBadOctal(words.substr(0, end))) return " (a leading 0 makes a number octal)";
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return "";
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

void throwBadValue(std::string_view what, std::string_view expected, Tcl_Obj* word) {
    throw core::Error("VALUE", "RANGE", std::string(textOf(word)),
                      std::string(what) + " must be " + std::string(expected) + ", not " + quoted(textOf(word)) +
                          octalHint(textOf(word)));
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
    // Made only when it is needed: a scene may hold a million vectors.
    const auto refuse = [&] {
        constexpr std::string_view counts[] = {"two", "three", "four"};
        const std::string kind = std::string(counts[numbers.size() - 2]) + " finite numbers";
        const bool isBounded = !core::rangeText(range).empty();
        throwBadValue(what, describe(isBounded ? kind + ", each" : kind, range), object);
    };
    int count = 0;
    Tcl_Obj** elements = nullptr;
    if (Tcl_ListObjGetElements(nullptr, object, &count, &elements) != TCL_OK) refuse();
    if (static_cast<std::size_t>(count) != numbers.size()) refuse();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool isNumber = Tcl_GetDoubleFromObj(nullptr, elements[i], &numbers[i]) == TCL_OK;
        if (!isNumber || !range.contains(numbers[i])) refuse();
    }
}

glm::dvec3 vectorFrom(Tcl_Obj* object, std::string_view what, const core::Range& range) {
    std::array<double, 3> v;
    numbersFrom(object, what, range, v);
    return {v[0], v[1], v[2]};
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
    return core::Rgbf(vector(i, what, range));
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
