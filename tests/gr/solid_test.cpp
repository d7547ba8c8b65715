// Where rays cross solids.
// Seen to fail with triangles that count on both sides of an edge, with edges that count on neither, a triangle's side
// turned round, a ball or a mesh that holds its surface, the end of a ray left out, rays that are left in the world's
// space, and the box round a place, too.
#include "gr/near_solid.h"
#include "gr/random_shapes.h"
#include "gr/scene.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

const core::Vec3f oblique(0.48f, 0.64f, 0.6f);

Scene sceneOf(const NodeContent& content, const std::function<void(Database&)>& place = {}) {
    Database database;
    database.create(":", "solid", content);
    if (place) place(database);
    return compile(database, ":", {});
}

// Exits less entries.
int exitsOf(const Scene& scene, const core::Rayf& ray) {
    std::vector<SolidCrossing> crossings;
    addCrossings(scene, scene.instances[0], ray, crossings);
    int exits = 0;
    for (const SolidCrossing& crossing : crossings) {
        exits += crossing.enters ? -1 : 1;
        EXPECT_GE(crossing.t, 0);
        EXPECT_LE(crossing.t, ray.tMax);
    }
    return exits;
}

TEST(SolidCrossings, TellWhetherAPointIsInABall) {
    const Scene scene = sceneOf(SphereNode{{3, 0, 0}, 2});
    EXPECT_EQ(exitsOf(scene, {{3, 0, 0}, oblique}), 1);
    EXPECT_EQ(exitsOf(scene, {{1.0625f, 0, 0}, oblique}), 1);
    EXPECT_EQ(exitsOf(scene, {{0.9375f, 0, 0}, {1, 0, 0}}), 0) << "goes through it";
    for (const core::Vec3f& direction : {core::Vec3f(1, 0, 0), core::Vec3f(-1, 0, 0), core::Vec3f(0, 1, 0)})
        EXPECT_EQ(exitsOf(scene, {{1, 0, 0}, direction}), 0) << "on the surface";
    std::vector<SolidCrossing> crossings;
    addCrossings(scene, scene.instances[0], {{4, 0, 0}, {-2, 0, 0}}, crossings);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_NEAR(crossings[0].t, 1.5, 1e-12);
}

TEST(SolidCrossings, TellWhetherAPointIsInABox) {
    const Scene scene = sceneOf(BoxNode{{1, 1, 1}, {2, 4, 8}});
    EXPECT_EQ(exitsOf(scene, {{2, 2, 2}, oblique}), 1);
    EXPECT_EQ(exitsOf(scene, {{2, 2, 2}, {0, -1, 0}}), 1);
    EXPECT_EQ(exitsOf(scene, {{0, 2, 2}, {1, 0, 0}}), 0) << "goes through it";
    for (const core::Vec3f& direction : {core::Vec3f(1, 0, 0), core::Vec3f(-1, 0, 0), core::Vec3f(0, 1, 0)})
        EXPECT_EQ(exitsOf(scene, {{1, 2, 2}, direction}), 0) << "on the surface";
    std::vector<SolidCrossing> crossings;
    addCrossings(scene, scene.instances[0], {{2, 2, 2}, {0, 0.5f, 1}}, crossings);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_NEAR(crossings[0].t, 6, 1e-12);
}

// Whether a point is within a shape of the list, in double precision.
struct Within {
    const char* name;
    NodeContent content;
    bool (*holds)(const glm::dvec3& p);
};

std::vector<Within> solids() {
    static constexpr auto radius = [](const glm::dvec3& p) { return std::hypot(p.x, p.z); };
    return {{"sphere", SphereNode{}, [](const glm::dvec3& p) { return glm::length(p) < 1; }},
            {"box", BoxNode{glm::dvec3(-0.5), glm::dvec3(1)},
             [](const glm::dvec3& p) {
                 return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 0.5;
             }},
            {"cylinder", CylinderNode{{0, -0.5, 0}, 1, 1},
             [](const glm::dvec3& p) { return radius(p) < 1 && std::abs(p.y) < 0.5; }},
            {"cone", ConeNode{{0, -0.5, 0}, 1, 1},
             [](const glm::dvec3& p) { return radius(p) < 0.5 - p.y && std::abs(p.y) < 0.5; }},
            {"cup", ConeNode{{0, -0.5, 0}, 0.4, 1, 1.2},
             [](const glm::dvec3& p) { return radius(p) < 0.8 * (p.y + 1) && std::abs(p.y) < 0.5; }},
            {"torus", TorusNode{.radius = 0.7, .tube = 0.4},
             [](const glm::dvec3& p) { return std::hypot(radius(p) - 0.7, p.y) < 0.4; }},
            {"plane", PlaneNode{{0, 0.1, 0}, {0, 1, 0}}, [](const glm::dvec3& p) { return p.y < 0.1; }}};
}

// From any place to any other, and without end.
TEST(SolidCrossings, TellOnWhichSideOfEachShapeTheEndsAre) {
    support::TestRandom random(9);
    for (const Within& solid : solids()) {
        const Scene scene = sceneOf(solid.content);
        int inside = 0;
        for (int i = 0; i < 20'000; ++i) {
            const core::Vec3f from(randomPoint(random, -1.5, 1.5)), to(randomPoint(random, -1.5, 1.5));
            const bool isIn = solid.holds(from), endsIn = solid.holds(glm::dvec3(from) + glm::dvec3(to - from));
            inside += isIn;
            ASSERT_EQ(exitsOf(scene, {from, to - from, 1}), isIn - endsIn) << solid.name;
            const bool endsBelow = isEndless(scene.instances[0].shape) && to.y < from.y;
            ASSERT_EQ(exitsOf(scene, {from, to - from}), isIn - endsBelow) << solid.name;
            std::vector<SolidCrossing> crossings;
            addCrossings(scene, scene.instances[0], {from, to - from, 1}, crossings);
            for (const SolidCrossing& crossing : crossings) {
                // Near there is a place within, and one without.
                const glm::dvec3 at = glm::dvec3(from) + glm::dvec3(to - from) * crossing.t;
                int held = 0;
                for (int side = 0; side < 6; ++side) {
                    glm::dvec3 aside(0);
                    aside[side / 2] = side % 2 == 0 ? 1e-5 : -1e-5;
                    held += solid.holds(at + aside);
                }
                ASSERT_TRUE(held > 0 && held < 6) << solid.name << ", " << held;
                ASSERT_EQ(crossing.enters, endsIn) << solid.name;
            }
        }
        EXPECT_GT(inside, 200) << solid.name;
    }
}

// A shape of the list that holds something must be among those above.
TEST(SolidCrossings, AreTestedForEveryShapeOfTheList) {
    std::vector<bool> has(std::variant_size_v<Shape>);
    for (const Within& solid : solids()) has[sceneOf(solid.content).instances[0].shape.index()] = true;
    const auto check = [&]<class Node>(const Node& node) {
        EXPECT_EQ(has[Shape(node.shape()).index()], decltype(node.shape())::isSolid) << Node::kind;
    };
    [&]<class... Nodes>(std::type_identity<ShapeNodeList<Nodes...>>) {
        (check(Nodes{}), ...);
    }(std::type_identity<ShapeNodes>());
}

// From one point to another only what lies between them counts.
TEST(SolidCrossings, EndWithTheRay) {
    for (const NodeContent& content :
         {NodeContent(SphereNode{}), NodeContent(BoxNode{glm::dvec3(-0.75), glm::dvec3(1.5)}),
          NodeContent(polyhedronNode(icosphereMesh(2))), NodeContent(polyhedronNode(cubeMesh()))}) {
        const Scene scene = sceneOf(content);
        const core::Vec3f in(0.25f, -0.5f, 0.125f), out(2, 3, -1);
        EXPECT_EQ(exitsOf(scene, {in, out - in, 1}), 1);
        EXPECT_EQ(exitsOf(scene, {out, in - out, 1}), -1);
        EXPECT_EQ(exitsOf(scene, {in, -2.f * in, 1}), 0);
        EXPECT_EQ(exitsOf(scene, {out, core::Vec3f(-4, -6, 2), 1}), 0);
        EXPECT_EQ(exitsOf(scene, {out, core::Vec3f(1, 2, 3), 1}), 0);
        EXPECT_EQ(exitsOf(scene, {in, core::Vec3f(0), 1}), 0) << "no way";
    }
}

// Through each vertex and the middle of each edge, from within and from outside, along the axes, too.
TEST(MeshCrossings, AreOneAtEdgesAndVertices) {
    for (const PolygonMesh& mesh : {cubeMesh(), icosphereMesh(0), icosphereMesh(2)}) {
        const Scene scene = sceneOf(polyhedronNode(mesh));
        std::vector<core::Vec3f> targets;
        for (const auto& face : mesh.faces)
            for (std::size_t i = 0; i < face.size(); ++i) {
                const core::Vec3f a(mesh.vertices[face[i]]), b(mesh.vertices[face[(i + 1) % face.size()]]);
                targets.push_back(a);
                targets.push_back((a + b) * 0.5f);
            }
        for (const core::Vec3f& target : targets) {
            EXPECT_EQ(exitsOf(scene, {{0, 0, 0}, target}), 1);
            EXPECT_EQ(exitsOf(scene, {2.f * target, -target}), 0);
            EXPECT_EQ(exitsOf(scene, {2.f * target, -2.f * target, 1}), -1);
        }
        for (int axis = 0; axis < 3; ++axis)
            for (const core::Vec3f& target : targets) {
                core::Vec3f along(0);
                along[axis] = 1;
                EXPECT_EQ(exitsOf(scene, {target - 4.f * along, along}), 0);
                EXPECT_EQ(exitsOf(scene, {target * 0.5f, along}), 1);
                EXPECT_EQ(exitsOf(scene, {target * 0.5f, -along}), 1);
            }
    }
}

TEST(MeshCrossings, LeaveTheSurfaceOutside) {
    const Scene scene = sceneOf(polyhedronNode(cubeMesh()));
    for (int axis = 0; axis < 3; ++axis)
        for (const float face : {-1.f, 1.f}) {
            core::Vec3f on(0.25f, -0.5f, 0.125f), out(0);
            on[axis] = face;
            out[axis] = face;
            EXPECT_EQ(exitsOf(scene, {on, out}), 0);
            EXPECT_EQ(exitsOf(scene, {on, -out}), 0);
            EXPECT_EQ(exitsOf(scene, {on - out, out, 1}), 1);
            EXPECT_EQ(exitsOf(scene, {on + out, -out, 1}), 0);
        }
}

TEST(MeshCrossings, AgreeWithTheBallRoundThem) {
    support::TestRandom random(1);
    const Scene ball = sceneOf(polyhedronNode(icosphereMesh(4)), [](Database& database) {
        database.scale(":solid", {0, 0, 0}, {1, -2, 0.5});
        database.rotate(":solid", 0, 30);
        database.translate(":solid", {7, 0, 0});
    });
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 point = randomPoint(random, -2.2, 2.2) + glm::dvec3(7, 0, 0);
        const core::Vec3f inObject = ball.instances[0].place.objectFromWorld().point(core::Vec3f(point));
        const float radius = glm::length(inObject);
        if (radius > 0.99f && radius < 1.01f) continue;
        inside += radius < 1;
        for (int k = 0; k < 3; ++k)
            ASSERT_EQ(exitsOf(ball, {core::Vec3f(point), core::Vec3f(randomDirection(random))}), radius < 1 ? 1 : 0);
    }
    EXPECT_GT(inside, 100);
}

// Larger than what single precision can square, and rounded to nothing beside it.
TEST(MeshCrossings, HaveNoLargestNumber) {
    for (const double size : {1e-12, 1., 1e10, 1e18})
        for (const double away : {0., 1., 1e9, 1e18}) {
            PolygonMesh mesh = cubeMesh();
            for (glm::dvec3& v : mesh.vertices) v = (v + glm::dvec3(0, 0, 5)) * (size / 8);
            const Scene scene = sceneOf(polyhedronNode(mesh));
            const core::Vec3f middle(0, 0, static_cast<float>(size * 5 / 8)), far(static_cast<float>(away + size));
            EXPECT_EQ(exitsOf(scene, {middle, oblique}), 1);
            EXPECT_EQ(exitsOf(scene, {middle, far, 1}), 1) << size << ' ' << away;
            EXPECT_EQ(exitsOf(scene, {middle + far, oblique}), 0);
            EXPECT_EQ(exitsOf(scene, {-far, far}), 0);
        }
}

// A place near an eye: one box round it, or one beside it.
TEST(NearSolid, CrossesAsTheWholeSolidDoes) {
    support::TestRandom random(2);
    int crossed = 0, beyond = 0;
    for (int i = 0; i < 400; ++i) {
        const Scene scene = sceneOf(polyhedronNode(icosphereMesh(2)),
                                    [&](Database& database) { squeezeAtRandom(database, ":solid", 2, 1, random); });
        const core::Vec3f eye(randomPoint(random, -1, 1));
        const float radius = static_cast<float>(random.next());
        const NearSolid near(scene, scene.instances[0], core::Bounds{eye, eye}.widened(radius));
        beyond += near.isBeyond();
        for (int k = 0; k < 20; ++k) {
            const core::Rayf ray{eye, core::Vec3f(randomPoint(random, -radius, radius)), 1};
            std::vector<SolidCrossing> all, found;
            addCrossings(scene, scene.instances[0], ray, all);
            near.addCrossings(ray, found);
            ASSERT_EQ(found.size(), all.size());
            const auto isBefore = [](const SolidCrossing& a, const SolidCrossing& b) { return a.t < b.t; };
            std::sort(all.begin(), all.end(), isBefore);
            std::sort(found.begin(), found.end(), isBefore);
            for (std::size_t c = 0; c < all.size(); ++c) {
                EXPECT_EQ(found[c].t, all[c].t);
                EXPECT_EQ(found[c].enters, all[c].enters);
            }
            crossed += !all.empty();
            EXPECT_TRUE(all.empty() || !near.isBeyond());
        }
    }
    EXPECT_GT(crossed, 100);
    EXPECT_GT(beyond, 10);
}

}  // namespace
}  // namespace gr
