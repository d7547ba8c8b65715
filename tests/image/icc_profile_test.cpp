// Which profiles mean sRGB.
#include "image/icc_profile.h"

#include "image/icc_samples.h"

#include <gmock/gmock.h>

namespace image {
namespace {

ProfileBytes bytesOf(const std::string& profile) {
    return {reinterpret_cast<const std::uint8_t*>(profile.data()), profile.size()};
}

bool isSrgb(const std::string& profile) {
    return isSrgbProfile(bytesOf(profile));
}

TEST(IccProfile, OfSrgbIsToldByItsColoursAndCurves) {
    EXPECT_TRUE(isSrgb(profileOf("RGB ", rgbTags(srgbCurve()))));
    EXPECT_TRUE(isSrgb(profileOf("RGB ", rgbTags(tableCurve(1024, decodeSrgb)))));
    // As small as some make it.
    EXPECT_TRUE(isSrgb(profileOf("RGB ", rgbTags(tableCurve(26, decodeSrgb)))));
    EXPECT_TRUE(isSrgb(profileOf("GRAY", {{"kTRC", srgbCurve()}})));
    const std::string withTail = parametricCurve(4, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045, 0, 0});
    EXPECT_TRUE(isSrgb(profileOf("RGB ", rgbTags(withTail))));
}

TEST(IccProfile, OfOtherCurvesIsNot) {
    for (const std::string& curve :
         {powerCurve(2.2), powerCurve(1), powerCurve(1.8), parametricCurve(0, {2.2}), parametricCurve(1, {2.4, 1, 0}),
          parametricCurve(9, {2.4}), std::string("curv") + bigEndian(0) + bigEndian(0),
          std::string("curv") + bigEndian(0) + bigEndian(4'000'000'000), std::string("text"), std::string()})
        EXPECT_FALSE(isSrgb(profileOf("RGB ", rgbTags(curve)))) << testing::PrintToString(curve);
}

TEST(IccProfile, OfOtherColoursIsNot) {
    // Display P3 and Adobe RGB, relative to D50.
    const ProfileColours p3{{0.5151, 0.2412, -0.0011}, {0.2920, 0.6922, 0.0419}, {0.1571, 0.0666, 0.7841}};
    const ProfileColours adobe{{0.60974, 0.31111, 0.01947}, {0.20528, 0.62567, 0.06087}, {0.14919, 0.06322, 0.74457}};
    EXPECT_FALSE(isSrgb(profileOf("RGB ", rgbTags(srgbCurve(), p3))));
    EXPECT_FALSE(isSrgb(profileOf("RGB ", rgbTags(srgbCurve(), adobe))));
    for (const char* missing : {"rXYZ", "gXYZ", "bXYZ", "rTRC", "gTRC", "bTRC"}) {
        Tags tags = rgbTags(srgbCurve());
        std::erase_if(tags, [&](const auto& tag) { return tag.first == missing; });
        EXPECT_FALSE(isSrgb(profileOf("RGB ", tags))) << missing;
    }
    Tags tags = rgbTags(srgbCurve());
    tags.emplace_back("A2B0", "mft2");
    EXPECT_FALSE(isSrgb(profileOf("RGB ", tags)));
    EXPECT_FALSE(isSrgb(profileOf("CMYK", rgbTags(srgbCurve()))));
}

// Whatever is cut off or changed, nothing outside is read (a sanitizer tells); and of every beginning none is sRGB.
TEST(IccProfile, ThatIsBrokenIsNot) {
    const std::string whole = profileOf("RGB ", rgbTags(srgbCurve()));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + std::ptrdiff_t(length));
        EXPECT_FALSE(isSrgbProfile(cut)) << length;
        nameOfProfile(cut);
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::vector<std::uint8_t> changed(whole.begin(), whole.end());
        changed[i] ^= 0xFF;
        isSrgbProfile(changed);
        nameOfProfile(changed);
    }
}

TEST(IccProfile, IsCalledByItsDescription) {
    EXPECT_EQ(nameOfProfile(bytesOf(profileOf("RGB ", rgbTags(srgbCurve())))), "Mine");
    EXPECT_EQ(nameOfProfile(bytesOf(profileOf("RGB ", {{"desc", descriptionTag("sRGB built-in", false)}}))),
              "sRGB built-in");
    EXPECT_EQ(nameOfProfile(bytesOf(profileOf("RGB ", {{"desc", descriptionTag("Gr\xfcn\n")}}))), "Gr?n?");
    EXPECT_EQ(nameOfProfile(bytesOf(profileOf("RGB ", {}))), "");
}

}  // namespace
}  // namespace image
