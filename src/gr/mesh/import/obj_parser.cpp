#include "gr/mesh/import/obj_file.h"
#include "gr/mesh/import/srgb.h"
#include "gr/mesh/import/text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace gr::importer {
namespace {

// What else OBJ files have: lines, points, curves, and what only other renderers know of.
constexpr std::array<std::string_view, 33> otherStatements{
    "l",     "p",     "vp",   "cstype",     "deg",       "bmat",   "step",   "curv",  "curv2",    "surf",     "parm",
    "trim",  "hole",  "scrv", "sp",         "end",       "con",    "mg",     "bevel", "c_interp", "d_interp", "lod",
    "ctech", "stech", "call", "shadow_obj", "trace_obj", "maplib", "usemap", "csh",   "res",      "cdc",      "cdp"};
constexpr std::array<std::string_view, 5> drawn{"l", "p", "curv", "curv2", "surf"};

// The largest numbers of a kind that faces name before they are there: they may come later.
class NamedAhead {
public:
    void see(std::int64_t number, std::string_view word, int line) {
        if (!seen_.empty() && number <= seen_.back().number) return;
        seen_.push_back({number, {line, shown(word)}});
    }
    // count: how many there are at the end.
    void check(std::size_t count) const {
        // The first one that is too large is larger than all before it.
        for (const Seen& seen : seen_)
            if (seen.number > static_cast<std::int64_t>(count))
                throw Failure("line " + std::to_string(seen.mention.line) + ": a face names vertex " +
                              seen.mention.text + " of " + std::to_string(count));
    }

private:
    struct Seen {
        std::int64_t number;
        ObjMention mention;
    };
    std::vector<Seen> seen_;
};

class ObjParser {
public:
    explicit ObjParser(std::string_view file) : text_(withoutByteOrderMark(file)), lines_(text_) {}

    ObjFile parse() {
        std::string_view line;
        while (nextLine(line)) addStatement(line);
        ahead_.check(file_.mesh.vertices.size());
        return std::move(file_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Failure("line " + std::to_string(first_) + ": " + what);
    }

    // A line with those that continue it, each ending in a backslash but the last one; without its comment.
    bool nextLine(std::string_view& line) {
        if (!lines_.next(line)) return false;
        first_ = lines_.number();
        if (line.ends_with('\\') && !trimmed(line).starts_with('#')) {
            joined_.clear();
            do {
                joined_.append(line.substr(0, line.size() - 1)) += ' ';
                if (!lines_.next(line)) line = {};
            } while (line.ends_with('\\'));
            joined_ += line;
            line = joined_;
        }
        for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
            if (at > 0 && !isBlank(line[at - 1])) continue;
            line = line.substr(0, at);
            break;
        }
        return true;
    }

    void addStatement(std::string_view line) {
        const std::string_view key = takeWord(line);
        if (key.empty()) return;
        if (key == "v")
            addVertex(line);
        else if (key == "vn")
            file_.normals.emplace_back(numbers<3>(line));
        else if (key == "vt")
            addUv(line);
        else if (key == "f" || key == "fo")
            addFace(line);
        else if (key == "o" || key == "g")
            nameGroup(line);
        else if (key == "usemtl")
            useMaterial(line);
        else if (key == "mtllib")
            file_.libraries.push_back({first_, joinedWords(line)});
        else if (key != "s")
            leaveOut(key);
    }

    bool isLastAndCutOff() const { return lines_.rest().empty() && !text_.ends_with('\n') && !text_.ends_with('\r'); }

    double number(std::string_view word) const {
        double value;
        if (!readNumber(word, value)) fail("\"" + shown(word) + "\" is not a number");
        return value;
    }

    // As many numbers as there must be; there may be others behind them.
    template<int count>
    glm::vec<count, double> numbers(std::string_view& line) const {
        glm::vec<count, double> values(0);
        for (int i = 0; i < count; ++i) {
            const std::string_view word = takeWord(line);
            if (word.empty() && isLastAndCutOff()) throw Failure("its last line is cut off");
            if (word.empty()) fail(std::to_string(count) + " numbers are needed, not " + std::to_string(i));
            values[i] = number(word);
        }
        return values;
    }

    // Three coordinates, which a weight that only curves use may follow, or a colour, red, green, blue and perhaps
    // alpha.
    void addVertex(std::string_view line) {
        const std::string_view words = line;
        const glm::dvec3 place = numbers<3>(line);
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(place[axis]) <= mostCoordinate)) failAtCoordinate(words, axis);
        file_.mesh.vertices.push_back(place);
        if (trimmed(line).empty()) return;
        std::array<double, 3> colour{};
        for (double& part : colour) {
            const std::string_view word = takeWord(line);
            if (word.empty()) return;
            part = number(word);
        }
        setOf(file_.mesh.vertices.size() - 1, file_.colours, fromSrgb({colour[0], colour[1], colour[2]}),
              core::Rgbf(1));
    }

    [[noreturn]] void failAtCoordinate(std::string_view line, int axis) const {
        for (int i = 0; i < axis; ++i) takeWord(line);
        fail("\"" + shown(takeWord(line)) + "\" is not a number from -1e+18 to 1e+18");
    }

    // v may be left out, and there may be a third one.
    void addUv(std::string_view line) {
        const double u = numbers<1>(line).x;
        const std::string_view second = takeWord(line);
        file_.uvs.emplace_back(u, second.empty() ? 0 : number(second));
    }

    void addFace(std::string_view line) {
        std::vector<int>& corners = file_.mesh.corners;
        const std::size_t first = corners.size();
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) addCorner(word);
        if (corners.size() - first >= 3) return file_.mesh.endFace();
        if (isLastAndCutOff()) throw Failure("its last line is cut off");
        corners.resize(first);
        for (std::vector<int>* places : {&file_.uvOf, &file_.normalOf}) places->resize(std::min(places->size(), first));
        ++file_.mesh.linesAndPoints;
    }

    // v, v/vt, v//vn or v/vt/vn, of which slashes at the end may be left.
    void addCorner(std::string_view word) {
        std::string_view left = word;
        const std::size_t corner = file_.mesh.corners.size();
        file_.mesh.corners.push_back(takeVertex(left, word));
        if (left.empty()) return;
        left.remove_prefix(1);
        if (!left.empty() && left[0] != '/') setOf(corner, file_.uvOf, takeOther(left, word, file_.uvs.size()), -1);
        if (left.empty()) return;
        left.remove_prefix(1);
        if (left.empty()) return;
        setOf(corner, file_.normalOf, takeOther(left, word, file_.normals.size()), -1);
        if (!left.empty()) failAtCorner(word);
    }

    [[noreturn]] void failAtCorner(std::string_view word) const {
        fail("\"" + shown(word) + "\" is not a corner: it must be v, v/vt, v//vn or v/vt/vn");
    }

    // Numbers count from 1, or backwards from -1, the last one so far.
    static constexpr std::int64_t mostNumber = std::numeric_limits<int>::max();

    std::int64_t takeNumber(std::string_view& left, std::string_view corner) const {
        std::int64_t number = 0;
        const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), number);
        if (error == std::errc::result_out_of_range) number = left.starts_with('-') ? -mostNumber : mostNumber;
        left.remove_prefix(static_cast<std::size_t>(end - left.data()));
        if (error == std::errc::invalid_argument || (!left.empty() && left[0] != '/')) failAtCorner(corner);
        return std::clamp(number, -mostNumber, mostNumber);
    }

    // A place in the list of vertices, which may still have to come.
    int takeVertex(std::string_view& left, std::string_view corner) {
        const std::int64_t number = takeNumber(left, corner), count = std::ssize(file_.mesh.vertices);
        const std::string_view word = corner.substr(0, corner.size() - left.size());
        if (number == 0 || -number > count) fail("a face names vertex " + shown(word) + " of " + std::to_string(count));
        if (number > count) ahead_.see(number, word, first_);
        return static_cast<int>(number > 0 ? number - 1 : count + number);
    }

    // A place in another list; what can never be there is beyond every list's end.
    int takeOther(std::string_view& left, std::string_view corner, std::size_t count) const {
        const std::int64_t number = takeNumber(left, corner), backwards = static_cast<std::int64_t>(count) + number;
        if (number > 0) return static_cast<int>(number - 1);
        return static_cast<int>(number == 0 || backwards < 0 ? mostNumber : backwards);
    }

    static std::string joinedWords(std::string_view line) {
        std::string text;
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            if (!text.empty()) text += ' ';
            text += word;
        }
        return text;
    }

    void nameGroup(std::string_view line) {
        const std::string name = joinedWords(line);
        if (name.empty()) return;
        name_ = name;
        file_.mesh.beginGroup(name_, material_);
    }

    void useMaterial(std::string_view line) {
        material_ = joinedWords(line);
        file_.materials.push_back({first_, material_});
        file_.mesh.beginGroup(name_, material_);
    }

    void leaveOut(std::string_view key) {
        if (std::find(otherStatements.begin(), otherStatements.end(), key) == otherStatements.end())
            fail("\"" + shown(key).substr(0, 21) + "\" is nothing that an OBJ file has");
        file_.mesh.linesAndPoints += std::find(drawn.begin(), drawn.end(), key) != drawn.end();
        for (const ObjMention& mention : file_.leftOut)
            if (mention.text == key) return;
        file_.leftOut.push_back({first_, std::string(key)});
    }

    std::string_view text_;
    TextLines lines_;
    int first_ = 0;  // number of the line that the statement begins in
    std::string joined_;
    ObjFile file_;
    NamedAhead ahead_;
    std::string name_, material_;
};

}  // namespace

ObjFile parseObj(std::string_view file) {
    return ObjParser(file).parse();
}

}  // namespace gr::importer
