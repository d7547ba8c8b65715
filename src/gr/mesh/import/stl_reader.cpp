#include "gr/mesh/import/readers.h"
#include "gr/mesh/import/text.h"

#include <bit>
#include <cstring>

namespace gr::importer {
namespace {

constexpr std::size_t headerSize = 84, triangleSize = 50;

std::string countOf(std::uint64_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// 80 bytes of any kind, the number of triangles, and 50 bytes for each of them: its normal, its corners, all of them
// floats, and two bytes whose meaning is each program's own.
SourceMesh readBinary(std::string_view file, std::uint64_t count) {
    static_assert(std::endian::native == std::endian::little);
    SourceMesh mesh;
    mesh.vertices.reserve(3 * count);
    mesh.corners.reserve(3 * count);
    for (std::uint64_t i = 0; i < count; ++i) {
        float places[9];
        std::memcpy(places, file.data() + headerSize + triangleSize * i + 3 * sizeof(float), sizeof places);
        for (int corner = 0; corner < 3; ++corner) {
            mesh.corners.push_back(static_cast<int>(mesh.vertices.size()));
            mesh.vertices.emplace_back(places[3 * corner], places[3 * corner + 1], places[3 * corner + 2]);
        }
        mesh.endFace();
    }
    return mesh;
}

// Words in capitals or not; where lines end means nothing but for a solid's name.
class StlText {
public:
    explicit StlText(std::string_view file) : lines_(file) {}

    SourceMesh read() {
        while (nextWord()) {
            if (isAt("solid")) {
                mesh_.beginGroup(std::string(trimmed(line_)), "");
                line_ = {};
                isInSolid_ = true;
            } else if (isAt("facet")) {
                readFacet();
            } else if (isAt("endsolid")) {
                endSolid();
            } else if (isAt("end")) {
                expect("solid");
                endSolid();
            } else {
                fail("solid, facet or endsolid");
            }
        }
        if (isInSolid_) failAtEnd("endsolid");
        return std::move(mesh_);
    }

private:
    bool isAt(std::string_view word) const { return isWord(word_, word); }
    [[noreturn]] void fail(const std::string& wanted) const {
        lines_.fail("\"" + shown(word_) + "\" stands where " + wanted + " must be");
    }
    [[noreturn]] static void failAtEnd(const std::string& keyword) {
        throw Failure("it has no line \"" + keyword + "\": its end is missing");
    }

    // The name behind it says nothing.
    void endSolid() {
        line_ = {};
        isInSolid_ = false;
    }

    bool nextWord() {
        for (word_ = takeWord(line_); word_.empty(); word_ = takeWord(line_))
            if (!lines_.next(line_)) return false;
        return true;
    }
    void expect(const char* keyword) {
        if (!nextWord()) failAtEnd("endsolid");
        if (!isAt(keyword)) fail(keyword);
    }
    double number() {
        double value;
        if (!nextWord()) failAtEnd("endsolid");
        if (!readNumber(word_, value)) lines_.fail("\"" + shown(word_) + "\" is not a number");
        return value;
    }

    void readFacet() {
        // The normal may be missing, or be no number.
        while (nextWord() && !isAt("outer"))
            if (isAt("vertex") || isAt("endfacet")) fail("outer loop");
        expect("loop");
        for (nextWord(); isAt("vertex"); nextWord()) {
            const double x = number(), y = number(), z = number();
            mesh_.corners.push_back(static_cast<int>(mesh_.vertices.size()));
            mesh_.vertices.emplace_back(x, y, z);
            ++corners_;
        }
        if (word_.empty()) failAtEnd("endsolid");
        if (!isAt("endloop")) fail("vertex or endloop");
        if (corners_ < 3) lines_.fail("a facet needs 3 vertices at least, not " + std::to_string(corners_));
        corners_ = 0;
        mesh_.endFace();
        expect("endfacet");
    }

    TextLines lines_;
    std::string_view line_, word_;
    int corners_ = 0;  // of the facet
    bool isInSolid_ = false;
    SourceMesh mesh_;
};

// Files of both kinds may begin with "solid"; text goes on with a line that begins with one of two words.
bool isText(std::string_view text) {
    TextLines lines(text);
    std::string_view line, word;
    while (word.empty() && lines.next(line)) word = takeWord(line);
    if (!isWord(word, "solid")) return false;
    word = {};
    while (word.empty() && lines.next(line)) word = takeWord(line);
    const bool isOneLine = lines.rest().empty() && text.find('\0') == text.npos;
    return isWord(word, "facet") || isWord(word, "endsolid") || isWord(word, "end") || isOneLine;
}

}  // namespace

SourceMesh readStl(std::string_view file) {
    std::uint64_t size = 0, count = 0;
    if (file.size() >= headerSize) {
        std::uint32_t announced;
        std::memcpy(&announced, file.data() + 80, sizeof announced);
        count = announced;
        size = headerSize + triangleSize * count;
    }
    if (file.size() != size) {
        const std::string_view text = withoutByteOrderMark(file);
        if (isText(text)) return StlText(text).read();
        if (file.size() < headerSize) throw Failure("it is shorter than the header of an STL file");
        // A byte or two behind the last triangle mean nothing, but room for one more would.
        if (file.size() < size || file.size() - size >= triangleSize)
            throw Failure("it announces " + countOf(count, "triangle") + ", which take " + std::to_string(size) +
                          " bytes, and has " + std::to_string(file.size()));
    }
    return readBinary(file, count);
}

}  // namespace gr::importer
