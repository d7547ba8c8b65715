#include "gr/mesh/outline.h"

#include <algorithm>
#include <set>

namespace gr {
namespace {

struct Edge {
    glm::dvec2 left, right;  // of two one above the other the lower one is left
    std::size_t number;
};

bool isLeftOf(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

Edge edgeOf(const Outline& outline, std::size_t i) {
    const glm::dvec2 a = outline[i], b = outline[i + 1 < outline.size() ? i + 1 : 0];
    return isLeftOf(a, b) ? Edge{a, b, i} : Edge{b, a, i};
}

bool cross(const Edge& e, const Edge& f) {
    return turn(e.left, e.right, f.left) * turn(e.left, e.right, f.right) < 0 &&
           turn(f.left, f.right, e.left) * turn(f.left, f.right, e.right) < 0;
}

bool anyTwoCross(const Outline& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i)
        for (std::size_t j = i + 1; j < outline.size(); ++j)
            if (cross(edgeOf(outline, i), edgeOf(outline, j))) return true;
    return false;
}

// Of edges above one x, whether e is below f. Where one starts on the other, where it goes on decides.
struct IsBelow {
    bool operator()(const Edge& e, const Edge& f) const {
        if (isLeftOf(f.left, e.left)) return isAbove(e, f) < 0;
        return isAbove(f, e) > 0;
    }

private:
    // 1 where e, which does not start before f, is above it, -1 where below.
    static int isAbove(const Edge& e, const Edge& f) {
        double side = turn(f.left, f.right, e.left);
        if (side == 0) side = turn(f.left, f.right, e.right);
        if (side == 0) return e.number > f.number ? 1 : e.number < f.number ? -1 : 0;
        return side > 0 ? 1 : -1;
    }
};

// A line sweeps from left to right over the edges and keeps those it meets in their order from below: before two cross,
// they are next to each other (Shamos and Hoey 1976).
class Sweep {
public:
    explicit Sweep(const Outline& outline) : places_(outline.size(), met_.end()) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            edges_.push_back(edgeOf(outline, i));
            events_.push_back({edges_[i].left, true, i});
            events_.push_back({edges_[i].right, false, i});
        }
        // At one place, edges end before others start.
        std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
            if (a.at != b.at) return isLeftOf(a.at, b.at);
            return a.starts != b.starts ? b.starts : a.edge < b.edge;
        });
    }

    bool findsCrossing() {
        return std::any_of(events_.begin(), events_.end(), [&](const Event& event) {
            return event.starts ? crossesAtStart(edges_[event.edge]) : letsCross(event.edge);
        });
    }

private:
    using Met = std::set<Edge, IsBelow>;
    struct Event {
        glm::dvec2 at;
        bool starts;
        std::size_t edge;
    };

    // Whether a new edge crosses one of its neighbours.
    bool crossesAtStart(const Edge& edge) {
        if (edge.left == edge.right) return false;
        const auto [place, isNew] = met_.insert(edge);
        if (!isNew) return false;
        places_[edge.number] = place;
        const auto above = std::next(place);
        return (place != met_.begin() && cross(*std::prev(place), edge)) ||
               (above != met_.end() && cross(edge, *above));
    }

    // Whether the neighbours of one that ends, which are each other's from now on, cross.
    bool letsCross(std::size_t edge) {
        if (places_[edge] == met_.end()) return false;
        const auto above = met_.erase(places_[edge]);
        return above != met_.begin() && above != met_.end() && cross(*std::prev(above), *above);
    }

    std::vector<Edge> edges_;
    std::vector<Event> events_;
    Met met_;
    std::vector<Met::iterator> places_;
};

}  // namespace

bool crossesItself(const Outline& outline) {
    return outline.size() <= fewCorners ? anyTwoCross(outline) : Sweep(outline).findsCrossing();
}

}  // namespace gr
