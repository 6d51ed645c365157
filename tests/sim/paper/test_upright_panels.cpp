// Which end is up of pieces that lie across the table, as plotters' files have them.
#include "sim/paper/upright_panels.h"

#include <gtest/gtest.h>
#include <numbers>

#include "sim/pattern/edge_shape.h"
#include "tests/support/polygon.h"

namespace selvedge::sim {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

Panel front() {
    return sim::polygon("TEE FRONT", {{-0.26, 0},
                                      {0.26, 0},
                                      {0.26, 0.45},
                                      {0.21, 0.5},
                                      {0.2, 0.68},
                                      {0.09, 0.72},
                                      {0, 0.62},
                                      {-0.09, 0.72},
                                      {-0.2, 0.68},
                                      {-0.21, 0.5},
                                      {-0.26, 0.45}});
}

Panel sleeve() {
    return sim::polygon("TEE SLEEVE", {{-0.1, 0}, {0.1, 0}, {0.18, 0.45}, {0.05, 0.55}, {-0.05, 0.55}, {-0.18, 0.45}});
}

// A leg without outer seam, whose waist slopes: wider at the waist than at the hem.
Panel whole_leg() {
    return sim::polygon(
        "LEG LONG",
        {{-0.11, 0}, {0.11, 0}, {0.28, 0.72}, {0.2, 0.85}, {0.2, 0.98}, {-0.2, 0.95}, {-0.2, 0.85}, {-0.28, 0.72}});
}

// With its top to the right or to the left; the grain of such files runs one way or the other.
Panel laid(const Panel& panel, bool is_top_right, double grain) {
    Panel across = mapped_panel(panel, Eigen::Affine2d(Eigen::Rotation2Dd(is_top_right ? -kQuarter : kQuarter)));
    across.grain_angle = grain;
    return across;
}

bool stands(const Panel& panel, const Panel& upright) {
    return (panel.vertices[0] - upright.vertices[0]).norm() < 1e-9;
}

TEST(TurnUpright, finds_the_top_of_bodices_sleeves_and_legs_whichever_way_the_grain_runs) {
    for (const bool is_top_right : {false, true}) {
        for (const double grain : {-kQuarter, kQuarter}) {
            const std::vector<Panel> upright{front(), sleeve(), whole_leg()};
            std::vector<Panel> panels;
            for (const Panel& panel : upright) panels.push_back(laid(panel, is_top_right, grain));
            turn_upright(panels);
            for (std::size_t p = 0; p < panels.size(); ++p) EXPECT_TRUE(stands(panels[p], upright[p])) << p << grain;
        }
    }
}

TEST(TurnUpright, turns_each_piece_by_its_own_shape_and_those_without_one_with_the_others) {
    const Panel pocket = sim::polygon("POCKET", {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}});
    std::vector<Panel> panels{laid(front(), true, kQuarter), laid(sleeve(), false, kQuarter),
                              laid(pocket, true, kQuarter)};
    turn_upright(panels);
    EXPECT_TRUE(stands(panels[0], front()));
    EXPECT_TRUE(stands(panels[1], sleeve()));
    EXPECT_TRUE(stands(panels[2], pocket)) << "as the front, which is larger than the sleeve";
}

TEST(TurnUpright, leaves_pieces_with_an_upright_grain_as_they_are_drawn) {
    Panel head_down = mapped_panel(front(), Eigen::Affine2d(Eigen::Rotation2Dd(2 * kQuarter)));
    head_down.grain_angle = 0;
    std::vector<Panel> panels{head_down};
    turn_upright(panels);
    EXPECT_TRUE(stands(panels[0], head_down));
}

}  // namespace
}  // namespace selvedge::sim
