// What a report says to the user, and where: texts as sim/inspection writes them.
#include <gtest/gtest.h>
#include <memory>

#include "editor/workspace/drape_verdict.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

sim::Pattern squares() {
    return sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / "two_squares.json").pattern;
}

TEST(DrapeVerdict, is_good_only_without_fault_and_tightness) {
    sim::DressReport report;
    EXPECT_EQ(verdict_of(report).verdict, Verdict::Good);
    EXPECT_EQ(verdict_of(report).text, "");
    report.notes = {"a note about something else"};
    EXPECT_EQ(verdict_of(report).verdict, Verdict::Good);
}

TEST(DrapeVerdict, names_the_part_and_the_length_by_which_it_is_too_small) {
    sim::DressReport report;
    report.faults = {{.kind = "inside_body", .place = "'front' at x 0.100 y 1.200 z 0.100 m", .value = 0.004},
                     {.kind = "does_not_fit", .place = "too small at the bust (y 1.24 m) by 2.2 cm", .value = 0.022}};
    EXPECT_EQ(verdict_of(report).verdict, Verdict::Wrong);
    EXPECT_EQ(verdict_of(report).text, "too small at the bust by 2.2 cm, and 1 more fault");
}

TEST(DrapeVerdict, is_tight_where_the_cloth_only_stretches) {
    sim::DressReport report;
    report.notes = {std::string(sim::kSmallerThanBody) + " up to 2.2 cm, from 1.14 to 1.26 m up: it stretches there"};
    report.fit = {{.measure = "bust", .body_girth = 0.92, .garment_girth = 0.898},
                  {.measure = "waist", .body_girth = 0.70, .garment_girth = 0.80}};
    EXPECT_EQ(verdict_of(report).verdict, Verdict::Tight);
    EXPECT_EQ(verdict_of(report).text, "smaller than the body by up to 2.2 cm at the bust");
}

TEST(DrapeVerdict, leaves_details_of_other_faults_to_the_list) {
    sim::DressReport report;
    report.faults = {{.kind = "self_crossing",
                      .place = "12 pairs of triangles, one at 'front' at x 0.113 y 1.071 z 0.129 m",
                      .value = 0.014}};
    EXPECT_EQ(verdict_of(report).text, "crossing itself over 1.4 cm");
}

// While the body moves, and after it; whether the garment at rest was looked at or not.
TEST(DrapeVerdict, says_first_that_a_garment_left_its_body_in_a_motion) {
    sim::SessionFrame frame;
    EXPECT_EQ(verdict_of(frame).verdict, Verdict::Good);
    frame.motion.faults = {"the garment of 'front' left the waist at 1.20 s and hangs on the left hand"};
    EXPECT_EQ(verdict_of(frame).verdict, Verdict::Wrong);
    EXPECT_EQ(verdict_of(frame).text, "left the waist at 1.20 s");
    sim::DressReport report;
    report.faults = {{.kind = "does_not_fit", .place = "too small at the bust (y 1.24 m) by 2.2 cm", .value = 0.022}};
    frame.report = std::make_shared<const sim::DressReport>(report);
    EXPECT_EQ(verdict_of(frame).text, "left the waist at 1.20 s, and 1 more fault");
    const std::vector<Finding> findings = findings_of(frame, squares());
    ASSERT_EQ(findings.size(), 2U);
    EXPECT_EQ(findings[0].kind, FindingKind::Defect);
    EXPECT_EQ(findings[0].text, frame.motion.faults[0]);
    EXPECT_EQ(findings[0].place.parts, (std::vector<PartLocation>{{.panel = "front"}}));
    EXPECT_EQ(findings[1].kind, FindingKind::DoesNotFit);
}

TEST(Findings, have_the_panels_edges_points_and_levels_that_their_texts_name) {
    sim::DressReport report;
    report.faults = {
        {.kind = "open_seam", .place = "seam 1, 'front' edge 1 to 'back' edge 3", .value = 0.01},
        {.kind = "inside_body", .place = "'front' beside 'back' at x 0.123 y 1.340 z -0.051 m", .value = 0.01},
        {.kind = "does_not_fit", .place = "too small at the waist (y 1.02 m) by 36.5 cm", .value = 0.365}};
    report.notes = {"smaller than the body by up to 1.9 cm, from 1.10 to 1.20 m up: it stretches there",
                    "smaller than the body by up to 1.9 cm, 1.14 m up: it stretches there",
                    "dressed with lowered arms"};
    const std::vector<Finding> findings = findings_of(report, squares());
    ASSERT_EQ(findings.size(), 6U);
    EXPECT_EQ(findings[0].kind, FindingKind::Defect);
    EXPECT_EQ(findings[0].place.parts,
              (std::vector<PartLocation>{{.panel = "front", .edge = 1}, {.panel = "back", .edge = 3}}));
    EXPECT_EQ(findings[1].place.parts, (std::vector<PartLocation>{{.panel = "front"}, {.panel = "back"}}));
    ASSERT_TRUE(findings[1].place.point);
    EXPECT_TRUE(findings[1].place.point->isApprox(Vec3d(0.123, 1.34, -0.051)));
    EXPECT_EQ(findings[2].kind, FindingKind::DoesNotFit);
    EXPECT_EQ(findings[2].place.level, std::optional<double>(1.02));
    EXPECT_NEAR(findings[3].place.level.value(), 1.15, 1e-12);
    EXPECT_EQ(findings[4].place.level, std::optional<double>(1.14));
    EXPECT_EQ(findings[5].kind, FindingKind::Note);
    EXPECT_TRUE(findings[5].place.is_empty());
}

TEST(LitCloth, is_where_a_level_cuts_the_triangles_and_where_a_point_is_nearest) {
    sim::DrawMesh mesh;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.u = {{Vec2f(5, 5), Vec2f(6, 5), Vec2f(5, 6)}};
    mesh.panel = {0};
    mesh.panel_names = {"front"};
    const LitCloth line = lit_cloth({.level = 0.5}, mesh);
    ASSERT_EQ(line.on_panels.size(), 1U);
    EXPECT_TRUE(line.on_panels[0].ends[0].isApprox(Vec2d(5.5, 5.5)));
    EXPECT_TRUE(line.on_panels[0].ends[1].isApprox(Vec2d(5, 5.5)));
    EXPECT_EQ(line.in_space.size(), 1U);
    const LitCloth point = lit_cloth({.point = Vec3d(0.1, 0.9, 0)}, mesh);
    ASSERT_EQ(point.on_panels.size(), 1U);
    EXPECT_TRUE(point.on_panels[0].ends[0].isApprox(Vec2d(5, 6)));
    EXPECT_TRUE(lit_cloth({.level = 3}, mesh).in_space.empty());
}

}  // namespace
}  // namespace selvedge::editor
