#include "grsh/redefine.h"

#include <array>

namespace grsh {
namespace {

// gr_light ?-redefine? name {x y z} {r g b} {c0 c1 c2}
Tcl_Obj* makeLight(Call& call) {
    constexpr core::Range amount{.least = 0, .most = 1e18};
    const bool changes = redefines(call);
    if (call.words.size() == 5) checkRedefineSpelling(call);
    if (changes != (call.words.size() == 5)) throwWrongWords();
    const std::size_t name = changes ? 1 : 0;
    gr::PointLight light;
    light.position = core::Vec3f(call.words.vector(name + 1, "position", {.least = -1e18, .most = 1e18}));
    light.intensity = call.words.colour(name + 2, "intensity", amount);
    light.attenuation = core::Vec3f(call.words.vector(name + 3, "attenuation", amount));
    if (light.attenuation == core::Vec3f(0))
        throwBadValue("attenuation", "other than all 0", call.words.object(name + 3));
    std::string made(call.words.text(name));
    if (changes)
        call.session.database.redefineLight(made, light);
    else
        made = call.session.database.addLight(made, light);
    return textObject(made);
}

Tcl_Obj* removeLight(Call& call) {
    call.session.database.removeLight(call.words.text(0));
    return nullptr;
}

constexpr std::array<Command, 2> rows{{
    {"gr_light", "", "?-redefine? name {x y z} {r g b} {c0 c1 c2}", 4, 5, makeLight,
     "makes or changes a point light; at distance d it shows a white surface {r g b}/(c0 + c1 d + c2 d^2) bright",
     "-redefine makes another of one that there is; lights shine in the renders that name them"},
    {"gr_delete_light", "", "name", 1, 1, removeLight, "deletes a point light"},
}};

}  // namespace

std::span<const Command> lightCommands() {
    return rows;
}

}  // namespace grsh
