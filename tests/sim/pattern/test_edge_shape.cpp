// Splitting edges of a panel and unfolding a half.
#include "sim/pattern/edge_shape.h"

#include <gtest/gtest.h>

#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// Half a front: 0 hem (a curve), 1 side, 2 top, 3 the fold at x = 0.
Panel half_front() {
    Panel panel;
    panel.vertices = {{0, 0}, {0.2, 0}, {0.25, 0.5}, {0, 0.4}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    panel.edges[0].kind = CurveKind::Quadratic;
    panel.edges[0].control[0] = {0.1, -0.05};
    panel.notches = {{.edge = 1, .t = 0.25, .kind = NotchKind::V, .count = 2}};
    panel.drill_points = {{0.1, 0.2}};
    return panel;
}

Vec2d place_of(const Panel& panel, const Notch& notch) {
    return outline_point(panel, panel.edges[static_cast<std::size_t>(notch.edge)], notch.t);
}

TEST(SplitEdge, keeps_the_shape_and_every_notch_where_it_is) {
    for (const double t : {0.1, 0.25, 0.7}) {
        Panel panel = half_front();
        const Vec2d before = place_of(panel, panel.notches[0]);
        const double area = outline_area(panel);
        split_edge(panel, 1, t);
        ASSERT_EQ(panel.edges.size(), 5U);
        EXPECT_LT((place_of(panel, panel.notches[0]) - before).norm(), 1e-12) << t;
        EXPECT_EQ(panel.notches[0].kind, NotchKind::V);
        split_edge(panel, 0, t);
        EXPECT_LT((place_of(panel, panel.notches[0]) - before).norm(), 1e-12) << t;
        EXPECT_NEAR(outline_area(panel), area, 2e-5);  // chords of 0.1 mm
    }
}

TEST(Unfold, joins_a_half_to_its_image_with_all_its_marks) {
    const Panel half = half_front();
    const Panel whole = unfolded(half, 3);
    ASSERT_EQ(whole.edges.size(), 6U);
    for (std::size_t e = 0; e < 6; ++e) EXPECT_EQ(whole.edges[e].end, whole.edges[(e + 1) % 6].start);
    EXPECT_NEAR(outline_area(whole), 2 * outline_area(half), 1e-9);
    for (int e = 0; e < 3; ++e) {
        const auto at = [&](int edge, double t) {
            return outline_point(whole, whole.edges[static_cast<std::size_t>(edge)], t);
        };
        const Vec2d own = at(unfolded_index(e, 3, 4), 0.3), image = at(unfolded_image(e, 3, 4), 0.7);
        EXPECT_LT((own - Vec2d(-image.x(), image.y())).norm(), 1e-9) << e;
    }
    ASSERT_EQ(whole.notches.size(), 2U);
    const Vec2d notch = place_of(whole, whole.notches[0]), image = place_of(whole, whole.notches[1]);
    EXPECT_LT((notch - Vec2d(-image.x(), image.y())).norm(), 1e-12);
    EXPECT_EQ(whole.notches[1].count, 2);
    EXPECT_EQ(whole.drill_points, (std::vector<Vec2d>{{0.1, 0.2}, {-0.1, 0.2}}));
}

}  // namespace
}  // namespace selvedge::sim
