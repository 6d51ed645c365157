#include "tests/editor/document/random_commands.h"

#include <algorithm>
#include <cmath>

namespace selvedge::editor {
namespace {

constexpr std::size_t kManyPanels = 14;  // with more panels, removals outnumber additions

const sim::Panel* find(const sim::Pattern& pattern, const std::string& name) {
    const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                    [&](const sim::Panel& panel) { return panel.name == name; });
    return found == pattern.panels.end() ? nullptr : &*found;
}

}  // namespace

int RandomCommands::pick(std::size_t count) {
    return static_cast<int>(random_() % std::max<std::size_t>(1, count));
}

double RandomCommands::between(double least, double most) {
    return least + (most - least) * static_cast<double>(random_() % 100001) / 100000.0;
}

Vec2d RandomCommands::some_shift(double most) {
    return {between(-most, most), between(-most, most)};
}

std::string RandomCommands::some_panel(const sim::Pattern& pattern) {
    if (pattern.panels.empty() || pick(200) == 0) return "nobody";
    return pattern.panels[static_cast<std::size_t>(pick(pattern.panels.size()))].name;
}

PartRef RandomCommands::some_vertex(const sim::Pattern& pattern) {
    const std::string name = some_panel(pattern);
    const sim::Panel* panel = find(pattern, name);
    return {name, panel == nullptr ? 0 : pick(panel->vertices.size())};
}

PartRef RandomCommands::some_edge(const sim::Pattern& pattern) {
    const std::string name = some_panel(pattern);
    const sim::Panel* panel = find(pattern, name);
    return {name, panel == nullptr ? 0 : pick(panel->edges.size())};
}

PlaneMap RandomCommands::some_map() {
    const double angle = between(-0.5, 0.5), size = between(0.9, 1.1);
    const double flip = pick(4) == 0 ? -1 : 1;
    return {.x_axis = flip * size * Vec2d(std::cos(angle), std::sin(angle)),
            .y_axis = size * Vec2d(-std::sin(angle), std::cos(angle)),
            .shift = some_shift(0.05)};
}

Command RandomCommands::next(const sim::Pattern& pattern) {
    if (pattern.panels.size() > kManyPanels && pick(2) == 0) return RemoveParts{.panels = {some_panel(pattern)}};
    const int kind = pick(12);
    switch (pick(8)) {
        case 0:
            return on_pattern(pattern, kind);
        case 1:
        case 2:
            return on_panel(pattern, kind);
        case 3:
            return on_seams(pattern, kind);
        default:
            return on_outline(pattern, kind);
    }
}

Command RandomCommands::on_pattern(const sim::Pattern& pattern, int kind) {
    constexpr const char* fabrics[] = {"silk", "denim", "", "cardboard"};
    constexpr const char* tartans[] = {"black_watch", "K/8 R24 W/4", "", "Q5"};
    const std::size_t which = static_cast<std::size_t>(pick(4));
    switch (kind) {
        case 0:
            return RenamePattern{.to = "garment " + std::to_string(pick(9))};
        case 1:
        case 2:
            return SetFabric{.panel = pick(2) == 0 ? "" : some_panel(pattern), .fabric = fabrics[which]};
        case 3:
            return SetTartan{.tartan = tartans[which], .size = between(0, 0.3), .position = some_shift(0.1)};
        case 4:
            return SetBody{.body = "mannequin:bust=" + std::to_string(85 + pick(20))};
        case 5:
            return SetEdgeLength{.length = pick(3) == 0 ? std::nullopt : std::optional(between(0, 0.1))};
        case 6:
            return TranslateAll{.by = Vec3d(between(-1, 1), 0, 0.1)};
        case 7:
            return AddPanels{.panels = {pattern.panels.empty() ? sim::Panel{} : pattern.panels.front()}};
        case 8:
            return RemoveParts{.panels = {some_panel(pattern)}};
        default:
            return RemoveParts{.vertices = {some_vertex(pattern)}, .seams = {pick(pattern.seams.size() + 1)}};
    }
}

Command RandomCommands::on_panel(const sim::Pattern& pattern, int kind) {
    const std::string panel = some_panel(pattern);
    switch (kind) {
        case 0:
            return RenamePanel{.panel = panel, .to = "panel_" + std::to_string(pick(40))};
        case 1:
            return DuplicatePanels{.panels = {panel, some_panel(pattern)},
                                   .shift = some_shift(0.5),
                                   .move = Vec3d(0.3, 0, 0),
                                   .is_linked = pick(2) == 0};
        case 2:
            return SymmetricCopy{.panels = {panel}, .is_linked = pick(2) == 0, .shift = some_shift(0.5)};
        case 3:
            return UnlinkPanel{.panel = panel};
        case 4:
            return MovePanels{.panels = {panel, some_panel(pattern)}, .by = some_shift(0.3)};
        case 5:
        case 6:
            return TransformPanels{.panels = {panel}, .map = some_map(), .what = "Turn"};
        case 7:
            return PlacePanel{
                .panel = panel, .translation = Vec3d(0, between(0, 2), 0.2), .wrap_radius = between(0, 0.3)};
        case 8:
            return SetGrain{.panel = panel, .angle = between(-4, 4)};
        case 9:
            return SetPins{.panel = panel, .vertices = {pick(9), pick(9)}};
        case 10: {
            const sim::Panel* cut = find(pattern, panel);
            if (cut == nullptr || cut->vertices.empty()) return SetLayer{.panel = panel, .layer = 1};
            const Vec2d from = cut->vertices[static_cast<std::size_t>(pick(cut->vertices.size()))] + some_shift(0.1);
            return CutPanel{.panel = panel, .path = {from, from + some_shift(0.6)}, .is_sewn = pick(2) == 0};
        }
        default:
            return UnfoldPanel{.panel = panel, .edge = pick(9), .is_linked = pick(2) == 0};
    }
}

Command RandomCommands::on_outline(const sim::Pattern& pattern, int kind) {
    const PartRef edge = some_edge(pattern);
    switch (kind) {
        case 0:
            return AddVertex{.panel = edge.panel, .edge = edge.index, .t = between(0, 1)};
        case 1:
            return RemoveParts{.vertices = {some_vertex(pattern)}};
        case 2:
            return TransformVertices{.vertices = {some_vertex(pattern), some_vertex(pattern)}, .map = some_map()};
        case 3: {
            sim::OutlineEdge curve{.kind = static_cast<sim::CurveKind>(pick(4)), .arc_radius = between(0, 2)};
            const sim::Panel* panel = find(pattern, edge.panel);
            if (panel != nullptr && !panel->vertices.empty()) {
                const Vec2d start = panel->vertices[static_cast<std::size_t>(edge.index) % panel->vertices.size()];
                curve.control = {start + some_shift(0.1), start + some_shift(0.2)};
            }
            return SetCurve{.panel = edge.panel, .edge = edge.index, .curve = curve};
        }
        case 4:
            return AddDart{.panel = edge.panel,
                           .edge = edge.index,
                           .t = between(0, 1),
                           .width = between(0, 0.05),
                           .depth = between(0, 0.1)};
        case 5:
            return AddNotch{.panel = edge.panel, .edge = edge.index, .t = between(-0.1, 1.1)};
        case 6:
            return MoveNotch{.panel = edge.panel, .index = pick(3), .edge = edge.index, .t = between(0, 1)};
        case 7:
            return AddInternalLine{.panel = edge.panel, .line = {"line", {some_shift(0.2), some_shift(0.2)}}};
        case 8:
            return RemoveParts{.internal_lines = {{edge.panel, pick(3)}}, .notches = {{edge.panel, pick(2)}}};
        default:
            return MoveVertices{.vertices = {some_vertex(pattern)}, .by = some_shift(0.02)};
    }
}

Command RandomCommands::on_seams(const sim::Pattern& pattern, int kind) {
    const int seam = pick(pattern.seams.size() + (pick(20) == 0 ? 1 : 0));
    const PartRef a = some_edge(pattern), b = some_edge(pattern);
    switch (kind) {
        case 0:
        case 1:
        case 2:
            return SewEdges{.first = a, .second = b, .is_reversed = pick(2) == 0};
        case 3:
        case 4:
            return SewRuns{.first = {{a.panel, a.index, between(0, 0.4), between(0.6, 1)}},
                           .second = {{b.panel, b.index, 0, between(0.5, 1)}},
                           .is_reversed = pick(2) == 0};
        case 5:
            return ReverseSeam{.seam = seam};
        case 6:
            return NameSeam{.seam = seam, .to = pick(3) == 0 ? "" : "seam_" + std::to_string(pick(30))};
        case 7:
            return AcceptEase{.seam = seam, .is_eased = pick(2) == 0};
        case 8:
            return EvenSeam{.seam = seam};
        case 10:
            return SlideSewing{.seam = seam, .is_second = pick(2) == 0, .by = between(-0.1, 0.1)};
        case 9:
            return MergePanels{.seam = seam};
        default:
            return RemoveParts{.seams = {seam}};
    }
}

}  // namespace selvedge::editor
