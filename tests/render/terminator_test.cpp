// The border between light and dark on a coarse ball that is shaded as a round one: it is the sphere's, and does not
// run in steps along the faces' edges. Seen to fail with shadow rays that start on the face, and with light that counts
// nothing when it is behind the face.
#include "gr/mesh/lathe.h"
#include "render/each_integrator.h"

#include <numbers>

namespace render {
namespace {

std::shared_ptr<const gr::Polyhedron> turnedBall(int sides, int parts) {
    std::vector<gr::ProfilePoint> profile;
    for (int i = 0; i <= parts; ++i) {
        const double angle = std::numbers::pi * (static_cast<double>(i) / parts - 0.5);
        profile.push_back({i == 0 || i == parts ? 0 : std::cos(angle), std::sin(angle)});
    }
    gr::MeshRepairs repairs;
    return gr::Polyhedron::make(gr::latheMesh(profile, sides), repairs);
}

const core::Vec3f lamp(8, 5, 2);

struct Ball : TestScene {
    explicit Ball(const gr::NodeContent& content) {
        add("ball", content, core::Rgbf(1));
        addPointLight("lamp", {glm::dvec3(lamp), core::Rgbf(1), core::Vec3f(1, 0, 0)});
        settings.pathLength = 1;
    }
};

// Root mean square errors against the sphere, as parts of its mean.
struct Errors {
    double now, cut;  // cut: where light from behind a face counts nothing
    int steps;  // places that are dark where the sphere is clearly lit
};

Errors errorsOf(int sides, int parts) {
    const Ball sphere(gr::SphereNode{}), coarse(gr::PolyhedronNode{turnedBall(sides, parts)});
    const gr::Scene scene = gr::compile(coarse.database, ":", coarse.pointLights);
    const auto accelerator = gr::makeNoAccelerator(scene);
    const Radiometer ofSphere(sphere), ofCoarse(coarse);
    double mean = 0, now = 0, cut = 0;
    int count = 0, steps = 0;
    constexpr int half = 40;
    for (int i = -half; i <= half; ++i) {
        for (int j = -half; j <= half; ++j) {
            // Not near the rim, where the polygon's outline is another one.
            const glm::dvec3 target(0.87 * i / half, 0.87 * j / half, 0);
            if (glm::length(target) > 0.87) continue;
            const core::Rayf ray = rayTowards({0, 0, 60}, target);
            const auto hit = accelerator->intersect(ray);
            if (!hit) continue;
            const auto surface = scene.surfaceAt(ray, *hit);
            const double expected = ofSphere.sample(ray, 1, 0).x, found = ofCoarse.sample(ray, 1, 0).x;
            const double ifCut = glm::dot(surface.normal, lamp - surface.position) > 0 ? found : 0;
            mean += expected;
            now += (found - expected) * (found - expected);
            cut += (ifCut - expected) * (ifCut - expected);
            steps += found == 0 && expected > 0.1;
            ++count;
        }
    }
    return {std::sqrt(now * count) / mean, std::sqrt(cut * count) / mean, steps};
}

class Terminator : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, Terminator, eachIntegrator, integratorName);

TEST_P(Terminator, OfACoarseBallIsTheSpheres) {
    const Errors errors = errorsOf(8, 6);
    EXPECT_EQ(errors.steps, 0);
    EXPECT_LT(errors.now, 0.08);
    EXPECT_GT(errors.cut, 0.18);
    RecordProperty("now", std::to_string(errors.now));
    RecordProperty("cut", std::to_string(errors.cut));
}

// It gets better with the square of the faces' size, as the shape itself does.
TEST_P(Terminator, ComesNearTheSpheresWithMoreFaces) {
    const double coarse = errorsOf(16, 12).now, fine = errorsOf(32, 24).now;
    EXPECT_LT(coarse, 0.04);
    EXPECT_LT(fine, coarse / 2.5);
}

}  // namespace
}  // namespace render
