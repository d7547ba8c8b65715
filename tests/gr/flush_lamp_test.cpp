// A lamp in the plane of another face, or of another lamp, is met from the side to which it shines, and by its light.
// Seen to fail without the lift that compile gives such lamps, and with one to the dark side.
#include "gr/database/database.h"
#include "gr/random_shapes.h"
#include "gr/tracer.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

struct Kind {
    const char* name;
    NodeContent ceiling;  // its underside in the plane y = 2
};

NodeContent polygon() {
    PolygonMesh mesh;
    mesh.vertices = {{-500, 2, -500}, {500, 2, -500}, {500, 2, 500}, {-500, 2, 500}};
    mesh.faces = {{0, 1, 2, 3}};
    return polyhedronNode(mesh);
}

// Of many triangles, so that the lanes do not take it for flat faces.
NodeContent fineGrid() {
    PolygonMesh mesh;
    constexpr int n = 16;
    for (int z = 0; z <= n; ++z)
        for (int x = 0; x <= n; ++x) mesh.vertices.push_back({1000. * x / n - 500, 2, 1000. * z / n - 500});
    for (int z = 0; z < n; ++z)
        for (int x = 0; x < n; ++x) {
            const int first = z * (n + 1) + x;
            mesh.faces.push_back({first, first + 1, first + n + 2, first + n + 1});
        }
    return polyhedronNode(mesh);
}

// A lamp of side 100 that shines down from y = 2, in the plane of a ceiling or of a lamp that shines up.
class FlushLamp : public testing::TestWithParam<int> {
protected:
    Scene make(bool lampFirst, double turn) const {
        Database database;
        database.create(":", "room", TransformNode{});
        if (lampFirst) addLamp(database);
        addCeiling(database);
        if (!lampFirst) addLamp(database);
        if (turn != 0)
            for (int axis = 0; axis < 3; ++axis) database.rotate(":room", axis, turn * (axis + 1));
        return compile(database, ":", {});
    }

private:
    static void addLamp(Database& database) {
        database.create(":room", "lamp", AreaLightNode{core::Rgbf(1), {0, 2, 0}, 100});
    }
    void addCeiling(Database& database) const {
        switch (GetParam()) {
            case 0:
                database.create(":room", "ceiling", BoxNode{{-500, 2, -500}, {1000, 10, 1000}});
                break;
            case 1:
                database.create(":room", "ceiling", polygon());
                break;
            case 2:
                database.create(":room", "ceiling", fineGrid());
                break;
            default:
                database.create(":room", "other", AreaLightNode{core::Rgbf(2), {0, 2, 0}, 100});
                database.scale(":room:other", {0, 2, 0}, {1, -1, 1});
        }
    }
};

TEST_P(FlushLamp, IsMetFromItsSide) {
    for (const double turn : {0., 17.})
        for (const bool lampFirst : {true, false}) {
            const Scene scene = make(lampFirst, turn);
            const auto off = makeNoAccelerator(scene);
            glm::dmat4 map(1);
            Database turned;
            turned.create(":", "room", TransformNode{});
            if (turn != 0)
                for (int axis = 0; axis < 3; ++axis) turned.rotate(":room", axis, turn * (axis + 1));
            if (turned.find(":room").matrix) map = *turned.find(":room").matrix;
            support::TestRandom random(7);
            int met = 0;
            constexpr int rays = 2000;
            for (const char* name : {"off", "grid", "embree"}) {
                const auto accelerator = makeAccelerator(name, scene, 1, true);
                const Tracer<float> tracer(scene, *accelerator, false);
                TraversalCounts counts;
                for (int i = 0; i < rays; ++i) {
                    const glm::dvec3 to(98 * random.next() - 49, 2, 98 * random.next() - 49);
                    const glm::dvec3 from = randomPoint(random, -300, 300) * glm::dvec3(1, 0, 1) - glm::dvec3(0, 40, 0);
                    const core::Vec3f start(transformed(map, from)), end(transformed(map, to));
                    const core::Rayf ray{start, glm::normalize(end - start)};
                    const auto surface = tracer.surfaceAt(ray, tracer.nearest(ray, true, counts));
                    const auto hit = off->intersect(ray);
                    const bool isMet = surface.light >= 0 && hit && scene.surfaceAt(ray, *hit).light >= 0;
                    const bool isOurs =
                        isMet && scene.lights.of<AreaLight>()[static_cast<std::size_t>(surface.light)].radiance.x == 1;
                    met += isOurs && glm::dot(ray.direction, surface.normal) < 0 ? 1 : 0;
                }
            }
            EXPECT_EQ(met, 3 * rays) << "turned by " << turn << ", lamp first: " << lampFirst;
        }
}

std::string nameOf(const testing::TestParamInfo<int>& info) {
    return std::array{"Box", "Polygon", "FineGrid", "OtherLamp"}.at(static_cast<std::size_t>(info.param));
}
INSTANTIATE_TEST_SUITE_P(InThePlaneOf, FlushLamp, testing::Range(0, 4), nameOf);

}  // namespace
}  // namespace gr
