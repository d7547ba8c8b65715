#include "gr/mesh/import/obj_words.h"

#include "gr/mesh/import/mapped_files.h"
#include "gr/mesh/import/obj_file.h"

#include <fcntl.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>

namespace gr::importer {
namespace {

class Words {
public:
    ~Words() { std::fwrite(text_.data(), 1, text_.size(), stdout); }

    void begin(const char* key) { text_.append(key).append(" {"); }
    void end() { text_ += "}\n"; }
    // Texts are anything at all.
    void add(const std::string& text) {
        text_ += '"';
        for (const char c : text) {
            if (std::strchr("\"\\[]{}$", c) != nullptr) text_ += '\\';
            text_ += c;
        }
        text_ += "\" ";
    }
    void add(std::int64_t number) { text_.append(std::to_string(number)) += ' '; }
    // Never like a whole number: Tcl divides those otherwise.
    template<class Vector>
    void addVector(const Vector& vector) {
        text_ += '{';
        for (int axis = 0; axis < 3; ++axis) {
            char digits[40];
            const auto [end, error] = std::to_chars(digits, digits + sizeof digits, vector[axis]);
            const std::string_view word(digits, static_cast<std::size_t>(end - digits));
            text_.append(word).append(word.find_first_of(".en") == word.npos ? ".0 " : " ");
        }
        text_ += "} ";
    }
    void add(const char* key, const std::vector<ObjMention>& mentions) {
        begin(key);
        for (const ObjMention& mention : mentions) {
            add(mention.line);
            add(mention.text);
        }
        end();
    }
    void open() { text_ += '{'; }
    void close() { text_ += "} "; }

private:
    std::string text_;
};

// The number of the normal that a corner has, or -1. absent: counts those which are not there.
int normalOf(const ObjFile& file, int corner, std::int64_t& absent) {
    const auto at = static_cast<std::size_t>(corner);
    if (at >= file.normalOf.size() || file.normalOf[at] < 0) return -1;
    if (file.normalOf[at] < std::ssize(file.normals)) return file.normalOf[at];
    ++absent;
    return -1;
}

void addParts(const ObjFile& file, Words& words, std::int64_t& absent) {
    const SourceMesh& mesh = file.mesh;
    std::vector<SourceGroup> groups = mesh.groups;
    if (groups.empty()) groups.push_back({"", "", 0});
    const auto endOf = [&](int face) {
        return mesh.ends.empty() ? 3 * face + 3 : mesh.ends[static_cast<std::size_t>(face)];
    };
    int face = 0, corner = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const int end = i + 1 < groups.size() ? groups[i + 1].firstFace : mesh.faceCount();
        if (face == end) continue;
        words.add(groups[i].name);
        words.add(groups[i].material);
        words.open();
        for (; face < end; ++face) {
            words.open();
            for (; corner < endOf(face); ++corner) {
                words.open();
                words.add(mesh.corners[static_cast<std::size_t>(corner)]);
                words.add(normalOf(file, corner, absent));
                words.close();
            }
            words.close();
        }
        words.close();
    }
}

void writeWords(const ObjFile& file) {
    Words words;
    words.begin("vertices");
    for (const glm::dvec3& vertex : file.mesh.vertices) words.addVector(vertex);
    words.end();
    words.begin("normals");
    for (const core::Vec3f& normal : file.normals) words.addVector(normal);
    words.end();
    std::int64_t absent = 0;
    words.begin("parts");
    addParts(file, words, absent);
    words.end();
    words.add("libraries", file.libraries);
    words.add("materials", file.materials);
    words.add("leftOut", file.leftOut);
    words.begin("absent");
    words.add(absent);
    words.end();
}

}  // namespace

int writeObjWords(const char* path) {
    try {
        const core::Descriptor descriptor(open(path, O_RDONLY | O_CLOEXEC));
        if (!descriptor.isOpen()) throw Failure(std::strerror(errno));
        const MappedFile file(descriptor.number(), path);
        writeWords(parseObj(file.bytes()));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

}  // namespace gr::importer
