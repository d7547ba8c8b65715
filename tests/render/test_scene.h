// Scenes that tests build by hand, and the light that is measured in them.
#pragma once

#include "gr/database/database.h"
#include "gr/scene.h"
#include "render/transport/integrator.h"
#include "support/statistics.h"

namespace render {

using RgbMean = std::array<support::RunningMean, 3>;

// Objects stand below the root and are found as ":name".
struct TestScene {
    gr::Database database;
    RenderSettings settings;
    core::Rgbf ambient{0};
    std::vector<std::string> pointLights;  // and all others that have names
    gr::Sky aroundIt;

    void add(const std::string& name, const gr::NodeContent& content, const materials::Material& material) {
        database.create(":", name, content);
        database.addMaterial(name, material);
        database.setMaterial(":" + name, name);
    }
    // The material is diffuse.
    void add(const std::string& name, const gr::NodeContent& content, const core::Rgbf& reflectance) {
        add(name, content, materials::Diffuse{reflectance});
    }
    // Its normal is on the side from which the outline goes round counterclockwise.
    void addPolygon(const std::string& name, const std::vector<glm::dvec3>& outline,
                    const materials::Material& material) {
        std::vector<int> face;
        for (std::size_t i = 0; i < outline.size(); ++i) face.push_back(static_cast<int>(i));
        gr::MeshRepairs repairs;
        add(name, gr::PolyhedronNode{gr::Polyhedron::make({outline, {face}}, repairs)}, material);
    }
    void addPolygon(const std::string& name, const std::vector<glm::dvec3>& outline, const core::Rgbf& reflectance) {
        addPolygon(name, outline, materials::Diffuse{reflectance});
    }
    void addAreaLight(const std::string& name, const core::Rgbf& radiance, const glm::dvec3& centre, double size) {
        database.create(":", name, gr::AreaLightNode{radiance, centre, size});
    }
    void addPointLight(const std::string& name, const gr::PointLight& light) { addLight(name, light); }
    void addLight(const std::string& name, const gr::NamedLight& light) {
        database.addLight(name, light);
        pointLights.push_back(name);
    }
};

inline core::Rayf rayTowards(const glm::dvec3& from, const glm::dvec3& to) {
    return {core::Vec3f(from), core::Vec3f(glm::normalize(to - from))};
}

// A scene made ready to be measured. Later changes of the TestScene do not reach it.
class Radiometer {
public:
    // Which integrator sample() and measure() ask: "report" or "path". Tests of both say so (each_integrator.h).
    static inline core::Word measuresWith = "report";

    // eye: only where there are dielectrics does it matter. Rays from elsewhere are right too, and slower.
    explicit Radiometer(const TestScene& scene, const glm::dvec3& eye = {0, 0, 0})
        : scene_(gr::compile(scene.database, ":", scene.pointLights, gr::Origin::isTheWorlds, scene.aroundIt)),
          accelerator_(gr::makeNoAccelerator(scene_)),
          integrator_(makeReportIntegrator(scene_, *accelerator_, scene.settings, scene.ambient,
                                           startsOf(scene.settings, core::Vec3f(eye)))),
          path_(makePathIntegrator(scene_, *accelerator_, scene.settings, scene.ambient,
                                   startsOf(scene.settings, core::Vec3f(eye)))) {}
    Radiometer(const Radiometer&) = delete;
    Radiometer& operator=(const Radiometer&) = delete;

    const ScalarIntegrator& integrator() const { return *integrator_; }
    const Integrator& pathIntegrator() const { return *path_; }
    const Integrator& measuringIntegrator() const { return measuresWith == "path" ? *path_ : *integrator_; }

    // One path.
    core::Rgbf sample(const core::Rayf& ray, std::uint64_t seed, int number) const {
        return samples(ray, seed, number, 1)[0];
    }
    // Paths know nothing of each other, with either integrator.
    RgbMean measure(const core::Rayf& ray, int count, std::uint64_t seed) const {
        constexpr int most = 4096;
        RgbMean mean;
        for (int first = 0; first < count; first += most)
            for (const core::Rgbf& radiance : samples(ray, seed, first, std::min(most, count - first)))
                for (int channel = 0; channel < 3; ++channel)
                    mean[static_cast<std::size_t>(channel)].add(radiance[channel]);
        return mean;
    }

private:
    // All over a lens round the eye, in whatever direction it looks.
    static RayStarts startsOf(const RenderSettings& settings, const core::Vec3f& eye) {
        if (!settings.depthOfField) return eye;
        return {eye, core::Bounds{eye, eye}.widened(static_cast<float>(settings.aperture))};
    }

    std::vector<core::Rgbf> samples(const core::Rayf& ray, std::uint64_t seed, int first, int count) const {
        Samples samples;
        samples.radiance.resize(static_cast<std::size_t>(count));
        if (measuresWith == "path") {
            // A pixel's samples are spread evenly, so that each is the only one of its pixel here; and the view is so
            // narrow that all pixels look along the ray.
            const glm::dvec3 view(ray.direction);
            const glm::dvec3 up = std::abs(view.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
            const Camera camera(glm::dvec3(ray.origin), view, up, 1e-18, 1, 1);
            const std::atomic<bool> stop = false;
            path_->render({camera, false, seed, 1}, {first, 0, first + count, 1, 0, 1}, samples, stop);
            return std::move(samples.radiance);
        }
        for (core::Rgbf& radiance : samples.radiance) {
            Sampler sampler(seed, 0, 0, first++);
            radiance = integrator_->radiance(ray, sampler, samples.rays);
        }
        return std::move(samples.radiance);
    }

    gr::Scene scene_;
    std::unique_ptr<gr::Accelerator> accelerator_;
    std::unique_ptr<ScalarIntegrator> integrator_;
    std::unique_ptr<Integrator> path_;
};

}  // namespace render
