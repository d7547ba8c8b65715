// Where a ray meets a CSG object. To be compiled for each instruction set, as csg_crossings.h.
#pragma once

#include "gr/body_surface.h"
#include "gr/csg/csg_crossings.h"
#include "gr/csg/csg_lanes.h"

namespace gr {

// The ray's way is followed from operand to operand, and where the whole is entered or left, there it is met: its
// surface is that of the operand that is crossed there.
//
// Surfaces of two operands may coincide: a hole that is as deep as the wall, or two blocks of a union side by side.
// Rounding decides which of them comes first, and between the two the whole seems to begin or to end. So what begins
// and ends again within less than rounding, at two surfaces that lie along each other, is no surface: nothing is left
// of a wall where a hole ends, and nothing parts two blocks. Where two such surfaces look the same way, that of the
// operand which was made first is met.
template<class Lanes>
class CsgTracer {
public:
    CsgTracer(const Scene& scene, const Csg& csg, TraversalCounts& counts)
        : scene_(scene), csg_(csg), counts_(counts), room_(ownRoom()) {
        room_.state.fit(csg.tree());
    }

    // The first hit that is not beyond `last`, nor where the ray ends.
    Hit first(const core::Rayf& ray, float last) const {
        // What is within rounding of the end counts for what is before it.
        const float end = std::min(last, ray.tMax) + csg_.farthestFilm<float>(ray.direction);
        CsgCrossings<Lanes>(scene_, csg_, counts_, room_.crossings).find(ray, end);
        if (room_.crossings.empty()) return {};
        return Way(scene_, csg_, ray, room_).first(last);
    }
    // The same of one of the lanes that have been tested at once.
    template<class Real>
    Hit first(const core::Rayf& ray, const CsgLanes<Real>& lanes, int lane, float last) const {
        lanes.crossings(lane, room_.crossings);
        return Way(scene_, csg_, ray, room_).first(last);
    }

    // Replaces `nearest` by what comes before it.
    void nearest(const core::Rayf& ray, Hit& nearest) const {
        const Hit hit = first(ray, nearest.t);
        if (hit.t < core::infinity && hit.isBefore(nearest)) nearest = hit;
    }
    bool occluded(const core::Rayf& ray) const { return first(ray, ray.tMax).t < core::infinity; }

private:
    // Lists that each thread uses again and again.
    struct Room {
        std::vector<CsgCrossing> crossings;
        CsgState::Room state;
    };

    // The way along a ray.
    class Way {
    public:
        Way(const Scene& scene, const Csg& csg, const core::Rayf& ray, Room& room)
            : scene_(scene), csg_(csg), ray_(ray), room_(room), state_(csg.tree(), room.state) {}
        ~Way() {
            for (const CsgCrossing& crossing : room_.crossings) state_.forget(operandAt(crossing));
        }

        // The first, if it is not beyond `last`, nor where the ray ends.
        Hit first(float last) {
            std::size_t i = 0;
            while (i < crossings().size() && crossings()[i].hit.t == 0) cross(i++);
            for (; i < crossings().size() && isWithin(crossings()[i].hit.t, last); ++i) {
                const bool before = state_.isInside();
                cross(i);
                if (state_.isInside() == before) continue;
                if (isAlone(i)) return crossings()[i].hit;
                const Closeness close = closenessAt(i);
                const std::size_t back = endOfFilm(i, close, before);
                if (back == i) return crossings()[firstMade(i, close)].hit;
                i = back;
            }
            return {};
        }

    private:
        // What lies within rounding of a crossing.
        struct Closeness {
            core::Vec3f normal;
            float along;  // in t
        };

        bool isWithin(float t, float last) const { return t <= last && t < ray_.tMax; }
        const std::vector<CsgCrossing>& crossings() const { return room_.crossings; }
        std::size_t operandAt(const CsgCrossing& crossing) const { return crossing.hit.instance - csg_.firstOperand(); }

        void cross(std::size_t i) { state_.cross(operandAt(crossings()[i]), crossings()[i].enters); }

        // Whether no other crossing can be within rounding.
        bool isAlone(std::size_t i) const {
            const float apart = csg_.farthestFilm<float>(ray_.direction);
            const auto isFar = [&](std::size_t other) {
                return std::abs(crossings()[other].hit.t - crossings()[i].hit.t) > apart;
            };
            return (i + 1 == crossings().size() || isFar(i + 1)) && (i == 0 || isFar(i - 1));
        }
        Closeness closenessAt(std::size_t i) const {
            const core::Vec3f normal = normalAt(i);
            const float slope = std::abs(glm::dot(normal, ray_.direction));
            return {normal, std::min(csg_.tolerance() / slope, csg_.farthestFilm<float>(ray_.direction))};
        }
        core::Vec3f normalAt(std::size_t i) const {
            const Hit& hit = crossings()[i].hit;
            SurfacePoint<float> surface{};
            BodySurface<float>(scene_, hit.instance, ray_, hit, true).set(surface, false);
            return surface.normal;
        }
        bool areAlike(std::size_t i, std::size_t other, const Closeness& close) const {
            constexpr float parallel = 1 - 1e-4f;
            return crossings()[i].hit.instance != crossings()[other].hit.instance &&
                   std::abs(glm::dot(close.normal, normalAt(other))) > parallel;
        }

        // Where what began at i has ended again, within rounding; i: nowhere. Crosses what is between.
        std::size_t endOfFilm(std::size_t i, const Closeness& close, bool before) {
            for (std::size_t k = i + 1;
                 k < crossings().size() && crossings()[k].hit.t - crossings()[i].hit.t <= close.along; ++k) {
                cross(k);
                if (state_.isInside() == before && areAlike(i, k, close)) return k;
            }
            return i;
        }

        // Of the surfaces within rounding that look the same way.
        std::size_t firstMade(std::size_t i, const Closeness& close) const {
            std::size_t first = i;
            const auto offer = [&](std::size_t k) {
                const bool isNear = std::abs(crossings()[k].hit.t - crossings()[i].hit.t) <= close.along;
                if (isNear && crossings()[k].hit.t > 0 &&
                    crossings()[k].hit.instance < crossings()[first].hit.instance && looksLike(k) == looksLike(i) &&
                    areAlike(i, k, close))
                    first = k;
                return isNear;
            };
            for (std::size_t k = i + 1; k < crossings().size() && offer(k);) ++k;
            for (std::size_t k = i; k-- > 0 && offer(k);) continue;
            return first;
        }
        bool looksLike(std::size_t i) const {
            return crossings()[i].enters != csg_.tree().isInverted(operandAt(crossings()[i]));
        }

        const Scene& scene_;
        const Csg& csg_;
        const core::Rayf& ray_;
        Room& room_;
        CsgState state_;
    };

    static Room& ownRoom() {
        thread_local Room room;
        return room;
    }

    const Scene& scene_;
    const Csg& csg_;
    TraversalCounts& counts_;
    Room& room_;
};

}  // namespace gr
