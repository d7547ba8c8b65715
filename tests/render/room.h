// A room in which path and report are compared, and what may stand in it.
#pragma once

#include "render/same_light.h"

#include "gr/sky_pictures.h"
#include "materials/material.h"

#include <cmath>
#include <memory>
#include <string>

namespace render {

inline std::shared_ptr<const gr::Polyhedron> smoothBall() {
    gr::FlatMesh mesh(gr::icosphereMesh(0));
    for (const int corner : mesh.corners) mesh.normals.push_back(gr::packNormal(core::Vec3f(mesh.vertices[corner])));
    gr::MeshRepairs repairs;
    return gr::Polyhedron::make(std::move(mesh), repairs);
}

// A room with a large lamp: paths that go by chance find it, too.
struct Room : SameLight {
    Room() {
        scene.add("room", gr::BoxNode{{-2, -2, -2}, {4, 4, 4}}, core::Rgbf(0.7f, 0.6f, 0.5f));
        scene.addAreaLight("lamp", core::Rgbf(4, 3, 2), {0.3, 1.9, 0.2}, 2);
        scene.settings.globalIllumination = true;
        scene.settings.antialiasing = true;
        scene.settings.pathLength = 4;
    }
    // A ball in the air and a turned box, of the same stuff.
    void addBodies(const materials::Material& material) {
        scene.add("ball", gr::SphereNode{{-0.7, -0.4, -0.3}, 0.8}, material);
        scene.add("block", gr::BoxNode{{0.3, -1.9, -0.5}, {0.9, 1.6, 0.9}}, core::Rgbf(0.5f));
        scene.database.setMaterial(":block", "ball");
        scene.database.rotate(":block", 1, 25);
    }
    // Lamps shine down before they are turned.
    void addLamp(const std::string& name, const core::Rgbf& radiance, const glm::dvec3& centre, double size, int axis,
                 double degrees) {
        scene.addAreaLight(name, radiance, {0, 0, 0}, size);
        scene.database.translate(":" + name, centre);
        scene.database.rotate(":" + name, axis, degrees);
    }
    // More than are each asked: bright and dim, to all sides.
    void addLampsAllAround() {
        for (int i = 0; i < 9; ++i) {
            const double turn = 0.7 * i;
            addLamp("around" + std::to_string(i), core::Rgbf(0.3f * static_cast<float>(1 + i), 2, 1),
                    {1.5 * std::sin(turn), 0.2 * i - 1, 1.5 * std::cos(turn)}, 0.3 + 0.15 * i, i % 3, 40. * i);
        }
    }
    // Point lights that fade in every way, bright and dim; one of them nearly on the floor.
    void addPointsAllAround() {
        constexpr core::Vec3f falloffs[] = {{0, 0, 1}, {1, 0, 0}, {0.3f, 0.2f, 0.5f}, {0, 1, 0}};
        for (int i = 0; i < 11; ++i) {
            const float turn = 1.1f * static_cast<float>(i);
            scene.addPointLight(
                "point" + std::to_string(i),
                {{1.6f * std::sin(turn), i == 3 ? -1.95f : 0.3f * static_cast<float>(i) - 1.4f, 1.6f * std::cos(turn)},
                 core::Rgbf(0.05f * static_cast<float>(1 + i % 4), 0.1f, 0.15f),
                 falloffs[i % 4]});
        }
    }
    void addSmoothBall(const core::Rgbf& reflectance, const glm::dvec3& centre) {
        scene.add("smooth", gr::PolyhedronNode{smoothBall()}, reflectance);
        scene.database.translate(":smooth", centre);
        scene.database.scale(":smooth", glm::dvec3(0), {0.9, 1, 0.9});
    }
    // No room, but a floor, under a sky that has a bright place.
    void openToSky() {
        scene.database.remove(":room");
        scene.database.remove(":lamp");
        scene.add("floor", gr::BoxNode{{-9, -2.1, -9}, {18, 0.1, 18}}, core::Rgbf(0.6f));
        const auto radiance = [](double u, double v) {
            const bool isBright = std::abs(u - 0.7) < 0.1 && std::abs(v - 0.3) < 0.1;
            return core::Rgbf(isBright ? 4 : 0.4, 0.5, 0.9 - 0.5 * v);
        };
        scene.aroundIt = {std::make_shared<gr::SkyGrid>(gr::skyOf(20, 10, radiance)), 30};
    }
    // Glass, metal and plaster; a mesh, too.
    void addAll() {
        scene.add("glass", gr::SphereNode{{-0.9, -0.9, 0.4}, 0.6},
                  materials::Dielectric{.absorption = {0.3f, 0.1f, 0.8f}});
        scene.add("metal", gr::SphereNode{{0.8, -0.2, -0.7}, 0.7},
                  materials::Shirley{
                      .diffuse = core::Rgbf(0.2f), .specular = core::Rgbf(0.8f, 0.6f, 0.2f), .exponents = {20, 80}});
        scene.add("block", gr::BoxNode{{-0.2, -2, -0.6}, {0.8, 0.9, 0.8}}, core::Rgbf(0.4f, 0.7f, 0.4f));
        scene.add("stone", gr::polyhedronNode(gr::icosphereMesh(0)), core::Rgbf(0.8f, 0.3f, 0.3f));
        scene.database.translate(":stone", {1.2, -1.5, 0.6});
        scene.database.scale(":stone", glm::dvec3(0), {0.5, 0.4, 0.5});
    }
};

}  // namespace render
