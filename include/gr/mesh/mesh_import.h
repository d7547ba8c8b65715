// Mesh files are read by a program of their own, grsh_import: files from anywhere may make a reader crash, hang or ask
// for all memory. Only that program suffers then, and it can do nothing but read.
#pragma once

#include "core/reader_child.h"
#include "gr/mesh/polyhedron.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gr {

// What grsh_import writes first; then what ImportedMesh holds, in its order. Texts end in a zero each.
struct ImportHeader {
    std::uint32_t vertices = 0;  // three floats each, relative to the origin
    std::uint32_t corners = 0;
    std::uint32_t ends = 0;
    std::uint32_t normals = 0;
    std::uint32_t uvs = 0;
    std::uint32_t colours = 0;
    std::uint32_t groups = 0;  // where each begins; then their texts: its name and its material's for each
    std::uint32_t groupTexts = 0;  // bytes
    std::uint32_t files = 0;  // size and time of each; then their texts: its path
    std::uint32_t fileTexts = 0;  // bytes
    std::uint32_t linesAndPoints = 0;
    std::uint32_t absentReferences = 0;
    glm::dvec3 origin{0};
};

// What grsh_import finds open: the file, and the folder where that lies, below which all lies that the file names.
inline constexpr int importFile = core::reader::input, importFolder = core::reader::input + 1;

// A file that a mesh file names, as it was when it was read.
struct NamedFile {
    std::string path;  // from the mesh file's folder
    std::int64_t size, changed;  // in bytes; when, in nanoseconds
};

struct ImportedMesh {
    FlatMesh mesh;  // no two of its vertices are at one place
    std::vector<NamedFile> files;
};

// file: open, a regular file; ending: one of meshEndings; folder: open. Throws core::Error whose text is the reason.
// repairs: counts what is left out.
ImportedMesh importMesh(int file, const std::string& ending, int folder, MeshRepairs& repairs);

}  // namespace gr
