#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sim/dress/carry_over.h"
#include "sim/dress/outline_match.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/sources.h"
#include "tests/sim/dress/support.h"

namespace selvedge::sim {
namespace {

// Two squares of which an edge each is sewn, and the same with a point where the seam is split, on both sides.
Pattern sewn_squares() {
    Pattern pattern;
    for (const char* name : {"one", "other"}) {
        Panel& panel = pattern.panels.emplace_back();
        panel.name = name;
        panel.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    }
    pattern.seams.push_back({.first = {0, 1}, .second = {1, 3}});
    return evaluate(sources_of(pattern));
}

Pattern split_at(const Pattern& whole, double t) {
    Pattern pattern = whole;
    split_edge(pattern.panels[0], 1, t);
    split_edge(pattern.panels[1], 3, 1 - t);
    pattern.seams = {{.first = {0, 1}, .second = {1, 4}}, {.first = {0, 2}, .second = {1, 3}}};
    return pattern;
}

TEST(OutlineMatch, points_at_the_same_share_of_an_edge_correspond_where_a_point_was_added) {
    const Pattern whole = sewn_squares(), split = split_at(whole, 0.25);
    const OutlineMatch match(whole.panels[0], split.panels[0]);
    EXPECT_NEAR(match.piece_after(1).to, 0.25, 1e-12);
    EXPECT_NEAR(match.piece_after(2).from, 0.25, 1e-12);
    EXPECT_EQ(match.piece_before(1).stretch, match.piece_after(2).stretch);
    for (const auto& [before, after] : match.points(whole.panels[0], split.panels[0], 4))
        EXPECT_LT((before - after).norm(), 1e-12);
    const OutlineMap map(split.panels[0], whole.panels[0]);
    EXPECT_LT((map({0.3, 0.6}) - Vec2d(0.3, 0.6)).norm(), 1e-9);
}

TEST(OutlineMatch, is_empty_where_no_edge_is_the_same) {
    const Panel panel = sewn_squares().panels[0];
    Panel other = panel;
    for (OutlineEdge& edge : other.edges) edge.key.number += 10;
    EXPECT_TRUE(OutlineMatch(panel, other).is_empty());
    const Panel mirrored = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    EXPECT_TRUE(OutlineMatch(panel, mirrored).is_empty());
}

TEST(CarryOver, a_seam_that_is_split_joins_the_same_places) {
    const Pattern whole = sewn_squares(), split = split_at(whole, 0.3);
    EXPECT_EQ(compare(whole, split), PatternChange::Outlines);
    EXPECT_EQ(compare(split, whole), PatternChange::Outlines);
    EXPECT_EQ(compare(split, split_at(whole, 0.6)), PatternChange::Outlines);
    EXPECT_EQ(compare(split, split), PatternChange::None);
}

TEST(CarryOver, edges_in_another_order_are_the_same_outline) {
    const Pattern whole = sewn_squares();
    Pattern turned = whole;
    std::rotate(turned.panels[1].edges.begin(), turned.panels[1].edges.begin() + 1, turned.panels[1].edges.end());
    turned.seams[0].second.edge = 2;
    EXPECT_EQ(compare(whole, turned), PatternChange::Outlines);
    std::swap(turned.seams[0].first, turned.seams[0].second);
    EXPECT_EQ(compare(whole, turned), PatternChange::Outlines);
}

TEST(CarryOver, seams_that_join_other_places_are_another_kind_of_pattern) {
    const Pattern whole = sewn_squares(), split = split_at(whole, 0.3);
    const std::string anew = ": sewn anew from where the panels are placed";
    Pattern half = split;
    half.seams.pop_back();
    EXPECT_EQ(compare(whole, half), PatternChange::Kind);
    EXPECT_EQ(restart_reason(whole, half), "seams join other edges" + anew);
    EXPECT_EQ(restart_reason(split, half), "there is one seam fewer" + anew);
    Pattern eased = split_at(whole, 0.3);
    eased.panels[1] = split_at(whole, 0.5).panels[1];
    EXPECT_EQ(compare(whole, eased), PatternChange::Kind) << "0.3 of one side is sewn to 0.5 of the other";
    Pattern drawn = whole;
    for (OutlineEdge& edge : drawn.panels[0].edges) edge.key.number += 10;
    EXPECT_EQ(restart_reason(whole, drawn), "'one' has another outline: sewn anew from where it is placed");
    Pattern mirrored = whole;
    mirrored.panels[0] = mapped_panel(whole.panels[0], Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    mirrored.seams.clear();
    EXPECT_EQ(restart_reason(whole, mirrored), "'one' was turned over" + anew);
}

}  // namespace
}  // namespace selvedge::sim
