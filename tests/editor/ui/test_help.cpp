// The first steps, the keys, the manual, the dark colours, and work by keys alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "editor/ui/actions.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/help_windows.h"
#include "editor/ui/script.h"
#include "sim/core/file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/played_script.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class HelpOfEditor : public testing::Test {
 protected:
    static Services services() {
        Services services = services_without_files();
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        services.examples = {{"Squares", "Two squares.", sim::read_file(file, 1 << 20)}};
        services.manual =
            "# The editor\nIt edits.\n## Keys\n| key | what |\n|---|---|\n| V | selects |\n- one\n  more\n";
        return services;
    }
    void play(const std::string& script) { play_script(editor_, script, "help.txt"); }
    AppState& state() { return editor_.state(); }
    const sim::Pattern& pattern() { return state().workspace.document->pattern(); }

    Editor editor_{services(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(HelpOfEditor, leads_through_five_steps_from_the_start_page) {
    play("frames 3\nclick widget start.tour\nframes 3\n");
    EXPECT_FALSE(state().shows_start_page);
    EXPECT_EQ(state().help.tour_step, 0U);
    play("click widget tour.show\nframes 2\n");
    EXPECT_EQ(pattern().panels.size(), 2U) << "the example is open";
    for (std::size_t step = 1; step < kTourSteps; ++step) {
        play("click widget tour.next\nframes 2\n");
        EXPECT_EQ(state().help.tour_step, step);
    }
    play("click widget tour.next\nframes 2\n");
    EXPECT_FALSE(state().help.tour_step);
}

TEST_F(HelpOfEditor, shows_the_keys_and_the_manual_by_key_and_escape_closes_them) {
    play("key shift+f1\nframes 2\n");
    EXPECT_TRUE(state().help.has_keys);
    play("key escape\nframes 2\n");
    EXPECT_FALSE(state().help.has_keys);
    play("key ctrl+f1\nframes 2\nclick widget manual.Keys\nframes 2\n");
    EXPECT_TRUE(state().help.has_manual);
    EXPECT_EQ(state().help.chapter, 1U);
}

TEST(Manual, is_divided_at_its_headings_into_paragraphs_tables_and_lists) {
    const std::vector<ManualChapter> chapters = chapters_of(
        "# The *editor*\nIt `edits`\na [pattern](x.md).\n\n## Keys\n| key | what |\n|---|---|\n| V | a |\n- one\n  "
        "more\n"
        "```\nplay\n```\n");
    ASSERT_EQ(chapters.size(), 2U);
    EXPECT_EQ(chapters[0].title, "The editor");
    ASSERT_EQ(chapters[0].blocks.size(), 1U);
    EXPECT_EQ(chapters[0].blocks[0].cells, std::vector<std::string>{"It edits a pattern."});
    ASSERT_EQ(chapters[1].blocks.size(), 4U);
    EXPECT_EQ(chapters[1].blocks[1].cells, (std::vector<std::string>{"V", "a"}));
    EXPECT_EQ(chapters[1].blocks[2].cells, std::vector<std::string>{"one more"});
    EXPECT_EQ(chapters[1].blocks[3].kind, ManualBlock::Kind::Code);
}

TEST(Manual, of_the_editor_has_no_chapter_without_text) {
    const auto file = std::filesystem::path(source_folder()) / "docs" / "editor.md";
    const std::vector<ManualChapter> chapters = chapters_of(sim::read_file(file, 1 << 20));
    EXPECT_GT(chapters.size(), 15U);
    EXPECT_NE(sim::read_file(file, 1 << 20).find("<!-- The manual in the menu Help begins here. -->"),
              std::string::npos);
    for (const ManualChapter& chapter : chapters) EXPECT_FALSE(chapter.blocks.empty()) << chapter.title;
}

TEST_F(HelpOfEditor, turns_dark_and_light_again) {
    const sim::Rgb8 light = state().theme.panel;
    play("action view.dark\nframes 2\n");
    EXPECT_EQ(state().theme.panel, dark_theme().panel);
    play("action view.dark\nframes 2\n");
    EXPECT_EQ(state().theme.panel, light);
}

TEST_F(HelpOfEditor, opens_each_tab_of_the_inspectors_by_its_number) {
    open_example(state(), state().services.examples[0]);
    const InspectorTab tabs[] = {InspectorTab::Seams, InspectorTab::Objects, InspectorTab::Properties};
    const char* keys[] = {"ctrl+2", "ctrl+7", "ctrl+1"};
    for (std::size_t i = 0; i < 3; ++i) {
        play("key " + std::string(keys[i]) + "\nframes 3\n");
        EXPECT_EQ(state().layout.tab, tabs[i]) << keys[i];
    }
}

TEST_F(HelpOfEditor, draws_and_notches_a_panel_by_keys_alone) {
    state().shows_start_page = false;
    play(
        "frames 2\nkey h\ntype 30 x 20\nkey enter\ntype 20 < 0\nkey enter\ntype 30 < 90\nkey enter\nkey enter\nframes "
        "2\n");
    ASSERT_EQ(pattern().panels.size(), 1U);
    EXPECT_EQ(pattern().panels[0].vertices.size(), 3U);
    const Vec2d px = editor_.sheet_to_px({0.4, 0.17});
    play("key k\nmove px " + std::to_string(px.x()) + " " + std::to_string(px.y()) + "\n");
    for (int i = 0; i < 60 && pattern().panels[0].notches.empty(); ++i) play("key alt+shift+up\nkey alt+enter\n");
    ASSERT_EQ(pattern().panels[0].notches.size(), 1U);
    EXPECT_EQ(pattern().panels[0].notches[0].edge, 0);
}

TEST_F(HelpOfEditor, shows_no_frame_time_in_scripts) {
    EXPECT_FALSE(state().shows_times);
    Editor window(services(), {.drive = sim::SessionDrive::Caller});
    EXPECT_TRUE(window.state().shows_times);
}

}  // namespace
}  // namespace selvedge::editor
