// How drawings are imported and patterns are printed from the editor: by the rows of the file browser and by scripts.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/paper_options.h"
#include "editor/ui/script.h"
#include "sim/core/error.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/played_script.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class PaperOfEditor : public testing::Test {
 protected:
    PaperOfEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        garment_ = sim::load_pattern(file);
        open_loaded(state(), garment_, file.string());
        play("frames 3\n");
    }
    Services services() {
        Services services = services_without_files();
        services.import_drawing = [this](const std::string& file, const sim::ImportOptions& options) {
            imports_.push_back({file, options});
            ImportedDrawing drawing{.garment = garment_, .sewn = "2 panels", .sizes = sizes_, .pictures = pictures_};
            if (!sizes_.empty())
                drawing.garment.pattern.size = options.panels.size.empty() ? "38" : options.panels.size;
            return drawing;
        };
        services.exists = [](const std::string& file) { return file.starts_with("taken"); };
        services.save = [this](const std::string& file, const std::string&) {
            if (file == "full.jpg") throw sim::InputError(file, "", "no space left");
            written_.push_back(file);
        };
        services.remove = [this](const std::string& file) { std::erase(written_, file); };
        services.print = [this](const sim::Pattern&, const std::string& file, const sim::PrintSettings& settings) {
            printed_ = file;
            settings_ = settings;
            return std::string("2 pages");
        };
        return services;
    }
    void play(const std::string& script) { play_script(editor_, script, "paper.txt"); }
    AppState& state() { return editor_.state(); }

    struct Import {
        std::string file;
        sim::ImportOptions options;
    };
    std::vector<Import> imports_;
    std::vector<std::string> sizes_, written_;
    std::vector<PictureFile> pictures_;
    std::string printed_;
    sim::PrintSettings settings_;
    sim::PatternDocument garment_;
    Editor editor_{services(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(PaperOfEditor, is_imported_with_the_options_of_the_browser) {
    play(
        "action file.import\nframes 3\nclick widget browser.size\ntype 40\nclick widget browser.allowance\ntype 10\n"
        "click widget browser.name\ntype shirt.dxf\nclick widget browser.choose\nframes 2\n");
    ASSERT_EQ(imports_.size(), 1U);
    EXPECT_TRUE(imports_[0].file.ends_with("shirt.dxf"));
    EXPECT_EQ(imports_[0].options.panels.size, "40");
    EXPECT_EQ(imports_[0].options.panels.allowance, std::optional<double>(0.01));
    EXPECT_FALSE(imports_[0].options.panels.metres_per_unit);
}

TEST_F(PaperOfEditor, is_imported_with_the_words_of_a_script) {
    play("import a.svg unit cm size M allowance 7.5 measurements anna.json\n");
    ASSERT_EQ(imports_.size(), 1U);
    const sim::ImportOptions& options = imports_[0].options;
    EXPECT_EQ(options.panels.metres_per_unit, std::optional<double>(0.01));
    EXPECT_EQ(options.panels.size, "M");
    EXPECT_EQ(options.panels.allowance, std::optional<double>(0.0075));
    EXPECT_EQ(options.measurements, "anna.json");
    EXPECT_THROW(play("import a.svg unit ell\n"), sim::InputError);
    EXPECT_THROW(play("import a.svg colour red\n"), sim::InputError);
    EXPECT_THROW(play("import a.svg allowance wide\n"), sim::InputError);
}

TEST_F(PaperOfEditor, with_several_sizes_asks_which_one) {
    sizes_ = {"36", "38", "40"};
    import_file(state(), "nest.dxf");
    ASSERT_EQ(state().questions.size(), 1U);
    EXPECT_NE(state().questions[0].text.find("3 sizes; this is 38"), std::string::npos) << state().questions[0].text;
    play("frames 2\nclick widget answer.40\nframes 2\n");
    EXPECT_EQ(state().workspace.document->pattern().size, "40");
    EXPECT_TRUE(state().questions.empty());
    import_file(state(), "nest.dxf", {.panels = {.size = "36"}});
    state().questions.clear();  // about what was not saved
}

TEST_F(PaperOfEditor, with_scans_writes_their_pictures_and_asks_before_it_replaces_a_file) {
    pictures_ = {{"free.jpg", "a"}};
    import_file(state(), "scan.pdf");
    EXPECT_EQ(written_, std::vector<std::string>{"free.jpg"});
    EXPECT_EQ(imports_.size(), 1U);
    state().workspace.document->mark_saved();
    pictures_ = {{"free.jpg", "a"}, {"taken.jpg", "b"}};
    const int opened = state().documents_opened;
    import_file(state(), "scan.pdf");
    ASSERT_EQ(state().questions.size(), 1U);
    EXPECT_EQ(state().questions[0].text, "There is a file 'taken.jpg' already.");
    EXPECT_EQ(written_.size(), 1U) << "nothing before the answer";
    EXPECT_EQ(state().documents_opened, opened);
    const auto replace = state().questions[0].answers.at(0).run;
    state().questions.clear();
    replace(state());
    EXPECT_EQ(written_, (std::vector<std::string>{"free.jpg", "free.jpg", "taken.jpg"}));
    EXPECT_EQ(state().documents_opened, opened + 1);
}

TEST_F(PaperOfEditor, with_scans_names_all_files_that_it_would_replace) {
    pictures_ = {{"taken1.jpg", "a"}, {"free.jpg", "b"}, {"taken2.jpg", "c"}};
    import_file(state(), "scan.pdf");
    ASSERT_EQ(state().questions.size(), 1U);
    EXPECT_EQ(state().questions[0].text, "2 files are there already: 'taken1.jpg', 'taken2.jpg'");
    state().questions.clear();
}

TEST_F(PaperOfEditor, with_scans_that_cannot_be_written_shows_the_panels_without_them_and_leaves_no_picture) {
    garment_.pattern.underlays = {{.file = "free.jpg", .pixel_size = 0.001}, {.file = "full.jpg", .pixel_size = 0.001}};
    pictures_ = {{"free.jpg", "a"}, {"taken.jpg", "b"}, {"full.jpg", "c"}};
    const int opened = state().documents_opened;
    import_file(state(), "scan.pdf");
    ASSERT_EQ(state().questions.size(), 1U);
    const auto replace = state().questions[0].answers.at(0).run;
    state().questions.clear();
    replace(state());
    EXPECT_EQ(state().documents_opened, opened + 1);
    EXPECT_FALSE(state().workspace.document->pattern().panels.empty());
    EXPECT_TRUE(state().workspace.document->pattern().underlays.empty());
    EXPECT_EQ(written_, std::vector<std::string>{"taken.jpg"}) << "only what was there before";
    EXPECT_NE(state().workspace.messages.all().back().text.find("no space left"), std::string::npos);
    state().workspace.document->mark_saved();
    garment_.pattern.panels.clear();
    garment_.pattern.seams.clear();
    pictures_ = {{"free.jpg", "a"}, {"full.jpg", "c"}};
    import_file(state(), "scan.pdf");
    EXPECT_EQ(state().documents_opened, opened + 1) << "nothing to show";
    EXPECT_EQ(written_, std::vector<std::string>{"taken.jpg"});
}

TEST_F(PaperOfEditor, is_printed_with_the_options_of_the_browser) {
    play(
        "action file.print\nframes 3\nclick widget browser.one_page\nclick widget browser.all_pieces\n"
        "click widget browser.layout\nframes 2\nclick widget browser.folded\nclick widget browser.choose\nframes 2\n");
    EXPECT_TRUE(printed_.ends_with(".pdf"));
    EXPECT_TRUE(settings_.is_one_page && settings_.prints_all && settings_.is_layout && settings_.is_folded);
    EXPECT_FALSE(settings_.is_on_fold || settings_.is_one_way || settings_.is_astm);
    play(
        "action file.print\nframes 3\nclick widget browser.paper\nframes 2\nclick widget browser.paper.a0\nframes 2\n");
    EXPECT_EQ(state().print_settings.paper, "a0");
}

TEST_F(PaperOfEditor, is_printed_without_the_options_of_another_kind_of_file) {
    play(
        "action file.print\nframes 3\nclick widget browser.on_fold\nclick widget browser.one_page\n"
        "click widget browser.cancel\nframes 2\n"
        "action file.print_svg\nframes 3\nclick widget browser.choose\nframes 2\n");
    EXPECT_TRUE(printed_.ends_with(".svg")) << printed_;
    EXPECT_FALSE(settings_.is_on_fold || settings_.is_one_page);
    EXPECT_TRUE(state().print_settings.is_on_fold) << "kept for the next PDF";
}

TEST_F(PaperOfEditor, is_printed_without_the_layers_that_were_unchecked) {
    play(
        "action file.print_svg\nframes 3\nclick widget browser.layers\nframes 3\nclick widget "
        "browser.layers.labels\nframes 2\n");
    EXPECT_EQ(state().print_settings.layers.size(), 7U);
    EXPECT_EQ(std::ranges::count(state().print_settings.layers, "labels"), 0);
    play("click widget browser.layers.labels\nframes 2\n");
    EXPECT_TRUE(state().print_settings.layers.empty()) << "all";
}

TEST_F(PaperOfEditor, is_printed_with_the_words_of_a_script) {
    play("print a.pdf paper a3 layers cut,sew width 140 layout one-way all\n");
    EXPECT_EQ(settings_.paper, "a3");
    EXPECT_EQ(settings_.layers, (std::vector<std::string>{"cut", "sew"}));
    EXPECT_DOUBLE_EQ(settings_.fabric_width, 1.4);
    EXPECT_TRUE(settings_.is_layout && settings_.is_one_way && settings_.prints_all);
    EXPECT_THROW(play("print a.pdf paper\n"), sim::InputError);
    EXPECT_THROW(play("print a.pdf bold\n"), sim::InputError);
}

}  // namespace
}  // namespace selvedge::editor
