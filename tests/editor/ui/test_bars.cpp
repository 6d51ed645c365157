// The bars around the views at several scales of the interface, in an editor without a window.
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <string>

#include "editor/ui/editor.h"
#include "editor/ui/files.h"
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

}  // namespace
}  // namespace selvedge::editor
