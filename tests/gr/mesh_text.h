// Mesh files in a folder that is gone with the test.
#pragma once

#include "gr/mesh/mesh_file.h"
#include "support/temporary_folder.h"

#include <fstream>

namespace gr {

class MeshFolder : public support::TemporaryFolder {
public:
    std::string write(const std::string& name, std::string_view bytes) const {
        std::ofstream(*this / name, std::ios::binary) << bytes;
        return *this / name;
    }
};

// Numbers as they are in memory.
template<class... T>
std::string bytesOf(const T&... numbers) {
    std::string bytes;
    (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
    return bytes;
}

// [0, 1] x [0, 2] x [0, 3]: 8 vertices, 6 faces outwards.
inline constexpr float blockVertices[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0},
                                              {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}};
inline constexpr int blockFaces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                         {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}};
inline constexpr int blockCuts[2][3] = {{0, 1, 2}, {0, 2, 3}};  // of a face into triangles

inline std::string vertexText(const float* v) {
    return std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
}

inline std::string blockObj() {
    std::string text;
    for (const auto& v : blockVertices) text += "v " + vertexText(v);
    for (const auto& f : blockFaces) {
        text += "f";
        for (const int i : f) text += " " + std::to_string(i + 1);
        text += "\n";
    }
    return text;
}

inline std::string plyHeader(const std::string& format, const std::string& vertices, const std::string& faces) {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string blockPly() {
    std::string text = plyHeader("ascii", "8", "6");
    for (const auto& v : blockVertices) text += vertexText(v);
    for (const auto& f : blockFaces) {
        text += "4";
        for (const int i : f) text += " " + std::to_string(i);
        text += "\n";
    }
    return text;
}

inline std::string blockBinaryPly() {
    std::string bytes = plyHeader("binary_little_endian", "8", "6");
    for (const auto& v : blockVertices) bytes += bytesOf(v[0], v[1], v[2]);
    for (const auto& f : blockFaces) bytes += bytesOf(char{4}, f[0], f[1], f[2], f[3]);
    return bytes;
}

inline std::string blockStl() {
    std::string text = "solid block\n";
    for (const auto& f : blockFaces)
        for (const auto& cut : blockCuts) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int i : cut) text += "vertex " + vertexText(blockVertices[f[i]]);
            text += "endloop\nendfacet\n";
        }
    return text + "endsolid block\n";
}

inline std::string blockBinaryStl() {
    std::string bytes(80, ' ');
    bytes += bytesOf(12);
    for (const auto& f : blockFaces)
        for (const auto& cut : blockCuts) {
            bytes += bytesOf(0.f, 0.f, 0.f);
            for (const int i : cut) bytes += bytesOf(blockVertices[f[i]]);
            bytes += bytesOf(short{0});
        }
    return bytes;
}

// The binary part of a glTF file: the vertices, then the triangles' corners.
inline std::string blockBuffer() {
    std::string bytes = bytesOf(blockVertices);
    for (const auto& f : blockFaces)
        for (const auto& cut : blockCuts)
            for (const int i : cut) bytes += bytesOf(static_cast<unsigned short>(f[i]));
    return bytes;
}

// nodes: glTF's list of them; buffer: what its buffer is besides its length.
inline std::string blockGltf(const std::string& nodes, const std::string& buffer, int vertices = 8) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":168)" +
           buffer + R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},)" +
           R"({"buffer":0,"byteOffset":96,"byteLength":72}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
           std::to_string(vertices) +
           R"(,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}]})";
}

inline std::string blockGlb() {
    std::string json = blockGltf(R"([{"mesh":0}])", "");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer = blockBuffer();
    const auto size = [](const std::string& s) { return static_cast<std::uint32_t>(s.size()); };
    return "glTF" + bytesOf(2, 28 + size(json) + size(buffer), size(json)) + "JSON" + json + bytesOf(size(buffer)) +
           std::string("BIN\0", 4) + buffer;
}

}  // namespace gr
