// Measurements by the names of other programs give a mannequin, and tell what was used and what was not.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/mannequin/from_measurements.h"

namespace selvedge::sim {
namespace {

bool lists(const std::vector<std::string>& lines, const std::string& begin) {
    return std::ranges::any_of(lines, [&](const std::string& line) { return line.starts_with(begin); });
}

TEST(FromMeasurements, freesewing_gives_girths_and_a_height_from_the_back) {
    const std::vector<NamedLength> lengths{
        {"chest", 0.925},       {"underbust", 0.78},       {"waist", 0.75},   {"hips", 0.9},     {"seat", 1.01},
        {"waistToFloor", 1.05}, {"hpsToWaistBack", 0.395}, {"inseam", 0.765}, {"bustSpan", 0.16}};
    const MannequinFit fit = mannequin_from_measurements(lengths);
    const MannequinMeasures& measures = fit.options.measures;
    EXPECT_EQ(fit.options.sex, Sex::Female);
    EXPECT_DOUBLE_EQ(measures.bust.value(), 0.925);
    EXPECT_DOUBLE_EQ(measures.hip.value(), 1.01);
    EXPECT_DOUBLE_EQ(measures.high_hip.value(), 0.9);
    EXPECT_NEAR(measures.height.value(), 1.445 / 0.87, 1e-4);
    EXPECT_DOUBLE_EQ(measures.inseam.value(), 0.765);
    EXPECT_DOUBLE_EQ(measures.waist_height.value(), 1.05);
    EXPECT_TRUE(lists(fit.derived, "height 166.1 cm, from waistToFloor + hpsToWaistBack"));
    EXPECT_TRUE(lists(fit.used, "high_hip 90.0 cm (hips)"));
    EXPECT_EQ(fit.ignored, std::vector<std::string>{"bustSpan"});
    EXPECT_TRUE(lists(fit.guessed, "neck"));
    EXPECT_FALSE(lists(fit.guessed, "bust"));
}

TEST(FromMeasurements, garmentcode_and_valentina_names_are_known) {
    const MannequinFit code = mannequin_from_measurements(std::vector<NamedLength>{{"height", 1.72},
                                                                                   {"bust", 0.998},
                                                                                   {"hips", 1.035},
                                                                                   {"waist", 0.843},
                                                                                   {"head_l", 0.263},
                                                                                   {"waist_line", 0.369},
                                                                                   {"hips_line", 0.235},
                                                                                   {"crotch_hip_diff", 0.088},
                                                                                   {"leg_circ", 0.602}});
    EXPECT_DOUBLE_EQ(code.options.measures.hip.value(), 1.035);  // widest, as it has no seat
    EXPECT_NEAR(code.options.measures.inseam.value(), 0.765, 1e-9);
    EXPECT_NEAR(code.options.measures.waist_height.value(), 1.72 - 0.263 - 0.369, 1e-9);
    const MannequinFit vit = mannequin_from_measurements(
        std::vector<NamedLength>{{"height", 1.75}, {"bust_circ", 0.96}, {"highhip_circ", 0.9}, {"arm_upper_circ", 0.3}},
        Sex::Male);
    EXPECT_EQ(vit.options.sex, Sex::Male);
    EXPECT_DOUBLE_EQ(vit.options.measures.biceps.value(), 0.3);
    EXPECT_DOUBLE_EQ(vit.options.measures.high_hip.value(), 0.9);
    EXPECT_FALSE(lists(vit.guessed, "sex"));
}

TEST(FromMeasurements, values_that_no_mannequin_has_are_refused_and_told) {
    const MannequinFit fit = mannequin_from_measurements(
        std::vector<NamedLength>{{"height", 1.7}, {"chest", 9.25}, {"waist", -1}, {"inseam", 0.6}});
    EXPECT_FALSE(fit.options.measures.bust);
    EXPECT_FALSE(fit.options.measures.waist);
    EXPECT_FALSE(fit.options.measures.inseam);  // 35 % of the height
    EXPECT_TRUE(lists(fit.refused, "bust 925.0 cm (chest)"));
    EXPECT_TRUE(lists(fit.refused, "inseam 60.0 cm"));
}

TEST(FromMeasurements, a_height_that_is_not_given_follows_from_the_lengths_that_are) {
    const auto height_of = [](const std::vector<NamedLength>& lengths) {
        return mannequin_from_measurements(lengths).options.measures.height.value_or(0);
    };
    EXPECT_NEAR(height_of({{"waistToFloor", 1.05}, {"hpsToWaistBack", 0.395}, {"inseam", 0.80}}), 1.445 / 0.87, 1e-4);
    EXPECT_NEAR(height_of({{"waistToFloor", 1.05}, {"inseam", 0.80}}), 1.05 / 0.63, 1e-4);
    EXPECT_NEAR(height_of({{"height_neck_back", 1.45}}), 1.45 / 0.86, 1e-4);
    EXPECT_NEAR(height_of({{"inseam", 0.80}, {"shoulderToWrist", 0.60}}), 0.80 / 0.48, 1e-4);
    EXPECT_NEAR(height_of({{"shoulderToWrist", 0.60}}), 0.60 / 0.34, 1e-4);
    EXPECT_EQ(height_of({{"chest", 0.9}}), 0) << "the base body's";
    // What gives no height that a mannequin can have is left.
    EXPECT_NEAR(height_of({{"waistToFloor", 1.307}, {"hpsToWaistBack", 0.566}}), 1.307 / 0.63, 1e-4);
    EXPECT_NEAR(height_of({{"height", 1.7}, {"inseam", 0.80}}), 1.7, 1e-9);
}

TEST(FromMeasurements, text_of_a_mannequin_is_read_back) {
    MannequinOptions options{.sex = Sex::Male, .measures = {.height = 1.805, .bust = 1.105, .waist = 0.8825}};
    EXPECT_EQ(mannequin_text(options), "mannequin:sex=male,height=180.50,bust=110.50,waist=88.25");
    const MannequinOptions read = parse_mannequin(mannequin_text(options));
    EXPECT_EQ(read.sex, Sex::Male);
    EXPECT_NEAR(read.measures.waist.value(), 0.8825, 1e-9);
}

}  // namespace
}  // namespace selvedge::sim
