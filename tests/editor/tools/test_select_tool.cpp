// Select and move, and what the host does for all tools.
#include <gtest/gtest.h>

#include "tests/editor/tools/sheet_hands.h"

namespace selvedge {
namespace {

TEST(SelectTool, a_click_selects_and_shift_adds_or_takes_away) {
    SheetHands hands;
    hands.click({0.1, 0.06});
    EXPECT_EQ(hands.document.selection().panels, (std::set<std::string>{"left"}));
    hands.click({0.4, 0.06}, {.shift = true});
    EXPECT_EQ(hands.document.selection().panels.size(), 2U);
    hands.click({0.1, 0.06}, {.shift = true});
    EXPECT_EQ(hands.document.selection().panels, (std::set<std::string>{"right"}));
    hands.click({0.25, 0.1});
    EXPECT_TRUE(hands.document.selection().is_empty());
}

TEST(SelectTool, dragging_a_panel_moves_it_as_one_entry_of_the_history) {
    SheetHands hands;
    hands.press({0.1, 0.06});
    hands.move({0.07, 0.06});
    hands.move({0.06, -0.031});
    EXPECT_TRUE(hands.document.is_attempting());
    const ToolOverlay overlay = hands.overlay();
    ASSERT_EQ(overlay.readout.size(), 3U);
    EXPECT_EQ(overlay.readout[0], "dx -4.0 cm");
    hands.release({0.06, -0.031});
    EXPECT_TRUE(hands.vertex("left", 0).isApprox(Vec2d(-0.04, -0.09), 1e-9)) << "whole steps of the grid";
    EXPECT_EQ(hands.document.position(), 1U);
    hands.document.undo();
    EXPECT_LT(hands.vertex("left", 0).norm(), 1e-9);
}

TEST(SelectTool, a_dragged_vertex_snaps_to_another_panels_vertex) {
    SheetHands hands;
    hands.drag({0.2, 0.2}, {0.304, 0.196});
    EXPECT_TRUE(hands.vertex("left", 2).isApprox(Vec2d(0.3, 0.2), 1e-9));
    EXPECT_EQ(hands.pattern().panels.size(), 2U);
}

TEST(SelectTool, an_edge_moves_with_both_its_ends) {
    SheetHands hands;
    hands.drag({0.05, 0.2}, {0.05, 0.25}, {.ctrl = true});
    EXPECT_NEAR(hands.vertex("left", 2).y(), 0.25, 1e-9);
    EXPECT_NEAR(hands.vertex("left", 3).y(), 0.25, 1e-9);
    EXPECT_NEAR(hands.vertex("left", 0).y(), 0, 1e-9);
}

TEST(SelectTool, escape_in_a_drag_puts_all_back) {
    SheetHands hands;
    hands.press({0.1, 0.06});
    hands.move({0.1, 0.15});
    hands.key(Key::Escape);
    EXPECT_LT(hands.vertex("left", 0).norm(), 1e-9);
    hands.release({0.1, 0.15});
    EXPECT_EQ(hands.document.position(), 0U);
    EXPECT_FALSE(hands.document.is_attempting());
}

TEST(SelectTool, an_alt_drag_leaves_a_copy) {
    SheetHands hands;
    hands.drag({0.1, 0.06}, {0.1, 0.36}, {.alt = true});
    ASSERT_EQ(hands.pattern().panels.size(), 3U);
    EXPECT_LT(hands.vertex("left", 0).norm(), 1e-9) << "the panel itself stays";
    EXPECT_TRUE(hands.vertex(hands.pattern().panels[2].name, 0).isApprox(Vec2d(0, 0.3), 1e-9));
}

TEST(SelectTool, a_box_to_the_right_takes_what_is_inside) {
    SheetHands hands;
    hands.drag({-0.05, 0.25}, {0.45, -0.05});
    EXPECT_EQ(hands.document.selection().panels, (std::set<std::string>{"left"}));
    hands.drag({0.45, -0.05}, {0.15, 0.25});
    EXPECT_EQ(hands.document.selection().panels.size(), 2U) << "to the left: what it touches";
}

TEST(SelectTool, arrows_nudge_by_a_millimetre_and_with_shift_by_a_centimetre) {
    SheetHands hands;
    EXPECT_FALSE(hands.key(Key::Right)) << "nothing is selected";
    hands.click({0.1, 0.06});
    EXPECT_TRUE(hands.key(Key::Right));
    EXPECT_TRUE(hands.key(Key::Up, {.shift = true}));
    EXPECT_TRUE(hands.vertex("left", 0).isApprox(Vec2d(0.001, 0.01), 1e-9));
}

TEST(SelectTool, a_typed_way_moves_the_selection) {
    SheetHands hands;
    hands.click({0.1, 0.06});
    hands.type("10/4 x -1");
    EXPECT_TRUE(hands.vertex("left", 0).isApprox(Vec2d(0.025, -0.01), 1e-9));
}

TEST(ToolHost, what_cannot_be_is_said_and_the_panel_stays_sound) {
    SheetHands hands;
    hands.press({0.2, 0.2});
    hands.move({0.1, 0.1}, {.ctrl = true});
    hands.move({-0.2, -0.2}, {.ctrl = true});
    EXPECT_FALSE(hands.message().empty());
    hands.release({-0.2, -0.2}, {.ctrl = true});
    EXPECT_GT(hands.vertex("left", 2).x(), 0) << "the last place that could be";
}

TEST(ToolHost, delete_takes_out_what_is_selected) {
    SheetHands hands;
    hands.click({0.1, 0.06});
    EXPECT_TRUE(hands.key(Key::Delete));
    ASSERT_EQ(hands.pattern().panels.size(), 1U);
    EXPECT_EQ(hands.pattern().panels[0].name, "right");
    EXPECT_FALSE(hands.key(Key::Delete));
}

TEST(ToolHost, keys_choose_tools_but_not_while_a_number_is_typed) {
    SheetHands hands;
    EXPECT_TRUE(hands.key(key_of('S')));
    EXPECT_EQ(hands.tools.kind(), ToolKind::Rectangle);
    hands.type("30", Key::None);
    hands.key(key_of('X'));
    EXPECT_EQ(hands.tools.kind(), ToolKind::Rectangle);
    EXPECT_FALSE(hands.key(key_of('Z'), {.ctrl = true})) << "undo is not the sheet's";
}

TEST(ToolHost, escape_ends_what_is_typed_then_what_is_selected_then_the_tool) {
    SheetHands hands;
    hands.click({0.1, 0.06});
    hands.choose(ToolKind::AddPoint);
    hands.type("5", Key::None);
    EXPECT_TRUE(hands.key(Key::Escape));
    EXPECT_FALSE(hands.document.selection().is_empty());
    EXPECT_TRUE(hands.key(Key::Escape));
    EXPECT_TRUE(hands.document.selection().is_empty());
    EXPECT_TRUE(hands.key(Key::Escape));
    EXPECT_EQ(hands.tools.kind(), ToolKind::Select);
    EXPECT_FALSE(hands.key(Key::Escape));
}

TEST(ToolHost, every_tool_has_a_name_a_hint_and_a_key_of_its_own) {
    SheetHands hands;
    std::set<Key> keys;
    std::set<std::string_view> ids;
    for (const ToolInfo& info : all_tools()) {
        hands.choose(info.kind);
        EXPECT_EQ(hands.tools.kind(), info.kind);
        EXPECT_FALSE(hands.tools.hint(hands.desk()).empty()) << info.id;
        EXPECT_TRUE(keys.insert(info.key).second) << info.id;
        EXPECT_TRUE(ids.insert(info.id).second) << info.id;
        EXPECT_NE(info.key, key_of('F')) << "frames the view";
    }
}

TEST(ToolHost, no_tool_minds_any_click_or_key_on_an_empty_sheet) {
    for (const ToolInfo& info : all_tools()) {
        SheetHands hands(PatternDocument{});
        hands.choose(info.kind);
        hands.key(Key::Enter);
        hands.drag({0.1, 0.1}, {0.1, 0.1004});
        hands.click({0.3, 0.2}, {.ctrl = true, .alt = true});
        hands.double_click({0.2, 0.05});
        for (const char* typed : {"0", "-3", "1e9", "5x0x7", "((", "1/0"}) hands.type(typed);
        hands.key(key_of('R'));
        hands.key(Key::Backspace);
        hands.overlay();
        hands.key(Key::Escape);
        hands.drag({0.4, 0.1}, {0.1, 0.3}, {.shift = true});
        hands.overlay();
    }
}

}  // namespace
}  // namespace selvedge
