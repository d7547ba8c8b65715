// Tells scenes apart that a picture's texts alone would not: after a script was changed, for instance.
#pragma once

#include "gr/scene.h"

namespace gr {

// The same for every scene with the same objects in the same places and order, the same materials and the same lights;
// for any other, in all likelihood, another one.
std::uint64_t fingerprint(const Scene& scene);
// Likewise of all that a texture is made of.
std::uint64_t fingerprint(const materials::Texture& texture);

}  // namespace gr
