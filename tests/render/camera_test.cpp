// Where the pixels are.
// Seen to fail with a picture that is mirrored or upside down, a field of view taken horizontally, and pixels shifted
// by a half.
#include "render/transport/camera.h"

#include "core/lanes.h"
#include "render/render.h"
#include "render/test_scene.h"

#include <gmock/gmock.h>

namespace render {
namespace {

using core::Vec2f;

void expectDirection(const Camera& camera, const Vec2f& place, const glm::dvec3& towards) {
    const core::Vec3f direction = camera.ray(place).direction;
    const double off = glm::length(glm::dvec3(direction) - glm::normalize(towards));
    EXPECT_LT(off, 3e-7) << "at " << place.x << " " << place.y << ": " << direction.x << " " << direction.y << " "
                         << direction.z;
}

// At 90 degrees the picture's upper and lower edge are as far off the middle as the middle is away.
TEST(Camera, SpansItsFieldOfViewFromTopToBottom) {
    const Camera camera({1, 2, 3}, {0, 0, -1}, {0, 1, 0}, 90, 6, 4);
    EXPECT_EQ(camera.ray(Vec2f(0)).origin, core::Vec3f(1, 2, 3));
    EXPECT_EQ(camera.ray(Vec2f(0)).tMax, core::infinity);
    expectDirection(camera, {3, 2}, {0, 0, -1});
    expectDirection(camera, {3, 0}, {0, 1, -1});
    expectDirection(camera, {3, 4}, {0, -1, -1});
}

// Pixels are square: the width follows from the height.
TEST(Camera, HasSquarePixels) {
    const Camera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90, 6, 4);
    expectDirection(camera, {0, 0}, {-1.5, 1, -1});
    expectDirection(camera, {6, 0}, {1.5, 1, -1});
    expectDirection(camera, {6, 4}, {1.5, -1, -1});
    expectDirection(camera, {0.5, 0.5}, {-1.25, 0.75, -1});  // the middle of the first pixel
    expectDirection(camera, {4.5, 1.5}, {0.75, 0.25, -1});
    const Camera tall({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60, 10, 1000);
    const double half = std::tan(glm::radians(30.0));
    expectDirection(tall, {5, 0}, {0, half, -1});
    expectDirection(tall, {10, 500}, {half / 100, 0, -1});
}

// Right is forward x up: who looks along +z with y up has +x on the left.
TEST(Camera, HasItsRightWhereForwardCrossUpPoints) {
    expectDirection(Camera({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90, 2, 2), {2, 1}, {-1, 0, 1});
    expectDirection(Camera({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 90, 2, 2), {2, 1}, {1, -1, 0});
    expectDirection(Camera({0, 0, 0}, {0, -1, 0}, {0, 0, 1}, 90, 2, 2), {1, 0}, {0, -1, 1});
}

TEST(Camera, TakesViewAndUpOfAnyLengthAndSlant) {
    const glm::dvec3 view = glm::normalize(glm::dvec3(1, 2, -3));
    const glm::dvec3 right = glm::normalize(glm::cross(view, glm::dvec3(0.2, 1, 0.1)));
    const glm::dvec3 up = glm::cross(right, view);
    for (const double length : {1e-12, 1.0, 1e12}) {
        const Camera camera({0, 0, 0}, view * length, glm::dvec3(0.2, 1, 0.1) / length, 50, 300, 200);
        const double pixel = 2 * std::tan(glm::radians(25.0)) / 200;
        for (const Vec2f& place : {Vec2f(150, 100), Vec2f(0, 0), Vec2f(300, 0), Vec2f(17.25f, 181.5f)})
            expectDirection(camera, place, view + right * ((place.x - 150) * pixel) + up * ((100 - place.y) * pixel));
    }
}

TEST(Camera, HoldsForEveryFieldOfView) {
    for (const double degrees : {1e-3, 1.0, 90.0, 179.0}) {
        const double half = std::tan(glm::radians(degrees / 2));
        const Camera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, degrees, 100, 100);
        expectDirection(camera, {50, 0}, {0, half, -1});
        expectDirection(camera, {100, 50}, {half, 0, -1});
    }
}

TEST(Camera, GivesUnitDirections) {
    const Camera camera({0, 0, 0}, {0.3, -0.5, 1}, {0, 1, 0}, 120, 640, 480);
    for (int x = 0; x <= 640; x += 80)
        for (int y = 0; y <= 480; y += 80) EXPECT_NEAR(glm::length(camera.ray(Vec2f(x, y)).direction), 1, 2e-7);
}

TEST(Camera, IsTheSameInLanes) {
    using core::Lanes;
    const Camera camera({1, 2, 3}, {0.3, -0.5, 1}, {0, 1, 0}, 70, 640, 480);
    for (const Vec2f& place : {Vec2f(0.5f), Vec2f(320, 17), Vec2f(639.5f, 479.5f)}) {
        const core::Rayf one = camera.ray(place);
        const core::Ray<Lanes> many = camera.ray(core::Vec2<Lanes>(Lanes(place.x), Lanes(place.y)));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(many.origin[axis].get(0), one.origin[axis]);
            EXPECT_NEAR(many.direction[axis].get(0), one.direction[axis], 1e-7);
        }
    }
}

// The picture that the camera, the film and the loop over pixels make together.
class Silhouette : public testing::Test {
protected:
    // With one sample through each pixel's centre, a line of text for each line of pixels: # where there is light.
    std::vector<std::string> picture(const Camera& camera, int width, int height) {
        image::Film film(width, height, 0, height);
        Progress progress;
        const std::atomic<bool> stop = false;
        scene.settings.samplesPerPixel = 1;
        const Radiometer radiometer(scene);
        render(radiometer.integrator(), camera, scene.settings, film, progress, stop);
        std::vector<std::string> lines;
        for (int y = 0; y < height; ++y) {
            lines.emplace_back();
            for (int x = 0; x < width; ++x) lines.back() += film.at(x, y) == core::Rgbf(0) ? '.' : '#';
        }
        return lines;
    }

    TestScene scene;
};

// A lamp of 3 x 2 pixels to the right and above the middle: each of its edges lies 0.4 of a pixel beyond the outermost
// centres that it covers.
TEST_F(Silhouette, OfALampIsInThePixelsItFills) {
    // Half the picture's height is 4 at distance 4, so that a pixel is 1 there.
    const Camera camera({0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 90, 10, 8);
    scene.addAreaLight("lamp", core::Rgbf(1), {0, 0, 0}, 1);
    scene.database.translate(":lamp", {2.5, 2, 0});
    scene.database.rotate(":lamp", 0, -90);  // it shines along +z
    scene.database.scale(":lamp", {0, 0, 0}, {2.8, 1, 1.8});
    EXPECT_THAT(picture(camera, 10, 8), testing::ElementsAre("..........",  //
                                                             "......###.",  //
                                                             "......###.",  //
                                                             "..........",  //
                                                             "..........",  //
                                                             "..........",  //
                                                             "..........",  //
                                                             ".........."));
}

// A ball is seen within the cone that touches it, whose sine is radius / distance.
TEST_F(Silhouette, OfABallIsTheConeThatTouchesIt) {
    const int width = 60, height = 40;
    const glm::dvec3 eye(1, -2, 3), ball(-3, 1, -7);
    const glm::dvec3 view(-0.4, 0.1, -1), up(0.1, 1, 0);
    scene.add("ball", gr::SphereNode{ball, 2}, core::Rgbf(1));
    scene.ambient = core::Rgbf(1);
    const std::vector<std::string> lines = picture(Camera(eye, view, up, 40, width, height), width, height);

    const glm::dvec3 forward = glm::normalize(view), right = glm::normalize(glm::cross(forward, up));
    const double pixel = 2 * std::tan(glm::radians(20.0)) / height;
    const glm::dvec3 toBall = glm::normalize(ball - eye);
    const double cosine = std::sqrt(1 - std::pow(2 / glm::distance(ball, eye), 2));
    int seen = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 through = forward + right * ((x + 0.5 - width / 2.0) * pixel) +
                                       glm::cross(right, forward) * ((height / 2.0 - y - 0.5) * pixel);
            const bool isSeen = glm::dot(glm::normalize(through), toBall) > cosine;
            seen += isSeen ? 1 : 0;
            ASSERT_EQ(lines[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)], isSeen ? '#' : '.')
                << "pixel " << x << " " << y;
        }
    }
    EXPECT_GT(seen, 200);
}

}  // namespace
}  // namespace render
