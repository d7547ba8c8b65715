// Light from a sky all round, as a picture has it.
#pragma once

#include "core/elementary.h"
#include "core/warp.h"
#include "gr/lights/light_concept.h"
#include "gr/lights/sky_grid.h"

namespace gr {

// Where a place of a sky's picture is seen: +y up, its middle towards -z, its right half towards +x.
template<class Real>
struct SkyDirection {
    core::Vec3<Real> wi;  // of unit length
    Real sine;  // of the angle from above

    // v: from 0 above to 1 below; right: from the middle, in turns, from 0 to 1.
    SkyDirection(const Real& v, const Real& right) {
        const core::SinCos<Real> fromUp = core::sinCosTurns(v * Real(0.5f)), round = core::sinCosTurns(right);
        wi = {fromUp.sin * round.sin, fromUp.cos, -(fromUp.sin * round.cos)};
        sine = fromUp.sin;
    }
};

// The picture is seen from within, +y up, its middle towards -z and its right half towards +x, before it is turned
// about +y. In lanes it is the same picture for all. A pointer and Reals, so that lanes can gather them.
template<class Real>
struct SkyLightOf {
    static constexpr bool isNamed = false, isEndless = true, canBeMet = true, hasPlaces = true;

    const SkyGrid* grid;
    Real unit;  // the grid's, of what each answer brings
    Real turns;  // about +y, counterclockwise seen from above; from 0 to 1

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.grid, self.unit, self.turns);
    }

    // From wherever. u: uniform in the unit square.
    LightSample<Real> sample(const core::Vec3<Real>&, const core::Vec2<Real>& u) const {
        const auto place = grid->draw(u);
        // To the right of -z; from 0 to 1.
        const Real right = place.u - Real(0.5f) - turns;
        const Real around =
            right - core::select(right < Real(-1), Real(-2), core::select(right < Real(0), Real(-1), Real(0)));
        const SkyDirection<Real> direction(place.v, core::min(around, Real(1)));
        const core::Vec3<Real>& wi = direction.wi;
        const Real pdf = pdfWOf(place.density, direction.sine);
        const core::Rgb<Real> weight = place.radiance * (unit / core::max(pdf, Real(0x1p-100f)));
        const core::Mask<Real> lit = pdf > Real(0);
        return {wi, wi, core::select(lit, weight, core::Rgb<Real>(Real(0))), core::select(lit, pdf, Real(0))};
    }

    Seen<Real> seen(const core::Vec3<Real>& wi) const {
        const Real sine = core::sqrt(wi.x * wi.x + wi.z * wi.z);
        const Real v = core::atan2<Real>(sine, wi.y) * Real(1 / core::pi);
        const Real u = core::atan2<Real>(wi.x, -wi.z) * Real(1 / (2 * core::pi)) + Real(0.5f) + turns;
        const Real around = core::select(u >= Real(1), u - Real(1), u);
        const auto place = grid->at(core::min(core::max(around, Real(0)), Real(1)), core::min(v, Real(1)));
        return {place.radiance * unit, pdfWOf(place.density, sine)};
    }

    // As AreaLight has it.
    void divideBy(const Real& times) { unit = core::select(times > Real(0), unit / times, Real(0)); }

    // The irradiance that an even sky as bright would bring.
    double power() const { return M_PI * grid->mean() * double{unit}; }

private:
    // u is an angle over 2 pi and v one over pi: dw = 2 pi^2 sin(angle from above) du dv.
    static Real pdfWOf(const Real& density, const Real& sine) {
        return density / core::max(Real(2 * core::pi * core::pi) * sine, Real(0x1p-60f));
    }
};
using SkyLight = SkyLightOf<float>;

}  // namespace gr
