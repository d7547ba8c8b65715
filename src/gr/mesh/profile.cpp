#include "gr/mesh/profile.h"

#include "core/error.h"
#include "gr/mesh/outline.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <numeric>

namespace gr {
namespace {

[[noreturn]] void fail(const std::string& why) {
    throw core::Error("LATHE", "PROFILE", "", "the profile " + why);
}

std::string text(const ProfileSegment& segment) {
    return std::to_string(segment.first) + " to " + std::to_string(segment.second);
}

glm::dvec2 place(const ProfilePoint& point) {
    return {point.r, point.y};
}

// Where all parts of a profile lie, for the search for two that meet.
class Crossings {
public:
    Crossings(std::span<const ProfilePoint> profile, const std::vector<ProfileSegment>& segments)
        : profile_(profile), segments_(segments), order_(segments.size()) {}

    // From below upwards: only those are looked at together that have a height in common.
    void refuse() {
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(),
                  [&](int a, int b) { return std::pair(low(a), a) < std::pair(low(b), b); });
        for (std::size_t i = 0; i < order_.size(); ++i)
            for (std::size_t j = i + 1; j < order_.size() && low(order_[j]) <= high(order_[i]); ++j)
                if (meet(segments_[order_[i]], segments_[order_[j]])) refuse(order_[i], order_[j]);
    }

private:
    [[noreturn]] void refuse(int a, int b) const {
        fail("crosses or touches itself: from point " + text(segments_[std::min(a, b)]) + " and from point " +
             text(segments_[std::max(a, b)]));
    }

    double low(int i) const { return std::min(profile_[segments_[i].first].y, profile_[segments_[i].second].y); }
    double high(int i) const { return std::max(profile_[segments_[i].first].y, profile_[segments_[i].second].y); }

    bool meet(const ProfileSegment& a, const ProfileSegment& b) const {
        const ProfilePoint ends[] = {profile_[a.first], profile_[a.second], profile_[b.first], profile_[b.second]};
        const glm::dvec2 p = place(ends[0]), q = place(ends[1]), s = place(ends[2]), t = place(ends[3]);
        const double sides[] = {turn(p, q, s), turn(p, q, t), turn(s, t, p), turn(s, t, q)};
        const auto apart = [](double x, double y) { return (x > 0 && y < 0) || (x < 0 && y > 0); };
        if (apart(sides[0], sides[1]) && apart(sides[2], sides[3])) return true;
        if (p == t && q == s) return true;
        // An end that lies on the other one: but for the point in which neighbours meet, and places on the axis.
        for (int i = 0; i < 4; ++i) {
            if (sides[i < 2 ? i + 2 : i - 2] != 0) continue;
            const ProfilePoint &end = ends[i], &from = ends[i < 2 ? 2 : 0], &to = ends[i < 2 ? 3 : 1];
            const double along = glm::dot(place(to) - place(from), place(end) - place(from));
            const double whole = glm::dot(place(to) - place(from), place(to) - place(from));
            if (along < 0 || along > whole) continue;
            const bool isShared = end == from || end == to;
            const bool areNeighbours = a.second == b.first || b.second == a.first || closes(a, b);
            if (isShared && (areNeighbours || end.r == 0)) continue;
            return true;
        }
        return false;
    }
    // Whether the two meet where a ring begins and ends.
    bool closes(const ProfileSegment& a, const ProfileSegment& b) const {
        const int last = static_cast<int>(profile_.size()) - 1;
        return profile_.front() == profile_.back() &&
               ((a.first == 0 && b.second == last) || (b.first == 0 && a.second == last));
    }

    std::span<const ProfilePoint> profile_;
    const std::vector<ProfileSegment>& segments_;
    std::vector<int> order_;
};

glm::dvec2 rightOf(const glm::dvec2& direction) {
    return {direction.y, -direction.x};
}

bool isSmooth(const glm::dvec2& in, const glm::dvec2& out) {
    return glm::dot(in, out) >= std::cos(glm::radians(sharpProfile)) - 1e-9;
}

// On the axis a profile meets its own mirror image, elsewhere its next segment.
void setNormals(std::span<const ProfilePoint> profile, std::vector<ProfileSegment>& segments) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        ProfileSegment& a = segments[i];
        const glm::dvec2 mirrored(a.direction.x, -a.direction.y);
        if (profile[a.first].r == 0 && isSmooth(a.direction, mirrored)) a.normals[0] = {0, -glm::sign(a.direction.x)};
        if (profile[a.second].r == 0 && isSmooth(a.direction, mirrored)) a.normals[1] = {0, -glm::sign(a.direction.x)};
        ProfileSegment& b = segments[i + 1 < segments.size() ? i + 1 : 0];
        if (profile[a.second].r == 0 || profile[a.second] != profile[b.first] || !isSmooth(a.direction, b.direction))
            continue;
        a.normals[1] = b.normals[0] = glm::normalize(rightOf(a.direction) + rightOf(b.direction));
    }
}

}  // namespace

std::vector<ProfileSegment> segmentsOf(std::span<const ProfilePoint> profile) {
    std::vector<ProfileSegment> segments;
    double length = 0;
    for (int i = 0; i + 1 < static_cast<int>(profile.size()); ++i) {
        const ProfilePoint &a = profile[i], &b = profile[i + 1];
        if (a == b) fail("has the same point twice, " + std::to_string(i) + " and " + std::to_string(i + 1));
        if (a.r == 0 && b.r == 0) continue;
        const glm::dvec2 way = place(b) - place(a),
                         direction = glm::normalize(way / std::max(std::abs(way.x), std::abs(way.y)));
        const double end = length + std::hypot(way.x, way.y);
        segments.push_back({i, i + 1, direction, length, end, {rightOf(direction), rightOf(direction)}});
        length = end;
    }
    if (segments.empty()) fail("never leaves the axis: at least one r must be greater than 0");
    for (ProfileSegment& segment : segments) {
        segment.start /= length;
        segment.end /= length;
    }
    Crossings(profile, segments).refuse();
    setNormals(profile, segments);
    return segments;
}

}  // namespace gr
