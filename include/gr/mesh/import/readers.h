// What reads the formats of mesh files. To add one: its function here, in a file of its own, and its row in
// include/gr/mesh/mesh_formats.h and src/gr/mesh/import/mesh_reader.cpp.
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <functional>
#include <string_view>

namespace gr::importer {

// The bytes of a file below the mesh file's own folder, by its path relative to that; they stay where they are as long
// as the reader runs. Throws Failure where there is none.
using OtherFile = std::function<std::string_view(const std::string& path)>;

// Each makes a mesh of a file's bytes. Throws Failure, whose text tells what is wrong where, for what is not a whole
// file of its format. A count that the file announces is compared with what it holds before memory is asked for.

// Wavefront OBJ: polygons, u v, normals and colours of vertices, objects, groups and the names of materials.
SourceMesh readObj(std::string_view file);

// Stanford PLY, as text or binary: vertices with normals, u v and colours, faces and strips of triangles.
SourceMesh readPly(std::string_view file);

// STL, as text or binary. It has normals of faces only, which say no more than the faces.
SourceMesh readStl(std::string_view file);

// glTF 2, its text and its binary form: all nodes of a scene where they stand at rest, also those with skins and morph
// targets.
SourceMesh readGltf(std::string_view file, const OtherFile& others);
SourceMesh readGlb(std::string_view file, const OtherFile& others);

}  // namespace gr::importer
