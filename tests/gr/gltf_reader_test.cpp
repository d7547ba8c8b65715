// glTF files as a whole: their text, their versions, their buffers. Messages are compared word for word.
#include "gr/gltf_text.h"

namespace gr {
namespace {

using importer::readGlb;

constexpr const char* data =
    R"(,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA")";

std::string padded(std::string text) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
}

std::uint32_t lengthOf(std::string_view bytes) {
    return static_cast<std::uint32_t>(bytes.size());
}

std::string glb(const std::string& json, const std::string& rest = "") {
    return "glTF" + bytesOf(2, 20 + lengthOf(json) + lengthOf(rest), lengthOf(json)) + "JSON" + json + rest;
}

std::string binaryPart(const std::string& bytes) {
    return bytesOf(lengthOf(bytes)) + std::string("BIN\0", 4) + bytes;
}

struct GltfReaderTest : GltfTest {
    std::string glbReason(const std::string& bytes) {
        return failureOf([&] { readGlb(bytes, others()); });
    }
};

const Places triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST_F(GltfReaderTest, ReadsATriangle) {
    const importer::SourceMesh mesh = read(triangleText());
    EXPECT_EQ(mesh.vertices, triangle);
    EXPECT_EQ(mesh.corners, (std::vector{0, 1, 2}));
    EXPECT_EQ(mesh.faceCount(), 1);
    EXPECT_TRUE(mesh.ends.empty() && mesh.normals.empty() && mesh.uvs.empty() && mesh.colours.empty());
    ASSERT_EQ(mesh.groups.size(), 1u);
    EXPECT_EQ(mesh.groups[0].name + mesh.groups[0].material, "");
}

TEST_F(GltfReaderTest, TellsWhatIsNoGltf) {
    EXPECT_EQ(reasonOf(""), "it is not whole JSON text: it goes wrong at line 1, column 1");
    EXPECT_EQ(reasonOf("{\"asset\":\n  {x}}"), "it is not whole JSON text: it goes wrong at line 2, column 4");
    EXPECT_EQ(reasonOf("[]"), "its JSON is not an object");
    EXPECT_EQ(reasonOf("{}"), "it has no \"asset\", as a glTF 2 file does");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":"1.1"}})"), "it is glTF 1, and only glTF 2 is read");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":1.0}})"), "it is glTF 1, and only glTF 2 is read");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":"3.0"}})"), "it is glTF of version \"3.0\", and only glTF 2 is read");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":"2.1","minVersion":"2.1"}})"),
              "it needs a reader of glTF \"2.1\", and this one is of \"2.0\"");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":1e999}})"),
              "its JSON has a number that is too large for any computer number");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":"2.0"}})"), "it has no faces");
    EXPECT_EQ(reasonOf("glTF"), "it is a .glb file, by its first bytes: its name should end so");
}

TEST_F(GltfReaderTest, EncodingsAreTold) {
    files["a.bin"] = triangleText().buffer;
    EXPECT_EQ(readText("\xef\xbb\xbf" + triangleText().text()).faceCount(), 1);
    const std::string utf16 = "it is UTF-16 text, and glTF's is UTF-8";
    EXPECT_EQ(reasonOf("\xff\xfe{"), utf16);
    EXPECT_EQ(reasonOf(std::string("\xfe\xff\0{", 4)), utf16);
    EXPECT_EQ(reasonOf(std::string("{\0\"\0", 4)), utf16);
    EXPECT_EQ(reasonOf(std::string("\0{\0\"", 4)), utf16);
}

TEST_F(GltfReaderTest, DeepTextIsRefused) {
    const std::string deep = "its JSON is nested deeper than 64 levels";
    EXPECT_EQ(reasonOf(std::string(2'000'000, '[')), deep);
    std::string objects;
    for (int i = 0; i < 500'000; ++i) objects += "{\"a\":";
    EXPECT_EQ(reasonOf(objects), deep);
    // Brackets in texts are none.
    GltfText text = triangleText();
    text.keys = ",\"extras\":\"\\\"" + std::string(100, '[') + "\"";
    EXPECT_EQ(read(text).faceCount(), 1);
    text.keys = ",\"extras\":" + std::string(64, '[') + std::string(64, ']');
    EXPECT_EQ(reason(text), deep);
    text.keys = ",\"extras\":" + std::string(63, '[') + std::string(63, ']');
    EXPECT_EQ(read(text).faceCount(), 1);
}

TEST_F(GltfReaderTest, ExtrasAreAnything) {
    for (const char* extras : {"7", "\"a\"", "null", "[1,{}]", "{\"a\":[]}"}) {
        GltfText text = triangleText();
        text.keys = std::string(",\"extras\":") + extras;
        text.nodes = std::string(R"({"mesh":0,"extras":)") + extras + "}";
        EXPECT_EQ(read(text).faceCount(), 1) << extras;
    }
}

TEST_F(GltfReaderTest, RequiredExtensionsMustBeKnown) {
    GltfText text = triangleText();
    text.keys = R"(,"extensionsUsed":["VENDOR_magic"])";
    EXPECT_EQ(read(text).faceCount(), 1);
    text.keys = R"(,"extensionsRequired":["KHR_mesh_quantization","KHR_materials_unlit","VENDOR_magic"])";
    const std::string said = reason(text);
    EXPECT_TRUE(
        said.starts_with("it requires the extension \"VENDOR_magic\", which is not among those that are known: "
                         "KHR_mesh_quantization, KHR_draco_mesh_compression, EXT_meshopt_compression, "
                         "EXT_mesh_gpu_instancing, "))
        << said;
    for (const char* name : {"KHR_mesh_quantization", "KHR_draco_mesh_compression", "EXT_meshopt_compression",
                             "EXT_mesh_gpu_instancing", "KHR_texture_transform", "KHR_texture_basisu",
                             "EXT_texture_webp", "KHR_lights_punctual", "KHR_materials_variants", "KHR_xmp_json_ld"}) {
        text.keys = std::string(R"(,"extensionsRequired":[")") + name + "\"]";
        EXPECT_EQ(read(text).faceCount(), 1) << name;
    }
    text.keys = R"(,"extensionsRequired":[3])";
    EXPECT_EQ(reason(text), "its \"extensionsRequired\" is not a list of names");
}

TEST_F(GltfReaderTest, BuffersAreFoundByTheirUri) {
    const GltfText text = triangleText();
    for (const auto& [uri, path] :
         std::initializer_list<std::pair<std::string, std::string>>{{"my%20mesh.bin", "my mesh.bin"},
                                                                    {"./x//y.bin", "x/y.bin"},
                                                                    {"x/../y.bin", "y.bin"},
                                                                    {"100%.bin", "100%.bin"},
                                                                    {"c%3Ad.bin", "c:d.bin"},
                                                                    {"St\u00fchle%C3%BC", "St\u00fchle\u00fc"}}) {
        files = {{path, text.buffer}};
        EXPECT_EQ(readText(text.text(R"(,"uri":")" + uri + "\"")).vertices, triangle) << uri;
    }
    files.clear();
    EXPECT_EQ(readText(text.text(data)).vertices, triangle);
    EXPECT_EQ(reasonOf(text.text()), "its buffer 0: there is no \"a.bin\"");
}

TEST_F(GltfReaderTest, BuffersElsewhereAreRefused) {
    const GltfText text = triangleText();
    for (const std::string uri : {"/etc/passwd", "../a.bin", "x/../../a.bin", "%2e%2e/a.bin", "%2Fa.bin", "file:a.bin",
                                  "http://a/b", "C:/a.bin", "a%00.bin", "", ".", "x/.."}) {
        files["a.bin"] = text.buffer;
        EXPECT_EQ(reasonOf(text.text(R"(,"uri":")" + uri + "\"")),
                  "its buffer 0 is at \"" + uri + "\", which is not below the file's own folder");
    }
    EXPECT_EQ(reasonOf(text.text(R"(,"uri":"data:;base64,AA_A")")), "its buffer 0's \"uri\" is not whole base64 text");
    EXPECT_EQ(reasonOf(text.text(R"(,"uri":"data:x")")), "its buffer 0's \"uri\" is not whole base64 text");
    EXPECT_EQ(reasonOf(text.text(R"(,"uri":"data:,%00%01")")), "its buffer 0 has 2 bytes instead of 36");
    EXPECT_EQ(reasonOf(text.text("")), "its buffer 0 has no \"uri\", and the file has no binary part");
}

TEST_F(GltfReaderTest, BuffersMayBeLongerThanTheySay) {
    const GltfText text = triangleText();
    files["a.bin"] = text.buffer + "more";
    EXPECT_EQ(readText(text.text()).vertices, triangle);
    // What is behind the end is in no buffer view.
    GltfText longer = text;
    longer.views = R"({"buffer":0,"byteLength":37})";
    EXPECT_EQ(reasonOf(longer.text()), "its bufferView 0 has 37 bytes from byte 0 on, more than buffer 0 with its 36");
    longer.views = R"({"buffer":0,"byteOffset":37,"byteLength":1})";
    EXPECT_EQ(reasonOf(longer.text()), "its bufferView 0 has 1 bytes from byte 37 on, more than buffer 0 with its 36");
    files["a.bin"] = text.buffer.substr(1);
    EXPECT_EQ(reasonOf(text.text()), "its buffer 0 has 35 bytes instead of 36");
}

TEST_F(GltfReaderTest, GlbFilesHaveTheirBufferWithinOrBesideThem) {
    const GltfText text = triangleText();
    const std::string within = padded(text.text("")), beside = padded(text.text());
    EXPECT_EQ(readGlb(glb(within, binaryPart(text.buffer + "more")), others()).vertices, triangle);
    EXPECT_EQ(glbReason(glb(within)), "its buffer 0 has no \"uri\", and the file has no binary part");
    files["a.bin"] = text.buffer;
    EXPECT_EQ(readGlb(glb(beside), others()).vertices, triangle);
    EXPECT_EQ(readGlb(glb(beside, binaryPart("other")), others()).vertices, triangle);
    EXPECT_EQ(readGlb(glb(padded(text.text(data)), binaryPart("other")), others()).vertices, triangle);
    // Some programs fill up with zeros.
    EXPECT_EQ(readGlb(glb(beside + std::string(4, '\0')), others()).vertices, triangle);
}

TEST_F(GltfReaderTest, GlbTextMayHaveAnyLength) {
    GltfText text = triangleText();
    for (int i = 0; i < 4; ++i) {
        text.keys = ",\"extras\":\"" + std::string(static_cast<std::size_t>(i), 'x') + "\"";
        const std::string json = text.text(""), part = binaryPart(text.buffer);
        EXPECT_EQ(readGlb(glb(json, part), others()).vertices, triangle) << i;
        // What fills up is there, but not counted.
        const std::string fill(padded(json).size() - json.size(), ' ');
        EXPECT_EQ(readGlb(glb(json, fill + part), others()).vertices, triangle) << i;
    }
}

TEST_F(GltfReaderTest, BrokenGlbFilesAreTold) {
    const std::string whole = glb(padded(triangleText().text("")), binaryPart(triangleText().buffer));
    EXPECT_EQ(glbReason("{}"), "it does not begin with \"glTF\", as a .glb file does");
    EXPECT_EQ(glbReason(whole.substr(0, 19)), "it ends within its header, after 19 bytes");
    EXPECT_EQ(glbReason(whole.substr(0, 100)),
              "it has 100 bytes, but its header tells of " + std::to_string(whole.size()));
    std::string old = whole;
    old[4] = 1;
    EXPECT_EQ(glbReason(old), "it is glTF 1, and only glTF 2 is read");
    EXPECT_EQ(glbReason("glTF" + bytesOf(2, 20, 9) + "JSON"), "it ends within its JSON part");
    EXPECT_EQ(glbReason("glTF" + bytesOf(2, 20, 0) + "TEXT"), "its first part is not its JSON");
    std::string cut = whole.substr(0, whole.size() - 1);
    cut.replace(8, 4, bytesOf(lengthOf(cut)));
    EXPECT_EQ(glbReason(cut), "it ends within its binary part");
}

TEST_F(GltfReaderTest, WrongNumbersAreNamed) {
    const auto with = [&](const std::string& nodes, const std::string& primitives, const std::string& keys) {
        GltfText text = triangleText();
        if (!nodes.empty()) text.nodes = nodes;
        if (!primitives.empty()) text.primitives = primitives;
        text.keys = keys;
        return reason(text);
    };
    EXPECT_EQ(with(R"({"mesh":7})", "", ""), "its node 0 names mesh 7 of 1");
    EXPECT_EQ(with(R"({"mesh":-1})", "", ""), "its node 0's \"mesh\" names no mesh by its number");
    EXPECT_EQ(with(R"({"mesh":0.0})", "", ""), "none");
    EXPECT_EQ(with(R"({"mesh":0.5})", "", ""), "its node 0's \"mesh\" names no mesh by its number");
    EXPECT_EQ(with(R"({"mesh":0,"skin":0})", "", ""),
              "its mesh 0's primitive 0 has no JOINTS_0, but a node gives its "
              "mesh a skin");
    EXPECT_EQ(with("3", "", ""), "its node 0 is not an object");
    EXPECT_EQ(with(R"({"children":3})", "", ""), "its node 0's \"children\" is not a list");
    EXPECT_EQ(with(R"({"children":[5]})", "", ""), "its node 0 names node 5 of 1");
    EXPECT_EQ(with("", R"({"attributes":{"POSITION":4}})", ""),
              "its mesh 0's primitive 0's attributes names accessor "
              "4 of 1");
    EXPECT_EQ(with("", "{}", ""), "its mesh 0's primitive 0 has no \"attributes\"");
    EXPECT_EQ(with("", R"({"attributes":{"POSITION":0},"mode":9})", ""),
              "its mesh 0's primitive 0's \"mode\" is 9, and glTF has 0 to 6");
    EXPECT_EQ(with("", R"({"attributes":{"POSITION":0},"material":0})", ""),
              "its mesh 0's primitive 0 names material 0 of 0");
    EXPECT_EQ(with("", "", R"(,"scene":0)"), "it names scene 0 of 0");
    EXPECT_EQ(with("", "", R"(,"scene":"a")"), "its \"scene\" names no scene by its number");
}

}  // namespace
}  // namespace gr
