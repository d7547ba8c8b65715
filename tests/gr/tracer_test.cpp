// What the tracer finds is what the accelerators find by themselves: the same surfaces, no leak, nothing in the way of
// light; and it finds the same bits whichever accelerator it asks, which accelerator_checks.h asks of harder scenes,
// too. GRSH_TEST_RAYS=40 traces 10^8 rays. Seen to fail with faces a hair too small, with places that keep no margin to
// the edges, with no more than a fixed hair for faces that are seen from afar, and with no face that blocks.
#include "gr/tracer.h"

#include "gr/accelerator_checks.h"
#include "gr/uv_sphere_mesh.h"

namespace gr {
namespace {

using core::Rayf;
using core::Vec3f;
using Surface = SurfacePoint<float>;

// One lane.
class OneLane {
public:
    explicit OneLane(const Scene& scene, const char* accelerator = "off")
        : all_(makeNoAccelerator(scene)),
          accelerator_(makeAccelerator(accelerator, scene, 1, true)),
          tracer_(scene, *accelerator_, true) {}
    OneLane(const OneLane&) = delete;
    OneLane& operator=(const OneLane&) = delete;

    Hit hit(const Rayf& ray) const {
        TraversalCounts counts;
        return tracer_.nearest(ray, true, counts);
    }
    Surface nearest(const Rayf& ray) const { return tracer_.surfaceAt(ray, hit(ray)); }
    bool occluded(const Rayf& ray) const {
        TraversalCounts counts;
        return tracer_.occluded(ray, true, counts);
    }
    const Accelerator& all() const { return *all_; }

private:
    std::unique_ptr<Accelerator> all_, accelerator_;
    Tracer<float> tracer_;
};

class TracerTest : public testing::TestWithParam<std::size_t> {
protected:
    TracerTest() : shape_(convexShapes()[GetParam()]) {}

    ConvexShape shape_;
};

TEST_P(TracerTest, MeetsWhatIsConvexFromOutsideOnce) {
    Violations metAgain, wrongSide;
    support::TestRandom random(1);
    forEachPlace(shape_, rayCount(4), random, alone, [&](const ConvexPlace& place) {
        const OneLane lane(place.scene);
        for (int i = 0; i < 1000; ++i) {
            const Rayf ray = place.rayFromOutside(random);
            const Surface surface = lane.nearest(ray);
            if (!surface.isMet()) continue;
            const float cosine = glm::dot(ray.direction, surface.normal);
            if (!(cosine < 0) && !shape_.isFlat && !shape_.isMesh) wrongSide.add(place.text(), ": cosine ", cosine);
            const Vec3f side = shape_.isFlat && cosine > 0 ? -surface.normal : surface.normal;
            for (int j = 0; j < 2; ++j) {
                const Rayf next{surface.offset(side), leave(side, random)};
                const Surface again = lane.nearest(next);
                if (again.isMet())
                    metAgain.add(place.text(), ": t ", again.t, ", step ", surface.step, ", cosine ",
                                 glm::dot(next.direction, side));
            }
        }
    });
    EXPECT_EQ(metAgain.count(), 0) << metAgain.text();
    EXPECT_EQ(wrongSide.count(), 0) << wrongSide.text();
}

class TracerInsideTest : public testing::TestWithParam<std::size_t> {
protected:
    TracerInsideTest() : shape_(closedShapes()[GetParam()]) {}

    ConvexShape shape_;
};

TEST_P(TracerInsideTest, NeverLeavesWhatItIsInside) {
    Violations escaped, fromOutside, sameFace;
    support::TestRandom random(2);
    forEachPlace(shape_, rayCount(4), random, alone, [&](const ConvexPlace& place) {
        const OneLane lane(place.scene);
        for (int path = 0; path < 50; ++path) {
            Rayf ray{place.toWorld(shape_.inside), Vec3f(randomDirection(random))};
            Vec3f lastNormal(0);
            for (int bounce = 0; bounce < 60; ++bounce) {
                const Surface surface = lane.nearest(ray);
                if (!surface.isMet()) {
                    escaped.add(place.text(), ": bounce ", bounce);
                    break;
                }
                const float cosine = glm::dot(ray.direction, surface.normal);
                if (cosine < 0) fromOutside.add(place.text(), ": bounce ", bounce, ", cosine ", cosine);
                const bool hasFaces = !shape_.isRound || shape_.isMesh;
                if (hasFaces && surface.normal == lastNormal)
                    sameFace.add(place.text(), ": bounce ", bounce, ", t ", surface.t, ", step ", surface.step);
                lastNormal = surface.normal;
                ray = {surface.offset(-surface.normal), leave(-surface.normal, random)};
            }
        }
    });
    EXPECT_EQ(escaped.count(), 0) << escaped.text();
    EXPECT_EQ(fromOutside.count(), 0) << fromOutside.text();
    EXPECT_EQ(sameFace.count(), 0) << sameFace.text();
}

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
    return convexShapes()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(All, TracerTest, testing::Range<std::size_t>(0, convexShapes().size()), nameOf);

std::string nameOfClosed(const testing::TestParamInfo<std::size_t>& info) {
    return closedShapes()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(All, TracerInsideTest, testing::Range<std::size_t>(0, closedShapes().size()), nameOfClosed);

// Rays from everywhere into a closed mesh: through a gap between two faces one would see the inside of a third.
void expectClosed(const PolygonMesh& mesh, double distance, int rays) {
    support::TestRandom random(16);
    Database database;
    database.create(":", "body", polyhedronNode(mesh));
    database.translate(":body", {0.3, -0.2, 0.1});
    squeezeAtRandom(database, ":body", 1, 0.5, random);
    const glm::dmat4 matrix = *database.find(":body").matrix;
    const Scene scene = compile(database, ":", {});
    const OneLane lane(scene);
    Violations missed, seenFromWithin;
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 origin = distance == 0 ? randomPoint(random, -0.5, 0.5) : randomDirection(random) * distance;
        const Vec3f from(transformed(matrix, origin));
        // A third of them to a corner, a third to an edge.
        const auto& face = mesh.faces[static_cast<std::size_t>(random.next() * static_cast<double>(mesh.faces.size()))];
        const glm::dvec3 &a = mesh.vertices[static_cast<std::size_t>(face[0])],
                         &b = mesh.vertices[static_cast<std::size_t>(face[1])];
        const glm::dvec3 to = i % 3 == 0   ? a
                              : i % 3 == 1 ? glm::mix(a, b, random.next())
                                           : 0.7 * randomDirection(random);
        const Rayf ray{from, glm::normalize(Vec3f(transformed(matrix, distance == 0 ? to : 0.9 * to)) - from)};
        const Surface surface = lane.nearest(ray);
        if (!surface.isMet())
            missed.add("from ", glm::length(origin));
        else if (distance > 1 && glm::dot(surface.normal, ray.direction) >= 0)
            seenFromWithin.add("from ", glm::length(origin));
    }
    EXPECT_EQ(missed.count(), 0) << "of " << rays << " rays\n" << missed.text();
    EXPECT_EQ(seenFromWithin.count(), 0) << "of " << rays << " rays\n" << seenFromWithin.text();
}

TEST(TracerLeak, OfMeshesIsNone) {
    for (const double distance : {0., 3., 100., 3000.}) {
        SCOPED_TRACE(distance);
        expectClosed(icosphereMesh(2), distance, rayCount(100'000));
        expectClosed(uvSphereMesh(40, 60), distance, rayCount(20'000));
    }
}

// Shapes of all the list, meshes and squares at random, each a material of its own.
Scene randomScene(std::uint64_t seed) {
    support::TestRandom random(seed);
    Database database;
    // Every other one has few enough faces for the lanes to test them.
    const int each = seed % 2 == 0 ? 4 : 2;
    const auto add = [&](const std::string& name, const NodeContent& content) {
        database.create(":", name, TransformNode{});
        database.translate(":" + name, randomPoint(random, -4, 4));
        squeezeAtRandom(database, ":" + name, 1.5, 1, random);
        database.create(":" + name, "shape", content);
        if (std::holds_alternative<AreaLightNode>(content)) return;
        database.addMaterial(name, materials::Shirley{.exponents = {10, 100}});
        database.setMaterial(":" + name, name);
    };
    for (int i = 0; i < each; ++i) {
        const std::string number = std::to_string(i);
        [&]<class... Nodes>(std::type_identity<ShapeNodeList<Nodes...>>) {
            (add(std::string(Nodes::kind) + number, Nodes{}), ...);
        }(std::type_identity<ShapeNodes>());
        add("cube" + number, polyhedronNode(cubeMesh()));
        add("stone" + number, polyhedronNode(icosphereMesh(0)));
        add("lamp" + number, AreaLightNode{core::Rgbf(1), {0, 0, 0}, 1});
    }
    return compile(database, ":", {});
}

// Calls f(scene, lane, ray, maker, number of the ray) for rays through random scenes.
template<class F>
void forEachRay(F&& f) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Scene scene = randomScene(seed);
        const OneLane lane(scene);
        RayMaker maker(scene, 0.5, seed);
        for (int i = 0; i < rayCount(20'000); ++i) {
            core::Rayf ray = maker.next();
            ray.direction = glm::normalize(ray.direction);
            f(scene, lane, ray, maker, i);
        }
    }
}

// All but rays that pass an edge, which one finds to meet it and the other not.
TEST(TracerSurface, IsTheScenes) {
    Violations wrong;
    int met = 0, atEdges = 0;
    forEachRay([&](const Scene& scene, const OneLane& lane, const core::Rayf& ray, RayMaker&, int) {
        const std::optional<Hit> hit = lane.all().intersect(ray);
        const Surface found = lane.nearest(ray);
        if (!hit && !found.isMet()) return;
        // Some rays start on a square, or at a corner: they may meet it or not.
        if ((hit && hit->t < 1e-4f) || found.t < 1e-4f) return;
        if (!hit || !found.isMet() || std::abs(hit->t - found.t) > 1e-3f * (1 + hit->t)) {
            ++atEdges;
            return;
        }
        ++met;
        const SurfacePoint expected = scene.surfaceAt(ray, *hit);
        if (expected.material != found.material || !(glm::length(expected.normal - found.normal) < 1e-4f)) {
            ++atEdges;  // of two that meet or cross there, the other one
            return;
        }
        const float light = expected.light;
        if (light != found.light) wrong.add("light ", found.light, ", expected ", light);
        if (!(std::abs(expected.step - found.step) <= 1e-3f * expected.step)) wrong.add("step ", found.step);
        // Both keep places off the edges, each by a way of its own; on the face's plane they are.
        const Vec3f apart = expected.position - found.position;
        if (!(std::abs(glm::dot(apart, expected.normal)) < 2e-5f)) wrong.add("off the plane, t ", found.t);
        if (!(glm::length(apart) < 1e-2f)) wrong.add("position off by ", glm::length(apart));
        if (!(glm::length(apart) < 1e-4f)) ++atEdges;
        const float turn = glm::dot(glm::normalize(expected.tangent), glm::normalize(found.tangent));
        if (!(turn > 0.99999f)) wrong.add("tangent of material ", found.material, ", light ", light, ": ", turn);
        // A turn about the axis is where it began.
        core::Vec2f step = glm::abs(expected.uv - found.uv);
        if (step.x > 0.9f && step.x < 1.1f) step.x = std::abs(step.x - 1);
        if (!(glm::length(step) < 1e-2f)) wrong.add("uv of material ", found.material, " off by ", glm::length(step));
    });
    EXPECT_EQ(wrong.count(), 0) << wrong.text();
    EXPECT_GT(met, 20'000);
    EXPECT_LT(atEdges, met / 500);
}

// Between points of the scene, where faces with nothing behind them are not looked at.
TEST(TracerShadow, IsTheAccelerators) {
    int lit = 0, dark = 0, different = 0;
    forEachRay([&](const Scene& scene, const OneLane& lane, const core::Rayf& ray, RayMaker& maker, int i) {
        const Surface surface = lane.nearest(ray);
        if (!surface.isMet()) return;
        const Vec3f side = glm::dot(ray.direction, surface.normal) < 0 ? surface.normal : -surface.normal;
        const std::vector<AreaLight>& lamps = scene.lights.of<AreaLight>();
        const AreaLight& light = lamps[static_cast<std::size_t>(i) % lamps.size()];
        const auto u = static_cast<float>(maker.random().next()), v = static_cast<float>(maker.random().next());
        const LightSample<float> sample = light.sample(surface.position, core::Vec2f(u, v));
        if (sample.pdfW == 0 || !(glm::dot(side, sample.wi) > 0)) return;
        const core::Rayf shadow = shadowRay(surface.offset(side), light, sample.target);
        const bool isDark = lane.all().occluded(shadow);
        ++(isDark ? dark : lit);
        different += lane.occluded(shadow) != isDark ? 1 : 0;
    });
    EXPECT_GT(lit, 5'000);
    EXPECT_GT(dark, 5'000);
    EXPECT_LE(different, (lit + dark) / 10'000) << "at edges alone";
}

std::string text(const Hit& hit) {
    return text(std::optional<Hit>(hit));
}

// Which accelerator is asked decides what is tested, never what is found.
TEST(Tracer, FindsTheSameBitsWithEachAccelerator) {
    Violations wrong;
    int met = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Scene scene = randomScene(seed);
        const OneLane off(scene), grid(scene, "grid"), tree(scene, "embree");
        RayMaker maker(scene, 0.5, seed);
        for (int i = 0; i < rayCount(20'000); ++i) {
            const Rayf ray = maker.next();
            const Hit expected = off.hit(ray);
            met += expected.t < core::infinity ? 1 : 0;
            for (const OneLane* other : {&grid, &tree}) {
                const Hit found = other->hit(ray);
                const bool isSameHit = expected.t == core::infinity
                                           ? found.t == core::infinity
                                           : isSame(std::optional(expected), std::optional(found));
                if (!isSameHit) wrong.add(other == &grid ? "grid: " : "tree: ", text(found), ", off: ", text(expected));
                if (other->occluded(ray) != off.occluded(ray)) wrong.add("occluded otherwise");
            }
        }
    }
    EXPECT_EQ(wrong.count(), 0) << wrong.text();
    EXPECT_GT(met, 100'000);
}

}  // namespace
}  // namespace gr
