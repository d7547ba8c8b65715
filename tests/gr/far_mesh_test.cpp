// A ray that passes a small mesh at a distance does not meet it. Seen to fail, without the exact areas of triangles,
// for the linear search: it has no boxes round triangles that would hide it.
#include "gr/accelerator_checks.h"
#include "gr/uv_sphere_mesh.h"

namespace gr {
namespace {

TEST(FarMeshTest, IsMissedFromAfar) {
    Database database;
    database.create(":", "mesh", polyhedronNode(uvSphereMesh(64, 128)));
    const Scene scene = compile(database, ":", {});
    const std::unique_ptr<Accelerator> off = makeNoAccelerator(scene);
    support::TestRandom random(1);
    Violations met;
    for (int i = 0; i < rayCount(2000); ++i) {
        const glm::dvec3 from = 5000. * randomDirection(random), direction = randomDirection(random);
        const core::Rayf ray{core::Vec3f(from), core::Vec3f(direction)};
        // Twice as far from the mesh's centre as its surface is.
        if (glm::length(glm::cross(from, direction)) < 2) continue;
        if (const auto hit = off->intersect(ray)) met.add("t ", hit->t, ", ", text(ray.origin), text(ray.direction));
        if (off->occluded(ray)) met.add("occluded, ", text(ray.origin), text(ray.direction));
    }
    EXPECT_EQ(met.count(), 0) << met.text();
}

}  // namespace
}  // namespace gr
