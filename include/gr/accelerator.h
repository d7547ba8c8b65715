// How the object is found that a ray meets first.
#pragma once

#include "gr/shape.h"

#include <memory>
#include <optional>

namespace gr {

class Scene;

class Accelerator {
public:
    virtual ~Accelerator() = default;

    // The nearest hit with 0 < t < ray.tMax, of any side of any object.
    virtual std::optional<Hit> intersect(const core::Rayf& ray) const = 0;
    // Whether there is any.
    virtual bool occluded(const core::Rayf& ray) const = 0;
    virtual std::size_t bytes() const = 0;
};

// Tests every object. The scene must outlive what is made for it.
std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene);

}  // namespace gr
