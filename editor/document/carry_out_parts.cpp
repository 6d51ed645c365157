#include "editor/document/carry_out_parts.h"

#include <algorithm>
#include <map>

#include "editor/drafting/draft_error.h"
#include "editor/drafting/outline_edit.h"
#include "editor/drafting/panel_edit.h"
#include "editor/drafting/seam_edit.h"
#include "editor/drafting/sheet_layout.h"
#include "sim/pattern/seam_name.h"

namespace selvedge {
namespace {

constexpr std::size_t kFewestPoints = 2;  // of an internal line

Panel& panel_of(Pattern& pattern, const std::string& name) {
    return pattern.panels[static_cast<std::size_t>(find_panel(pattern, name))];
}

void check_edge(const Panel& panel, int edge) {
    if (edge >= 0 && static_cast<std::size_t>(edge) < panel.edges.size()) return;
    throw DraftError("'" + panel.name + "' has no edge " + std::to_string(edge), {{.panel = panel.name}});
}

// Indices by panel, in the order of their names.
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
        throw DraftError("'" + panel + "' has no such " + what, {{.panel = panel}});
    }
    for (auto index = indices.rbegin(); index != indices.rend(); ++index) items.erase(items.begin() + *index);
}

Outcome select_seams(const std::vector<int>& seams) {
    Outcome outcome{.selection = Selection{}};
    outcome.selection->seams.insert(seams.begin(), seams.end());
    return outcome;
}

void check_internal_line(const InternalLine& line, const std::string& panel) {
    if (line.points.size() >= kFewestPoints) return;
    throw DraftError("An internal line has two points at least", {{.panel = panel}});
}

void check_fraction(double t) {
    if (!(t >= 0 && t <= 1)) throw DraftError("A place along an edge is between its ends");
}

std::vector<EdgeSpan> spans_of(const Pattern& pattern, const std::vector<SpanRef>& refs) {
    std::vector<EdgeSpan> spans;
    for (const SpanRef& ref : refs) {
        const SeamSide side = edge_of(pattern, {ref.panel, ref.edge});
        spans.push_back({.panel = side.panel, .edge = side.edge, .from = ref.from, .to = ref.to});
    }
    return spans;
}

}  // namespace

const Seam& known_seam(const Pattern& pattern, int seam) {
    if (seam < 0 || static_cast<std::size_t>(seam) >= pattern.seams.size()) throw DraftError("There is no such seam");
    return pattern.seams[static_cast<std::size_t>(seam)];
}

SeamSide edge_of(const Pattern& pattern, const PartRef& edge) {
    const int panel = find_panel(pattern, edge.panel);
    check_edge(pattern.panels[static_cast<std::size_t>(panel)], edge.index);
    return {.panel = panel, .edge = edge.index};
}

void check_vertex(const Panel& panel, int vertex) {
    if (vertex >= 0 && static_cast<std::size_t>(vertex) < panel.vertices.size()) return;
    throw DraftError("'" + panel.name + "' has no point " + std::to_string(vertex), {{.panel = panel.name}});
}

Eigen::Affine2d map_in_panel(const Pattern& pattern, int panel, const PlaneMap& map) {
    const Vec2d origin = sheet_positions(pattern)[static_cast<std::size_t>(panel)];
    Eigen::Affine2d affine = Eigen::Affine2d::Identity();
    affine.linear().col(0) = map.x_axis;
    affine.linear().col(1) = map.y_axis;
    affine.translation() = affine.linear() * origin + map.shift - origin;
    return affine;
}

// Seams first, whose indices the rest would shift; panels last.
Outcome run(Pattern& pattern, const RemoveParts& command) {
    for (const int seam : command.seams) known_seam(pattern, seam);
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
    std::vector<int> panels;
    for (const std::string& name : command.panels) panels.push_back(find_panel(pattern, name));
    remove_panels(pattern, panels);
    return {.selection = Selection{}};
}

Outcome run(Pattern& pattern, const MoveVertices& command) {
    for (const auto& [name, indices] : by_panel(command.vertices)) {
        move_vertices(pattern, find_panel(pattern, name), indices, command.by);
    }
    return {};
}

Outcome run(Pattern& pattern, const TransformVertices& command) {
    for (const auto& [name, indices] : by_panel(command.vertices)) {
        const int panel = find_panel(pattern, name);
        transform_vertices(pattern, panel, indices, map_in_panel(pattern, panel, command.map));
    }
    return {};
}

Outcome run(Pattern& pattern, const SetCurve& command) {
    set_curve(pattern, edge_of(pattern, {command.panel, command.edge}), command.curve);
    return {};
}

Outcome run(Pattern& pattern, const AddVertex& command) {
    Outcome outcome{.selection = Selection{}};
    const int vertex = split_edge(pattern, edge_of(pattern, {command.panel, command.edge}), command.t);
    outcome.selection->vertices.insert({command.panel, vertex});
    return outcome;
}

Outcome run(Pattern& pattern, const AddDart& command) {
    insert_dart(pattern, edge_of(pattern, {command.panel, command.edge}), command.t, command.width, command.depth);
    return {};
}

Outcome run(Pattern& pattern, const AddInternalLine& command) {
    check_internal_line(command.line, command.panel);
    std::vector<InternalLine>& lines = panel_of(pattern, command.panel).internal_lines;
    lines.push_back(command.line);
    Outcome outcome{.selection = Selection{}};
    outcome.selection->internal_lines.insert({command.panel, static_cast<int>(lines.size()) - 1});
    return outcome;
}

Outcome run(Pattern& pattern, const SetInternalLine& command) {
    check_internal_line(command.line, command.panel);
    std::vector<InternalLine>& lines = panel_of(pattern, command.panel).internal_lines;
    if (command.index < 0 || static_cast<std::size_t>(command.index) >= lines.size()) {
        throw DraftError("'" + command.panel + "' has no such internal line", {{.panel = command.panel}});
    }
    lines[static_cast<std::size_t>(command.index)] = command.line;
    return {};
}

Outcome run(Pattern& pattern, const AddNotch& command) {
    edge_of(pattern, {command.panel, command.edge});
    check_fraction(command.t);
    std::vector<Notch>& notches = panel_of(pattern, command.panel).notches;
    notches.push_back({.edge = command.edge, .t = command.t});
    Outcome outcome{.selection = Selection{}};
    outcome.selection->notches.insert({command.panel, static_cast<int>(notches.size()) - 1});
    return outcome;
}

Outcome run(Pattern& pattern, const MoveNotch& command) {
    edge_of(pattern, {command.panel, command.edge});
    check_fraction(command.t);
    std::vector<Notch>& notches = panel_of(pattern, command.panel).notches;
    if (command.index < 0 || static_cast<std::size_t>(command.index) >= notches.size()) {
        throw DraftError("'" + command.panel + "' has no such notch", {{.panel = command.panel}});
    }
    notches[static_cast<std::size_t>(command.index)] = {.edge = command.edge, .t = command.t};
    return {};
}

Outcome run(Pattern& pattern, const SewEdges& command) {
    return select_seams({sew_edges(pattern, {.first = edge_of(pattern, command.first),
                                             .second = edge_of(pattern, command.second),
                                             .is_reversed = command.is_reversed})});
}

Outcome run(Pattern& pattern, const SewRuns& command) {
    return select_seams(
        sew_runs(pattern, spans_of(pattern, command.first), spans_of(pattern, command.second), command.is_reversed));
}

Outcome run(Pattern& pattern, const ReverseSeam& command) {
    known_seam(pattern, command.seam);
    bool& is_reversed = pattern.seams[static_cast<std::size_t>(command.seam)].is_reversed;
    is_reversed = !is_reversed;
    return {};
}

Outcome run(Pattern& pattern, const NameSeam& command) {
    known_seam(pattern, command.seam);
    if (command.to.find_first_of(",+") != std::string::npos)
        throw DraftError("A seam's name has no comma and no plus sign");
    for (const Seam& seam : pattern.seams) {
        if (!command.to.empty() && seam.name == command.to)
            throw DraftError("There is a seam '" + command.to + "' already");
    }
    pattern.seams[static_cast<std::size_t>(command.seam)].name = command.to;
    return {};
}

Outcome run(Pattern& pattern, const AcceptEase& command) {
    known_seam(pattern, command.seam);
    pattern.seams[static_cast<std::size_t>(command.seam)].is_eased = command.is_eased;
    return {};
}

Outcome run(Pattern& pattern, const EvenSeam& command) {
    known_seam(pattern, command.seam);
    even_seam(pattern, command.seam);
    return {};
}

}  // namespace selvedge
