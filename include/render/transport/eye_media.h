// What the eye is inside of, and each place round it where the camera's rays start.
#pragma once

#include "gr/near_solid.h"
#include "render/transport/camera.h"
#include "render/transport/media.h"

namespace render {

class EyeMedia {
public:
    EyeMedia() = default;  // air all over
    // The scene must outlive this.
    EyeMedia(const gr::Scene& scene, const RayStarts& starts);

    // What a place is inside of where rays start; one elsewhere is looked at anew.
    Media at(const core::Vec3f& place) const;

private:
    struct Near {
        gr::NearSolid solid;
        const materials::Interior* interior;
    };

    const gr::Scene* scene_ = nullptr;
    RayStarts starts_{core::Vec3f(0)};
    Media media_;  // at the eye
    std::vector<Near> near_;  // what may lie between the eye and such a place
};

}  // namespace render
