#include "render/figure_legend.h"

#include <gtest/gtest.h>

namespace selvedge {
namespace {

TEST(FigureLegend, limits_are_round_and_never_below_the_figure) {
    for (const auto& [value, round] :
         {std::pair{0.01, 0.01}, {0.011, 0.012}, {0.037, 0.04}, {0.071, 0.08}, {0.081, 0.1}, {6.0, 6.0}, {0.3, 0.3}})
        EXPECT_NEAR(round_up(value), round, 1e-9 * round) << value;
}

TEST(FigureLegend, strain_is_written_in_percent_with_its_sign) {
    std::vector<double> strains(100, 0.001);
    strains[0] = -0.0423;
    strains[1] = 0.0961;
    strains[2] = 0.02;
    const Legend legend = strain_legend("Strain", 0.05, strains);
    ASSERT_EQ(legend.notes.size(), 3U);
    EXPECT_EQ(legend.notes[0][1], "+2.0 %");
    EXPECT_EQ(legend.notes[1][1], "+9.6 %");
    EXPECT_EQ(legend.notes[2][1], "-4.2 %");
    ASSERT_TRUE(legend.scale && legend.scale->ticks.size() == 3);
    EXPECT_EQ(legend.scale->ticks[0].label, "-5 %");
    EXPECT_EQ(legend.scale->ticks[1].label, "0");
    EXPECT_EQ(legend.scale->ticks[2].label, "+5 %");
}

TEST(FigureLegend, no_strain_has_no_sign_of_compression) {
    EXPECT_EQ(strain_legend("Strain", 0.01, {-0.0001}).notes[1][1], "+0.0 %");
}

TEST(FigureLegend, clearance_is_written_in_millimetres_and_what_is_inside_is_said) {
    const Legend clear = clearance_legend(0.05, {0.003, 0.012, 0.1});
    EXPECT_EQ(clear.scale->ticks[1].label, "25");
    EXPECT_EQ(clear.scale->ticks[2].label, "50 mm");
    ASSERT_EQ(clear.notes.size(), 3U);
    EXPECT_EQ(clear.notes[0][1], "12 mm");
    EXPECT_EQ(clear.notes[2][1], "100 mm");
    const Legend inside = clearance_legend(0.05, {0.003, -0.0012});
    ASSERT_EQ(inside.notes.size(), 4U);
    EXPECT_EQ(inside.notes[3][1], "1.2 mm");
}

}  // namespace
}  // namespace selvedge
