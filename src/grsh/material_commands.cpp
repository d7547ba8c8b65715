#include "grsh/commands.h"
#include "grsh/option_words.h"

#include <array>

namespace grsh {
namespace {

std::vector<std::string_view> typeNames() {
    std::vector<std::string_view> names;
    materials::forEachMaterialType([&]<class M>() { names.push_back(M::typeName); });
    return names;
}

// gr_material name type ?option value ...?
materials::Material readTyped(Call& call) {
    const std::string type(call.words.text(1));
    std::optional<materials::Material> material;
    materials::forEachMaterialType([&]<class M>() {
        if (type != M::typeName) return;
        M parameters;
        readOptions(call.words, 2, "a " + type + " material has no option", parameters);
        material = parameters;
    });
    if (material) return *material;
    throw core::Error("MATERIAL", "TYPE", type,
                      "no such type " + quoted(type) + core::didYouMean(type, typeNames()) + ": must be " +
                          core::listed(typeNames()) + ", or {kd} {ks} exponent");
}

// gr_material name {kd} {ks} exponent: the course's older form. Without specular reflection it is a diffuse material.
materials::Material readOlderForm(Call& call) {
    materials::Diffuse diffuse;
    diffuse.reflectance = call.words.colour(1, "kd", core::unitInterval);
    const core::Rgbf specular = call.words.colour(2, "ks", core::unitInterval);
    call.words.number(3, "exponent", core::notNegative);
    if (specular != core::Rgbf(0)) throwBadValue("ks", "black, {0 0 0}", call.words.object(2));
    return diffuse;
}

Tcl_Obj* makeMaterial(Call& call) {
    const bool older = call.words.size() == 4 && call.words.listLength(1) != 1;
    call.session.database.addMaterial(call.words.text(0), older ? readOlderForm(call) : readTyped(call));
    return nullptr;
}

Tcl_Obj* setMaterial(Call& call) {
    call.session.database.setMaterial(call.words.text(0), call.words.text(1));
    return nullptr;
}

constexpr std::array<Command, 2> rows{{
    {"gr_material", "", "name type ?option value ...?", 2, anyNumberOfWords, makeMaterial,
     "makes a material; the older form {kd} {ks} exponent in place of type and options still works"},
    {"gr_surfaceproperty", "gr_set_material", "node material", 2, 2, setMaterial,
     "gives a node, and what is below it without a material of its own, a material"},
}};

}  // namespace

std::span<const Command> materialCommands() {
    return rows;
}

std::string materialOptionsHelp() {
    std::string text;
    materials::forEachMaterialType(
        [&]<class M>() { text += "type " + std::string(M::typeName) + ":\n" + optionsHelp(M::options()); });
    return text;
}

}  // namespace grsh
