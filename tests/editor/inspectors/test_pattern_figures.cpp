// Measurements of a pattern, and the transforms and curves that typed values define.
#include "editor/inspectors/pattern_figures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_read.h"

namespace selvedge::editor {
namespace {

constexpr double kPi = std::numbers::pi;

sim::Panel square(double side) {
    sim::Panel panel;
    panel.name = "square";
    panel.vertices = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

TEST(Angles, are_those_that_files_have) {
    for (const Vec3d& degrees : {Vec3d(10, 20, 30), Vec3d(-170, 80, 5), Vec3d(0, 0, 180), Vec3d(90, -45, -90)}) {
        const Vec3d angles = angles_of(sim::rotation_from_degrees(degrees));
        EXPECT_TRUE(angles.isApprox(degrees * kPi / 180, 1e-9)) << angles.transpose() * 180 / kPi;
    }
}

TEST(Angles, come_round_to_the_same_rotation_also_where_two_axes_fall_together) {
    for (const double y : {90.0, -90.0, 89.9999999, 90.0000001}) {
        for (const double x : {0.0, 35.0, -120.0}) {
            const Eigen::Matrix3d rotation = sim::rotation_from_degrees({x, y, 50});
            EXPECT_TRUE(rotation_of(angles_of(rotation)).isApprox(rotation, 1e-6)) << x << " " << y;
        }
    }
}

TEST(GarmentCentre, is_the_middle_of_all_panels_as_they_are_placed) {
    sim::Pattern pattern;
    pattern.panels = {square(1), square(1)};
    pattern.panels[1].translation = {3, 0, 2};
    EXPECT_TRUE(garment_centre(pattern).isApprox(Vec3d(2, 0.5, 1)));
    EXPECT_TRUE(garment_centre({}).isZero());
}

TEST(ScaleAbout, leaves_the_centre_where_it_is) {
    const PlaneMap map = scale_about({2, 3}, {1.5, 0.5});
    const Vec2d centre = map.x_axis * 2 + map.y_axis * 3 + map.shift;
    EXPECT_TRUE(centre.isApprox(Vec2d(2, 3)));
    EXPECT_TRUE((map.x_axis * 4 + map.y_axis * 3 + map.shift).isApprox(Vec2d(5, 3)));
}

TEST(WithKind, keeps_the_middle_of_the_curve) {
    sim::Panel panel = square(1);
    sim::OutlineEdge bulge = panel.edges[0];
    bulge.kind = sim::CurveKind::Quadratic;
    bulge.control[0] = {0.5, -0.6};
    const Vec2d middle = outline_point(panel, bulge, 0.5);
    for (const sim::CurveKind kind : {sim::CurveKind::Quadratic, sim::CurveKind::Cubic, sim::CurveKind::Arc}) {
        const sim::OutlineEdge curve = with_kind(panel, bulge, kind);
        EXPECT_EQ(curve.kind, kind);
        EXPECT_NEAR((outline_point(panel, curve, 0.5) - middle).norm(), 0, 1e-6) << static_cast<int>(kind);
        const sim::OutlineEdge cubic = with_kind(panel, curve, sim::CurveKind::Cubic);
        EXPECT_NEAR((outline_point(panel, cubic, 0.5) - middle).norm(), 0, 0.005) << static_cast<int>(kind);
    }
    EXPECT_EQ(with_kind(panel, bulge, sim::CurveKind::Line).kind, sim::CurveKind::Line);
}

TEST(WithKind, a_line_becomes_an_arc_that_bulges_out) {
    const sim::Panel panel = square(1);
    const sim::OutlineEdge arc = with_kind(panel, panel.edges[0], sim::CurveKind::Arc);
    EXPECT_LT(outline_point(panel, arc, 0.5).y(), -0.05);
    EXPECT_GE(arc.arc_radius, least_arc_radius(panel, arc));
}

TEST(WithKind, arcs_of_more_than_half_the_circle_and_hollow_ones_keep_their_side) {
    sim::Panel panel = square(1);
    for (const double height : {-0.9, -0.2, 0.2, 0.9}) {
        sim::OutlineEdge curve = panel.edges[0];
        curve.kind = sim::CurveKind::Quadratic;
        curve.control[0] = {0.5, 2 * height};
        const sim::OutlineEdge arc = with_kind(panel, curve, sim::CurveKind::Arc);
        EXPECT_NEAR(outline_point(panel, arc, 0.5).y(), height, 1e-6);
    }
}

TEST(ShiftForLength, starts_from_the_edge_as_it_was_also_while_another_length_is_tried) {
    sim::Panel panel = square(1);
    const LengthChange change{.before = 1, .after = 1.5};
    EXPECT_TRUE(shift_for_length(panel, panel.edges[0], change).isApprox(Vec2d(0.5, 0)));
    panel.vertices[1] = {1.2, 0};  // previewed
    EXPECT_TRUE(shift_for_length(panel, panel.edges[0], change).isApprox(Vec2d(0.5, 0)));
    EXPECT_TRUE(shift_for_length(panel, panel.edges[0], {.before = 1, .after = 0}).isZero());
}

TEST(SeamMeasures, tell_which_seams_are_wrong) {
    sim::Pattern pattern;
    pattern.panels = {square(1), square(1.002)};
    pattern.panels[1].name = "other";
    sim::Seam seam{.first = {0, 1}, .second = {1, 3}};
    EXPECT_TRUE(seam_measures(pattern, seam).is_wrong());
    EXPECT_EQ(difference_text(seam_measures(pattern, seam)), "+2 mm");
    seam.is_eased = true;
    EXPECT_FALSE(seam_measures(pattern, seam).is_wrong());
    pattern.panels[1] = square(1.0005);
    EXPECT_FALSE(seam_measures(pattern, seam).is_uneven) << "half a millimetre is no difference";
}

}  // namespace
}  // namespace selvedge::editor
