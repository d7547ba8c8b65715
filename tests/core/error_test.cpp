#include "core/error.h"

#include <gtest/gtest.h>

namespace core {
namespace {

using Words = std::vector<std::string_view>;

TEST(Error, CarriesTheErrorCodeAndTheMessage) {
    const Error error("NODE", "UNKNOWN", ":arn", "no such node \":arn\"");
    EXPECT_EQ(error.topic, "NODE");
    EXPECT_EQ(error.reason, "UNKNOWN");
    EXPECT_EQ(error.word, ":arn");
    EXPECT_STREQ(error.what(), "no such node \":arn\"");
}

TEST(Nearest, FindsALetterChangedAddedLeftOutOrSwapped) {
    const Words colours{"silver", "gold", "copper"};
    EXPECT_EQ(nearest("bold", colours), "gold");
    EXPECT_EQ(nearest("goold", colours), "gold");
    EXPECT_EQ(nearest("gld", colours), "gold");
    EXPECT_EQ(nearest("glod", colours), "gold");
    EXPECT_EQ(nearest("old", colours), "gold");
    EXPECT_EQ(nearest("golds", colours), "gold");
    EXPECT_EQ(nearest("gold", colours), "gold");
}

// One mistake for every three letters, and one in shorter words.
TEST(Nearest, LeavesOutWhatIsTooFarToBeMeant) {
    const Words options{"pathlength"};
    EXPECT_EQ(nearest("pahtlenght", options), "pathlength");
    EXPECT_EQ(nearest("pothlen", options), "");
    EXPECT_EQ(nearest("pathlengths", options), "pathlength");
    EXPECT_EQ(nearest("bathlendth", options), "pathlength");
    EXPECT_EQ(nearest("bithlendth", options), "pathlength");
    EXPECT_EQ(nearest("bithlendsh", options), "");
    EXPECT_EQ(nearest("gauld", Words{"gold"}), "");
    EXPECT_EQ(nearest("on", Words{"of"}), "of");
    EXPECT_EQ(nearest("on", Words{"if"}), "");
}

// Where every letter differs there is no likeness, however short the word.
TEST(Nearest, NeverSuggestsAWordThatHasNoLetterInCommon) {
    EXPECT_EQ(nearest("x", Words{"y"}), "");
    EXPECT_EQ(nearest("", Words{"a", ""}), "");
    EXPECT_EQ(nearest("abc", {}), "");
}

TEST(Nearest, CountsNoCapitals) {
    EXPECT_EQ(nearest("PANORAMA", Words{"perspective", "panorama"}), "panorama");
    EXPECT_EQ(nearest("Glod", Words{"silver", "gold"}), "gold");
    EXPECT_EQ(nearest(":LEG", Words{":Leg", ":arm"}), ":Leg");
}

TEST(Nearest, FindsAnAbbreviationOfOneWordOnly) {
    const Words options{"perspective", "orthographic", "samplesperpixel", "samplesperlightsource"};
    EXPECT_EQ(nearest("ortho", options), "orthographic");
    EXPECT_EQ(nearest("Pers", options), "perspective");
    EXPECT_EQ(nearest("samplesperp", options), "samplesperpixel");
    EXPECT_EQ(nearest("samples", options), "");
    EXPECT_EQ(nearest("or", options), "");
    EXPECT_EQ(nearest("gr_dif", Words{"gr_disc", "gr_difference"}), "gr_difference");
    EXPECT_EQ(nearest("gr_dis", Words{"gr_disc", "gr_distance"}), "gr_disc");
    EXPECT_EQ(nearest("ort", Words{"orthographic", "orthographic"}), "orthographic");
}

TEST(Nearest, PrefersFewerMistakesAndThenTheFirst) {
    EXPECT_EQ(nearest("startlime", Words{"stoplime", "startline", "starline"}), "startline");
    EXPECT_EQ(nearest("startlint", Words{"startling", "startline"}), "startling");
    EXPECT_EQ(nearest("startlint", Words{"startline", "startling"}), "startline");
}

TEST(DidYouMean, QuotesTheNearestWord) {
    EXPECT_EQ(didYouMean(":arn", Words{":leg", ":arm"}), " (did you mean \":arm\"?)");
    EXPECT_EQ(didYouMean("gld", Words{"gold"}), " (did you mean \"gold\"?)");
    EXPECT_EQ(didYouMean("granite", Words{"gold"}), "");
}

TEST(Listed, PutsOrBeforeTheLast) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed(Words{"on"}), "on");
    EXPECT_EQ(listed(Words{"on", "off"}), "on or off");
    EXPECT_EQ(listed(Words{"a", "b", "c"}), "a, b or c");
    EXPECT_EQ(listed(Words{"a", "b", "c", "d"}), "a, b, c or d");
}

}  // namespace
}  // namespace core
