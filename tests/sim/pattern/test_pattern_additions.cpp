// What drafting keeps in a file: notches, wraps, mirror images, places on the sheet, ease, names that change.
#include <gtest/gtest.h>

#include "sim/pattern/pattern_file.h"
#include "sim/pattern/pattern_write.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge {
namespace {

std::string with_drafting() {
    const std::string text =
        replaced(sample_text(), R"("pattern": {)",
                 R"("selvedge": {"eased": [{"panel": "back", "edge": 2, "since": 1.0}], "seam_names":
 {"left side": {"panel": "back", "edge": 2}}}, "pattern": {)");
    return replaced(text, R"("back": {)",
                    R"("back": {"selvedge": {"notches": [{"edge": 1, "at": 0.250, "depth": 3}, {"edge": 0, "at": 1}],
 "wrap_radius": 15.0, "mirror_of": "front", "sheet_position": [120.0, -7]}, )");
}

std::string written(const PatternDocument& document) {
    return write_json(parse_json(write_pattern(document), ""), -1);
}

std::string one_line(const std::string& text) {
    return write_json(parse_json(text, ""), -1);
}

TEST(PatternAdditions, are_read_in_metres_and_along_the_edges_of_the_file) {
    const Pattern pattern = parse_pattern(with_drafting(), "").pattern;
    const Panel& back = pattern.panels[1];
    ASSERT_TRUE(back.is_mirrored);
    EXPECT_EQ(back.notches, (std::vector<Notch>{{1, 0.25}, {0, 1}}));
    EXPECT_DOUBLE_EQ(back.wrap_radius, 0.15);
    EXPECT_EQ(back.mirror_of, "front");
    EXPECT_TRUE(back.sheet_position.value_or(Vec2d::Zero()).isApprox(Vec2d(1.2, -0.07)));
    EXPECT_TRUE(pattern.seams[0].is_eased);
    EXPECT_FALSE(pattern.seams[1].is_eased);
    const Panel& front = pattern.panels[0];
    EXPECT_TRUE(front.notches.empty());
    EXPECT_FALSE(front.sheet_position);
    EXPECT_EQ(front.mirror_of, "");
    EXPECT_EQ(front.wrap_radius, 0);
}

TEST(PatternAdditions, come_back_as_they_stood_when_nothing_changed) {
    EXPECT_EQ(written(parse_pattern(with_drafting(), "")), one_line(with_drafting()));
    const std::string empty = replaced(sample_text(), R"("pattern": {)", R"("selvedge": {"eased": []}, "pattern": {)");
    EXPECT_EQ(written(parse_pattern(empty, "")), one_line(empty));
}

TEST(PatternAdditions, go_to_a_file_that_had_none_and_come_back) {
    PatternDocument document = parse_pattern(sample_text(), "");
    Panel& back = document.pattern.panels[1];
    back.notches = {{2, 0.125}, {0, 0}};
    back.wrap_radius = 0.125;
    back.mirror_of = "front";
    back.sheet_position = Vec2d(-0.5, 0.25);
    document.pattern.seams[1].is_eased = true;
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(again.pattern.panels[1].notches, back.notches);
    EXPECT_EQ(again.pattern.panels[1].wrap_radius, back.wrap_radius);
    EXPECT_EQ(again.pattern.panels[1].mirror_of, "front");
    EXPECT_EQ(again.pattern.panels[1].sheet_position, back.sheet_position);
    EXPECT_FALSE(again.pattern.seams[0].is_eased);
    EXPECT_TRUE(again.pattern.seams[1].is_eased);
    EXPECT_EQ(write_json(*again.json.find("selvedge"), -1), R"({"eased":[{"panel":"front","edge":3}]})");
    document.pattern = parse_pattern(sample_text(), "").pattern;
    document.json = again.json;
    const Pattern without = parse_pattern(write_pattern(document), "").pattern;
    EXPECT_EQ(without.panels, document.pattern.panels);
    EXPECT_FALSE(without.seams[1].is_eased);
    EXPECT_EQ(write_pattern(document).find("eased"), std::string::npos);
}

TEST(PatternAdditions, an_eased_seam_keeps_its_place_in_the_list_when_another_joins_it) {
    PatternDocument document = parse_pattern(with_drafting(), "");
    document.pattern.seams[1].is_eased = true;
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(write_json(*again.json.find("selvedge")->find("eased"), -1),
              R"([{"panel":"back","edge":2,"since":1.0},{"panel":"front","edge":3}])");
}

TEST(PatternAdditions, a_panel_that_is_renamed_keeps_its_place_and_whatever_is_unknown) {
    std::string text = replaced(with_drafting(), R"("front": {)", R"("front": {"lining": [1.50], )");
    PatternDocument document = parse_pattern(text, "");
    document.pattern.panels[0].name = "vest";
    document.pattern.panels[1].mirror_of = "vest";
    rename_panel_in_file(document.json, "front", "vest");
    for (const char* from : {R"("front": {)", R"({"panel": "front", "edge": 1})", R"({"panel": "front", "edge": 3})",
                             R"("mirror_of": "front")", R"("panel_order": ["front")"}) {
        std::string to = from;
        text = replaced(text, from, to.replace(to.find("front"), 5, "vest"));
    }
    EXPECT_EQ(written(document), one_line(text));
}

TEST(PatternAdditions, names_of_seams_and_ease_follow_a_panel_that_is_renamed) {
    PatternDocument document = parse_pattern(with_drafting(), "");
    document.pattern.panels[1].name = "rear";
    rename_panel_in_file(document.json, "back", "rear");
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(write_json(*again.json.find("selvedge"), -1), R"({"eased":[{"panel":"rear","edge":2,"since":1.0}],)"
                                                            R"("seam_names":{"left side":{"panel":"rear","edge":2}}})");
    EXPECT_EQ(again.pattern.panels, document.pattern.panels);
    EXPECT_EQ(again.pattern.seams, document.pattern.seams);
}

TEST(PatternAdditions, a_name_that_is_taken_or_unknown_renames_nothing) {
    Json json = parse_json(with_drafting(), "");
    rename_panel_in_file(json, "front", "back");
    rename_panel_in_file(json, "sleeve", "arm");
    EXPECT_EQ(write_json(json, -1), one_line(with_drafting()));
    Json none;
    rename_panel_in_file(none, "front", "vest");
    EXPECT_TRUE(none.is_null());
}

}  // namespace
}  // namespace selvedge
