// The tab Objects, its actions and keys, in an editor without a window.
#include <gtest/gtest.h>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "editor/ui/actions.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class ObjectsTab : public testing::Test {
 protected:
    ObjectsTab() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
        editor_.state().layout.inspector_width = 30;  // room for seven tabs in ImGui's own font, which is wide
        play("frames 3\n");
    }
    void play(const std::string& script) {
        const auto step = [&](const std::vector<InputEvent>& events) {
            editor_.frame(events, {.width_px = 1280, .height_px = 800}, 1.0 / 30);
        };
        ScriptPlayer player(editor_, {.step = step, .screenshot = {}, .say = {}}, "objects.txt");
        player.play(parse_script(script, "objects.txt"));
    }
    Document& document() { return *editor_.state().workspace.document; }
    std::set<std::string> selected() { return document().selection().panels; }
    void select(const std::string& panel) {
        Selection selection;
        selection.panels.insert(panel);
        document().select(selection);
    }
    bool can(const std::string& action) { return find_action(editor_.state().actions, action)->can(editor_.state()); }
    bool has_widget(const std::string& name) { return editor_.state().widgets.contains(name); }

    Editor editor_{services_without_files(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(ObjectsTab, opens_and_takes_the_keys_with_ctrl_f_from_the_views_and_from_a_box) {
    const Vec2d before = editor_.sheet_to_px({0, 0});
    play("move room 0 1 0.2\nkey ctrl+f\nframes 4\n");
    EXPECT_EQ(editor_.state().layout.tab, InspectorTab::Objects);
    play("type back\nframes 2\n");
    EXPECT_TRUE(has_widget("objects.panel.back"));
    EXPECT_FALSE(has_widget("objects.panel.front"));
    EXPECT_EQ(editor_.sheet_to_px({0, 0}), before);
    play("key enter\nclick widget tab.Edit\nframes 3\n");
    EXPECT_EQ(editor_.state().layout.tab, InspectorTab::Properties);
}

TEST_F(ObjectsTab, shows_all_seven_tabs_in_the_window) {
    for (const char* tab : {"Edit", "Seams", "Cloth", "Body", "Drape", "History", "Objects"}) {
        EXPECT_LE(editor_.state().widgets.at(std::string("tab.") + tab).high.x(), 1280) << tab;
    }
}

TEST_F(ObjectsTab, hides_with_a_key_what_is_selected_and_shows_all_again) {
    EXPECT_FALSE(can("panel.hide"));
    EXPECT_FALSE(can("panel.show_all"));
    select("front");
    play("key ctrl+shift+h\n");
    EXPECT_EQ(document().panel_states().hidden, std::set<std::string>{"front"});
    EXPECT_TRUE(selected().empty());
    play("click panel front 0 20\n");
    EXPECT_TRUE(selected().empty());
    ASSERT_TRUE(can("panel.show_all"));
    play("action panel.show_all\nframes 1\nclick panel front 0 20\n");
    EXPECT_EQ(selected(), std::set<std::string>{"front"});
    EXPECT_TRUE(document().history().empty());
}

TEST_F(ObjectsTab, locks_the_panel_of_a_selected_part_and_unlocks_all) {
    Selection selection;
    selection.edges.insert({"back", 2});
    document().select(selection);
    play("key ctrl+shift+l\n");
    EXPECT_EQ(document().panel_states().locked, std::set<std::string>{"back"});
    play("key ctrl+a\n");
    EXPECT_EQ(selected(), std::set<std::string>{"front"});
    play("action panel.unlock_all\nkey ctrl+a\n");
    EXPECT_EQ(selected().size(), 2U);
}

TEST_F(ObjectsTab, the_menu_of_the_sheet_hides_what_it_was_opened_on) {
    play("click panel back 0 20 right\nframes 2\nclick widget sheet_menu.panel.hide\nframes 2\n");
    EXPECT_EQ(document().panel_states().hidden, std::set<std::string>{"back"});
}

TEST_F(ObjectsTab, f2_names_the_selected_panel) {
    EXPECT_FALSE(can("panel.rename"));
    select("back");
    play("key f2\nframes 4\ntype rear\nkey enter\nframes 2\n");
    EXPECT_EQ(document().pattern().panels[1].name, "rear");
    EXPECT_EQ(selected(), std::set<std::string>{"rear"});
}

TEST_F(ObjectsTab, a_double_click_beside_a_name_shows_the_panel_on_the_sheet) {
    play("key ctrl+f\nframes 4\nkey escape\nframes 2\n");
    const double before = (editor_.sheet_to_px({0.1, 0}) - editor_.sheet_to_px({0, 0})).norm();
    play("double widget objects.panel.back\nframes 3\n");
    EXPECT_GT((editor_.sheet_to_px({0.1, 0}) - editor_.sheet_to_px({0, 0})).norm(), 1.1 * before);
    EXPECT_EQ(selected(), std::set<std::string>{"back"});
}

TEST_F(ObjectsTab, a_row_lights_its_panel_up_in_the_views) {
    play("key ctrl+f\nframes 4\nkey escape\nframes 2\nmove widget objects.panel.back\nframes 5\n");
    EXPECT_EQ(editor_.state().workspace.hover, Hover{.panel = "back"});
}

TEST_F(ObjectsTab, another_document_has_nothing_hidden_and_nothing_wanted) {
    select("back");
    play("key ctrl+shift+h\nkey ctrl+f\nframes 4\ntype back\nkey enter\n");
    const auto file = std::filesystem::path(source_folder()) / "patterns" / "skirt.json";
    open_loaded(editor_.state(), sim::load_pattern(file), file.string());
    play("frames 3\n");
    EXPECT_TRUE(document().panel_states().is_empty());
    EXPECT_TRUE(has_widget("objects.panel.front"));
}

}  // namespace
}  // namespace selvedge::editor
