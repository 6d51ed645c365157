#include "editor/geometry/edge_remap.h"

#include <algorithm>
#include <cmath>

#include "editor/geometry/draft.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

constexpr double kSmooth = 1e-3;  // rad, tangents that differ by less make no corner

void remove_seams_at(sim::Pattern& pattern, const std::vector<sim::SeamSide>& sides) {
    const auto is_there = [&](const sim::SeamSide& side) {
        return std::find(sides.begin(), sides.end(), side) != sides.end();
    };
    std::erase_if(pattern.seams, [&](const sim::Seam& seam) { return is_there(seam.first) || is_there(seam.second); });
}

// The edges of the run, in outline order.
std::vector<int> run_of(const sim::Panel& panel, int first, int count) {
    std::vector<int> run;
    run.reserve(as_size(count));
    for (int i = 0; i < count; ++i) run.push_back((first + i) % edge_count(panel));
    return run;
}

struct OppositeRun {
    int panel = 0;
    int first = 0;  // first edge of the run, in the order of that panel's outline
};

// The run on the other side of a run's seams. None: those edges are not consecutive in matching order.
std::optional<OppositeRun> opposite_run(const sim::Pattern& pattern, int panel, const std::vector<int>& run) {
    std::vector<sim::SeamSide> others;
    std::optional<bool> is_reversed;
    for (const int edge : run) {
        const sim::SeamSide side{panel, edge};
        const auto found = seam_at(pattern, side);
        if (!found) return {};
        const sim::Seam& seam = pattern.seams[as_size(*found)];
        others.push_back(seam.first == side ? seam.second : seam.first);
        if (is_reversed.value_or(seam.is_reversed) != seam.is_reversed) return {};
        is_reversed = seam.is_reversed;
    }
    if (*is_reversed) std::reverse(others.begin(), others.end());
    const int count = edge_count(pattern.panels[as_size(others[0].panel)]);
    for (std::size_t i = 0; i < others.size(); ++i) {
        const bool follows =
            others[i].panel == others[0].panel && others[i].edge == (others[0].edge + static_cast<int>(i)) % count;
        const bool is_own = others[i].panel == panel && std::find(run.begin(), run.end(), others[i].edge) != run.end();
        if (!follows || is_own) return {};
    }
    return OppositeRun{others[0].panel, others[0].edge};
}

}  // namespace

void remap_edges(sim::Pattern& pattern, int panel, const std::function<std::optional<EdgeImage>(int)>& image_of) {
    std::vector<sim::Seam> kept;
    for (sim::Seam seam : pattern.seams) {
        bool is_whole = true;
        for (sim::SeamSide* side : {&seam.first, &seam.second}) {
            if (side->panel != panel) continue;
            const auto image = image_of(side->edge);
            is_whole = is_whole && image.has_value();
            if (!image) continue;
            *side = image->side;
            if (image->is_turned) seam.is_reversed = !seam.is_reversed;
        }
        if (is_whole) kept.push_back(std::move(seam));
    }
    pattern.seams = std::move(kept);
}

int split_alone(sim::Pattern& pattern, const sim::SeamSide& at, double t) {
    sim::Panel& panel = pattern.panels[as_size(at.panel)];
    const int vertex = static_cast<int>(panel.vertices.size());
    split_edge(panel, at.edge, t);
    remap_edges(pattern, at.panel, [&](int edge) { return EdgeImage{{at.panel, edge > at.edge ? edge + 1 : edge}}; });
    return vertex;
}

int split_sewn(sim::Pattern& pattern, const sim::SeamSide& at, double t) {
    const int vertex = split_alone(pattern, at, t);
    if (seam_at(pattern, at)) share_seam(pattern, at, vertex, t);
    return vertex;
}

void share_seam(sim::Pattern& pattern, const sim::SeamSide& own, int rest, double t) {
    const int index = seam_at(pattern, own).value();
    const bool is_first = pattern.seams[as_size(index)].first == own;
    const auto other_of = [&](sim::Seam& seam) -> sim::SeamSide& { return is_first ? seam.second : seam.first; };
    const bool is_reversed = pattern.seams[as_size(index)].is_reversed;
    split_alone(pattern, other_of(pattern.seams[as_size(index)]), is_reversed ? 1 - t : t);
    sim::Seam& seam = pattern.seams[as_size(index)];
    sim::Seam second = seam;
    second.name.clear();
    (is_first ? second.first : second.second).edge = edge_from(pattern.panels[as_size(own.panel)], rest);
    ++other_of(is_reversed ? seam : second).edge;
    pattern.seams.push_back(std::move(second));
}

int edge_from(const sim::Panel& panel, int vertex) {
    const auto found = std::find_if(panel.edges.begin(), panel.edges.end(),
                                    [&](const sim::OutlineEdge& edge) { return edge.start == vertex; });
    return static_cast<int>(found - panel.edges.begin());
}

void join_alone(sim::Pattern& pattern, int panel_index, int first, int count) {
    sim::Panel& panel = pattern.panels[as_size(panel_index)];
    const int total = edge_count(panel);
    const std::vector<int> run = run_of(panel, first, count);
    std::vector<sim::OutlineEdge> chain;
    std::vector<double> reached{0};  // m, arc length before each edge of the chain
    for (const int edge : run) {
        chain.push_back(panel.edges[as_size(edge)]);
        reached.push_back(reached.back() + outline_length(panel, chain.back()));
    }
    const int wrapped = std::max(0, first + count - total);  // edges of the run that wrap to index 0
    std::vector<int> image(as_size(total));
    for (int i = 0; i < total; ++i) image[as_size(i)] = i < first ? i - wrapped : i - count + 1;
    for (const int edge : run) image[as_size(edge)] = first - wrapped;
    for (sim::Notch& notch : panel.notches) {
        const auto at = std::find(run.begin(), run.end(), notch.edge);
        if (at != run.end()) {
            const auto i = static_cast<std::size_t>(at - run.begin());
            const double length = reached[i] + notch.t * (reached[i + 1] - reached[i]);
            notch.t = std::clamp(length / reached.back(), 0.0, 1.0);
        }
        notch.edge = image[as_size(notch.edge)];
    }
    panel.edges[as_size(first)] = joined_curve(panel, chain);
    panel.edges.erase(panel.edges.begin() + first + 1, panel.edges.begin() + std::min(first + count, total));
    panel.edges.erase(panel.edges.begin(), panel.edges.begin() + wrapped);
    remap_edges(pattern, panel_index, [&](int edge) { return EdgeImage{{panel_index, image[as_size(edge)]}}; });
}

void join_sewn(sim::Pattern& pattern, int panel, int first, int count,
               const std::function<bool(int panel, int vertex)>& may_join) {
    const sim::Panel& own = pattern.panels[as_size(panel)];
    const std::vector<int> run = run_of(own, first, count);
    std::optional<OppositeRun> opposite = opposite_run(pattern, panel, run);
    if (opposite) {
        const sim::Panel& other = pattern.panels[as_size(opposite->panel)];
        for (const int edge : run_of(other, opposite->first, count - 1)) {
            if (!may_join(opposite->panel, other.edges[as_size(edge)].end)) opposite.reset();
            if (!opposite) break;
        }
    }
    std::vector<sim::SeamSide> going;
    for (const int edge : run) {
        if (!opposite || edge != first) going.push_back({panel, edge});
    }
    const int start = own.edges[as_size(first)].start;
    remove_seams_at(pattern, going);
    if (opposite) {
        // The remaining seam is that of `first`. If the opposite run is reversed, it is at that run's last edge.
        join_alone(pattern, opposite->panel, opposite->first, count);
    }
    join_alone(pattern, panel, edge_from(pattern.panels[as_size(panel)], start), count);
}

void drop_vertices(sim::Panel& panel, const std::vector<int>& vertices) {
    std::vector<int> image(panel.vertices.size(), 0);
    for (const int vertex : vertices) image[as_size(vertex)] = -1;
    std::vector<Vec2d> kept;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (image[i] < 0) continue;
        image[i] = static_cast<int>(kept.size());
        kept.push_back(panel.vertices[i]);
    }
    panel.vertices = std::move(kept);
    for (sim::OutlineEdge& edge : panel.edges) {
        edge.start = image[as_size(edge.start)];
        edge.end = image[as_size(edge.end)];
    }
    std::erase_if(panel.pins, [&](int pin) { return image[as_size(pin)] < 0; });
    for (int& pin : panel.pins) pin = image[as_size(pin)];
}

bool is_smooth(const sim::Panel& panel, int vertex) {
    if (std::find(panel.pins.begin(), panel.pins.end(), vertex) != panel.pins.end()) return false;
    const int after = edge_from(panel, vertex);
    const int before = edge_before(panel, after);
    const Vec2d arriving = curve_direction(panel, panel.edges[as_size(before)], sim::EdgeEnd::End);
    const Vec2d leaving = curve_direction(panel, panel.edges[as_size(after)], sim::EdgeEnd::Start);
    return arriving.dot(leaving) > 0 && std::abs(sim::cross2(arriving, leaving)) < kSmooth;
}

void drop_unused(sim::Panel& panel, std::vector<int> candidates) {
    std::erase_if(candidates, [&](int vertex) { return edge_from(panel, vertex) < edge_count(panel); });
    if (!candidates.empty()) drop_vertices(panel, candidates);
}

void drop_panels(sim::Pattern& pattern, const std::vector<int>& panels) {
    for (const int panel : panels) unlink(pattern, panel);
    std::vector<int> image(pattern.panels.size(), 0);
    for (const int panel : panels) image[as_size(panel)] = -1;
    std::vector<sim::Panel> kept;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (image[i] < 0) continue;
        image[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(pattern.panels[i]));
    }
    pattern.panels = std::move(kept);
    std::erase_if(pattern.seams, [&](const sim::Seam& seam) {
        return image[as_size(seam.first.panel)] < 0 || image[as_size(seam.second.panel)] < 0;
    });
    for (sim::Seam& seam : pattern.seams) {
        seam.first.panel = image[as_size(seam.first.panel)];
        seam.second.panel = image[as_size(seam.second.panel)];
    }
}

void unlink(sim::Pattern& pattern, int panel) {
    sim::Panel& own = pattern.panels[as_size(panel)];
    own.mirror_of.clear();
    own.copy_of.clear();
    own.fold_key = 0;
    for (sim::Panel& other : pattern.panels) {
        for (std::string* source : {&other.mirror_of, &other.copy_of}) {
            if (*source == own.name) source->clear();
        }
    }
}

}  // namespace selvedge::editor
