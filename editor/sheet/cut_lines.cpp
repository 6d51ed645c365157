#include "editor/sheet/cut_lines.h"

#include <algorithm>
#include <utility>

namespace selvedge::editor {

namespace {

std::vector<sim::Dart> darts_of(const sim::Panel& panel, const sim::Pattern& pattern) {
    const auto own = std::ranges::find(pattern.panels, panel.name, &sim::Panel::name);
    if (own == pattern.panels.end() || own->edges.size() != panel.edges.size()) return {};
    return sim::find_darts(panel, static_cast<int>(own - pattern.panels.begin()), pattern.seams);
}

}  // namespace

const sim::CutLine* CutLines::find(const sim::Panel& panel, const sim::Pattern& pattern) {
    const double pattern_allowance = pattern.allowance;
    const bool has_any = std::ranges::any_of(panel.edges, [&](const sim::OutlineEdge& edge) {
        return sim::allowance_of(panel, edge, pattern_allowance) > 0;
    });
    if (!has_any) {
        kept_.erase(panel.name);
        return nullptr;
    }
    constexpr double kScreenError = 2e-4;  // m: a tenth of a pixel where a panel fills the view
    std::vector<sim::Dart> darts = darts_of(panel, pattern);
    const auto [place, is_new] = kept_.try_emplace(panel.name);
    Kept& kept = place->second;
    if (is_new || kept.pattern_allowance != pattern_allowance || kept.darts != darts || !(kept.panel == panel)) {
        kept = {.panel = panel,
                .pattern_allowance = pattern_allowance,
                .darts = darts,
                .line = cut_line(
                    panel,
                    {.pattern_allowance = pattern_allowance, .chord_error = kScreenError, .darts = std::move(darts)})};
    }
    return &kept.line;
}

}  // namespace selvedge::editor
