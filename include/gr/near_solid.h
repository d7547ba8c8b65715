// An instance's solid near some place, for many rays there: of a mesh only the triangles are kept that reach into it,
// in a tree of boxes.
#pragma once

#include "gr/solid.h"

namespace gr {

class NearSolid {
public:
    // near: where all the rays are.
    NearSolid(const Scene& scene, const Instance& instance, const core::Bounds& near);

    // Whether none of them can cross the solid.
    bool isBeyond() const { return isBeyond_; }
    // As gr::addCrossings does it.
    void addCrossings(const core::Rayf& ray, std::vector<SolidCrossing>& crossings) const;

private:
    // A box; those that it is cut into follow it, up to `next`.
    struct Node {
        core::Bounds bounds;
        std::uint32_t next;
        std::uint32_t begin, end;  // the triangles in it, if it is not cut
    };
    struct Triangle {
        core::Bounds bounds;
        std::uint32_t number;
    };
    void addNodes(std::vector<Triangle>& triangles, std::size_t begin, std::size_t end);

    const Scene* scene_;
    const Instance* instance_;
    const Polyhedron* mesh_ = nullptr;  // or null
    std::vector<std::uint32_t> triangles_;
    std::vector<Node> nodes_;
    bool isBeyond_;
};

}  // namespace gr
