// Where on a surface a point of it is: u grows along the tangent and v does not, v grows to the left of it as seen from
// outside, and both go from 0 to 1.
// Seen to fail with a longitude to the west, v from the north pole down, u and v of a cap exchanged, and coordinates in
// the world instead of the object.
#include "gr/scene.h"
#include "gr/shape_oracle.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Vec3f;

class CoordinatesTest : public testing::TestWithParam<std::size_t> {
protected:
    CoordinatesTest() {
        Database database;
        database.create(":", "shape", oracleObjects()[GetParam()].content);
        // Turned by hand, so that lengths in the world are the object's, and its y axis points elsewhere.
        database.translate(":shape", {0.3, -0.1, 0.2});
        database.rotate(":shape", 0, 70);
        database.rotate(":shape", 2, -25);
        matrix_ = *database.find(":shape").matrix;
        scene_ = compile(database, ":", {});
        accelerator_ = makeNoAccelerator(scene_);
    }

    // What a ray meets that comes straight down on a place near the surface.
    std::optional<SurfacePoint<float>> above(const Vec3f& place, const Vec3f& normal) const {
        const core::Rayf ray{place + normal * 1e-2f, -normal, 2e-2f};
        const std::optional<Hit> hit = accelerator_->intersect(ray);
        return hit ? std::optional(scene_.surfaceAt(ray, *hit)) : std::nullopt;
    }
    std::optional<SurfacePoint<float>> anywhere() {
        const Vec3f from(transformed(matrix_, randomDirection(random_) * 4.0));
        const core::Rayf ray{from, glm::normalize(Vec3f(transformed(matrix_, randomPoint(random_, -1, 1))) - from)};
        const std::optional<Hit> hit = accelerator_->intersect(ray);
        return hit && hit->t < 10 ? std::optional(scene_.surfaceAt(ray, *hit)) : std::nullopt;
    }

    glm::dmat4 matrix_{1};
    Scene scene_;
    std::unique_ptr<Accelerator> accelerator_;
    support::TestRandom random_{5};
};

// From one side of a seam to the other u jumps by 1.
float across(float step) {
    return step > 0.5f ? step - 1 : step < -0.5f ? step + 1 : step;
}

TEST_P(CoordinatesTest, GrowAlongTheTangentAndAcrossIt) {
    constexpr float step = 2e-3f;
    int checked = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto at = anywhere();
        if (!at) continue;
        const Vec3f u = glm::normalize(at->tangent), v = glm::cross(at->normal, u);
        EXPECT_NEAR(glm::dot(u, at->normal), 0, 1e-5);
        const auto east = above(at->position + u * step, at->normal),
                   north = above(at->position + v * step, at->normal);
        // Not from one face to the next, and not round the pole, nor where the tube is hardly wider than the step.
        const auto isNext = [&](const auto& to) { return to && glm::dot(to->normal, at->normal) > 0.98f; };
        if (!isNext(east) || !isNext(north)) continue;
        if (glm::dot(glm::normalize(east->tangent), u) < 0.98f || glm::dot(glm::normalize(north->tangent), u) < 0.98f)
            continue;
        ++checked;
        const core::Vec2f alongU = east->uv - at->uv, alongV = north->uv - at->uv;
        ASSERT_GT(across(alongU.x), 5e-5f) << at->uv.x << " " << at->uv.y;
        ASSERT_LT(std::abs(across(alongU.y)), 0.1f * across(alongU.x));
        ASSERT_GT(across(alongV.y), 5e-5f) << at->uv.x << " " << at->uv.y;
        ASSERT_LT(std::abs(across(alongV.x)), 0.1f * across(alongV.y));
    }
    EXPECT_GT(checked, 100);  // of the thinnest shape
}

class CoordinatesFrom0To1Test : public CoordinatesTest {};

TEST_P(CoordinatesFrom0To1Test, HaveTheseEnds) {
    core::Vec2f least(1), most(0);
    for (int i = 0; i < 20'000; ++i) {
        const auto at = anywhere();
        if (!at) continue;
        least = glm::min(least, at->uv);
        most = glm::max(most, at->uv);
    }
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_GE(least[axis], -1e-5f);
        EXPECT_LE(most[axis], 1 + 1e-5f);
        EXPECT_LT(least[axis], 0.05f);
        EXPECT_GT(most[axis], 0.95f);
    }
}

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
    return oracleObjects()[info.param].name;
}

// Planes and meshes have units of their own.
std::vector<std::size_t> thoseFrom0To1() {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < oracleObjects().size(); ++i) {
        const NodeContent& content = oracleObjects()[i].content;
        if (!std::holds_alternative<PlaneNode>(content) && !std::holds_alternative<PolyhedronNode>(content))
            numbers.push_back(i);
    }
    return numbers;
}

INSTANTIATE_TEST_SUITE_P(All, CoordinatesTest, testing::Range<std::size_t>(0, oracleObjects().size()), nameOf);
INSTANTIATE_TEST_SUITE_P(All, CoordinatesFrom0To1Test, testing::ValuesIn(thoseFrom0To1()), nameOf);

}  // namespace
}  // namespace gr
