// Keys that Selvedge does not know, in the objects that only it writes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

using Lines = std::vector<std::string>;

Lines of_garment(const std::string& own) {
    return faults_of(replaced(sample_text(), R"("parameters")", R"("selvedge": {)" + own + R"(}, "parameters")"));
}

Lines of_panel(const std::string& own) {
    return faults_of(replaced(sample_text(), R"("front": {)", R"("front": {"selvedge": {)" + own + "}, "));
}

Lines of_edge(const std::string& own) {
    return faults_of(
        replaced(sample_text(), R"({"endpoints": [1, 2]})", R"({"endpoints": [1, 2], "selvedge": {)" + own + "}}"));
}

// The one warning, without the name of the file.
Lines warning(const std::string& place, const std::string& problem) {
    return {"f.json: " + place + ": warning: " + problem};
}

const std::string kOwnPanel = "pattern.panels.front.selvedge.";
const std::string kOwnEdge = "pattern.panels.front.edges[1].selvedge.";

TEST(UnknownKeys, are_warned_of_with_the_key_that_is_nearly_spelt_so) {
    EXPECT_EQ(of_edge(R"("elastic": {"shar": 0.5})"),
              warning(kOwnEdge + "elastic.shar", "unknown key 'shar': is 'share' meant?"));
    EXPECT_EQ(of_edge(R"("topstitch": {"stitchLength": 0.3})"),
              warning(kOwnEdge + "topstitch.stitchLength", "unknown key 'stitchLength': is 'stitch_length' meant?"));
    EXPECT_EQ(of_edge(R"("topstitch": {"thread": {"color": "#102030"}})"),
              warning(kOwnEdge + "topstitch.thread.color", "unknown key 'color': is 'colour' meant?"));
    EXPECT_EQ(of_edge(R"("elastci": {})"), warning(kOwnEdge + "elastci", "unknown key 'elastci': is 'elastic' meant?"));
    EXPECT_EQ(of_panel(R"("garmnet": "vest")"),
              warning(kOwnPanel + "garmnet", "unknown key 'garmnet': is 'garment' meant?"));
    EXPECT_EQ(of_garment(R"("Fabric": "silk")"),
              warning("selvedge.Fabric", "unknown key 'Fabric': is 'fabric' meant?"));
}

TEST(UnknownKeys, are_listed_up_to_a_number) {
    std::string own;
    for (int i = 0; i < 20'000; ++i) own += (own.empty() ? "\"odd" : ", \"odd") + std::to_string(i) + "\": 1";
    const Lines lines = of_garment(own);
    ASSERT_EQ(lines.size(), kMostFaults + 1);
    EXPECT_EQ(Lines{lines[kMostFaults - 1]}, warning("selvedge.odd999", "unknown key 'odd999'"));
    EXPECT_EQ(lines.back(), "f.json: warning: more than 1000: no others are listed");
}

TEST(UnknownKeys, are_warned_of_without_another_when_none_is_near) {
    EXPECT_EQ(of_edge(R"("elastic": {"price": 3})"), warning(kOwnEdge + "elastic.price", "unknown key 'price'"));
    EXPECT_EQ(of_edge(R"("elastic": {"sh": 3})"), warning(kOwnEdge + "elastic.sh", "unknown key 'sh'"));
}

TEST(UnknownKeys, are_warned_of_in_every_object_that_is_selvedges_own) {
    const std::string problem = "unknown key 'odd'";
    EXPECT_EQ(of_garment(R"("odd": 1)"), warning("selvedge.odd", problem));
    EXPECT_EQ(of_panel(R"("odd": 1)"), warning(kOwnPanel + "odd", problem));
    EXPECT_EQ(of_edge(R"("odd": 1)"), warning(kOwnEdge + "odd", problem));
    EXPECT_EQ(of_panel(R"("notches": [{"edge": 1, "at": 0.5, "odd": 1}])"),
              warning(kOwnPanel + "notches[0].odd", problem));
    EXPECT_EQ(of_panel(R"("internal_lines": [{"points": [[1, 1], [2, 2]], "odd": 1}])"),
              warning(kOwnPanel + "internal_lines[0].odd", problem));
    EXPECT_EQ(of_panel(R"("wrap_cone": {"apex": [20, 90], "sine": 0.5, "odd": 1})"),
              warning(kOwnPanel + "wrap_cone.odd", problem));
    EXPECT_EQ(of_panel(R"("edge_keys": {"keys": [1, 2, 3, 4], "last": 5, "odd": 1})"),
              warning(kOwnPanel + "edge_keys.odd", problem));
    EXPECT_EQ(of_panel(R"("surface": {"kind": "test", "odd": 1})"), warning(kOwnPanel + "surface.odd", problem));
    EXPECT_EQ(of_garment(R"("seams": [{"panel": "front", "edge": 1, "odd": 1}])"),
              warning("selvedge.seams[0].odd", problem));
    EXPECT_EQ(of_garment(R"("eased": [{"panel": "front", "edge": 1, "odd": 1}])"),
              warning("selvedge.eased[0].odd", problem));
    EXPECT_EQ(of_garment(R"("underlays": [{"file": "a.png", "pixel_size": 0.1, "odd": 1}])"),
              warning("selvedge.underlays[0].odd", problem));
    EXPECT_EQ(of_garment(R"("matched_sett": {"repeat": [5, 5], "odd": 1})"),
              warning("selvedge.matched_sett.odd", problem));
}

TEST(UnknownKeys, of_other_programs_are_not_warned_of) {
    std::string text = replaced(sample_text(), R"("front": {)", R"("front": {"odd": 1, )");
    text = replaced(text, R"({"endpoints": [1, 2]})", R"({"endpoints": [1, 2], "odd": 1})");
    text = replaced(text, R"({"panel": "front", "edge": 1})", R"({"panel": "front", "edge": 1, "odd": 1})");
    text = replaced(text, R"("properties": {)", R"("odd": 1, "properties": {"odd": 1, )");
    EXPECT_EQ(faults_of(text), Lines{});
}

void set_all_fields(Panel& panel, const Topstitch& rows) {
    panel.grain_angle = 0.1;
    panel.sett_offset = {0.01, 0};
    panel.fabric = "denim";
    panel.interlinings = {"linen"};
    panel.surface = SurfaceDesign{.kind = DesignKind::Colour, .source = "#102030"};
    panel.layer = 2;
    panel.garment = "vest";
    panel.pins = {1};
    panel.internal_lines = {
        {.name = "line", .points = {{0.1, 0.1}, {0.2, 0.1}}, .use = LineUse::Fold, .topstitch = rows}};
    panel.notches = {{.edge = 1, .t = 0.5, .kind = NotchKind::V, .count = 2}};
    panel.wrap_cone = WrapCone{.apex = {0.2, 0.9}, .sine = 0.5};
    panel.sheet_position = Vec2d(1, 1);
    panel.allowance = 0.02;
    panel.pieces = 2;
    panel.is_worn = false;
    panel.drill_points = {{0.1, 0.1}};
    panel.edges[1].allowance = 0.03;
    panel.edges[1].allowance_corner = AllowanceCorner::Squared;
    panel.edges[1].topstitch = rows;
    panel.edges[1].elastic = Elastic{.share = 0.5, .stiffness = 20};
    panel.edges[0].key = {.number = 7};
    panel.last_key = 7;
    for (int e = 1; e < 4; ++e) panel.edges[as_size(e)].key = {.number = e};
    panel.fold_key = 5;
}

TEST(UnknownKeys, are_not_those_that_a_garment_of_all_fields_is_written_with) {
    PatternDocument document = parse_pattern(sample_text(), "f.json");
    Pattern& pattern = document.pattern;
    pattern.fabric = "silk";
    pattern.tartan = "black_watch";
    pattern.sett_size = 0.1;
    pattern.sett_position = Vec2d(0.01, 0.02);
    pattern.surface = SurfaceDesign{.kind = DesignKind::Test,
                                    .size = 0.2,
                                    .position = {0.1, 0.1},
                                    .rotation = 0.5,
                                    .is_repeated = false,
                                    .ground = "#102030"};
    pattern.matched_sett = MatchedSett{.tartan = "black_watch", .repeat = {0.1, 0.1}};
    pattern.body = "mannequin:sex=female";
    pattern.underlays = {{.file = "a.png", .position = {1, 1}, .pixel_size = 0.001, .rotation = 0.1, .opacity = 0.5}};
    pattern.body_height = 1.6;
    pattern.allowance = 0.01;
    pattern.size = "40";
    pattern.edge_length = 0.04;
    const Topstitch rows{.distances = {0.002, 0.003}, .rows = 2, .stitch_length = 0.004, .thread = {"#102030", 0.001}};
    Seam& seam = pattern.seams[0];
    seam.name = "side";
    seam.is_eased = true;
    seam.sewing = "sides";
    seam.topstitch = rows;
    set_all_fields(pattern.panels[0], rows);
    pattern.panels[1].wrap_radius = 0.3;
    pattern.panels.push_back(pattern.panels[1]);
    pattern.panels[1].mirror_of = pattern.panels[0].name;
    pattern.panels[2].name = "copy";
    pattern.panels[2].copy_of = pattern.panels[0].name;
    const std::string text = write_pattern(document);
    for (const char* key : {"edge_keys", "underlays", "sewings", "eased", "seam_names", "thread", "elastic", "format",
                            "fold_key", "mirror_of", "copy_of"})
        EXPECT_NE(text.find("\"" + std::string(key) + "\""), std::string::npos) << key;
    const Lines faults = faults_of(text);
    EXPECT_EQ(faults.size(), 3U) << "the links are broken";
    for (const std::string& fault : faults)
        EXPECT_NE(fault.find(": the link is not followed"), std::string::npos) << fault;
}

}  // namespace
}  // namespace selvedge::sim
