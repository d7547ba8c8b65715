// The words of a command, read as what the command needs. What cannot be read is a core::Error that says which word it
// is, what it may be and what it was.
#pragma once

#include "core/error.h"
#include "core/option.h"

#include <tcl.h>

#include <algorithm>

namespace grsh {

class Words {
public:
    // The words behind the command's name.
    Words(int objc, Tcl_Obj* const objv[]) : words_(objv + 1, static_cast<std::size_t>(objc - 1)) {}

    std::size_t size() const { return words_.size(); }
    Tcl_Obj* object(std::size_t i) const { return words_[i]; }
    std::string_view text(std::size_t i) const;

    // what: the name of the word in messages, e.g. "radius".
    double number(std::size_t i, std::string_view what, const core::Range& range = core::anyNumber) const;
    int integer(std::size_t i, std::string_view what, const core::Range& range) const;
    glm::dvec3 vector(std::size_t i, std::string_view what, const core::Range& range = core::anyNumber) const;
    core::Rgbf colour(std::size_t i, std::string_view what, const core::Range& range) const;
    std::vector<std::string> strings(std::size_t i, std::string_view what) const;
    std::string fileName(std::size_t i, std::string_view what) const;
    // Whether the word may be meant as a colour: a number, one that the web knows, or a list of other than one element.
    bool isColour(std::size_t i) const;
    // The words from the i-th on as one list.
    std::string textFrom(std::size_t i) const;
    // How many elements the word has when read as a list; 0 also when it is none.
    std::size_t listLength(std::size_t i) const;

private:
    std::span<Tcl_Obj* const> words_;
};

std::string_view textOf(Tcl_Obj* object);
// The elements of a list, or a core::Error that says what it should be.
std::span<Tcl_Obj* const> elementsOf(Tcl_Obj* object, std::string_view what, std::string_view expected);
double numberFrom(Tcl_Obj* object, std::string_view what, const core::Range& range);
// Whole numbers within int; the range must say so too.
int integerFrom(Tcl_Obj* object, std::string_view what, const core::Range& range);
// A list of as many numbers as there is room for in `numbers`.
void numbersFrom(Tcl_Obj* object, std::string_view what, const core::Range& range, std::span<double> numbers);
// The same, or one number that stands for all of them.
void oneOrMoreFrom(Tcl_Obj* object, std::string_view what, const core::Range& range, std::span<double> numbers);
glm::dvec3 vectorFrom(Tcl_Obj* object, std::string_view what, const core::Range& range);
// Linear: {r g b}, one number for grey, or a colour as the web writes it (css_colours.h).
core::Rgbf colourFrom(Tcl_Obj* object, std::string_view what, const core::Range& range);
// An amount of each channel that is no colour, so that a colour's name would say something else: {r g b} or one number.
core::Rgbf channelsFrom(Tcl_Obj* object, std::string_view what, const core::Range& range);
// A file's name as the system has it: Tcl's own UTF-8 has NUL, and letters beyond the first 65536, in another way.
std::string fileNameFrom(Tcl_Obj* object, std::string_view what);
// The word in quotes for a message: one line, its white space as single blanks, cut where it is long.
std::string quoted(std::string_view word);
// "{what} must be {expected}, not "word"{suggestion}"
[[noreturn]] void throwBadValue(std::string_view what, std::string_view expected, Tcl_Obj* word,
                                std::string_view suggestion = {});

}  // namespace grsh
