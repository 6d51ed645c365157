// Turning about any point, why clicks on no edge do nothing, where a dart cannot be, and selecting by Tab.
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "editor/tools/tool.h"
#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

TEST(RotateTool, turns_about_a_point_that_was_clicked_with_alt) {
    SheetUser user;
    user.click({0.1, 0.06});
    user.choose("rotate");
    user.click({0.001, 0.001}, {.alt = true});  // snaps to the corner
    user.type("90");
    EXPECT_TRUE(user.vertex("left", 0).isZero(1e-9));
    EXPECT_TRUE(user.vertex("left", 1).isApprox(Vec2d(0, 0.2), 1e-9));
    user.type("-90");
    EXPECT_TRUE(user.vertex("left", 1).isApprox(Vec2d(0.2, 0), 1e-9)) << "the point stays";
}

TEST(RotateTool, turns_about_where_its_cross_was_dragged_until_something_else_is_selected) {
    SheetUser user;
    user.click({0.1, 0.06});
    user.choose("rotate");
    user.drag({0.1, 0.1}, {0.2, 0});
    user.drag({0.1, 0.3}, {0.5, 0.1}, {.shift = true});
    EXPECT_TRUE(user.vertex("left", 1).isApprox(Vec2d(0.2, 0), 1e-9)) << user.vertex("left", 1).transpose();
    EXPECT_GT(user.vertex("left", 0).norm(), 0.05);
    user.click({0.45, 0.06});
    ASSERT_EQ(user.document.selection().panels, std::set<std::string>{"right"});
    user.type("180");
    EXPECT_TRUE(user.vertex("right", 0).isApprox(Vec2d(0.5, 0.2), 1e-9)) << "about its middle";
}

TEST(EdgeTools, say_why_a_click_does_nothing) {
    SheetUser user;
    user.document.run(AddInternalLine{"left", {.name = "", .points = {{0.02, 0.1}, {0.18, 0.1}}}});
    const std::string tools[] = {"add_point", "notch", "dart", "merge", "unfold", "segment_sewing", "free_sewing"};
    for (const std::string& tool : tools) {
        user.choose(tool);
        user.click({0.1, 0.1});
        EXPECT_NE(user.message().find("internal line"), std::string::npos) << tool << ": " << user.message();
        user.click({0.1, 0.05});
        EXPECT_NE(user.message().find("inside of 'left'"), std::string::npos) << tool << ": " << user.message();
        user.click({0.25, 0.1});
        EXPECT_NE(user.message().find("no edge"), std::string::npos) << tool << ": " << user.message();
    }
    PanelStates states;
    states.locked.insert("left");
    user.document.set_panel_states(states);
    for (const std::string& tool : tools) {
        user.choose(tool);
        user.click({0.1, 0.05});
        EXPECT_NE(user.message().find("locked"), std::string::npos) << tool << ": " << user.message();
    }
}

TEST(DartTool, warns_where_a_dart_cannot_be) {
    SheetUser user;
    user.choose("dart");
    user.move({0.1, 0});
    EXPECT_TRUE(user.overlay().problem.empty()) << user.overlay().problem;
    user.move({0.004, 0});
    EXPECT_NE(user.overlay().problem.find("does not fit"), std::string::npos) << user.overlay().problem;
    const ToolOverlay overlay = user.overlay();
    EXPECT_EQ(overlay.lines.back().tone, OverlayTone::Warning);
}

TEST(ToolHost, tab_goes_through_the_panels_and_with_edit_point_through_their_points) {
    SheetUser user;
    EXPECT_TRUE(user.key(Key::Tab));
    EXPECT_EQ(user.document.selection().panels, std::set<std::string>{"left"});
    user.key(Key::Tab);
    EXPECT_EQ(user.document.selection().panels, std::set<std::string>{"right"});
    user.key(Key::Tab);
    EXPECT_EQ(user.document.selection().panels, std::set<std::string>{"left"});
    user.choose("edit_point");
    user.key(Key::Tab);
    EXPECT_EQ(user.document.selection().vertices, (std::set<PartRef>{{"left", 0}}));
    user.key(Key::Tab, {.shift = true});
    EXPECT_EQ(user.document.selection().vertices, (std::set<PartRef>{{"left", 3}}));
}

}  // namespace
}  // namespace selvedge::editor
