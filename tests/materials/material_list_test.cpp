#include "materials/material.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "materials/parameter_sets.h"

namespace materials {
namespace {

TEST(MaterialList, IsWalkedTypeByType) {
    std::vector<std::size_t> indices;
    std::set<std::string_view> names;
    forEachMaterialType([&]<class M>() {
        indices.push_back(Material(M{}).index());
        names.insert(M::typeName);
    });
    ASSERT_EQ(indices.size(), std::variant_size_v<Material>);
    for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(indices[i], i);
    EXPECT_EQ(names.size(), indices.size()) << "two materials have one name";
}

// A node without a material of its own is diffuse grey.
TEST(MaterialList, BeginsWithTheDefault) {
    ASSERT_TRUE(std::holds_alternative<Diffuse>(Material{}));
    EXPECT_EQ(std::get<Diffuse>(Material{}).reflectance.value, core::Rgbf(0.5f));
}

// So that a denoiser can divide by it.
TEST(MaterialList, HasAlbedosFromBlackToWhite) {
    forEachMaterialType([]<class M>() {
        for (const M& material : parameterSets<M>())
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_GE(material.template albedo<float>(SomePoint{})[channel], 0) << M::typeName;
                EXPECT_LE(material.template albedo<float>(SomePoint{})[channel], 1) << M::typeName;
            }
    });
}

// What light goes through has something behind its surface, and nothing else has. Seen to fail with a dielectric
// without.
TEST(MaterialList, HasInteriorsBehindWhatRefracts) {
    forEachMaterialType([]<class M>() {
        for (const M& material : parameterSets<M>())
            EXPECT_EQ(material.interior().has_value(), M::canSample[2]) << M::typeName;
    });
}

template<class M>
class MaterialOptions : public testing::Test {};
TYPED_TEST_SUITE(MaterialOptions, EveryMaterial, MaterialName);

struct IsWithin {
    core::Range range;
    bool operator()(double x) const { return range.contains(x); }
    bool operator()(const core::Rgbf& c) const {
        return range.contains(c.x) && range.contains(c.y) && range.contains(c.z);
    }
    bool operator()(const core::Vec2f& v) const { return range.contains(v.x) && range.contains(v.y); }
    bool operator()(const std::optional<int>& x) const { return !x || range.contains(*x); }
    bool operator()(const std::optional<core::Weights>& weights) const {
        return !weights || std::all_of(weights->begin(), weights->end(), [&](float w) { return range.contains(w); });
    }
    bool operator()(const std::optional<glm::dvec3>& v) const {
        return !v || (range.contains(v->x) && range.contains(v->y) && range.contains(v->z));
    }
    template<class Element>
    bool operator()(const std::vector<Element>& list) const {
        return std::all_of(list.begin(), list.end(), *this);
    }
    bool operator()(const glm::dvec3& v) const {
        return range.contains(v.x) && range.contains(v.y) && range.contains(v.z);
    }
    template<class Value>
    bool operator()(const core::Textured<Value>& value) const {
        return (*this)(value.value);
    }
    bool operator()(const core::ColourPair& pair) const { return (*this)(pair[0]) && (*this)(pair[1]); }
    bool operator()(const core::ColourStop& stop) const { return (*this)(stop.colour); }
    bool operator()(const core::Scaling& scaling) const { return (*this)(scaling.by); }
    bool operator()(const core::Script&) const { return true; }
    bool operator()(core::Word) const { return true; }
    bool operator()(const core::WordList&) const { return true; }
};

TYPED_TEST(MaterialOptions, HaveNamesHelpAndDefaultsWithinTheirRange) {
    std::set<std::string_view> names;
    for (const core::OptionRow<TypeParam>& row : TypeParam::options()) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), std::string_view::npos) << row.name;
        EXPECT_TRUE(names.insert(row.name).second) << row.name << " is there twice";
        EXPECT_FALSE(row.help.empty()) << row.name;
        EXPECT_NE(core::typeText(row), "") << row.name;
        static const TypeParam defaults;
        const auto isWithin = [&](auto member) { return IsWithin{row.range}(defaults.*member); };
        EXPECT_TRUE(std::visit(isWithin, row.member)) << row.name << ": " << core::defaultText(row);
    }
}

TYPED_TEST(MaterialOptions, HoldForTheTestsOwnParameters) {
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        for (const core::OptionRow<TypeParam>& row : TypeParam::options()) {
            const auto isWithin = [&](auto member) { return IsWithin{row.range}(material.*member); };
            EXPECT_TRUE(std::visit(isWithin, row.member)) << row.name << ": " << core::optionText(row, material);
        }
    }
}

// The names that scenes are written with, and what they take.
template<class M>
std::vector<std::string> described() {
    std::vector<std::string> texts;
    for (const auto& row : M::options())
        texts.push_back(std::string(row.name) + " " + core::typeText(row) + ", " + core::rangeText(row.range));
    return texts;
}

TEST(MaterialOptions, AreThoseOfTheSceneLanguage) {
    using Texts = std::vector<std::string>;
    const std::string sampling = "sampling {a b c d}, at least 0";
    const std::string perturbation = "perturbation number, greater than 0 and at most 90";
    EXPECT_EQ(described<Diffuse>(), (Texts{"diffuse {r g b}|texture, 0 to 1", sampling, perturbation}));
    EXPECT_EQ(described<Shirley>(),
              (Texts{"diffuse {r g b}|texture, 0 to 1", "specular {r g b}|texture, 0 to 1",
                     "exp {nu nv}|texture, 0 to 1000000", "keepdiffuse on/off, ", sampling, perturbation}));
    EXPECT_EQ(described<Dielectric>(),
              (Texts{"specular {r g b}|texture, 0 to 1", "n number, greater than 0 and at most 1000000",
                     "beers {ar ag ab}, 0 to 1e+18", sampling, "perturbation number, 0 to 90"}));
}

}  // namespace
}  // namespace materials
