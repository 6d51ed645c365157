// The bars around the views at several scales of the interface, in an editor without a window.
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "editor/tools/tool_table.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class BarsOfEditor : public testing::Test {
 protected:
    BarsOfEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
    }
    void show(const FrameSize& size) {
        for (int i = 0; i < 3; ++i) editor_.frame({}, size, 1.0 / 30);
    }
    const WidgetBox& widget(const std::string& name) { return editor_.state().widgets.at(name); }

    const WidgetBox& tool_box(const ToolInfo& tool) { return widget("tool." + std::string(tool.id)); }

    Editor editor_{services_without_files(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(BarsOfEditor, the_one_over_the_3d_view_is_whole_at_every_scale) {
    for (const float scale : {1.0F, 1.5F, 2.0F}) {
        show({.width_px = 1280, .height_px = 800, .scale = scale});
        const float right = widget("tab.Edit").low.x();
        float bottom = 0;
        for (const char* name : {"simulate.run", "simulate.reset", "view.modes", "view.body", "view.threads",
                                 "view.points", "view.timeline"}) {
            EXPECT_LT(widget(name).high.x(), right) << name << " at scale " << scale;
            bottom = std::max(bottom, widget(name).high.y());
        }
        EXPECT_LT(bottom, 400) << "the 3D view keeps room, at scale " << scale;
    }
}

TEST_F(BarsOfEditor, the_list_of_modes_keeps_room_for_a_word) {
    show({.width_px = 1280, .height_px = 800, .scale = 2});
    const WidgetBox& list = widget("view.modes");
    EXPECT_GT(list.high.x() - list.low.x(), 2 * 6 * 15 - 1) << "six font heights of 30 px";
}

TEST_F(BarsOfEditor, the_tools_stand_in_groups_with_captions) {
    show({.width_px = 1280, .height_px = 800});
    EXPECT_TRUE(editor_.state().widgets.contains("tools.Select"));
    const ToolInfo* before = nullptr;
    std::set<ToolGroup> seen;
    for (const ToolInfo& tool : all_tools()) {
        const WidgetBox& box = tool_box(tool);
        if (before != nullptr) {
            const float gap = box.low.y() - tool_box(*before).high.y();
            const bool begins_group = tool.group != before->group;
            EXPECT_EQ(gap > 10, begins_group) << tool.id << " " << gap;
            EXPECT_TRUE(!begins_group || !seen.contains(tool.group)) << tool.id << " is apart from its group";
            EXPECT_EQ(box.low.x(), tool_box(*before).low.x()) << tool.id;
        }
        EXPECT_TRUE(editor_.state().widgets.contains("tools." + std::string(title_of(tool.group))));
        seen.insert(tool.group);
        before = &tool;
    }
    EXPECT_EQ(seen.size(), 5U);
    EXPECT_LT(tool_box(*before).high.y(), 780);
}

TEST_F(BarsOfEditor, the_tools_have_two_columns_where_one_is_too_long) {
    for (const FrameSize& size : {FrameSize{1280, 800, 2}, FrameSize{1280, 420, 1}}) {
        show(size);
        std::set<float> columns;
        for (const ToolInfo& tool : all_tools()) {
            EXPECT_LT(tool_box(tool).high.y(), static_cast<float>(size.height_px)) << tool.id;
            columns.insert(tool_box(tool).low.x());
        }
        EXPECT_EQ(columns.size(), 2U);
    }
}

TEST_F(BarsOfEditor, the_tools_scroll_where_two_columns_are_too_long) {
    const FrameSize size{1280, 400, 2};
    show(size);
    const ToolInfo& last = all_tools().back();
    EXPECT_GT(tool_box(last).high.y(), 340);
    const Vec2f at = tool_box(all_tools().front()).centre();
    editor_.frame({{.kind = InputEvent::Kind::MouseMove, .x = at.x(), .y = at.y()}}, size, 1.0 / 30);
    editor_.frame({}, size, 1.0 / 30);
    editor_.frame({{.kind = InputEvent::Kind::Wheel, .y = -50}}, size, 1.0 / 30);
    show(size);
    EXPECT_LT(tool_box(last).high.y(), 345);
}

TEST_F(BarsOfEditor, the_status_line_says_first_that_a_newer_garment_cannot_be_saved) {
    sim::Json file = sim::read_json(source_folder() + "/patterns/two_squares.json");
    file["selvedge"]["format"] = sim::Json(sim::kGarmentFormat + 1);
    file["pattern"]["panels"]["back"]["selvedge"]["grainlin"] = sim::Json(0.0);
    open_loaded(editor_.state(), sim::parse_pattern(write_json(file), "newer.json"), "newer.json");
    const Message* shown = editor_.state().workspace.messages.shown();
    ASSERT_NE(shown, nullptr);
    EXPECT_NE(shown->text.find("'newer.json' cannot be saved"), std::string::npos) << shown->text;
}

}  // namespace
}  // namespace selvedge::editor
