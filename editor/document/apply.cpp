#include "editor/document/apply.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <type_traits>

#include "editor/document/set_fields.h"
#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/core/error.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_fields.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/sources.h"
#include "sim/tartan/match.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::editor {
namespace {

// Converts an InputError of the simulation modules to a GeometryError.
template <class Function>
auto as_geometry_error(Function&& function) {
    try {
        return function();
    } catch (const sim::InputError& error) {
        throw GeometryError(error.problem());
    }
}

sim::Panel& panel_of(sim::Pattern& pattern, const std::string& name) {
    return pattern.panels[static_cast<std::size_t>(find_panel(pattern, name))];
}

// Checks of and access to parts. Each throws GeometryError if there is no such part.

void check_seam(const sim::Pattern& pattern, int seam) {
    if (seam >= 0 && static_cast<std::size_t>(seam) < pattern.seams.size()) return;
    throw GeometryError("There is no such seam");
}

void check_edge(const sim::Panel& panel, int edge) {
    if (edge >= 0 && static_cast<std::size_t>(edge) < panel.edges.size()) return;
    throw GeometryError("'" + panel.name + "' has no edge " + std::to_string(edge), {{.panel = panel.name}});
}

sim::SeamSide edge_of(const sim::Pattern& pattern, const PartRef& edge) {
    const int panel = find_panel(pattern, edge.panel);
    check_edge(pattern.panels[static_cast<std::size_t>(panel)], edge.index);
    return {.panel = panel, .edge = edge.index};
}

void check_vertex(const sim::Panel& panel, int vertex) {
    if (vertex >= 0 && static_cast<std::size_t>(vertex) < panel.vertices.size()) return;
    throw GeometryError("'" + panel.name + "' has no point " + std::to_string(vertex), {{.panel = panel.name}});
}

// Converts a map in sheet coordinates to the panel's own coordinates.
Eigen::Affine2d map_in_panel(const sim::Pattern& pattern, int panel, const PlaneMap& map) {
    const Vec2d origin = sheet_positions(pattern)[static_cast<std::size_t>(panel)];
    Eigen::Affine2d affine = Eigen::Affine2d::Identity();
    affine.linear().col(0) = map.x_axis;
    affine.linear().col(1) = map.y_axis;
    affine.translation() = affine.linear() * origin + map.shift - origin;
    return affine;
}

Selection only(const std::string& panel) {
    Selection selection;
    selection.panels.insert(panel);
    return selection;
}

// --- commands on the pattern

Outcome run(sim::Pattern& pattern, const PutOver& command) {
    const std::size_t before = pattern.panels.size();
    Outcome outcome{.selection = Selection{}};
    as_geometry_error([&] {
        sim::PatternDocument outer = sim::parse_pattern(command.text, command.file);
        outcome.notes = take_up(outer);
        put_over(pattern, std::move(outer.pattern));
    });
    for (std::size_t p = before; p < pattern.panels.size(); ++p)
        outcome.selection->panels.insert(pattern.panels[p].name);
    return outcome;
}

Outcome run(sim::Pattern& pattern, const TakeOff& command) {
    if (!take_off(pattern, command.garment)) throw GeometryError("There is no garment '" + command.garment + "'");
    return {};
}

Outcome run(sim::Pattern& pattern, const RenamePattern& command) {
    pattern.name = command.to;
    return {};
}

// A file is read when the garment is dressed.
void check_fabric_name(const std::string& fabric) {
    if (fabric.empty() || sim::is_fabric_file(fabric)) return;
    as_geometry_error([&] { return sim::find_fabric(fabric); });
}

Outcome run(sim::Pattern& pattern, const SetFabric& command) {
    check_fabric_name(command.fabric);
    (command.panel.empty() ? pattern.fabric : panel_of(pattern, command.panel).fabric) = command.fabric;
    return {};
}

Outcome run(sim::Pattern& pattern, const ReplaceFabric& command) {
    if (command.from.empty() || command.to.empty()) throw GeometryError("A fabric to replace has a name");
    check_fabric_name(command.to);
    if (pattern.fabric.empty() && command.from == sim::Fabric().name) pattern.fabric = command.to;
    visit_values(pattern, [&]<class T>(const auto& field, T& value) {
        if constexpr (std::is_same_v<T, std::string>) {
            if (field.measure == sim::Measure::Fabric && value == command.from) value = command.to;
        }
    });
    return {};
}

Outcome run(sim::Pattern& pattern, const SetTartan& command) {
    if (!command.tartan.empty()) as_geometry_error([&] { return sim::find_tartan(command.tartan); });
    if (command.size && !(*command.size >= sim::kSmallestSett && *command.size <= sim::kLargestSett)) {
        throw GeometryError("A repeat of a tartan is from 0.1 to 500 cm");
    }
    pattern.tartan = command.tartan;
    pattern.surface.reset();  // which would hide it
    pattern.sett_size = command.size;
    pattern.sett_position = command.position;
    return {};
}

Outcome run(sim::Pattern& pattern, const SetUnderlays& command) {
    if (command.underlays.size() > sim::kMostUnderlays) {
        throw GeometryError("At most " + std::to_string(sim::kMostUnderlays) + " photos can lie under the sheet");
    }
    for (const sim::Underlay& underlay : command.underlays) {
        if (!(underlay.pixel_size >= sim::kSmallestPixel && underlay.pixel_size <= sim::kLargestPixel))
            throw GeometryError("A pixel of a photo is from 0.001 mm to 1 m wide");
        if (!(underlay.opacity >= 0 && underlay.opacity <= 1)) throw GeometryError("An opacity is from 0 to 1");
    }
    pattern.underlays = command.underlays;
    return {};
}

void check_design(const sim::SurfaceDesign& design) {
    if (design.size && !(*design.size >= sim::kSmallestDesign && *design.size <= sim::kLargestDesign))
        throw GeometryError("A repeat is from 0.1 to 500 cm");
    if (design.kind == sim::DesignKind::Colour && !sim::is_colour_text(design.source))
        throw GeometryError("'" + design.source + "' is no colour: #RRGGBB is");
    if (!design.ground.empty() && !sim::is_colour_text(design.ground))
        throw GeometryError("'" + design.ground + "' is no colour: #RRGGBB is");
    if (design.kind == sim::DesignKind::Picture && design.source.empty()) throw GeometryError("Choose a picture first");
    if (design.kind == sim::DesignKind::Tartan && !design.source.empty())
        as_geometry_error([&] { return sim::find_tartan(design.source); });
}

Outcome run(sim::Pattern& pattern, const SetAllowance& command) {
    if (command.width && !(*command.width >= 0 && *command.width <= sim::kWidestAllowance))
        throw GeometryError("A seam allowance is from 0 to 50 cm");
    if (command.panel.empty()) {
        pattern.allowance = command.width.value_or(0);
        return {};
    }
    sim::Panel& panel = panel_of(pattern, command.panel);
    if (!command.edge) {
        panel.allowance = command.width;
        return {};
    }
    edge_of(pattern, {command.panel, *command.edge});  // throws if there is none
    sim::OutlineEdge& edge = panel.edges[static_cast<std::size_t>(*command.edge)];
    edge.allowance = command.width;
    edge.allowance_corner = command.corner;
    return {};
}

Outcome run(sim::Pattern& pattern, const SetSurface& command) {
    if (command.surface) check_design(*command.surface);
    (command.panel.empty() ? pattern.surface : panel_of(pattern, command.panel).surface) = command.surface;
    return {};
}

Outcome run(sim::Pattern& pattern, const SetBody& command) {
    if (!command.shifts.empty() && command.shifts.size() != pattern.panels.size()) {
        throw GeometryError("A body's shifts are one for each panel");
    }
    pattern.body = command.body;
    for (std::size_t i = 0; i < command.shifts.size(); ++i) pattern.panels[i].translation += command.shifts[i];
    return {};
}

Outcome run(sim::Pattern& pattern, const SetEdgeLength& command) {
    if (command.length && !(*command.length >= sim::kShortestMeshEdge && *command.length <= sim::kLongestMeshEdge))
        throw GeometryError(std::string("A mesh has edges of ") + sim::kMeshEdgesText);
    pattern.edge_length = command.length;
    return {};
}

Outcome run(sim::Pattern& pattern, const MatchSetts& command) {
    if (pattern.tartan.empty()) throw GeometryError("The garment names no tartan to match");
    const sim::Sett sett = as_geometry_error([&] { return sett_of(pattern); });
    for (const int seam : command.first_seams) check_seam(pattern, seam);
    const sim::SettMatch match = match_sett(pattern, sett, {.first_seams = command.first_seams});
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) pattern.panels[i].sett_offset = match.offsets[i];
    pattern.matched_sett =
        sim::MatchedSett{.tartan = pattern.tartan, .repeat = Vec2d(repeat_size(sett), weft_repeat_size(sett))};
    return {};
}

Outcome run(sim::Pattern& pattern, const TranslateAll& command) {
    for (sim::Panel& panel : pattern.panels) panel.translation += command.by;
    return {};
}

// --- commands on whole panels

Outcome select_new(const sim::Pattern& pattern, const std::vector<int>& panels) {
    Outcome outcome{.selection = Selection{}};
    for (const int panel : panels)
        outcome.selection->panels.insert(pattern.panels[static_cast<std::size_t>(panel)].name);
    return outcome;
}

Outcome select_new(const sim::Pattern& pattern, int panel) {
    return select_new(pattern, std::vector<int>{panel});
}

std::vector<int> find_panels(const sim::Pattern& pattern, const std::vector<std::string>& names) {
    std::vector<int> panels;
    for (const std::string& name : names) panels.push_back(find_panel(pattern, name));
    return panels;
}

Outcome run(sim::Pattern& pattern, const AddPanels& command) {
    return select_new(pattern, add_panels(pattern, command.panels, command.seams));
}

Outcome run(sim::Pattern& pattern, const RenamePanel& command) {
    const int panel = find_panel(pattern, command.panel);
    if (command.to == command.panel) return {};
    rename_panel(pattern, panel, command.to);
    return {.selection = only(command.to), .rename = PanelRename{.from = command.panel, .to = command.to}};
}

Outcome run(sim::Pattern& pattern, const DuplicatePanels& command) {
    return select_new(pattern, duplicate_panels(pattern, find_panels(pattern, command.panels),
                                                {.on_sheet = command.shift, .in_world = command.move},
                                                command.is_linked ? CopyLink::Linked : CopyLink::None));
}

Outcome run(sim::Pattern& pattern, const SymmetricCopy& command) {
    return select_new(
        pattern, symmetric_copies(pattern, find_panels(pattern, command.panels), command.is_linked, command.shift));
}

Outcome run(sim::Pattern& pattern, const UnlinkPanel& command) {
    unlink(pattern, find_panel(pattern, command.panel));
    return {};
}

// Fixes the sheet position of all panels first, so that the automatic layout does not move the others.
Outcome run(sim::Pattern& pattern, const MovePanels& command) {
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    for (std::size_t i = 0; i < positions.size(); ++i) pattern.panels[i].sheet_position = positions[i];
    for (const std::string& name : command.panels) *panel_of(pattern, name).sheet_position += command.by;
    return {};
}

Outcome run(sim::Pattern& pattern, const TransformPanels& command) {
    for (const std::string& name : command.panels) {
        const int panel = find_panel(pattern, name);
        transform_panel(pattern, panel, map_in_panel(pattern, panel, command.map));
    }
    return {};
}

Outcome run(sim::Pattern& pattern, const PlacePanel& command) {
    constexpr double kNearly = 1e-6;
    const Eigen::Matrix3d& r = command.rotation;
    const bool is_rotation = (r * r.transpose()).isIdentity(kNearly) && r.determinant() > 0;
    if (!is_rotation) throw GeometryError("The placement must be a rotation", {{.panel = command.panel}});
    if (!(command.wrap_radius >= 0))
        throw GeometryError("The wrap radius must be 0 or more", {{.panel = command.panel}});
    sim::Panel& panel = panel_of(pattern, command.panel);
    panel.translation = command.translation;
    panel.rotation = command.rotation;
    panel.wrap_radius = command.wrap_radius;
    if (command.wrap_radius > 0) panel.wrap_cone.reset();
    return {};
}

Outcome run(sim::Pattern& pattern, const PlacePanels& command) {
    for (const PanelPlacement& place : command.places) {
        run(pattern, PlacePanel{.panel = place.panel,
                                .translation = place.translation,
                                .rotation = place.rotation,
                                .wrap_radius = place.wrap_radius});
    }
    return {};
}

Outcome run(sim::Pattern& pattern, const SetGrain& command) {
    panel_of(pattern, command.panel).grain_angle = std::remainder(command.angle, 2 * std::numbers::pi);
    return {};
}

Outcome run(sim::Pattern& pattern, const SetSettOffset& command) {
    panel_of(pattern, command.panel).sett_offset = command.offset;
    return {};
}

Outcome run(sim::Pattern& pattern, const SetPins& command) {
    sim::Panel& panel = panel_of(pattern, command.panel);
    for (const int vertex : command.vertices) check_vertex(panel, vertex);
    panel.pins = command.vertices;
    std::sort(panel.pins.begin(), panel.pins.end());
    panel.pins.erase(std::unique(panel.pins.begin(), panel.pins.end()), panel.pins.end());
    return {};
}

Outcome run(sim::Pattern& pattern, const SetLayer& command) {
    panel_of(pattern, command.panel).layer = command.layer;
    return {};
}

Outcome run(sim::Pattern& pattern, const CutPanel& command) {
    const int panel = find_panel(pattern, command.panel);
    Outcome outcome = select_new(pattern, cut_panel(pattern, panel, command.path, command.is_sewn));
    outcome.selection->panels.insert(command.panel);
    return outcome;
}

Outcome run(sim::Pattern& pattern, const MergePanels& command) {
    check_seam(pattern, command.seam);
    std::optional<int> stays;
    if (!command.stays.empty()) stays = find_panel(pattern, command.stays);
    Merged merged = merge_panels(pattern, command.seam, stays);
    Outcome outcome = select_new(pattern, merged.panel);
    outcome.notes = std::move(merged.notes);
    return outcome;
}

Outcome run(sim::Pattern& pattern, const UnfoldPanel& command) {
    unfold_panel(pattern, edge_of(pattern, {command.panel, command.edge}),
                 command.is_linked ? CopyLink::Linked : CopyLink::None);
    return {.selection = only(command.panel)};
}

// --- commands on parts of panels and on seams

constexpr std::size_t kMinPoints = 2;  // minimum for an internal line

// Groups part indices by panel, in the order of the panels' names.
std::map<std::string, std::vector<int>> by_panel(const std::vector<PartRef>& parts) {
    std::map<std::string, std::vector<int>> sorted;
    for (const PartRef& part : parts) sorted[part.panel].push_back(part.index);
    return sorted;
}

template <class T>
void erase_at(std::vector<T>& items, std::vector<int> indices, const std::string& panel, const char* what) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    if (!indices.empty() && (indices.front() < 0 || static_cast<std::size_t>(indices.back()) >= items.size())) {
        throw GeometryError("'" + panel + "' has no such " + what, {{.panel = panel}});
    }
    for (auto index = indices.rbegin(); index != indices.rend(); ++index) items.erase(items.begin() + *index);
}

Outcome select_seams(const std::vector<int>& seams) {
    Outcome outcome{.selection = Selection{}};
    outcome.selection->seams.insert(seams.begin(), seams.end());
    return outcome;
}

void check_internal_line(const sim::InternalLine& line, const std::string& panel) {
    if (line.points.size() >= kMinPoints) return;
    throw GeometryError("An internal line has two points at least", {{.panel = panel}});
}

void check_fraction(double t) {
    if (!(t >= 0 && t <= 1)) throw GeometryError("The position must be between 0 and 1");
}

std::vector<EdgeSpan> spans_of(const sim::Pattern& pattern, const std::vector<SpanRef>& refs) {
    std::vector<EdgeSpan> spans;
    for (const SpanRef& ref : refs) {
        const sim::SeamSide side = edge_of(pattern, {ref.panel, ref.edge});
        spans.push_back({.panel = side.panel, .edge = side.edge, .from = ref.from, .to = ref.to});
    }
    return spans;
}

// Seams first, because the other removals change their indices; panels last.
Outcome run(sim::Pattern& pattern, const RemoveParts& command) {
    for (const int seam : command.seams) check_seam(pattern, seam);
    remove_seams(pattern, command.seams);
    for (const auto& [name, indices] : by_panel(command.internal_lines)) {
        erase_at(panel_of(pattern, name).internal_lines, indices, name, "internal line");
    }
    for (const auto& [name, indices] : by_panel(command.notches)) {
        erase_at(panel_of(pattern, name).notches, indices, name, "notch");
    }
    for (const auto& [name, indices] : by_panel(command.vertices)) {
        remove_vertices(pattern, find_panel(pattern, name), indices);
    }
    remove_panels(pattern, find_panels(pattern, command.panels));
    return {.selection = Selection{}};
}

Outcome run(sim::Pattern& pattern, const MoveVertices& command) {
    for (const auto& [name, indices] : by_panel(command.vertices)) {
        move_vertices(pattern, find_panel(pattern, name), indices, command.by);
    }
    return {};
}

Outcome run(sim::Pattern& pattern, const TransformVertices& command) {
    for (const auto& [name, indices] : by_panel(command.vertices)) {
        const int panel = find_panel(pattern, name);
        transform_vertices(pattern, panel, indices, map_in_panel(pattern, panel, command.map));
    }
    return {};
}

Outcome run(sim::Pattern& pattern, const SetCurve& command) {
    set_curve(pattern, edge_of(pattern, {command.panel, command.edge}), command.curve);
    return {};
}

Outcome run(sim::Pattern& pattern, const AddVertex& command) {
    Outcome outcome{.selection = Selection{}};
    const int vertex = split_edge(pattern, edge_of(pattern, {command.panel, command.edge}), command.t);
    outcome.selection->vertices.insert({command.panel, vertex});
    return outcome;
}

Outcome run(sim::Pattern& pattern, const AddDart& command) {
    insert_dart(pattern, edge_of(pattern, {command.panel, command.edge}), command.t, command.width, command.depth);
    return {};
}

Outcome run(sim::Pattern& pattern, const AddInternalLine& command) {
    check_internal_line(command.line, command.panel);
    std::vector<sim::InternalLine>& lines = panel_of(pattern, command.panel).internal_lines;
    lines.push_back(command.line);
    Outcome outcome{.selection = Selection{}};
    outcome.selection->internal_lines.insert({command.panel, static_cast<int>(lines.size()) - 1});
    return outcome;
}

Outcome run(sim::Pattern& pattern, const SetInternalLine& command) {
    check_internal_line(command.line, command.panel);
    std::vector<sim::InternalLine>& lines = panel_of(pattern, command.panel).internal_lines;
    if (command.index < 0 || static_cast<std::size_t>(command.index) >= lines.size()) {
        throw GeometryError("'" + command.panel + "' has no such internal line", {{.panel = command.panel}});
    }
    lines[static_cast<std::size_t>(command.index)] = command.line;
    return {};
}

Outcome run(sim::Pattern& pattern, const AddNotch& command) {
    edge_of(pattern, {command.panel, command.edge});
    check_fraction(command.t);
    std::vector<sim::Notch>& notches = panel_of(pattern, command.panel).notches;
    notches.push_back({.edge = command.edge, .t = command.t});
    Outcome outcome{.selection = Selection{}};
    outcome.selection->notches.insert({command.panel, static_cast<int>(notches.size()) - 1});
    return outcome;
}

Outcome run(sim::Pattern& pattern, const MoveNotch& command) {
    edge_of(pattern, {command.panel, command.edge});
    check_fraction(command.t);
    std::vector<sim::Notch>& notches = panel_of(pattern, command.panel).notches;
    if (command.index < 0 || static_cast<std::size_t>(command.index) >= notches.size()) {
        throw GeometryError("'" + command.panel + "' has no such notch", {{.panel = command.panel}});
    }
    sim::Notch& notch = notches[static_cast<std::size_t>(command.index)];
    notch.edge = command.edge;
    notch.t = command.t;
    return {};
}

Outcome run(sim::Pattern& pattern, const SewEdges& command) {
    return select_seams({sew_edges(pattern, {.first = edge_of(pattern, command.first),
                                             .second = edge_of(pattern, command.second),
                                             .is_reversed = command.is_reversed})});
}

Outcome run(sim::Pattern& pattern, const SewRuns& command) {
    return select_seams(
        sew_runs(pattern, spans_of(pattern, command.first), spans_of(pattern, command.second), command.is_reversed));
}

Outcome run(sim::Pattern& pattern, const ReverseSeam& command) {
    check_seam(pattern, command.seam);
    const bool is_one = sewing_of(pattern, command.seam).size() == 1;
    const std::vector<int> seams = reverse_sewing(pattern, command.seam);
    return is_one ? Outcome{} : select_seams(seams);
}

// A sewing of several seams has the name; each of its seams may have one of its own in the file.
Outcome run(sim::Pattern& pattern, const NameSeam& command) {
    check_seam(pattern, command.seam);
    if (command.to.find_first_of(",+") != std::string::npos)
        throw GeometryError("A seam's name has no comma and no plus sign");
    for (const sim::Seam& seam : pattern.seams) {
        if (!command.to.empty() && (seam.name == command.to || seam.sewing == command.to))
            throw GeometryError("There is a seam '" + command.to + "' already");
    }
    const std::vector<int> seams = sewing_of(pattern, command.seam);
    if (seams.size() == 1) {
        pattern.seams[static_cast<std::size_t>(command.seam)].name = command.to;
        return {};
    }
    const std::string name = command.to.empty() ? free_sewing_name(pattern) : command.to;
    for (const int seam : seams) pattern.seams[static_cast<std::size_t>(seam)].sewing = name;
    return {};
}

Outcome run(sim::Pattern& pattern, const AcceptEase& command) {
    check_seam(pattern, command.seam);
    for (const int seam : sewing_of(pattern, command.seam)) {
        pattern.seams[static_cast<std::size_t>(seam)].is_eased = command.is_eased;
    }
    return {};
}

Outcome run(sim::Pattern& pattern, const SlideSewing& command) {
    check_seam(pattern, command.seam);
    slide_sewing(pattern, command.seam, command.is_second ? SewingRun::Second : SewingRun::First, command.by);
    return {};
}

Outcome run(sim::Pattern& pattern, const SetFields& command) {
    set_fields(pattern, command);
    return {};
}

Outcome run(sim::Pattern& pattern, const EvenSeam& command) {
    check_seam(pattern, command.seam);
    equalize_seam(pattern, command.seam);
    return {};
}

}  // namespace

Outcome apply(sim::Pattern& pattern, const Command& command) {
    return std::visit([&](const auto& given) { return run(pattern, given); }, command);
}

std::vector<std::string> take_up(sim::PatternDocument& document) {
    std::vector<std::string> ended;
    for (sim::EndedLink& link : end_broken_links(document.pattern)) ended.push_back(std::move(link.problem));
    std::vector<std::string> notes;
    for (const sim::Fault& warning : document.warnings) {
        if (std::ranges::count(ended, warning.problem) > 0) continue;  // reading warned of these too
        notes.push_back(sim::fault_line("", warning.place, warning.problem));
    }
    document.warnings.clear();
    notes.insert(notes.end(), ended.begin(), ended.end());
    return notes;
}

}  // namespace selvedge::editor
