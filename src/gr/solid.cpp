#include "gr/solid.h"

namespace gr {
namespace {

bool holds(const Sphere&, const glm::dvec3& p) {
    return glm::dot(p, p) < 1;
}

bool holds(const Box&, const glm::dvec3& p) {
    return p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1 && p.z > 0 && p.z < 1;
}

// The t at which a line from within leaves.
double exitOf(const Sphere&, const glm::dvec3& from, const glm::dvec3& direction) {
    const double a = glm::dot(direction, direction), b = -glm::dot(from, direction);
    const glm::dvec3 nearest = from + direction * (b / a);
    const double root = std::sqrt(a * std::max(1 - glm::dot(nearest, nearest), 0.));
    // Both roots without cancellation, as Sphere::intersect has them.
    const double q = b + std::copysign(root, b);
    return std::max(q / a, q == 0 ? 0 : (glm::dot(from, from) - 1) / q);
}

double exitOf(const Box&, const glm::dvec3& from, const glm::dvec3& direction) {
    double exit = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0) exit = std::min(exit, ((direction[axis] > 0 ? 1 : 0) - from[axis]) / direction[axis]);
    return exit;
}

// A convex solid is crossed where just one end of the line is in it.
template<class Convex>
void addConvex(const Convex& solid, const Line& line, std::vector<SolidCrossing>& crossings) {
    const bool isEndless = line.end == std::numeric_limits<double>::infinity();
    const bool isBefore = holds(solid, line.origin), isAfter = !isEndless && holds(solid, line.at(line.end));
    if (isBefore == isAfter) return;
    const double t = isBefore ? exitOf(solid, line.origin, line.direction)
                              : line.end - exitOf(solid, line.at(line.end), -line.direction);
    crossings.push_back({std::clamp(t, 0., line.end), isAfter});
}

// Of each shape of the list its solid.
struct Crossings {
    void operator()(const Sphere& sphere) const { addConvex(sphere, line, found); }
    void operator()(const Box& box) const { addConvex(box, line, found); }
    void operator()(const Square&) const {}
    void operator()(const Polyhedron* mesh) const {
        if (!line.mayMeet(mesh->bounds())) return;
        const MeshLine meshLine(line);
        const auto count = static_cast<std::uint32_t>(mesh->triangleCount());
        for (std::uint32_t triangle = 0; triangle < count; ++triangle) meshLine.addCrossing(*mesh, triangle, found);
    }

    const Line line;
    std::vector<SolidCrossing>& found;
};

}  // namespace

void addCrossings(const Instance& instance, const core::Rayf& ray, std::vector<SolidCrossing>& crossings) {
    const Line line(instance.place.toObject(ray));
    if (line.goesAnywhere()) std::visit(Crossings{line, crossings}, instance.shape);
}

}  // namespace gr
