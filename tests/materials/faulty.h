// Materials with a fault, for the tests that see a check find it.
#pragma once

namespace materials {

// FaultyBsdf derives from the BSDF that M makes.
template<class M, class FaultyBsdf>
struct Faulty : M {
    template<class Real, class Point>
    FaultyBsdf at(const Point& point) const {
        return {M::template at<Real>(point)};
    }
};

}  // namespace materials
