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
    void operator()(const Csg*) const {}  // see below
    void operator()(const Polyhedron* mesh) const {
        if (!line.mayMeet(mesh->bounds())) return;
        const MeshLine meshLine(line);
        const auto count = static_cast<std::uint32_t>(mesh->triangleCount());
        for (std::uint32_t triangle = 0; triangle < count; ++triangle) meshLine.addCrossing(*mesh, triangle, found);
    }

    const Line line;
    std::vector<SolidCrossing>& found;
};

// Every end of the parts of a line that an operand holds, of those that are not behind it. At t = 0 is what begins
// before.
struct OperandCrossings {
    template<class S>
    void operator()(const S& shape) const {
        if constexpr (S::isSolid)
            for (const Interval<double>& span : shape.spans(core::Ray<double>{line.origin, line.direction, line.end})) {
                if (!span.exists || !(span.leave > 0)) continue;
                found.push_back({std::max(span.enter, 0.), true});
                if (span.leave < line.end) found.push_back({span.leave, false});
            }
    }
    void operator()(const Csg*) const {}  // none is an operand
    void operator()(const Polyhedron* mesh) const {
        const std::size_t first = found.size();
        Crossings{line, found}(mesh);
        std::ptrdiff_t inside = 0;
        for (std::size_t i = first; i < found.size(); ++i) inside += found[i].enters ? -1 : 1;
        for (; inside > 0; --inside) found.push_back({0, true});
    }

    const Line line;
    std::vector<SolidCrossing>& found;
};

struct CsgSolidCrossing : SolidCrossing {
    std::uint32_t operand;
};

// The whole is crossed where what its operands hold together begins or ends.
void addCsgCrossings(const Scene& scene, const Csg& csg, const core::Rayf& ray, std::vector<SolidCrossing>& crossings) {
    std::vector<CsgSolidCrossing> all;
    std::vector<SolidCrossing> ofOne;
    for (std::uint32_t i = 0; i < csg.operandCount(); ++i) {
        const Instance& instance = scene.instances[csg.firstOperand() + i];
        const Line line(instance.place.toObject(core::Rayf{ray.origin, ray.direction, core::infinity}));
        if (!line.goesAnywhere()) return;
        ofOne.clear();
        std::visit(OperandCrossings{line, ofOne}, instance.shape);
        for (const SolidCrossing& crossing : ofOne) all.push_back({crossing, i});
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    CsgState::Room room;
    room.fit(csg.tree());
    CsgState state(csg.tree(), room);
    const auto cross = [&](const CsgSolidCrossing& crossing) { state.cross(crossing.operand, crossing.enters); };
    std::size_t next = 0;
    for (; next < all.size() && all[next].t <= 0; ++next) cross(all[next]);
    for (; next < all.size() && all[next].t <= double{ray.tMax}; ++next) {
        const bool before = state.isInside();
        cross(all[next]);
        if (state.isInside() != before) crossings.push_back({all[next].t, !before});
    }
}

}  // namespace

void addCrossings(const Scene& scene, const Instance& instance, const core::Rayf& ray,
                  std::vector<SolidCrossing>& crossings) {
    if (const auto* csg = std::get_if<const Csg*>(&instance.shape))
        return addCsgCrossings(scene, **csg, ray, crossings);
    const Line line(instance.place.toObject(ray));
    if (line.goesAnywhere()) std::visit(Crossings{line, crossings}, instance.shape);
}

}  // namespace gr
