#include "gr/mesh/lathe.h"

#include "core/error.h"
#include "gr/mesh/profile.h"

#include <cmath>
#include <numbers>

namespace gr {
namespace {

class Lathe {
public:
    Lathe(std::span<const ProfilePoint> profile, int segments) : profile_(profile), segments_(segments) {
        for (int k = 0; k <= 2 * segments; ++k) {
            // Of a whole turn the last direction is the first one.
            const double angle = std::numbers::pi * (k % (2 * segments)) / segments;
            directions_.push_back({-std::sin(angle), 0, -std::cos(angle)});
        }
    }

    FlatMesh turned() && {
        const std::vector<ProfileSegment> segments = segmentsOf(profile_);
        if (static_cast<double>(segments.size()) * segments_ > mostLatheFaces)
            throw core::Error("LATHE", "SIZE", "",
                              std::to_string(segments.size()) + " parts of the profile in " +
                                  std::to_string(segments_) + " segments are more than " +
                                  std::to_string(mostLatheFaces) + " faces");
        addVertices();
        isReversed_ = volume(segments) < 0;
        for (const ProfileSegment& segment : segments)
            for (int k = 0; k < segments_; ++k) addFaces(segment, k);
        return std::move(mesh_);
    }

private:
    // Of what the profile goes round, outwards where it goes up on the outside; times 3 / pi.
    double volume(const std::vector<ProfileSegment>& segments) const {
        double sum = 0;
        for (const ProfileSegment& s : segments) {
            const ProfilePoint &a = profile_[s.first], &b = profile_[s.second];
            sum += (b.y - a.y) * (a.r * a.r + a.r * b.r + b.r * b.r);
        }
        return sum;
    }

    // One for each point on the axis, a ring of them for every other.
    void addVertices() {
        const bool isRing = profile_.front() == profile_.back();
        for (std::size_t i = 0; i < profile_.size(); ++i) {
            if (isRing && i + 1 == profile_.size()) {
                firsts_.push_back(firsts_.front());
                continue;
            }
            firsts_.push_back(static_cast<int>(mesh_.vertices.size()));
            const ProfilePoint& point = profile_[i];
            for (int k = 0; k < (point.r == 0 ? 1 : segments_); ++k)
                mesh_.vertices.push_back(at(2 * k, point.r) + glm::dvec3(0, point.y, 0));
        }
    }
    // halves: of a segment.
    glm::dvec3 at(int halves, double r) const { return directions_[halves] * r; }

    // Between two meridians: two triangles, or one that ends in a pole.
    void addFaces(const ProfileSegment& segment, int k) {
        const bool startsAtPole = profile_[segment.first].r == 0, endsAtPole = profile_[segment.second].r == 0;
        const auto corner = [&](bool isSecond, int halves) { return Corner{&segment, isSecond, halves}; };
        const int west = 2 * k, east = 2 * k + 2, middle = 2 * k + 1;
        if (startsAtPole) return addTriangle(corner(false, middle), corner(true, east), corner(true, west));
        if (endsAtPole) return addTriangle(corner(false, west), corner(false, east), corner(true, middle));
        addTriangle(corner(false, west), corner(false, east), corner(true, east));
        addTriangle(corner(false, west), corner(true, east), corner(true, west));
    }

    struct Corner {
        const ProfileSegment* segment;
        bool isSecond;
        int halves;
    };
    void addTriangle(const Corner& a, const Corner& b, const Corner& c) {
        add(a);
        add(isReversed_ ? c : b);
        add(isReversed_ ? b : c);
    }
    void add(const Corner& corner) {
        const ProfileSegment& segment = *corner.segment;
        const int point = corner.isSecond ? segment.second : segment.first;
        const bool isPole = profile_[point].r == 0;
        mesh_.corners.push_back(firsts_[point] + (isPole ? 0 : corner.halves / 2 % segments_));
        const glm::dvec2 normal = segment.normals[corner.isSecond] * (isReversed_ ? -1. : 1.);
        mesh_.normals.push_back(packNormal(core::Vec3f(at(corner.halves, normal.x) + glm::dvec3(0, normal.y, 0))));
        mesh_.uvs.push_back(core::Vec2f(static_cast<float>(corner.halves / (2. * segments_)),
                                        static_cast<float>(corner.isSecond ? segment.end : segment.start)));
    }

    std::span<const ProfilePoint> profile_;
    int segments_;
    std::vector<glm::dvec3> directions_;  // from the axis, every half segment
    std::vector<int> firsts_;  // of each point of the profile: its first vertex
    bool isReversed_ = false;
    FlatMesh mesh_;
};

}  // namespace

FlatMesh latheMesh(std::span<const ProfilePoint> profile, int segments) {
    return Lathe(profile, segments).turned();
}

}  // namespace gr
