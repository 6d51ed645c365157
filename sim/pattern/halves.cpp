#include "sim/pattern/halves.h"

#include <algorithm>
#include <vector>

#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"

namespace selvedge::sim {
namespace {

// Of a list with the drawn half's parts first, then as many images.
template <class T>
std::vector<T> part_of_list(const std::vector<T>& parts, EdgeRole half) {
    const auto middle = parts.begin() + static_cast<std::ptrdiff_t>((parts.size() + 1) / 2);
    return half == EdgeRole::Drawn ? std::vector<T>(parts.begin(), middle) : std::vector<T>(middle, parts.end());
}

}  // namespace

bool has_linked_halves(const Panel& panel) {
    return panel.fold_key > 0;
}

std::optional<Panel> half_of(const Panel& panel, EdgeRole role) {
    const std::size_t count = panel.edges.size();
    const auto is_own = [&](std::size_t edge) { return panel.edges[edge % count].key.role == role; };
    std::size_t starts = 0, first = 0, own = 0;  // of runs of own edges
    for (std::size_t e = 0; e < count; ++e) {
        own += is_own(e) ? 1 : 0;
        if (!is_own(e) || is_own(e + count - 1)) continue;
        ++starts;
        first = e;
    }
    if (!has_linked_halves(panel) || !has_keys(panel) || starts != 1) return {};
    Panel half = panel;
    half.edges.clear();
    std::vector<int> edge(count, -1), vertex(panel.vertices.size(), -1);
    const std::size_t last = (first + own - 1) % count;
    const OutlineEdge fold{
        .start = panel.edges[last].end, .end = panel.edges[first].start, .key = {.number = panel.fold_key}};
    for (std::size_t e = 0; e < count; ++e) {
        if (!is_own(e)) continue;
        edge[e] = static_cast<int>(half.edges.size());
        half.edges.push_back(panel.edges[e]);
        half.edges.back().key.role = EdgeRole::Drawn;
        vertex[as_size(panel.edges[e].start)] = vertex[as_size(panel.edges[e].end)] = 0;
        if (e != last) continue;
        half.edges.push_back(fold);
    }
    half.vertices.clear();
    for (std::size_t v = 0; v < vertex.size(); ++v) {
        if (vertex[v] < 0) continue;
        vertex[v] = static_cast<int>(half.vertices.size());
        half.vertices.push_back(panel.vertices[v]);
    }
    for (OutlineEdge& own_edge : half.edges) {
        own_edge.start = vertex[as_size(own_edge.start)];
        own_edge.end = vertex[as_size(own_edge.end)];
    }
    std::erase_if(half.notches, [&](const Notch& notch) { return edge[as_size(notch.edge)] < 0; });
    for (Notch& notch : half.notches) notch.edge = edge[as_size(notch.edge)];
    std::erase_if(half.pins, [&](int pin) { return vertex[as_size(pin)] < 0; });
    for (int& pin : half.pins) pin = vertex[as_size(pin)];
    half.internal_lines = part_of_list(panel.internal_lines, role);
    half.drill_points = part_of_list(panel.drill_points, role);
    return half;
}

std::optional<int> fold_of(const Panel& half) {
    return has_linked_halves(half) ? find_edge(half, {.number = half.fold_key}) : std::nullopt;
}

Panel whole_of(const Panel& half) {
    return unfolded(half, fold_of(half).value());
}

Eigen::Affine2d fold_reflection(const Panel& half) {
    const OutlineEdge& fold = half.edges[as_size(fold_of(half).value())];
    return reflection_in(half.vertices[as_size(fold.start)], half.vertices[as_size(fold.end)]);
}

}  // namespace selvedge::sim
