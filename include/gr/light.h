// THE list of lights. To add one: write its header in gr/lights/ beside point_light.h, with all that CompleteLight asks
// for, and add its name to Lights. Both integrators, the tree over lights, the fingerprint, the count of bytes and the
// print-out walk this list.
#pragma once

#include "gr/lights/area_light.h"
#include "gr/lights/point_light.h"
#include "gr/lights/sky_light.h"
#include "gr/lights/spot_light.h"
#include "gr/lights/sun_light.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

namespace gr {

// One kind at a time, so that the compiler says which lacks what.
template<class Kind>
struct KindOfLight {
    static_assert(CompleteLight<Kind>, "a light of the list lacks something: what, the compiler says here");
    static constexpr bool isComplete = true;
};

// Lights of some kinds, an array for each kind, so that lanes can gather from it. A light's index counts those of the
// kinds before it, too.
template<class... Kinds>
class LightList {
    static_assert((KindOfLight<Kinds>::isComplete && ...));
    // So that what is made of the others alone can count them from 0.
    static_assert(std::ranges::is_sorted(std::array{Kinds::isEndless...}), "endless kinds stand behind all others");

public:
    template<class Kind>
    std::vector<Kind>& of() {
        return std::get<std::vector<Kind>>(arrays_);
    }
    template<class Kind>
    const std::vector<Kind>& of() const {
        return std::get<std::vector<Kind>>(arrays_);
    }

    // Calls f(lights, first) for each kind: its array, and the index of the first in it.
    template<class F>
    void forEachKind(F&& f) const {
        std::size_t first = 0;
        const auto visit = [&](const auto& lights) {
            f(lights, first);
            first += lights.size();
        };
        (visit(of<Kinds>()), ...);
    }
    // Calls f(light) for each light, in the order of their indices.
    template<class F>
    void forEach(F&& f) const {
        const auto visit = [&](const auto& lights) {
            for (const auto& light : lights) f(light);
        };
        (visit(of<Kinds>()), ...);
    }

    std::size_t size() const { return (of<Kinds>().size() + ...); }
    // Those that have a place: their indices come before those of endless lights.
    std::size_t placed() const { return ((Kinds::isEndless ? 0 : of<Kinds>().size()) + ...); }
    std::size_t bytes() const { return ((of<Kinds>().capacity() * sizeof(Kinds)) + ...); }

private:
    std::tuple<std::vector<Kinds>...> arrays_;
};

using Lights = LightList<AreaLight, PointLight, SpotLight, SunLight, ParallelLight, SkyLight>;

namespace detail {

template<class Variant, class... Kinds>
struct NamedKinds {
    using Type = Variant;
};
template<class... Named, class Kind, class... Others>
struct NamedKinds<std::variant<Named...>, Kind, Others...>
    : NamedKinds<std::conditional_t<Kind::isNamed, std::variant<Named..., Kind>, std::variant<Named...>>, Others...> {};
template<class... Kinds>
typename NamedKinds<std::variant<>, Kinds...>::Type namedOf(const LightList<Kinds...>&);

template<class... As, class... Bs, class F>
void forEachPair(const std::tuple<As...>& a, const std::tuple<Bs...>& b, F&& f) {
    const auto each = [&]<std::size_t... i>(std::index_sequence<i...>) {
        (f(std::get<i>(a), std::get<i>(b)), ...);
    };
    each(std::index_sequence_for<As...>());
}

}  // namespace detail

// Of a kind that scripts give names.
using NamedLight = decltype(detail::namedOf(Lights()));

// The light of that index in its kind's array, for each lane.
template<class Real, template<class> class Light>
Light<Real> gathered(const Light<float>* lights, const core::UInt<Real>& index) {
    const core::GatheredRow<Real, Light<float>> row(lights, index);
    Light<Real> light;
    std::size_t offset = 0;
    const auto take = [&]<class Part>(Part& part, const auto& ofFirst) {
        if constexpr (std::is_pointer_v<Part>)
            part = ofFirst;  // all lights of the kind have the same
        else if constexpr (std::is_same_v<Part, Real>)
            part = row.number(offset);
        else
            part = row.vector(offset);
        offset += sizeof(ofFirst);
    };
    detail::forEachPair(Light<Real>::parts(light), Light<float>::parts(lights[0]), take);
    return light;
}
// The same light in all lanes.
template<class Real, template<class> class Light>
Light<Real> broadcast(const Light<float>& one) {
    Light<Real> light;
    const auto set = []<class Part>(Part& part, const auto& from) {
        if constexpr (std::is_pointer_v<Part>)
            part = from;
        else if constexpr (std::is_same_v<Part, Real>)
            part = Real(from);
        else
            part = core::broadcast<Real>(from);
    };
    detail::forEachPair(Light<Real>::parts(light), Light<float>::parts(one), set);
    return light;
}

}  // namespace gr
