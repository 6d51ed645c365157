#pragma once
// What the editor asks of the program that it runs in: files, journals, exports. Plain functions, so that tests bring
// their own. Those that can fail throw InputError.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/journal.h"
#include "editor/workspace/workspace.h"
#include "render/scene/scene.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::editor {

struct FolderEntry {
    std::string name;
    bool is_folder = false;
};

struct FolderListing {
    std::string folder;                // absolute
    std::string parent;                // empty: there is none
    std::vector<FolderEntry> entries;  // folders first, by name; hidden ones left out
};

struct Example {
    std::string title;
    std::string what;  // a sentence
    std::string text;  // the garment file
};

// A journal of an editor that was killed.
struct LeftJournal {
    std::string id;
    Recovery recovery;
    std::string age;  // "3 minutes ago"
};

// What is written where the file's name ends in .png, .obj or .glb.
struct ExportRequest {
    std::string file;
    std::shared_ptr<const render::Scene> scene;  // of a picture
    render::Camera camera{};
    render::Light light{};
    sim::PlainMesh garment{};
};

struct Services {
    std::function<sim::PatternDocument(const std::string& file)> load;
    std::function<void(const std::string& file, const std::string& text)> save;  // atomic
    std::function<FolderListing(const std::string& folder)> list_folder;         // empty: where the program was started
    std::function<bool(const std::string& file)> exists;
    std::function<void(const ExportRequest& request)> write_export;
    BodyMaker make_body = make_worn_mannequin;

    std::function<std::vector<std::string>()> recent_files;  // newest first
    std::function<void(const std::string& file)> remember_file;
    std::vector<Example> examples{};

    // The journal of the open document begins anew with its first line, then gets a line for each change.
    std::function<void(const std::string& head)> begin_journal;
    std::function<void(std::string_view line)> note_in_journal;
    std::function<void()> end_journal;  // nothing is left to recover
    std::function<std::vector<LeftJournal>()> left_journals;
    std::function<void(const std::string& id)> discard_journal;
};

// Keeps nothing and finds nothing: for tests, which replace what they need.
Services no_services();

}  // namespace selvedge::editor
