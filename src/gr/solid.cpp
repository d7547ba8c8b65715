#include "gr/solid.h"

namespace gr {
namespace {

core::Ray<double> reversed(const Line& line) {
    return {line.at(line.end), -line.direction, line.end};
}

// At the end of a line: at its place there, or where it is that it goes to without one.
template<class Solid>
bool holdsEnd(const Solid& solid, const Line& line) {
    if (line.end < std::numeric_limits<double>::infinity()) return solid.template level<double>(line.at(line.end)) < 0;
    if (!Solid::isEndless) return false;
    const double gain = solid.template level<double>(line.direction) - solid.template level<double>(glm::dvec3(0));
    return gain != 0 ? gain < 0 : solid.template level<double>(line.origin) < 0;
}

// A solid is crossed where just one end of the line is in it: where the line first leaves it, or last enters it.
template<class Solid>
void addSolid(const Solid& solid, const Line& line, std::vector<SolidCrossing>& crossings) {
    const bool isBefore = solid.template level<double>(line.origin) < 0, isAfter = holdsEnd(solid, line);
    if (isBefore == isAfter) return;
    const bool looksBack = isAfter && line.end < std::numeric_limits<double>::infinity();
    const double way = solid.template intersect<double>(
        looksBack ? reversed(line) : core::Ray<double>{line.origin, line.direction, line.end});
    // Rounding may see it beyond the other end.
    const double t = looksBack ? line.end - way : way;
    crossings.push_back({std::clamp(t, 0., line.end), isAfter});
}

// Of each shape of the list its solid.
struct Crossings {
    template<class S>
    void operator()(const S& shape) const {
        if constexpr (S::isSolid) addSolid(shape, line, found);
    }
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
