#include "gr/mesh/import/mesh_reader.h"

#include "gr/mesh/import/readers.h"
#include "gr/mesh/mesh_formats.h"

#include <algorithm>

namespace gr::importer {
namespace {

struct Format {
    std::string_view ending;
    SourceMesh (*read)(std::string_view file, const OtherFile& others);
};

constexpr std::array<Format, 5> formats{{
    {".obj", [](std::string_view file, const OtherFile&) { return readObj(file); }},
    {".ply", [](std::string_view file, const OtherFile&) { return readPly(file); }},
    {".stl", [](std::string_view file, const OtherFile&) { return readStl(file); }},
    {".gltf", readGltf},
    {".glb", readGlb},
}};
static_assert(std::equal(formats.begin(), formats.end(), meshEndings.begin(), meshEndings.end(),
                         [](const Format& format, std::string_view ending) { return format.ending == ending; }));

}  // namespace

SourceMesh readMeshFile(std::string_view ending, std::string_view file, const OtherFile& others) {
    for (const Format& format : formats)
        if (format.ending == ending) return format.read(file, others);
    throw Failure("there is no format \"" + std::string(ending) + "\"");
}

}  // namespace gr::importer
