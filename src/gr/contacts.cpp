#include "gr/contacts.h"

#include "core/option.h"
#include "gr/database/node.h"
#include "gr/offset.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace gr {
namespace {

std::vector<FlatSide> flatSidesOf(const Shape& shape) {
    return visitShape(shape, [](const auto& s) { return s.flatSides(); });
}

// A flat side in the scene.
struct Side {
    std::array<glm::dvec3, 4> corners;
    glm::dvec3 middle;  // which has all its digits also where the corners are nearly without end
    glm::dvec3 normal;  // unit length, outward
    double size;  // its longest edge
    const Instance& instance;

    // matrix: from the side's own space; normals: what it makes of normals, the transposed inverse, which keeps them
    // outward where it mirrors.
    Side(const FlatSide& side, const glm::dmat4& matrix, const glm::dmat3& normals, const Instance& instance)
        : instance(instance) {
        const auto place = [&](const glm::dvec3& p) { return glm::dvec3(matrix * glm::dvec4(p, 1)); };
        const glm::dvec3 last = side.isTriangle ? side.edge2 : side.edge1 + side.edge2;
        corners = {place(side.corner), place(side.corner + side.edge1), place(side.corner + last),
                   place(side.corner + side.edge2)};
        middle = place(side.corner + 0.5 * (side.edge1 + side.edge2));
        normal = glm::normalize(normals * glm::cross(side.edge1, side.edge2));
        size = std::max(glm::distance(corners[0], corners[1]), glm::distance(corners[0], corners[3]));
    }
    // How far rounding may move a point of it along the normal.
    double errorAt(const glm::dvec3& point) const {
        return offsetBeyond(glm::dvec3(instance.errorAt(core::Vec3f(point))), normal);
    }
};

std::vector<Side> sidesOf(const FlatObject& object, const Instance& instance) {
    const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(object.matrix)));
    std::vector<Side> sides;
    for (const FlatSide& side : flatSidesOf(instance.shape)) {
        const Side placed(side, object.matrix, normals, instance);
        if (std::isfinite(placed.normal.x)) sides.push_back(placed);
    }
    return sides;
}

// Along an axis across both normals, how far the two reach into each other.
double overlapAlong(const glm::dvec3& axis, const Side& a, const Side& b) {
    double low = -core::infinity, high = core::infinity;
    for (const Side* side : {&a, &b}) {
        double least = core::infinity, most = -core::infinity;
        for (const glm::dvec3& corner : side->corners) {
            least = std::min(least, glm::dot(axis, corner));
            most = std::max(most, glm::dot(axis, corner));
        }
        low = std::max(low, least);
        high = std::min(high, most);
    }
    return high - low;
}

// Whether they cover each other by more than that. Of two convex outlines in a plane that do not, an edge of one parts
// them.
bool areOpposite(const Side& a, const Side& b, double leeway) {
    for (const Side* side : {&a, &b})
        for (std::size_t i = 0; i < side->corners.size(); ++i) {
            const glm::dvec3 along = side->corners[(i + 1) % side->corners.size()] - side->corners[i];
            if (along == glm::dvec3(0)) continue;
            if (overlapAlong(glm::normalize(glm::cross(side->normal, along)), a, b) <= leeway) return false;
        }
    return true;
}

struct Gap {
    double size;  // less than 0: they overlap, or are the two sides of one body
    double error;  // how far roundings may move both sides together
};

// Of two sides that look at each other and are parallel.
std::optional<Gap> gapBetween(const Side& a, const Side& b) {
    constexpr double parallel = 1e-9;  // 1 - cos
    if (glm::dot(a.normal, b.normal) > parallel - 1) return std::nullopt;
    const Side &larger = a.size > b.size ? a : b, &smaller = a.size > b.size ? b : a;
    double nearest = core::infinity, farthest = -nearest, error = 0, reach = 0;
    for (const glm::dvec3& corner : smaller.corners) {
        const double height = glm::dot(larger.normal, corner - larger.middle);
        nearest = std::min(nearest, height);
        farthest = std::max(farthest, height);
        error = std::max(error, larger.errorAt(corner) + smaller.errorAt(corner));
        reach = std::max(reach, glm::length(corner));
    }
    if (farthest - nearest > error) return std::nullopt;
    const double size = 0.5 * (nearest + farthest);
    // What a script's own rounding leaves between two faces is no gap.
    return Gap{std::abs(size) < 1e-14 * reach ? 0 : size, error};
}

// The widest gap that is within rounding between any two sides.
std::optional<Gap> widestGap(const std::vector<Side>& sides, const std::vector<Side>& others, bool isWithin) {
    std::optional<Gap> widest;
    for (const Side& side : sides)
        for (const Side& other : others) {
            std::optional<Gap> gap = gapBetween(side, other);
            if (!gap) continue;
            if (isWithin) gap->size = -gap->size;
            if (gap->size < 0 || (isWithin && gap->size == 0) || gap->size >= gap->error) continue;
            if ((!widest || gap->size > widest->size) && areOpposite(side, other, gap->error)) widest = gap;
        }
    return widest;
}

// How many pairs of sides are compared.
class Budget {
public:
    bool allows(std::size_t pairs) {
        left_ -= std::min(left_, pairs);
        return left_ > 0;
    }

private:
    std::size_t left_ = std::size_t{1} << 26;
};

std::string named(const FlatObject& object) {
    return "\"" + object.node->path() + "\"";
}

std::string shortText(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", number);
    return text;
}

}  // namespace

bool hasFlatSides(const Shape& shape) {
    constexpr std::size_t mostTriangles = 1000;
    if (const auto* mesh = std::get_if<const Polyhedron*>(&shape)) return (*mesh)->triangleCount() <= mostTriangles;
    return !flatSidesOf(shape).empty();
}

std::string Contact::warning() const {
    if (gap == 0) return "";
    const bool isThin = first == second;
    return named(*first) + (isThin ? " is " : " and " + named(*second) + " are ") + shortText(gap) +
           (isThin ? " thick" : " apart") + ", and rounding may move " + (isThin ? "its surface" : "their surfaces") +
           " by " + shortText(error) + ": " +
           (isThin ? "light that enters it may not come out" : "they are shown as touching");
}

std::vector<Contact> contactsOf(const Scene& scene, std::span<const FlatObject> objects,
                                const std::vector<core::Bounds>& boxes) {
    if (!scene.hasInteriors()) return {};
    const auto isTransparent = [&](const FlatObject& object) {
        return scene.interiors[scene.instances[object.instance].material].has_value();
    };
    const auto isNear = [&](const FlatObject& a, const FlatObject& b) {
        return !boxes[a.instance].intersection(boxes[b.instance]).isEmpty();
    };
    Budget budget;
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const FlatObject& a = objects[i];
        if (!isTransparent(a)) continue;
        const std::vector<Side> sides = sidesOf(a, scene.instances[a.instance]);
        for (std::size_t k = 0; k < objects.size(); ++k) {
            const FlatObject& b = objects[k];
            if (!budget.allows(1)) return contacts;
            const bool areOfOne = a.csg != ofNoCsg && a.csg == b.csg && i != k;
            if (areOfOne || (k < i && isTransparent(b)) || !isNear(a, b)) continue;
            const std::vector<Side> others = sidesOf(b, scene.instances[b.instance]);
            if (!budget.allows(sides.size() * others.size())) return contacts;
            if (const std::optional<Gap> gap = widestGap(sides, others, i == k))
                contacts.push_back({&a, &b, gap->size, gap->error});
        }
    }
    return contacts;
}

}  // namespace gr
