// Where the rays of all lanes go into the operands of a small CSG object and out of them: each operand is tested by all
// lanes at once. To be compiled for each instruction set.
#pragma once

#include "gr/csg/csg_crossings.h"

#include <array>
#include <tuple>

namespace gr {

template<class Real>
class CsgLanes {
public:
    // How many operands may be: each may have two parts of a line.
    static constexpr std::uint32_t most = 12;
    static bool isFor(const Csg& csg) { return csg.operandCount() <= most && !csg.hasMeshes(); }

    CsgLanes(const Scene& scene, const Csg& csg, const core::Ray<Real>& ray, TraversalCounts& counts) {
        for (std::uint32_t i = csg.firstOperand(); i < csg.firstOperand() + csg.operandCount(); ++i)
            std::visit(
                [&]<class S>(const S& shape) {
                    if constexpr (isSolidShape<S>)
                        for (const Interval<Real>& span : shape.spans(scene.instances[i].place.toObject(ray)))
                            add(span, i);
                },
                scene.instances[i].shape);
        counts.tests += csg.operandCount();
    }

    // A bit for each lane that comes near.
    std::uint32_t lanes() const { return lanes_; }

    // The crossings of one of them, in their order.
    void crossings(int lane, std::vector<CsgCrossing>& found) const {
        found.clear();
        for (std::uint32_t i = 0; i < count_; ++i)
            if (parts_[i].lanes >> lane & 1) addSpan(enter_[i][lane], leave_[i][lane], parts_[i].instance, found);
        sortCrossings(found);
    }

private:
    struct Part {
        std::uint32_t instance;
        std::uint32_t lanes;
    };

    void add(const Interval<Real>& span, std::uint32_t instance) {
        const std::uint32_t ahead = core::bitsOf(span.exists & (span.leave > Real(0)));
        if (ahead == 0) return;
        parts_[count_] = {instance, ahead};
        enter_[count_] = core::LaneArray<Real>(span.enter);
        leave_[count_] = core::LaneArray<Real>(span.leave);
        ++count_;
        lanes_ |= ahead;
    }

    static constexpr std::size_t mostParts = 2 * most;
    std::array<Part, mostParts> parts_;
    core::LaneArray<Real> enter_[mostParts], leave_[mostParts];
    std::uint32_t count_ = 0, lanes_ = 0;
};

}  // namespace gr
