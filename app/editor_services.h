#pragma once
// Implements the services that the editor requires: files, journals, exports, recent files. Also connects the editor to
// the loop that shows it, and loads its fonts.
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/edit_loop.h"
#include "app/journal_store.h"
#include "editor/ui/editor.h"
#include "editor/ui/services.h"
#include "render/image/image.h"

namespace selvedge::app {

struct EditorServicesOptions {
    std::optional<std::filesystem::path> state{};  // folder of journals and recent files; none: nothing is kept
    // Renders a scene at full quality, for exports.
    std::function<render::Image(const render::Scene& scene)> render_full_quality;
};

// Throws InputError if there is to be a state folder and it cannot be created.
editor::Services make_editor_services(const EditorServicesOptions& options);

// The recently opened or saved files, stored between runs.

class RecentFiles {
 public:
    explicit RecentFiles(std::filesystem::path file) : file_(std::move(file)) {}

    std::vector<std::string> list() const;  // existing files only, newest first

    // Moves the file to the front of the list. Write errors are ignored.
    void add(const std::string& path) const;

 private:
    std::filesystem::path file_;
};

// The user's choices of keys and colours, stored between runs.

class SettingsFile {
 public:
    explicit SettingsFile(std::filesystem::path file) : file_(std::move(file)) {}

    editor::UserSettings load() const;                      // the editor's own, if nothing valid is stored
    void save(const editor::UserSettings& settings) const;  // write errors are ignored

 private:
    std::filesystem::path file_;
};

// Adapts the editor to the EditSurface interface of the loop.

class EditorSurface final : public EditSurface {
 public:
    explicit EditorSurface(editor::Editor& editor) : editor_(editor) {}

    editor::FrameOutput frame(const FrameInput& input) override;

 private:
    editor::Editor& editor_;
};

// Reads the system's fonts; empty if none is installed.
editor::FontBytes read_fonts();

}  // namespace selvedge::app
