#include "sim/pattern/seam_name.h"

#include <gtest/gtest.h>

#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge {
namespace {

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
}  // namespace selvedge
