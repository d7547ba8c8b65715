// Where surfaces of two operands coincide nothing is left between them, and one of them is met, always the same: turned
// and moved, so that rounding decides which comes first. Seen to fail without the look ahead for what ends within
// rounding, with one that does not ask whether the surfaces are parallel (the wedges), where the nearer of two surfaces
// is taken in place of the one made first, where the error bound of an operand is its own alone, and where lanes take
// what they meet first without a look at what is beside it.
#include "gr/convex_places.h"
#include "gr/random_shapes.h"
#include "gr/scene.h"
#include "gr/tracer.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Rayf;
using core::Vec3f;

// A CSG object somewhere askew, and rays through it.
class Placed {
public:
    template<class Build>
    Placed(Build&& build, support::TestRandom& random) {
        Database database;
        database.create(":", "place", TransformNode{});
        database.translate(":place", 3. * randomPoint(random, -1, 1));
        for (int axis = 0; axis < 3; ++axis) database.rotate(":place", axis, 360 * random.next());
        database.scale(":place", glm::dvec3(0), glm::dvec3(std::pow(10, random.next())));
        matrix_ = *database.find(":place").matrix;
        build(database, ":place");
        scene_ = compile(database, ":", {});
        accelerator_ = makeNoAccelerator(scene_);
        lanes_.emplace(scene_, *accelerator_, false);
        for (std::uint32_t i = 0; i < scene_.instances.size(); ++i)
            if (scene_.instances[i].isOperand) operands_.push_back(i);
    }
    Placed(const Placed&) = delete;
    Placed& operator=(const Placed&) = delete;

    // The number of the operand that is met, or -1.
    int operandMet(const glm::dvec3& from, const glm::dvec3& to) const {
        const Vec3f origin(transformed(matrix_, from));
        const std::optional<Hit> hit = met({origin, Vec3f(transformed(matrix_, to)) - origin});
        if (!hit) return -1;
        return static_cast<int>(std::find(operands_.begin(), operands_.end(), hit->instance) - operands_.begin());
    }

    // Whether a ray that leaves what is met, to the side from which it was met, meets nothing more.
    bool isLeftFreely(const glm::dvec3& from, const glm::dvec3& to, support::TestRandom& random) const {
        const Vec3f origin(transformed(matrix_, from));
        const Rayf ray{origin, Vec3f(transformed(matrix_, to)) - origin};
        const std::optional<Hit> hit = met(ray);
        if (!hit) return false;
        const SurfacePoint surface = scene_.surfaceAt(ray, *hit);
        return !met({surface.offset(surface.normal), leave(surface.normal, random)});
    }

private:
    // By one ray alone and in lanes, which must be the same.
    std::optional<Hit> met(const Rayf& ray) const {
        const std::optional<Hit> hit = accelerator_->intersect(ray);
        TraversalCounts counts;
        const Hit inLanes = lanes_->nearest(ray, true, counts);
        EXPECT_EQ(inLanes.t, hit ? hit->t : core::infinity);
        if (hit) {
            EXPECT_EQ(inLanes.instance, hit->instance);
        }
        return hit;
    }

    glm::dmat4 matrix_;
    Scene scene_;
    std::unique_ptr<Accelerator> accelerator_;
    std::optional<Tracer<float>> lanes_;
    std::vector<std::uint32_t> operands_;
};

template<class Build, class Check>
void inManyPlaces(Build&& build, Check&& check) {
    support::TestRandom random(1);
    for (int i = 0; i < 200; ++i) {
        const Placed placed(build, random);
        for (int j = 0; j < rayCount(50); ++j) check(placed, random);
    }
}

NodeContent wall() {
    return BoxNode{{-1, -1, 0}, {2, 2, 0.3}};
}

// A hole as deep as the wall goes through, whatever makes it.
TEST(CsgFilm, NothingIsLeftOfAWallWhereAHoleEnds) {
    const PolygonMesh cube = cubeMesh();
    for (const int kind : {0, 1, 2, 3})
        inManyPlaces(
            [&](Database& database, const std::string& place) {
                const std::string wallWithHole = database.create(place, "d", DifferenceNode{}).path();
                database.create(wallWithHole, "wall", wall());
                if (kind == 0) database.create(wallWithHole, "hole", BoxNode{{-0.5, -0.5, 0}, {1, 1, 0.3}});
                if (kind == 1 || kind == 2) {
                    NodeContent hole = kind == 1 ? NodeContent(CylinderNode{glm::dvec3(0), 0.5, 0.3})
                                                 : NodeContent(ConeNode{glm::dvec3(0), 0.5, 0.3, 0.5});
                    database.create(wallWithHole, "hole", std::move(hole));
                    database.rotate(wallWithHole + ":hole", 0, 90);
                }
                if (kind == 3) {
                    database.create(wallWithHole, "hole", polyhedronNode(cube));
                    database.scale(wallWithHole + ":hole", {0, 0, 0}, {0.5, 0.5, 0.15});
                    database.translate(wallWithHole + ":hole", {0, 0, 1});
                }
            },
            [](const Placed& placed, support::TestRandom& random) {
                // Both ends of the way are well within the hole.
                glm::dvec3 from = randomPoint(random, -0.3, 0.3), to = from + 0.02 * randomPoint(random, -1, 1);
                const bool isBack = random.next() < 0.5;
                from.z = isBack ? 3 : -3;
                to.z = isBack ? -3 : 3;
                EXPECT_EQ(placed.operandMet(from, to), -1);
                // And beside it is the wall.
                from.x += 1.2 - 2 * from.x * (from.x < 0);
                EXPECT_EQ(placed.operandMet({0.8, from.y, from.z}, {0.8, to.y, to.z}), 0);
            });
}

// Two blocks side by side, or an intersection that has no inside.
TEST(CsgFilm, NothingPartsTwoBlocksOfAUnion) {
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string both = database.create(place, "u", UnionNode{}).path();
            database.create(both, "left", BoxNode{{-1, -1, -1}, {1, 2, 2}});
            database.create(both, "right", BoxNode{{0, -1, -1}, {1, 2, 2}});
        },
        [](const Placed& placed, support::TestRandom& random) {
            // From within one of them the next surface is the other's outside.
            glm::dvec3 from = randomPoint(random, -0.8, 0.8), to = randomPoint(random, -0.8, 0.8);
            from.x = -0.2 - 0.5 * random.next();
            to.x = 3;
            to.y = to.z = 0;
            EXPECT_EQ(placed.operandMet(from, to), 1);
        });
}

TEST(CsgFilm, AnIntersectionOfBlocksSideBySideIsNothing) {
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string both = database.create(place, "i", IntersectionNode{}).path();
            database.create(both, "left", BoxNode{{-1, -1, -1}, {1, 2, 2}});
            database.create(both, "right", BoxNode{{0, -1, -1}, {1, 2, 2}});
            database.create(place, "beyond", BoxNode{{2, -9, -9}, {1, 18, 18}});
        },
        [](const Placed& placed, support::TestRandom& random) {
            glm::dvec3 from = randomPoint(random, -0.8, 0.8), to = randomPoint(random, -0.8, 0.8);
            from.x = -3;
            to.x = 3;
            const int met = placed.operandMet(from, to);
            EXPECT_NE(met, 0);
            EXPECT_NE(met, 1);
        });
}

// Their fronts lie in one plane: the operand that was made first is met, and of the holes of a difference, too.
TEST(CsgFilm, OfSurfacesThatLookTheSameWayTheFirstMadeIsMet) {
    const auto front = [](const Placed& placed, support::TestRandom& random) {
        glm::dvec3 from = randomPoint(random, -0.8, 0.8), to = from + 0.1 * randomPoint(random, -1, 1);
        from.z = 4;
        to.z = 0;
        return placed.operandMet(from, to);
    };
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string both = database.create(place, "u", UnionNode{}).path();
            database.create(both, "first", BoxNode{{-1, -1, -1}, {2, 2, 2}});
            database.create(both, "second", BoxNode{{-2, -2, 0.5}, {4, 4, 0.5}});
        },
        [&](const Placed& placed, support::TestRandom& random) { EXPECT_EQ(front(placed, random), 0); });
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string both = database.create(place, "i", IntersectionNode{}).path();
            database.create(both, "first", BoxNode{{-2, -2, 0.5}, {4, 4, 0.5}});
            database.create(both, "second", BoxNode{{-1, -1, -1}, {2, 2, 2}});
        },
        [&](const Placed& placed, support::TestRandom& random) { EXPECT_EQ(front(placed, random), 0); });
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string holes = database.create(place, "d", DifferenceNode{}).path();
            database.create(holes, "block", BoxNode{{-3, -3, -3}, {6, 6, 5}});
            database.create(holes, "first", BoxNode{{-1, -1, -1}, {2, 2, 9}});
            database.create(holes, "second", BoxNode{{-2, -2, -1}, {4, 4, 9}});
        },
        [&](const Placed& placed, support::TestRandom& random) {
            glm::dvec3 from = randomPoint(random, -0.8, 0.8), to = from;
            from.z = 4;
            to.z = -2;
            EXPECT_EQ(placed.operandMet(from, to), 1);
        });
}

// Of two fronts in one plane one is of a block a thousand times as large, which rounding moves farther: a step off the
// small one's leads beyond both.
TEST(CsgFilm, BothAreLeftAtOnce) {
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string both = database.create(place, "u", UnionNode{}).path();
            database.create(both, "small", BoxNode{{-1, -1, -1}, {2, 2, 2}});
            database.create(both, "large", BoxNode{{-2000, -2000, -3999}, {4000, 4000, 4000}});
        },
        [](const Placed& placed, support::TestRandom& random) {
            glm::dvec3 from = randomPoint(random, -0.8, 0.8), to = from + 0.1 * randomPoint(random, -1, 1);
            from.z = 4;
            to.z = 0;
            EXPECT_TRUE(placed.isLeftFreely(from, to, random));
        });
}

// A thin edge between two surfaces that are not parallel is there to its end, or nearly.
TEST(CsgFilm, WedgesAreNoFilms) {
    inManyPlaces(
        [](Database& database, const std::string& place) {
            const std::string wedge = database.create(place, "i", IntersectionNode{}).path();
            database.create(wedge, "flat", BoxNode{{-1, 0, -1}, {2, 1, 2}});
            database.create(wedge, "tilted", BoxNode{{-1, -1, -1}, {2, 1, 2}});
            database.rotate(wedge + ":tilted", 2, 5);
        },
        [](const Placed& placed, support::TestRandom& random) {
            // Where it is 10^-5 thick and more.
            const double x = 2e-4 + 1e-3 * random.next();
            EXPECT_GE(placed.operandMet({x, 3, 0.5 * random.next()}, {x, -3, 0.5 * random.next()}), 0);
        });
}

}  // namespace
}  // namespace gr
