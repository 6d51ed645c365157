// The select tool and ToolHost; then edit point, add point, curve, notch, dart, rotate, scale, merge, unfold, measure.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>

#include "editor/tools/outline_tools.h"
#include "editor/tools/tool.h"
#include "sim/pattern/outline.h"
#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

TEST(SelectTool, a_click_selects_and_shift_adds_or_takes_away) {
    SheetUser user;
    user.click({0.1, 0.06});
    EXPECT_EQ(user.document.selection().panels, (std::set<std::string>{"left"}));
    user.click({0.4, 0.06}, {.shift = true});
    EXPECT_EQ(user.document.selection().panels.size(), 2U);
    user.click({0.1, 0.06}, {.shift = true});
    EXPECT_EQ(user.document.selection().panels, (std::set<std::string>{"right"}));
    user.click({0.25, 0.1});
    EXPECT_TRUE(user.document.selection().is_empty());
}

TEST(SelectTool, dragging_a_panel_moves_it_as_one_entry_of_the_history) {
    SheetUser user;
    user.press({0.1, 0.06});
    user.move({0.07, 0.06});
    user.move({0.06, -0.031});
    EXPECT_TRUE(user.document.is_previewing());
    const ToolOverlay overlay = user.overlay();
    ASSERT_EQ(overlay.readout.size(), 3U);
    EXPECT_EQ(overlay.readout[0], "dx -4.0 cm");
    user.release({0.06, -0.031});
    EXPECT_TRUE(user.vertex("left", 0).isApprox(Vec2d(-0.04, -0.09), 1e-9)) << "whole steps of the grid";
    EXPECT_EQ(user.document.position(), 1U);
    user.document.undo();
    EXPECT_LT(user.vertex("left", 0).norm(), 1e-9);
}

TEST(SelectTool, a_dragged_vertex_snaps_to_another_panels_vertex) {
    SheetUser user;
    user.drag({0.2, 0.2}, {0.304, 0.196});
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.3, 0.2), 1e-9));
    EXPECT_EQ(user.pattern().panels.size(), 2U);
}

// What is linked moves along, so it says nothing about where the point should go.
TEST(SelectTool, a_dragged_point_does_not_snap_to_points_that_follow_it) {
    SheetUser halves;
    halves.document.run(UnfoldPanel{.panel = "left", .edge = 3, .is_linked = true});
    SheetUser copies;
    copies.document.run(SymmetricCopy{.panels = {"left"}, .is_linked = true, .shift = Vec2d(0.7, 0)});
    for (SheetUser* user : {&halves, &copies}) {
        user->choose("edit_point");
        user->press({0.2, 0.2});
        for (int i = 1; i <= 9; ++i) user->move({0.2 + 0.003 * i, 0.2 + 0.003 * i});
        user->release({0.227, 0.227});
        EXPECT_TRUE(user->vertex("left", 2).isApprox(Vec2d(0.225, 0.225), 1e-9)) << user->vertex("left", 2).transpose();
    }
    EXPECT_TRUE(halves.vertex("left", 5).isApprox(Vec2d(-0.225, 0.225), 1e-9)) << "the image";
}

// A point of the linked copy where the first move of a drag ends.
TEST(SelectTool, a_point_that_is_dragged_in_one_move_does_not_snap_to_points_that_follow_it) {
    SheetUser user;
    user.document.run(SymmetricCopy{.panels = {"left"}, .is_linked = true, .shift = Vec2d(0.7, 0)});
    user.document.run(MoveVertices{.vertices = {{"left", 2}}, .by = Vec2d(0.03, 0.03)});  // in line with no other point
    const Vec2d follower = user.vertex(user.pattern().panels.back().name, 2);
    user.choose("edit_point");
    user.press({0.23, 0.23});
    user.move(follower + Vec2d(0.004, 0.004));
    user.release(follower + Vec2d(0.004, 0.004));
    EXPECT_NEAR(user.vertex("left", 2).x(), follower.x() + 0.005, 1e-9);
}

TEST(SelectTool, select_all_and_boxes_pass_over_hidden_and_locked_panels) {
    SheetUser user;
    user.document.set_panel_states({.hidden = {}, .locked = {"left"}});
    user.key(key_of('A'), {.ctrl = true});
    EXPECT_EQ(user.document.selection().panels, std::set<std::string>{"right"});
    user.document.set_panel_states({.hidden = {"right"}, .locked = {}});
    user.drag({-0.05, -0.05}, {0.6, 0.3});
    EXPECT_EQ(user.document.selection().panels, std::set<std::string>{"left"});
}

TEST(SelectTool, a_locked_panel_that_is_selected_is_not_changed) {
    SheetUser user;
    user.document.set_panel_states({.hidden = {}, .locked = {"left"}});
    Selection both;
    both.panels = {"left", "right"};
    user.document.select(both);  // as clicks in the tree of objects do
    user.key(Key::Right);
    user.type("2");
    user.drag({0.4, 0.06}, {0.4, 0.11});
    user.choose("rotate");
    user.document.select(both);
    user.type("90");
    EXPECT_LT(user.vertex("left", 0).norm(), 1e-12);
    EXPECT_EQ(user.panel("left").vertices, two_squares().pattern.panels[0].vertices);
    EXPECT_GT((user.vertex("right", 0) - Vec2d(0.3, 0)).norm(), 0.02);
    user.document.select(both);
    user.key(Key::Delete);
    EXPECT_EQ(user.pattern().panels.size(), 1U);
    user.document.select(both);
    EXPECT_FALSE(user.key(Key::Delete));
    EXPECT_FALSE(user.key(Key::Right));
}

TEST(ToolHost, clears_the_hover_when_the_mouse_leaves_and_then_leaves_it_to_others) {
    SheetUser user;
    user.move({0.1, 0.06});
    EXPECT_EQ(user.hover.panel, "left");
    user.tools.leave(user.host());
    EXPECT_EQ(user.hover, Hover{});
    user.hover = {.panel = "right"};  // as a list beside the sheet does
    user.tools.leave(user.host());
    EXPECT_EQ(user.hover.panel, "right");
}

TEST(SelectTool, an_edge_moves_with_both_its_ends) {
    SheetUser user;
    user.drag({0.05, 0.2}, {0.05, 0.25}, {.ctrl = true});
    EXPECT_NEAR(user.vertex("left", 2).y(), 0.25, 1e-9);
    EXPECT_NEAR(user.vertex("left", 3).y(), 0.25, 1e-9);
    EXPECT_NEAR(user.vertex("left", 0).y(), 0, 1e-9);
}

TEST(SelectTool, escape_in_a_drag_puts_all_back) {
    SheetUser user;
    user.press({0.1, 0.06});
    user.move({0.1, 0.15});
    user.key(Key::Escape);
    EXPECT_LT(user.vertex("left", 0).norm(), 1e-9);
    user.release({0.1, 0.15});
    EXPECT_EQ(user.document.position(), 0U);
    EXPECT_FALSE(user.document.is_previewing());
}

TEST(SelectTool, an_alt_drag_leaves_a_copy) {
    SheetUser user;
    user.drag({0.1, 0.06}, {0.1, 0.36}, {.alt = true});
    ASSERT_EQ(user.pattern().panels.size(), 3U);
    EXPECT_LT(user.vertex("left", 0).norm(), 1e-9) << "the panel itself stays";
    EXPECT_TRUE(user.vertex(user.pattern().panels[2].name, 0).isApprox(Vec2d(0, 0.3), 1e-9));
}

TEST(SelectTool, an_alt_drag_of_several_panels_copies_their_seams) {
    SheetUser user;
    user.document.run(SewEdges{.first = {"left", 1}, .second = {"right", 3}});
    user.document.run(AddDart{.panel = "left", .edge = 0, .t = 0.5, .width = 0.02, .depth = 0.05});
    Selection both;
    both.panels = {"left", "right"};
    user.document.select(both);
    user.drag({0.1, 0.1}, {0.1, 0.4}, {.alt = true});
    ASSERT_EQ(user.pattern().panels.size(), 4U);
    ASSERT_EQ(user.pattern().seams.size(), 4U);
    for (const sim::Seam& seam : {user.pattern().seams[2], user.pattern().seams[3]}) {
        EXPECT_GE(seam.first.panel, 2);
        EXPECT_GE(seam.second.panel, 2);
    }
}

TEST(SelectTool, a_box_to_the_right_takes_what_is_inside) {
    SheetUser user;
    user.drag({-0.05, 0.25}, {0.45, -0.05});
    EXPECT_EQ(user.document.selection().panels, (std::set<std::string>{"left"}));
    user.drag({0.45, -0.05}, {0.15, 0.25});
    EXPECT_EQ(user.document.selection().panels.size(), 2U) << "to the left: what it touches";
}

TEST(SelectTool, arrows_nudge_by_a_millimetre_and_with_shift_by_a_centimetre) {
    SheetUser user;
    EXPECT_FALSE(user.key(Key::Right)) << "nothing is selected";
    user.click({0.1, 0.06});
    EXPECT_TRUE(user.key(Key::Right));
    EXPECT_TRUE(user.key(Key::Up, {.shift = true}));
    EXPECT_TRUE(user.vertex("left", 0).isApprox(Vec2d(0.001, 0.01), 1e-9));
}

TEST(SelectTool, a_typed_way_moves_the_selection) {
    SheetUser user;
    user.click({0.1, 0.06});
    user.type("10/4 x -1");
    EXPECT_TRUE(user.vertex("left", 0).isApprox(Vec2d(0.025, -0.01), 1e-9));
}

bool has_warning_line_through(const ToolOverlay& overlay, const Vec2d& point) {
    return std::any_of(overlay.lines.begin(), overlay.lines.end(), [&](const OverlayLine& line) {
        const auto is_there = [&](const Vec2d& p) { return (p - point).norm() < 1e-9; };
        return line.tone == OverlayTone::Warning && std::any_of(line.points.begin(), line.points.end(), is_there);
    });
}

TEST(ToolHost, a_drag_that_ends_where_the_outline_would_cross_itself_changes_nothing_and_says_why) {
    SheetUser user;
    user.press({0.2, 0.2});
    user.move({0.1, 0.15}, {.ctrl = true});
    ASSERT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.1, 0.15), 1e-9));
    user.move({-0.2, 0.1}, {.ctrl = true});
    user.release({-0.2, 0.1}, {.ctrl = true});
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.2, 0.2), 1e-9));
    EXPECT_EQ(user.document.position(), 0U);
    EXPECT_NE(user.message().find("would cross"), std::string::npos) << user.message();
    EXPECT_NE(user.message().find("as before the drag"), std::string::npos) << user.message();
    EXPECT_TRUE(user.overlay().problem.empty());
}

TEST(ToolHost, a_drag_shows_the_outline_that_cannot_be_with_the_reason_until_it_can) {
    SheetUser user;
    user.press({0.2, 0.2});
    user.move({0.1, 0.15}, {.ctrl = true});
    EXPECT_TRUE(user.overlay().problem.empty());
    user.move({-0.2, 0.1}, {.ctrl = true});
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.2, 0.2), 1e-9)) << "the panel is as before";
    EXPECT_NE(user.overlay().problem.find("would cross"), std::string::npos);
    EXPECT_TRUE(has_warning_line_through(user.overlay(), {-0.2, 0.1}));
    user.move({0.15, 0.15}, {.ctrl = true});
    EXPECT_TRUE(user.overlay().problem.empty());
    EXPECT_FALSE(has_warning_line_through(user.overlay(), {-0.2, 0.1}));
    EXPECT_EQ(user.message(), "");
    user.release({0.15, 0.15}, {.ctrl = true});
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.15, 0.15), 1e-9));
    EXPECT_EQ(user.document.position(), 1U);
    user.document.undo();
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.2, 0.2), 1e-9));
}

TEST(ToolHost, escape_ends_a_drag_that_is_not_possible) {
    SheetUser user;
    user.press({0.2, 0.2});
    user.move({-0.2, 0.1}, {.ctrl = true});
    ASSERT_FALSE(user.overlay().problem.empty());
    user.key(Key::Escape);
    EXPECT_TRUE(user.overlay().problem.empty());
    user.release({-0.2, 0.1}, {.ctrl = true});
    EXPECT_EQ(user.message(), "");
    EXPECT_EQ(user.document.position(), 0U);
}

TEST(ToolHost, a_seam_that_a_drag_would_make_too_uneven_leaves_both_panels_as_they_were) {
    SheetUser user;
    user.document.run(SewEdges{.first = {"left", 1}, .second = {"right", 3}});
    user.drag({0.2, 0.2}, {0.2, 0.04}, {.ctrl = true});
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.2, 0.2), 1e-9));
    EXPECT_NE(user.message().find("four times"), std::string::npos) << user.message();
    EXPECT_EQ(user.document.position(), 1U);
}

TEST(ToolHost, delete_takes_out_what_is_selected) {
    SheetUser user;
    user.click({0.1, 0.06});
    EXPECT_TRUE(user.key(Key::Delete));
    ASSERT_EQ(user.pattern().panels.size(), 1U);
    EXPECT_EQ(user.pattern().panels[0].name, "right");
    EXPECT_FALSE(user.key(Key::Delete));
}

TEST(ToolHost, keys_choose_tools_but_not_while_a_number_is_typed) {
    SheetUser user;
    EXPECT_TRUE(user.key(key_of('S')));
    EXPECT_EQ(user.tools.info().id, "rectangle");
    user.type("30", Key::None);
    user.key(key_of('X'));
    EXPECT_EQ(user.tools.info().id, "rectangle");
    EXPECT_FALSE(user.key(key_of('Z'), {.ctrl = true})) << "undo is not the sheet's";
}

TEST(ToolHost, escape_ends_what_is_typed_then_what_is_selected_then_the_tool) {
    SheetUser user;
    user.click({0.1, 0.06});
    user.choose("add_point");
    user.type("5", Key::None);
    EXPECT_TRUE(user.key(Key::Escape));
    EXPECT_FALSE(user.document.selection().is_empty());
    EXPECT_TRUE(user.key(Key::Escape));
    EXPECT_TRUE(user.document.selection().is_empty());
    EXPECT_TRUE(user.key(Key::Escape));
    EXPECT_EQ(user.tools.info().id, "select");
    EXPECT_FALSE(user.key(Key::Escape));
}

TEST(ToolHost, every_tool_has_a_name_a_hint_and_a_key_of_its_own) {
    SheetUser user;
    std::set<Key> keys;
    std::set<std::string_view> ids;
    for (const ToolInfo& info : all_tools()) {
        user.choose(info.id);
        EXPECT_EQ(user.tools.info().id, info.id);
        EXPECT_FALSE(user.tools.hint(user.host()).empty()) << info.id;
        EXPECT_TRUE(keys.insert(info.key).second) << info.id;
        EXPECT_TRUE(ids.insert(info.id).second) << info.id;
        EXPECT_NE(info.key, key_of('F')) << "frames the view";
    }
}

TEST(ToolHost, no_key_chooses_two_tools_in_either_key_map) {
    for (const KeyMap map : {KeyMap::Selvedge, KeyMap::MarvelousDesigner}) {
        std::set<Key> keys{key_of('F')};  // frames the view
        for (const ToolInfo& info : all_tools()) {
            for (const Key key : keys_of(info, map)) {
                if (key == Key::None) continue;
                EXPECT_TRUE(keys.insert(key).second) << info.id;
                SheetUser user;
                user.tools.key_map = map;
                user.choose(info.id == "select" ? "polygon" : "select");
                EXPECT_TRUE(user.key(key));
                EXPECT_EQ(user.tools.info().id, info.id);
            }
        }
    }
    EXPECT_EQ(tool_of_key(key_of('Q'))->id, "measure");
    EXPECT_EQ(tool_of_key(key_of('Q'), KeyMap::MarvelousDesigner)->id, "select");
    EXPECT_EQ(tool_of_key(key_of('V'), KeyMap::MarvelousDesigner)->id, "edit_point");
    EXPECT_EQ(tool_of_key(key_of('I'), KeyMap::MarvelousDesigner)->id, "internal_line");
}

TEST(AskedNumber, ends_a_drag_with_the_number_instead_of_the_mouse) {
    SheetUser user;
    const Vec2d before = user.vertex("left", 0);
    user.press({0.1, 0.1});
    user.move({0.14, 0.13});
    user.move({0.17, 0.15});
    ASSERT_TRUE(user.tools.ask_number(user.host()));
    user.move({0.5, 0.4});
    user.release({0.5, 0.4});
    EXPECT_TRUE(user.document.is_previewing()) << "it waits for the number";
    user.type("12.5x3");
    EXPECT_FALSE(user.tools.is_asking());
    EXPECT_FALSE(user.document.is_previewing());
    EXPECT_LT((user.vertex("left", 0) - before - Vec2d(0.125, 0.03)).norm(), 1e-9);
    EXPECT_TRUE(user.overlay().readout.empty()) << "the drag is over";
    user.move({0.6, 0.1});
    EXPECT_FALSE(user.document.is_previewing());
    user.document.undo();
    EXPECT_LT((user.vertex("left", 0) - before).norm(), 1e-9) << "one entry of the history";
}

TEST(AskedNumber, may_be_refused) {
    for (const Key key : {Key::Escape, Key::Enter}) {
        SheetUser user;
        const Vec2d before = user.vertex("left", 0);
        user.press({0.1, 0.1});
        user.move({0.15, 0.1});
        user.move({0.2, 0.1});
        ASSERT_TRUE(user.tools.ask_number(user.host()));
        user.release({0.2, 0.1});
        EXPECT_TRUE(user.key(Key::Backspace)) << "nothing is deleted";
        EXPECT_TRUE(user.key(key));
        EXPECT_FALSE(user.tools.is_asking());
        const double moved = (user.vertex("left", 0) - before).x();
        EXPECT_NEAR(moved, key == Key::Escape ? 0 : 0.1, 1e-9) << "Enter keeps what the mouse has done";
        EXPECT_EQ(user.pattern().panels.size(), 2U);
    }
}

TEST(AskedNumber, leaves_the_selection_alone_where_a_frame_or_copies_are_dragged) {
    for (const bool is_copying : {false, true}) {
        SheetUser user;
        user.click({0.1, 0.1});  // selects the left panel
        const Vec2d before = user.vertex("left", 0);
        const Vec2d from = is_copying ? Vec2d(0.1, 0.1) : Vec2d(0.25, -0.1);
        const Modifiers modifiers{.alt = is_copying};
        user.press(from, modifiers);
        user.move(from + Vec2d(0.04, 0.02), modifiers);
        user.move(from + Vec2d(0.06, 0.03), modifiers);
        ASSERT_TRUE(user.tools.ask_number(user.host())) << is_copying;
        user.release(from + Vec2d(0.06, 0.03), modifiers);
        user.type("5");
        EXPECT_LT((user.vertex("left", 0) - before).norm(), 1e-12) << is_copying;
        EXPECT_EQ(user.message(), "This tool does not use a number here") << is_copying;
        EXPECT_EQ(user.pattern().panels.size(), 2U) << is_copying;
    }
}

TEST(AskedNumber, moves_a_curve_handle_that_is_dragged) {
    SheetUser user;
    sim::OutlineEdge curve = user.panel("left").edges[0];
    curve.kind = sim::CurveKind::Quadratic;
    curve.control[0] = {0.1, 0.04};
    user.document.run(SetCurve{"left", 0, curve});
    user.choose("edit_point");
    user.click({0.1, 0.02});  // selects the edge: its handle shows
    user.press({0.1, 0.04});
    user.move({0.12, 0.06});
    user.move({0.13, 0.06});
    ASSERT_TRUE(user.tools.ask_number(user.host()));
    user.release({0.13, 0.06});
    user.type("2x1");
    EXPECT_LT((user.panel("left").edges[0].control[0] - Vec2d(0.12, 0.05)).norm(), 1e-9);
    EXPECT_LT((user.vertex("left", 0) - Vec2d(0, 0)).norm(), 1e-9) << "nothing else moves";
}

TEST(AskedNumber, is_a_length_of_what_is_drawn) {
    SheetUser user;
    user.choose("polygon");
    EXPECT_FALSE(user.tools.ask_number(user.host())) << "nothing is drawn yet";
    user.click({0, 0.5});
    user.move({0.3, 0.5});
    ASSERT_TRUE(user.tools.ask_number(user.host()));
    user.move({0.1, 0.9});
    user.type("25");
    user.click({0.25, 0.8});
    user.key(Key::Enter);
    ASSERT_EQ(user.pattern().panels.size(), 3U);
    EXPECT_NEAR((user.vertex("polygon", 1) - user.vertex("polygon", 0)).norm(), 0.25, 1e-6);
    user.choose("measure");
    user.click({0, 0});
    user.move({0.2, 0});
    EXPECT_FALSE(user.tools.ask_number(user.host())) << "it takes none";
}

TEST(ToolHost, no_tool_minds_any_click_or_key_on_an_empty_sheet) {
    for (const ToolInfo& info : all_tools()) {
        SheetUser user(sim::PatternDocument{});
        user.choose(info.id);
        user.key(Key::Enter);
        user.drag({0.1, 0.1}, {0.1, 0.1004});
        user.click({0.3, 0.2}, {.ctrl = true, .alt = true});
        user.double_click({0.2, 0.05});
        for (const char* typed : {"0", "-3", "1e9", "5x0x7", "((", "1/0"}) user.type(typed);
        user.key(key_of('R'));
        user.key(Key::Backspace);
        user.overlay();
        user.key(Key::Escape);
        user.drag({0.4, 0.1}, {0.1, 0.3}, {.shift = true});
        user.overlay();
        user.key(Key::Escape);
        EXPECT_TRUE(user.pattern().seams.empty()) << info.title;
        for (const sim::Panel& panel : user.pattern().panels) {
            EXPECT_TRUE(sim::find_outline_crossings(panel).empty()) << info.title;
            EXPECT_GT(sim::outline_area(panel), 0) << info.title;
        }
        user.document.go_to(0);
        EXPECT_TRUE(user.pattern().panels.empty()) << info.title << ": all that it did can be undone";
    }
}

}  // namespace

// Tools on points, curves, notches and darts; rotate and scale; merge, unfold, measure.

namespace {

TEST(EditPointTool, a_double_click_on_an_edge_adds_a_point_and_delete_takes_it_out) {
    SheetUser user;
    user.choose("edit_point");
    user.double_click({0.05, 0});
    ASSERT_EQ(user.panel("left").vertices.size(), 5U);
    user.click({0.05, 0});
    EXPECT_EQ(user.document.selection().vertices.size(), 1U);
    user.key(Key::Delete);
    EXPECT_EQ(user.panel("left").vertices.size(), 4U);
}

TEST(EditPointTool, drags_the_handles_of_a_panel_that_is_selected) {
    sim::PatternDocument source = two_squares();
    source.pattern.panels[0].edges[0].kind = sim::CurveKind::Quadratic;
    source.pattern.panels[0].edges[0].control[0] = Vec2d(0.1, -0.05);
    SheetUser user(source);
    user.choose("edit_point");
    user.drag({0.1, -0.05}, {0.1, -0.08}, {.ctrl = true});
    EXPECT_TRUE(user.panel("left").edges[0].control[0].isApprox(Vec2d(0.1, -0.05))) << "handles are not shown yet";
    user.click({0.1, 0.1});
    user.drag({0.1, -0.05}, {0.12, -0.08}, {.ctrl = true});
    EXPECT_TRUE(user.panel("left").edges[0].control[0].isApprox(Vec2d(0.12, -0.08), 1e-9));
}

TEST(EditPointTool, a_box_selects_points) {
    SheetUser user;
    user.choose("edit_point");
    user.drag({-0.05, -0.05}, {0.35, 0.05});
    EXPECT_EQ(user.document.selection().vertices.size(), 3U);
    EXPECT_TRUE(user.document.selection().panels.empty());
}

TEST(EditPointTool, drags_a_point_of_an_internal_line) {
    sim::PatternDocument source = two_squares();
    source.pattern.panels[0].internal_lines.push_back({.name = "", .points = {Vec2d(0.05, 0.05), Vec2d(0.15, 0.05)}});
    SheetUser user(source);
    user.choose("edit_point");
    user.drag({0.149, 0.05}, {0.15, 0.15}, {.ctrl = true});
    EXPECT_TRUE(user.panel("left").internal_lines[0].points[1].isApprox(Vec2d(0.15, 0.15), 1e-9));
    EXPECT_TRUE(user.panel("left").internal_lines[0].points[0].isApprox(Vec2d(0.05, 0.05), 1e-9));
}

TEST(AddPointTool, splits_an_edge_at_a_typed_distance_from_its_nearer_end) {
    SheetUser user;
    user.choose("add_point");
    user.move({0.17, 0.001});
    user.type("5.5");
    ASSERT_EQ(user.panel("left").vertices.size(), 5U);
    EXPECT_NEAR(user.vertex("left", user.panel("left").edges[0].end).x(), 0.145, 1e-9);
    user.type("80");
    EXPECT_EQ(user.panel("left").vertices.size(), 5U);
    EXPECT_NE(user.message().find("only"), std::string::npos) << "the edge is not that long";
}

TEST(CurveTool, bends_an_edge_through_the_cursor) {
    SheetUser user;
    user.choose("curve_point");
    user.drag({0.1, 0}, {0.1, -0.04});
    const sim::Panel& panel = user.panel("left");
    ASSERT_EQ(panel.edges[0].kind, sim::CurveKind::Quadratic);
    EXPECT_TRUE(curve_point(panel, panel.edges[0], 0.5).isApprox(Vec2d(0.1, -0.04), 1e-3));
    user.double_click({0.1, -0.04});
    EXPECT_EQ(user.panel("left").edges[0].kind, sim::CurveKind::Line);
}

TEST(CurveTool, with_alt_draws_a_circles_arc_and_with_shift_two_handles) {
    SheetUser user;
    user.choose("curve_point");
    user.drag({0.1, 0}, {0.1, -0.04}, {.alt = true});
    EXPECT_EQ(user.panel("left").edges[0].kind, sim::CurveKind::Arc);
    user.drag({0.1, 0.2}, {0.1, 0.25}, {.shift = true});
    EXPECT_EQ(user.panel("left").edges[2].kind, sim::CurveKind::Cubic);
}

TEST(CurveShape, an_arc_goes_through_the_point_on_either_side) {
    const sim::Panel panel = square_panel("p", {0, 0}, {0.2, 0.2});
    for (const Vec2d& to : {Vec2d(0.1, -0.03), Vec2d(0.12, 0.03), Vec2d(0.1, -0.25), Vec2d(0.07, 0.18)}) {
        const sim::OutlineEdge arc = arc_through(panel, panel.edges[0], to);
        double nearest = 1;
        for (int i = 0; i <= 1000; ++i) nearest = std::min(nearest, (curve_point(panel, arc, i / 1000.0) - to).norm());
        EXPECT_LT(nearest, 5e-4) << to.transpose();
    }
    EXPECT_EQ(arc_through(panel, panel.edges[0], {0.1, 0}).kind, sim::CurveKind::Line);
}

TEST(CurveShape, a_cubic_is_bent_through_the_point_it_was_held_at) {
    const sim::Panel panel = square_panel("p", {0, 0}, {0.2, 0.2});
    const sim::OutlineEdge cubic = as_cubic_edge(panel, panel.edges[0]);
    const sim::OutlineEdge bent = bent_through(panel, cubic, 0.3, {0.07, -0.02});
    EXPECT_EQ(bent.kind, sim::CurveKind::Cubic);
    EXPECT_TRUE(curve_point(panel, bent, 0.3).isApprox(Vec2d(0.07, -0.02), 1e-3));
}

TEST(NotchTool, a_click_notches_and_a_drag_moves_the_notch) {
    SheetUser user;
    user.choose("notch");
    user.click({0.05, 0.001});
    ASSERT_EQ(user.panel("left").notches.size(), 1U);
    EXPECT_NEAR(user.panel("left").notches[0].t, 0.25, 1e-9);
    user.drag({0.05, 0}, {0.2, 0.1});
    ASSERT_EQ(user.panel("left").notches.size(), 1U);
    EXPECT_EQ(user.panel("left").notches[0].edge, 1);
    user.click({0.2, 0.1});
    user.key(Key::Delete);
    EXPECT_TRUE(user.panel("left").notches.empty());
}

TEST(DartTool, is_dragged_to_its_depth_or_typed) {
    SheetUser user;
    user.choose("dart");
    user.drag({0.1, 0}, {0.1, 0.081});
    EXPECT_EQ(user.panel("left").vertices.size(), 7U);
    EXPECT_EQ(user.pattern().seams.size(), 1U) << "its legs are sewn";
    user.click({0.4, 0.2});
    user.type("2x6");
    EXPECT_EQ(user.panel("right").vertices.size(), 7U);
    EXPECT_NEAR(outline_area(user.panel("right")), 0.04 - 0.02 * 0.06 / 2, 1e-6);
}

TEST(RotateTool, turns_by_dragging_and_by_typing) {
    SheetUser user;
    user.click({0.1, 0.06});
    user.choose("rotate");
    user.drag({0.2, 0.1}, {0.1, 0.205}, {.shift = true});
    EXPECT_TRUE(user.vertex("left", 0).isApprox(Vec2d(0.2, 0), 1e-6)) << "a quarter turn about the middle";
    user.type("-90");
    EXPECT_LT(user.vertex("left", 0).norm(), 1e-6);
}

TEST(ScaleTool, a_handle_scales_about_the_opposite_one) {
    SheetUser user;
    user.click({0.1, 0.06});
    user.choose("scale");
    user.drag({0.2, 0.1}, {0.25, 0.17}, {.ctrl = true});
    EXPECT_TRUE(user.vertex("left", 2).isApprox(Vec2d(0.25, 0.2), 1e-6)) << "one way only";
    user.type("0.8 x 1");
    EXPECT_NEAR(user.vertex("left", 2).x() - user.vertex("left", 0).x(), 0.2, 1e-6);
    user.type("0");
    EXPECT_FALSE(user.message().empty());
}

TEST(ScaleTool, a_handle_does_not_snap_to_points_that_are_scaled_along) {
    SheetUser user;
    user.document.run(SymmetricCopy{.panels = {"left"}, .is_linked = true, .shift = Vec2d(0.7, 0)});
    const Vec2d follower = user.vertex(user.pattern().panels.back().name, 2);
    user.click({0.1, 0.06});
    user.choose("scale");
    user.press({0.2, 0.2});
    user.move(follower + Vec2d(0.004, 0.004));
    user.release(follower + Vec2d(0.004, 0.004));
    EXPECT_NEAR(user.vertex("left", 2).x(), follower.x() + 0.005, 1e-6);
}

TEST(MergeTool, joins_the_panels_of_a_seam_and_says_where_there_is_none) {
    SheetUser user;
    user.choose("merge");
    user.click({0.05, 0});
    EXPECT_FALSE(user.message().empty());
    user.document.run(SewEdges{{"left", 1}, {"right", 3}, true});
    user.click({0.2, 0.05});
    EXPECT_EQ(user.pattern().panels.size(), 1U);
}

TEST(UnfoldTool, opens_a_panel_over_an_edge) {
    SheetUser user;
    user.choose("unfold");
    user.click({0, 0.05});
    EXPECT_NEAR(outline_area(user.panel("left")), 0.08, 1e-6);
}

TEST(MeasureTool, tells_distance_and_length_along_an_edge) {
    SheetUser user;
    user.choose("curve_point");
    user.drag({0.1, 0}, {0.1, -0.06});
    user.choose("measure");
    user.click({0, 0});
    user.click({0.2, 0});
    const ToolOverlay overlay = user.overlay();
    ASSERT_EQ(overlay.labels.size(), 1U) << "corners belong to two edges: the distance alone";
    EXPECT_EQ(overlay.labels[0].text.substr(0, 7), "20.0 cm");
    EXPECT_EQ(user.document.position(), 1U) << "measuring changes nothing";
}

}  // namespace

namespace {

TEST(TypedInput, a_letter_does_not_begin_a_number) {
    TypedInput input;
    EXPECT_FALSE(input.add("x"));
    EXPECT_FALSE(input.add("h"));
    EXPECT_TRUE(input.is_empty());
    EXPECT_FALSE(input.numbers());
}

TEST(TypedInput, reads_expressions) {
    TypedInput input;
    EXPECT_TRUE(input.add("92/4+1"));
    EXPECT_EQ(input.numbers(), std::vector<double>{24});
}

TEST(TypedInput, reads_several_numbers_with_a_cross_between) {
    TypedInput input;
    for (const char* c : {"3", "0", " ", "x", " ", "4", "0", "/", "2"}) EXPECT_TRUE(input.add(c));
    EXPECT_EQ(input.numbers(), (std::vector<double>{30, 20}));
}

TEST(TypedInput, has_no_number_while_one_is_unfinished) {
    TypedInput input;
    input.add("30x");
    EXPECT_FALSE(input.numbers());
    input.remove_last();
    EXPECT_EQ(input.numbers(), std::vector<double>{30});
    input.clear();
    EXPECT_TRUE(input.is_empty());
}

TEST(TypedInput, does_not_grow_without_end) {
    TypedInput input;
    for (int i = 0; i < 1000; ++i) input.add("1");
    EXPECT_LE(input.text().size(), 64U);
}

}  // namespace

}  // namespace selvedge::editor
