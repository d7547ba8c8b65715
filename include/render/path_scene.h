// A scene made ready for the path integrator: what its lanes test by themselves, and how they ask for the rest.
#pragma once

#include "render/face_list.h"
#include "render/light_tree.h"

#include <cstddef>

namespace render {

inline constexpr int mostLanes = 16;

// Rays and surfaces of up to mostLanes paths, a column for each number: how lanes talk to what goes one by one.
struct RayColumns {
    float origin[3][mostLanes], direction[3][mostLanes], tMax[mostLanes];
};
struct SurfaceColumns {
    float t[mostLanes];  // infinity: nothing was met, and the rest means nothing
    float position[3][mostLanes], normal[3][mostLanes], shadingNormal[3][mostLanes], tangent[3][mostLanes];
    float error[mostLanes], isSmooth[mostLanes], material[mostLanes], light[mostLanes];
};

struct PathScene {
    PathScene(const gr::Scene& scene, const gr::Accelerator& accelerator);

    const gr::Scene& scene;
    const gr::Accelerator& accelerator;
    bool hasInteriors = false;  // materials that paths go through
    bool hasAnisotropy = false;
    bool hasNormals = false;  // meshes shaded with normals of their own
    LightTree lights;

    // Where every object is tested lanes do it by themselves, and here the objects are; else the accelerator is asked.
    bool isInLanes = false;
    FaceList faces;
    std::vector<const gr::Instance*> spheres, boxes;
    std::size_t bytes() const;
    std::size_t objectCount() const { return faces.size() + spheres.size() + boxes.size(); }

    // The surfaces that rays meet first, for the lanes whose bits are set.
    void nearest(const RayColumns& rays, std::uint32_t lanes, SurfaceColumns& surfaces,
                 gr::TraversalCounts& counts) const;
    // The lanes whose rays meet anything.
    std::uint32_t occluded(const RayColumns& rays, std::uint32_t lanes, gr::TraversalCounts& counts) const;
};

}  // namespace render
