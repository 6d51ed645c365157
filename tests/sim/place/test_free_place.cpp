// New panels stand clear of the body and of the panels that are there.
#include "sim/place/free_place.h"

#include <gtest/gtest.h>

#include "sim/pattern/outline.h"
#include "tests/sim/place/support.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

Eigen::AlignedBox3d box_of(const Panel& panel) {
    Eigen::AlignedBox3d box;
    for (const OutlineEdge& edge : panel.edges) {
        for (int i = 0; i < 50; ++i) box.extend(panel.place(outline_point(panel, edge, i / 50.0)));
    }
    return box;
}

double distance_to(const Body& body, const Eigen::AlignedBox3d& box) {
    double least = 100;
    for (const Vec3d& x : body.x) least = std::min(least, box.exteriorDistance(x));
    return least;
}

TEST(FreePlace, new_panels_stand_beside_each_other_before_the_body) {
    const Body& body = mannequin();
    Pattern pattern;
    for (int i = 0; i < 5; ++i) {
        Panel panel = unplaced_rectangle("panel", 0.3 + 0.05 * i, 0.4);
        place_freely(panel, pattern, &body);
        EXPECT_GT(panel.translation.z(), 0.3);
        EXPECT_GT(distance_to(body, box_of(panel)), 0.02);
        for (const Panel& other : pattern.panels)
            EXPECT_GT(box_of(panel).exteriorDistance(box_of(other)), kFreeGap - 1e-9);
        pattern.panels.push_back(panel);
    }
    EXPECT_NEAR(box_of(pattern.panels[0]).center().x(), 0, 1e-9) << "the first one in the middle";
}

TEST(FreePlace, a_copy_of_a_bent_panel_leaves_the_panel_and_the_body_to_the_side) {
    const Body& body = mannequin();
    Pattern pattern;
    pattern.body_height = height_range(body).high;
    Panel sleeve = unplaced_rectangle("panel", 0.4, 0.3);
    sleeve.wrap_radius = 0.1;
    sleeve.translation = {0.45, 1.1, 0.1};
    pattern.panels = {sleeve};
    Panel copy = sleeve;
    const Vec3d move = free_move(pattern, {copy}, &body);
    EXPECT_EQ(move.y(), 0);
    EXPECT_EQ(move.z(), 0);
    copy.translation += move;
    constexpr double bulge = 0.001;  // m, of the sleeve's edges between the points that the move knows
    EXPECT_GE(box_of(copy).exteriorDistance(box_of(sleeve)), kFreeGap - bulge);
    EXPECT_GE(distance_to(body, box_of(copy)), kFreeGap - bulge);
    EXPECT_TRUE(free_move(Pattern{}, {copy}, &body).isZero()) << "it is clear there";
    EXPECT_TRUE(free_move(pattern, {}, &body).isZero());
}

}  // namespace
}  // namespace selvedge::sim::test
