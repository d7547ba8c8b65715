// Where a line crosses a mesh.
#pragma once

#include "gr/mesh/edge_side.h"
#include "gr/mesh/polyhedron.h"

#include <algorithm>

namespace gr {

struct SolidCrossing {
    double t;
    bool enters;
};

// In the object's space. Double precision holds all products of its floats, so that no number is too large here, and
// the signs that decide are exact.
struct Line {
    explicit Line(const core::Rayf& ray) : origin(ray.origin), direction(ray.direction), end(ray.tMax) {}

    glm::dvec3 at(double t) const { return origin + direction * t; }
    bool goesAnywhere() const { return direction != glm::dvec3(0); }
    // Whether it may meet what is in a box, which is taken for a little larger than it is.
    bool mayMeet(const core::Bounds& box) const {
        double enter = 0, leave = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double widened = 1e-6 * (std::abs(origin[axis]) + box.reach());
            const double low = box.low[axis] - widened - origin[axis];
            const double high = box.high[axis] + widened - origin[axis];
            if (direction[axis] == 0) {
                if (low > 0 || high < 0) return false;
                continue;
            }
            const auto [first, last] = std::minmax({low / direction[axis], high / direction[axis]});
            enter = std::max(enter, first);
            leave = std::min(leave, last);
        }
        return enter <= leave;
    }

    glm::dvec3 origin, direction;
    double end;
};

// A line made ready to be tested against triangles. Space is sheared so that it becomes the last axis, as TriangleRay
// does it; but a line through an edge or a vertex must cross just one of the triangles there: see sideOfEdge.
class MeshLine {
public:
    explicit MeshLine(const Line& line)
        : axes_(core::Vec3f(line.direction)),
          origin_(axes_.permute(line.origin)),
          direction_(axes_.permute(line.direction)),
          slopeX_(direction_.x / direction_.z),
          slopeY_(direction_.y / direction_.z),
          end_(line.end) {}

    void addCrossing(const Polyhedron& mesh, std::uint32_t triangle, std::vector<SolidCrossing>& crossings) const {
        const Vertex a(*this, mesh.vertex(triangle, 0));
        const Vertex b(*this, mesh.vertex(triangle, 1));
        const Vertex c(*this, mesh.vertex(triangle, 2));
        const int side = sideOfTriangle(a.across, b.across, c.across);
        if (side == 0) return;
        const bool enters = (side > 0) != (direction_.z > 0);
        const double t = meet(a, b, c);
        // On the surface is outside.
        if (enters ? t >= 0 && t < end_ : t > 0 && t <= end_) crossings.push_back({t, enters});
    }

private:
    struct Vertex {
        glm::dvec3 place;  // permuted
        glm::dvec3 way;  // to there from the line's origin
        core::Vec2f across;  // the line

        Vertex(const MeshLine& line, const core::Vec3f& v)
            : place(line.axes_.permute(glm::dvec3(v))),
              way(place - line.origin_),
              across(static_cast<float>(way.x - line.slopeX_ * way.z),
                     static_cast<float>(way.y - line.slopeY_ * way.z)) {}
    };

    // Of the triangle's plane; where that is nearly along the line, still between the first and the last vertex.
    double meet(const Vertex& a, const Vertex& b, const Vertex& c) const {
        const glm::dvec3 normal = glm::cross(b.place - a.place, c.place - a.place);
        const double t = glm::dot(normal, a.way) / glm::dot(normal, direction_);
        const auto [first, last] =
            std::minmax({a.way.z / direction_.z, b.way.z / direction_.z, c.way.z / direction_.z});
        return t > first ? std::min(t, last) : first;
    }

    UniformAxes axes_;
    glm::dvec3 origin_, direction_;  // permuted
    double slopeX_, slopeY_;
    double end_;
};

}  // namespace gr
