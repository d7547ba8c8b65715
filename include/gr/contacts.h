// Where flat sides of transparent objects and others touch, or nearly.
#pragma once

#include "gr/scene.h"

#include <glm/mat4x4.hpp>

#include <span>

namespace gr {

struct Node;

inline constexpr std::uint32_t ofNoCsg = ~0u;

struct FlatObject {
    std::uint32_t instance;
    glm::dmat4 matrix;  // from its shape's own space to the scene's
    const Node* node;
    std::uint32_t csg = ofNoCsg;  // the number of the CSG object that it is an operand of
};
// Whether contacts are looked for at a shape: it has flat sides, but not as many as a mesh of a thousand triangles.
bool hasFlatSides(const Shape& shape);
inline constexpr std::size_t mostFlatObjects = 65536;

// Two sides that look at each other and are nearer than rounding may move their points. At least one is transparent.
struct Contact {
    const FlatObject *first, *second;  // the same one: its own two sides, which it is as thin as
    double gap;  // between them; 0: they touch
    double error;  // how far roundings may move them together

    std::string warning() const;  // empty where they touch: that is no fault
};

// One for each pair of objects at the most, that with the widest gap. boxes: of all instances. Of very many sides that
// may touch, by their boxes, not all are compared.
std::vector<Contact> contactsOf(const Scene& scene, std::span<const FlatObject> objects,
                                const std::vector<core::Bounds>& boxes);

}  // namespace gr
