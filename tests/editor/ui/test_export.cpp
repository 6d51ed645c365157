// Exports from the menu: what they ask for.
#include <gtest/gtest.h>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/ui/editor.h"
#include "editor/ui/export_thickness.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class ExportFromEditor : public testing::Test {
 protected:
    ExportFromEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
        editor_.state().workspace.drape.options().max_level = 0;
        play("frames 5\n");
    }
    Services services() {
        Services services = services_without_files();
        services.write_export = [this](const ExportRequest& request) { written_ = request; };
        return services;
    }
    void play(const std::string& script) {
        const auto step = [&](const std::vector<InputEvent>& events) {
            editor_.frame(events, {.width_px = 1280, .height_px = 900}, 1.0 / 30);
        };
        ScriptPlayer player(editor_, {.step = step, .screenshot = {}, .say = {}}, "export.txt");
        player.play(parse_script(script, "export.txt"));
    }

    std::optional<ExportRequest> written_;
    Editor editor_{services(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(ExportFromEditor, of_a_mesh_asks_how_thick_the_cloth_is_and_remembers_it) {
    play("action file.export_stl\nframes 3\nclick widget browser.choose\nframes 2\n");
    ASSERT_TRUE(written_);
    EXPECT_TRUE(written_->file.ends_with("two_squares.stl")) << written_->file;
    EXPECT_EQ(written_->thickness.kind, ExportThickness::Kind::None);
    EXPECT_EQ(written_->pattern.panels.size(), 2U);
    editor_.state().export_thickness.kind = ExportThickness::Kind::Given;
    play("action file.export_stl\nframes 3\nclick widget browser.thickness_mm\nkey ctrl+a\ntype 0.8\nkey enter\n");
    play("frames 2\n");
    play("click widget browser.choose\nframes 2\n");
    EXPECT_EQ(written_->thickness.kind, ExportThickness::Kind::Given);
    EXPECT_NEAR(written_->thickness.metres, 0.0008, 1e-12);
    play("action file.export_glb\nframes 3\nclick widget browser.thickness_mm\nkey ctrl+a\ntype 900\nkey enter\n");
    play("frames 2\nclick widget browser.choose\nframes 2\n");
    EXPECT_EQ(written_->thickness.metres, 0.05) << "the thickest";
}

TEST_F(ExportFromEditor, of_a_picture_asks_for_no_thickness) {
    play("action file.export_png\nframes 3\n");
    EXPECT_THROW(play("click widget browser.thickness\n"), sim::InputError);
}

TEST_F(ExportFromEditor, by_a_script_names_the_thickness) {
    play("export a.ply thickness fabric\n");
    EXPECT_EQ(written_->thickness.kind, ExportThickness::Kind::Fabric);
    play("export a.ply thickness 1.5\n");
    EXPECT_NEAR(written_->thickness.metres, 0.0015, 1e-12);
    play("export a.ply\n");
    EXPECT_EQ(written_->thickness.kind, ExportThickness::Kind::None);
    EXPECT_THROW(play("export a.ply thickness 0\n"), sim::InputError);
    EXPECT_THROW(play("export a.ply thickness thin\n"), sim::InputError);
}

}  // namespace
}  // namespace selvedge::editor
