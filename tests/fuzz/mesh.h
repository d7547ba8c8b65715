// What fuzzers of mesh files share.
#pragma once

#include "core/error.h"
#include "gr/mesh/import/joined_mesh.h"
#include "gr/mesh/import/readers.h"
#include "gr/mesh/polyhedron.h"

#include <cstdint>
#include <cstdlib>
#include <new>

namespace fuzz {

// Every list is as long as it should be, and every corner names a vertex.
inline bool isSound(const gr::importer::JoinedMesh& joined) {
    const gr::importer::SourceMesh& mesh = joined.source;
    const std::size_t corners = mesh.corners.size();
    const auto fits = [&](const auto& list) { return list.empty() || list.size() == corners; };
    bool isSound = corners > 0 && fits(mesh.normals) && fits(mesh.uvs) && fits(mesh.colours);
    isSound &= mesh.ends.empty() ? corners % 3 == 0 : static_cast<std::size_t>(mesh.ends.back()) == corners;
    for (const int vertex : mesh.corners)
        isSound &= vertex >= 0 && static_cast<std::size_t>(vertex) < joined.vertices.size();
    for (const gr::importer::SourceGroup& group : mesh.groups) isSound &= group.firstFace <= mesh.faceCount();
    return isSound;
}

// Reads a mesh and makes of it what is rendered; errors that are told are right, whatever the bytes are.
template<class Read>
void readMesh(const std::uint8_t* bytes, std::size_t size, const Read& read) {
    try {
        gr::importer::JoinedMesh joined = join(read(std::string_view(reinterpret_cast<const char*>(bytes), size)));
        if (!isSound(joined)) std::abort();
        gr::FlatMesh mesh;
        mesh.vertices.assign(joined.vertices.begin(), joined.vertices.end());
        mesh.corners = std::move(joined.source.corners);
        mesh.ends = std::move(joined.source.ends);
        mesh.normals = std::move(joined.source.normals);
        gr::MeshRepairs repairs;
        gr::Polyhedron::make(std::move(mesh), repairs);
    } catch (const gr::importer::Failure&) {
    } catch (const core::Error&) {
    } catch (const std::bad_alloc&) {
    }
}

}  // namespace fuzz
