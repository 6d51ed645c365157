// Seams of paper patterns, as drafts of real garments have them: halves and whole panels, darts, bands, hoods.
#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <utility>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/seam_proposals.h"
#include "tests/support/polygon.h"

namespace selvedge::sim {
namespace {

Panel rectangle(const char* name, double width, double height) {
    return polygon(name, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

// Bends an edge outward, by so much in its middle, m.
void bend(Panel& panel, std::size_t edge, double out) {
    OutlineEdge& bent = panel.edges[edge];
    const Vec2d a = panel.vertices[static_cast<std::size_t>(bent.start)];
    const Vec2d b = panel.vertices[static_cast<std::size_t>(bent.end)];
    const Vec2d along = (b - a).normalized();
    bent.kind = CurveKind::Quadratic;
    bent.control[0] = (a + b) / 2 + 2 * out * Vec2d(along.y(), -along.x());
}

// The edge i of the panel becomes edge (count - i) % count of its mirror image.
Panel mirror_image(const Panel& panel) {
    Panel image = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    image.mirror_of = panel.name;
    image.name = panel.name + "_mirrored";
    return image;
}

// Pairs of panel and edge that accepted proposals sew, the smaller first.
using Pairs = std::set<std::pair<std::pair<std::string, int>, std::pair<std::string, int>>>;
Pairs sewn(const Pattern& pattern) {
    Pairs pairs;
    const ProposalOptions options;
    const auto end = [&](const EdgeSpan& span) {
        return std::pair(pattern.panels[static_cast<std::size_t>(span.panel)].name, span.edge);
    };
    for (const SeamProposal& proposal : propose_seams(pattern, options)) {
        if (proposal.confidence < options.accepted) continue;
        for (const auto& [first, second] : proposal.parts) pairs.insert(std::minmax(end(first), end(second)));
    }
    return pairs;
}

bool are_sewn(const Pairs& pairs, const std::pair<std::string, int>& a, const std::pair<std::string, int>& b) {
    return pairs.contains(std::minmax(a, b));
}

bool are_panels_sewn(const Pairs& pairs, const std::string& a, const std::string& b) {
    return std::ranges::any_of(pairs, [&](const auto& pair) {
        return (pair.first.first == a && pair.second.first == b) || (pair.first.first == b && pair.second.first == a);
    });
}

// A whole front or back: hem 0, side 1, armhole 2, shoulder 3, neck 4, shoulder 5, armhole 6, side 7.
Panel whole(const char* name) {
    Panel panel = polygon(
        name, {{-0.25, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {-0.08, 0.64}, {-0.2, 0.6}, {-0.25, 0.4}});
    bend(panel, 2, -0.03);
    bend(panel, 6, -0.03);
    bend(panel, 4, -0.05);
    return panel;
}

// Hem 0, underarm 1, cap 2 and 3, underarm 4. The cap is 1 cm longer than the armhole.
Panel sleeve(const char* name) {
    Panel panel = polygon(name, {{-0.1, 0}, {0.1, 0}, {0.18, 0.45}, {0, 0.56}, {-0.18, 0.45}});
    bend(panel, 2, 0.03);
    bend(panel, 3, 0.03);
    return panel;
}

Pattern body_block() {
    Pattern pattern;
    pattern.panels = {whole("front"), whole("back"), sleeve("sleeve")};
    pattern.panels.push_back(mirror_image(pattern.panels[2]));
    return pattern;
}

TEST(Drafts, have_their_armholes_sewn_to_sleeves_and_not_to_each_other) {
    const Pairs pairs = sewn(body_block());
    EXPECT_TRUE(are_sewn(pairs, {"front", 1}, {"back", 7}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 7}, {"back", 1}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 3}, {"back", 5}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 5}, {"back", 3}));
    EXPECT_TRUE(are_panels_sewn(pairs, "front", "sleeve"));
    EXPECT_TRUE(are_panels_sewn(pairs, "back", "sleeve"));
    EXPECT_TRUE(are_panels_sewn(pairs, "front", "sleeve_mirrored"));
    for (const int armhole : {2, 6}) {
        for (const int other : {2, 6}) EXPECT_FALSE(are_sewn(pairs, {"front", armhole}, {"back", other}));
    }
}

// A part of a sleeve, as it would lie unrolled from one sixteenth of its round to another: hem 0, seam 1, cap from 2
// on, which is highest at 8 and lowest at 0 and 16, and the other seam last.
Panel part_of_sleeve(const char* name, int from, int to) {
    constexpr double kStep = 0.355 / 16, kRise = 0.06;  // m
    std::vector<Vec2d> corners{{from * kStep, 0}, {to * kStep, 0}};
    for (int k = to; k >= from; --k)
        corners.emplace_back(k * kStep, 0.45 + kRise * std::cos(2 * std::numbers::pi * (k - 8) / 16));
    return polygon(name, corners);
}

// A sleeve of two panels, sewn already, whose seams end neither at the side nor at the shoulder.
Pattern body_block_with_two_piece_sleeve() {
    Pattern pattern;
    pattern.panels = {whole("front"), whole("back"), part_of_sleeve("topsleeve", 3, 12),
                      part_of_sleeve("undersleeve", 12, 19)};
    pattern.panels.push_back(mirror_image(pattern.panels[2]));
    pattern.panels.push_back(mirror_image(pattern.panels[3]));
    const int upper = 11, lower = 9;  // the last edges
    pattern.seams = {{{2, 1}, {3, lower}}, {{2, upper}, {3, 1}}, {{4, 1}, {5, lower}}, {{4, upper}, {5, 1}}};
    return pattern;
}

TEST(Drafts, have_the_top_of_a_two_piece_sleeve_sewn_to_the_shoulder) {
    const Pattern pattern = body_block_with_two_piece_sleeve();
    // The armhole 2 of the front ends at the shoulder, and 6 begins there.
    int found = 0;
    const auto expect_top = [&](const EdgeSpan& armhole, const EdgeSpan& cap) {
        if (armhole.panel != 0 || cap.panel < 2) return;
        const bool ends = armhole.edge == 2 && armhole.to == 1, begins = armhole.edge == 6 && armhole.from == 0;
        if (!ends && !begins) return;
        ++found;
        const Panel& panel = pattern.panels[static_cast<std::size_t>(cap.panel)];
        const OutlineEdge& edge = panel.edges[static_cast<std::size_t>(cap.edge)];
        EXPECT_GT(outline_point(panel, edge, ends ? cap.from : cap.to).y(), 0.5) << panel.name;
    };
    const ProposalOptions options;
    for (const SeamProposal& proposal : propose_seams(pattern, options)) {
        if (proposal.confidence < options.accepted) continue;
        for (const auto& [first, second] : proposal.parts) {
            expect_top(first, second);
            expect_top(second, first);
        }
    }
    EXPECT_EQ(found, 2) << testing::PrintToString(sewn(pattern));
}

TEST(Drafts, have_a_side_sewn_in_one_with_the_sleeve_that_is_in_it) {
    Pattern pattern = body_block();
    pattern.panels.pop_back();
    // The left sleeve is sewn in flat: shoulder, and both halves of the armhole.
    pattern.seams = {{{0, 3}, {1, 5}}, {{0, 2}, {2, 3}}, {{1, 6}, {2, 2}}};
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"front", 1}, {"back", 7}));
    EXPECT_TRUE(are_sewn(pairs, {"sleeve", 1}, {"sleeve", 4}));
}

TEST(Drafts, have_ribbing_sewn_to_the_hems_that_it_ends) {
    Pattern pattern = body_block();
    // Drawn along the cloth; 15 % shorter than the hems of 0.2 and 1 m.
    pattern.panels.push_back(rectangle("cuff", 0.1, 0.17));
    pattern.panels.push_back(mirror_image(pattern.panels.back()));
    pattern.panels.push_back(rectangle("waistband", 0.1, 0.85));
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"cuff", 0}, {"cuff", 2})) << "the cuff is as long round as the sleeve's hem";
    EXPECT_TRUE(are_sewn(pairs, {"waistband", 0}, {"waistband", 2}));
    EXPECT_NE(are_panels_sewn(pairs, "cuff", "sleeve"), are_panels_sewn(pairs, "cuff", "sleeve_mirrored"));
    EXPECT_NE(are_panels_sewn(pairs, "cuff_mirrored", "sleeve"),
              are_panels_sewn(pairs, "cuff_mirrored", "sleeve_mirrored"));
    const bool is_at_hem =
        are_sewn(pairs, {"front", 0}, {"waistband", 1}) || are_sewn(pairs, {"front", 0}, {"waistband", 3});
    EXPECT_TRUE(is_at_hem);
    EXPECT_FALSE(are_sewn(pairs, {"front", 4}, {"waistband", 1}) || are_sewn(pairs, {"front", 4}, {"waistband", 3}));
}

// Four gores of a corset, the first on the fold, all others in pairs, each as its neighbours are.
TEST(Drafts, of_numbered_panels_have_each_sewn_to_the_next_and_only_the_last_to_its_mirror_image) {
    Pattern pattern;
    for (const char* name : {"panel1", "panel2", "panel3", "panel4"})
        pattern.panels.push_back(rectangle(name, 0.07, 0.2));
    for (const std::size_t p : {1U, 2U, 3U}) pattern.panels.push_back(mirror_image(pattern.panels[p]));
    const Pairs pairs = sewn(pattern);
    for (const auto& [a, b] :
         {std::pair("panel1", "panel2"), std::pair("panel2", "panel3"), std::pair("panel3", "panel4"),
          std::pair("panel4", "panel4_mirrored"), std::pair("panel1", "panel2_mirrored"),
          std::pair("panel2_mirrored", "panel3_mirrored"), std::pair("panel3_mirrored", "panel4_mirrored")})
        EXPECT_TRUE(are_panels_sewn(pairs, a, b)) << a << " " << b;
    EXPECT_EQ(pairs.size(), 7U) << testing::PrintToString(pairs);
}

// A trouser half: hem 0, inseam 1, crotch 2, waist 3, outseam 4.
Panel leg(const char* name, double crotch) {
    Panel panel = polygon(name, {{0, 0}, {0.2, 0}, {0.2 + crotch, 0.7}, {0.2, 0.95}, {0, 0.95}});
    bend(panel, 2, -0.03);
    return panel;
}

TEST(Drafts, of_trousers_have_the_crotch_sewn_to_its_mirror_image_and_nothing_else) {
    Pattern pattern;
    pattern.panels = {leg("front", 0.05), leg("back", 0.09)};
    pattern.panels[1] = mapped_panel(pattern.panels[1], Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    pattern.panels.push_back(mirror_image(pattern.panels[0]));
    pattern.panels.push_back(mirror_image(pattern.panels[1]));
    pattern.panels.push_back(rectangle("waistband", 0.8, 0.05));
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"front", 2}, {"front_mirrored", 3}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 4}, {"back", 1}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 1}, {"back", 4}));
    EXPECT_FALSE(are_sewn(pairs, {"front", 4}, {"front_mirrored", 1}));
    EXPECT_TRUE(are_panels_sewn(pairs, "waistband", "front"));
    EXPECT_FALSE(are_sewn(pairs, {"front", 0}, {"waistband", 0}) || are_sewn(pairs, {"front", 0}, {"waistband", 2}));
}

// A back half with the middle at x = 0, seen from outside: hem 0, side 1, armhole 2, shoulder 3, neck 4, middle 5.
Panel back_half() {
    return polygon("back", {{0, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {0, 0.6}});
}

TEST(Drafts, of_two_halves_are_sewn_in_the_middle_and_to_one_side_of_a_whole_front) {
    Pattern pattern;
    pattern.panels = {
        polygon(
            "front",
            {{-0.25, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {-0.08, 0.64}, {-0.2, 0.6}, {-0.25, 0.4}}),
        back_half()};
    pattern.panels.push_back(mirror_image(pattern.panels[1]));
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"back", 5}, {"back_mirrored", 1}));
    EXPECT_FALSE(are_sewn(pairs, {"back", 1}, {"back_mirrored", 5}));
    // Side 7 and shoulder 5 of the front are on its left, side 1 and shoulder 3 on its right.
    EXPECT_EQ(are_sewn(pairs, {"front", 7}, {"back", 1}), are_sewn(pairs, {"front", 5}, {"back", 3}));
    EXPECT_NE(are_sewn(pairs, {"front", 7}, {"back", 1}), are_sewn(pairs, {"front", 1}, {"back", 1}));
    EXPECT_NE(are_sewn(pairs, {"front", 1}, {"back", 1}), are_sewn(pairs, {"front", 1}, {"back_mirrored", 5}));
}

TEST(Drafts, have_wide_darts_closed_and_the_seam_across_them_found) {
    Pattern pattern;
    // A front whose sides have darts of 50 degrees: the side is straight when they are closed.
    const double angle = 50 * std::acos(-1) / 180, reach = 0.16;
    const Vec2d tip(0.25 - reach, 0.25);
    const auto turned = [&](double x, double y) -> Vec2d {  // what lies below the dart, turned away about its tip
        return tip + Eigen::Rotation2Dd(-angle) * (Vec2d(x, y) - tip);
    };
    const std::vector<Vec2d> right{turned(0.08, 0), turned(0.25, 0), turned(0.25, 0.25), tip,
                                   {0.25, 0.25},    {0.25, 0.4},     {0.2, 0.6},         {0.08, 0.64}};
    std::vector<Vec2d> corners = right;
    for (auto p = right.rbegin(); p != right.rend(); ++p) corners.emplace_back(-p->x(), p->y());
    pattern.panels = {
        polygon("front", corners),
        polygon(
            "back",
            {{-0.25, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {-0.08, 0.64}, {-0.2, 0.6}, {-0.25, 0.4}})};
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"front", 2}, {"front", 3}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 1}, {"back", 7})) << "below the dart";
    EXPECT_TRUE(are_sewn(pairs, {"front", 4}, {"back", 7})) << "above the dart";
}

TEST(Drafts, with_a_deep_neck_have_no_dart_there) {
    Pattern pattern;
    pattern.panels = {
        polygon("front", {{-0.25, 0}, {0.25, 0}, {0.25, 0.6}, {0.12, 0.6}, {0, 0.4}, {-0.12, 0.6}, {-0.25, 0.6}})};
    EXPECT_FALSE(are_sewn(sewn(pattern), {"front", 3}, {"front", 4}));
}

TEST(Drafts, of_two_piece_sleeves_are_sewn_where_the_outline_turns_only_a_little) {
    Pattern pattern;
    // Hem 0, front seam 1, cap 2 and 3, which goes on from the back seam 4 with a turn of some 20 degrees.
    pattern.panels = {polygon("topsleeve", {{0, 0}, {0.18, 0}, {0.2, 0.45}, {0.11, 0.58}, {0.02, 0.53}}),
                      polygon("undersleeve", {{0, 0}, {0.1, 0}, {0.1, 0.5304}, {0, 0.4504}})};
    bend(pattern.panels[0], 3, 0.012);
    bend(pattern.panels[1], 2, -0.03);
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"topsleeve", 1}, {"undersleeve", 3}));
    EXPECT_TRUE(are_sewn(pairs, {"topsleeve", 4}, {"undersleeve", 1}));
}

TEST(Drafts, with_a_hood_have_no_binding_at_the_neck_and_a_strip_between_the_sides) {
    Pattern pattern;
    // Neck 0, back 1 (round), face 2.
    pattern.panels = {polygon("hoodSide", {{0, 0}, {0.18, 0}, {0.04, 0.36}})};
    bend(pattern.panels[0], 1, 0.1);
    pattern.panels.push_back(mirror_image(pattern.panels[0]));
    const double round = outline_length(pattern.panels[0], pattern.panels[0].edges[1]);
    pattern.panels.push_back(rectangle("hoodCenter", round, 0.06));
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_panels_sewn(pairs, "hoodSide", "hoodCenter"));
    EXPECT_TRUE(are_panels_sewn(pairs, "hoodSide_mirrored", "hoodCenter"));
    EXPECT_FALSE(are_panels_sewn(pairs, "hoodSide", "hoodSide_mirrored"));
}

// A cowl: the front's neckline rises from a short shoulder with a turn of 20 degrees, which is no corner.
TEST(Drafts, with_a_cowl_have_the_shoulders_sewn_though_the_neckline_goes_on_from_them) {
    Pattern pattern = body_block();
    for (Panel& panel : {std::ref(pattern.panels[0]), std::ref(pattern.panels[1])}) {
        panel.vertices[3] = {0.2, 0.6};
        panel.vertices[4] = {0.15, 0.615};
        panel.vertices[5] = {-0.15, 0.615};
        panel.vertices[6] = {-0.2, 0.6};
        for (const std::size_t edge : {2U, 6U})
            panel.edges[edge] = {.start = panel.edges[edge].start, .end = panel.edges[edge].end};
        bend(panel, 2, -0.03);
        bend(panel, 6, -0.03);
    }
    bend(pattern.panels[0], 4, 0.02);
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"front", 3}, {"back", 5}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 5}, {"back", 3}));
    EXPECT_TRUE(are_panels_sewn(pairs, "front", "sleeve"));
    for (const int armhole : {2, 6}) {
        for (const int other : {2, 6}) EXPECT_FALSE(are_sewn(pairs, {"front", armhole}, {"back", other}));
    }
}

TEST(Drafts, have_no_stretch_that_is_too_short_to_be_meshed) {
    Pattern pattern;
    pattern.panels = {rectangle("collar", 0.4, 0.06), rectangle("collar stand", 0.44, 0.04)};
    // Notches 0.02 mm beside a vertex of the stand, and 2 cm from its ends.
    split_edge(pattern.panels[1], 2, 0.5);
    for (const double t : {0.02 / 0.22, 1 - 1e-4}) pattern.panels[1].notches.push_back({.edge = 2, .t = t});
    pattern.panels[1].notches.push_back({.edge = 3, .t = 1 - 0.02 / 0.22});
    for (const SeamProposal& proposal : propose_seams(pattern)) {
        for (const auto& [first, second] : proposal.parts) {
            for (const EdgeSpan& span : {first, second}) {
                const Panel& panel = pattern.panels[static_cast<std::size_t>(span.panel)];
                const double whole_edge = outline_length(panel, panel.edges[static_cast<std::size_t>(span.edge)]);
                EXPECT_GT((span.to - span.from) * whole_edge, 4e-4);
            }
        }
    }
}

// Half a shirt: the back with its middle on the right and a pleat at the yoke, the yoke above it, the front with its
// middle on the left.
Pattern shirt_with_yoke() {
    Pattern pattern;
    pattern.panels = {
        polygon("BackPanel", {{-0.28, 0}, {0, 0}, {0, 0.68}, {-0.266, 0.68}, {-0.3, 0.45}}),
        polygon("Yoke", {{-0.24, 0}, {0, 0}, {0, 0.07}, {-0.08, 0.13}, {-0.25, 0.07}}),
        polygon("FrontPanel", {{0, 0}, {0.3, 0}, {0.32, 0.45}, {0.25, 0.68}, {0.08, 0.74}, {0, 0.66}}),
    };
    bend(pattern.panels[0], 3, -0.04);
    bend(pattern.panels[1], 2, -0.02);
    bend(pattern.panels[2], 2, -0.04);
    bend(pattern.panels[2], 4, -0.02);
    for (std::size_t p = 0; p < 3; ++p) pattern.panels.push_back(mirror_image(pattern.panels[p]));
    return pattern;
}

TEST(Drafts, of_shirts_have_the_back_hanging_from_the_yoke_and_its_shoulders_neck_to_neck) {
    const Pairs pairs = sewn(shirt_with_yoke());
    EXPECT_TRUE(are_sewn(pairs, {"BackPanel", 2}, {"Yoke", 0}));
    EXPECT_TRUE(are_sewn(pairs, {"Yoke", 3}, {"FrontPanel", 3}));
    EXPECT_TRUE(are_sewn(pairs, {"Yoke_mirrored", 2}, {"FrontPanel_mirrored", 3}));
    EXPECT_FALSE(are_panels_sewn(pairs, "Yoke", "FrontPanel_mirrored"));
    EXPECT_TRUE(are_sewn(pairs, {"Yoke", 1}, {"Yoke_mirrored", 4}));
}

TEST(Drafts, with_long_and_short_sleeves_have_one_kind_sewn) {
    Pattern pattern;
    pattern.panels = {whole("front"), whole("back")};
    const Panel full = sleeve("FullSleeve");
    Panel brief = sleeve("ShortSleeve");
    brief.vertices[0] = {-0.16, 0.3};
    brief.vertices[1] = {0.16, 0.3};
    for (const Panel& one : {full, brief}) {
        pattern.panels.push_back(one);
        pattern.panels.push_back(mirror_image(one));
    }
    const Pairs pairs = sewn(pattern);
    std::set<std::string> sleeves;
    for (const Panel& panel : pattern.panels) {
        for (const char* torso : {"front", "back"}) {
            if (panel.name.find("Sleeve") != std::string::npos && are_panels_sewn(pairs, torso, panel.name))
                sleeves.insert(panel.name);
        }
    }
    ASSERT_EQ(sleeves.size(), 2U);
    EXPECT_EQ(*sleeves.begin() + "_mirrored", *sleeves.rbegin());
}

TEST(Drafts, of_one_panel_round_the_leg_have_the_whole_crotch_sewn_at_once) {
    for (const auto& [width, depth] : {std::pair(0.3, 0.25), {0.22, 0.4}}) {
        Pattern pattern;
        Panel pants = polygon("pants", {{0, 0}, {1, 0}, {1, 1}, {0.5 + width / 2, 1}, {0.5 - width / 2, 1}, {0, 1}});
        bend(pants, 3, -depth);
        pattern.panels = {pants, mirror_image(pants)};
        EXPECT_TRUE(are_sewn(sewn(pattern), {"pants", 3}, {"pants_mirrored", 3})) << depth;
    }
}

TEST(Drafts, have_no_cap_sewn_to_a_side_that_is_as_long) {
    Pattern pattern;
    Panel sleeve = polygon("sleeve", {{-0.15, 0}, {0.15, 0}, {0.2, 0.4}, {-0.2, 0.4}});
    bend(sleeve, 2, 0.1);
    pattern.panels = {rectangle("front", 0.5, outline_length(sleeve, sleeve.edges[2])), sleeve};
    EXPECT_FALSE(are_panels_sewn(sewn(pattern), "front", "sleeve"));
}

// A double notch says "back" on a back's side: it meets the front's single one.
TEST(Drafts, may_have_other_notches_on_the_back_than_on_the_front) {
    Pattern pattern;
    pattern.panels = {whole("front"), whole("back")};
    const auto confidence = [&] {
        for (const SeamProposal& one : propose_seams(pattern, {})) {
            const EdgeSpan &a = one.parts[0].first, &b = one.parts[0].second;
            if (a.edge * b.edge == 7 && a.panel != b.panel) return one.confidence;  // edges 1 and 7
        }
        return 0.0;
    };
    const double without = confidence();
    pattern.panels[0].notches = {{.edge = 1, .t = 0.4}, {.edge = 7, .t = 0.6}};
    pattern.panels[1].notches = {{.edge = 1, .t = 0.4, .count = 2}, {.edge = 7, .t = 0.6, .count = 2}};
    EXPECT_GT(confidence(), without);
}

// The raglan lines of front and back go on under the arm without a corner, where those of the sleeve have one.
TEST(Drafts, of_raglans_have_both_sides_of_a_sleeve_sewn_though_it_has_a_corner_under_the_arm) {
    // Hem 0, side 1, underarm 2, raglan line 3, neck 4, raglan line 5, underarm 6, side 7.
    const auto body = [](const char* name, double neck) {
        Panel panel = polygon(name, {{-0.25, 0},
                                     {0.25, 0},
                                     {0.25, 0.25},
                                     {0.22, 0.265},
                                     {0.07, neck},
                                     {-0.07, neck},
                                     {-0.22, 0.265},
                                     {-0.25, 0.25}});
        for (const auto& [edge, control] : {std::pair<std::size_t, Vec2d>(2, {0.235, 0.25}), {6, {-0.235, 0.25}}}) {
            panel.edges[edge].kind = CurveKind::Quadratic;
            panel.edges[edge].control[0] = control;
        }
        return panel;
    };
    Pattern pattern;
    pattern.panels = {
        body("front", 0.47), body("back", 0.49),
        polygon("sleeve", {{-0.1, 0}, {0.1, 0}, {0.175, 0.5}, {0.03, 0.768}, {-0.03, 0.75}, {-0.175, 0.5}})};
    // Notches in the middle of the straight lines, and as far from the underarm of the sleeve.
    for (const std::size_t p : {0U, 1U}) pattern.panels[p].notches = {{.edge = 3, .t = 0.5}, {.edge = 5, .t = 0.5}};
    pattern.panels[2].notches = {{.edge = 2, .t = 0.557}, {.edge = 4, .t = 0.441}};
    pattern.panels.push_back(mirror_image(pattern.panels[2]));
    const Pairs pairs = sewn(pattern);
    for (const char* sleeve : {"sleeve", "sleeve_mirrored"}) {
        EXPECT_TRUE(are_panels_sewn(pairs, "front", sleeve)) << sleeve;
        EXPECT_TRUE(are_panels_sewn(pairs, "back", sleeve)) << sleeve;
    }
}

// Its sides stay open, and its hems are cut in teeth.
TEST(Drafts, of_a_tabard_have_its_shoulders_sewn_and_neither_its_sides_nor_its_hems) {
    // Teeth 0 to 3, side 4, shoulder 5, neck 6, shoulder 7, side 8.
    const auto half = [](const char* name) {
        Panel panel = polygon(name, {{-0.2, 0.12},
                                     {-0.1, 0},
                                     {0, 0.12},
                                     {0.1, 0},
                                     {0.2, 0.12},
                                     {0.2, 0.8},
                                     {0.12, 0.83},
                                     {-0.12, 0.83},
                                     {-0.2, 0.8}});
        bend(panel, 6, -0.05);
        return panel;
    };
    Pattern pattern;
    pattern.panels = {half("front"), half("back")};
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"front", 5}, {"back", 7}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 7}, {"back", 5}));
    EXPECT_EQ(pairs.size(), 2U);
}

// The elbow is behind: seen from outside, on the right of a left sleeve.
TEST(Drafts, of_sleeves_that_bend_at_the_elbow_have_each_on_the_arm_that_it_bends_with) {
    // Hem 0, underarm 1 and 2, cap 3 and 4, underarm 5 and 6.
    Panel left =
        polygon("sleeve", {{-0.13, 0}, {0.07, 0}, {0.14, 0.22}, {0.18, 0.45}, {0, 0.56}, {-0.18, 0.45}, {-0.11, 0.22}});
    bend(left, 3, 0.03);
    bend(left, 4, 0.03);
    Panel right = mirror_image(left);
    right.mirror_of.clear();
    right.name = "sleeve";
    const auto sewn_with = [](const Panel& drawn) {
        Pattern pattern;
        pattern.panels = {whole("front"), whole("back"), drawn, mirror_image(drawn)};
        for (const int sleeve : {2, 3}) {
            pattern.seams.push_back({.first = {sleeve, 1}, .second = {sleeve, 6}});
            pattern.seams.push_back({.first = {sleeve, 2}, .second = {sleeve, 5}});
        }
        return sewn(pattern);
    };
    const Pairs of_left = sewn_with(left), of_right = sewn_with(right);
    EXPECT_TRUE(are_sewn(of_left, {"front", 2}, {"sleeve", 4}));
    EXPECT_TRUE(are_sewn(of_left, {"back", 6}, {"sleeve", 3}));
    EXPECT_TRUE(are_sewn(of_right, {"front", 6}, {"sleeve", 3}));
    EXPECT_TRUE(are_sewn(of_right, {"back", 2}, {"sleeve", 4}));
}

// Edges with buttons lie over each other; those that a zip joins meet.
TEST(Drafts, with_a_zip_have_the_fronts_sewn_in_the_middle_and_with_buttons_not) {
    // Hem 0, side 1, armhole 2, shoulder 3, neck 4, middle 5.
    Panel front = polygon("front", {{0, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {0, 0.5}});
    bend(front, 2, -0.03);
    bend(front, 4, -0.03);
    for (const auto& [name, is_sewn] : {std::pair("zipperGuard", true), {"buttonPlacket", false}}) {
        Pattern pattern;
        pattern.panels = {whole("back"), front, mirror_image(front),
                          polygon(name, {{0, 0}, {0.03, 0}, {0.03, 0.31}, {0, 0.31}})};
        EXPECT_EQ(are_sewn(sewn(pattern), {"front", 5}, {"front_mirrored", 1}), is_sewn) << name;
    }
}

// As of a jacket.
TEST(Drafts, with_a_side_panel_have_it_sewn_between_front_and_back) {
    const auto trunk = [](const char* name, double low) {
        Panel panel = polygon(
            name,
            {{-0.19, 0}, {0.19, 0}, {0.19, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {-0.08, 0.64}, {-0.2, 0.6}, {-0.19, 0.4}});
        bend(panel, 2, -0.03);
        bend(panel, 6, -0.03);
        bend(panel, 4, -low);
        return panel;
    };
    Panel side = polygon("side", {{-0.06, 0}, {0.06, 0}, {0.06, 0.4}, {-0.06, 0.4}});
    bend(side, 2, -0.02);
    Pattern pattern;
    pattern.panels = {trunk("front", 0.05), trunk("back", 0.01), side};
    pattern.panels.push_back(mirror_image(side));
    const Pairs pairs = sewn(pattern);
    for (const char* face : {"front", "back"}) {
        EXPECT_TRUE(are_panels_sewn(pairs, "side", face)) << face;
        EXPECT_TRUE(are_panels_sewn(pairs, "side_mirrored", face)) << face;
    }
    EXPECT_FALSE(are_sewn(pairs, {"front", 1}, {"back", 7}));
    EXPECT_FALSE(are_sewn(pairs, {"front", 7}, {"back", 1}));
}

// The upper edge of a lapel is short, and meets the other one nowhere.
TEST(Drafts, with_lapels_have_the_corners_of_these_sewn_to_each_other_nowhere) {
    // Hem 0, side 1, armhole 2, shoulder 3, upright edge of the neck 4, lapel 5 and 6.
    Panel front =
        polygon("front", {{-0.03, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {0.075, 0.58}, {-0.03, 0.58}});
    bend(front, 2, -0.03);
    bend(front, 6, 0.02);
    Pattern pattern;
    pattern.panels = {whole("back"), front, mirror_image(front)};
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_panels_sewn(pairs, "front", "back"));
    EXPECT_FALSE(are_sewn(pairs, {"front", 4}, {"front_mirrored", 3}));
}

// Below its tip, the edge of a front that lies over the other slants away from the middle.
TEST(Drafts, of_fronts_that_lie_over_each_other_have_them_open) {
    // Hem 0, side 1, armhole 2, shoulder 3, edge 4 to the tip and 5 below it.
    Panel front = polygon("front", {{-0.04, 0}, {0.25, 0}, {0.25, 0.4}, {0.2, 0.6}, {0.08, 0.64}, {-0.2, 0.36}});
    bend(front, 2, -0.03);
    Pattern pattern;
    pattern.panels = {whole("back"), front, mirror_image(front)};
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_panels_sewn(pairs, "front", "back"));
    EXPECT_FALSE(are_panels_sewn(pairs, "front", "front_mirrored"));
}

// One line, which only vertices divide, is shoulder, neckline of the back and shoulder.
TEST(Drafts, of_a_tabard_with_level_shoulders_have_them_sewn_beside_the_neck_and_its_sides_open) {
    const Panel back =
        polygon("back", {{-0.2, 0}, {0.2, 0}, {0.2, 0.8}, {0.14, 0.8}, {0, 0.8}, {-0.14, 0.8}, {-0.2, 0.8}});
    const Panel front = polygon("front", {{-0.2, 0},
                                          {0.2, 0},
                                          {0.2, 0.8},
                                          {0.14, 0.8},
                                          {0.11, 0.8},
                                          {0, 0.67},
                                          {-0.11, 0.8},
                                          {-0.14, 0.8},
                                          {-0.2, 0.8}});
    Pattern pattern;
    pattern.panels = {front, back};
    const Pairs pairs = sewn(pattern);
    EXPECT_TRUE(are_sewn(pairs, {"front", 2}, {"back", 5}));
    EXPECT_TRUE(are_sewn(pairs, {"front", 7}, {"back", 2}));
    EXPECT_EQ(pairs.size(), 2U);
}

}  // namespace
}  // namespace selvedge::sim
