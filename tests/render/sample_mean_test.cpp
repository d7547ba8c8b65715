// What becomes of samples that are no numbers, of many samples, and of a render that is stopped: with integrators that
// give what the test wants.
#include "render/render.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

namespace render {
namespace {

constexpr int width = 37;
constexpr int height = 29;
const Camera camera({0, 0, 6}, {0.05, -0.1, -1}, {0, 1, 0}, 50, width, height);

struct Picture {
    image::Film film{width, height, 0, height};
    RenderResult result;

    Picture(const Integrator& integrator, const RenderSettings& settings, const std::atomic<bool>& stop = false) {
        Progress progress;
        result = render(integrator, camera, settings, film, progress, stop);
    }
};

// One channel of every seventh sample is not finite. It keeps what it gave, by direction.
class Faulty : public ScalarIntegrator {
public:
    core::Rgbf radiance(const core::Rayf& ray, Sampler& sampler, RayCounts&, FirstSurface*) const override {
        const float u = sampler.next1D();
        core::Rgbf radiance(u, 2 * u, 0.1f);
        const float faults[] = {std::nanf(""), core::infinity, -core::infinity};
        const int fault = static_cast<int>(u * 10'000) % 21;
        if (fault < 3) radiance[fault] = faults[fault];
        const std::lock_guard lock(mutex_);
        given[{ray.direction.x, ray.direction.y}].push_back(radiance);
        return radiance;
    }

    mutable std::map<std::pair<float, float>, std::vector<core::Rgbf>> given;

private:
    mutable std::mutex mutex_;
};

TEST(NonFiniteSamples, AreDroppedAndCounted) {
    RenderSettings settings;
    settings.samplesPerPixel = 9;
    const Faulty integrator;
    const Picture picture(integrator, settings);

    std::uint64_t dropped = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const core::Rayf ray = camera.ray(core::Vec2f(float(x) + 0.5f, float(y) + 0.5f));
            const std::vector<core::Rgbf>& given = integrator.given.at({ray.direction.x, ray.direction.y});
            ASSERT_EQ(given.size(), 9u);
            glm::dvec3 sum(0);
            int kept = 0;
            for (const core::Rgbf& radiance : given) {
                if (!core::isFinite(radiance)) continue;
                sum += glm::dvec3(radiance);
                ++kept;
            }
            dropped += 9 - static_cast<std::uint64_t>(kept);
            ASSERT_GT(kept, 0);
            ASSERT_EQ(picture.film.at(x, y), core::Rgbf(sum / double(kept)));
        }
    }
    EXPECT_EQ(picture.result.droppedSamples, dropped);
    EXPECT_EQ(picture.result.samples, std::uint64_t{9} * width * height);
    EXPECT_GT(dropped, 1000u);
}

class AlwaysNan : public ScalarIntegrator {
    core::Rgbf radiance(const core::Rayf&, Sampler&, RayCounts&, FirstSurface*) const override {
        return core::Rgbf(std::nanf(""));
    }
};

TEST(NonFiniteSamples, LeaveBlackWhereThereAreNoOthers) {
    const Picture picture(AlwaysNan(), RenderSettings{});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_EQ(picture.film.at(x, y), core::Rgbf(0));
    EXPECT_EQ(picture.result.droppedSamples, std::uint64_t{16} * width * height);
}

// A sum in single precision would be off by the 10,000th sample.
class Bright : public ScalarIntegrator {
    core::Rgbf radiance(const core::Rayf&, Sampler&, RayCounts&, FirstSurface*) const override {
        return core::Rgbf(0.1f, 1e30f, 0);
    }
};

TEST(Mean, IsExactForManySamples) {
    RenderSettings settings;
    settings.samplesPerPixel = 10'000;
    const Picture picture(Bright(), settings);
    EXPECT_EQ(picture.film.at(3, 4), core::Rgbf(0.1f, 1e30f, 0));
}

// Asks for a stop at its 500th sample, and counts those that begin after that.
class Stopping : public ScalarIntegrator {
public:
    core::Rgbf radiance(const core::Rayf&, Sampler&, RayCounts&, FirstSurface*) const override {
        if (stop) ++late;
        if (++samples == 500) stop = true;
        return core::Rgbf(1);
    }

    mutable std::atomic<int> samples = 0, late = 0;
    mutable std::atomic<bool> stop = false;
};

TEST(Stop, EndsTheRenderSoon) {
    for (const int threads : {1, 2, 7}) {
        RenderSettings settings;
        settings.samplesPerPixel = 20'000;
        settings.threads = threads;
        const Stopping integrator;
        const Picture picture(integrator, settings, integrator.stop);
        EXPECT_EQ(picture.result.stoppedBy, StoppedBy::interrupt);
        EXPECT_LT(integrator.late, threads) << "at most the sample that each other thread is at";
        EXPECT_LE(picture.result.samples, static_cast<std::uint64_t>(integrator.samples))
            << "a block that was broken off counts for nothing";
    }
}

TEST(Stop, BeforeTheStartRendersNothing) {
    const Stopping integrator;
    integrator.stop = true;
    const Picture picture(integrator, RenderSettings{}, integrator.stop);
    EXPECT_EQ(picture.result.stoppedBy, StoppedBy::interrupt);
    EXPECT_EQ(integrator.samples, 0);
    EXPECT_EQ(picture.result.samples, 0u);
}

}  // namespace
}  // namespace render
