#include <gtest/gtest.h>
#include <cmath>

#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

Panel wrapped(bool is_mirrored) {
    Panel panel;
    panel.is_mirrored = is_mirrored;
    panel.wrap_radius = 0.15;
    panel.translation = {0.1, 1.2, 0.3};
    return panel;
}

TEST(PanelPlace, a_wrap_keeps_lengths_along_x_and_y) {
    for (const bool is_mirrored : {false, true}) {
        const Panel panel = wrapped(is_mirrored);
        double length = 0;
        constexpr int kSteps = 10000;
        for (int i = 0; i < kSteps; ++i) {
            const auto at = [&](int step) { return panel.place({-0.2 + 0.5 * step / kSteps, 0.4}); };
            length += (at(i + 1) - at(i)).norm();
        }
        EXPECT_NEAR(length, 0.5, 1e-8);
        EXPECT_NEAR((panel.place({0.1, 0.7}) - panel.place({0.1, 0.2})).norm(), 0.5, 1e-12);
    }
}

// Panels are stored as seen from the right side, with x to the right and y up, so x cross y points out of it.
TEST(PanelPlace, the_right_side_of_a_wrap_looks_away_from_its_axis) {
    for (const bool is_mirrored : {false, true}) {
        const Panel panel = wrapped(is_mirrored);
        const double side = is_mirrored ? -1 : 1;
        const Vec3d axis = panel.translation - Vec3d(0, 0, side * panel.wrap_radius);
        for (const double x : {-0.2, -0.01, 0.0, 0.1, 0.3}) {
            const Vec2d u(x, 0.25);
            const double step = 1e-6;
            const Vec3d along_x = panel.place(u + Vec2d(step, 0)) - panel.place(u - Vec2d(step, 0));
            const Vec3d along_y = panel.place(u + Vec2d(0, step)) - panel.place(u - Vec2d(0, step));
            Vec3d outward = panel.place(u) - axis;
            outward.y() = 0;
            EXPECT_NEAR(outward.norm(), panel.wrap_radius, 1e-12);
            EXPECT_NEAR(along_x.cross(along_y).normalized().dot(outward.normalized()), 1, 1e-6);
        }
    }
}

TEST(PanelPlace, a_wrap_and_a_flat_panel_touch_at_x_0) {
    for (const bool is_mirrored : {false, true}) {
        const Panel bent = wrapped(is_mirrored);
        Panel flat = bent;
        flat.wrap_radius = 0;
        EXPECT_TRUE(bent.place({0, 0.3}).isApprox(flat.place({0, 0.3}), 1e-15));
        EXPECT_NEAR((bent.place({0.001, 0.3}) - flat.place({0.001, 0.3})).norm(), 0, 1e-5);
        EXPECT_GT((bent.place({0.1, 0.3}) - flat.place({0.1, 0.3})).norm(), 1e-2);
    }
}

TEST(SeamName, follows_from_the_edges_unless_the_seam_has_its_own) {
    Pattern pattern = parse_pattern(sample_text(), "").pattern;
    EXPECT_EQ(seam_name(pattern, pattern.seams[0]), "front.1+back.2");
    pattern.seams[0].name = "left side";
    EXPECT_EQ(seam_name(pattern, pattern.seams[0]), "left side");
}

TEST(SeamName, finds_seams_by_name_by_edges_in_either_order_and_by_label) {
    Pattern pattern = parse_pattern(sample_text(), "").pattern;
    pattern.seams[0].name = "left side";
    pattern.panels[0].edges[1].label = "side";
    pattern.panels[1].edges[0].label = "side";
    EXPECT_EQ(find_seams(pattern, "left side"), (std::vector<int>{0}));
    EXPECT_EQ(find_seams(pattern, "front.3+back.0"), (std::vector<int>{1}));
    EXPECT_EQ(find_seams(pattern, "back.0+front.3"), (std::vector<int>{1}));
    EXPECT_EQ(find_seams(pattern, "side"), (std::vector<int>{0, 1}));
    EXPECT_TRUE(find_seams(pattern, "front.3").empty());
    EXPECT_TRUE(find_seams(pattern, "").empty());
}

}  // namespace

}  // namespace selvedge::sim
