// Drawings that nest, repeat or count beyond measure, and numbers that are none: they are refused with a line, or read
// as what they say.
#include <gtest/gtest.h>

#include "sim/paper/svg_shapes.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

std::string svg_problem(const std::string& elements) {
    return problem_of(svg(elements), [](const std::string& text) { return read_svg_document(text, "a.svg"); });
}

std::size_t seen_shapes(const std::string& elements) {
    return read_svg_document(svg(elements), "a.svg").shapes.size();
}

const std::string kSquare = "<path class='a' d='M0,0H9V9H0Z'/>";

TEST(SvgStyles, follow_media_rules_in_each_other_to_a_depth) {
    const auto nested = [](int depth) {
        return "<style>" + repeated("@media screen{", depth) + ".a{display:none}" + repeated("}", depth) + "</style>" +
               kSquare;
    };
    EXPECT_EQ(seen_shapes(nested(10)), 0U);
    EXPECT_EQ(seen_shapes(nested(30000)), 1U);
}

TEST(SvgStyles, tell_of_rules_that_could_hide_and_are_left_out) {
    const auto notes = [](const std::string& css) {
        return read_svg_document(svg("<style>" + css + "</style>" + kSquare), "a.svg").notes;
    };
    EXPECT_TRUE(notes(".a:hover{fill:none}").empty());
    ASSERT_EQ(notes(".a:not(.b){display:none !important}").size(), 1U);
    ASSERT_EQ(notes(repeated(".b{fill:red}", 2000) + ".a{display:none}").size(), 1U);
    // What says nothing of what is drawn is no rule.
    EXPECT_EQ(notes(repeated(".b{font-size:1px}", 2000) + ".a{display:none}")[0], "1 hidden element left out");
}

TEST(SvgStyles, refuse_more_rules_than_they_can_compare_with_elements) {
    const std::string file = "<style>" + repeated("x .a{fill:red}", 2000) + "</style>" + repeated("<g>", 100) +
                             repeated(kSquare, 4000) + repeated("</g>", 100);
    EXPECT_EQ(svg_problem(file), "a.svg: its style sheets have too many rules for so many elements");
}

TEST(SvgStyles, let_a_child_draw_what_its_parent_does_not) {
    const auto shapes = [](const std::string& parent, const std::string& child) {
        return seen_shapes("<g fill='none' stroke='black' " + parent + "><path d='M0,0H9' " + child + "/></g>");
    };
    EXPECT_EQ(shapes("stroke-width='0'", ""), 0U);
    EXPECT_EQ(shapes("stroke-width='0'", "stroke-width='2'"), 1U);
    EXPECT_EQ(shapes("stroke-width='0'", "stroke-opacity='1'"), 0U);
    EXPECT_EQ(shapes("stroke-opacity='0'", "stroke-width='2'"), 0U);
}

}  // namespace
}  // namespace selvedge::sim
