#pragma once
// What the editor requires from its host program: files, journals, exports. Plain std::functions, so that tests can
// replace them. Those that can fail throw InputError.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/journal.h"
#include "editor/frame/frame.h"
#include "editor/ui/underlay_pictures.h"
#include "editor/workspace/workspace.h"
#include "render/scene/scene.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/paper/import_options.h"
#include "sim/pattern/pattern_file.h"
#include "sim/print/print_settings.h"

namespace selvedge::editor {

struct FolderEntry {
    std::string name;
    bool is_folder = false;
};

struct FolderListing {
    std::string folder;                // absolute path
    std::string parent;                // empty: there is none
    std::vector<FolderEntry> entries;  // folders first, sorted by name; without hidden ones
};

struct Example {
    std::string title;
    std::string what;  // one sentence
    std::string text;  // content of the garment file
};

// A journal of an editor that did not exit normally.
struct OrphanedJournal {
    std::string id;
    std::optional<Recovery> recovery;  // none: it is damaged, and nothing of it can be recovered
    std::string age;                   // for example "3 minutes ago"
};

// How thick the cloth of an exported mesh is: not at all, as the fabric of each panel, or as given.
struct ExportThickness {
    enum class Kind { None, Fabric, Given };
    Kind kind = Kind::None;
    double metres = 0.001;  // of Given, 0.00001 to 0.05
};

// An export; the extension of `file` selects the format: .png, .obj, .glb, .ply or .stl.
struct ExportRequest {
    std::string file;
    std::shared_ptr<const render::Scene> scene;  // for an image
    render::Camera camera{};
    render::Light light{};
    sim::DrawMesh garment{};
    ExportThickness thickness{};  // of a mesh
    sim::Pattern pattern{};       // says what the garment's panels are made of
};

struct PictureFile {
    std::string file;
    std::string bytes;
};

// What became of a drawing of another program.
struct ImportedDrawing {
    sim::PatternDocument garment = {};
    std::string sewn = {};                   // "8 seams were sewn, 3 more are possible"
    std::vector<std::string> notes = {};     // what was guessed, repaired and left out, one line each
    std::string hints = {};                  // its texts about the whole garment
    std::vector<std::string> sizes = {};     // that it has; the garment is of one of them (Pattern::size)
    std::vector<PictureFile> pictures = {};  // that its underlays name, to be written beside the drawing
};

struct UserSettings {
    KeyMap keys = KeyMap::Selvedge;
    bool is_dark = false;

    bool operator==(const UserSettings&) const = default;
};

struct Services {
    std::function<sim::PatternDocument(const std::string& file)> load;
    std::function<bool(const std::string& file)> is_drawing;  // of another program, by its content
    std::function<ImportedDrawing(const std::string& file, const sim::ImportOptions& options)> import_drawing;
    std::function<bool(const std::string& file)> is_photo;  // PNG or JPEG, by its ending
    PhotoReader read_photo;
    // Writes a pattern for the cutting table (.pdf, .svg, .dxf), and says what was written.
    std::function<std::string(const sim::Pattern& pattern, const std::string& file, const sim::PrintSettings& settings)>
        print;
    std::function<void(const std::string& file, const std::string& text)> save;  // atomic
    std::function<void(const std::string& file)> remove;                         // if it can be
    std::function<FolderListing(const std::string& folder)> list_folder;         // empty: the working directory
    std::function<bool(const std::string& file)> exists;
    // The SHA-256 of what the file holds; none: there is no such file, or it cannot be read. Unset: it is not known.
    std::function<std::optional<std::string>(const std::string& file)> hash_of{};
    std::function<std::string(const std::string& file)> full_path;  // from the root folder
    std::function<void(const ExportRequest& request)> write_export;
    BodyMaker make_body = make_mannequin_body;
    MotionFinder find_motion = sim::find_motion;
    FabricReader read_fabric = sim::read_fabric_file;

    // The user's choices, kept from one start to the next. Unset: they are not kept.
    std::function<UserSettings()> load_settings{};
    std::function<void(const UserSettings& settings)> save_settings{};

    std::string manual{};  // of the editor, as Markdown; empty: there is none

    std::function<std::vector<std::string>()> recent_files;  // newest first
    std::function<void(const std::string& file)> remember_file;
    std::vector<Example> examples{};

    // begin_journal starts a new journal for the open document with its first line, and those of the drafts of fabrics;
    // note_in_journal appends one line per change.
    std::function<void(const std::string& text)> begin_journal;
    std::function<void(std::string_view line)> note_in_journal;
    std::function<void()> end_journal;               // deletes the journal: nothing to recover
    std::function<std::string()> journal_problem{};  // why it lacks lines now; empty: it has all. Unset: likewise
    std::function<std::vector<OrphanedJournal>()> orphaned_journals;
    std::function<void(const std::string& id)> discard_journal;
    // Moves a damaged journal to where it is not offered again, and returns the name of the file.
    std::function<std::string(const std::string& id)> set_aside_journal;
};

}  // namespace selvedge::editor
