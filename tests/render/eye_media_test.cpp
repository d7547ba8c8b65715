// What the eye is inside of, and its lens.
// Seen to fail with the order from the eye outwards for the one back to it, the order in which the scene has them, a
// mesh's crossings taken in the other order, one ray followed from hit to hit (to which blocks that touch have one
// surface, and which never ends among large numbers), a lens taken to be where the eye is, its crossings taken in the
// other order, and places beyond the lens taken to be on it.
#include "render/transport/eye_media.h"

#include "gr/random_shapes.h"
#include "render/converges.h"
#include "render/each_integrator.h"

namespace render {
namespace {

using core::Vec3f;
using materials::Dielectric;

const Dielectric water{.index = 1.25, .absorption = {1, 0, 0}};
const Dielectric glass{.index = 1.5, .absorption = {0, 1, 0}};

// Things wherever a test puts them.
struct Things {
    void add(const std::string& name, const gr::NodeContent& content, const materials::Material& material) {
        database.create(":", name, content);
        database.addMaterial(name, material);
        database.setMaterial(":" + name, name);
        compile();
    }
    void compile() { scene = gr::compile(database, ":", {}); }
    float index(const Vec3f& point) const { return mediaAt(point, scene).index(); }
    // The index beyond the surface of the thing that was added so, counted from 0, and left from inside.
    float beyond(const Vec3f& point, std::size_t number) const {
        return mediaAt(point, scene).indexBeyond(*scene.interiorOf(scene.instances[number].material), false);
    }
    // With a lens round it.
    EyeMedia lens(const Vec3f& eye, double radius) const {
        Camera camera(eye, {0, 0, -1}, {0, 1, 0}, 90, 2, 2);
        camera.setLens(radius, 1);
        return EyeMedia(scene, camera.starts());
    }

    gr::Database database;
    gr::Scene scene;
};

gr::SphereNode ball(double radius) {
    return {{0, 0, 0}, radius};
}

gr::BoxNode block(double half) {
    return {glm::dvec3(-half), glm::dvec3(2 * half)};
}

gr::PolyhedronNode meshBlock(const glm::dvec3& corner, const glm::dvec3& size) {
    gr::PolygonMesh mesh = gr::cubeMesh();
    for (glm::dvec3& v : mesh.vertices) v = corner + size * (v * 0.5 + 0.5);
    return gr::polyhedronNode(mesh);
}

// A drop of glass in a ball of water, with opaque things in it and about it.
struct Drop : Things {
    Drop() {
        add("water", ball(4), water);
        add("drop", ball(1), glass);
        add("stone", gr::SphereNode{{2, 0, 0}, 0.5}, materials::Diffuse{});
        add("shell", ball(9), materials::Shirley{});
        database.create(":", "lamp", gr::AreaLightNode{core::Rgbf(1), {0, 1.5, 0}, 30});
        database.setMaterial(":lamp", "drop");
        compile();
    }
};

TEST(Eye, IsInADropWhereverItIs) {
    const Drop drop;
    EXPECT_EQ(drop.index({0.1f, 0.2f, -0.3f}), 1.5f);
    EXPECT_EQ(drop.index({-2, 0, 1}), 1.25f);
    EXPECT_EQ(drop.index({-2, -2, -2}), 1.25f) << "the drop is on the way out";
    EXPECT_EQ(drop.index({2, 0, 0}), 1.25f) << "in the stone";
    EXPECT_EQ(drop.index({-4, -4, -4}), 1) << "all of it is on the way out";
    EXPECT_EQ(drop.index({20, 0, 0}), 1);
}

TEST(Eye, LeavesADropAsItWasEntered) {
    const Drop drop;
    EXPECT_EQ(drop.beyond({0, 0, 0}, 1), 1.25f);
    EXPECT_EQ(drop.beyond({0, 0, 0}, 0), 1.5f);
    EXPECT_EQ(drop.beyond({0, 0, 2}, 0), 1);
}

// Whichever was made first, and of whatever shape they are.
TEST(Eye, IsInTheInnermost) {
    const gr::NodeContent inner[] = {ball(1), block(0.5), gr::polyhedronNode(gr::icosphereMesh(2))};
    const gr::NodeContent outer[] = {ball(4), block(2.5), meshBlock({-3, -3, -3}, {6, 6, 6})};
    for (const auto& in : inner)
        for (const auto& out : outer)
            for (const bool innerFirst : {true, false}) {
                Things things;
                if (innerFirst) things.add("in", in, glass);
                things.add("out", out, water);
                if (!innerFirst) things.add("in", in, glass);
                for (const Vec3f& point : {Vec3f(0, 0, 0), Vec3f(0.25f, -0.375f, 0.125f)}) {
                    EXPECT_EQ(things.index(point), 1.5f);
                    EXPECT_EQ(things.beyond(point, innerFirst ? 0 : 1), 1.25f);
                }
                EXPECT_EQ(things.index({0, 2, 0}), 1.25f);
                EXPECT_EQ(things.index({0, -5, 0}), 1);
            }
}

// A cup's walls are left again on the way out, and those of a body with two shells in it count twice.
TEST(Eye, IsNotInAWallBesideIt) {
    Things things;
    const std::vector<glm::dvec2> outline{{-2, -2}, {2, -2}, {2, 2}, {1, 2}, {1, -1}, {-1, -1}, {-1, 2}, {-2, 2}};
    gr::PolygonMesh cup;
    for (const double z : {-2., 2.})
        for (const glm::dvec2& p : outline) cup.vertices.push_back({p, z});
    cup.faces = {{7, 6, 5, 4, 3, 2, 1, 0}, {8, 9, 10, 11, 12, 13, 14, 15}};
    for (int i = 0; i < 8; ++i) cup.faces.push_back({i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i});
    things.add("cup", gr::polyhedronNode(cup), glass);
    things.add("wine", gr::BoxNode{{-1.125, -1.125, -1}, {2.25, 2, 2}}, water);
    EXPECT_EQ(things.index({0, 0, 0}), 1.25f) << "glass is all round";
    EXPECT_EQ(things.beyond({0, 0, 0}, 1), 1);
    EXPECT_EQ(things.index({1.5f, 0, 0}), 1.5f);
    EXPECT_EQ(things.index({-1.5f, 0, 0}), 1.5f) << "the wine and the other wall are on the way out";
    EXPECT_EQ(things.index({0, 1.5f, 0}), 1);
    for (const Vec3f& overlap : {Vec3f(1.0625f, 0, 0), Vec3f(-1.0625f, 0, 0)}) {
        EXPECT_NE(things.index(overlap), 1);
        EXPECT_NE(things.beyond(overlap, 0), 1);
        EXPECT_NE(things.beyond(overlap, 1), 1);
    }
}

// The ray by which an eye looks round itself goes through the face that two blocks have in common, through an edge, and
// through a corner.
TEST(Eye, IsInAirBesideBlocksThatTouch) {
    const Vec3f ray(0.48f, 0.64f, 0.6f);
    for (const Vec3f& through : {Vec3f(0.5f, 0.5f, 0), Vec3f(0, 0.5f, 0), Vec3f(0, 0, 0)})
        for (const bool areMeshes : {false, true}) {
            Things things;
            for (const int z : {-1, 0, 1}) {
                const gr::NodeContent box = gr::BoxNode{{0, 0, z}, {1, 1, 1}};
                things.add("b" + std::to_string(z + 1), areMeshes ? meshBlock({0, 0, z}, {1, 1, 1}) : box,
                           z == -1 ? water : glass);
            }
            for (const float way : {2.f, 4.f}) EXPECT_EQ(things.index(through - way * ray), 1);
            EXPECT_EQ(things.index({0.5f, 0.5f, -0.5f}), 1.25f);
            EXPECT_EQ(things.index({0.5f, 0.5f, 0.5f}), 1.5f);
        }
}

// To each of its places from each, near ones and far ones.
TEST(Eye, MayHaveALens) {
    const Drop drop;
    const std::pair<Vec3f, float> places[] = {{{0, 0, 0}, 1.5f},  {{0, -2, 0}, 1.25f},    {{0, 0, -5}, 1},
                                              {{3, 0, 0}, 1.25f}, {{-3, 0.5f, 0}, 1.25f}, {{0, 12, 0}, 1}};
    for (const double radius : {0.1, 4., 20.})
        for (const auto& [eye, before] : places) {
            const EyeMedia media = drop.lens(eye, radius);
            EXPECT_EQ(media.at(eye).index(), before);
            for (const auto& [place, after] : places) EXPECT_EQ(media.at(place).index(), after);
        }
}

// The lens lies along the edges of the water's surface, so that every way on it from the air crosses one.
TEST(Eye, HasALensAlongEdges) {
    Things things;
    gr::PolygonMesh tank;
    for (const double y : {-4., 0.})
        for (int x = -2; x <= 2; ++x)
            for (int z = -1; z <= 1; ++z) tank.vertices.push_back({x, y, z});
    const auto at = [](int y, int x, int z) { return 15 * y + 3 * x + z; };
    for (int x = 0; x < 4; ++x)
        for (int z = 0; z < 2; ++z) {
            tank.faces.push_back({at(1, x, z), at(1, x, z + 1), at(1, x + 1, z + 1)});
            tank.faces.push_back({at(1, x, z), at(1, x + 1, z + 1), at(1, x + 1, z)});
            tank.faces.push_back({at(0, x, z), at(0, x + 1, z), at(0, x + 1, z + 1), at(0, x, z + 1)});
        }
    for (int x = 0; x < 4; ++x) {
        tank.faces.push_back({at(0, x, 0), at(1, x, 0), at(1, x + 1, 0), at(0, x + 1, 0)});
        tank.faces.push_back({at(0, x, 2), at(0, x + 1, 2), at(1, x + 1, 2), at(1, x, 2)});
    }
    for (int z = 0; z < 2; ++z) {
        tank.faces.push_back({at(0, 0, z), at(0, 0, z + 1), at(1, 0, z + 1), at(1, 0, z)});
        tank.faces.push_back({at(0, 4, z), at(1, 4, z), at(1, 4, z + 1), at(0, 4, z + 1)});
    }
    things.add("tank", gr::polyhedronNode(tank), water);
    for (const float height : {-0.25f, 0.25f}) {
        const EyeMedia media = things.lens({0, height, 0}, 1);
        for (int i = -8; i <= 8; ++i)
            for (const float y : {-0.5f, 0.5f}) EXPECT_EQ(media.at({i / 16.f, y, 0}).index(), y < 0 ? 1.25f : 1) << i;
    }
}

// What single precision cannot tell apart lies in the way of each other: each dielectric is found by itself.
TEST(Eye, HasNoLargestNumber) {
    Things things;
    const auto tetrahedron = [](const std::vector<glm::dvec3>& vertices) {
        return gr::polyhedronNode({vertices, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}});
    };
    things.add("glass",
               tetrahedron({{13366478642.8, -7565193255.9, 238269858938.3},
                            {2624712566.7, 792907642.4, -48239202002.5},
                            {42906871147.5, 47091225113.4, -994684895.7},
                            {-221502358789.6, -628292889570.7, 60072722014.7}}),
               glass);
    things.add("stone",
               tetrahedron({{116604748.8, -3902025585, 3817450909.8},
                            {728802297592.3, -2246883471, 106140948.8},
                            {79724611661.8, 716378392242.6, -94448493915.9},
                            {-138994289.8, -667851742701.5, 396562372.2}}),
               materials::Diffuse{});
    things.add("box",
               gr::BoxNode{{-14911756537.5, -101646212.5, 85722099729.9}, {876162489.8, 359396383.7, 1506563607.2}},
               water);
    things.database.rotate(":box", 0, 1.0714583248877014);
    things.compile();
    const Vec3f eye(-180992956.3f, 143086895.5f, -188787431.2f);
    support::TestRandom random(1);
    for (const double radius : {1e9, 4.8e11, 1e18}) {
        const EyeMedia media = things.lens(eye, radius);
        for (int i = 0; i < 2000; ++i) {
            const Vec3f place = eye + Vec3f(gr::randomPoint(random, -1, 1) * radius);
            EXPECT_EQ(media.at(place).index(), things.index(place)) << i;
        }
    }
}

class EyeBesideGlass : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, EyeBesideGlass, eachIntegrator, integratorName);

// Blocks that are not in the picture leave it as it is.
TEST_P(EyeBesideGlass, SeesThroughAir) {
    TestScene scene;
    scene.settings.globalIllumination = true;
    scene.settings.background = core::Rgbf(1);
    scene.add("a", gr::BoxNode{{3, 4, 5}, {1, 1, 1}}, glass);
    scene.add("b", gr::BoxNode{{3, 4, 6}, {1, 1, 1}}, glass);
    EXPECT_EQ(Radiometer(scene, {0, 0.5, 2}).sample({{0, 0.5f, 2}, {0, 0, -1}}, 1, 0), core::Rgbf(1));
}

}  // namespace
}  // namespace render
