// The same scene has the same fingerprint, and whatever changes the scene changes it.
#include "gr/fingerprint.h"

#include "gr/database/database.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace gr {
namespace {

const std::vector<glm::dvec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

void addMesh(Database& database, const char* name, std::vector<glm::dvec3> vertices) {
    PolygonMesh mesh{std::move(vertices), {{0, 1, 2, 3}}};
    MeshRepairs repairs;
    database.create(":", name, PolyhedronNode{Polyhedron::make(std::move(mesh), repairs)});
}

// change: what is done to the scene at the end.
std::uint64_t fingerprintWith(const std::function<void(Database&)>& change, core::Rgbf clay = core::Rgbf(0.5f),
                              glm::dvec3 corner = {1, 1, 0}) {
    Database database;
    database.addMaterial("clay", materials::Diffuse{.reflectance = clay});
    database.addMaterial("glass", materials::Dielectric{});
    database.create(":", "ball", SphereNode{{1, 2, 3}, 1});
    database.create(":", "box", BoxNode{{0, 0, 0}, {1, 2, 3}});
    database.setMaterial(":ball", "clay");
    std::vector<glm::dvec3> vertices = corners;
    vertices[2] = corner;
    addMesh(database, "sheet", vertices);
    database.create(":", "lamp", AreaLightNode{{5, 5, 5}, {0, 4, 0}, 2});
    database.addLight("bulb", PointLight{{1, 1, 1}, core::Rgbf(1), {1, 0, 0}});
    database.addLight("spot", PointLight{{1, 1, 1}, core::Rgbf(1), {1, 0, 1}});
    change(database);
    const std::vector<std::string> lights{"bulb"};
    return fingerprint(compile(database, ":", lights));
}

TEST(Fingerprint, IsThatOfTheSceneAndOfNothingElse) {
    const auto nothing = [](Database&) {};
    const std::uint64_t same = fingerprintWith(nothing);
    EXPECT_EQ(fingerprintWith(nothing), same);
    EXPECT_EQ(fingerprintWith([](Database& d) { d.addMaterial("unused", materials::Shirley{}); }), same);

    std::map<std::uint64_t, std::string> all{{same, "as it was"}};
    const auto expectOther = [&](const std::string& what, std::uint64_t value) {
        const auto [at, isNew] = all.emplace(value, what);
        EXPECT_TRUE(isNew) << what << " is like " << at->second;
    };
    const auto change = [&](const std::string& what, const std::function<void(Database&)>& by) {
        expectOther(what, fingerprintWith(by));
    };
    change("moved", [](Database& d) { d.translate(":ball", {1e-4, 0, 0}); });
    change("turned", [](Database& d) { d.rotate(":box", 1, 10); });
    change("another material", [](Database& d) { d.setMaterial(":box", "glass"); });
    change("the same on another node", [](Database& d) { d.setMaterial(":sheet", "glass"); });
    change("one more ball", [](Database& d) { d.create(":", "more", SphereNode{{1, 2, 3}, 1}); });
    change("one more box", [](Database& d) { d.create(":", "more", BoxNode{{0, 0, 0}, {1, 2, 3}}); });
    change("one more lamp", [](Database& d) { d.create(":", "more", AreaLightNode{{5, 5, 5}, {0, 4, 0}, 2}); });
    change("one more, another lamp", [](Database& d) {
        d.create(":", "more", AreaLightNode{{5, 5, 6}, {0, 4, 0}, 2});
    });
    change("one more mesh", [](Database& d) { addMesh(d, "more", corners); });
    change("an instance of the mesh", [](Database& d) { d.createInstance(":", "more", ":sheet"); });
    change("no box", [](Database& d) { d.remove(":box"); });
    expectOther("another colour", fingerprintWith(nothing, core::Rgbf(0.5f, 0.5f, 0.25f)));
    expectOther("another corner", fingerprintWith(nothing, core::Rgbf(0.5f), {1, 1.5, 0}));

    Database database;
    database.create(":", "ball", SphereNode{{0, 0, 0}, 1});
    const auto lit = [&](const PointLight& light) {
        database.addLight("l" + std::to_string(all.size()), light);
        const std::vector<std::string> lights{"l" + std::to_string(all.size())};
        return fingerprint(compile(database, ":", lights));
    };
    expectOther("a point light", lit({{1, 1, 1}, core::Rgbf(1), {1, 0, 0}}));
    expectOther("a point light elsewhere", lit({{1, 1, 2}, core::Rgbf(1), {1, 0, 0}}));
    expectOther("a brighter one", lit({{1, 1, 1}, core::Rgbf(2), {1, 0, 0}}));
    expectOther("one that fades", lit({{1, 1, 1}, core::Rgbf(1), {1, 0, 1}}));
}

}  // namespace
}  // namespace gr
