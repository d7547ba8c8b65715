// grsh_import: reads a mesh file and writes what it holds; see include/gr/mesh/mesh_import.h. What it is to do is one
// word, the format's ending. With the words --words and a file's name it writes an OBJ file to its standard output as
// words of Tcl, for tools.
#include "core/reader_child.h"
#include "gr/mesh/import/joined_mesh.h"
#include "gr/mesh/import/mapped_files.h"
#include "gr/mesh/import/mesh_reader.h"
#include "gr/mesh/import/obj_words.h"
#include "gr/mesh/mesh_import.h"

#include <unistd.h>

#include <new>
#include <string_view>

namespace {

using namespace gr::importer;
namespace reader = core::reader;

std::uint32_t sizeOf(const auto& values) {
    return static_cast<std::uint32_t>(values.size());
}

// Numbers and texts of things of which there are few.
struct Listed {
    std::vector<std::int64_t> numbers;
    std::string texts;  // each with a zero behind it

    void add(const std::string& text) { texts.append(text.substr(0, text.find('\0'))) += '\0'; }
};

void putMesh(const JoinedMesh& joined, const FilesBelow& others) {
    const SourceMesh& source = joined.source;
    Listed groups, files;
    for (const SourceGroup& group : source.groups) {
        groups.numbers.push_back(group.firstFace);
        groups.add(group.name);
        groups.add(group.material);
    }
    for (const MappedFile& file : others.opened()) {
        files.numbers.insert(files.numbers.end(), {static_cast<std::int64_t>(file.bytes().size()), file.changed()});
        files.add(file.name);
    }
    const gr::ImportHeader header{.vertices = sizeOf(joined.vertices),
                                  .corners = sizeOf(source.corners),
                                  .ends = sizeOf(source.ends),
                                  .normals = sizeOf(source.normals),
                                  .uvs = sizeOf(source.uvs),
                                  .colours = sizeOf(source.colours),
                                  .groups = sizeOf(groups.numbers),
                                  .groupTexts = sizeOf(groups.texts),
                                  .files = sizeOf(others.opened()),
                                  .fileTexts = sizeOf(files.texts),
                                  .linesAndPoints = source.linesAndPoints,
                                  .absentReferences = source.absentReferences,
                                  .origin = joined.origin};
    reader::putSuccess();
    reader::put(&header, sizeof header);
    reader::put(joined.vertices);
    reader::put(source.corners);
    reader::put(source.ends);
    reader::put(source.normals);
    reader::put(source.uvs);
    reader::put(source.colours);
    reader::put(groups.numbers);
    reader::put(groups.texts.data(), groups.texts.size());
    reader::put(files.numbers);
    reader::put(files.texts.data(), files.texts.size());
}

void importFile(std::string_view ending) {
    const MappedFile file(gr::importFile, "it");
    FilesBelow others(gr::importFolder);
    putMesh(join(readMeshFile(ending, file.bytes(), [&](const std::string& path) { return others.bytesOf(path); })),
            others);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "--words") return writeObjWords(argv[2]);
    if (argc != reader::firstWord + 1) return 2;
    reader::begin(argv);
    reader::confineTo(gr::importFolder);
    constexpr std::string_view tooLarge = "it asks for more memory than a file of its size should";
    try {
        importFile(argv[reader::firstWord]);
    } catch (const std::bad_alloc&) {
        reader::putError(tooLarge);
    } catch (const std::length_error&) {
        reader::putError(tooLarge);
    } catch (const std::exception& error) {
        reader::putError(error.what());
    }
    _exit(0);  // without giving back what is given back anyway
}
