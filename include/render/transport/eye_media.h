// What the eye is inside of, and each place on its lens.
#pragma once

#include "gr/near_solid.h"
#include "render/settings.h"
#include "render/transport/media.h"

namespace render {

class EyeMedia {
public:
    EyeMedia() = default;  // air all over
    // The lens: as the settings have it, round the eye. The scene must outlive this.
    EyeMedia(const gr::Scene& scene, const core::Vec3f& eye, const RenderSettings& settings);

    // What a place on the lens is inside of; one elsewhere is looked at anew.
    Media at(const core::Vec3f& place) const;

private:
    struct Near {
        gr::NearSolid solid;
        const materials::Interior* interior;
    };

    const gr::Scene* scene_ = nullptr;
    core::Vec3f eye_{0};
    core::Bounds lens_;
    Media media_;  // at the eye
    std::vector<Near> near_;  // what the lens may cross
};

}  // namespace render
