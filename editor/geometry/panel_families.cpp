#include "editor/geometry/panel_families.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

// An EdgePiece or an EdgeHeir.
void turn_part(auto& part) {
    part.from = 1 - std::exchange(part.to, 1 - part.from);
}

}  // namespace

EdgePieces turned(EdgePieces pieces) {
    std::ranges::reverse(pieces);
    for (EdgePiece& piece : pieces) turn_part(piece);
    return pieces;
}

std::vector<EdgeHeir> turned(std::vector<EdgeHeir> heirs) {
    std::ranges::reverse(heirs);
    for (EdgeHeir& heir : heirs) {
        turn_part(heir);
        turn_part(heir.piece);
    }
    return heirs;
}

bool EdgePiece::is_whole() const {
    return from <= kSameFraction && to >= 1 - kSameFraction;
}

void add_piece(EdgePieces& pieces, EdgePiece piece) {
    const bool goes_on =
        !pieces.empty() && pieces.back().key == piece.key && std::abs(pieces.back().to - piece.from) <= kSameFraction;
    if (goes_on) {
        pieces.back().to = piece.to;
    } else {
        pieces.push_back(piece);
    }
}

PanelFamilies::PanelFamilies(const sim::Pattern& pattern)
    : panels_(pattern.panels), source_(panels_.size()), root_(panels_.size()), is_turned_(panels_.size(), false) {
    const std::map<std::string, std::size_t> index = sim::index_by_name(panels_);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        if (const auto link = sim::link_of(panels_[i])) source_[i] = static_cast<int>(index.at(link->source));
    }
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        int at = static_cast<int>(i);
        for (; source_[as_size(at)]; at = *source_[as_size(at)]) {
            if (!panels_[as_size(at)].mirror_of.empty()) is_turned_[i] = !is_turned_[i];
        }
        root_[i] = at;
    }
}

std::vector<int> PanelFamilies::members(int root) const {
    std::vector<int> found{root};
    for (std::size_t i = 0; i < root_.size(); ++i) {
        if (root_[i] == root && static_cast<int>(i) != root) found.push_back(static_cast<int>(i));
    }
    return found;
}

void PanelFamilies::put(int panel, const sim::Panel& shown) {
    panels_[as_size(panel)] = shown;
    for (int at = panel; source_[as_size(at)];) {
        const int source = *source_[as_size(at)];
        const sim::Derivation kind = sim::link_of(panels_[as_size(at)])->kind;
        panels_[as_size(source)] = source_of_derived(panels_[as_size(at)], kind, panels_[as_size(source)]);
        at = source;
    }
    derive(root_of(panel));
}

void PanelFamilies::derive(int root) {
    std::vector<bool> is_done(panels_.size(), false);
    for (const int member : members(root)) derive_panel(member, is_done);
}

void PanelFamilies::derive_panel(int panel, std::vector<bool>& is_done) {
    if (is_done[as_size(panel)] || !source_[as_size(panel)]) return;
    is_done[as_size(panel)] = true;
    const int source = *source_[as_size(panel)];
    derive_panel(source, is_done);
    sim::Panel& own = panels_[as_size(panel)];
    own = derived_panel(panels_[as_size(source)], sim::link_of(own)->kind, own);
}

EdgePieces PanelFamilies::split(int panel, const sim::EdgeKey& key, std::vector<double> fractions) {
    sim::Panel& root = panels_[as_size(root_of(panel))];
    if (is_turned(panel)) {
        std::ranges::reverse(fractions);
        for (double& fraction : fractions) fraction = 1 - fraction;
    }
    const int edge = find_edge(root, key).value();
    double whole = 1;
    for (auto t = fractions.rbegin(); t != fractions.rend(); ++t) {
        split_edge(root, edge, *t / whole);
        whole = *t;
    }
    derive(root_of(panel));
    EdgePieces parts;
    for (int i = 0; i <= static_cast<int>(fractions.size()); ++i) parts.push_back({.key = edge_key(root, edge + i)});
    return is_turned(panel) ? turned(parts) : parts;
}

std::optional<EdgePieces> PanelFamilies::join(int panel, const EdgePieces& edges) {
    sim::Pattern alone;
    alone.panels.push_back(panels_[as_size(root_of(panel))]);
    sim::Panel& root = alone.panels.front();
    const EdgePieces run = is_turned(panel) ? turned(edges) : edges;
    const int count = static_cast<int>(run.size());
    if (count > edge_count(root) - 2) return {};
    const int first = find_edge(root, run.front().key).value();
    std::vector<int> inner;
    std::vector<double> reached{0};  // m
    for (int i = 0; i < count; ++i) {
        const sim::OutlineEdge& edge = root.edges[as_size((first + i) % edge_count(root))];
        reached.push_back(reached.back() + outline_length(root, edge));
        if (i + 1 < count) inner.push_back(edge.end);
    }
    if (!std::ranges::all_of(inner, [&](int vertex) { return is_smooth(root, vertex); })) return {};
    join_alone(alone, 0, first, count);
    drop_unused(root, inner);
    EdgePieces parts;
    for (std::size_t i = 0; i < run.size(); ++i) {
        parts.push_back({.key = run.front().key,
                         .from = reached[i] / reached.back(),
                         .to = reached[i + 1] / reached.back(),
                         .is_joined = true});
    }
    panels_[as_size(root_of(panel))] = std::move(root);
    derive(root_of(panel));
    return is_turned(panel) ? turned(parts) : parts;
}

}  // namespace selvedge::editor
