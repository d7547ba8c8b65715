// glTF files made in code, and what is read from them.
#pragma once

#include "gr/mesh/import/readers.h"
#include "gr/mesh_text.h"

#include <gtest/gtest.h>

#include <map>

namespace gr {

// One mesh of one primitive at one node, unless a test says otherwise. Its buffer is "a.bin".
struct GltfText {
    std::string nodes = R"({"mesh":0})", primitives, meshKeys, keys;  // keys: with a comma before each
    std::string accessors, views, buffer;
    int accessorCount = 0, viewCount = 0;

    // Both give the number of what they add.
    int addView(const std::string& bytes, const std::string& more = "") {
        buffer.resize((buffer.size() + 3) / 4 * 4);
        views += std::string(viewCount > 0 ? "," : "") + R"({"buffer":0,"byteOffset":)" +
                 std::to_string(buffer.size()) + R"(,"byteLength":)" + std::to_string(bytes.size()) + more + "}";
        buffer += bytes;
        return viewCount++;
    }
    int addAccessor(const std::string& type, int component, std::size_t count, const std::string& more) {
        accessors += std::string(accessorCount > 0 ? "," : "") + R"({"type":")" + type + R"(","componentType":)" +
                     std::to_string(component) + R"(,"count":)" + std::to_string(count) + more + "}";
        return accessorCount++;
    }
    int add(const std::string& type, int component, std::size_t count, const std::string& bytes,
            const std::string& more = "") {
        const std::string view = std::to_string(addView(bytes));
        return addAccessor(type, component, count, R"(,"bufferView":)" + view + more);
    }
    int addFloats(const std::string& type, std::size_t width, const std::vector<float>& numbers) {
        std::string bytes;
        for (const float number : numbers) bytes += bytesOf(number);
        return add(type, 5126, numbers.size() / width, bytes);
    }
    int addVectors(const std::vector<float>& numbers) { return addFloats("VEC3", 3, numbers); }

    std::string text(const std::string& bufferKeys = R"(,"uri":"a.bin")") const {
        return R"({"asset":{"version":"2.0"},"nodes":[)" + nodes + R"(],"meshes":[{"primitives":[)" + primitives + "]" +
               meshKeys + R"(}],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
               R"(],"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + bufferKeys + "}]" + keys + "}";
    }
};

inline const std::vector<float> cornerPlaces{0, 0, 0, 1, 0, 0, 0, 1, 0};

// A triangle in the plane z = 0 that faces upwards, of three vertices without numbers.
inline GltfText triangleText() {
    GltfText text;
    text.addVectors(cornerPlaces);
    text.primitives = R"({"attributes":{"POSITION":0}})";
    return text;
}

struct GltfTest : testing::Test {
    std::map<std::string, std::string, std::less<>> files;

    importer::OtherFile others() {
        return [this](const std::string& path) -> std::string_view {
            const auto at = files.find(path);
            if (at == files.end()) throw importer::Failure("there is no \"" + path + "\"");
            return at->second;
        };
    }
    importer::SourceMesh readText(const std::string& text) { return importer::readGltf(text, others()); }
    importer::SourceMesh read(const GltfText& text) {
        files["a.bin"] = text.buffer;
        return readText(text.text());
    }
    template<class Read>
    static std::string failureOf(Read&& action) {
        try {
            action();
        } catch (const importer::Failure& failure) {
            return failure.what();
        }
        return "none";
    }
    std::string reason(const GltfText& text) {
        return failureOf([&] { read(text); });
    }
    std::string reasonOf(const std::string& text) {
        return failureOf([&] { readText(text); });
    }
};

// Where a face's corners are.
inline std::vector<glm::dvec3> faceOf(const importer::SourceMesh& mesh, int face) {
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < 3; ++i)
        places.push_back(mesh.vertices[static_cast<std::size_t>(mesh.corners[3 * static_cast<std::size_t>(face) + i])]);
    return places;
}

using Places = std::vector<glm::dvec3>;

}  // namespace gr
