#include "editor/geometry/sewing.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/seam_edit.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

constexpr double kSameCurve = 5e-5;  // m, two edges are parts of one curve if it lies no further from them
constexpr double kShortest = 1e-4;   // m, of an edge that is left where a point was slid

// One edge for the two that meet at the vertex. None: they make a corner there, or are not parts of one curve.
std::optional<sim::OutlineEdge> curve_through(const sim::Panel& panel, int vertex) {
    if (edge_count(panel) < 3 || !is_smooth(panel, vertex)) return {};
    const sim::OutlineEdge& after = panel.edges[as_size(edge_from(panel, vertex))];
    const sim::OutlineEdge& first = panel.edges[as_size(edge_before(panel, edge_from(panel, vertex)))];
    const sim::OutlineEdge joined = joined_curve(panel, {first, after});
    const double length = outline_length(panel, first), whole = outline_length(panel, joined);
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const Vec2d here = outline_point(panel, first, share), next = outline_point(panel, after, share);
        const double rest = whole - length;
        if ((outline_point(panel, joined, share * length / whole) - here).norm() > kSameCurve) return {};
        if ((outline_point(panel, joined, (length + share * rest) / whole) - next).norm() > kSameCurve) return {};
    }
    return joined;
}

sim::SeamSide side_of(const sim::Seam& seam, SewingRun run) {
    return run == SewingRun::First ? seam.first : seam.second;
}

// A vertex of a panel.
struct Point {
    int panel = 0;
    int vertex = 0;

    auto operator<=>(const Point&) const = default;
};

Point start_of(const sim::Pattern& pattern, const sim::SeamSide& side) {
    return {side.panel, edge_of(pattern, side).start};
}

// The vertices inside a run, where two of its edges meet.
std::set<Point> joints_of(const sim::Pattern& pattern, const std::vector<sim::SeamSide>& run) {
    std::set<Point> ends, joints;
    for (const sim::SeamSide& side : run) ends.insert({side.panel, edge_of(pattern, side).end});
    for (const sim::SeamSide& side : run) {
        if (ends.contains(start_of(pattern, side))) joints.insert(start_of(pattern, side));
    }
    return joints;
}

// The joints of a run that stand only where the other run has a corner.
std::set<Point> made_joints(const sim::Pattern& pattern, const std::vector<int>& seams,
                            const std::vector<sim::SeamSide>& run, const std::vector<sim::SeamSide>& other,
                            SewingRun which) {
    const std::set<Point> joints = joints_of(pattern, run), other_joints = joints_of(pattern, other);
    const auto is_made = [&](const Point& at) {
        return curve_through(pattern.panels[as_size(at.panel)], at.vertex).has_value();
    };
    std::set<Point> made;
    for (const int index : seams) {
        const sim::Seam& seam = pattern.seams[as_size(index)];
        const sim::SeamSide own = side_of(seam, which);
        const sim::SeamSide facing = side_of(seam, which == SewingRun::First ? SewingRun::Second : SewingRun::First);
        const Point joint = start_of(pattern, own);
        const sim::OutlineEdge& edge = edge_of(pattern, facing);
        const Point meets{facing.panel, seam.is_reversed ? edge.end : edge.start};
        if (!joints.contains(joint) || !is_made(joint)) continue;
        if (!other_joints.contains(meets) || !is_made(meets)) made.insert(joint);
    }
    return made;
}

// Takes points out of outlines. Pre: the edges that meet there are not sewn.
void join_at(sim::Pattern& draft, const std::set<Point>& points) {
    for (const Point& point : points) {
        const sim::Panel& panel = draft.panels[as_size(point.panel)];
        join_alone(draft, point.panel, edge_before(panel, edge_from(panel, point.vertex)), 2);
    }
}

std::vector<EdgeSpan> spans_from(const sim::Pattern& pattern, const std::vector<Point>& starts) {
    std::vector<EdgeSpan> spans;
    for (const Point& start : starts) {
        const int edge = edge_from(pattern.panels[as_size(start.panel)], start.vertex);
        spans.push_back({start.panel, edge, 0, 1});
    }
    return spans;
}

void drop_points(sim::Pattern& draft, const std::set<Point>& points) {
    std::map<int, std::vector<int>> vertices;
    for (const Point& point : points) vertices[point.panel].push_back(point.vertex);
    for (const auto& [panel, unused] : vertices) drop_unused(draft.panels[as_size(panel)], unused);
}

// The vertices of a run that can be slid, in outline order.
std::vector<Point> slidable(const sim::Pattern& pattern, const std::vector<sim::SeamSide>& run) {
    std::vector<Point> points;
    const auto add = [&](int panel, int vertex) {
        const Point point{panel, vertex};
        const bool is_known = std::find(points.begin(), points.end(), point) != points.end();
        if (!is_known && curve_through(pattern.panels[as_size(panel)], vertex)) points.push_back(point);
    };
    for (const sim::SeamSide& side : run) {
        add(side.panel, edge_of(pattern, side).start);
        add(side.panel, edge_of(pattern, side).end);
    }
    return points;
}

// Moves a vertex along the curve of the two edges that meet there; their notches stay where they are.
void slide_point(sim::Panel& panel, int vertex, double by) {
    const int after = edge_from(panel, vertex), first = edge_before(panel, after);
    const std::optional<sim::OutlineEdge> joined = curve_through(panel, vertex);
    const double length = outline_length(panel, panel.edges[as_size(first)]);
    const double whole = length + outline_length(panel, panel.edges[as_size(after)]);
    const double moved = length + by;
    if (!joined || moved < kShortest || moved > whole - kShortest) {
        throw GeometryError("The sewing cannot be slid past the end of its curve.", {{panel.name, after, vertex}});
    }
    for (sim::Notch& notch : panel.notches) {
        if (notch.edge != first && notch.edge != after) continue;
        const double at = notch.edge == first ? notch.t * length : length + notch.t * (whole - length);
        notch.edge = at <= moved ? first : after;
        notch.t = at <= moved ? at / moved : (at - moved) / (whole - moved);
    }
    sim::SplitCurve parts = split_curve(panel, *joined, moved / whole, vertex);
    panel.vertices[as_size(vertex)] = parts.point;
    keep_properties(parts.before, panel.edges[as_size(first)]);
    keep_properties(parts.after, panel.edges[as_size(after)]);
    panel.edges[as_size(first)] = std::move(parts.before);
    panel.edges[as_size(after)] = std::move(parts.after);
}

}  // namespace

std::vector<sim::SeamSide> edges_of_run(const sim::Pattern& pattern, const std::vector<int>& seams, SewingRun run) {
    std::vector<int> panels;
    std::map<int, std::set<int>> edges;
    for (const int seam : seams) {
        const sim::SeamSide side = side_of(pattern.seams[as_size(seam)], run);
        if (!edges.contains(side.panel)) panels.push_back(side.panel);
        edges[side.panel].insert(side.edge);
    }
    std::vector<sim::SeamSide> sides;
    for (const int panel : panels) {
        const std::set<int>& own = edges[panel];
        const auto begins = [&](int edge) { return !own.contains(edge_before(pattern.panels[as_size(panel)], edge)); };
        const auto found = std::find_if(own.begin(), own.end(), begins);
        const auto start = found == own.end() ? own.begin() : found;
        for (auto edge = start; edge != own.end(); ++edge) sides.push_back({panel, *edge});
        for (auto edge = own.begin(); edge != start; ++edge) sides.push_back({panel, *edge});
    }
    return sides;
}

std::vector<int> sewing_of(const sim::Pattern& pattern, int seam) {
    const std::string& name = seam_of(pattern, seam).sewing;
    if (name.empty()) return {seam};
    std::vector<int> seams;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        if (pattern.seams[i].sewing == name) seams.push_back(static_cast<int>(i));
    }
    const std::vector<sim::SeamSide> run = edges_of_run(pattern, seams, SewingRun::First);
    const auto place = [&](int index) {
        return std::find(run.begin(), run.end(), pattern.seams[as_size(index)].first) - run.begin();
    };
    std::stable_sort(seams.begin(), seams.end(), [&](int a, int b) { return place(a) < place(b); });
    return seams;
}

int first_of_sewing(const sim::Pattern& pattern, int seam) {
    const std::string& name = seam_of(pattern, seam).sewing;
    if (name.empty()) return seam;
    return static_cast<int>(std::ranges::find(pattern.seams, name, &sim::Seam::sewing) - pattern.seams.begin());
}

std::vector<int> one_of_each_sewing(const sim::Pattern& pattern, const std::set<int>& seams) {
    std::vector<int> chosen;
    std::set<std::string> taken;
    for (const int seam : seams) {
        const std::string& sewing = seam_of(pattern, seam).sewing;
        if (sewing.empty() || taken.insert(sewing).second) chosen.push_back(seam);
    }
    return chosen;
}

std::vector<int> one_of_each_sewing(const sim::Pattern& pattern) {
    std::set<int> all;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) all.insert(static_cast<int>(i));
    return one_of_each_sewing(pattern, all);
}

void toggle_sewing(const sim::Pattern& pattern, int seam, std::set<int>& seams) {
    const bool was_there = seams.contains(seam);
    for (const int part : sewing_of(pattern, seam)) {
        if (was_there) seams.erase(part);
        if (!was_there) seams.insert(part);
    }
}

void separate_sewings(sim::Pattern& pattern, std::size_t first) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < first; ++i) taken.insert(pattern.seams[i].sewing);
    std::map<std::string, std::string> fresh;
    for (std::size_t i = first; i < pattern.seams.size(); ++i) {
        std::string& sewing = pattern.seams[i].sewing;
        if (sewing.empty() || (!taken.contains(sewing) && !fresh.contains(sewing))) continue;
        const auto known = fresh.find(sewing);
        sewing = known != fresh.end() ? known->second : (fresh[sewing] = free_sewing_name(pattern));
    }
}

std::array<double, 2> sewing_lengths(const sim::Pattern& pattern, int seam) {
    std::array<double, 2> lengths{0, 0};
    for (const int part : sewing_of(pattern, seam)) {
        const auto [first, second] = seam_lengths(pattern, pattern.seams[as_size(part)]);
        lengths[0] += first;
        lengths[1] += second;
    }
    return lengths;
}

std::vector<int> reverse_sewing(sim::Pattern& pattern, int seam) {
    const std::vector<int> seams = sewing_of(pattern, seam);
    if (seams.size() == 1) {
        bool& is_reversed = pattern.seams[as_size(seam)].is_reversed;
        is_reversed = !is_reversed;
        return seams;
    }
    std::vector<sim::Seam> old;  // in the order in which the runs meet
    for (const int part : seams) old.push_back(pattern.seams[as_size(part)]);
    return edit_pattern(pattern, [&](sim::Pattern& draft) {
        const std::vector<sim::SeamSide> run = edges_of_run(draft, seams, SewingRun::First);
        const std::vector<sim::SeamSide> other = edges_of_run(draft, seams, SewingRun::Second);
        std::set<Point> made = made_joints(draft, seams, run, other, SewingRun::First);
        made.merge(made_joints(draft, seams, other, run, SewingRun::Second));
        std::array<std::vector<Point>, 2> starts;
        for (const int part : seams) {  // in the order in which the runs meet
            const sim::Seam& sewn = draft.seams[as_size(part)];
            if (!made.contains(start_of(draft, sewn.first))) starts[0].push_back(start_of(draft, sewn.first));
            if (!made.contains(start_of(draft, sewn.second))) starts[1].push_back(start_of(draft, sewn.second));
        }
        if (old.front().is_reversed) std::reverse(starts[1].begin(), starts[1].end());
        remove_seams(draft, seams);
        join_at(draft, made);
        std::vector<int> sewn =
            sew_runs(draft, spans_from(draft, starts[0]), spans_from(draft, starts[1]), !old.front().is_reversed);
        for (std::size_t i = 0; i < sewn.size(); ++i) {
            sim::Seam& part = draft.seams[as_size(sewn[i])];
            keep_properties(part, old[std::min(i, old.size() - 1)]);
            if (i >= old.size()) part.name.clear();
            if (sewn.size() == 1) part.sewing.clear();
        }
        drop_points(draft, made);
        return sewn;
    });
}

bool can_slide(const sim::Pattern& pattern, int seam, SewingRun run) {
    return !slidable(pattern, edges_of_run(pattern, sewing_of(pattern, seam), run)).empty();
}

void slide_sewing(sim::Pattern& pattern, int seam, SewingRun run, double by) {
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        const std::vector<sim::SeamSide> sides = edges_of_run(draft, sewing_of(draft, seam), run);
        std::vector<Point> points = slidable(draft, sides);
        if (points.empty()) {
            throw GeometryError("The sewing begins and ends at corners: there is nothing to slide.",
                                {place_of(draft, sides.front())});
        }
        // The foremost one first, so that the next one has room.
        if (by > 0) std::reverse(points.begin(), points.end());
        for (const Point& point : points) slide_point(draft.panels[as_size(point.panel)], point.vertex, by);
    });
}

}  // namespace selvedge::editor
