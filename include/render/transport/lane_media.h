// What the paths go through, each lane's by itself.
#pragma once

#include "core/elementary.h"
#include "core/lanes.h"
#include "core/vec.h"
#include "render/transport/media.h"
#include "render/transport/path_scene.h"

#include <array>
#include <cstdint>

namespace render {

template<class Real>
class LaneMedia {
public:
    // Beer's law: what is left of light after a way of these lengths.
    core::Rgb<Real> transmittance(const Real& length) const {
        const auto left = [&](const Real& a) {
            const core::Mask<Real> absorbs = a > Real(0);
            return core::select(absorbs, core::exp<Real>(core::select(absorbs, -a * length, Real(0))), Real(1));
        };
        return {left(absorption_.x), left(absorption_.y), left(absorption_.z)};
    }

    // What a lane's path is inside of, to be changed. Call update() after the last change.
    Media& change(int lane) {
        changed_ |= 1u << lane;
        return media_[lane];
    }
    const Media& at(int lane) const { return media_[lane]; }
    // Makes transmittance() tell of what has been changed.
    void update() {
        if (changed_ == 0) return;
        core::LaneArray<Real> x(absorption_.x), y(absorption_.y), z(absorption_.z);
        core::forEachLane(changed_, [&](int lane) {
            const core::Rgbf a = media_[lane].absorption();
            x[lane] = a.x;
            y[lane] = a.y;
            z[lane] = a.z;
        });
        absorption_ = {x.real(), y.real(), z.real()};
        changed_ = 0;
    }

private:
    std::array<Media, mostLanes> media_;
    core::Rgb<Real> absorption_{Real(0)};  // per unit length
    std::uint32_t changed_ = 0;  // a bit for each lane
};

}  // namespace render
