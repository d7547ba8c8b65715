// Scenes that tests build by hand, and the light that is measured in them.
#pragma once

#include "gr/database.h"
#include "gr/scene.h"
#include "render/integrator.h"
#include "support/statistics.h"

namespace render {

using RgbMean = std::array<support::RunningMean, 3>;

// Objects stand below the root and are found as ":name".
struct TestScene {
    gr::Database database;
    RenderSettings settings;
    core::Rgbf ambient{0};
    std::vector<std::string> pointLights;

    void add(const std::string& name, const gr::NodeContent& content, const materials::Material& material) {
        database.create(":", name, content);
        database.addMaterial(name, material);
        database.setMaterial(":" + name, name);
    }
    // Of what reflects diffusely.
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
    void addPointLight(const std::string& name, const gr::PointLight& light) {
        database.addPointLight(name, light);
        pointLights.push_back(name);
    }
};

inline core::Rayf rayTowards(const glm::dvec3& from, const glm::dvec3& to) {
    return {core::Vec3f(from), core::Vec3f(glm::normalize(to - from))};
}

// A scene made ready to be measured. Later changes of the TestScene do not reach it.
class Radiometer {
public:
    // eye: only where there are dielectrics does it matter. Rays from elsewhere are right too, and slower.
    explicit Radiometer(const TestScene& scene, const glm::dvec3& eye = {0, 0, 0})
        : scene_(gr::compile(scene.database, ":", scene.pointLights)),
          accelerator_(gr::makeNoAccelerator(scene_)),
          integrator_(makeReportIntegrator(scene_, *accelerator_, scene.settings, scene.ambient, core::Vec3f(eye))),
          path_(makePathIntegrator(scene_, *accelerator_, scene.settings, scene.ambient, core::Vec3f(eye))) {}
    Radiometer(const Radiometer&) = delete;
    Radiometer& operator=(const Radiometer&) = delete;

    const ScalarIntegrator& integrator() const { return *integrator_; }
    const Integrator& pathIntegrator() const { return *path_; }

    // One path.
    core::Rgbf sample(const core::Rayf& ray, std::uint64_t seed, int number) const {
        Sampler sampler(seed, 0, 0, number);
        RayCounts rays;
        return integrator_->radiance(ray, sampler, rays);
    }
    RgbMean measure(const core::Rayf& ray, int samples, std::uint64_t seed) const {
        RgbMean mean;
        for (int i = 0; i < samples; ++i) {
            const core::Rgbf radiance = sample(ray, seed, i);
            for (int channel = 0; channel < 3; ++channel) mean[channel].add(radiance[channel]);
        }
        return mean;
    }

private:
    gr::Scene scene_;
    std::unique_ptr<gr::Accelerator> accelerator_;
    std::unique_ptr<ScalarIntegrator> integrator_;
    std::unique_ptr<Integrator> path_;
};

}  // namespace render
