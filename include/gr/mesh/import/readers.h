// What reads the formats of mesh files. To add one: its function here, in a file of its own, and its row in
// include/gr/mesh/mesh_formats.h and src/gr/mesh/import/mesh_reader.cpp.
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <functional>
#include <string_view>

namespace gr::importer {

// Gives the bytes of a file that lies below the mesh file's own folder. path: relative to that folder, parted by '/',
// without "." and "..". The bytes stay where they are as long as the reader runs. Throws Failure where there is none.
using OtherFile = std::function<std::string_view(const std::string& path)>;

// Each makes a mesh of a file's bytes. Throws Failure, whose text tells what is wrong where, for what is not a whole
// file of its format. A count that the file announces is compared with what it holds before memory is asked for.

// Wavefront OBJ: polygons, u v, normals and colours of vertices, objects, groups and the names of materials.
SourceMesh readObj(std::string_view file);

// Stanford PLY, as text or binary: vertices with normals, u v and colours, faces and strips of triangles.
SourceMesh readPly(std::string_view file);

// STL, as text or binary. It has normals of faces only, which say no more than the faces.
SourceMesh readStl(std::string_view file);

// glTF 2, as JSON text with its buffers beside it, or in one file. All faces of the file's scene: its default one, or
// its first one, or all nodes where there are no scenes. Meshes stand as they do before any animation begins, with
// their skins and morph targets. Lengths are the file's, which are metres; y is upwards. Pictures, lights and cameras
// are not read.
SourceMesh readGltf(std::string_view file, const OtherFile& others);
SourceMesh readGlb(std::string_view file, const OtherFile& others);

}  // namespace gr::importer
