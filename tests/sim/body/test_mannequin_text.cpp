#include <gtest/gtest.h>

#include <numbers>

#include "sim/body/mannequin.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

// The message of the error that `text` gives; empty when it is accepted.
std::string refusal(const char* text) {
    try {
        parse_mannequin(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ParseMannequin, reads_centimetres) {
    const MannequinOptions options = parse_mannequin("mannequin:sex=male,height=178.5,bust=100,hip=98,resolution=1");
    EXPECT_EQ(options.sex, Sex::Male);
    EXPECT_EQ(options.subdivisions, 1);
    EXPECT_DOUBLE_EQ(options.measures.height.value(), 1.785);
    EXPECT_DOUBLE_EQ(options.measures.bust.value(), 1.0);
    EXPECT_DOUBLE_EQ(options.measures.hip.value(), 0.98);
    EXPECT_FALSE(options.measures.waist.has_value());
}

TEST(ParseMannequin, reads_the_stance_in_degrees) {
    EXPECT_FALSE(parse_mannequin("mannequin").stance.has_value());
    EXPECT_NEAR(parse_mannequin("mannequin:stance=1.5").stance.value(), 0.0261799, 1e-7);
    EXPECT_EQ(parse_mannequin("mannequin:stance=0").stance.value(), 0);
    EXPECT_EQ(parse_mannequin("mannequin:stance=10").stance.value(), 10 * std::numbers::pi / 180);
    EXPECT_EQ(refusal("mannequin:stance=12"), "mannequin: stance: 12 degrees is not between 0 and 10 degrees");
    EXPECT_EQ(refusal("mannequin:stance=wide"), "mannequin: stance: 'wide' is not a number");
    EXPECT_NE(refusal("mannequin:stance=1,stance=2").find("given twice"), std::string::npos);
}

TEST(ParseMannequin, takes_nothing_for_the_default_body) {
    for (const char* text : {"mannequin", "mannequin:"}) {
        const MannequinOptions options = parse_mannequin(text);
        EXPECT_EQ(options.sex, Sex::Female);
        EXPECT_EQ(options.subdivisions, 2);
        EXPECT_FALSE(options.measures.bust.has_value());
    }
}

TEST(ParseMannequin, knows_hips_as_hip) {
    EXPECT_DOUBLE_EQ(parse_mannequin("mannequin:hips=103.5").measures.hip.value(), 1.035);
    EXPECT_NE(refusal("mannequin:hip=100,hips=101").find("given twice"), std::string::npos);
}

TEST(ParseMannequin, knows_every_measure_by_its_name) {
    EXPECT_EQ(measure_names().size(), 19U);
    MannequinMeasures measures;
    for (const std::string_view name : measure_names()) {
        std::optional<double>* measure = find_measure(measures, name);
        ASSERT_NE(measure, nullptr);
        EXPECT_FALSE(measure->has_value()) << name << " stands for the same measure as another name";
        *measure = 1;
    }
    EXPECT_EQ(find_measure(measures, "cup"), nullptr);
}

TEST(ParseMannequin, says_what_is_wrong) {
    EXPECT_EQ(refusal("mannequin:bust=5"), "mannequin: bust: 5 cm is not between 70 cm and 150 cm");
    EXPECT_EQ(refusal("mannequin:bust=big"), "mannequin: bust: 'big' is not a number");
    EXPECT_EQ(refusal("mannequin:bust=92cm"), "mannequin: bust: '92cm' is not a number");
    EXPECT_EQ(refusal("mannequin:bust=nan"), "mannequin: bust: 'nan' is not a number");
    EXPECT_EQ(refusal("mannequin:bust="), "mannequin: bust: '' is not a number");
    EXPECT_EQ(refusal("mannequin:sex=woman"), "mannequin: sex: 'woman' is neither female nor male");
    EXPECT_EQ(refusal("mannequin:bust"), "mannequin: bust: 'name=value' expected");
    EXPECT_EQ(refusal("mannequin:resolution=2.5"), "mannequin: resolution: '2.5' is not a number of steps");
    EXPECT_EQ(refusal("mannequin:resolution=7"),
              "mannequin: resolution: 7 is not between 1 and 4 steps of subdivision");
    EXPECT_NE(refusal("mannequin:busst=92").find("busst: no such measure; known are sex, resolution, stance, height"),
              std::string::npos);
    EXPECT_NE(refusal("mannequin:bust=90,,").find("'name=value' expected"), std::string::npos);
    EXPECT_NE(refusal("mannequins").find("':' expected"), std::string::npos);
    EXPECT_NE(refusal("body.glb").find("expected"), std::string::npos);
}

}  // namespace
}  // namespace selvedge
