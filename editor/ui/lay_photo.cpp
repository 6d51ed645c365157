// Photos and scans (PNG, JPEG) that are laid under the sheet, to be traced (editor/ui/files.h).
#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "editor/tools/tool_host.h"
#include "editor/tools/underlay_tool.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"

namespace selvedge::editor {
namespace {

constexpr double kGuessedPhotoSide = 1;  // m, longer side of a photo that does not state its resolution

// Right of all panels and photos, with its upper edge at theirs.
Vec2d free_photo_place(const AppState& state, const Vec2d& size) {
    const SheetBox taken = extended(state.tools.geometry().box(), state.workspace.document->pattern().underlays,
                                    [&](const std::string& file) { return state.underlays.size_px(file); });
    constexpr double kGap = 0.05;  // m
    if (taken.isEmpty()) return Vec2d::Zero();
    return {taken.max().x() + kGap + size.x() / 2, taken.max().y() - size.y() / 2};
}

std::string size_text(const Vec2d& size) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f x %.1f cm", 100 * size.x(), 100 * size.y());
    return text.data();
}

}  // namespace

void lay_photo(AppState& state, const std::string& file) {
    Document& document = *state.workspace.document;
    document.commit();
    try_to(state, [&] {
        render::Photo photo = state.services.read_photo(file);
        const bool has_size = photo.pixel_size.has_value();
        const Vec2d px(photo.image.width_px, photo.image.height_px);
        sim::Underlay underlay{.file = state.services.full_path(file),
                               .pixel_size = photo.pixel_size.value_or(kGuessedPhotoSide / px.maxCoeff())};
        underlay.position = free_photo_place(state, underlay.pixel_size * px);
        SetUnderlays command{.underlays = document.pattern().underlays, .what = "Lay photo under the sheet"};
        command.underlays.push_back(underlay);
        if (!state.workspace.run(command)) return;
        state.underlays.hold(underlay.file, std::move(photo));
        state.shows_start_page = false;
        state.wants_whole_sheet = true;
        state.tools.choose(tool_host_context(state.workspace), underlay_tool());
        const std::string size = size_text(underlay.pixel_size * px);
        state.workspace.messages.note("'" + file.substr(file.find_last_of('/') + 1) + "' is " +
                                      (has_size ? size + ", as its file says"
                                                : size + " for now: its file states no size. Click two points "
                                                         "and type their distance"));
    });
}

}  // namespace selvedge::editor
