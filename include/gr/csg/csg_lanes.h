// Where the rays of all lanes go into the operands of a small CSG object and out of them: each operand is tested by all
// lanes at once. To be compiled for each instruction set.
#pragma once

#include "gr/csg/csg_crossings.h"

#include <array>

namespace gr {

template<class Real>
class CsgLanes {
public:
    using Mask = core::Mask<Real>;
    using UInt = core::UInt<Real>;

    // How many operands may be: each may have two parts of a line.
    static constexpr std::uint32_t most = 12;
    static bool isFor(const Csg& csg) { return csg.operandCount() <= most && !csg.hasMeshes(); }

    CsgLanes(const Scene& scene, const Csg& csg, const core::Ray<Real>& ray, TraversalCounts& counts) : csg_(csg) {
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
            if (enter_[i][lane] < core::infinity) addSpan(enter_[i][lane], leave_[i][lane], instance_[i], found);
        sortCrossings(found);
    }

    bool haveTable() const { return csg_.tree().operandCount() <= CsgTree::mostInTable; }
    // What all lanes that are asked meet first, up to `last` and before their rays end; for a tree that has a table.
    // isUnclear: what they meet there has another crossing beside it, and must be asked one by one.
    struct First {
        HitOf<Real> hit;
        Mask isUnclear;
    };
    First first(const core::Ray<Real>& ray, const Mask& asked, const Real& last) const {
        const InOrder in(*this);
        const UInt table(csg_.tree().table()), lastBit(1), operands((1u << numberFrom) - 1);
        UInt inside(0), code(0);  // inside: a bit for each operand
        Real before = core::toReal(table & lastBit);
        First first{{}, Real(0) > Real(0)};
        Mask goesOn = asked;
        for (std::uint32_t i = 0; i < in.count; ++i) {
            inside = inside ^ (in.code[i] & operands);
            const Real now = core::toReal((table >> inside) & lastBit);
            const Mask isMet = goesOn & (now != before) & (in.t[i] > Real(0));
            before = now;
            if (!core::any(isMet)) continue;
            const Mask counts = isMet & (in.t[i] <= last) & (in.t[i] < ray.tMax);
            // Twice as far, for rounding.
            const Real apart = Real(2) * csg_.farthestFilm<Real>(ray.direction);
            Mask isAlone = counts;
            if (i > 0) isAlone = isAlone & (in.t[i] - in.t[i - 1] > apart);
            if (i + 1 < in.count) isAlone = isAlone & (in.t[i + 1] - in.t[i] > apart);
            first.isUnclear = first.isUnclear | (counts & !isAlone);
            first.hit.t = core::select(isAlone, in.t[i], first.hit.t);
            code = core::selectUInt<Real>(isAlone, in.code[i], code);
            goesOn = goesOn & !isMet;
            if (!core::any(goesOn)) break;
        }
        first.hit.instance = UInt(csg_.firstOperand()) + ((code & UInt((1u << leavesBit) - 1)) >> numberFrom);
        first.hit.triangle = (code >> leavesBit) * UInt(Hit::leaves);
        return first;
    }

private:
    static constexpr std::size_t mostParts = 2 * most;

    void add(const Interval<Real>& span, std::uint32_t instance) {
        const Mask isAhead = span.exists & (span.leave > Real(0));
        const std::uint32_t ahead = core::bitsOf(isAhead);
        if (ahead == 0) return;
        const Real never(core::infinity), enter = core::max(span.enter, Real(0));
        instance_[count_] = instance;
        enter_[count_] = core::LaneArray<Real>(core::select(isAhead, enter, never));
        leave_[count_] = core::LaneArray<Real>(core::select(isAhead, core::max(enter, span.leave), never));
        ++count_;
        lanes_ |= ahead;
    }

    // Of a crossing one number tells: by a bit for each which operand it is of, from bit `numberFrom` on that one's
    // number, and whether the ray leaves it.
    static constexpr int numberFrom = CsgTree::mostInTable, leavesBit = 31;

    // The crossings of all lanes, each lane's in its order; at infinity what it has not.
    struct InOrder {
        explicit InOrder(const CsgLanes& lanes) : count(0) {
            for (std::uint32_t i = 0; i < lanes.count_; ++i) {
                const std::uint32_t operand = lanes.instance_[i] - lanes.csg_.firstOperand();
                const std::uint32_t enters = operand << numberFrom | 1u << operand;
                add(lanes.enter_[i].real(), UInt(enters), 0);
                // It is never left before it is entered.
                add(lanes.leave_[i].real(), UInt(enters | 1u << leavesBit), 1);
            }
        }

        // Those at one place stay as they come, by the numbers of their operands. first: before which it cannot be.
        void add(const Real& at, const UInt& what, std::uint32_t first) {
            t[count] = at;
            code[count] = what;
            for (std::uint32_t i = count++; i > first; --i) order(i - 1, i);
        }

        void order(std::uint32_t i, std::uint32_t k) {
            const Mask isWrong = t[k] < t[i];
            const Real nearer = core::select(isWrong, t[k], t[i]), farther = core::select(isWrong, t[i], t[k]);
            const UInt first = core::selectUInt<Real>(isWrong, code[k], code[i]);
            code[k] = core::selectUInt<Real>(isWrong, code[i], code[k]);
            code[i] = first;
            t[i] = nearer;
            t[k] = farther;
        }

        static constexpr std::size_t most = 2 * 2 * CsgTree::mostInTable;
        std::uint32_t count;
        Real t[most];
        UInt code[most];
    };

    const Csg& csg_;
    // Parts of the line that an operand holds: of which, and where each lane enters and leaves; infinity where it has
    // no such part.
    std::array<std::uint32_t, mostParts> instance_;
    core::LaneArray<Real> enter_[mostParts], leave_[mostParts];
    std::uint32_t count_ = 0, lanes_ = 0;
};

}  // namespace gr
