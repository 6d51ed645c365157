#pragma once
// What the editor asks of the program, as it is on a real machine: files, journals, exports.
#include <functional>
#include <memory>

#include "app/journal_store.h"
#include "editor/ui/services.h"
#include "render/image/image.h"

namespace selvedge {

struct EditorServicesOptions {
    std::filesystem::path state;  // where journals and recent files are kept
    // Draws a scene at a size (px) as finely as can be; for exports.
    std::function<Image(const Scene& scene)> draw_finely;
};

// Throws InputError when the state folder cannot be made.
Services make_editor_services(const EditorServicesOptions& options);

}  // namespace selvedge
