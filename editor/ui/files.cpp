#include "editor/ui/files.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "editor/frame/item.h"
#include "editor/geometry/outline_edit.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/tools/tool_host.h"
#include "editor/ui/app_state.h"
#include "editor/ui/export_thickness.h"
#include "editor/ui/fabric_files.h"
#include "editor/ui/paper_options.h"
#include "editor/ui/widgets.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/core/sha256.h"
#include "sim/pattern/named_file.h"

namespace selvedge::editor {
namespace {

std::string name_in_folder(const std::string& file) {
    return file.substr(file.find_last_of('/') + 1);
}

// The formats that a body is read from (sim/repair/guarded_import.h).
std::vector<std::string> body_endings() {
    return {".obj", ".glb", ".gltf"};
}

// What is known of the file of a document that is shown.
struct FileState {
    std::string file = {};                 // empty: there is none
    std::optional<std::string> hash = {};  // AppState::file_hash
    bool is_unsaved = false;               // the document has changes that are in no file
};

std::optional<std::string> hash_of(const AppState& state, const std::string& file) {
    if (file.empty() || !state.services.hash_of) return std::nullopt;
    return state.services.hash_of(file);
}

void show_document(AppState& state, sim::PatternDocument source, const FileState& shown) {
    auto document = std::make_unique<Document>(std::move(source));
    if (shown.is_unsaved) document->mark_changed();
    document->continue_revisions(*state.workspace.document);
    state.workspace.document = std::move(document);
    state.workspace.file = shown.file;
    state.file_hash = shown.hash;
    state.workspace.look.hidden_garments.clear();
    state.inspectors.objects = {};
    state.workspace.fabrics.show("");  // the Cloth tab showed one of the garment before
    state.workspace.drape.begin_document();
    state.tools.choose(tool_host_context(state.workspace), default_tool());
    state.shows_start_page = false;
    ++state.documents_opened;
    begin_journal(state);
    state.workspace.tell_notes();
    if (const auto newer = state.workspace.document->read_only_reason())  // last: the status line shows the last one
        state.workspace.messages.warn("'" + document_name(state) + "' cannot be saved: " + *newer);
}

// Runs `go_on` at once if there are no unsaved changes.
void after_asking(AppState& state, std::function<void(AppState&)> go_on) {
    if (!state.workspace.document->has_unsaved_changes()) return go_on(state);
    const auto save_first = [go_on](AppState& current) { save(current, go_on); };
    state.questions.push_front({"'" + document_name(state) + "' has changes that are not saved.",
                                {{"Save", save_first}, {"Discard", go_on}, {"Cancel", [](AppState&) {}}}});
}

void write_pose_file(AppState& state, const std::string& file, const sim::PoseAngles& angles) {
    std::string name = name_in_folder(file);
    name.resize(name.find_last_of('.'));
    state.services.save(file, write_pose(angles, name));
    Workspace& workspace = state.workspace;
    if (!angles.bones.empty())
        return workspace.messages.warn("Wrote " + file + ", without " + std::to_string(angles.bones.size()) +
                                       " bones that are no joint of a person");
    workspace.messages.note("Wrote " + file);
    workspace.drape.choose_pose(file);
}

std::vector<std::string> files_of(const AppState& state) {
    return named_files(state.workspace.document->pattern());
}

// Throws InputError if the garment is read from this file, or names it: it is not to be written over.
void refuse_inputs(const AppState& state, const std::string& file, std::vector<std::string> inputs) {
    const std::string target = state.services.full_path(file);
    for (const std::string& input : inputs) {
        if (!input.empty() && state.services.full_path(input) == target)
            throw sim::InputError(file, "", "cannot write: the garment is made of this file");
    }
}

void refuse_garment_and_its_files(const AppState& state, const std::string& file) {
    std::vector<std::string> inputs = files_of(state);
    inputs.push_back(state.workspace.file);
    refuse_inputs(state, file, std::move(inputs));
}

// Throws InputError for what could not be opened again.
void require_readable(const std::string& text, const std::string& file) {
    for (const sim::Fault& fault : sim::check_pattern_text(text, file)) {
        if (fault.severity == sim::Severity::Error)
            throw sim::InputError(file, fault.place, "not saved, for it could not be opened again: " + fault.problem);
    }
}

// Does not look at what the file holds: see is_changed_by_others.
void write_document(AppState& state, const std::string& file) {
    Document& document = *state.workspace.document;
    if (const auto newer = document.read_only_reason())
        throw sim::InputError(state.workspace.file, "", "not saved: " + *newer);
    document.commit();
    refuse_inputs(state, file, files_of(state));
    const std::string text = document.text(file);
    require_readable(text, file);
    state.services.save(file, text);
    document.mark_saved();
    state.workspace.file = file;
    state.file_hash = sim::sha256(text);
    state.services.remember_file(file);
    state.workspace.messages.note("Saved as " + file);
    begin_journal(state);
}

// Whether the document's file holds something else than what was last read of it or written to it. A file that was
// removed is written anew; one that cannot be read holds something else.
bool is_changed_by_others(const AppState& state) {
    const std::string& file = state.workspace.file;
    if (!state.services.hash_of || !state.services.exists(file)) return false;
    const std::optional<std::string> hash = state.services.hash_of(file);
    return !hash || hash != state.file_hash;
}

bool is_file_of_document(const AppState& state, const std::string& file) {
    const std::string& own = state.workspace.file;
    return !own.empty() && state.services.full_path(file) == state.services.full_path(own);
}

void write_and_go_on(AppState& state, const std::string& file, const std::function<void(AppState&)>& then) {
    const bool is_written = try_to(state, [&] { write_document(state, file); });
    if (is_written && then) then(state);
}

void ask_about_changed_file(AppState& state, const std::function<void(AppState&)>& then) {
    const std::string file = state.workspace.file;
    const auto replace = [file, then](AppState& current) { write_and_go_on(current, file, then); };
    const auto take_theirs = [file, then](AppState& current) {
        const bool is_open = try_to(current, [&] { load_and_open(current, file); });
        if (is_open) current.workspace.messages.note("Opened '" + document_name(current) + "' as it is on disk now");
        if (is_open && then) then(current);
    };
    state.questions.push_front({"'" + document_name(state) +
                                    "' was changed by another program since it was read. Replace its changes by "
                                    "yours, or drop yours?",
                                {{"Replace", replace},
                                 {"Take theirs", take_theirs},
                                 {"Save as...", [](AppState& current) { browse_to_save(current); }},
                                 {"Cancel", [](AppState&) {}}}});
}

}  // namespace

bool try_to(AppState& state, const std::function<void()>& function) {
    try {
        function();
        return true;
    } catch (const std::exception& error) {  // InputError, or what the system refuses
        state.workspace.messages.say({.kind = MessageKind::Error, .text = error.what(), .places = {}});
        return false;
    }
}

std::string with_ending(const std::string& file, const std::string& ending) {
    return file.ends_with(ending) ? file : file + ending;
}

void ask_to_replace(AppState& state, const std::vector<std::string>& files, std::function<void(AppState&)> write) {
    std::string names;
    for (const std::string& file : files) names += (names.empty() ? "'" : ", '") + file + "'";
    const std::string text = files.size() == 1 ? "There is a file " + names + " already."
                                               : std::to_string(files.size()) + " files are there already: " + names;
    state.questions.push_front({text, {{"Replace", std::move(write)}, {"Cancel", [](AppState&) {}}}});
}

void ask_to_replace(AppState& state, const std::string& file, std::function<void(AppState&)> write) {
    ask_to_replace(state, std::vector<std::string>{file}, std::move(write));
}

std::string name_without_ending(std::string name) {
    for (const std::string_view ending : {".json", ".garment"}) {
        if (name.size() > ending.size() && name.ends_with(ending)) name.resize(name.size() - ending.size());
    }
    return name;
}

std::string document_name(const AppState& state) {
    const std::string& file = state.workspace.file;
    return file.empty() ? "untitled" : name_in_folder(file);
}

void new_document(AppState& state) {
    after_asking(state, [](AppState& current) { show_document(current, empty_garment(), {}); });
}

void open_loaded(AppState& state, sim::PatternDocument source, const std::string& file) {
    show_document(state, std::move(source), {.file = file, .hash = hash_of(state, file)});
    state.services.remember_file(file);
}

// The hash is taken first: a change between the two is asked about when the document is saved.
void load_and_open(AppState& state, const std::string& file) {
    std::optional<std::string> hash = hash_of(state, file);
    sim::PatternDocument source = state.services.load(file);
    show_document(state, std::move(source), {.file = file, .hash = std::move(hash)});
    state.services.remember_file(file);
}

void open_file(AppState& state, const std::string& file) {
    after_asking(state, [file](AppState& current) { try_to(current, [&] { load_and_open(current, file); }); });
}

namespace {

// Offers the other sizes of the drawing that was imported.
void ask_for_size(AppState& state, const std::string& file, const std::vector<std::string>& sizes,
                  const sim::ImportOptions& options) {
    const std::string shown = state.workspace.document->pattern().size;
    std::vector<Question::Answer> answers{{shown.empty() ? "Keep" : "Keep " + shown, [](AppState&) {}}};
    constexpr std::size_t kMostAnswers = 10;
    for (const std::string& size : sizes) {
        if (size == shown || answers.size() == kMostAnswers) continue;
        answers.push_back({size, [file, size, options](AppState& current) {
                               sim::ImportOptions other = options;
                               other.panels.size = size;
                               current.workspace.document->mark_saved();  // what was imported is given up
                               import_file(current, file, other);
                           }});
    }
    state.questions.push_front({"'" + name_in_folder(file) + "' has " + std::to_string(sizes.size()) + " sizes" +
                                    (shown.empty() ? "" : "; this is " + shown) + ". Which one?",
                                std::move(answers)});
}

bool holds(const AppState& state, const PictureFile& picture) {
    return state.services.hash_of && state.services.hash_of(picture.file) == sim::sha256(picture.bytes);
}

// Whose places are taken by files that hold something else.
std::vector<std::string> taken_files(const AppState& state, const std::vector<PictureFile>& pictures) {
    std::vector<std::string> files;
    for (const PictureFile& picture : pictures) {
        if (state.services.exists(picture.file) && !holds(state, picture)) files.push_back(picture.file);
    }
    return files;
}

// If it fails, no file is left that was not there before.
void write_pictures(AppState& state, const std::vector<PictureFile>& pictures) {
    std::vector<std::string> added;
    try {
        for (const PictureFile& picture : pictures) {
            const bool is_there = state.services.exists(picture.file);
            if (is_there && holds(state, picture)) continue;
            state.services.save(picture.file, picture.bytes);
            if (!is_there) added.push_back(picture.file);
        }
    } catch (...) {
        for (const std::string& file : added) state.services.remove(file);
        throw;
    }
}

// The document is shown when its pictures are there, so that it can be saved, and recovered after a crash. Panels are
// shown without pictures that cannot be written.
void show_import(AppState& state, ImportedDrawing& imported, const std::string& file,
                 const sim::ImportOptions& options) {
    std::string failure;
    try {
        write_pictures(state, imported.pictures);
    } catch (const std::exception& error) {  // InputError, or what the system refuses
        if (imported.garment.pattern.panels.empty()) throw;
        failure = error.what();
        imported.pictures.clear();
        imported.garment.pattern.underlays.clear();
    }
    show_document(state, imported.garment, {.is_unsaved = true});
    state.workspace.document->set_hints(imported.hints);
    Messages& messages = state.workspace.messages;
    for (const std::string& note : imported.notes) messages.note(note);
    for (const PictureFile& picture : imported.pictures) messages.note("Wrote " + picture.file);
    const std::string scans = imported.pictures.empty() ? ""
                                                        : "; " + sim::count_text(imported.pictures.size(), "scan") +
                                                              " under the sheet, to be traced";
    messages.note("Imported '" + name_in_folder(file) + "': " + imported.sewn + scans);
    if (!failure.empty())
        messages.warn("The scans of '" + name_in_folder(file) + "' do not lie under the sheet: " + failure);
    if (imported.sizes.size() > 1 && options.panels.size.empty()) ask_for_size(state, file, imported.sizes, options);
}

}  // namespace

void import_file(AppState& state, const std::string& file, const sim::ImportOptions& options) {
    if (state.services.is_photo(file)) return lay_photo(state, file);
    after_asking(state, [file, options](AppState& current) {
        try_to(current, [&] {
            const auto imported = std::make_shared<ImportedDrawing>(current.services.import_drawing(file, options));
            const auto show = [=](AppState& shown) {
                try_to(shown, [&] { show_import(shown, *imported, file, options); });
            };
            const std::vector<std::string> taken = taken_files(current, imported->pictures);
            if (taken.empty()) return show(current);
            ask_to_replace(current, taken, show);
        });
    });
}

void wear_over(AppState& state, const std::string& file) {
    state.workspace.document->commit();
    try_to(state, [&] {
        const sim::PatternDocument outer = state.services.load(file);
        if (outer.pattern.panels.empty())
            return state.workspace.messages.warn("'" + name_in_folder(file) + "' has no panels: nothing to wear");
        state.workspace.wear_over(outer);
    });
}

void open_example(AppState& state, const Example& example) {
    after_asking(state, [example](AppState& current) {
        try_to(current, [&] { show_document(current, sim::parse_pattern(example.text, example.title), {}); });
    });
}

namespace {

// Without changes of the garment, its file is what was saved last, unless it can no longer be read.
sim::PatternDocument recovered_document(const AppState& state, const Recovery& recovery) {
    if (!recovery.has_changes() && !recovery.file.empty() && state.services.exists(recovery.file)) {
        try {
            return state.services.load(recovery.file);
        } catch (const sim::InputError&) {
        }
    }
    return sim::parse_pattern(recovery.text, recovery.file);
}

// Returns whether all drafts are back.
bool recover_drafts(Workspace& workspace, const std::map<std::string, sim::Fabric>& drafts) {
    bool are_all_back = true;
    for (const auto& [name, draft] : drafts) {
        if (!workspace.fabrics.recover_draft(name, draft)) {
            are_all_back = false;
            workspace.messages.warn("The fabric '" + readable_name(name) + "' was not recovered: it is being edited");
            continue;
        }
        workspace.fabrics.show(name);
        workspace.messages.note("Recovered what was edited of the fabric '" + readable_name(name) +
                                "': the Cloth tab shows it");
    }
    return are_all_back;
}

std::string lines_text(int count) {
    return std::to_string(count) + (count == 1 ? " line" : " lines");
}

}  // namespace

void recover_journal(AppState& state, const OrphanedJournal& journal) {
    const auto go_on = [journal](AppState& current) {
        const Recovery& recovery = *journal.recovery;
        const bool is_open = try_to(current, [&] {
            // What the file held when the journal began, unless it is read again: saving asks if it is another now.
            const bool has_changes = recovery.has_changes();
            const auto hash = has_changes ? recovery.file_hash : hash_of(current, recovery.file);
            show_document(current, recovered_document(current, recovery),
                          {.file = recovery.file, .hash = hash, .is_unsaved = has_changes});
        });
        if (!is_open) return;
        if (recovery.has_changes())
            current.workspace.messages.note("Recovered '" + document_name(current) + "': save it to keep it");
        // The new journal has the document, and the drafts are noted in it: both can be recovered again.
        const bool are_all_back = recover_drafts(current.workspace, recovery.drafts);
        if (recovery.unread_lines == 0) {
            if (are_all_back) current.services.discard_journal(journal.id);
            return;
        }
        try_to(current, [&] {
            current.workspace.messages.warn("Recovered '" + document_name(current) + "' but for " +
                                            lines_text(recovery.unread_lines) +
                                            " that cannot be read: the journal is kept as '" +
                                            current.services.set_aside_journal(journal.id) + "'");
        });
    };
    after_asking(state, go_on);
}

void take_dropped_file(AppState& state, const std::string& file) {
    if (state.services.is_photo(file) || state.services.is_drawing(file)) return import_file(state, file);
    if (file.ends_with(".json")) return open_file(state, file);
    const auto is_ending = [&](const std::string& ending) { return file.ends_with(ending); };
    if (std::ranges::any_of(body_endings(), is_ending)) return state.workspace.drape.show_body(file);
    state.workspace.messages.warn("'" + file +
                                  "' is neither a garment (.json), a drawing (.svg, .dxf, .pdf), a photo (.png, .jpg) "
                                  "nor a body (.obj, .glb)");
}

void save(AppState& state, std::function<void(AppState&)> then) {
    const std::string file = state.workspace.file;
    if (file.empty()) return browse_to_save(state);
    if (is_changed_by_others(state)) return ask_about_changed_file(state, then);
    write_and_go_on(state, file, then);
}

void save_as(AppState& state, const std::string& file, IfExists if_exists) {
    const std::string target = with_ending(file, ".json");
    const auto write = [target](AppState& current) { try_to(current, [&] { write_document(current, target); }); };
    if (if_exists == IfExists::Replace) return write(state);
    if (is_file_of_document(state, target)) return save(state);
    if (!state.services.exists(target)) return write(state);
    ask_to_replace(state, target, write);
}

void export_to(AppState& state, const std::string& file, const ExportThickness& thickness, IfExists if_exists) {
    const ExportRequest request{.file = file,
                                .scene = state.viewport.scene,
                                .camera = state.viewport.camera,
                                .light = state.viewport.light,
                                .garment = state.workspace.drape.frame()->mesh,
                                .thickness = thickness,
                                .pattern = state.workspace.document->pattern()};
    if (!request.scene || request.garment.triangles.empty()) {
        return state.workspace.messages.warn("There is nothing to export yet");
    }
    const auto write = [file, request](AppState& current) {
        const bool is_written = try_to(current, [&] {
            refuse_garment_and_its_files(current, file);
            current.services.write_export(request);
        });
        if (is_written) current.workspace.messages.note("Wrote " + file);
    };
    if (if_exists == IfExists::Replace || !state.services.exists(file)) return write(state);
    ask_to_replace(state, file, write);
}

void print_to(AppState& state, const std::string& file, const sim::PrintSettings& settings, IfExists if_exists) {
    state.workspace.document->commit();
    const auto write = [file, settings](AppState& current) {
        try_to(current, [&] {
            refuse_garment_and_its_files(current, file);
            current.workspace.messages.note(
                "Wrote " + file + ": " + current.services.print(current.workspace.document->pattern(), file, settings));
        });
    };
    if (if_exists == IfExists::Replace || !state.services.exists(file)) return write(state);
    ask_to_replace(state, file, write);
}

void save_pose(AppState& state, const std::string& file) {
    const sim::PoseAngles* angles = state.workspace.drape.angles();
    if (angles == nullptr) return state.workspace.messages.warn("There is no pose to save: the body has no joints");
    const std::string target = with_ending(file, ".json");
    const auto write = [target, angles = *angles](AppState& current) {
        try_to(current, [&] { write_pose_file(current, target, angles); });
    };
    if (!state.services.exists(target)) return write(state);
    ask_to_replace(state, target, write);
}

void close(AppState& state) {
    const auto end = [](AppState& current) {
        current.services.end_journal();
        current.wants_to_close = true;
    };
    after_asking(state, [end](AppState& current) { after_asking_about_fabrics(current, end); });
}

void browse_to_open(AppState& state) {
    state.browser.open({.title = "Open a garment",
                        .verb = "Open",
                        .endings = {".json"},
                        .choose = [](AppState& current, const std::string& file) { open_file(current, file); }},
                       state.services);
}

void browse_to_import(AppState& state) {
    state.browser.open(
        {.title = "Import a drawing, or a photo to trace",
         .verb = "Import",
         .endings = {".svg", ".dxf", ".pdf", ".PDF", ".json", ".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"},
         .show_options = show_import_options,
         .option_rows = kImportOptionRows,
         .choose = [](AppState& current,
                      const std::string& file) { import_file(current, file, current.import_options); }},
        state.services);
}

void browse_to_wear_over(AppState& state) {
    state.browser.open({.title = "Wear a garment over this one",
                        .verb = "Wear",
                        .endings = {".json"},
                        .choose = [](AppState& current, const std::string& file) { wear_over(current, file); }},
                       state.services);
}

void browse_to_save(AppState& state) {
    state.browser.open({.title = "Save the garment",
                        .verb = "Save",
                        .endings = {".json"},
                        .is_saving = true,
                        .name = state.workspace.file.empty() ? "new.garment.json" : document_name(state),
                        .choose = [](AppState& current, const std::string& file) { save_as(current, file); }},
                       state.services);
}

void browse_to_export(AppState& state, const std::string& ending) {
    const std::string name = name_without_ending(document_name(state));
    state.browser.open({.title = "Export",
                        .verb = "Export",
                        .endings = {ending},
                        .is_saving = true,
                        .name = name + ending,
                        .show_options = ending == ".png" ? nullptr : show_export_thickness,
                        .choose =
                            [ending](AppState& current, const std::string& file) {
                                export_to(current, with_ending(file, ending), current.export_thickness);
                            }},
                       state.services);
}

void browse_to_print(AppState& state, const std::string& ending) {
    const std::string name = name_without_ending(document_name(state));
    state.browser.open({.title = "Print the pattern",
                        .verb = "Write",
                        .endings = {ending},
                        .is_saving = true,
                        .name = name + ending,
                        .show_options = [ending](AppState& current) { show_print_options(current, ending); },
                        .option_rows = print_option_rows(ending),
                        .choose =
                            [ending](AppState& current, const std::string& file) {
                                print_to(current, with_ending(file, ending),
                                         settings_for(current.print_settings, ending));
                            }},
                       state.services);
}

namespace {

void show_picture(AppState& state, const std::string& file) {
    const std::set<std::string>& selected = state.workspace.document->selection().panels;
    try_to(state, [&] {
        state.services.read_photo(file);  // so that a file that is none is refused
        const auto show = [&](const std::string& panel) -> Command {
            const auto& pattern = state.workspace.document->pattern();
            const std::optional<int> index = panel.empty() ? std::nullopt : panel_index(pattern, panel);
            const auto& before = index ? pattern.panels[static_cast<std::size_t>(*index)].surface : pattern.surface;
            sim::SurfaceDesign design = before.value_or(sim::SurfaceDesign{});
            design.kind = sim::DesignKind::Picture;
            design.source = state.services.full_path(file);
            return SetSurface{.panel = panel, .surface = design};
        };
        std::vector<Command> commands;
        if (selected.empty()) commands.push_back(show(""));
        for (const std::string& panel : selected) commands.push_back(show(panel));
        state.workspace.run_together(commands);
    });
}

}  // namespace

void browse_for_picture(AppState& state) {
    state.browser.open({.title = "Choose a picture that the cloth shows",
                        .verb = "Show",
                        .endings = {".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"},
                        .choose = [](AppState& current, const std::string& file) { show_picture(current, file); }},
                       state.services);
}

void browse_for_body(AppState& state) {
    state.browser.open(
        {.title = "Put it on a body",
         .verb = "Wear",
         .endings = body_endings(),
         .choose = [](AppState& current, const std::string& file) { current.workspace.drape.show_body(file); }},
        state.services);
}

void browse_for_motion(AppState& state) {
    state.browser.open({.title = "Play a motion",
                        .verb = "Open",
                        .endings = {".bvh", ".fbx", ".glb", ".gltf", ".json"},
                        .choose =
                            [](AppState& current, const std::string& file) {
                                current.layout.has_timeline = true;
                                current.workspace.drape.choose_motion(file);
                            }},
                       state.services);
}

void browse_for_pose(AppState& state) {
    state.browser.open(
        {.title = "Go into a pose",
         .verb = "Open",
         .endings = {".json"},
         .choose = [](AppState& current, const std::string& file) { current.workspace.drape.choose_pose(file); }},
        state.services);
}

void browse_to_save_pose(AppState& state) {
    state.browser.open({.title = "Save the pose",
                        .verb = "Save",
                        .endings = {".json"},
                        .is_saving = true,
                        .name = "my_pose.json",
                        .choose = [](AppState& current, const std::string& file) { save_pose(current, file); }},
                       state.services);
}

namespace {

// "'shirt.json' (3 changes) and the fabric 'Silk'"
std::string unsaved_text(const Recovery& recovery) {
    std::string text;
    if (recovery.has_changes())
        text = recovery.file.empty() ? "an unsaved garment" : "'" + name_in_folder(recovery.file) + "'";
    if (recovery.changes > 0) {
        text += " (" + std::to_string(recovery.changes) + (recovery.changes == 1 ? " change)" : " changes)");
    }
    for (const auto& [name, draft] : recovery.drafts)
        text += (text.empty() ? "the fabric '" : " and the fabric '") + readable_name(name) + "'";
    return text;
}

// It is kept: another version of the program, or a person, may make something of it.
void report_damaged(AppState& state, const OrphanedJournal& journal) {
    try_to(state, [&] {
        const std::string file = state.services.set_aside_journal(journal.id);
        state.questions.push_back({"The journal of an editor that ended " + journal.age +
                                       " is damaged or of another version: nothing was recovered. It is kept as '" +
                                       file + "'.",
                                   {{"OK", [](AppState&) {}}}});
    });
}

}  // namespace

void offer_recovery(AppState& state) {
    for (const OrphanedJournal& journal : state.services.orphaned_journals()) {
        if (!journal.recovery) {
            report_damaged(state, journal);
            continue;
        }
        const int unread = journal.recovery->unread_lines;
        const std::string damage = unread == 0 ? "" : " " + lines_text(unread) + " after that cannot be read.";
        state.questions.push_back(
            {"The editor ended " + journal.age + " without saving " + unsaved_text(*journal.recovery) + "." + damage,
             {{"Recover", [journal](AppState& current) { recover_journal(current, journal); }},
              {"Discard", [journal](AppState& current) { current.services.discard_journal(journal.id); }},
              {"Later", [](AppState&) {}}}});
    }
}

void begin_journal(AppState& state) {
    Workspace& workspace = state.workspace;
    // The whole path: the next editor may start in another folder.
    const std::string file = workspace.file.empty() ? "" : state.services.full_path(workspace.file);
    std::string text = journal_head(
        file, workspace.document->text(file),
        {.is_unsaved = workspace.document->has_unsaved_changes(), .file_hash = state.file_hash.value_or("")});
    for (const std::string& line : workspace.fabrics.journal_lines()) text += "\n" + line;
    if (!try_to(state, [&] { state.services.begin_journal(text); })) return;
    const auto note = [&state](std::string_view line) { state.services.note_in_journal(line); };
    workspace.document->set_journal(note);
    workspace.fabrics.set_journal(note);
}

void report_journal_problem(AppState& state) {
    if (!state.services.journal_problem) return;
    std::string problem = state.services.journal_problem();
    const bool is_new = !problem.empty() && state.journal_problem.empty();
    const bool has_ended = problem.empty() && !state.journal_problem.empty();
    if (is_new)
        state.workspace.messages.say(
            {.kind = MessageKind::Error,
             .text = "After a crash, the last changes could not be recovered: save them. " + problem,
             .places = {}});
    if (has_ended) state.workspace.messages.note("All changes can be recovered after a crash again");
    state.journal_problem = std::move(problem);
}

}  // namespace selvedge::editor
