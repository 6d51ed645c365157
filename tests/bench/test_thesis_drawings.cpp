// The explanatory drawings of the thesis, whose contents come from small meshes and curves of the program.
#include <gtest/gtest.h>
#include <algorithm>
#include <string>

#include "bench/thesis/thesis.h"
#include "tests/bench/support.h"

namespace selvedge::bench {
namespace {

std::string drawing_named(const ThesisResult& result, const std::string& name) {
    const auto found = std::ranges::find(result.drawings, name, &Drawing::name);
    return found == result.drawings.end() ? std::string() : found->svg;
}

TEST(Thesis, drawings_of_the_mesh_show_what_it_permits) {
    const ThesisResult result = draw_mesh_structure(kQuick);
    EXPECT_EQ(occurrences(drawing_named(result, "3.14"), ">0.5 L<"), 3U) << "halves of one, and a new edge as long";
    EXPECT_EQ(occurrences(drawing_named(result, "3.2"), ">C<"), 3U) << "split at levels 0 to 2";
    const std::string edge = drawing_named(result, "3.10");
    const auto lines = [&](const std::string& colour) {
        return occurrences(edge, "stroke=\"" + colour + "\" stroke-width=\"4\"");
    };
    EXPECT_EQ(lines("#2e8b3a"), 2 * 2U) << "one edge of level 1, one of level 2; in both views";
    EXPECT_EQ(lines("#9a9a96"), 2 * 2U) << "the edges of level 3, the deepest";
    EXPECT_EQ(occurrences(edge, "r=\"5\" fill=\"#2e8b3a\""), 2U) << "only the centre of level 2 may rejoin";
}

// Figure 6.2: corners, and each other vertex of level 3 on one edge.
TEST(Thesis, the_order_of_edges_evaluates_each_vertex_once) {
    const std::string svg = drawing_named(draw_edge_curves(kQuick), "6.2");
    EXPECT_EQ(occurrences(svg, "<circle"), 45U);
    EXPECT_EQ(occurrences(svg, "r=\"3.5\" fill=\"#c0392b\""), 3 * 7U);
    EXPECT_EQ(occurrences(svg, "r=\"3.5\" fill=\"#2f6d8f\""), 3 * 3U);
    EXPECT_EQ(occurrences(svg, "r=\"3.5\" fill=\"#2e8b3a\""), 4 * 3U);
}

TEST(Thesis, drawings_of_garments_and_limbs_take_their_numbers_from_the_program) {
    const ThesisResult seams = draw_seams_and_pushes(kQuick);
    EXPECT_NE(drawing_named(seams, "4.5").find(">10.2 cm<"), std::string::npos) << "the mean of 10.0 and 10.4 cm";
    EXPECT_EQ(occurrences(drawing_named(seams, "4.4"), "r=\"7\" fill=\"#2f6d8f\""), 4U) << "merged vertices";
    const ThesisResult limbs = draw_limb_frames(kQuick);
    ASSERT_EQ(limbs.drawings.size(), 3U);
    EXPECT_NE(drawing_named(limbs, "5.2").find("32 slices"), std::string::npos);
    EXPECT_GT(occurrences(drawing_named(limbs, "5.3"), "<circle"), 50U) << "rigid vertices";
}

}  // namespace
}  // namespace selvedge::bench
