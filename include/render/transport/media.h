// What a path goes through: air, or the materials that it is inside of.
#pragma once

#include "gr/scene.h"

#include <vector>

namespace render {

// Solids may overlap and lie in one another: the one entered last counts. An interior is told from others by its
// address and must outlive this.
class Media {
public:
    // The index of refraction here; air's is 1.
    float index() const { return inside_.empty() ? 1.f : inside_.back()->index; }
    // And beyond the surface of that interior. enters: whether the way goes against its outward normal.
    float indexBeyond(const materials::Interior& interior, bool enters) const;

    void cross(const materials::Interior& interior, bool enters);
    // A surface met from behind says what the way to it went through, also where its shape is open and no way in was
    // seen.
    void meetFromInside(const materials::Interior& interior);

    // Beer's law: what is left of light after a way of this length.
    core::Rgbf transmittance(float length) const {
        return inside_.empty() ? core::Rgbf(1) : inside_.back()->transmittance(length);
    }

    // Per unit length.
    core::Rgbf absorption() const { return inside_.empty() ? core::Rgbf(0) : inside_.back()->absorption; }

private:
    std::vector<const materials::Interior*> inside_;  // in the order in which they were entered
};

// What a point is inside of.
Media mediaAt(const core::Vec3f& point, const gr::Scene& scene);

}  // namespace render
