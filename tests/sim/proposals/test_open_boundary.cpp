// Chains of unsewn edges, across seams.
#include "sim/proposals/open_boundary.h"

#include <gtest/gtest.h>
#include <numbers>

namespace selvedge::sim {
namespace {

constexpr double kCorner = 0.5;  // rad

// Edges: 0 bottom, 1 right, 2 top, 3 left.
Panel square(const char* name) {
    Panel panel;
    panel.name = name;
    panel.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

TEST(OpenBoundary, of_a_square_has_four_chains) {
    Pattern pattern;
    pattern.panels = {square("a")};
    const OpenBoundary boundary(pattern);
    const std::vector<Chain> chains = boundary.chains(kCorner);
    ASSERT_EQ(chains.size(), 4U);
    for (const Chain& chain : chains) {
        EXPECT_NEAR(chain.length, 1, 1e-9);
        EXPECT_NEAR(chain.angle_before, std::numbers::pi / 2, 1e-9);
        EXPECT_FALSE(chain.is_loop);
    }
}

TEST(OpenBoundary, goes_on_across_a_seam_and_closes_to_a_tube) {
    Pattern pattern;
    pattern.panels = {square("a"), square("b")};
    OpenBoundary boundary(pattern);
    boundary.sew(1, 7);  // right of a, left of b
    const OpenBoundary::Step step = boundary.next(0);
    EXPECT_EQ(step.atom, 4);
    EXPECT_EQ(step.seams, 1);
    EXPECT_NEAR(step.angle, std::numbers::pi, 1e-9);
    EXPECT_EQ(boundary.chains(kCorner).size(), 4U);
    boundary.sew(5, 3);
    const std::vector<Chain> tube = boundary.chains(kCorner);
    ASSERT_EQ(tube.size(), 2U);
    for (const Chain& chain : tube) {
        EXPECT_TRUE(chain.is_loop);
        EXPECT_NEAR(chain.length, 2, 1e-9);
    }
    EXPECT_EQ(boundary.joined_panels(0), std::vector<int>{1});
}

TEST(OpenBoundary, is_divided_where_a_seam_ends) {
    Pattern pattern;
    pattern.panels = {square("a")};
    OpenBoundary boundary(pattern);
    const int rest = boundary.split(0, 0.25);
    EXPECT_NEAR(boundary.atom(0).length, 0.25, 1e-9);
    EXPECT_EQ(boundary.atom(rest).span, (EdgeSpan{0, 0, 0.25, 1}));
    EXPECT_EQ(boundary.next(0).atom, rest);
    EXPECT_EQ(boundary.next(rest).atom, 1);
    EXPECT_LT((boundary.point(rest, 0.5) - Vec2d(0.625, 0)).norm(), 1e-9);
}

TEST(OpenBoundary, has_the_points_of_the_outline_to_the_bit_however_often_it_is_asked) {
    Pattern pattern;
    pattern.panels = {square("a")};
    OutlineEdge& edge = pattern.panels[0].edges[1];
    edge.kind = CurveKind::Cubic;
    edge.control = {Vec2d(1.4, 0.2), Vec2d(0.7, 0.9)};
    OpenBoundary boundary(pattern);
    const int rest = boundary.split(1, 0.3);
    const OpenBoundary copy = boundary;
    for (int ask = 0; ask < 2; ++ask) {
        for (const double t : {0.0, 0.1, 0.5, 0.99, 1.0}) {
            EXPECT_EQ(boundary.point(1, t), outline_point(pattern.panels[0], edge, 0 + t * (0.3 - 0)));
            EXPECT_EQ(copy.point(rest, t), outline_point(pattern.panels[0], edge, 0.3 + t * (1 - 0.3)));
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
