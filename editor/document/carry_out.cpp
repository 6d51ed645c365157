#include "editor/document/carry_out.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "editor/document/carry_out_parts.h"
#include "editor/drafting/draft_error.h"
#include "editor/drafting/outline_edit.h"
#include "editor/drafting/panel_edit.h"
#include "editor/drafting/seam_edit.h"
#include "editor/drafting/sheet_layout.h"
#include "sim/core/error.h"
#include "sim/pattern/fabric.h"
#include "sim/tartan/match.h"
#include "sim/tartan/sett_repeat.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

// What others throw as wrong input is wrong to a draft, too.
template <class Function>
auto in_draft_words(Function&& function) {
    try {
        return function();
    } catch (const InputError& error) {
        throw DraftError(error.problem());
    }
}

Sett sett_of(const Pattern& pattern) {
    const Sett sett = find_tartan(pattern.tartan.empty() ? kDefaultTartan : pattern.tartan);
    return pattern.sett_size ? with_repeat_size(sett, *pattern.sett_size) : sett;
}

Panel& panel_of(Pattern& pattern, const std::string& name) {
    return pattern.panels[static_cast<std::size_t>(find_panel(pattern, name))];
}

Selection only(const std::string& panel) {
    Selection selection;
    selection.panels.insert(panel);
    return selection;
}

// --- of the pattern

Outcome run(Pattern& pattern, const RenamePattern& command) {
    pattern.name = command.to;
    return {};
}

Outcome run(Pattern& pattern, const SetFabric& command) {
    if (!command.fabric.empty() && !command.fabric.ends_with(".json")) {
        in_draft_words([&] { return find_fabric(command.fabric); });
    }
    (command.panel.empty() ? pattern.fabric : panel_of(pattern, command.panel).fabric) = command.fabric;
    return {};
}

Outcome run(Pattern& pattern, const SetTartan& command) {
    if (!command.tartan.empty()) in_draft_words([&] { return find_tartan(command.tartan); });
    if (command.size && !(*command.size >= kSmallestSett && *command.size <= kLargestSett)) {
        throw DraftError("A repeat of a tartan is from 0.1 to 500 cm");
    }
    pattern.tartan = command.tartan;
    pattern.sett_size = command.size;
    pattern.sett_position = command.position;
    return {};
}

Outcome run(Pattern& pattern, const SetBody& command) {
    if (!command.shifts.empty() && command.shifts.size() != pattern.panels.size()) {
        throw DraftError("A body's shifts are one for each panel");
    }
    pattern.body = command.body;
    for (std::size_t i = 0; i < command.shifts.size(); ++i) pattern.panels[i].translation += command.shifts[i];
    return {};
}

Outcome run(Pattern& pattern, const SetEdgeLength& command) {
    constexpr double kShortest = 0.005, kLongest = 0.5;  // m, as in files
    if (command.length && !(*command.length >= kShortest && *command.length <= kLongest)) {
        throw DraftError("A mesh has edges of 0.5 to 50 cm");
    }
    pattern.edge_length = command.length;
    return {};
}

Outcome run(Pattern& pattern, const MatchSetts& command) {
    const Sett sett = in_draft_words([&] { return sett_of(pattern); });
    for (const int seam : command.first_seams) known_seam(pattern, seam);
    const SettMatch match = match_sett(pattern, sett, {.first_seams = command.first_seams});
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) pattern.panels[i].sett_offset = match.offsets[i];
    pattern.matched_sett = MatchedSett{.tartan = pattern.tartan.empty() ? kDefaultTartan : pattern.tartan,
                                       .repeat = Vec2d(repeat_size(sett), weft_repeat_size(sett))};
    return {};
}

Outcome run(Pattern& pattern, const TranslateAll& command) {
    for (Panel& panel : pattern.panels) panel.translation += command.by;
    return {};
}

// --- of whole panels

Outcome run(Pattern& pattern, const AddPanels& command) {
    Outcome outcome{.selection = Selection{}};
    for (const Panel& panel : command.panels) {
        const int index = add_panel(pattern, panel);
        outcome.selection->panels.insert(pattern.panels[static_cast<std::size_t>(index)].name);
    }
    return outcome;
}

Outcome run(Pattern& pattern, const RenamePanel& command) {
    const int panel = find_panel(pattern, command.panel);
    if (command.to == command.panel) return {};
    rename_panel(pattern, panel, command.to);
    return {.selection = only(command.to), .rename = PanelRename{.from = command.panel, .to = command.to}};
}

Outcome select_new(const Pattern& pattern, int panel) {
    return {.selection = only(pattern.panels[static_cast<std::size_t>(panel)].name)};
}

Outcome run(Pattern& pattern, const DuplicatePanel& command) {
    return select_new(pattern, duplicate_panel(pattern, find_panel(pattern, command.panel), command.shift));
}

Outcome run(Pattern& pattern, const SymmetricCopy& command) {
    const int panel = find_panel(pattern, command.panel);
    return select_new(pattern, symmetric_copy(pattern, panel, command.is_linked, command.shift));
}

Outcome run(Pattern& pattern, const UnlinkPanel& command) {
    panel_of(pattern, command.panel).mirror_of.clear();
    for (Panel& other : pattern.panels) {
        if (other.mirror_of == command.panel) other.mirror_of.clear();
    }
    return {};
}

// All panels are laid out before one is put somewhere: the others stay where they are seen.
Outcome run(Pattern& pattern, const MovePanels& command) {
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    for (std::size_t i = 0; i < positions.size(); ++i) pattern.panels[i].sheet_position = positions[i];
    for (const std::string& name : command.panels) *panel_of(pattern, name).sheet_position += command.by;
    return {};
}

Outcome run(Pattern& pattern, const TransformPanels& command) {
    for (const std::string& name : command.panels) {
        const int panel = find_panel(pattern, name);
        transform_panel(pattern, panel, map_in_panel(pattern, panel, command.map));
    }
    return {};
}

Outcome run(Pattern& pattern, const PlacePanel& command) {
    constexpr double kNearly = 1e-6;
    const Eigen::Matrix3d& r = command.rotation;
    const bool is_rotation = (r * r.transpose()).isIdentity(kNearly) && r.determinant() > 0;
    if (!is_rotation) throw DraftError("A panel is placed by a rotation", {{.panel = command.panel}});
    if (!(command.wrap_radius >= 0)) throw DraftError("A panel is bent by a radius", {{.panel = command.panel}});
    Panel& panel = panel_of(pattern, command.panel);
    panel.translation = command.translation;
    panel.rotation = command.rotation;
    panel.wrap_radius = command.wrap_radius;
    return {};
}

Outcome run(Pattern& pattern, const PlacePanels& command) {
    for (const PanelPlace& place : command.places) {
        run(pattern, PlacePanel{.panel = place.panel,
                                .translation = place.translation,
                                .rotation = place.rotation,
                                .wrap_radius = place.wrap_radius});
    }
    return {};
}

Outcome run(Pattern& pattern, const SetGrain& command) {
    panel_of(pattern, command.panel).grain_angle = std::remainder(command.angle, 2 * std::numbers::pi);
    return {};
}

Outcome run(Pattern& pattern, const SetSettOffset& command) {
    panel_of(pattern, command.panel).sett_offset = command.offset;
    return {};
}

Outcome run(Pattern& pattern, const SetPins& command) {
    Panel& panel = panel_of(pattern, command.panel);
    for (const int vertex : command.vertices) check_vertex(panel, vertex);
    panel.pins = command.vertices;
    std::sort(panel.pins.begin(), panel.pins.end());
    panel.pins.erase(std::unique(panel.pins.begin(), panel.pins.end()), panel.pins.end());
    return {};
}

Outcome run(Pattern& pattern, const SetLayer& command) {
    panel_of(pattern, command.panel).layer = command.layer;
    return {};
}

Outcome run(Pattern& pattern, const CutPanel& command) {
    const int panel = find_panel(pattern, command.panel);
    Outcome outcome = select_new(pattern, cut_panel(pattern, panel, command.path, command.is_sewn));
    outcome.selection->panels.insert(command.panel);
    return outcome;
}

Outcome run(Pattern& pattern, const MergePanels& command) {
    known_seam(pattern, command.seam);
    return select_new(pattern, merge_panels(pattern, command.seam));
}

Outcome run(Pattern& pattern, const UnfoldPanel& command) {
    unfold_panel(pattern, edge_of(pattern, {command.panel, command.edge}));
    return {.selection = only(command.panel)};
}

}  // namespace

Outcome carry_out(Pattern& pattern, const Command& command) {
    return std::visit([&](const auto& given) { return run(pattern, given); }, command);
}

}  // namespace selvedge
