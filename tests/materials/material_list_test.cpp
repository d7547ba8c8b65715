#include "materials/material.h"

#include <gtest/gtest.h>

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
    EXPECT_EQ(std::get<Diffuse>(Material{}).reflectance, core::Rgbf(0.5f));
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
    bool operator()(const std::optional<int>& x) const { return !x || range.contains(*x); }
    bool operator()(core::Word) const { return true; }
};

TYPED_TEST(MaterialOptions, HaveNamesHelpAndDefaultsWithinTheirRange) {
    std::set<std::string_view> names;
    for (const core::OptionRow<TypeParam>& row : TypeParam::options()) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), std::string_view::npos) << row.name;
        EXPECT_TRUE(names.insert(row.name).second) << row.name << " is there twice";
        EXPECT_FALSE(row.help.empty()) << row.name;
        EXPECT_NE(core::typeText(row), "") << row.name;
        const TypeParam defaults;
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

TEST(DiffuseOptions, AreTheReflectance) {
    const auto rows = Diffuse::options();
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].name, "diffuse");
    EXPECT_EQ(core::typeText(rows[0]), "{r g b}");
    EXPECT_EQ(core::rangeText(rows[0].range), "0 to 1");
    EXPECT_EQ(core::defaultText(rows[0]), "{0.5 0.5 0.5}");
}

}  // namespace
}  // namespace materials
