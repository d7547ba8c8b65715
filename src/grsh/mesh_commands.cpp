// The commands that make meshes.

#include "gr/mesh/heightfield.h"
#include "gr/mesh/lathe.h"
#include "grsh/commands.h"
#include "grsh/node_words.h"
#include "grsh/option_words.h"
#include "grsh/place.h"
#include "image/heights.h"
#include "image/image_file.h"

#include <algorithm>
#include <array>

namespace grsh {
namespace {

std::vector<glm::dvec3> readVertices(Call& call) {
    std::vector<glm::dvec3> vertices;
    const auto elements = elementsOf(call.words.object(2), "vertices", "a list of {x y z}");
    for (Tcl_Obj* element : elements)
        vertices.push_back(vectorFrom(element, "vertex " + std::to_string(vertices.size()), coordinate));
    if (vertices.size() < 3) throwBadValue("vertices", "at least three {x y z}", call.words.object(2));
    return vertices;
}

std::vector<std::vector<int>> readFaces(Call& call, std::size_t vertexCount) {
    const core::Range index{.least = 0, .most = static_cast<double>(vertexCount) - 1};
    std::vector<std::vector<int>> faces;
    for (Tcl_Obj* element : elementsOf(call.words.object(3), "faces", "a list of {i j k ...}")) {
        const std::string what = "face " + std::to_string(faces.size());
        const auto corners = elementsOf(element, what, "a list of vertex numbers");
        if (corners.size() < 3) throwBadValue(what, "at least three vertex numbers", element);
        std::vector<int>& face = faces.emplace_back();
        for (Tcl_Obj* corner : corners) face.push_back(integerFrom(corner, "vertex number in " + what, index));
    }
    if (faces.empty()) throwBadValue("faces", "at least one {i j k ...}", call.words.object(3));
    return faces;
}

// What gr_polyhedron is asked for beside vertices and faces: one row each.
struct PolyhedronSettings {
    std::vector<glm::dvec3> normals;
    std::vector<core::Vec2f> uvs;
    std::vector<core::Rgbf> colours;
    double smooth = 0;  // degrees

    static std::span<const core::OptionRow<PolyhedronSettings>> options();
};

constexpr std::array<core::OptionRow<PolyhedronSettings>, 4> polyhedronRows{{
    {.name = "normals",
     .member = &PolyhedronSettings::normals,
     .range = coordinate,
     .form = "{{x y z} ...}",
     .defaultText = "those of the faces",
     .help = "for shading, outwards, of any length; one for each vertex"},
    {.name = "uv",
     .member = &PolyhedronSettings::uvs,
     .range = coordinate,
     .form = "{{u v} ...}",
     .defaultText = "none",
     .help = "places on a picture, v upwards; one for each vertex"},
    {.name = "colours",
     .member = &PolyhedronSettings::colours,
     .range = core::unitInterval,
     .form = "{{r g b} ...}",
     .defaultText = "none",
     .help = "linear; one for each vertex"},
    {.name = "smooth",
     .member = &PolyhedronSettings::smooth,
     .range = {.least = 0, .most = 180},
     .unit = "degrees",
     .help = "edges flatter than this are rounded for shading"},
}};

std::span<const core::OptionRow<PolyhedronSettings>> PolyhedronSettings::options() {
    return polyhedronRows;
}

void checkNormals(const std::vector<glm::dvec3>& normals) {
    const auto zero = std::find(normals.begin(), normals.end(), glm::dvec3(0));
    if (zero == normals.end()) return;
    throw core::Error("VALUE", "RANGE", "0 0 0",
                      "normal " + std::to_string(zero - normals.begin()) +
                          " must be three finite numbers that are not all 0, not \"0 0 0\"");
}

// What a script says of each vertex.
PolyhedronSettings readPolyhedronSettings(Call& call, std::size_t vertexCount) {
    PolyhedronSettings settings;
    readOptions(call.words, 4, "no such option", settings);
    const auto checkCount = [&](const char* option, const char* form, std::size_t count) {
        for (std::size_t i = 4; i < call.words.size(); i += 2)
            if (withoutDash(call.words.text(i)) == option && count != vertexCount)
                throw core::Error("VALUE", "COUNT", option,
                                  std::string(option) + " must be " + std::to_string(vertexCount) + " " + form +
                                      ", one for each vertex, not " + std::to_string(count));
    };
    checkCount("normals", "{x y z}", settings.normals.size());
    checkCount("uv", "{u v}", settings.uvs.size());
    checkCount("colours", "{r g b}", settings.colours.size());
    checkNormals(settings.normals);
    if (!settings.normals.empty() && settings.smooth > 0)
        throw core::Error("OPTION", "CONFLICT", "smooth",
                          "smooth makes normals and cannot be given together with the option normals");
    return settings;
}

void warnOf(Call& call, const std::string& what, const gr::MeshRepairs& repairs) {
    if (const std::string text = repairs.text(); !text.empty()) warn(call, what + ": " + text);
}

Tcl_Obj* makePolyhedron(Call& call) {
    checkNew(call);
    gr::PolygonMesh mesh;
    mesh.vertices = readVertices(call);
    mesh.faces = readFaces(call, mesh.vertices.size());
    PolyhedronSettings settings = readPolyhedronSettings(call, mesh.vertices.size());
    mesh.normals = std::move(settings.normals);
    mesh.uvs = std::move(settings.uvs);
    mesh.colours = std::move(settings.colours);
    gr::MeshRepairs repairs;
    const auto polyhedron = gr::Polyhedron::make(mesh, repairs, settings.smooth);
    Tcl_Obj* path = create(call, gr::PolyhedronNode{polyhedron});
    warnOf(call, "gr_polyhedron: " + std::string(textOf(path)), repairs);
    return path;
}

Tcl_Obj* makeMesh(Call& call) {
    checkNew(call);
    const std::string file(call.words.text(2));
    gr::MeshSettings settings;
    readOptions(call.words, 3, "no such option", settings);
    gr::MeshRepairs repairs;
    const std::string place = besideScript(call.interp, file);
    const core::Folder* below = call.session.files->folderToRead(place, file);
    const auto polyhedron = call.session.database.readMesh(place, file, repairs, below, settings);
    Tcl_Obj* path = create(call, gr::PolyhedronNode{polyhedron, file});
    warnOf(call, "gr_mesh: " + std::string(textOf(path)) + ": \"" + file + "\"", repairs);
    return path;
}

std::vector<gr::ProfilePoint> readProfile(Call& call) {
    std::vector<gr::ProfilePoint> profile;
    for (Tcl_Obj* element : elementsOf(call.words.object(2), "profile", "a list of {r y}")) {
        const std::string what = "point " + std::to_string(profile.size()) + " of the profile";
        std::array<double, 2> numbers;
        numbersFrom(element, what, coordinate, numbers);
        if (numbers[0] < 0) throwBadValue(what, "{r y} with r at least 0, which is the axis", element);
        profile.push_back({numbers[0] + 0, numbers[1] + 0});  // -0 becomes 0
    }
    if (profile.size() < 2) throwBadValue("profile", "at least two {r y}", call.words.object(2));
    return profile;
}

Tcl_Obj* makeLathe(Call& call) {
    checkNew(call);
    const std::vector<gr::ProfilePoint> profile = readProfile(call);
    const bool isGiven = call.words.size() == 4;
    const int segments = isGiven ? call.words.integer(3, "segments", {.least = 3, .most = 10000}) : 128;
    gr::MeshRepairs repairs;
    const auto polyhedron = gr::Polyhedron::make(gr::latheMesh(profile, segments), repairs);
    return create(call, gr::PolyhedronNode{polyhedron});
}

// Its words are read as text: as an object a word cannot be a list and a number at once.
bool isNumber(Tcl_Obj* word) {
    double number = 0;
    return Tcl_GetDouble(nullptr, std::string(textOf(word)).c_str(), &number) == TCL_OK;
}

gr::HeightGrid readRows(Tcl_Obj* word) {
    const std::string expected = "rows {{h ...} ...} or a picture file, " + image::pictureEndings();
    gr::HeightGrid grid;
    for (Tcl_Obj* row : elementsOf(word, "heights", expected)) {
        const std::string what = "row " + std::to_string(grid.rows);
        const auto elements = elementsOf(row, what, "a list of heights");
        const int count = static_cast<int>(elements.size());
        // A single word that is no number was meant for a file's name.
        if (grid.rows == 0 && count == 1 && !isNumber(row)) throwBadValue("heights", expected, word);
        if (grid.rows > 0 && count != grid.columns)
            throwBadValue(what, "as long as row 0, " + std::to_string(grid.columns) + " heights", row);
        grid.columns = count;
        for (int i = 0; i < count; ++i)
            grid.heights.push_back(numberFrom(elements[i], "height " + std::to_string(i) + " of " + what, coordinate));
        ++grid.rows;
    }
    if (grid.rows < 2 || grid.columns < 2) throwBadValue("heights", "at least two rows of two heights", word);
    return grid;
}

gr::HeightGrid readPicture(Call& call) {
    const std::string name = call.words.fileName(2, "picture");
    const image::FileName file = call.session.files->toRead(besideScript(call.interp, call.words.text(2)), name);
    const image::Image picture = image::readImage(file);
    gr::HeightGrid grid{picture.held.width, picture.held.height, image::heightsOf(picture, name)};
    if (grid.columns < 2 || grid.rows < 2)
        throw core::Error("VALUE", "RANGE", name,
                          "the picture \"" + name + "\" must have at least 2 x 2 pixels, not " +
                              std::to_string(grid.columns) + " x " + std::to_string(grid.rows));
    return grid;
}

Tcl_Obj* makeHeightfield(Call& call) {
    checkNew(call);
    const std::string word(call.words.text(2));
    const bool isPicture = image::hasPictureEnding(word);
    const gr::HeightGrid grid = isPicture ? readPicture(call) : readRows(call.words.object(2));
    gr::MeshRepairs repairs;
    const auto polyhedron = gr::Polyhedron::make(gr::heightfieldMesh(grid), repairs);
    return create(call, gr::PolyhedronNode{polyhedron, isPicture ? word : ""});
}

constexpr std::array<Command, 4> rows{{
    {"gr_polyhedron", "", "pname name {{x y z} ...} {{i j k ...} ...} ?option value ...?", 4, anyNumberOfWords,
     makePolyhedron,
     "makes a polygon mesh: vertices, then faces of vertex numbers from 0; any simple polygon, concave ones too"},
    {"gr_mesh", "", "pname name file ?option value ...?", 3, anyNumberOfWords, makeMesh,
     "makes a mesh from a file, .obj, .ply, .stl, .gltf or .glb; its path is relative to the script's folder"},
    {"gr_lathe", "", "pname name {{r y} ...} ?segments?", 3, 4, makeLathe,
     "makes a mesh by turning a profile round the y axis, in 128 segments unless told",
     "r is at least 0; where r is 0 at both ends, or the last point is the first, the mesh is closed\n"
     "corners of the profile sharper than 40 degrees stay edges, all others are smooth"},
    {"gr_heightfield", "", "pname name picture|{{h ...} ...}", 3, 3, makeHeightfield,
     "makes a smooth mesh over [0,1] in x and z from heights y: rows along x, the first at z = 0, or a picture's "
     "pixels",
     "a picture's top row is the first; black is 0, white 1, between them the file's own numbers, not through a curve\n"
     "its path is relative to the script's folder"},
}};

}  // namespace

std::span<const Command> meshCommands() {
    return rows;
}

std::vector<OptionHelp> meshOptionsHelp() {
    return optionsHelp(gr::MeshSettings::options());
}

std::vector<OptionHelp> polyhedronOptionsHelp() {
    return optionsHelp(PolyhedronSettings::options());
}

}  // namespace grsh
