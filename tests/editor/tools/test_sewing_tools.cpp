#include <gtest/gtest.h>

#include <algorithm>

#include "editor/geometry/draft.h"
#include "editor/tools/sewing_tools.h"
#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

bool has_warning(const ToolOverlay& overlay) {
    return std::any_of(overlay.lines.begin(), overlay.lines.end(),
                       [](const OverlayLine& line) { return line.tone == OverlayTone::Warning; });
}

TEST(SewingTool, the_ends_that_are_clicked_meet) {
    SheetUser user;
    user.choose("segment_sewing");
    user.click({0.2, 0.03});  // edge 1 of `left` points up: near its start
    user.click({0.3, 0.04});  // edge 3 of `right` points down: near its end
    ASSERT_EQ(user.pattern().seams.size(), 1U);
    EXPECT_EQ(user.pattern().seams[0].first, (sim::SeamSide{0, 1}));
    EXPECT_EQ(user.pattern().seams[0].second, (sim::SeamSide{1, 3}));
    EXPECT_TRUE(user.pattern().seams[0].is_reversed);
}

TEST(SewingTool, warns_of_crossed_threads_and_r_turns_the_second_edge) {
    SheetUser user;
    user.choose("segment_sewing");
    user.click({0.2, 0.03});
    user.move({0.3, 0.04});
    EXPECT_FALSE(has_warning(user.overlay()));
    user.move({0.3, 0.17});
    EXPECT_TRUE(has_warning(user.overlay()));
    EXPECT_TRUE(user.key(key_of('R')));
    EXPECT_FALSE(has_warning(user.overlay()));
    user.click({0.3, 0.17});
    EXPECT_TRUE(user.pattern().seams.at(0).is_reversed);
    EXPECT_EQ(user.tools.info().id, "segment_sewing") << "R is not Rotate here";
}

TEST(SewingTool, tells_both_lengths_and_their_difference) {
    SheetUser user;
    user.document.run(MoveVertices{{{"right", 3}}, Vec2d(0, 0.0032)});
    user.choose("segment_sewing");
    user.click({0.2, 0.03});
    user.move({0.3, 0.04});
    const std::vector<std::string> readout = user.overlay().readout;
    ASSERT_EQ(readout.size(), 2U);
    EXPECT_EQ(readout[0], "20.0 cm to 20.32 cm");
    EXPECT_EQ(readout[1], "+3.2 mm");
}

TEST(SewingTool, leaves_seams_of_hidden_and_locked_panels_alone) {
    for (const bool is_hidden : {false, true}) {
        SheetUser user;
        user.document.run(SewEdges{{"left", 1}, {"right", 3}, true});
        user.choose("segment_sewing");
        user.click({0.3, 0.05});
        const std::set<std::string> names{"left"};
        if (is_hidden)
            user.document.set_panel_states({.hidden = names, .locked = {}});
        else
            user.document.set_panel_states({.hidden = {}, .locked = names});
        Selection selection;
        selection.seams = {0};
        user.document.select(selection);
        user.key(key_of('R'));
        user.key(Key::Delete);
        ASSERT_EQ(user.pattern().seams.size(), 1U) << is_hidden;
        EXPECT_TRUE(user.pattern().seams[0].is_reversed) << is_hidden;
    }
}

TEST(SewingTool, a_sewn_edge_is_selected_and_r_or_a_click_on_its_mark_reverses_it) {
    SheetUser user;
    user.document.run(SewEdges{{"left", 1}, {"right", 3}, true});
    user.choose("segment_sewing");
    user.click({0.3, 0.05});
    EXPECT_EQ(user.document.selection().seams, (std::set<int>{0}));
    user.key(key_of('R'));
    EXPECT_FALSE(user.pattern().seams[0].is_reversed);
    user.click({0.2, 0.1});
    EXPECT_TRUE(user.pattern().seams[0].is_reversed);
    user.key(Key::Delete);
    EXPECT_TRUE(user.pattern().seams.empty());
}

TEST(SewingTool, an_edge_is_not_sewn_to_itself) {
    SheetUser user;
    user.choose("segment_sewing");
    user.click({0.2, 0.03});
    user.click({0.2, 0.16});
    EXPECT_TRUE(user.pattern().seams.empty());
    EXPECT_FALSE(user.message().empty());
}

TEST(FreeSewingTool, sews_parts_of_edges_that_are_dragged_over) {
    SheetUser user;
    user.choose("free_sewing");
    user.drag({0.2, 0.0}, {0.2, 0.1});
    user.drag({0.3, 0.0}, {0.3, 0.098});
    ASSERT_EQ(user.pattern().seams.size(), 1U);
    EXPECT_TRUE(user.pattern().seams[0].is_reversed) << "one was drawn along its outline, the other against it";
    EXPECT_EQ(user.panel("left").vertices.size(), 5U);
    ASSERT_EQ(user.panel("right").vertices.size(), 5U);
    double lowest = 1;
    for (int i = 0; i < 5; ++i) {
        const Vec2d at = user.vertex("right", i);
        if (at.y() > 0.01 && at.y() < 0.19) lowest = at.y();
    }
    EXPECT_NEAR(lowest, 0.1, 1e-9) << "as long as the first";
}

TEST(FreeSewingTool, one_run_is_sewn_to_several_with_shift) {
    sim::PatternDocument source = two_squares();
    source.pattern.panels[1] = square_panel("right", {0.3, 0}, {0.5, 0.1});
    source.pattern.panels.push_back(square_panel("upper", {0.3, 0.12}, {0.5, 0.22}));
    SheetUser user(source);
    user.choose("free_sewing");
    user.click({0.2, 0.03});
    user.click({0.3, 0.02}, {.shift = true});
    user.click({0.3, 0.13}, {.shift = true});
    EXPECT_TRUE(user.pattern().seams.empty()) << "more may come";
    EXPECT_TRUE(user.key(Key::Enter));
    EXPECT_EQ(user.message(), "");
    EXPECT_EQ(user.pattern().seams.size(), 2U);
    EXPECT_EQ(user.panel("left").vertices.size(), 5U);
}

TEST(FreeSewingTool, runs_are_put_in_the_outlines_order) {
    const SewnRun run = run_of({{{"a", 2}, 1, 0}, {{"a", 1}, 1, 0.4}});
    EXPECT_FALSE(run.is_forward);
    ASSERT_EQ(run.spans.size(), 2U);
    EXPECT_EQ(run.spans[0], (SpanRef{"a", 1, 0.4, 1}));
    EXPECT_EQ(run.spans[1], (SpanRef{"a", 2, 0, 1}));
    EXPECT_THROW(run_of({{{"a", 2}, 1, 0}, {{"a", 3}, 0, 1}}), GeometryError);
    EXPECT_THROW(run_of({}), GeometryError);
}

}  // namespace
}  // namespace selvedge::editor
