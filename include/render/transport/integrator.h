// How the light is found that a picture's samples see.
#pragma once

#include "gr/scene.h"
#include "render/settings.h"
#include "render/transport/camera.h"
#include "render/transport/sampler.h"

#include <atomic>

namespace render {

// The rays that were traced, by what for.
struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;
    std::uint64_t diffuse = 0;
    std::uint64_t reflective = 0;  // mirrored, sharply or not
    std::uint64_t refractive = 0;
    gr::TraversalCounts traversal;

    std::uint64_t total() const { return camera + shadow + diffuse + reflective + refractive; }
    RayCounts& operator+=(const RayCounts& other) {
        camera += other.camera;
        shadow += other.shadow;
        diffuse += other.diffuse;
        reflective += other.reflective;
        refractive += other.refractive;
        traversal += other.traversal;
        return *this;
    }
};

// What a camera ray met first, for the picture's layers.
struct FirstSurface {
    float distance = core::infinity;  // as Camera::depth has it; infinite where it met nothing
    core::Rgbf albedo{0};  // 0 for a light
    core::Vec3f normal{0};  // the shading normal, in the world, facing the eye

    bool isMet() const { return distance < core::infinity; }
};

// The samples `first` to `end` - 1 of each of the pixels from (left, top) to (right - 1, bottom - 1).
struct SampleBlock {
    int left, top, right, bottom;
    int first, end;

    int pixels() const { return (right - left) * (bottom - top); }
    int samplesPerPixel() const { return end - first; }
    int size() const { return pixels() * samplesPerPixel(); }
};

// Goes through a block's samples, pixel after pixel, each pixel's in their order. It counts, since to divide for each
// sample would take longer than to draw its random numbers.
struct SampleWalk {
    explicit SampleWalk(const SampleBlock& block) : block(block), x(block.left), y(block.top), sample(block.first) {}

    bool isOver() const { return place == static_cast<std::size_t>(block.size()); }
    void next() {
        ++place;
        if (++sample < block.end) return;
        sample = block.first;
        if (++x < block.right) return;
        x = block.left;
        ++y;
    }

    SampleBlock block;
    int x, y, sample;
    std::size_t place = 0;  // in Samples
};

// What a block's samples saw: pixel after pixel, line after line, each pixel's samples in their order.
struct Samples {
    std::vector<core::Rgbf> radiance;
    std::vector<FirstSurface> first;  // empty unless somebody wants it
    RayCounts rays;
};

// Where a picture's samples start.
struct View {
    Camera camera;
    bool antialiasing;  // all over the pixel, or through its centre
    std::uint64_t seed;
    int samplesPerPixel;  // what an even spread over the pixel counts on; 1 where nobody knows how many there will be
};

class Integrator {
public:
    virtual ~Integrator() = default;

    // Fills samples.radiance, and samples.first where it is not empty; both have the block's size. A sample depends on
    // seed, pixel and its number alone. Returns early once stop is true; what is missing is then left as it was.
    virtual void render(const View& view, const SampleBlock& block, Samples& samples,
                        const std::atomic<bool>& stop) const = 0;
    // Memory that it takes beside the scene and the accelerator.
    virtual std::size_t bytes() const { return 0; }
};

// One that follows one path at a time.
class ScalarIntegrator : public Integrator {
public:
    // One sample of the radiance that arrives at the ray's origin, against its direction. first: where the ray meets
    // something it is told here, with the distance along the ray, unless null.
    virtual core::Rgbf radiance(const core::Rayf& cameraRay, Sampler& sampler, RayCounts& rays,
                                FirstSurface* first) const = 0;
    core::Rgbf radiance(const core::Rayf& cameraRay, Sampler& sampler, RayCounts& rays) const {
        return radiance(cameraRay, sampler, rays, nullptr);
    }

    void render(const View& view, const SampleBlock& block, Samples& samples,
                const std::atomic<bool>& stop) const final;
};

// The report's own (section 5.2): plain, scalar, the oracle. Scene and accelerator must outlive it.
// ambient: times R_d, it is added where a path ends because it holds all the surface points it may.
// starts: where camera rays start; what that is inside of is found once. From elsewhere they are right, too, and
// slower.
std::unique_ptr<ScalarIntegrator> makeReportIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator,
                                                       const RenderSettings& settings, const core::Rgbf& ambient,
                                                       const RayStarts& starts);

// The same expected picture with far less noise for the time: many paths at once, in lanes. All as above.
std::unique_ptr<Integrator> makePathIntegrator(const gr::Scene& scene, const gr::Accelerator& accelerator,
                                               const RenderSettings& settings, const core::Rgbf& ambient,
                                               const RayStarts& starts);

}  // namespace render
