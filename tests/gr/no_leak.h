// Paths that bounce about within something closed.
#pragma once

#include "gr/convex_places.h"

#include <gtest/gtest.h>

namespace gr {

// Lets paths bounce about within what `build` makes under a node, where that is and somewhere askew.
template<class Build>
void expectClosed(const glm::dvec3& inside, int rays, Build&& build) {
    for (const bool askew : {false, true}) {
        Database database;
        database.create(":", "body", TransformNode{});
        if (askew) {
            database.translate(":body", {3, -2, 5});
            database.rotate(":body", 0, 40);
            database.rotate(":body", 1, -25);
            database.scale(":body", glm::dvec3(0), {1.2, 0.3, 0.8});
            database.rotate(":body", 2, 33);
        } else {
            database.scale(":body", glm::dvec3(0), glm::dvec3(1));
        }
        build(database);
        const glm::dmat4 matrix = *database.find(":body").matrix;
        const Scene scene = compile(database, ":", {});
        const auto accelerator = makeNoAccelerator(scene);
        support::TestRandom random(7);
        Violations escaped;
        for (int i = 0; i < rays; i += 100) {
            core::Rayf ray{core::Vec3f(transformed(matrix, inside)), core::Vec3f(randomDirection(random))};
            for (int bounce = 0; bounce < 100; ++bounce) {
                const std::optional<Hit> hit = accelerator->intersect(ray);
                if (!hit) {
                    escaped.add("askew ", askew, ", bounce ", bounce);
                    break;
                }
                const SurfacePoint surface = scene.surfaceAt(ray, *hit);
                const bool front = glm::dot(ray.direction, surface.normal) < 0;
                const core::Vec3f side = front ? surface.normal : -surface.normal;
                ray = {surface.offset(side), leave(side, random)};
            }
        }
        EXPECT_EQ(escaped.count(), 0) << escaped.text();
    }
}

}  // namespace gr
