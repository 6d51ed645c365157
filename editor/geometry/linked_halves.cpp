#include "editor/geometry/linked_halves.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "editor/geometry/draft.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

constexpr double kSameHalf = 1e-9;  // m, points of halves that are closer to each other's images are the same

// Of a list of parts of a panel, those of each half.
template <class T>
struct PartsByHalf {
    std::vector<T> drawn;
    std::vector<T> other;
};

// The half of each part of `now`: that of the equal part of `before`, in order, or what `is_drawn` tells. Where both
// have as many, parts were at most changed, and stay in their halves.
template <class T, class IsDrawn>
PartsByHalf<T> split_by_half(const std::vector<T>& now, const std::vector<T>& before, IsDrawn is_drawn) {
    PartsByHalf<T> parts;
    std::size_t next = 0;  // part of `before`
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto same = std::find(before.begin() + static_cast<std::ptrdiff_t>(next), before.end(), now[i]);
        const auto found = static_cast<std::size_t>(same - before.begin());
        const bool is_known = now.size() == before.size() || found < before.size();
        const std::size_t at = now.size() == before.size() ? i : found;
        if (is_known) next = at + 1;
        const bool is_of_drawn = is_known ? 2 * at < before.size() : is_drawn(now[i]);
        (is_of_drawn ? parts.drawn : parts.other).push_back(now[i]);
    }
    return parts;
}

Vec2d middle_of(const Vec2d& point) {
    return point;
}
Vec2d middle_of(const sim::InternalLine& line) {
    Vec2d sum = Vec2d::Zero();
    for (const Vec2d& point : line.points) sum += point;
    return line.points.empty() ? sum : Vec2d(sum / static_cast<double>(line.points.size()));
}

// Takes the other point where both are the same but for rounding.
void snap_to(Vec2d& point, const Vec2d& other) {
    if ((point - other).cwiseAbs().maxCoeff() < kSameHalf) point = other;
}

// Gives a half the very numbers of the image of the drawn half, where it is that image.
void snap_to_image(sim::Panel& half, const sim::Panel& image) {
    for (sim::OutlineEdge& edge : half.edges) {
        const std::optional<int> found = find_edge(image, edge.key);
        if (!found) continue;
        const sim::OutlineEdge& same = image.edges[as_size(*found)];
        snap_to(half.vertices[as_size(edge.start)], image.vertices[as_size(same.start)]);
        snap_to(half.vertices[as_size(edge.end)], image.vertices[as_size(same.end)]);
        if (edge.kind != same.kind) continue;
        snap_to(edge.control[0], same.control[0]);
        snap_to(edge.control[1], same.control[1]);
        if (std::abs(edge.arc_radius - same.arc_radius) < kSameHalf) edge.arc_radius = same.arc_radius;
    }
    for (std::size_t i = 0; i < std::min(half.drill_points.size(), image.drill_points.size()); ++i)
        snap_to(half.drill_points[i], image.drill_points[i]);
    for (std::size_t i = 0; i < std::min(half.internal_lines.size(), image.internal_lines.size()); ++i) {
        std::vector<Vec2d>& points = half.internal_lines[i].points;
        const std::vector<Vec2d>& others = image.internal_lines[i].points;
        for (std::size_t p = 0; p < std::min(points.size(), others.size()); ++p) snap_to(points[p], others[p]);
    }
}

bool is_same_place(const Vec2d& one, const Vec2d& other) {
    return (one - other).cwiseAbs().maxCoeff() < kSameHalf;
}

bool has_point(const std::vector<Vec2d>& points, const Vec2d& point) {
    return std::ranges::any_of(points, [&](const Vec2d& one) { return is_same_place(one, point); });
}

bool is_same_line(sim::InternalLine one, const sim::InternalLine& other) {
    if (!std::ranges::equal(one.points, other.points, is_same_place)) return false;
    one.points = other.points;
    return one == other;
}

bool has_same_ends(const sim::Panel& one, const sim::OutlineEdge& edge, const sim::Panel& other,
                   const sim::OutlineEdge& same) {
    return is_same_place(one.vertices[as_size(edge.start)], other.vertices[as_size(same.start)]) &&
           is_same_place(one.vertices[as_size(edge.end)], other.vertices[as_size(same.end)]);
}

// Whether edges with the same ends are the same.
bool is_same_edge(sim::OutlineEdge one, const sim::OutlineEdge& other) {
    for (std::size_t i = 0; i < one.control.size(); ++i) snap_to(one.control[i], other.control[i]);
    if (std::abs(one.arc_radius - other.arc_radius) < kSameHalf) one.arc_radius = other.arc_radius;
    one.start = other.start;
    one.end = other.end;
    return one == other;
}

bool has_same_notches(const sim::Panel& one, const sim::Panel& other) {
    return std::ranges::is_permutation(
        one.notches, other.notches, [&](const sim::Notch& notch, const sim::Notch& same) {
            return notch.kind == same.kind && notch.count == same.count &&
                   is_same_place(outline_point(one, one.edges[as_size(notch.edge)], notch.t),
                                 outline_point(other, other.edges[as_size(same.edge)], same.t));
        });
}

bool has_same_pins(const sim::Panel& one, const sim::Panel& other) {
    return std::ranges::is_permutation(one.pins, other.pins, [&](int pin, int same) {
        return is_same_place(one.vertices[as_size(pin)], other.vertices[as_size(same)]);
    });
}

bool has_same_lines(const sim::Panel& one, const sim::Panel& other) {
    return std::ranges::equal(one.internal_lines, other.internal_lines, is_same_line);
}

bool has_same_drill_points(const sim::Panel& one, const sim::Panel& other) {
    return std::ranges::equal(one.drill_points, other.drill_points, is_same_place);
}

constexpr std::array kSameMarks{has_same_notches, has_same_pins, has_same_lines, has_same_drill_points};

const sim::OutlineEdge& fold_edge(const sim::Panel& half) {
    return half.edges[as_size(fold_of(half).value())];
}

// The half with the ends of its fold where those of the other are, and their pins: these belong to both halves.
sim::Panel with_fold_of(sim::Panel half, const sim::Panel& other) {
    const sim::OutlineEdge own = fold_edge(half), fold = fold_edge(other);
    for (const auto& [from, to] : {std::pair(own.start, fold.start), std::pair(own.end, fold.end)}) {
        const Vec2d by = other.vertices[as_size(to)] - half.vertices[as_size(from)];
        sim::VertexMove move{std::vector<bool>(half.vertices.size(), false), Eigen::Affine2d(Eigen::Translation2d(by))};
        move.is_moved[as_size(from)] = true;
        if (by != Vec2d::Zero()) move_outline(half, move);
        std::erase(half.pins, from);
        if (std::ranges::count(other.pins, to) > 0) half.pins.push_back(from);
    }
    return half;
}

// More than at the ends of its fold.
bool is_half_changed(const sim::Panel& before, const sim::Panel& now) {
    const sim::Panel was = with_fold_of(before, now);
    if (was.edges.size() != now.edges.size()) return true;
    for (const sim::OutlineEdge& edge : now.edges) {
        const std::optional<int> found = find_edge(was, edge.key);
        if (!found) return true;
        const sim::OutlineEdge& same = was.edges[as_size(*found)];
        if (!has_same_ends(now, edge, was, same) || !is_same_edge(edge, same)) return true;
    }
    return !std::ranges::all_of(kSameMarks, [&](const auto& has_same) { return has_same(was, now); });
}

// Whether an edge with this one's key is there and is the same.
bool has_edge(const sim::Panel& half, const sim::Panel& other, const sim::OutlineEdge& edge) {
    const std::optional<int> found = find_edge(half, edge.key);
    if (!found) return false;
    const sim::OutlineEdge& same = half.edges[as_size(*found)];
    return has_same_ends(half, same, other, edge) && is_same_edge(same, edge);
}

// `half`: that of the panel with this role.
std::vector<HalfDart> darts_of_half(const sim::Pattern& pattern, int panel, sim::EdgeRole role,
                                    const sim::Panel& half) {
    std::vector<HalfDart> darts;
    for (const int dart : sim::darts_of(pattern, panel)) {
        const sim::Seam& seam = pattern.seams[as_size(dart)];
        const sim::Panel& whole = pattern.panels[as_size(panel)];
        const sim::EdgeKey one = edge_key(whole, seam.first.edge), other = edge_key(whole, seam.second.edge);
        if (one.role != role || other.role != role) continue;
        const sim::EdgeKeyPair keys = with_role({one, other}, sim::EdgeRole::Drawn);
        const sim::OutlineEdge& edge = half.edges[as_size(find_edge(half, keys.first).value())];
        const sim::OutlineEdge& sewn = half.edges[as_size(find_edge(half, keys.second).value())];
        const auto at = [&](int vertex) { return half.vertices[as_size(vertex)]; };
        darts.push_back({keys, {at(edge.start), at(edge.end), at(sewn.start), at(sewn.end)}});
    }
    return darts;
}

bool has_dart(const std::vector<HalfDart>& darts, const HalfDart& dart) {
    return std::ranges::any_of(
        darts, [&](const HalfDart& one) { return std::ranges::equal(one.ends, dart.ends, is_same_place); });
}

// Whether `made` has what an edit added to a list, and not what it removed. has(list, one): whether one is in it.
template <class T, class Has>
bool is_list_kept(const std::vector<T>& before, const std::vector<T>& now, const std::vector<T>& made, Has has) {
    return std::ranges::all_of(now, [&](const T& one) { return has(before, one) || has(made, one); }) &&
           std::ranges::none_of(made, [&](const T& one) { return has(before, one) && !has(now, one); });
}

// Whether the half has what the edit changed in it. More points may have come where it is sewn, which divide edges.
bool is_kept(const HalfEdit& edit, const sim::Panel& made, const std::vector<HalfDart>& made_darts) {
    const sim::Panel &before = edit.before, &now = edit.now;
    if (!is_list_kept(before.vertices, now.vertices, made.vertices, has_point) ||
        !is_list_kept(edit.darts_before, edit.darts_now, made_darts, has_dart))
        return false;
    for (const sim::OutlineEdge& edge : now.edges) {
        const std::optional<int> found = find_edge(made, edge.key);
        if (!found || has_edge(before, now, edge) || has_edge(made, now, edge)) continue;
        if (has_same_ends(made, made.edges[as_size(*found)], now, edge)) return false;
    }
    return std::ranges::all_of(kSameMarks,
                               [&](const auto& has_same) { return has_same(before, now) || has_same(made, now); });
}

struct Halves {
    sim::Panel drawn;
    sim::Panel other;  // as a mirror image of `drawn`
    DividedPanel edits = {};
};

// Whether the halves of a panel still meet at both ends of its fold. The first edges of both, round the outline, are
// known by their keys: splits and joins within a half keep these.
bool has_fold_of(const sim::Panel& now, const sim::Panel& before) {
    for (int e = 0; e < edge_count(before); ++e) {
        const sim::EdgeKey key = edge_key(before, e);
        const bool is_first = key.role != edge_key(before, edge_before(before, e)).role;
        if (is_first && !find_edge(now, key)) return false;
    }
    return true;
}

// A panel of a pattern, as an edit finds it.
struct PanelOf {
    const sim::Pattern& pattern;
    int index = 0;

    const sim::Panel& panel() const { return pattern.panels[as_size(index)]; }
};

// `half`: that of `now` with this role.
std::optional<HalfEdit> edit_of(const PanelOf& before, const PanelOf& now, sim::EdgeRole role, const sim::Panel& half) {
    const std::optional<sim::Panel> was = half_of(before.panel(), role);
    if (!was) return {};
    HalfEdit edit{.before = *was,
                  .now = half,
                  .darts_before = darts_of_half(before.pattern, before.index, role, *was),
                  .darts_now = darts_of_half(now.pattern, now.index, role, half)};
    edit.is_changed = is_half_changed(*was, half) || !std::ranges::is_permutation(edit.darts_before, edit.darts_now, {},
                                                                                  &HalfDart::keys, &HalfDart::keys);
    return edit;
}

// `was`: the panel before. None: it has no halves that are linked.
std::optional<Halves> halves_of(const PanelOf& now, const std::optional<PanelOf>& was) {
    const sim::Panel& panel = now.panel();
    const sim::Panel* before = was ? &was->panel() : nullptr;
    std::optional<sim::Panel> drawn = half_of(panel, sim::EdgeRole::Drawn);
    std::optional<sim::Panel> other = half_of(panel, sim::EdgeRole::Image);
    const bool had_halves = before != nullptr && before->fold_key == panel.fold_key;
    if (had_halves && (!drawn || !other || !has_fold_of(panel, *before))) {
        throw GeometryError(
            "The halves of panel " + panel.name + " are linked and meet in this point: unlink the panel first.",
            {{panel.name, -1, -1}});
    }
    if (!drawn || !other) return {};
    const sim::OutlineEdge fold = fold_edge(*drawn);
    const Vec2d from = drawn->vertices[as_size(fold.start)], along = drawn->vertices[as_size(fold.end)] - from;
    if (along.norm() < kSameHalf) {
        throw GeometryError("The halves of panel " + panel.name + " would meet in one point.", {{panel.name, -1, -1}});
    }
    if (had_halves) {
        const auto is_drawn = [&](const auto& part) { return sim::cross2(along, middle_of(part) - from) >= 0; };
        auto lines = split_by_half(panel.internal_lines, before->internal_lines, is_drawn);
        auto points = split_by_half(panel.drill_points, before->drill_points, is_drawn);
        drawn->internal_lines = std::move(lines.drawn);
        drawn->drill_points = std::move(points.drawn);
        other->internal_lines = std::move(lines.other);
        other->drill_points = std::move(points.other);
    }
    const Eigen::Affine2d image(Eigen::Scaling(-1.0, 1.0));
    sim::Panel placed = mapped_panel(*other, image * fold_reflection(*drawn));
    Halves halves{.drawn = *drawn, .other = sim::mirror_image(*drawn)};
    if (had_halves) {
        halves.edits.drawn = edit_of(*was, now, sim::EdgeRole::Drawn, *drawn);
        halves.edits.other = edit_of(*was, now, sim::EdgeRole::Image, *other);
    }
    const sim::Panel alike = halves.other;
    halves.other.vertices = std::move(placed.vertices);
    halves.other.edges = std::move(placed.edges);
    halves.other.notches = std::move(placed.notches);
    halves.other.pins = std::move(placed.pins);
    halves.other.internal_lines = std::move(placed.internal_lines);
    halves.other.drill_points = std::move(placed.drill_points);
    snap_to_image(halves.other, alike);
    halves.other.copy_of.clear();
    halves.other.mirror_of = panel.name;
    return halves;
}

}  // namespace

DividedPattern divide_halves(const sim::Pattern& pattern, const sim::Pattern& before) {
    DividedPattern parts{.pattern = pattern, .divided = {}};
    const auto was = [&](std::size_t panel) -> std::optional<PanelOf> {
        const auto found = std::ranges::find(before.panels, pattern.panels[panel].name, &sim::Panel::name);
        if (found != before.panels.end()) return PanelOf{before, static_cast<int>(found - before.panels.begin())};
        if (before.panels.size() != pattern.panels.size()) return {};
        return PanelOf{before, static_cast<int>(panel)};
    };
    std::vector<int> other(pattern.panels.size(), -1);
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        if (!sim::has_linked_halves(pattern.panels[i])) continue;
        std::optional<Halves> halves = halves_of({pattern, static_cast<int>(i)}, was(i));
        if (!halves) continue;
        other[i] = static_cast<int>(parts.pattern.panels.size());
        parts.divided.push_back(std::move(halves->edits));
        parts.divided.back().panel = static_cast<int>(i);
        parts.pattern.panels[i] = std::move(halves->drawn);
        parts.pattern.panels.push_back(std::move(halves->other));
    }
    for (sim::Seam& seam : parts.pattern.seams) {
        for (sim::SeamSide* side : {&seam.first, &seam.second}) {
            const std::size_t panel = as_size(side->panel);
            if (other[panel] < 0) continue;
            const sim::EdgeKey key = edge_key(pattern.panels[panel], side->edge);
            if (key.role == sim::EdgeRole::Image) side->panel = other[panel];
            side->edge = find_edge(parts.pattern.panels[as_size(side->panel)], {.number = key.number}).value();
        }
    }
    return parts;
}

sim::Pattern joined_halves(const DividedPattern& parts) {
    sim::Pattern pattern = parts.pattern;
    const std::size_t count = pattern.panels.size() - parts.divided.size();
    pattern.panels.resize(count);
    std::vector<bool> is_divided(count, false);
    for (const DividedPanel& divided : parts.divided) {
        is_divided[as_size(divided.panel)] = true;
        sim::Panel& own = pattern.panels[as_size(divided.panel)];
        own = whole_of(own);
    }
    for (sim::Seam& seam : pattern.seams) {
        for (sim::SeamSide* side : {&seam.first, &seam.second}) {
            const bool is_other = as_size(side->panel) >= count;
            if (!is_other && !is_divided[as_size(side->panel)]) continue;
            sim::EdgeKey key = edge_key(parts.pattern.panels[as_size(side->panel)], side->edge);
            key.role = is_other ? sim::EdgeRole::Image : sim::EdgeRole::Drawn;
            if (is_other) side->panel = parts.divided[as_size(side->panel) - count].panel;
            side->edge = find_edge(pattern.panels[as_size(side->panel)], key).value();
        }
    }
    return pattern;
}

void expect_both_kept(const DividedPattern& parts, const sim::Pattern& made) {
    for (const DividedPanel& divided : parts.divided) {
        const std::optional<HalfEdit>&drawn = divided.drawn, &other = divided.other;
        if (!drawn || !other || !drawn->is_changed || !other->is_changed) continue;
        const sim::Panel& panel = made.panels[as_size(divided.panel)];
        const auto is_edit_kept = [&](const HalfEdit& edit, sim::EdgeRole role) {
            const sim::Panel half = half_of(panel, role).value();
            return is_kept(edit, half, darts_of_half(made, divided.panel, role, half));
        };
        if (is_edit_kept(*drawn, sim::EdgeRole::Drawn) && is_edit_kept(*other, sim::EdgeRole::Image)) continue;
        throw GeometryError("The halves of panel " + panel.name + " are linked and would not be alike: change one of " +
                                "them at a time, or unlink the panel first.",
                            {{panel.name, -1, -1}});
    }
}

}  // namespace selvedge::editor
