#include "editor/sheet/cut_lines.h"

#include <algorithm>

namespace selvedge::editor {

const sim::CutLine* CutLines::find(const sim::Panel& panel, double pattern_allowance) {
    const bool has_any = std::ranges::any_of(panel.edges, [&](const sim::OutlineEdge& edge) {
        return sim::allowance_of(panel, edge, pattern_allowance) > 0;
    });
    if (!has_any) {
        kept_.erase(panel.name);
        return nullptr;
    }
    constexpr double kScreenError = 2e-4;  // m: a tenth of a pixel where a panel fills the view
    const auto [place, is_new] = kept_.try_emplace(panel.name);
    Kept& kept = place->second;
    if (is_new || kept.pattern_allowance != pattern_allowance || !(kept.panel == panel)) {
        kept = {.panel = panel,
                .pattern_allowance = pattern_allowance,
                .line = cut_line(panel, {.pattern_allowance = pattern_allowance, .chord_error = kScreenError})};
    }
    return &kept.line;
}

}  // namespace selvedge::editor
