// Which part of the window gets the keys, in an editor without a window.
#include <gtest/gtest.h>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "editor/tools/tool_table.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "editor/viewport3d/view_keys.h"
#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class KeysOfEditor : public testing::Test {
 protected:
    KeysOfEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
        play("frames 3\n");
        Selection front;
        front.panels.insert("front");
        document().select(front);
        play("frames 3\n");
    }
    void select_corner() {
        Selection selected;
        selected.vertices.insert({"front", 0});
        document().select(selected);
    }
    void play(const std::string& script) {
        const auto step = [&](const std::vector<InputEvent>& events) {
            editor_.frame(events, {.width_px = 1280, .height_px = 800}, 1.0 / 30);
        };
        ScriptPlayer player(editor_, {.step = step, .screenshot = {}, .say = {}}, "keys.txt");
        player.play(parse_script(script, "keys.txt"));
    }
    Document& document() { return *editor_.state().workspace.document; }
    double height_cm() { return 100 * document().pattern().panels[0].translation.y(); }
    Vec2d corner() { return document().pattern().panels[0].vertices[0]; }

    Editor editor_{services_without_files(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(KeysOfEditor, go_to_the_sheet_after_enter_in_a_number_box) {
    play("click widget panel.translation.y\nkey ctrl+a\ntype 90\nkey enter\n");
    EXPECT_NEAR(height_cm(), 90, 1e-9);
    const Vec2d px = editor_.sheet_to_px({0, 0});
    play("key f\nframes 2\n");
    EXPECT_NE(editor_.sheet_to_px({0, 0}), px) << "F frames the panel";
    const Vec2d before = corner();
    select_corner();
    play("key right\n");
    EXPECT_GT(corner().x(), before.x()) << "arrows move what is selected";
    play("key escape\n");
    EXPECT_TRUE(document().selection().is_empty()) << "Escape selects nothing";
}

TEST_F(KeysOfEditor, of_a_script_are_refused_where_a_number_of_steps_is_none) {
    for (const char* script : {"frames 1e300\n", "frames -1\n", "frames 0.5\n", "click vertex front 1e300\n"})
        EXPECT_THROW(play(script), sim::InputError) << script;
}

TEST_F(KeysOfEditor, go_to_the_sheet_after_the_keypads_enter) {
    play("click widget panel.translation.y\nkey ctrl+a\ntype 90\nkey numenter\n");
    EXPECT_NEAR(height_cm(), 90, 1e-9);
    play("key escape\n");
    EXPECT_TRUE(document().selection().is_empty());
}

TEST_F(KeysOfEditor, go_to_the_sheet_after_escape_in_a_number_box) {
    const double before = height_cm();
    play("click widget panel.translation.y\nkey ctrl+a\ntype 90\nkey escape\n");
    EXPECT_EQ(height_cm(), before);
    EXPECT_FALSE(document().selection().is_empty()) << "this Escape was the box's";
    play("key escape\n");
    EXPECT_TRUE(document().selection().is_empty());
}

TEST_F(KeysOfEditor, sew_a_proposed_seam_while_the_cursor_is_over_the_3d_view) {
    Selection seam;
    seam.seams.insert(0);
    document().select(seam);
    play("key delete\nframes 2\n");
    const std::size_t before = document().pattern().seams.size();
    play("click room 0 1.7 0\nframes 3\naction seam.propose\nframes 3\nkey enter\nframes 3\n");
    EXPECT_GT(document().pattern().seams.size(), before);
}

TEST_F(KeysOfEditor, stay_with_the_boxes_after_tab) {
    play("click widget panel.translation.x\nkey ctrl+a\ntype 1\nkey tab\nframes 2\nkey ctrl+a\ntype 95\nkey enter\n");
    EXPECT_NEAR(height_cm(), 95, 1e-9);
}

// Presses and releases of the same key `count` times, as a window collects them while a slow picture is drawn.
std::vector<InputEvent> presses(Key key, int count) {
    std::vector<InputEvent> events;
    for (int i = 0; i < count; ++i) {
        for (const bool is_down : {true, false}) {
            events.push_back({.kind = InputEvent::Kind::Key, .key = key, .is_down = is_down});
        }
    }
    return events;
}

TEST_F(KeysOfEditor, that_came_during_a_slow_picture_are_all_taken_before_the_next) {
    const FrameSize size{.width_px = 1280, .height_px = 800};
    play("click widget panel.translation.y\nkey escape\n");
    select_corner();
    play("frames 2\n");
    const double start = corner().x();
    editor_.frame(presses(Key::Right, 1), size, 1);
    const double step = corner().x() - start;
    ASSERT_GT(step, 0);
    EXPECT_FALSE(editor_.has_more_input());
    const FrameOutput output = editor_.frame(presses(Key::Right, 6), size, 1);
    EXPECT_NEAR(corner().x(), start + 7 * step, 1e-9);
    EXPECT_FALSE(editor_.has_more_input());
    std::set<UiTexture> asked;
    for (const SceneRequest& scene : output.scenes) EXPECT_TRUE(asked.insert(scene.texture).second) << scene.texture;
}

TEST_F(KeysOfEditor, of_which_there_are_very_many_are_shown_on_their_way) {
    const FrameSize size{.width_px = 1280, .height_px = 800};
    select_corner();
    const FrameOutput output = editor_.frame(presses(Key::Right, 100), size, 1);
    EXPECT_TRUE(editor_.has_more_input());
    EXPECT_TRUE(output.is_animating) << "the host draws the next frame at once";
}

TEST_F(KeysOfEditor, ask_for_a_number_by_a_right_click_while_something_is_drawn) {
    const std::size_t panels = document().pattern().panels.size();
    play("key h\nclick sheet 0 70\nmove sheet 20 70\nclick sheet 20 70 right\nmove sheet 5 90\ntype 12.5\nkey enter\n");
    play("click sheet 5 95\nkey enter\n");
    ASSERT_EQ(document().pattern().panels.size(), panels + 1);
    const sim::Panel& drawn = document().pattern().panels.back();
    EXPECT_NEAR((drawn.vertices[1] - drawn.vertices[0]).norm(), 0.125, 1e-6);
}

TEST_F(KeysOfEditor, an_edge_stands_for_its_seam_in_the_menu) {
    const Action& reverse = *find_action(editor_.state().actions, "seam.reverse");
    EXPECT_EQ(tip_for(reverse, editor_.state()), reverse.tip + "\nIt needs a selected seam, or edge of one");
    const sim::Seam seam = document().pattern().seams.at(0);
    Selection selected;
    selected.edges.insert({document().pattern().panels[as_size(seam.first.panel)].name, seam.first.edge});
    document().select(selected);
    EXPECT_EQ(tip_for(reverse, editor_.state()), reverse.tip);
    play("action seam.reverse\nframes 2\n");
    EXPECT_NE(document().pattern().seams.at(0).is_reversed, seam.is_reversed);
}

// Keys of Marvelous Designer.
class OtherKeys : public KeysOfEditor {
 protected:
    OtherKeys() { play("action view.keys_marvelous\nframes 2\n"); }
    std::string tool() { return std::string(editor_.state().tools.info().id); }
    std::string keys_of_action(std::string_view id) { return chord_text(*find_action(editor_.state().actions, id)); }
};

TEST_F(OtherKeys, choose_tools_and_commands_and_stand_in_menus) {
    play("key b\nframes 2\n");
    EXPECT_EQ(editor_.state().layout.tab, InspectorTab::Seams);
    for (const auto& [key, id] :
         {std::pair{"q", "select"}, {"v", "edit_point"}, {"i", "internal_line"}, {"y", "measure"}}) {
        play(std::string("key ") + key + "\n");
        EXPECT_EQ(tool(), id) << key;
    }
    EXPECT_EQ(keys_of_action("tool.select"), "A");
    EXPECT_EQ(keys_of_action("tool.mirror"), "");
    EXPECT_EQ(keys_of_action("edit.duplicate"), "");
    EXPECT_EQ(keys_of_action("panel.symmetric_copy"), "Ctrl+D");
    play("action view.keys_marvelous\nframes 2\nkey q\n");
    EXPECT_EQ(tool(), "measure") << "the editor's own keys again";
    EXPECT_EQ(keys_of_action("edit.duplicate"), "Ctrl+D");
}

TEST_F(OtherKeys, turn_the_3d_view_by_digits_while_the_cursor_is_over_it) {
    const auto ahead = [&] {  // of a point 1 m before the body, px right of the body's middle
        return (*editor_.world_to_px({0, 1, 1}) - *editor_.world_to_px({0, 1, 0})).x();
    };
    play("move room 0 1 0\nkey 4\nframes 30\n");
    const double from_left = ahead();
    play("key 6\nframes 30\n");
    EXPECT_LT(ahead() * from_left, -1000) << "the other side";
    play("key 2\nframes 30\n");
    EXPECT_NEAR(ahead(), 0, 2);
    EXPECT_TRUE(editor_.state().tools.typed().is_empty());
    play("key h\nmove sheet 0 70\ntype 6\nframes 30\n");
    EXPECT_NEAR(ahead(), 0, 2) << "this digit is the tool's";
    EXPECT_EQ(editor_.state().tools.typed().text(), "6");
}

TEST(KeyMaps, bind_no_key_twice) {
    for (const KeyMap map : {KeyMap::Selvedge, KeyMap::MarvelousDesigner}) {
        std::set<std::string> keys;
        for (const Action& action : make_actions(map)) {
            for (const Chord& chord : action.chords) EXPECT_TRUE(keys.insert(text_of(chord)).second) << action.id;
        }
        std::set<ViewCommand> commands;
        for (const ViewKey& key : view_keys(map)) {
            EXPECT_TRUE(keys.insert(text_of({key.key, key.modifiers})).second) << text_of({key.key, key.modifiers});
            EXPECT_EQ(view_command(map, key.key, key.modifiers), key.command);
            commands.insert(key.command);
        }
        EXPECT_EQ(commands.size(), 12U) << "all of them";
        for (const ToolInfo& tool : all_tools()) {
            EXPECT_TRUE(find_action(make_actions(map), "tool." + std::string(tool.id))) << tool.id;
        }
    }
}

TEST(ActionSearch, finds_by_letters_in_order_and_by_words_of_the_tip) {
    const std::vector<Action> actions = make_actions(KeyMap::Selvedge);
    EXPECT_EQ(search(actions, "symcop").at(0)->id, "panel.symmetric_copy");
    EXPECT_EQ(search(actions, "print pdf").at(0)->id, "file.print");
    EXPECT_TRUE(search(actions, "print zebra").empty());
}

TEST(KeyMaps, are_kept_by_the_program) {
    Services services = services_without_files();
    UserSettings kept{.keys = KeyMap::MarvelousDesigner, .is_dark = true};
    services.load_settings = [&] { return kept; };
    services.save_settings = [&](const UserSettings& settings) { kept = settings; };
    Editor editor(services, {.drive = sim::SessionDrive::Caller, .is_steady = true});
    editor.frame({}, {}, 1.0 / 30);
    EXPECT_EQ(chord_text(*find_action(editor.state().actions, "panel.symmetric_copy")), "Ctrl+D");
    choose_key_map(editor.state(), KeyMap::Selvedge);
    EXPECT_EQ(kept, (UserSettings{.keys = KeyMap::Selvedge, .is_dark = true}));
}

}  // namespace
}  // namespace selvedge::editor
