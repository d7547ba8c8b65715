// Which light a surface point asks where chance picks it: one that has a place, which the tree over lights finds, or an
// endless one, which is as bright wherever the point is.
#pragma once

#include "render/transport/light_tree.h"

#include <cstddef>
#include <vector>

namespace render {

class LightChoice {
public:
    explicit LightChoice(const gr::Lights& lights);

    // u: uniform in [0, 1).
    template<class Real>
    LightTree::Pick<Real> pick(const core::Vec3<Real>& at, const Real& u) const {
        if (ends_.empty()) return tree_.pick(at, u);
        const core::Mask<Real> isEndless = u < Real(endlessShare_);
        // A number that is uniform again.
        const Real rest = core::select(isEndless, u, u - Real(endlessShare_)) * Real(restFactor_);
        Real light(first_), low(0), high(ends_[0]);
        for (std::size_t i = 1; i < ends_.size(); ++i) {
            const core::Mask<Real> isBeyond = rest >= Real(ends_[i - 1]);
            light = core::select(isBeyond, Real(first_ + static_cast<float>(i)), light);
            low = core::select(isBeyond, Real(ends_[i - 1]), low);
            high = core::select(isBeyond, Real(ends_[i]), high);
        }
        const LightTree::Pick<Real> endless{light, (high - low) * Real(endlessShare_)};
        if (endlessShare_ == 1) return endless;
        const LightTree::Pick<Real> placed = tree_.pick(at, rest);
        return {core::select(isEndless, endless.light, placed.light),
                core::select(isEndless, endless.probability, placed.probability * Real(1 - endlessShare_))};
    }

    // How likely pick() is to pick this light: one that has a place,
    template<class Real>
    Real probability(const core::Vec3<Real>& at, const Real& light) const {
        const Real found = tree_.probability(at, light);
        return ends_.empty() ? found : found * Real(1 - endlessShare_);
    }
    // or the endless one of that number.
    float endlessProbability(std::size_t number) const {
        return (ends_[number] - (number == 0 ? 0 : ends_[number - 1])) * endlessShare_;
    }

    std::size_t bytes() const { return tree_.bytes() + ends_.capacity() * sizeof(float); }

private:
    LightTree tree_;
    // The endless lights: how likely those up to each are, by their irradiance, once one of them is picked.
    std::vector<float> ends_;
    float first_ = 0;  // the index of the first
    float endlessShare_ = 0;  // how likely one of them is picked
    float restFactor_ = 1;
};

}  // namespace render
