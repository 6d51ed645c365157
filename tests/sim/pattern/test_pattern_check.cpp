#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

// A replacement that makes the sample text wrong, and the only line that the check should report.
struct Case {
    friend void PrintTo(const Case& spoilt, std::ostream* out) { *out << spoilt.name; }

    std::string name;
    std::string from;
    std::string to;
    std::string line;
};

class Check : public ::testing::TestWithParam<Case> {};

TEST_P(Check, finds_the_one_fault) {
    const std::string text = replaced(sample_text(), GetParam().from, GetParam().to);
    EXPECT_EQ(faults_of(text), std::vector<std::string>{"f.json: " + GetParam().line});
}

const std::string kFront = "pattern.panels.front";

INSTANTIATE_TEST_SUITE_P(
    , Check,
    ::testing::Values(
        Case{"open_outline", R"({"endpoints": [3, 0]}]},)", R"({"endpoints": [3, 1]}]},)",
             kFront + ".edges[3]: the outline is open: this edge ends at vertex 1, the next starts at vertex 0"},
        Case{"passed_twice", R"({"endpoints": [1, 2]},
              {"endpoints": [2, 3], "curvature": {"type": "circle", "params": [25, 0, 1]}, "label": "lower_interface"})",
             R"({"endpoints": [1, 2]}, {"endpoints": [2, 1]}, {"endpoints": [1, 3]})",
             kFront + ".edges[3]: the outline passes vertex 1 twice"},
        Case{"missing_panel", R"({"panel": "back", "edge": 2})", R"({"panel": "slevee", "edge": 2})",
             "pattern.stitches[0][1].panel: no panel 'slevee'"},
        Case{"missing_edge", R"({"panel": "back", "edge": 2})", R"({"panel": "back", "edge": 4})",
             "pattern.stitches[0][1].edge: no edge 4: there are 4"},
        Case{"half_an_edge", R"({"panel": "back", "edge": 2})", R"({"panel": "back", "edge": 2.5})",
             "pattern.stitches[0][1].edge: no edge 2.5: there are 4"},
        Case{"short_offset", R"("front": {)", R"("front": {"selvedge": {"sett_offset": [1]}, )",
             kFront + ".selvedge.sett_offset: 1 value where 2 should be"},
        Case{"worded_offset", R"("front": {)", R"("front": {"selvedge": {"sett_offset": [1, "far"]}, )",
             kFront + ".selvedge.sett_offset[1]: a string where a number should be"},
        Case{"huge_offset", R"("front": {)", R"("front": {"selvedge": {"sett_offset": [1, 1e300]}, )",
             kFront + ".selvedge.sett_offset: further than 100 m"},
        Case{"underlay_of_nothing", R"("pattern": {)",
             R"("selvedge": {"underlays": [{"pixel_size": 1}]}, "pattern": {)", "selvedge.underlays[0]: no key 'file'"},
        Case{"underlay_without_scale", R"("pattern": {)",
             R"("selvedge": {"underlays": [{"file": "a.png", "pixel_size": 0}]}, "pattern": {)",
             "selvedge.underlays[0].pixel_size: 0 is no size of a pixel: 0.0001 to 100 cm are"},
        Case{"underlay_too_strong", R"("pattern": {)",
             R"("selvedge": {"underlays": [{"file": "a.png", "pixel_size": 1, "opacity": 2}]}, "pattern": {)",
             "selvedge.underlays[0].opacity: an opacity is from 0 to 1"},
        Case{"name_of_no_edge", R"("pattern": {)",
             R"("selvedge": {"seam_names": {"a": {"panel": "back"}}}, "pattern": {)",
             "selvedge.seam_names.a: no key 'edge'"},
        Case{"name_of_no_seam", R"("pattern": {)",
             R"("selvedge": {"seam_names": {"a": {"panel": "back", "edge": 1}}}, "pattern": {)",
             "selvedge.seam_names.a: this edge is not sewn"},
        Case{
            "two_names", R"("pattern": {)",
            R"("selvedge": {"seam_names": {"a": {"panel": "back", "edge": 2}, "b": {"panel": "front", "edge": 1}}}, "pattern": {)",
            "selvedge.seam_names.b: the seam is named 'a' already"},
        Case{"name_with_comma", R"("pattern": {)",
             R"("selvedge": {"seam_names": {"a,b": {"panel": "back", "edge": 2}}}, "pattern": {)",
             "selvedge.seam_names[\"a,b\"]: a seam's name is not empty, and has no comma and no plus sign"},
        Case{"matched_to_nothing", R"("pattern": {)",
             R"("selvedge": {"matched_sett": {"repeat": [0, 14]}}, "pattern": {)",
             "selvedge.matched_sett.repeat: the repeat must be positive"},
        Case{"a_sett_of_no_size", R"("pattern": {)", R"("selvedge": {"sett_size": 0.05}, "pattern": {)",
             "selvedge.sett_size: 0.05 is no size of a sett's repeat: 0.1 to 500 cm are"},
        Case{"matched_to_what", R"("pattern": {)", R"("selvedge": {"matched_sett": {}}, "pattern": {)",
             "selvedge.matched_sett: no key 'repeat'"},
        Case{"sewn_twice", R"({"panel": "back", "edge": 2})", R"({"panel": "back", "edge": 0})",
             "pattern.stitches[1][1]: edge 0 of panel 'back' is sewn already, at pattern.stitches[0][1]"},
        Case{"unequal_seam", "[5, 50], [35, 50], [40, 0]]", "[5, 50], [35, 50.5], [40, 0]]",
             "pattern.stitches[0]: warning: the sides differ by 5.0 mm (502.5 and 507.5, ratio 1.01)"},
        Case{"same_vertex", R"({"endpoints": [1, 2]},
              {"endpoints": [2, 3], "curv)",
             R"({"endpoints": [1, 1]},
              {"endpoints": [2, 3], "curv)",
             kFront + ".edges[1].endpoints: the edge starts and ends at the same vertex"},
        Case{"nan", "[35, 50]", "[35, null]", kFront + ".vertices[2][1]: null where a number should be"},
        Case{"far_away", "[35, 50]", "[35, 1e300]", kFront + ".vertices[2]: further than 100 m"},
        Case{"far_control", "[[0.5, -0.05]]", "[[0.5, 1e300]]",
             kFront + ".edges[0].curvature.params[0]: the control point is further than 100 m"},
        Case{"line_without_points", R"("front": {)", R"("front": {"selvedge": {"internal_lines": [{"points": []}]}, )",
             kFront + ".selvedge.internal_lines[0].points: 0 values where at least 2 should be"},
        Case{"line_of_one_point", R"("front": {)",
             R"("front": {"selvedge": {"internal_lines": [{"points": [[3, 4], [5, 6]]}, {"points": [[3, 4]]}]}, )",
             kFront + ".selvedge.internal_lines[1].points: 1 value where at least 2 should be"},
        Case{"too_many_numbers", "[35, 50]", "[35, 50, 1]", kFront + ".vertices[2]: 3 values where 2 should be"},
        Case{"unknown_vertex", R"("endpoints": [2, 3])", R"("endpoints": [2, 7])",
             kFront + ".edges[2].endpoints[1]: no vertex 7: there are 4"},
        Case{
            "unknown_curvature", "\"cubic\"", "\"spline\"",
            "pattern.panels.back.edges[1].curvature.type: unknown curvature type 'spline': known are quadratic, cubic, "
            "circle"},
        Case{"small_arc", "[25, 0, 1]", "[14, 0, 1]",
             kFront + ".edges[2].curvature.params[0]: a radius of 14 is too small for a chord of 30"},
        Case{"text_for_a_flag", R"("front": {)", R"("front": {"selvedge": {"worn": "no"}, )",
             kFront + ".selvedge.worn: a string where true or false should be"},
        Case{"arc_flag", "[25, 0, 1]", "[25, 0, 2]", kFront + ".edges[2].curvature.params[2]: expected 0 or 1"},
        Case{"text_for_edges", R"("edges": [{"endpoints": [0, 1]},)",
             R"("edges": "none", "was": [{"endpoints": [0, 1]},)",
             "pattern.panels.back.edges: a string where an array should be"},
        Case{"no_panels", "\"panels\"", "\"pannels\"", "pattern: no key 'panels'"},
        Case{"units", "\"units_in_meter\": 100", "\"units_in_meter\": 0",
             "properties.units_in_meter: 0 units in a metre: expected 0.001 to 1000000"},
        Case{"coords", "\"relative\"", "\"polar\"",
             "properties.curvature_coords: 'polar' is neither relative nor absolute"},
        Case{"third_of_a_stitch", R"({"panel": "back", "edge": 2}])", R"({"panel": "back", "edge": 2}, "wrong_right"])",
             "pattern.stitches[0][2]: 'wrong_right' should be right_wrong"},
        Case{"pin", R"("back": {)", R"("back": {"selvedge": {"pins": [1, 4]}, )",
             "pattern.panels.back.selvedge.pins[1]: no vertex 4: there are 4"},
        Case{"notch_of_no_edge", R"("back": {)", R"("back": {"selvedge": {"notches": [{"edge": 4, "at": 0.5}]}, )",
             "pattern.panels.back.selvedge.notches[0].edge: no edge 4: there are 4"},
        Case{"notch_nowhere", R"("back": {)", R"("back": {"selvedge": {"notches": [{"edge": 3}]}, )",
             "pattern.panels.back.selvedge.notches[0]: no key 'at'"},
        Case{"notch_beyond", R"("back": {)", R"("back": {"selvedge": {"notches": [{"edge": 3, "at": 1.5}]}, )",
             "pattern.panels.back.selvedge.notches[0].at: a notch lies from 0 to 1 along its edge"},
        Case{"worded_notch", R"("back": {)", R"("back": {"selvedge": {"notches": [3]}, )",
             "pattern.panels.back.selvedge.notches[0]: a number where an object should be"},
        Case{"wide_allowance", R"("back": {)", R"("back": {"selvedge": {"allowance": 51}, )",
             "pattern.panels.back.selvedge.allowance: an allowance is from 0 to 50 cm"},
        Case{"half_a_piece", R"("back": {)", R"("back": {"selvedge": {"pieces": 1.5}, )",
             "pattern.panels.back.selvedge.pieces: 1.5 is not a whole number from 1 to 1000"},
        Case{"kind_of_notch", R"("back": {)",
             R"("back": {"selvedge": {"notches": [{"edge": 0, "at": 0.5, "kind": "w"}]}, )",
             "pattern.panels.back.selvedge.notches[0].kind: 'w' is none of slit, v, t, castle, u"},
        Case{"wrap", R"("back": {)", R"("back": {"selvedge": {"wrap_radius": -1}, )",
             "pattern.panels.back.selvedge.wrap_radius: wrap_radius must not be negative"},
        Case{"cone_and_wrap", R"("back": {)",
             R"("back": {"selvedge": {"wrap_radius": 1, "wrap_cone": {"apex": [0, 1], "sine": 0.5}}, )",
             "pattern.panels.back.selvedge.wrap_cone: a panel has wrap_radius or wrap_cone, not both"},
        Case{"cone_without_apex", R"("back": {)", R"("back": {"selvedge": {"wrap_cone": {"sine": 0.5}}, )",
             "pattern.panels.back.selvedge.wrap_cone: no key 'apex'"},
        Case{"wide_cone", R"("back": {)", R"("back": {"selvedge": {"wrap_cone": {"apex": [0, 1], "sine": 1.5}}, )",
             "pattern.panels.back.selvedge.wrap_cone.sine: the sine is from 0.01 to 1, or as much below 0"},
        Case{"needle", R"("back": {)", R"("back": {"selvedge": {"wrap_cone": {"apex": [0, 1], "sine": 1e-310}}, )",
             "pattern.panels.back.selvedge.wrap_cone.sine: the sine is from 0.01 to 1, or as much below 0"},
        Case{"huge_wrap", R"("back": {)", R"("back": {"selvedge": {"wrap_radius": 1e6}, )",
             "pattern.panels.back.selvedge.wrap_radius: further than 100 m"},
        Case{"mirror_of_nothing", R"("back": {)", R"("back": {"selvedge": {"mirror_of": "fornt"}, )",
             "pattern.panels.back.selvedge.mirror_of: no panel 'fornt'"},
        Case{"mirror_of_itself", R"("back": {)", R"("back": {"selvedge": {"mirror_of": "back"}, )",
             "pattern.panels.back.selvedge.mirror_of: a panel is no mirror image of itself"},
        Case{"mirror_of_a_number", R"("back": {)", R"("back": {"selvedge": {"mirror_of": 1}, )",
             "pattern.panels.back.selvedge.mirror_of: a number where a string should be"},
        Case{"sheet", R"("back": {)", R"("back": {"selvedge": {"sheet_position": [1]}, )",
             "pattern.panels.back.selvedge.sheet_position: 1 value where 2 should be"},
        Case{"eased_and_not_sewn", R"("pattern": {)",
             R"("selvedge": {"eased": [{"panel": "back", "edge": 1}]}, "pattern": {)",
             "selvedge.eased[0]: this edge is not sewn"},
        Case{"eased_nowhere", R"("pattern": {)", R"("selvedge": {"eased": [{"edge": 1}]}, "pattern": {)",
             "selvedge.eased[0]: no key 'panel'"},
        Case{"eased_twice", R"("pattern": {)",
             R"("selvedge": {"eased": [{"panel": "back", "edge": 2}, {"panel": "front", "edge": 1}]}, "pattern": {)",
             "selvedge.eased[1]: the seam is listed already"},
        Case{"sewing_not_sewn", R"("pattern": {)",
             R"("selvedge": {"sewings": {"a": [{"panel": "back", "edge": 1}]}}, "pattern": {)",
             "selvedge.sewings.a[0]: this edge is not sewn"},
        Case{"sewing_is_no_list", R"("pattern": {)", R"("selvedge": {"sewings": {"a": 1}}, "pattern": {)",
             "selvedge.sewings.a: a number where an array should be"},
        Case{
            "sewings_share_a_seam", R"("pattern": {)",
            R"("selvedge": {"sewings": {"a": [{"panel": "back", "edge": 2}], "b": [{"panel": "front", "edge": 1}]}}, "pattern": {)",
            "selvedge.sewings.b[0]: the seam is a part of sewing 'a' already"},
        Case{"layer", R"("back": {)", R"("back": {"selvedge": {"layer": 0.5}, )",
             "pattern.panels.back.selvedge.layer: a layer is a whole number from -1000 to 1000"},
        Case{"fabric", R"("pattern": {)", R"("selvedge": {"fabric": "velour"}, "pattern": {)",
             "selvedge.fabric: warning: no fabric 'velour' ships with the program"},
        Case{"height", R"("pattern": {)", R"("selvedge": {"body_height": 1.7}, "pattern": {)",
             "selvedge.body_height: 1.7 is not a body height: 30 to 300 cm"}),
    [](const auto& spoilt) { return spoilt.param.name; });

// A panel with straight edges through these points, cm. `last`: additional JSON members of the last edge.
std::string polygon(const std::string& vertices, int count, const std::string& last = "") {
    std::string edges;
    for (int i = 0; i < count; ++i) {
        edges += (i == 0 ? "" : ",") +
                 ("{\"endpoints\":[" + std::to_string(i) + "," + std::to_string((i + 1) % count)) + "]" +
                 (i + 1 == count ? last : "") + "}";
    }
    return R"({"pattern":{"panels":{"p":{"vertices":[)" + vertices + R"(],"edges":[)" + edges + "]}}}}";
}

using Lines = std::vector<std::string>;
const std::string kEdges = "f.json: pattern.panels.p.edges";

TEST(CheckShape, lines_that_cross) {
    EXPECT_EQ(faults_of(polygon("[0,0],[40,0],[5,30],[35,30]", 4)),
              Lines{kEdges + "[1]: the outline crosses or touches itself: edges 1 and 3 meet near (20, 17.143)"});
}

TEST(CheckShape, a_vertex_on_another_edge) {
    EXPECT_FALSE(faults_of(polygon("[0,0],[40,0],[40,30],[20,0],[0,30]", 5)).empty());
    EXPECT_EQ(faults_of(polygon("[0,0],[40,0],[40,30],[20,0.001],[0,30]", 5)), Lines{});
}

TEST(CheckShape, an_edge_that_runs_back_along_its_neighbour) {
    const Lines lines = faults_of(polygon("[0,0],[40,0],[20,0],[20,30]", 4));
    ASSERT_EQ(lines.size(), 2U);  // second fault: the far end of edge 1 is on edge 0
    EXPECT_EQ(lines[0], kEdges + "[0]: the outline crosses or touches itself: edges 0 and 1 meet near (40, 0)");
}

TEST(CheckShape, a_curve_that_cuts_another_edge) {
    const Lines lines =
        faults_of(polygon("[0,0],[40,0],[40,30],[0,30]", 4, R"(,"curvature":{"type":"quadratic","params":[[0.5,3]]})"));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines[0].find("edges 1 and 3 meet near (40, "), std::string::npos) << lines[0];
}

TEST(CheckShape, a_loop_within_one_edge) {
    const Lines lines = faults_of(
        polygon("[0,0],[40,0],[40,30],[0,30]", 4, R"(,"curvature":{"type":"cubic","params":[[2,-2],[-1,-2]]})"));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines[0].find("edges 3 and 3 meet"), std::string::npos) << lines[0];
}

TEST(CheckShape, an_edge_without_length) {
    EXPECT_EQ(faults_of(polygon("[0,0],[40,0],[40,0],[0,30]", 4)), Lines{kEdges + "[1]: the edge has no length"});
}

TEST(CheckShape, a_mirrored_panel_is_named_by_the_coordinates_of_its_file) {
    EXPECT_EQ(faults_of(polygon("[0,0],[35,30],[5,30],[40,0.5]", 4)),
              Lines{kEdges + "[0]: the outline crosses or touches itself: edges 0 and 2 meet near (20.126, 17.251)"});
}

TEST(CheckShape, a_panel_without_area) {
    EXPECT_EQ(faults_of(polygon("[0,0],[40,0],[20,0]", 3)),
              Lines{"f.json: pattern.panels.p: the outline encloses no area"});
}

TEST(CheckShape, a_seam_whose_sides_are_no_match_at_all) {
    std::string text = polygon("[0,0],[40,0],[40,8],[0,30]", 4);
    text.insert(text.size() - 2, R"(,"stitches":[[{"panel":"p","edge":0},{"panel":"p","edge":1}]])");
    EXPECT_EQ(faults_of(text),
              Lines{"f.json: pattern.stitches[0]: the sides differ by 320.0 mm (400.0 and 80.0, ratio 5.00)"});
}

TEST(CheckFile, lists_every_fault_in_the_order_of_the_file) {
    std::string text = replaced(sample_text(), "[35, 50], [5, 50]]", "[35, 50], \"x\"]");
    text = replaced(text, "\"cubic\"", "\"spline\"");
    text = replaced(text, R"({"panel": "back", "edge": 2})", R"({"panel": "slevee", "edge": 2})");
    text = replaced(text, R"({"panel": "back", "edge": 0})", R"({"edge": -1})");
    const std::vector<std::string> lines = faults_of(text);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], "f.json: pattern.panels.front.vertices[3]: a string where an array should be");
    EXPECT_NE(lines[1].find("spline"), std::string::npos);
    EXPECT_NE(lines[2].find("slevee"), std::string::npos);
    EXPECT_EQ(lines[3], "f.json: pattern.stitches[1][1]: no key 'panel'");
}

TEST(CheckFile, refuses_an_outline_of_one_edge) {
    EXPECT_EQ(faults_of(R"({"pattern":{"panels":{"p":{"vertices":[[0,0],[1,1]],"edges":[{"endpoints":[0,1]}]}}}})"),
              Lines{kEdges + ": an outline needs two edges or more"});
}

TEST(CheckFile, refuses_what_is_no_specification) {
    EXPECT_EQ(faults_of("[]"), Lines{"f.json: an array where an object should be"});
    EXPECT_EQ(faults_of("{}"), Lines{"f.json: no key 'pattern': not a garment specification"});
    EXPECT_EQ(faults_of(R"({"pattern":{}})"), Lines{"f.json: pattern: no key 'panels'"});
    EXPECT_EQ(faults_of("{").size(), 1U);
    EXPECT_EQ(faults_of(std::string(100, '[')).size(), 1U);
}

// A garment that was only begun can be saved, and opened again.
TEST(CheckFile, allows_a_garment_without_panels_with_a_warning) {
    const std::string text = R"({"pattern":{"panels":{}}})";
    EXPECT_EQ(faults_of(text), Lines{"f.json: pattern.panels: warning: no panels"});
    EXPECT_TRUE(parse_pattern(text, "f.json").pattern.panels.empty());
}

TEST(CheckFile, refuses_stitches_of_a_garment_without_panels) {
    const std::string text =
        R"({"pattern":{"panels":{},"stitches":[[{"panel":"front","edge":0},{"panel":"back","edge":0}]]}})";
    EXPECT_EQ(faults_of(text), (Lines{"f.json: pattern.panels: warning: no panels",
                                      "f.json: pattern.stitches[0][0].panel: no panel 'front'",
                                      "f.json: pattern.stitches[0][1].panel: no panel 'back'"}));
}

TEST(CheckFile, is_silent_about_a_sound_file) {
    EXPECT_TRUE(faults_of(sample_text()).empty());
}

TEST(CheckFile, allows_gathers_with_a_warning) {
    const std::string text =
        replaced(sample_text(), "[[0, 0], [40, 0], [35, 50], [5, 50]]", "[[0, 0], [40, 0], [35, 22], [5, 50]]");
    const std::vector<Fault> faults = check_pattern_text(text, "f.json");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].severity, Severity::Warning);
    EXPECT_NE(faults[0].problem.find("ratio 2.23"), std::string::npos) << faults[0].problem;
    EXPECT_EQ(parse_pattern(text, "").pattern.seams.size(), 2U);
}

TEST(CheckFile, does_not_warn_of_a_seam_that_is_eased) {
    std::string text =
        replaced(sample_text(), "[[0, 0], [40, 0], [35, 50], [5, 50]]", "[[0, 0], [40, 0], [35, 22], [5, 50]]");
    text = replaced(text, R"("pattern": {)", R"("selvedge": {"eased": [{"panel": "back", "edge": 2}]}, "pattern": {)");
    EXPECT_EQ(faults_of(text), Lines{});
}

TEST(CheckFile, refuses_a_mirror_image_of_a_mirror_image) {
    std::string text = replaced(sample_text(), R"("back": {)", R"("back": {"selvedge": {"mirror_of": "front"}, )");
    EXPECT_EQ(faults_of(text), Lines{"f.json: pattern.panels.back: warning: 'back' is not the mirror image of "
                                     "'front': the link is not followed"});
    text = replaced(text, R"("front": {)", R"("front": {"selvedge": {"mirror_of": "back"}, )");
    EXPECT_EQ(
        faults_of(text),
        (Lines{"f.json: pattern.panels.front.selvedge.mirror_of: panel 'back' is a mirror image itself, of 'front'",
               "f.json: pattern.panels.back.selvedge.mirror_of: panel 'front' is a mirror image itself, of 'back'"}));
}

TEST(CheckFile, a_seam_of_one_panel_with_itself_is_a_dart_and_fine) {
    const std::string text = replaced(sample_text(), R"([{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}])",
                                      R"([{"panel": "front", "edge": 1}, {"panel": "front", "edge": 3}])");
    const std::vector<std::string> lines =
        faults_of(replaced(text, R"([{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}])",
                           R"([{"panel": "back", "edge": 2}, {"panel": "back", "edge": 0}])"));
    EXPECT_TRUE(lines.empty());
}

TEST(CheckFile, loading_throws_what_check_lists_first) {
    const std::string text = replaced(sample_text(), "\"cubic\"", "\"spline\"");
    try {
        parse_pattern(text, "f.json");
        FAIL() << "loaded";
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), faults_of(text).front());
    }
}

TEST(CheckFile, a_missing_file_is_one_fault) {
    const std::vector<Fault> faults = check_pattern_file("no/such/file.json");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_TRUE(has_error(faults));
    EXPECT_EQ(faults[0].file, "no/such/file.json");
}

}  // namespace
}  // namespace selvedge::sim
