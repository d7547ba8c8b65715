#include "grsh/commands.h"

#include <array>

namespace grsh {
namespace {

Tcl_Obj* makeLight(Call& call) {
    constexpr core::Range amount{.least = 0, .most = 1e18};
    gr::PointLight light;
    light.position = core::Vec3f(call.words.vector(1, "position", {.least = -1e18, .most = 1e18}));
    light.intensity = call.words.colour(2, "intensity", amount);
    light.attenuation = core::Vec3f(call.words.vector(3, "attenuation", amount));
    if (light.attenuation == core::Vec3f(0)) throwBadValue("attenuation", "other than all 0", call.words.object(3));
    call.session.database.addLight(call.words.text(0), light);
    return nullptr;
}

constexpr std::array<Command, 1> rows{{
    {"gr_light", "", "name {x y z} {r g b} {c0 c1 c2}", 4, 4, makeLight,
     "makes a point light; at distance d it shows a white surface {r g b}/(c0 + c1 d + c2 d^2) bright"},
}};

}  // namespace

std::span<const Command> lightCommands() {
    return rows;
}

}  // namespace grsh
