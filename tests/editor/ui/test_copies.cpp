// Panels that are duplicated, or copied and pasted, in an editor without a window.
#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <vector>

#include "editor/geometry/panel_edit.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class CopiesInEditor : public testing::Test {
 protected:
    CopiesInEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
        play("frames 3\ndo {\"add_dart\": {\"panel\": \"" + pattern().panels[0].name + "\", \"edge\": 0}}\n");
    }
    void play(const std::string& script) {
        const auto step = [&](const std::vector<InputEvent>& events) {
            editor_.frame(events, {.width_px = 1280, .height_px = 800}, 1.0 / 30);
        };
        ScriptPlayer player(editor_, {.step = step, .screenshot = {}, .say = {}}, "copies.txt");
        player.play(parse_script(script, "copies.txt"));
    }
    void select_all() {
        Selection all;
        for (const sim::Panel& panel : pattern().panels) all.panels.insert(panel.name);
        editor_.state().workspace.document->select(all);
    }
    const sim::Pattern& pattern() { return editor_.state().workspace.document->pattern(); }

    // Expects that panels and seams are there twice, with the seams of the copies among the copies.
    void expect_twice(std::size_t panels, std::size_t seams) {
        ASSERT_EQ(pattern().panels.size(), 2 * panels);
        ASSERT_EQ(pattern().seams.size(), 2 * seams);
        for (std::size_t i = 0; i < seams; ++i) {
            sim::Seam expected = pattern().seams[i];
            expected.name.clear();
            expected.first.panel += static_cast<int>(panels);
            expected.second.panel += static_cast<int>(panels);
            EXPECT_EQ(pattern().seams[seams + i], expected);
        }
    }

    Eigen::AlignedBox2d sheet_box(std::size_t panel, const std::vector<Vec2d>& positions) {
        Eigen::AlignedBox2d box = outline_box(pattern().panels[panel]);
        return box.translate(positions[panel]);
    }
    Eigen::AlignedBox3d world_box(std::size_t panel) {
        Eigen::AlignedBox3d box;
        for (const Vec2d& vertex : pattern().panels[panel].vertices) box.extend(pattern().panels[panel].place(vertex));
        return box;
    }

    Editor editor_{services_without_files(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(CopiesInEditor, keep_darts_and_seams_when_duplicated_and_when_pasted) {
    const std::size_t panels = pattern().panels.size(), seams = pattern().seams.size();
    ASSERT_GE(seams, 2U);
    select_all();
    play("key ctrl+d\nframes 2\n");
    expect_twice(panels, seams);
    play("key ctrl+z\nframes 2\n");
    ASSERT_EQ(pattern().panels.size(), panels) << "one entry of the history";
    select_all();
    play("key ctrl+c\nkey ctrl+v\nframes 2\n");
    expect_twice(panels, seams);
}

TEST_F(CopiesInEditor, neither_cover_their_originals_nor_each_other) {
    const std::size_t panels = pattern().panels.size();
    select_all();
    play("key ctrl+c\nkey ctrl+d\nframes 2\nkey ctrl+v\nframes 2\n");
    ASSERT_EQ(pattern().panels.size(), 3 * panels);
    const std::vector<Vec2d> positions = sheet_positions(pattern());
    for (std::size_t i = 0; i < 3 * panels; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (i / panels == k / panels) continue;  // they were given like this
            EXPECT_FALSE(sheet_box(i, positions).intersects(sheet_box(k, positions))) << i << " " << k;
            EXPECT_FALSE(world_box(i).intersects(world_box(k))) << i << " " << k;
        }
    }
}

}  // namespace
}  // namespace selvedge::editor
