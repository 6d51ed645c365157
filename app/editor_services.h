#pragma once
// What the editor asks of the program, as it is on a real machine: files, journals, exports.
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/edit_loop.h"
#include "app/journal_store.h"
#include "editor/ui/editor.h"
#include "editor/ui/services.h"
#include "render/image/image.h"

namespace selvedge::app {

struct EditorServicesOptions {
    std::filesystem::path state;  // where journals and recent files are kept
    // Draws a scene at a size (px) as finely as can be; for exports.
    std::function<render::Image(const render::Scene& scene)> draw_finely;
};

// Throws InputError when the state folder cannot be made.
editor::Services make_editor_services(const EditorServicesOptions& options);

// The files that were opened or saved last, kept from one run to the next.

class RecentFiles {
 public:
    explicit RecentFiles(std::filesystem::path file) : file_(std::move(file)) {}

    std::vector<std::string> list() const;  // those that are still there, newest first

    // First from now on. What cannot be written is only forgotten.
    void add(const std::string& path) const;

 private:
    std::filesystem::path file_;
};

// The editor as the loop that shows it wants it, and the letters that it is given.

class EditorSurface final : public EditSurface {
 public:
    explicit EditorSurface(editor::Editor& editor) : editor_(editor) {}

    editor::FrameOutput frame(const FrameInput& input) override;

 private:
    editor::Editor& editor_;
};

// The system's; empty where it has none.
editor::FontBytes read_fonts();

}  // namespace selvedge::app
