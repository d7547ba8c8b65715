// Parallel rays, and rays all round.
// Seen to fail with a picture twice as high, a plane of rays at the wrong side of the eye, a panorama that begins in
// the view or is mirrored, latitudes over half the height, a focus 1 % too far, and the depth all round along the
// view.
#include "render/each_integrator.h"
#include "render/layer_picture.h"
#include "render/transport/eye_media.h"

#include "core/lanes.h"

#include <numbers>

namespace render {
namespace {

using core::Vec2f;
using std::numbers::pi;

// Any view that lies askew.
constexpr int width = 60, height = 40;
const glm::dvec3 eye(1, -2, 3), forward = glm::normalize(glm::dvec3(0.3, -0.5, 1)), anyUp(0.1, 2, 0.3),
                                right = glm::normalize(glm::cross(forward, anyUp)), upward = glm::cross(right, forward);

Camera cameraWith(Projection projection, double focus = 1, int columns = width, int lines = height) {
    return Camera({eye, 7.0 * forward, anyUp, 40, columns, lines, projection, focus});
}

double off(const core::Vec3f& a, const glm::dvec3& b) {
    return glm::distance(glm::dvec3(a), b);
}

TEST(Orthographic, LooksAlongTheViewFromAPlaneThroughTheEye) {
    const double focus = 5, pixel = 2 * focus * std::tan(glm::radians(20.0)) / height;
    const Camera camera = cameraWith(Projection::orthographic, focus);
    for (const Vec2f& place : {Vec2f(30, 20), Vec2f(0, 0), Vec2f(60, 40), Vec2f(60, 0), Vec2f(17.25f, 31.5f)}) {
        const core::Rayf ray = camera.ray(place);
        EXPECT_LT(off(ray.direction, forward), 1e-7);
        EXPECT_LT(off(ray.origin, eye + right * (pixel * (place.x - 30)) - upward * (pixel * (place.y - 20))), 2e-6);
        EXPECT_EQ(ray.tMax, core::infinity);
    }
}

// What lies at the focal distance is in the same place of the picture in perspective.
TEST(Orthographic, IsAsLargeAsPerspectiveInThePlaneInFocus) {
    const double focus = 3;
    const Camera parallel = cameraWith(Projection::orthographic, focus), pinhole = cameraWith(Projection::perspective);
    for (const Vec2f& place : {Vec2f(3, 4), Vec2f(55, 39), Vec2f(30, 1)}) {
        const core::Rayf a = parallel.ray(place), b = pinhole.ray(place);
        const glm::dvec3 through(b.direction);
        const glm::dvec3 inFocus = eye + through * (focus / glm::dot(through, forward));
        EXPECT_LT(glm::distance(glm::dvec3(a.origin) + focus * forward, inFocus), 3e-6);
    }
}

TEST(Orthographic, HasALensForEachPlace) {
    const double focus = 4, radius = 0.3;
    const Camera pinhole = cameraWith(Projection::orthographic, focus);
    Camera camera = pinhole;
    camera.setLens(radius, focus);
    for (const Vec2f& place : {Vec2f(3, 4), Vec2f(60, 40)}) {
        const glm::dvec3 middle(pinhole.ray(place).origin);
        for (const Vec2f& u : {Vec2f(0, 0), Vec2f(0.25f, 0.6f), Vec2f(0.999f, 0.3f)}) {
            const core::Rayf ray = camera.ray(place, u);
            const glm::dvec3 origin(ray.origin), direction(ray.direction);
            EXPECT_NEAR(glm::distance(origin, middle), radius * std::sqrt(u.x), 1e-6);
            EXPECT_NEAR(glm::dot(origin - middle, forward), 0, 1e-6);
            const glm::dvec3 met = origin + direction * (focus / glm::dot(direction, forward));
            EXPECT_LT(glm::distance(met, middle + focus * forward), 3e-6);
            EXPECT_NEAR(glm::length(direction), 1, 2e-7);
        }
    }
}

TEST(Panorama, IsLongitudeAndLatitude) {
    const Camera camera = cameraWith(Projection::panorama);
    for (int x = 0; x <= width; x += 5) {
        for (int y = 0; y <= height; y += 4) {
            const double longitude = 2 * pi * (double(x) / width - 0.5), latitude = pi * (0.5 - double(y) / height);
            const glm::dvec3 level = std::cos(longitude) * forward + std::sin(longitude) * right;
            const core::Rayf ray = camera.ray(Vec2f(x, y));
            EXPECT_LT(off(ray.direction, std::cos(latitude) * level + std::sin(latitude) * upward), 5e-7)
                << x << " " << y;
            EXPECT_NEAR(glm::length(ray.direction), 1, 2e-7);
            EXPECT_EQ(ray.origin, core::Vec3f(eye));
        }
    }
}

TEST(Panorama, HasTheViewInItsMiddleAndRightOnTheRight) {
    const Camera camera = cameraWith(Projection::panorama);
    EXPECT_LT(off(camera.ray(Vec2f(30, 20)).direction, forward), 5e-7);
    EXPECT_LT(off(camera.ray(Vec2f(45, 20)).direction, right), 5e-7);
    EXPECT_LT(off(camera.ray(Vec2f(15, 20)).direction, -right), 5e-7);
    EXPECT_LT(off(camera.ray(Vec2f(0, 20)).direction, -forward), 5e-7);
    EXPECT_LT(off(camera.ray(Vec2f(60, 20)).direction, -forward), 5e-7);
    EXPECT_LT(off(camera.ray(Vec2f(7, 0)).direction, upward), 5e-7);
    EXPECT_LT(off(camera.ray(Vec2f(7, 40)).direction, -upward), 5e-7);
}

TEST(Projections, AreTheSameInLanes) {
    using core::Lanes;
    for (const Projection projection : {Projection::orthographic, Projection::panorama}) {
        Camera camera = cameraWith(projection, 4);
        for (const Vec2f& place : {Vec2f(0.5f), Vec2f(32, 17), Vec2f(59.5f, 39.5f)}) {
            const core::Rayf one = camera.ray(place);
            const core::Ray<Lanes> many = camera.ray(core::Vec2<Lanes>(Lanes(place.x), Lanes(place.y)));
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_NEAR(many.origin[axis].get(0), one.origin[axis], 1e-6);
                EXPECT_NEAR(many.direction[axis].get(0), one.direction[axis], 1e-7);
            }
        }
    }
}

// With one sample through each pixel's centre.
class ProjectedPicture : public EachIntegrator {
protected:
    static image::Film picture(const TestScene& scene, const Camera& camera, int columns, int lines) {
        RenderSettings settings = scene.settings;
        settings.samplesPerPixel = 1;
        return layersOf(Radiometer(scene, eye).measuringIntegrator(), camera, settings,
                        image::Film(columns, lines, 0, lines, everyLayer));
    }
    static bool isMet(const image::Film& film, int x, int y) {
        return numberAt(film, image::Layer::depth, x, y) < core::infinity;
    }
};
INSTANTIATE_TEST_SUITE_P(By, ProjectedPicture, eachIntegrator, integratorName);

// However far away, a ball covers pi r^2, and its depth is that of its near half.
TEST_P(ProjectedPicture, OrthographicShowsABallInItsOwnSize) {
    const double focus = 5, pixel = 2 * focus * std::tan(glm::radians(20.0)) / height, radius = 1.3;
    const Camera camera = cameraWith(Projection::orthographic, focus);
    for (const double distance : {3.0, 40.0}) {
        TestScene scene;
        const double x0 = 0.4, y0 = -0.2;  // of its middle, in the picture
        scene.add("ball", gr::SphereNode{eye + distance * forward + x0 * right + y0 * upward, radius}, core::Rgbf(1));
        const image::Film film = picture(scene, camera, width, height);
        int met = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double across =
                    std::hypot(pixel * (x + 0.5 - width / 2) - x0, pixel * (height / 2 - y - 0.5) - y0);
                if (std::abs(across - radius) < 1e-4) continue;
                ASSERT_EQ(isMet(film, x, y), across < radius) << x << " " << y;
                if (across > radius) continue;
                ++met;
                const double depth = distance - std::sqrt(radius * radius - across * across);
                ASSERT_NEAR(numberAt(film, image::Layer::depth, x, y), depth,
                            4e-5 * distance / std::sqrt(1 - across / radius));
            }
        }
        EXPECT_NEAR(met * pixel * pixel, pi * radius * radius, 0.02 * pi * radius * radius);
    }
}

// What is behind the plane of the rays is not seen.
TEST_P(ProjectedPicture, OrthographicBeginsAtTheEye) {
    TestScene scene;
    scene.add("behind", gr::SphereNode{eye - 2.0 * forward, 1}, core::Rgbf(1));
    const image::Film film = picture(scene, cameraWith(Projection::orthographic, 5), width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_FALSE(isMet(film, x, y));
}

// The balls fill cones of sin a = radius / distance, wherever they are: 2 pi (1 - cos a) of all directions.
TEST_P(ProjectedPicture, PanoramaShowsBallsAllRound) {
    const int columns = 160, lines = 80;
    const Camera camera = cameraWith(Projection::panorama, 1, columns, lines);
    for (const glm::dvec3& way :
         {forward, -forward, right, upward, -upward, glm::normalize(upward - right - forward)}) {
        TestScene scene;
        scene.add("ball", gr::SphereNode{eye + 4.0 * way, 2}, core::Rgbf(1));
        const image::Film film = picture(scene, camera, columns, lines);
        const double cosine = std::sqrt(1 - 0.25);
        double seen = 0;
        for (int y = 0; y < lines; ++y) {
            const double latitude = pi * (0.5 - (y + 0.5) / lines);
            for (int x = 0; x < columns; ++x) {
                const glm::dvec3 direction(camera.ray(Vec2f(x + 0.5f, y + 0.5f)).direction);
                const double along = glm::dot(direction, way);
                if (std::abs(along - cosine) < 1e-5) continue;
                ASSERT_EQ(isMet(film, x, y), along > cosine) << x << " " << y;
                if (along < cosine) continue;
                seen += std::cos(latitude) * (2 * pi / columns) * (pi / lines);
                const double t = 4 * along - std::sqrt(4 - 16 * (1 - along * along));
                ASSERT_NEAR(numberAt(film, image::Layer::depth, x, y), t, 1e-4);
            }
        }
        // Round a pole whole lines are met or not: half of the one at the edge, 30 degrees from the pole, may be wrong.
        EXPECT_NEAR(seen, 2 * pi * (1 - cosine), 0.5 * 2 * pi * std::sin(pi / 6) * (pi / lines));
    }
}

// The depth all round is the distance, not that along the view, which is below 0 behind.
TEST_P(ProjectedPicture, PanoramaHasTheDistanceForItsDepth) {
    TestScene scene;
    scene.add("room", gr::SphereNode{eye, 3}, core::Rgbf(0.5f));
    const image::Film film = picture(scene, cameraWith(Projection::panorama), width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_NEAR(numberAt(film, image::Layer::depth, x, y), 3, 1e-5);
}

// What the places of an orthographic picture are inside of, one by one.
TEST(Orthographic, KnowsWhatEachPlaceIsInsideOf) {
    gr::Database database;
    const auto add = [&](const std::string& name, const gr::NodeContent& content, const materials::Dielectric& glass) {
        database.create(":", name, content);
        database.addMaterial(name, glass);
        database.setMaterial(":" + name, name);
    };
    add("ball", gr::SphereNode{eye + 0.8 * right, 1}, {.index = 1.5});
    add("other", gr::SphereNode{eye - 1.1 * right + 0.4 * upward, 0.9}, {.index = 1.3});
    add("inner", gr::SphereNode{eye + 0.9 * right, 0.5}, {.index = 2});
    add("block", gr::BoxNode{eye - glm::dvec3(2.5, 2.5, 0.2), {1.4, 1.4, 2}}, {.index = 1.7});
    const gr::Scene scene = gr::compile(database, ":", {});
    const Camera camera = cameraWith(Projection::orthographic, 5);
    const EyeMedia media(scene, camera.starts());
    std::array<int, 5> seen{};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const core::Vec3f place = camera.ray(Vec2f(x + 0.5f, y + 0.5f)).origin;
            EXPECT_TRUE(camera.starts().box.intersection({place, place}).size() == core::Vec3f(0));
            const float index = media.at(place).index();
            ASSERT_EQ(index, mediaAt(place, scene).index()) << x << " " << y;
            ++seen[index == 1 ? 0 : index == 1.5f ? 1 : index == 1.3f ? 2 : index == 2 ? 3 : 4];
        }
    }
    for (const int count : seen) EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace render
