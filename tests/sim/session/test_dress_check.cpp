#include "sim/session/dress_check.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/sim/dress/shapes.h"

namespace selvedge::sim::test {
namespace {

std::vector<std::string> lines_of(const Pattern& pattern, const DressCheck& check = {}) {
    std::vector<std::string> lines;
    for (const Fault& fault : dress_faults(pattern, "f.json", check)) {
        EXPECT_EQ(fault.severity, Severity::Error);
        lines.push_back(describe(fault));
    }
    return lines;
}

TEST(DressCheck, finds_nothing_in_a_garment_that_can_be_dressed_or_was_only_begun) {
    EXPECT_EQ(lines_of(tube(0.5, 0.4, 1, 1.4)), std::vector<std::string>());
    EXPECT_EQ(lines_of(Pattern()), std::vector<std::string>());
}

TEST(DressCheck, names_every_fabric_that_cannot_be_found) {
    Pattern pattern = tube(0.5, 0.4, 1, 1.4);
    pattern.fabric = "nosuch";
    pattern.panels[0].fabric = "missing.json";
    pattern.panels[0].interlinings = {"linen", "neither"};
    const std::vector<std::string> lines = lines_of(pattern);
    const std::string panel = "f.json: pattern.panels." + pattern.panels[0].name + ".selvedge.";
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].rfind("f.json: selvedge.fabric: no fabric 'nosuch': known are", 0), 0U) << lines[0];
    EXPECT_EQ(lines[1].rfind(panel + "fabric: missing.json: cannot read", 0), 0U) << lines[1];
    EXPECT_EQ(lines[2].rfind(panel + "interlinings[1]: no fabric 'neither'", 0), 0U) << lines[2];
    EXPECT_EQ(lines_of(pattern, {.has_fabrics = false}).size(), 1U) << "interlinings stay";
}

TEST(DressCheck, names_the_body_by_what_says_it) {
    Pattern pattern = tube(0.5, 0.4, 1, 1.4);
    pattern.body_height = 0.4;
    EXPECT_EQ(lines_of(pattern)[0].rfind("f.json: selvedge.body_height: mannequin: height: 40 cm is not between", 0),
              0U);
    pattern.body = "mannequin:bust=7";
    EXPECT_EQ(lines_of(pattern)[0].rfind("f.json: selvedge.body: mannequin: bust: 7 cm is not between", 0), 0U);
    pattern.body = "missing.obj";
    EXPECT_EQ(lines_of(pattern)[0].rfind("f.json: selvedge.body: missing.obj: cannot read", 0), 0U);
    EXPECT_TRUE(lines_of(pattern, {.makes_body_and_mesh = false}).empty());
}

TEST(DressCheck, names_the_panels_of_seams_that_cannot_be_closed) {
    Pattern pattern = tube(0.5, 0.4, 1, 1.4);
    ASSERT_GE(pattern.seams.size(), 1U);
    Panel third = pattern.panels[0];
    third.name = "third";
    pattern.panels.push_back(third);
    Seam again = pattern.seams[0];
    again.second = {.panel = static_cast<int>(pattern.panels.size()) - 1, .edge = again.first.edge};
    pattern.seams.push_back(again);
    const std::vector<std::string> lines = lines_of(pattern);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].rfind("f.json: pattern.stitches: sewn like this, more than two edges meet in one line, of '", 0),
              0U)
        << lines[0];
    EXPECT_NE(lines[0].find("'third'"), std::string::npos) << lines[0];
}

TEST(DressCheck, wants_a_panel_that_is_worn) {
    Pattern pattern = tube(0.5, 0.4, 1, 1.4);
    for (Panel& panel : pattern.panels) panel.is_worn = false;
    EXPECT_EQ(lines_of(pattern),
              std::vector<std::string>{"f.json: pattern.panels: no panel that is worn: nothing to dress"});
}

}  // namespace
}  // namespace selvedge::sim::test
