// The editor's file and export services.
#include <gtest/gtest.h>
#include <imgui.h>
#include <filesystem>
#include <fstream>

#include "app/editor_services.h"
#include "editor/tools/tool_host.h"
#include "editor/tools/tool_table.h"
#include "editor/ui/app_state.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/exchange/mesh_file.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/run_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

namespace fs = std::filesystem;

class EditorServices : public testing::Test {
 protected:
    ScratchFolder folder_;
    editor::Services services_ =
        make_editor_services({.state = folder_.path() / "state", .render_full_quality = [](const render::Scene&) {
                                  return render::Image(3, 2, {9, 8, 7, 255});
                              }});
};

editor::ExportRequest triangle_to(const std::string& file) {
    editor::ExportRequest request{.file = file, .scene = std::make_shared<const render::Scene>()};
    sim::DrawMesh& mesh = request.garment;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, Vec3f(0, 0, 1));
    mesh.triangles = {{0, 1, 2}};
    mesh.u = {{Vec2f(0, 0), Vec2f(1, 0), Vec2f(0, 1)}};
    mesh.panel = {0};
    mesh.level = {0};
    mesh.vertex_level = {0, 0, 0};
    mesh.panel_names = {"front"};
    return request;
}

TEST_F(EditorServices, print_with_the_settings_that_fit_the_kind_of_file) {
    const sim::Pattern pattern = sim::load_pattern(source_folder() + "/patterns/two_squares.json").pattern;
    for (const bool is_layout : {false, true}) {
        const sim::PrintSettings all{.layers = {"cut"},
                                     .is_one_page = true,
                                     .prints_all = true,
                                     .is_on_fold = true,
                                     .is_layout = is_layout,
                                     .is_one_way = true,
                                     .is_folded = true,
                                     .is_astm = true};
        for (const std::string ending : {".pdf", ".svg", ".dxf"}) {
            const std::string file = (folder_.path() / ("print" + ending)).string();
            EXPECT_THROW(services_.print(pattern, file, all), sim::InputError) << ending;
            EXPECT_NO_THROW(services_.print(pattern, file, settings_for(all, ending))) << ending << is_layout;
            EXPECT_TRUE(fs::exists(file)) << file;
        }
    }
}

TEST_F(EditorServices, takes_a_person_only_for_a_body) {
    const std::string file = (folder_.path() / "crate.obj").string();
    std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    EXPECT_THROW(services_.make_body(file), sim::InputError);
}

TEST_F(EditorServices, a_folder_is_listed_with_folders_first_and_without_what_is_hidden) {
    const fs::path place = folder_.path() / "place";
    fs::create_directories(place / "zippers");
    for (const char* name : {"b.json", "a.json", ".hidden"}) std::ofstream(place / name) << "";
    fs::create_symlink("nowhere", place / "broken");
    const editor::FolderListing listing = services_.list_folder((place / ".." / "place").string());
    EXPECT_EQ(listing.folder, place.string());
    EXPECT_EQ(listing.parent, folder_.path().string());
    std::vector<std::string> names;
    for (const editor::FolderEntry& entry : listing.entries) names.push_back(entry.name);
    EXPECT_EQ(names, (std::vector<std::string>{"zippers", "a.json", "b.json", "broken"}));
    EXPECT_TRUE(listing.entries[0].is_folder);
    EXPECT_FALSE(listing.entries[1].is_folder);
    EXPECT_EQ(services_.list_folder("/").parent, "");
    EXPECT_EQ(services_.list_folder("").folder, fs::current_path().string());
}

TEST_F(EditorServices, the_choice_of_keys_is_kept) {
    EXPECT_EQ(services_.load_settings().keys, editor::KeyMap::Selvedge) << "none is stored";
    services_.save_settings({.keys = editor::KeyMap::MarvelousDesigner, .is_dark = true});
    EXPECT_EQ(services_.load_settings().keys, editor::KeyMap::MarvelousDesigner);
    EXPECT_EQ(SettingsFile(folder_.path() / "state" / "settings.json").load(),
              (editor::UserSettings{.keys = editor::KeyMap::MarvelousDesigner, .is_dark = true}));
    services_.save_settings({});
    EXPECT_EQ(services_.load_settings().keys, editor::KeyMap::Selvedge);
    std::ofstream(folder_.path() / "state" / "settings.json") << "{\"keys\": [";
    EXPECT_EQ(services_.load_settings().keys, editor::KeyMap::Selvedge) << "an invalid file";
}

TEST_F(EditorServices, a_folder_that_is_not_there_is_an_input_error) {
    EXPECT_THROW(services_.list_folder(folder_ / "none"), sim::InputError);
    std::ofstream(folder_ / "file") << "";
    EXPECT_THROW(services_.list_folder(folder_ / "file"), sim::InputError);
}

TEST_F(EditorServices, garments_are_exported_as_meshes_and_pictures_as_png) {
    services_.write_export(triangle_to(folder_ / "a.obj"));
    const std::string obj = content_of(folder_ / "a.obj");
    EXPECT_NE(obj.find("\nf "), std::string::npos) << obj;
    services_.write_export(triangle_to(folder_ / "a.glb"));
    EXPECT_EQ(content_of(folder_ / "a.glb").substr(0, 4), "glTF");
    services_.write_export(triangle_to(folder_ / "a.ply"));
    EXPECT_EQ(content_of(folder_ / "a.ply").substr(0, 4), "ply\n");
    services_.write_export(triangle_to(folder_ / "a.stl"));
    EXPECT_EQ(content_of(folder_ / "a.stl").size(), 84U + 50U);
    services_.write_export(triangle_to(folder_ / "a.png"));
    const render::Image picture = render::read_png(folder_ / "a.png");
    EXPECT_EQ(picture.width_px, 3);
    EXPECT_EQ(picture.at(2, 1), (render::Rgba8{9, 8, 7, 255}));
}

TEST_F(EditorServices, meshes_are_exported_as_thick_as_asked_for) {
    editor::ExportRequest request = triangle_to(folder_ / "a.stl");
    request.thickness = {.kind = editor::ExportThickness::Kind::Given, .metres = 0.002};
    services_.write_export(request);
    EXPECT_EQ(content_of(folder_ / "a.stl").size(), 84U + 8 * 50U) << "two sides, and two triangles per border edge";
    sim::Panel panel;
    panel.name = "front";
    panel.fabric = "denim";
    request.pattern.panels = {panel};
    request.thickness.kind = editor::ExportThickness::Kind::Fabric;
    request.file = folder_ / "a.obj";
    services_.write_export(request);
    const sim::DrawMesh thick = sim::read_garment(folder_ / "a.obj");
    ASSERT_EQ(thick.triangles.size(), 8U);
    const auto [low, high] = std::ranges::minmax_element(thick.x, {}, [](const Vec3f& x) { return x.z(); });
    EXPECT_NEAR(high->z() - low->z(), sim::find_fabric("denim").thickness, 1e-6);
    request.pattern.panels[0].fabric = "no/such.json";
    EXPECT_THROW(services_.write_export(request), sim::InputError);
}

TEST_F(EditorServices, an_export_that_cannot_be_written_is_an_input_error) {
    for (const char* name : {"no/such/a.obj", "no/such/a.glb", "no/such/a.png"}) {
        EXPECT_THROW(services_.write_export(triangle_to(folder_ / name)), sim::InputError) << name;
    }
}

TEST_F(EditorServices, examples_are_garments) {
    ASSERT_EQ(services_.examples.size(), 3U);
    for (const editor::Example& example : services_.examples) {
        EXPECT_FALSE(sim::parse_pattern(example.text, example.title).pattern.panels.empty()) << example.title;
    }
}

// Editors over the same journals. One that is destroyed without being closed leaves what a crash leaves.
class CrashedEditor : public EditorServices {
 protected:
    void start(std::unique_ptr<editor::Editor>& editor) const {
        editor.reset();
        editor = std::make_unique<editor::Editor>(
            make_editor_services({.state = folder_.path() / "state", .render_full_quality = {}}),
            editor::EditorOptions{.drive = sim::SessionDrive::Caller, .is_steady = true});
    }
    static void make_silk_heavier(editor::AppState& state) {
        editor::FabricLibrary& fabrics = state.workspace.fabrics;
        fabrics.begin_draft("silk");
        sim::Fabric draft = *fabrics.find("silk").draft;
        draft.area_density = 0.25;
        fabrics.set_draft("silk", draft);
    }
    // Answers the only question.
    static void recover(editor::AppState& state) {
        ASSERT_EQ(state.questions.size(), 1U);
        const auto run = state.questions[0].answers.at(0).run;
        state.questions.clear();
        run(state);
    }
};

TEST_F(CrashedEditor, gives_back_a_new_garment_and_what_was_edited_of_a_fabric) {
    std::unique_ptr<editor::Editor> editor;
    start(editor);
    new_document(editor->state());
    editor->state().workspace.run(editor::SetBody{.body = "mannequin:sex=male"});
    make_silk_heavier(editor->state());
    for (int crash = 0; crash < 2; ++crash) {  // what was recovered can be recovered again
        start(editor);
        ASSERT_EQ(editor->state().questions.size(), 1U);
        const std::string question = editor->state().questions[0].text;
        if (crash == 0) {
            EXPECT_NE(question.find("without saving an unsaved garment (1 change) and the fabric 'Silk'."),
                      std::string::npos)
                << question;
        }
        recover(editor->state());
        const editor::Workspace& workspace = editor->state().workspace;
        EXPECT_EQ(workspace.file, "");
        EXPECT_EQ(workspace.document->pattern().body, "mannequin:sex=male");
        EXPECT_TRUE(workspace.document->has_unsaved_changes());
        EXPECT_EQ(workspace.fabrics.shown(), "silk");
        EXPECT_EQ(workspace.fabrics.changed(), std::vector<std::string>{"silk"});
        EXPECT_EQ(editor->state().workspace.fabrics.find("silk").draft->area_density, 0.25);
        editor->state().workspace.run(editor::SetEdgeLength{.length = 0.03 + 0.01 * crash});
    }
}

TEST_F(CrashedEditor, gives_back_a_fabric_that_was_edited_beside_a_saved_garment) {
    const std::string file = folder_ / "skirt.json";
    sim::write_file_atomically(file, services_.examples[1].text);
    std::unique_ptr<editor::Editor> editor;
    start(editor);
    open_file(editor->state(), file);
    editor->state().workspace.run(editor::SetEdgeLength{.length = 0.03});
    make_silk_heavier(editor->state());
    save(editor->state());
    start(editor);
    recover(editor->state());
    const editor::Workspace& workspace = editor->state().workspace;
    EXPECT_EQ(workspace.file, file);
    EXPECT_FALSE(workspace.document->has_unsaved_changes());
    EXPECT_EQ(workspace.fabrics.changed(), std::vector<std::string>{"silk"});
    editor->state().workspace.fabrics.drop_draft("silk");
    start(editor);
    EXPECT_TRUE(editor->state().questions.empty()) << "it was dropped";
}

TEST_F(CrashedEditor, gives_back_a_garment_with_its_fabric_when_the_next_one_starts_elsewhere) {
    const std::string file = folder_ / "skirt.json", fabric = folder_ / "mine.json";
    sim::write_file_atomically(file, services_.examples[1].text);
    sim::write_file_atomically(fabric, sim::read_fabric_file("silk").text);
    const fs::path before = fs::current_path();
    fs::current_path(folder_.path());
    std::unique_ptr<editor::Editor> editor;
    start(editor);
    open_file(editor->state(), "skirt.json");
    editor->state().workspace.run(editor::SetFabric{.fabric = fabric});
    save(editor->state());
    editor->state().workspace.run(editor::SetEdgeLength{.length = 0.03});
    fs::current_path(before);
    start(editor);
    recover(editor->state());
    EXPECT_EQ(editor->state().workspace.file, fs::canonical(file));
    EXPECT_EQ(editor->state().workspace.document->pattern().fabric, fs::canonical(fabric));
    save(editor->state());
    EXPECT_NE(content_of(file).find("\"fabric\": \"mine.json\""), std::string::npos);
}

// Writes a journal that an editor left. Returns its file.
fs::path leave_journal(const fs::path& state, const std::string& text) {
    fs::create_directories(state / "journals");
    std::ofstream(state / "journals/1.journal") << text;
    return state / "journals/1.journal";
}

fs::path only_file_of(const fs::path& folder, const std::string& ending) {
    fs::path found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (!entry.path().string().ends_with(ending)) continue;
        EXPECT_TRUE(found.empty()) << found << " and " << entry.path();
        found = entry.path();
    }
    return found;
}

TEST_F(CrashedEditor, keeps_a_journal_of_which_nothing_can_be_recovered_and_names_its_file) {
    const std::string head = editor::journal_head("shirt.json", services_.examples[1].text) + "\n";
    for (const std::string& text : std::vector<std::string>{
             std::string("damaged\n"), head.substr(0, head.size() / 2), head + "{\"do\": 7}\n", std::string(100, '\0'),
             "{\"selvedge_journal\": 2, \"file\": \"shirt.json\", \"text\": \"{}\"}\n",
             head + "{\"try\": {\"rename_panel\": {\"panel\": \"front\", \"to\": \"a\"}}}\n"}) {
        const fs::path journal = leave_journal(folder_.path() / "state", text);
        std::unique_ptr<editor::Editor> editor;
        start(editor);
        EXPECT_FALSE(fs::exists(journal));
        const fs::path kept = only_file_of(journal.parent_path(), ".damaged");
        ASSERT_FALSE(kept.empty());
        EXPECT_EQ(content_of(kept), text);
        ASSERT_EQ(editor->state().questions.size(), 1U);
        EXPECT_NE(editor->state().questions[0].text.find(kept.string()), std::string::npos);
        recover(editor->state());  // "OK"
        start(editor);
        EXPECT_TRUE(editor->state().questions.empty()) << "it is told once";
        fs::remove(kept);
    }
}

TEST_F(CrashedEditor, gives_back_what_stands_before_a_damaged_line_and_keeps_the_journal) {
    const auto line = [](double length) {
        return write_json(journal_line(editor::SetEdgeLength{.length = length}), -1) + "\n";
    };
    const std::string text = editor::journal_head("", services_.examples[1].text) + "\n" + line(0.03) +
                             "{\"do\": 7}\n" + line(0.04) + "{\"torn";
    const fs::path journal = leave_journal(folder_.path() / "state", text);
    std::unique_ptr<editor::Editor> editor;
    start(editor);
    ASSERT_EQ(editor->state().questions.size(), 1U);
    EXPECT_NE(editor->state().questions[0].text.find("(1 change). 2 lines after that cannot be read."),
              std::string::npos)
        << editor->state().questions[0].text;
    recover(editor->state());
    EXPECT_EQ(editor->state().workspace.document->pattern().edge_length, 0.03);
    EXPECT_FALSE(fs::exists(journal));
    const fs::path kept = only_file_of(journal.parent_path(), ".damaged");
    ASSERT_FALSE(kept.empty());
    EXPECT_EQ(content_of(kept), text);
    EXPECT_NE(editor->state().workspace.messages.all().back().text.find(kept.string()), std::string::npos);
}

TEST_F(EditorServices, the_user_is_told_when_the_journal_lacks_changes_and_when_it_has_them_again) {
    std::string problem;
    services_.journal_problem = [&problem] { return problem; };
    editor::Editor editor(std::move(services_), {.drive = sim::SessionDrive::Caller, .is_steady = true});
    editor::AppState& state = editor.state();
    const std::size_t before = state.workspace.messages.count();
    report_journal_problem(state);
    EXPECT_EQ(state.workspace.messages.count(), before);
    problem = "1.journal: No space left on device";
    for (int i = 0; i < 2; ++i) report_journal_problem(state);
    ASSERT_EQ(state.workspace.messages.count(), before + 1) << "it is told once";
    EXPECT_EQ(state.workspace.messages.all().back().kind, editor::MessageKind::Error);
    EXPECT_NE(state.workspace.messages.all().back().text.find(problem), std::string::npos);
    problem.clear();
    report_journal_problem(state);
    EXPECT_EQ(state.workspace.messages.all().back().text, "All changes can be recovered after a crash again");
}

TEST_F(EditorServices, an_editor_whose_journal_cannot_begin_starts_and_says_so) {
    services_.begin_journal = [](const std::string&) { throw sim::InputError("1.journal", "", "No space left"); };
    const editor::Editor editor(std::move(services_), {.drive = sim::SessionDrive::Caller, .is_steady = true});
    ASSERT_FALSE(editor.state().workspace.messages.all().empty());
    EXPECT_EQ(editor.state().workspace.messages.all().back().text, "1.journal: No space left");
}

TEST_F(EditorServices, what_could_not_be_opened_again_is_not_saved) {
    const std::string file = folder_ / "far.json";
    editor::Editor editor(std::move(services_), {.drive = sim::SessionDrive::Caller, .is_steady = true});
    editor::AppState& state = editor.state();
    sim::PatternDocument source = sim::parse_pattern(state.services.examples[1].text, "");
    source.pattern.panels[0].translation.x() = 101;
    state.workspace.document = std::make_unique<editor::Document>(std::move(source));
    state.workspace.document->mark_changed();
    save_as(state, file);
    EXPECT_FALSE(fs::exists(file));
    EXPECT_TRUE(state.workspace.document->has_unsaved_changes());
    const std::string text = state.workspace.messages.all().back().text;
    EXPECT_NE(text.find("not saved, for it could not be opened again: further than 100 m"), std::string::npos) << text;
}

TEST_F(EditorServices, a_garment_is_not_saved_over_a_file_that_it_names) {
    const std::string fabric = folder_ / "mine.json", garment = folder_ / "skirt.json";
    sim::write_file_atomically(fabric, sim::read_fabric_file("silk").text);
    editor::Editor editor(std::move(services_), {.drive = sim::SessionDrive::Caller, .is_steady = true});
    editor::AppState& state = editor.state();
    open_example(state, state.services.examples[1]);
    state.workspace.run(editor::SetFabric{.fabric = fabric});
    save_as(state, fabric, editor::IfExists::Replace);
    EXPECT_EQ(content_of(fabric), sim::read_fabric_file("silk").text);
    EXPECT_NE(state.workspace.messages.all().back().text.find("the garment is made of this file"), std::string::npos);
    save_as(state, garment);
    save_as(state, garment);
    EXPECT_FALSE(state.workspace.document->has_unsaved_changes());
}

TEST_F(EditorServices, an_editor_without_a_folder_for_state_keeps_nothing_and_works) {
    editor::Services services = make_editor_services({.state = {}, .render_full_quality = {}});
    EXPECT_TRUE(services.recent_files().empty());
    const std::string file = folder_ / "begun.json";
    editor::Editor editor(std::move(services), {.drive = sim::SessionDrive::Caller, .is_steady = true});
    new_document(editor.state());
    save_as(editor.state(), file);
    EXPECT_TRUE(fs::exists(file));
}

TEST_F(EditorServices, a_garment_without_panels_is_saved_and_opened_again) {
    const std::string file = folder_ / "begun.json";
    editor::Editor editor(std::move(services_), {.drive = sim::SessionDrive::Caller, .is_steady = true});
    editor::AppState& state = editor.state();
    new_document(state);
    state.workspace.run(editor::SetBody{.body = "mannequin:sex=male"});
    save_as(state, file);
    new_document(state);
    open_file(state, file);
    EXPECT_EQ(state.workspace.file, file);
    EXPECT_EQ(state.workspace.document->pattern().body, "mannequin:sex=male");
    EXPECT_TRUE(state.workspace.document->pattern().panels.empty());
    wear_over(state, file);
    EXPECT_EQ(state.workspace.messages.all().back().text, "'begun.json' has no panels: nothing to wear");
}

TEST_F(EditorServices, a_journal_is_offered_with_its_changes_and_goes_where_it_has_none) {
    const fs::path journal = folder_.path() / "state/journals/none.journal";
    const std::string head = editor::journal_head("shirt.json", services_.examples[1].text);
    std::ofstream(journal) << head << '\n';
    EXPECT_TRUE(services_.orphaned_journals().empty());
    EXPECT_FALSE(fs::exists(journal));
    const std::string line = write_json(journal_line(editor::MoveVertices{{{"front", 0}}, Vec2d(0.01, 0)}), -1);
    std::ofstream(journal) << head << '\n' << line << "\n{\"do\": {\"torn";
    const std::vector<editor::OrphanedJournal> left = services_.orphaned_journals();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].id, journal.string());
    EXPECT_EQ(left[0].recovery->changes, 1) << "but for the torn line";
    EXPECT_EQ(left[0].age, "a moment ago");
    services_.discard_journal(left[0].id);
    EXPECT_FALSE(fs::exists(journal));
    // What was recovered and is in no file is offered again, though nothing was changed since.
    std::ofstream(journal) << editor::journal_head("shirt.json", services_.examples[1].text, {.is_unsaved = true})
                           << '\n';
    ASSERT_EQ(services_.orphaned_journals().size(), 1U);
    EXPECT_TRUE(services_.orphaned_journals()[0].recovery->was_unsaved);
}

TEST_F(EditorServices, fabrics_are_read_by_name_or_file_and_written_whole) {
    const std::string file = folder_ / "mine.json";
    sim::FabricFile fabric = services_.read_fabric("denim");
    fabric.fabric.shear = 77;
    services_.save(file, write_fabric(fabric.fabric, file, fabric.text));
    EXPECT_EQ(services_.read_fabric(file).fabric, fabric.fabric);
    EXPECT_EQ(services_.read_fabric(file).text, content_of(file));
    EXPECT_THROW(services_.save(folder_ / "no/such.json", "{}"), sim::InputError);
    std::ofstream(file) << R"({"name": "mine"})";
    try {
        services_.read_fabric(file);
        FAIL();
    } catch (const sim::InputError& error) {
        EXPECT_EQ(error.file(), file) << error.what();
    }
    EXPECT_THROW(services_.read_fabric("velour"), sim::InputError);
}

TEST_F(EditorServices, a_body_file_may_be_called_mannequin) {
    try {
        services_.make_body("mannequin.obj");
        FAIL();
    } catch (const sim::InputError& error) {
        EXPECT_EQ(error.file(), "mannequin.obj") << error.what();
    }
}

// A hint that is too long for the status bar ends with dots, which is narrower than its whole text.
TEST_F(EditorServices, hints_of_tools_are_whole_in_a_window_of_1280_px) {
    editor::Editor editor(std::move(services_),
                          {.drive = sim::SessionDrive::Caller, .fonts = read_fonts(), .is_steady = true});
    editor::AppState& state = editor.state();
    open_example(state, state.services.examples.front());
    for (const float scale : {1.0F, 1.5F}) {
        for (const editor::ToolInfo& tool : editor::all_tools()) {
            state.workspace.messages.dismiss();
            state.tools.choose(tool_host_context(state.workspace), tool);
            editor::Selection selection;
            selection.seams = {0};
            for (const editor::Selection& chosen : {editor::Selection{}, selection}) {
                state.workspace.document->select(chosen);
                for (int i = 0; i < 2; ++i)
                    editor.frame({}, {.width_px = 1280, .height_px = 800, .scale = scale}, 0.03);
                const std::string hint = state.tools.hint(tool_host_context(state.workspace));
                const editor::WidgetBox& shown = state.widgets.at("status.hint");
                const float whole = ImGui::CalcTextSize(hint.c_str()).x;
                EXPECT_NEAR(shown.high.x() - shown.low.x(), whole, 1) << hint << " at scale " << scale;
            }
        }
    }
}

TEST_F(EditorServices, a_document_that_is_opened_has_no_hidden_garments) {
    editor::Editor editor(std::move(services_),
                          {.drive = sim::SessionDrive::Caller, .fonts = read_fonts(), .is_steady = true});
    editor::AppState& state = editor.state();
    state.workspace.look.hidden_garments = {"skirt"};
    open_example(state, state.services.examples.front());
    EXPECT_TRUE(state.workspace.look.hidden_garments.empty());
}

}  // namespace

// The list of recent files.

namespace {

using Files = std::vector<std::string>;

TEST(RecentFiles, come_newest_first_each_once_and_only_while_they_are_there) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    EXPECT_TRUE(recent.list().empty());
    for (const char* name : {"a", "b"}) std::ofstream(folder / name) << name;
    recent.add(folder / "a");
    recent.add(folder / "b");
    recent.add((folder.path() / "." / "a").string());
    EXPECT_EQ(recent.list(), (Files{folder / "a", folder / "b"}));
    std::filesystem::remove(folder / "a");
    EXPECT_EQ(recent.list(), Files{folder / "b"});
}

TEST(RecentFiles, that_cannot_be_looked_at_are_left_out) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    const std::string there = folder / "a.json", loop = folder / "loop.json";
    std::ofstream(there) << "{}";
    fs::create_symlink("loop.json", loop);
    const std::string deep = there + "/in_a_file.json", endless = folder / std::string(300, 'n') + ".json";
    std::ofstream(folder / "recent.json")
        << "[\"" << loop << "\", \"" << deep << "\", \"" << endless << "\", \"" << there << "\"]";
    EXPECT_EQ(recent.list(), std::vector<std::string>{there});
    for (const std::string& file : {loop, endless, std::string(5000, 'n')}) EXPECT_NO_THROW(recent.add(file));
    EXPECT_EQ(recent.list(), std::vector<std::string>{there});
}

TEST_F(EditorServices, paths_that_cannot_be_looked_at_are_no_files) {
    fs::create_symlink("loop", folder_ / "loop");
    for (const std::string& file : {folder_ / "loop", folder_ / std::string(300, 'n'), std::string(5000, 'n')}) {
        EXPECT_FALSE(services_.exists(file));
        EXPECT_EQ(services_.full_path(file).front(), '/');
        EXPECT_THROW(services_.list_folder(file), sim::InputError);
        EXPECT_THROW(services_.load(file), sim::InputError);
        EXPECT_THROW(services_.save(file, ""), sim::InputError);
    }
}

TEST(RecentFiles, are_a_dozen_at_most) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    for (int i = 0; i < 15; ++i) {
        std::ofstream(folder / std::to_string(i)) << i;
        recent.add(folder / std::to_string(i));
    }
    EXPECT_EQ(recent.list().size(), 12U);
    EXPECT_EQ(recent.list().front(), folder / "14");
}

TEST(RecentFiles, a_list_that_is_none_is_an_empty_one_and_is_written_anew) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    std::ofstream(folder / "shirt") << "";
    for (const char* text : {"", "[1, 2]", "{\"a\": [", "null"}) {
        std::ofstream(folder / "recent.json") << text;
        EXPECT_TRUE(recent.list().empty()) << text;
        recent.add(folder / "shirt");
        EXPECT_EQ(recent.list(), Files{folder / "shirt"}) << text;
    }
}

TEST(RecentFiles, what_cannot_be_written_is_forgotten) {
    const ScratchFolder folder;
    const RecentFiles recent(folder.path() / "no" / "such" / "recent.json");
    EXPECT_NO_THROW(recent.add("shirt"));
    EXPECT_TRUE(recent.list().empty());
}

}  // namespace

}  // namespace selvedge::app
