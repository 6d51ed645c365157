// Fabrics are opened, edited and saved as files by mouse and script, in an editor without a window.
#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "editor/ui/editor.h"
#include "editor/ui/fabric_files.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "sim/core/file.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::editor {
namespace {

class FabricsInEditor : public testing::Test {
 protected:
    FabricsInEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(state(), sim::load_pattern(file), file.string());
        state().workspace.drape.options().max_level = 0;
        state().workspace.run(SetFabric{.fabric = "silk"});
        state().workspace.document->mark_saved();
        play("frames 3\nclick widget tab.Cloth\nframes 2\n");
    }
    Services services() {
        Services services = services_without_files();
        services.exists = [](const std::string& name) { return std::filesystem::exists(name); };
        services.save = [this](const std::string& name, const std::string& text) {
            ++writes_;
            sim::write_file_atomically(name, text);
        };
        return services;
    }
    void play(const std::string& script) {
        const auto step = [&](const std::vector<InputEvent>& events) {
            editor_.frame(events, {.width_px = 1280, .height_px = 1400}, 1.0 / 30);
        };
        ScriptPlayer player(editor_, {.step = step, .screenshot = {}, .say = {}}, "fabrics.txt");
        player.play(parse_script(script, "fabrics.txt"));
    }
    void edit_weight(const std::string& text) {
        play("click widget material.fabric.edit\nframes 2\nclick widget fabric.area_density\ntype " + text +
             "\nkey enter\nframes 2\n");
    }
    void save_my_silk() {
        edit_weight("100");
        save_fabric_as(state(), "silk", file_);
        play("frames 3\n");
    }
    AppState& state() { return editor_.state(); }
    FabricLibrary& fabrics() { return state().workspace.fabrics; }
    const sim::Pattern& pattern() { return state().workspace.document->pattern(); }
    std::string last_message() { return state().workspace.messages.all().back().text; }
    bool has_question() { return !state().questions.empty(); }
    void answer(const std::string& label) { play("frames 2\nclick widget answer." + label + "\nframes 2\n"); }

    sim::TemporaryFolder folder_;
    std::string file_ = (folder_ / "my_silk.json").string();
    int writes_ = 0;
    Editor editor_{services(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(FabricsInEditor, are_saved_as_a_file_of_which_the_garment_is_then_made) {
    save_my_silk();
    EXPECT_EQ(pattern().fabric, file_);
    EXPECT_EQ(fabrics().shown(), file_);
    EXPECT_TRUE(fabrics().changed().empty());
    sim::Fabric expected = sim::find_fabric("silk");
    expected.area_density = 0.1;
    expected.name = "my_silk";
    EXPECT_EQ(sim::find_fabric(file_), expected);
    EXPECT_NE(sim::read_fabric_file(file_).text.find("evidence"), std::string::npos);
    EXPECT_EQ(state().workspace.document->history().size(), 2U) << "one step goes back";
}

TEST_F(FabricsInEditor, that_only_a_panel_is_made_of_are_replaced_there) {
    state().workspace.run(SetFabric{.fabric = "denim"});
    state().workspace.run(SetFabric{.panel = "front", .fabric = "silk"});
    fabrics().show("silk");
    save_my_silk();
    EXPECT_EQ(pattern().fabric, "denim");
    EXPECT_EQ(pattern().panels[0].fabric, file_);
    EXPECT_EQ(pattern().panels[1].fabric, "");
}

TEST_F(FabricsInEditor, are_replaced_in_all_panels_and_interlinings_in_one_step) {
    sim::Panel pocket = pattern().panels[0];
    pocket.name = "pocket";
    pocket.interlinings = {"linen", "silk", "silk"};
    state().workspace.run(AddPanels{.panels = {pocket}});
    state().workspace.run(SetFabric{.fabric = "denim"});
    for (const char* panel : {"front", "back"}) state().workspace.run(SetFabric{.panel = panel, .fabric = "silk"});
    const sim::Pattern before = pattern();
    fabrics().show("silk");
    save_my_silk();
    for (const std::size_t p : {0U, 1U}) EXPECT_EQ(pattern().panels[p].fabric, file_);
    EXPECT_EQ(pattern().panels[2].interlinings, (std::vector<std::string>{"linen", file_, file_}));
    EXPECT_EQ(pattern().fabric, "denim");
    state().workspace.document->undo();
    EXPECT_EQ(pattern(), before);
}

TEST_F(FabricsInEditor, are_taken_by_a_garment_that_hangs_when_they_are_saved) {
    save_my_silk();
    play("key space\nsettle 12\nexpect Settled\n");
    const std::vector<Vec3f> before = state().workspace.drape.frame()->mesh.x;
    play(
        "click widget material.fabric.edit\nframes 2\nclick widget fabric.bending_warp\ntype 300\nkey enter\nframes 2\n"
        "click widget fabric.bending_weft\ntype 300\nkey enter\nframes 2\nexpect Settled\n"
        "click widget material.fabric.save\nframes 1\n");
    EXPECT_EQ(writes_, 2);
    EXPECT_FALSE(has_question());
    EXPECT_EQ(state().workspace.drape.frame()->stage, sim::SessionStage::Draping);
    EXPECT_FALSE(fabrics().find(file_).draft);
    EXPECT_EQ(sim::find_fabric(file_).bending_warp, 3e-4);
    play("settle 12\n");
    EXPECT_NE(state().workspace.drape.frame()->mesh.x, before);
}

TEST_F(FabricsInEditor, ask_before_they_replace_a_file) {
    sim::write_file_atomically(file_, "notes of somebody");
    save_my_silk();
    ASSERT_TRUE(has_question());
    EXPECT_EQ(writes_, 0);
    EXPECT_EQ(pattern().fabric, "silk");
    answer("Cancel");
    EXPECT_EQ(writes_, 0);
    EXPECT_EQ(fabrics().changed(), std::vector<std::string>{"silk"});
    save_fabric_as(state(), "silk", file_);
    answer("Replace");
    EXPECT_EQ(pattern().fabric, file_);
}

TEST_F(FabricsInEditor, ask_before_they_replace_what_another_program_wrote_meanwhile) {
    save_my_silk();
    edit_weight("120");
    sim::write_file_atomically(file_, sim::read_fabric_file("denim").text);
    EXPECT_FALSE(save_fabric(state(), file_));
    EXPECT_TRUE(has_question());
    EXPECT_EQ(sim::find_fabric(file_).name, "denim");
    answer("Replace");
    EXPECT_EQ(sim::find_fabric(file_).area_density, 0.12);
}

TEST_F(FabricsInEditor, that_cannot_be_written_stay_as_drafts) {
    edit_weight("100");
    const std::string nowhere = (folder_ / "no/such/folder.json").string();
    save_fabric_as(state(), "silk", nowhere);
    EXPECT_NE(last_message().find("folder.json"), std::string::npos) << last_message();
    EXPECT_EQ(pattern().fabric, "silk");
    EXPECT_EQ(fabrics().changed(), std::vector<std::string>{"silk"});
}

TEST_F(FabricsInEditor, are_opened_from_files_and_a_broken_one_is_told_once) {
    sim::write_file_atomically(file_, R"({"name": "net", "area_density": "light"})");
    const std::size_t before = state().workspace.messages.count();
    open_fabric(state(), file_);
    play("frames 5\n");
    EXPECT_EQ(state().workspace.messages.count(), before + 1);
    EXPECT_NE(last_message().find("area_density: a string where a number should be"), std::string::npos);
    EXPECT_EQ(fabrics().shown(), "");
    EXPECT_TRUE(fabrics().files().empty());
    sim::write_file_atomically(file_, sim::read_fabric_file("linen").text);
    open_fabric(state(), file_);
    play("frames 2\nclick widget material.fabric.garment\n");
    EXPECT_EQ(pattern().fabric, file_);
}

TEST_F(FabricsInEditor, are_asked_about_before_the_editor_closes) {
    edit_weight("100");
    close(state());
    ASSERT_TRUE(has_question());
    EXPECT_FALSE(state().wants_to_close);
    answer("Cancel");
    EXPECT_FALSE(state().wants_to_close);
    EXPECT_EQ(fabrics().changed(), std::vector<std::string>{"silk"});
    close(state());
    answer("Discard");
    EXPECT_TRUE(state().wants_to_close);
}

TEST_F(FabricsInEditor, of_a_file_are_saved_before_the_editor_closes) {
    save_my_silk();
    state().workspace.document->mark_saved();
    edit_weight("90");
    close(state());
    answer("Save");
    EXPECT_TRUE(state().wants_to_close);
    EXPECT_EQ(sim::find_fabric(file_).area_density, 0.09);
}

TEST_F(FabricsInEditor, keep_their_drafts_when_another_garment_is_opened) {
    edit_weight("100");
    new_document(state());
    play("frames 2\n");
    EXPECT_EQ(fabrics().changed(), std::vector<std::string>{"silk"});
}

}  // namespace
}  // namespace selvedge::editor
