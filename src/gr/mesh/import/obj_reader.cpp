#include "gr/mesh/import/obj_file.h"
#include "gr/mesh/import/readers.h"

namespace gr::importer {
namespace {

// What the corners have that name places in a list. absent: counts those that name what is not there.
template<class Value>
std::vector<Value> valuesAt(const std::vector<int>& places, const std::vector<Value>& values, const Value& none,
                            std::uint32_t& absent) {
    std::vector<Value> ofCorners(places.size(), none);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] < 0) continue;
        const auto place = static_cast<std::size_t>(places[i]);
        if (place < values.size())
            ofCorners[i] = values[place];
        else
            ++absent;
    }
    return values.empty() ? std::vector<Value>() : ofCorners;
}

}  // namespace

SourceMesh toMesh(ObjFile&& file) {
    SourceMesh mesh = std::move(file.mesh);
    std::vector<PackedNormal> normals(file.normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = packedOrNone(file.normals[i]);
    mesh.normals = valuesAt(file.normalOf, normals, noNormal, mesh.absentReferences);
    mesh.uvs = valuesAt(file.uvOf, file.uvs, core::Vec2f(0), mesh.absentReferences);
    if (file.colours.empty()) return mesh;
    file.colours.resize(mesh.vertices.size(), core::Rgbf(1));
    mesh.colours.reserve(mesh.corners.size());
    for (const int corner : mesh.corners) mesh.colours.push_back(file.colours[static_cast<std::size_t>(corner)]);
    return mesh;
}

SourceMesh readObj(std::string_view file) {
    return toMesh(parseObj(file));
}

}  // namespace gr::importer
