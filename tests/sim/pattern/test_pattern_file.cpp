#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "sim/core/error.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/pattern_read.h"
#include "tests/sim/pattern/sample.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Pattern sample() {
    return parse_pattern(sample_text(), "sample.json").pattern;
}

// The larger 3D distance, m, between an end of the seam's first side and the end that it is sewn to.
double widest_gap(const Pattern& pattern, const Seam& seam) {
    const auto end = [&](const SeamSide& side, double t) {
        const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
        return panel.place(outline_point(panel, panel.edges[static_cast<std::size_t>(side.edge)], t));
    };
    const double from = seam.is_reversed ? 1 : 0;
    return std::max((end(seam.first, 0) - end(seam.second, from)).norm(),
                    (end(seam.first, 1) - end(seam.second, 1 - from)).norm());
}

TEST(PatternFile, reads_centimetres_as_metres) {
    const Pattern pattern = sample();
    ASSERT_EQ(pattern.panels.size(), 2U);
    EXPECT_EQ(pattern.name, "sample");
    EXPECT_EQ(pattern.panels[0].name, "front");
    EXPECT_TRUE(pattern.panels[0].vertices[2].isApprox(Vec2d(0.35, 0.5)));
    EXPECT_TRUE(pattern.panels[0].translation.isApprox(Vec3d(-0.2, 0.9, 0.18)));
    EXPECT_EQ(pattern.panels[0].edges[2].label, "lower_interface");
}

TEST(PatternFile, honours_other_units) {
    const std::string text = replaced(sample_text(), "\"units_in_meter\": 100", "\"units_in_meter\": 1000");
    EXPECT_TRUE(parse_pattern(text, "").pattern.panels[0].vertices[2].isApprox(Vec2d(0.035, 0.05)));
}

TEST(PatternFile, mirrors_what_is_drawn_clockwise_and_places_it_where_it_was) {
    const Pattern pattern = sample();
    const Panel& front = pattern.panels[0];
    const Panel& back = pattern.panels[1];
    EXPECT_FALSE(front.is_mirrored);
    EXPECT_TRUE(back.is_mirrored);
    EXPECT_GT(outline_area(front), 0);
    EXPECT_GT(outline_area(back), 0);
    EXPECT_TRUE(back.vertices[2].isApprox(Vec2d(-0.35, 0.5)));
    EXPECT_TRUE(back.place(back.vertices[2]).isApprox(Vec3d(0.15, 1.4, -0.16)));
}

TEST(PatternFile, places_control_points_left_of_the_edge_for_a_positive_second_number) {
    const Pattern pattern = sample();
    EXPECT_TRUE(pattern.panels[0].edges[0].control[0].isApprox(Vec2d(0.2, -0.02)));
    // The back's top edge runs from (5,50) to (35,50). An offset of 0.05 to its left is upward, in the file and
    // mirrored.
    EXPECT_TRUE(pattern.panels[1].edges[1].control[0].isApprox(Vec2d(-0.14, 0.515)));
    EXPECT_TRUE(pattern.panels[1].edges[1].control[1].isApprox(Vec2d(-0.26, 0.515)));
}

TEST(PatternFile, an_arc_flagged_right_bulges_to_the_right_of_its_edge_as_drawn) {
    const std::string circle = R"("curvature": {"type": "circle", "params": [25, 0, 1]})";
    const Pattern pattern =
        parse_pattern(
            replaced(sample_text(), R"("curvature": {"type": "cubic", "params": [[0.3, 0.05], [0.7, 0.05]]})", circle),
            "")
            .pattern;
    // The front's top edge runs to the left, so its right side is up. The back's runs to the right in the file: down.
    EXPECT_NEAR(outline_point(pattern.panels[0], pattern.panels[0].edges[2], 0.5).y(), 0.55, 1e-9);
    EXPECT_NEAR(outline_point(pattern.panels[1], pattern.panels[1].edges[1], 0.5).y(), 0.45, 1e-9);
}

TEST(PatternFile, takes_the_bare_pair_of_old_files_for_a_quadratic_curve) {
    const std::string text =
        replaced(sample_text(), R"({"type": "quadratic", "params": [[0.5, -0.05]]})", "[0.5, -0.05]");
    const PatternDocument document = parse_pattern(text, "");
    EXPECT_EQ(document.pattern.panels[0].edges[0].kind, CurveKind::Quadratic);
    EXPECT_TRUE(document.pattern.panels[0].edges[0].control[0].isApprox(Vec2d(0.2, -0.02)));
    EXPECT_NE(write_pattern(document).find("\"curvature\": [0.5, -0.05]"), std::string::npos);
}

TEST(PatternFile, reads_and_keeps_absolute_control_points) {
    std::string text = replaced(sample_text(), "\"relative\"", "\"absolute\"");
    text = replaced(text, "[[0.5, -0.05]]", "[[20, -2]]");
    text = replaced(text, "[[0.3, 0.05], [0.7, 0.05]]", "[[14, 51.5], [26, 51.5]]");
    const PatternDocument document = parse_pattern(text, "");
    EXPECT_TRUE(document.pattern.panels[0].edges[0].control[0].isApprox(Vec2d(0.2, -0.02)));
    EXPECT_TRUE(document.pattern.panels[1].edges[1].control[0].isApprox(Vec2d(-0.14, 0.515)));
    EXPECT_EQ(write_json(parse_json(write_pattern(document), ""), -1), write_json(parse_json(text, ""), -1));
}

TEST(PatternFile, turns_about_x_first_then_y_then_z) {
    const Eigen::Matrix3d turned = rotation_from_degrees({90, 90, 0});
    EXPECT_TRUE((turned * Vec3d(0, 1, 0)).isApprox(Vec3d(1, 0, 0), 1e-12));  // about x: y to z; then about y: z to x
    EXPECT_TRUE((rotation_from_degrees({0, 0, 90}) * Vec3d(1, 0, 0)).isApprox(Vec3d(0, 1, 0), 1e-12));
}

TEST(PatternFile, seams_join_start_to_end_unless_they_say_right_wrong) {
    const Pattern pattern = sample();
    ASSERT_EQ(pattern.seams.size(), 2U);
    for (const Seam& seam : pattern.seams) {
        EXPECT_TRUE(seam.is_reversed);
        EXPECT_NEAR(widest_gap(pattern, seam), 0.34, 1e-9);  // distance of front and back
    }
    const std::string other =
        replaced(sample_text(), R"({"panel": "back", "edge": 2}])", R"({"panel": "back", "edge": 2}, "right_wrong"])");
    const PatternDocument document = parse_pattern(other, "");
    EXPECT_FALSE(document.pattern.seams[0].is_reversed);
    EXPECT_TRUE(joins_right_to_wrong(document.pattern.seams[0]));
    EXPECT_FALSE(joins_right_to_wrong(document.pattern.seams[1]));
    EXPECT_EQ(write_json(parse_json(write_pattern(document), ""), -1), write_json(parse_json(other, ""), -1));
    PatternDocument toggled = parse_pattern(sample_text(), "");
    toggled.pattern.seams[0].is_reversed = false;
    EXPECT_EQ(parse_pattern(write_pattern(toggled), "").pattern, document.pattern);
}

std::string for_body(const std::string& body) {
    return replaced(sample_text(), R"("pattern": {)", R"("selvedge": {"body": ")" + body + R"("}, "pattern": {)");
}

TEST(PatternFile, keeps_what_lies_under_the_sheet_beside_itself) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "mine.json";
    PatternDocument document = parse_pattern(sample_text(), file.string());
    const std::string picture = (std::filesystem::canonical(file.parent_path()) / "photos" / "front.jpg").string();
    document.pattern.underlays = {{.file = picture,
                                   .position = Vec2d(0.25, -0.5),
                                   .pixel_size = 0.0002,
                                   .rotation = 90 * kDegree,
                                   .opacity = 0.4}};
    save_pattern(document, file);
    const PatternDocument again = load_pattern(file);
    ASSERT_EQ(again.pattern.underlays.size(), 1U);
    EXPECT_EQ(again.pattern.underlays[0].file, picture);
    EXPECT_TRUE(again.pattern.underlays[0].position.isApprox(Vec2d(0.25, -0.5)));
    EXPECT_NEAR(again.pattern.underlays[0].pixel_size, 0.0002, 1e-12);
    EXPECT_NEAR(again.pattern.underlays[0].rotation, 90 * kDegree, 1e-12);
    EXPECT_EQ(again.pattern.underlays[0].opacity, 0.4);
    EXPECT_EQ(again.json.find("selvedge")->find("underlays")->elements()[0].find("file")->string(), "photos/front.jpg");
    EXPECT_EQ(write_pattern(again, file), write_pattern(document, file));
}

TEST(PatternFile, names_a_body_file_relative_to_itself) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "shirt.json";
    const std::string place = std::filesystem::canonical(file.parent_path()).string();
    const auto body_of = [&](const std::string& body) {
        return parse_pattern(for_body(body), file.string()).pattern.body;
    };
    EXPECT_EQ(body_of("anna.obj"), place + "/anna.obj");
    EXPECT_EQ(body_of("bodies/../anna.obj"), place + "/anna.obj");
    EXPECT_EQ(body_of("/scans/anna.obj"), "/scans/anna.obj");
    EXPECT_EQ(body_of("mannequin:sex=male"), "mannequin:sex=male");
    EXPECT_EQ(body_of(""), "");
}

TEST(PatternFile, that_has_no_name_keeps_the_body_file_as_it_is_named) {
    for (const char* body : {"/scans/anna.obj", "anna.obj"}) {
        const PatternDocument document = parse_pattern(for_body(body), "");
        EXPECT_EQ(document.pattern.body, body);
        EXPECT_EQ(parse_pattern(write_pattern(document), "").pattern, document.pattern);
    }
}

TEST(PatternFile, keeps_a_body_files_name_and_names_another_from_where_it_is_stored) {
    const TemporaryFolder folder;
    const std::string place = std::filesystem::canonical((folder / "x").parent_path()).string();
    PatternDocument document = parse_pattern(for_body("./anna.obj"), place + "/shirt.json");
    const auto body_in = [&](const std::string& file) {
        const Json json = parse_json(write_pattern(document, file), file);
        return json.find("selvedge")->find("body")->string();
    };
    EXPECT_EQ(body_in(place + "/copy.json"), "./anna.obj");
    EXPECT_EQ(body_in(place + "/below/copy.json"), place + "/anna.obj");
    document.pattern.body = place + "/scans/berta.obj";
    EXPECT_EQ(body_in(place + "/copy.json"), "scans/berta.obj");
    const std::string copy = place + "/c.json";
    EXPECT_EQ(parse_pattern(write_pattern(document, copy), copy).pattern.body, document.pattern.body);
}

std::string with_additions() {
    std::string text = replaced(sample_text(), R"("pattern": {)",
                                R"("selvedge": {"fabric": "wool_twill", "tartan": "black_watch", "later": [1.0],
 "sett_size": 14.90, "sett_position": [1, -2.50], "matched_sett": {"repeat": [14.90, 7], "tartan": "black_watch"},
 "seam_names": {"left side": {"panel": "back", "edge": 2}},
 "body": "mannequin:sex=female", "body_height": 168, "edge_length": 8}, "pattern": {)");
    return replaced(
        text, R"("back": {)",
        R"("back": {"selvedge": {"grainline": 30, "sett_offset": [1.50, -2], "fabric": "denim", "layer": 2, "pins": [1, 2],
 "internal_lines": [{"name": "pleat", "points": [[10, 1], [10, 40]]}]}, )");
}

TEST(PatternFile, reads_our_additions_in_the_panel_frame) {
    const Pattern pattern = parse_pattern(with_additions(), "").pattern;
    EXPECT_EQ(pattern.fabric, "wool_twill");
    EXPECT_EQ(pattern.tartan, "black_watch");
    EXPECT_EQ(pattern.body, "mannequin:sex=female");
    EXPECT_DOUBLE_EQ(pattern.body_height, 1.68);
    EXPECT_DOUBLE_EQ(pattern.edge_length.value_or(0), 0.08);
    const Panel& back = pattern.panels[1];
    EXPECT_EQ(back.fabric, "denim");
    EXPECT_EQ(back.layer, 2);
    EXPECT_EQ(back.pins, (std::vector<int>{1, 2}));
    EXPECT_NEAR(back.grain_angle, -30 * kDegree, 1e-12);          // mirrored with the panel
    EXPECT_TRUE(back.sett_offset.isApprox(Vec2d(0.015, -0.02)));  // relative to the fabric, so it is not mirrored
    EXPECT_TRUE(pattern.panels[0].sett_offset.isZero(0));
    EXPECT_DOUBLE_EQ(pattern.sett_size.value_or(0), 0.149);
    EXPECT_TRUE(pattern.sett_position.isApprox(Vec2d(0.01, -0.025)));
    ASSERT_TRUE(pattern.matched_sett);
    EXPECT_EQ(pattern.matched_sett->tartan, "black_watch");
    EXPECT_TRUE(pattern.matched_sett->repeat.isApprox(Vec2d(0.149, 0.07)));
    EXPECT_EQ(pattern.seams[0].name, "left side");
    EXPECT_EQ(pattern.seams[1].name, "");
    ASSERT_EQ(back.internal_lines.size(), 1U);
    EXPECT_TRUE(back.internal_lines[0].points[1].isApprox(Vec2d(-0.1, 0.4)));
    EXPECT_DOUBLE_EQ(pattern.panels[0].grain_angle, 0);
}

TEST(PatternFile, writes_an_unchanged_document_value_for_value_as_it_came) {
    for (const std::string& text : {sample_text(), with_additions()}) {
        const PatternDocument document = parse_pattern(text, "");
        EXPECT_EQ(write_json(parse_json(write_pattern(document), ""), -1), write_json(parse_json(text, ""), -1));
    }
}

TEST(PatternFile, writes_only_what_changed) {
    const std::string text = with_additions();
    PatternDocument document = parse_pattern(text, "");
    document.pattern.panels[1].vertices[1].x() = -0.0525;
    document.pattern.panels[1].grain_angle = 45 * kDegree;
    document.pattern.panels[0].translation.y() = 0.915;
    document.pattern.tartan = "anderson";
    std::string expected = replaced(text, "[5, 50], [35, 50], [40, 0]]", "[5.25, 50], [35, 50], [40, 0]]");
    expected = replaced(expected, "\"grainline\": 30", "\"grainline\": -45");
    expected = replaced(expected, "90.0", "91.5");
    expected = replaced(expected, "black_watch", "anderson");
    // The curve of the back's top edge is stored relative to its chord, which moved; its control points do not move.
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_TRUE(again.pattern.panels[1].edges[1].control[0].isApprox(Vec2d(-0.14, 0.515), 1e-8));
    document.pattern.panels[1].edges[1].control = parse_pattern(expected, "").pattern.panels[1].edges[1].control;
    EXPECT_EQ(write_json(parse_json(write_pattern(document), ""), -1), write_json(parse_json(expected, ""), -1));
}

TEST(PatternFile, writes_offsets_of_setts_names_of_seams_and_what_was_matched_shortly_and_in_order) {
    PatternDocument document = parse_pattern(sample_text(), "");
    document.pattern.panels[0].sett_offset = {0.0123456789, 0.1 + 0.2};
    document.pattern.seams[1].name = "right side";
    document.pattern.matched_sett = {"gordon", {0.189, 0.189}};
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(write_json(*again.json.find("pattern")->find("panels")->find("front")->find("selvedge"), -1),
              R"({"sett_offset":[1.23456789,30]})");
    EXPECT_EQ(write_json(*again.json.find("selvedge"), -1),
              R"({"matched_sett":{"tartan":"gordon","repeat":[18.9,18.9]},)"
              R"("seam_names":{"right side":{"panel":"front","edge":3}}})");
    EXPECT_EQ(again.pattern.seams[1].name, "right side");
    EXPECT_TRUE(again.pattern.matched_sett->repeat.isApprox(Vec2d(0.189, 0.189)));
    document.pattern = parse_pattern(sample_text(), "").pattern;
    document.json = again.json;
    EXPECT_EQ(write_pattern(document).find("gordon"), std::string::npos);
    EXPECT_EQ(write_pattern(document).find("right side"), std::string::npos);
}

TEST(PatternFile, reads_and_writes_the_labels_of_panels) {
    PatternDocument document = parse_pattern(sample_text(), "");
    EXPECT_EQ(document.pattern.panels[0].label, "");
    document.pattern.panels[0].label = "leg";
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(again.pattern.panels[0].label, "leg");
    EXPECT_EQ(again.pattern.panels[1].label, "");
}

TEST(PatternFile, writes_panels_and_seams_that_were_added_and_drops_removed_ones) {
    PatternDocument document = parse_pattern(sample_text(), "");
    Panel third = document.pattern.panels[1];
    third.name = "lining";
    document.pattern.panels.push_back(third);
    document.pattern.panels.erase(document.pattern.panels.begin());
    document.pattern.seams = {{.first = {0, 2}, .second = {1, 2}, .is_reversed = false}};
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    ASSERT_EQ(again.pattern.panels.size(), 2U);
    EXPECT_EQ(again.pattern.panels[1].name, "lining");
    EXPECT_TRUE(again.pattern.panels[1].is_mirrored);
    EXPECT_EQ(again.pattern.seams.size(), 1U);
    EXPECT_EQ(again.pattern.seams[0].second, (SeamSide{1, 2}));
    EXPECT_FALSE(again.pattern.seams[0].is_reversed);
    EXPECT_EQ(write_json(*again.json.find("pattern")->find("panel_order"), -1), R"(["back","lining"])");
}

TEST(PatternFile, writes_a_pattern_that_never_was_a_file) {
    PatternDocument document{parse_pattern(with_additions(), "").pattern, {}};
    document.pattern.panels[0].rotation = rotation_from_degrees({20, -35, 110});
    const Pattern again = parse_pattern(write_pattern(document), "").pattern;
    ASSERT_EQ(again.panels.size(), 2U);
    EXPECT_TRUE(again.panels[0].rotation.isApprox(document.pattern.panels[0].rotation, 1e-9));
    for (std::size_t i = 0; i < 2; ++i) {
        const Panel& before = document.pattern.panels[i];
        const Panel& after = again.panels[i];
        EXPECT_EQ(after.is_mirrored, before.is_mirrored);
        EXPECT_EQ(after.pins, before.pins);
        for (std::size_t e = 0; e < before.edges.size(); ++e) {
            EXPECT_NEAR(outline_length(after, after.edges[e]), outline_length(before, before.edges[e]), 1e-9);
            EXPECT_TRUE(
                outline_point(after, after.edges[e], 0.3).isApprox(outline_point(before, before.edges[e], 0.3), 1e-8));
        }
    }
    EXPECT_EQ(again.seams[1].second, document.pattern.seams[1].second);
}

TEST(PatternFile, saves_to_a_file_that_loads_again) {
    const auto path = std::filesystem::path(::testing::TempDir()) / "selvedge_saved_specification.json";
    save_pattern(parse_pattern(sample_text(), ""), path);
    EXPECT_EQ(load_pattern(path).pattern.name, "selvedge_saved");
    EXPECT_TRUE(check_pattern_file(path).empty());
    std::filesystem::remove(path);
}

TEST(PatternFile, names_a_garment_after_its_file_without_the_ending_when_it_has_no_name) {
    for (const char* name : {"shirt.json", "shirt_specification.json", "shirt.garment.json"}) {
        const auto path = std::filesystem::path(::testing::TempDir()) / name;
        save_pattern(parse_pattern(sample_text(), ""), path);
        EXPECT_EQ(load_pattern(path).pattern.name, "shirt") << name;
        std::filesystem::remove(path);
    }
}

class GarmentCodeFiles : public ::testing::TestWithParam<std::string> {};

TEST_P(GarmentCodeFiles, load_with_seams_that_meet_and_come_back_as_they_were) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const auto path = std::filesystem::path(data) / "garmentcode" / GetParam();
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    const PatternDocument document = parse_pattern(text.str(), path.string());
    EXPECT_EQ(write_json(parse_json(write_pattern(document), ""), -1), write_json(parse_json(text.str(), ""), -1));
    for (const Panel& panel : document.pattern.panels) {
        EXPECT_GT(outline_area(panel), 0);
        EXPECT_EQ(panel.is_mirrored, panel.translation.z() < 0) << panel.name;  // back panels are drawn clockwise
    }
    // Front and back are half a metre apart. On edges of at least 0.1 m, swapped ends would have a larger distance.
    for (const Seam& seam : document.pattern.seams) {
        EXPECT_LT(widest_gap(document.pattern, seam), 0.56);
        const Panel& panel = document.pattern.panels[static_cast<std::size_t>(seam.first.panel)];
        if (outline_length(panel, panel.edges[static_cast<std::size_t>(seam.first.edge)]) < 0.1) continue;
        Seam crossed = seam;
        crossed.is_reversed = !crossed.is_reversed;
        EXPECT_LT(widest_gap(document.pattern, seam), widest_gap(document.pattern, crossed));
    }
}

INSTANTIATE_TEST_SUITE_P(, GarmentCodeFiles,
                         ::testing::Values("shirt_mean_specification.json", "dress_pencil_specification.json",
                                           "example_handwritten_specification.json"),
                         [](const auto& file) { return file.param.substr(0, file.param.find('_')); });

}  // namespace

// Additions by pattern editing: notches, wraps, mirror images, sheet positions, eased seams, renamed panels.

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

// What the panel's paper says: allowances, kinds of notches, fold lines, drill points, pieces, size.
TEST(PatternAdditions, for_paper_are_kept_and_mirrored_with_their_panel) {
    PatternDocument document = parse_pattern(sample_text(), "");
    Pattern& pattern = document.pattern;
    pattern.allowance = 0.01;
    pattern.size = "M";
    Panel& back = pattern.panels[1];
    back.allowance = 0.015;
    back.pieces = 2;
    back.is_worn = false;
    back.drill_points = {{-0.1, 0.2}};
    back.notches = {{.edge = 1, .t = 0.5, .kind = NotchKind::Castle, .count = 2}};
    back.internal_lines = {{.name = "middle", .points = {{-0.1, 0.1}, {-0.3, 0.1}}, .use = LineUse::Fold}};
    back.edges[3].allowance = 0.03;
    back.edges[3].allowance_corner = AllowanceCorner::Mirrored;
    const std::string text = write_pattern(document);
    EXPECT_NE(text.find(R"("drill_points": [[10, 20]])"), std::string::npos) << text;  // the file has it unmirrored
    Pattern again = parse_pattern(text, "").pattern;
    EXPECT_EQ(again.allowance, pattern.allowance);
    EXPECT_EQ(again.size, "M");
    ASSERT_TRUE(again.panels[1].drill_points[0].isApprox(back.drill_points[0], 1e-12));
    again.panels[1].drill_points = back.drill_points;
    again.panels[1].internal_lines[0].points = back.internal_lines[0].points;
    EXPECT_EQ(again.panels[1].internal_lines, back.internal_lines);
    EXPECT_EQ(again.panels[1].notches, back.notches);
    EXPECT_EQ(again.panels[1].edges[3].allowance, back.edges[3].allowance);
    EXPECT_EQ(again.panels[1].edges[3].allowance_corner, AllowanceCorner::Mirrored);
    EXPECT_EQ(again.panels[1].allowance, back.allowance);
    EXPECT_EQ(again.panels[1].pieces, 2);
    EXPECT_FALSE(again.panels[1].is_worn);
    EXPECT_TRUE(again.panels[0].is_worn);
    document.json = parse_json(text, "");
    document.pattern.panels[1].edges[3].allowance.reset();
    EXPECT_FALSE(parse_pattern(write_pattern(document), "").pattern.panels[1].edges[3].allowance);
}

TEST(PatternAdditions, are_written_unchanged_when_nothing_was_edited) {
    EXPECT_EQ(written(parse_pattern(with_drafting(), "")), one_line(with_drafting()));
    const std::string empty = replaced(sample_text(), R"("pattern": {)", R"("selvedge": {"eased": []}, "pattern": {)");
    EXPECT_EQ(written(parse_pattern(empty, "")), one_line(empty));
}

TEST(PatternAdditions, are_written_to_a_file_without_them_and_read_again) {
    PatternDocument document = parse_pattern(sample_text(), "");
    Panel& back = document.pattern.panels[1];
    back.notches = {{.edge = 2, .t = 0.125}, {.edge = 0, .t = 0}};
    back.wrap_radius = 0.125;
    back.mirror_of = "front";
    back.sheet_position = Vec2d(-0.5, 0.25);
    document.pattern.panels[0].wrap_cone = WrapCone{.apex = {0.25, 0.5}, .sine = 0.625};
    document.pattern.seams[1].is_eased = true;
    const PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(again.pattern.panels[1].notches, back.notches);
    EXPECT_EQ(again.pattern.panels[1].wrap_radius, back.wrap_radius);
    EXPECT_EQ(again.pattern.panels[0].wrap_cone, document.pattern.panels[0].wrap_cone);
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

TEST(PatternAdditions, the_apex_of_a_cone_is_mirrored_with_a_panel_that_is_drawn_clockwise) {
    PatternDocument document = parse_pattern(sample_text(), "");
    Pattern& pattern = document.pattern;
    for (Panel& panel : pattern.panels) panel.wrap_cone = WrapCone{.apex = {0.25, 0.5}, .sine = 0.5};
    ASSERT_TRUE(std::ranges::any_of(pattern.panels, &Panel::is_mirrored));
    const std::string text = write_pattern(document);
    EXPECT_NE(text.find("[-25"), std::string::npos);
    EXPECT_EQ(parse_pattern(text, "").pattern.panels, pattern.panels);
}

TEST(PatternAdditions, sewings_of_several_seams_come_back_and_follow_a_panel_that_is_renamed) {
    PatternDocument document = parse_pattern(sample_text(), "");
    for (Seam& seam : document.pattern.seams) seam.sewing = "round";
    PatternDocument again = parse_pattern(write_pattern(document), "");
    EXPECT_EQ(again.pattern.seams, document.pattern.seams);
    ASSERT_GE(again.pattern.seams.size(), 2U);
    again.pattern.panels[1].name = "rear";
    rename_panel_in_file(again.json, "back", "rear");
    again.pattern.seams[0].sewing = "other";
    const PatternDocument third = parse_pattern(write_pattern(again), "");
    EXPECT_EQ(third.pattern.seams, again.pattern.seams);
    for (Seam& seam : again.pattern.seams) seam.sewing.clear();
    EXPECT_EQ(write_pattern(again).find("sewings"), std::string::npos);
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

}  // namespace selvedge::sim
