// Ear clipping (Meisters 1975): every simple outline of more than three corners has two ears, triangles round a corner
// that can be cut off.
#include "gr/mesh/corner_tree.h"

#include <deque>
#include <numeric>

namespace gr {
namespace {

// Whether the triangle round corner i of what is left of the outline can be cut off: it turns left, and no other
// corner lies in it. A corner at the same place as one of the triangle's does not count.
bool isEar(const Outline& outline, const std::vector<int>& left, std::size_t i) {
    const std::size_t n = left.size();
    const glm::dvec2 a = outline[left[(i + n - 1) % n]], b = outline[left[i]], c = outline[left[(i + 1) % n]];
    if (turn(a, b, c) <= 0) return false;
    for (const int other : left) {
        const glm::dvec2 p = outline[other];
        if (p == a || p == b || p == c) continue;
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

// Whether nothing with an area is left to cut off, but for what the outline's own roundings may make.
bool isFlat(const Outline& outline, const std::vector<int>& left) {
    glm::dvec2 low = outline[0], high = outline[0];
    for (const glm::dvec2& p : outline) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec2 size = high - low;
    const double rounding = 0x1p-50 * size.x * size.y;
    for (std::size_t i = 1; i + 1 < left.size(); ++i)
        if (std::abs(turn(outline[left[0]], outline[left[i]], outline[left[i + 1]])) > rounding) return false;
    return true;
}

bool clipFew(const Outline& outline, std::vector<glm::ivec3>& triangles, std::vector<int>& left) {
    left.resize(outline.size());
    std::iota(left.begin(), left.end(), 0);
    std::size_t at = 0, tried = 0;
    while (left.size() >= 3) {
        const std::size_t n = left.size();
        at %= n;
        if (isEar(outline, left, at)) {
            triangles.emplace_back(left[(at + n - 1) % n], left[at], left[(at + 1) % n]);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
            tried = 0;
        } else if (++at, ++tried == n) {
            return isFlat(outline, left);
        }
    }
    left.clear();
    return true;
}

// The same in less than quadratic time. What is left is a ring of corners. Whether a corner is an ear is asked again
// only where the answer may be another: when a neighbour of it was cut off, or when a corner that lay just on a side of
// its triangle is no longer in the way. One that lies within stays in the way for as long as the neighbours stay, since
// the triangle's third side leaves the outline. And of the corners that lie in a triangle it is enough to know those
// where the outline does not turn left: the one nearest to the tip is such a one.
class Clipper {
public:
    explicit Clipper(const Outline& outline)
        : outline_(outline),
          left_(outline.size()),
          last_(outline.size()),
          next_(outline.size()),
          isWaiting_(outline.size(), 1),
          firstTouch_(outline.size(), none),
          tree_(outline, notLeft(outline)) {
        const int n = static_cast<int>(outline.size());
        for (int i = 0; i < n; ++i) {
            last_[i] = i == 0 ? n - 1 : i - 1;
            next_[i] = i + 1 == n ? 0 : i + 1;
            waiting_.push_back(i);
        }
    }

    bool clip(std::vector<glm::ivec3>& triangles, std::vector<int>& onLine) {
        while (!waiting_.empty() && left_ > 2) {
            const int corner = waiting_.front();
            waiting_.pop_front();
            isWaiting_[corner] = 0;
            if (isEar(corner)) cutOff(corner, triangles);
        }
        onLine.clear();
        if (left_ > 2) onLine = ring();
        return onLine.empty() || isFlat(outline_, onLine);
    }

private:
    static constexpr int none = CornerTree::none;

    static std::vector<int> notLeft(const Outline& outline) {
        std::vector<int> corners;
        const std::size_t n = outline.size();
        for (std::size_t i = 0; i < n; ++i)
            if (turn(outline[i == 0 ? n - 1 : i - 1], outline[i], outline[i + 1 < n ? i + 1 : 0]) <= 0)
                corners.push_back(static_cast<int>(i));
        return corners;
    }

    bool turnsLeft(int corner) const {
        return turn(outline_[last_[corner]], outline_[corner], outline_[next_[corner]]) > 0;
    }

    bool isEar(int corner) {
        if (!turnsLeft(corner)) return false;
        const glm::dvec2 a = outline_[last_[corner]], b = outline_[corner], c = outline_[next_[corner]];
        const int other = tree_.findIn(a, b, c);
        if (other == none) return true;
        const glm::dvec2 p = outline_[other];
        if (turn(a, b, p) == 0 || turn(b, c, p) == 0 || turn(c, a, p) == 0) addTouch(other, corner);
        return false;
    }

    void cutOff(int corner, std::vector<glm::ivec3>& triangles) {
        const int last = last_[corner], next = next_[corner];
        triangles.emplace_back(last, corner, next);
        next_[last] = next;
        last_[next] = last;
        first_ = next;
        --left_;
        isWaiting_[corner] = 1;  // it is gone: nothing asks for it again
        for (const int neighbour : {last, next}) {
            ask(neighbour);
            if (!turnsLeft(neighbour)) continue;
            tree_.remove(neighbour);
            for (int i = std::exchange(firstTouch_[neighbour], none); i != none; i = touches_[i].next)
                ask(touches_[i].corner);
        }
    }

    // Notes that a corner touches the triangle of another one.
    void addTouch(int touching, int corner) {
        touches_.push_back({corner, firstTouch_[touching]});
        firstTouch_[touching] = static_cast<int>(touches_.size()) - 1;
    }

    void ask(int corner) {
        if (isWaiting_[corner] != 0) return;
        isWaiting_[corner] = 1;
        waiting_.push_back(corner);
    }

    std::vector<int> ring() const {
        std::vector<int> corners{first_};
        for (int i = next_[first_]; i != first_; i = next_[i]) corners.push_back(i);
        return corners;
    }

    const Outline& outline_;
    std::size_t left_;
    int first_ = 0;  // one of those left
    std::vector<int> last_, next_;  // the neighbours of each corner that is left
    std::vector<char> isWaiting_;
    std::deque<int> waiting_;  // those to be looked at
    // For each corner a list of those whose triangles it touches: its first place in touches_, or none.
    struct Touch {
        int corner, next;
    };
    std::vector<int> firstTouch_;
    std::vector<Touch> touches_;
    CornerTree tree_;  // of the corners where the outline does not turn left
};

}  // namespace

bool clipEars(const Outline& outline, std::vector<glm::ivec3>& triangles, std::vector<int>& onLine) {
    return outline.size() <= fewCorners ? clipFew(outline, triangles, onLine)
                                        : Clipper(outline).clip(triangles, onLine);
}

}  // namespace gr
