// A Wavefront OBJ file as it stands there.
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <string_view>

namespace gr::importer {

// A word that stands in a line, which is counted from 1.
struct ObjMention {
    int line;
    std::string text;
};

struct ObjFile {
    // Its vertices, corners, ends and groups; each corner's normal, u v and colour are below.
    SourceMesh mesh;
    std::vector<core::Rgbf> colours;  // of vertices, as SourceMesh has those of corners
    std::vector<core::Vec2f> uvs;
    std::vector<core::Vec3f> normals;
    // Of each corner: places in `uvs` and `normals`, or -1. A place may be beyond the list's end: the file names what
    // it does not have.
    std::vector<int> uvOf, normalOf;

    std::vector<ObjMention> libraries;  // what each mtllib names
    std::vector<ObjMention> materials;  // what each usemtl names
    std::vector<ObjMention> leftOut;  // keywords of what is neither polygon nor part of one, each once
};

// Throws Failure.
ObjFile parseObj(std::string_view file);

// The same with each corner's own values.
SourceMesh toMesh(ObjFile&& file);

}  // namespace gr::importer
