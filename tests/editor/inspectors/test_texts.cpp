// Words and figures: fabrics, threadcounts, mannequins, drapes.
#include <gtest/gtest.h>

#include "editor/inspectors/body_text.h"
#include "editor/inspectors/drape_text.h"
#include "editor/inspectors/drape_trace.h"
#include "editor/inspectors/fabric_text.h"
#include "editor/inspectors/threadcount_text.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

std::string value_of(const Fabric& fabric, const std::string& label) {
    for (const FabricRow& row : fabric_rows(fabric)) {
        if (row.label == label) return row.value;
    }
    return "";
}

TEST(FabricText, speaks_in_units_of_the_trade) {
    const Fabric fabric;
    EXPECT_EQ(value_of(fabric, "Weight"), "120 g/m\u00B2");
    EXPECT_EQ(value_of(fabric, "Stretch"), "8000 \u00D7 5000 N/m");
    EXPECT_EQ(value_of(fabric, "Bending"), "9 \u00D7 6 \u00B5N\u00B7m");
    EXPECT_EQ(value_of(fabric, "Thickness"), "0.28 mm");
    EXPECT_EQ(value_of(fabric, "Gives up to"), "3 %");
}

TEST(FabricText, names_are_made_readable) {
    EXPECT_EQ(readable_name("wool_twill_light"), "Wool twill light");
    EXPECT_EQ(readable_name("cloths/my_wool.json"), "my_wool.json");
}

TEST(ThreadcountText, every_tartan_that_ships_is_woven_alike_from_it) {
    for (const std::string& name : shipped_tartans()) {
        const Sett sett = find_tartan(name);
        const std::string text = threadcount_of(sett);
        ASSERT_EQ(wrong_with_tartan(text), "") << name << ": " << text;
        const Sett again = find_tartan(text);
        EXPECT_EQ(thread_colours(again), thread_colours(sett)) << name << ": " << text;
        EXPECT_EQ(weft_thread_colours(again), weft_thread_colours(sett)) << name << ": " << text;
        EXPECT_EQ(again.weave, sett.weave) << name;
    }
}

TEST(ThreadcountText, tells_what_is_wrong) {
    EXPECT_NE(wrong_with_tartan("K8 ?5"), "");
    EXPECT_EQ(wrong_with_tartan("K8 W8"), "");
    Pattern pattern;
    pattern.tartan = "K8 ?5";
    EXPECT_FALSE(sett_of(pattern));
}

TEST(ThreadcountText, tartans_are_found_by_parts_of_their_words) {
    EXPECT_TRUE(has_words("Hunting Stewart", "stew hunt"));
    EXPECT_FALSE(has_words("Hunting Stewart", "stew dress"));
    EXPECT_TRUE(has_words("Hunting Stewart", ""));
}

TEST(BodyText, only_what_is_set_is_written_and_read_back) {
    MannequinOptions options{.sex = Sex::Male};
    options.measures.bust = 1.02;
    options.measures.mid_thigh = 0.525;
    options.stance = 0.0349065850398866;  // 2 degrees
    const std::string text = mannequin_text(options);
    EXPECT_EQ(text, "mannequin:sex=male,bust=102,mid_thigh=52.5,stance=2");
    EXPECT_EQ(wrong_with_body(text), "");
    EXPECT_EQ(mannequin_text(parse_mannequin(text)), text);
}

TEST(BodyText, measures_out_of_range_are_told) {
    EXPECT_NE(wrong_with_body("mannequin:bust=20").find("bust"), std::string::npos);
    EXPECT_EQ(wrong_with_body("somebody.obj"), "") << "files are tried by those who read them";
}

TEST(BodyText, every_measure_has_words) {
    for (const std::string_view name : measure_names()) EXPECT_STRNE(measure_tip(name), "") << name;
    EXPECT_EQ(measure_label("bust", Sex::Male), "Chest");
    EXPECT_EQ(measure_label("high_hip", Sex::Female), "High hip");
}

TEST(DrapeText, counts_have_commas) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1000), "1,000");
    EXPECT_EQ(count_text(1234567), "1,234,567");
}

TEST(DrapeText, rejoining_stays_below_splitting) {
    const CurvatureOptions usual;
    EXPECT_LT(curvature_with(usual, 0.05, {}).rejoin_angle, 0.05F);
    EXPECT_LT(curvature_with(usual, {}, 1.0).rejoin_angle, usual.split_angle);
    EXPECT_EQ(curvature_with(usual, {}, {}).rejoin_angle, usual.rejoin_angle);
}

TEST(DrapeText, kept_drapes_get_names_of_their_own) {
    EXPECT_EQ(free_drape_name({}, ""), "drape");
    EXPECT_EQ(free_drape_name({"drape", "drape 2"}, ""), "drape 3");
    EXPECT_EQ(free_drape_name({"wide"}, "wide"), "wide 2");
}

SessionFrame running_frame(std::uint64_t number) {
    SessionFrame frame;
    frame.number = number;
    frame.is_running = true;
    frame.statistics.leaf_triangles = static_cast<int>(number);
    return frame;
}

TEST(DrapeTrace, keeps_the_newest_frames_in_their_order) {
    DrapeTrace trace;
    for (std::uint64_t number = 1; number <= DrapeTrace::kLength + 5; ++number) trace.take(running_frame(number));
    ASSERT_EQ(trace.size(), DrapeTrace::kLength);
    EXPECT_EQ(trace.triangles(0), 6.0F);
    EXPECT_EQ(trace.triangles(trace.size() - 1), static_cast<float>(DrapeTrace::kLength + 5));
}

TEST(DrapeTrace, takes_no_frame_twice_and_none_that_stands) {
    DrapeTrace trace;
    trace.take(running_frame(1));
    trace.take(running_frame(1));
    SessionFrame paused = running_frame(2);
    paused.is_running = false;
    trace.take(paused);
    EXPECT_EQ(trace.size(), 1U);
}

}  // namespace
}  // namespace selvedge
