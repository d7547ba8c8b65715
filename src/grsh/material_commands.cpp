#include "grsh/css_colours.h"
#include "grsh/option_words.h"
#include "grsh/redefine.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace grsh {
namespace {

std::vector<std::string_view> typeNames() {
    std::vector<std::string_view> names;
    materials::forEachMaterialType([&]<class M>() { names.push_back(M::typeName); });
    return names;
}

// type ?option value ...?, from word `first` on.
materials::Material readTyped(Call& call, std::size_t first) {
    const std::string type(call.words.text(first));
    std::optional<materials::Material> material;
    materials::forEachMaterialType([&]<class M>() {
        if (type != M::typeName) return;
        M parameters;
        readOptions(call.words, first + 1, "a " + type + " material has no option", parameters, &call.session.database);
        material = parameters;
    });
    if (material) return *material;
    checkRedefineSpelling(call);
    // Of as many words as the older form has, the first may be a colour.
    std::vector<std::string_view> near = typeNames();
    if (call.words.size() == first + 3) std::ranges::copy(cssColourNames(), std::back_inserter(near));
    throw core::Error("MATERIAL", "TYPE", type,
                      "no such type " + quoted(type) + core::didYouMean(type, near) + ": must be " +
                          core::listed(typeNames()) + ", or {kd} {ks} exponent");
}

// {kd} {ks} exponent, from word `first` on: the course's older form. Without a highlight it is a diffuse material.
materials::Material readOlderForm(Call& call, std::size_t first) {
    const core::Rgbf kd = call.words.colour(first, "kd", core::unitInterval);
    const core::Rgbf ks = call.words.colour(first + 1, "ks", core::unitInterval);
    const core::Range range{.least = 0, .most = materials::Shirley::mostExponent};
    const double exponent = call.words.number(first + 2, "exponent", range);
    if (ks == core::Rgbf(0)) return materials::Diffuse{.reflectance = kd};
    return materials::Shirley{
        .diffuse = kd, .specular = ks, .exponents = core::Vec2f(static_cast<float>(exponent)), .keepDiffuse = true};
}

// Ways to go on that the material cannot take give black samples: asked for by mistake, most likely.
void warnOfBlackSamples(Call& call, std::string_view name, const materials::Material& material) {
    constexpr std::array<std::string_view, 4> methods{"diffuse", "reflective", "refractive", "Shirley"};
    std::visit(
        [&]<class M>(const M& m) {
            std::string black;
            for (std::size_t i = 0; i < methods.size(); ++i)
                if (m.sampling && (*m.sampling)[i] > 0 && !M::canSample[i])
                    black += (black.empty() ? "" : " and ") + std::string(methods[i]);
            if (!black.empty())
                warn(call, "gr_material: " + quoted(name) + " is " + std::string(M::typeName) + ": its " + black +
                               " samples are black");
        },
        material);
}

// gr_material ?-redefine? name type ?option value ...?, or name {kd} {ks} exponent
Tcl_Obj* makeMaterial(Call& call) {
    const bool changes = redefines(call);
    const std::size_t name = changes ? 1 : 0, first = name + 1;
    if (call.words.size() <= first) throwWrongWords();
    const bool older = call.words.size() == first + 3 && call.words.isColour(first);
    const materials::Material material = older ? readOlderForm(call, first) : readTyped(call, first);
    const std::string words = call.words.textFrom(first);
    std::string made(call.words.text(name));
    if (changes)
        call.session.database.redefineMaterial(made, material, words);
    else
        made = call.session.database.addMaterial(made, material, words);
    warnOfBlackSamples(call, made, material);
    return textObject(made);
}

Tcl_Obj* removeMaterial(Call& call) {
    call.session.database.removeMaterial(call.words.text(0));
    return nullptr;
}

Tcl_Obj* setMaterial(Call& call) {
    call.session.database.setMaterial(call.words.text(0), call.words.text(1));
    return nullptr;
}

constexpr std::array<Command, 3> rows{{
    {"gr_material", "", "?-redefine? name type ?option value ...?", 2, anyNumberOfWords, makeMaterial,
     "makes or changes a material; the older form {kd} {ks} exponent in place of type and options still works",
     "-redefine makes another of one that there is, for all nodes that have it"},
    {"gr_delete_material", "", "name", 1, 1, removeMaterial, "deletes a material that no node has"},
    {"gr_surfaceproperty", "gr_set_material", "node material", 2, 2, setMaterial,
     "gives a node, and what is below it without a material of its own, a material"},
}};

}  // namespace

std::span<const Command> materialCommands() {
    return rows;
}

std::vector<OptionHelp> materialOptionsHelp() {
    std::vector<OptionHelp> options;
    materials::forEachMaterialType([&]<class M>() {
        for (OptionHelp& option : optionsHelp(M::options(), M::typeName)) options.push_back(std::move(option));
    });
    return options;
}

}  // namespace grsh
