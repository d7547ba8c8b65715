// Mesh files are read by a program of their own, grsh_import: the library that reads them is large, and files from
// anywhere may make it crash, hang or ask for all memory. Only that program suffers then, and grsh starts without it.
#pragma once

#include "core/open_below.h"
#include "gr/mesh/polyhedron.h"

namespace gr {

// What grsh_import writes (core/reader_process.h): this, the vertices (three floats each), the corners, the faces' ends
// and the corners' normals, as FlatMesh has them.
struct ImportHeader {
    std::uint32_t vertices = 0;
    std::uint32_t corners = 0;
    std::uint32_t ends = 0;
    std::uint32_t normals = 0;
    std::uint32_t linesAndPoints = 0;
};

// No two of its vertices are at one place. Throws core::Error whose text is the reason. repairs: counts what is no
// face. below: the folder that all files lie below, or null.
FlatMesh importMesh(const std::string& path, MeshRepairs& repairs, const core::Folder* below = nullptr);

}  // namespace gr
