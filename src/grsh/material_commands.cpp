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
    const core::Rgbf diffuse = call.words.colour(1, "kd", core::unitInterval);
    const core::Rgbf specular = call.words.colour(2, "ks", core::unitInterval);
    const double exponent = call.words.number(3, "exponent", {.least = 0, .most = materials::Shirley::mostExponent});
    if (specular == core::Rgbf(0)) return materials::Diffuse{.reflectance = diffuse};
    return materials::Shirley{
        .diffuse = diffuse, .specular = specular, .exponents = core::Vec2f(static_cast<float>(exponent))};
}

// Ways to go on that the material cannot take give black samples: asked for by mistake, most likely.
void warnOfBlackSamples(Call& call, const materials::Material& material) {
    constexpr std::array<std::string_view, 4> methods{"diffuse", "reflective", "refractive", "Shirley"};
    std::visit(
        [&]<class M>(const M& m) {
            std::string black;
            for (std::size_t i = 0; i < methods.size(); ++i)
                if (m.sampling && (*m.sampling)[i] > 0 && !M::canSample[i])
                    black += (black.empty() ? "" : " and ") + std::string(methods[i]);
            if (!black.empty())
                warn(call, "gr_material: " + quoted(call.words.text(0)) + " is " + std::string(M::typeName) + ": its " +
                               black + " samples are black");
        },
        material);
}

Tcl_Obj* makeMaterial(Call& call) {
    const bool older = call.words.size() == 4 && call.words.listLength(1) != 1;
    const materials::Material material = older ? readOlderForm(call) : readTyped(call);
    call.session.database.addMaterial(call.words.text(0), material);
    warnOfBlackSamples(call, material);
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
