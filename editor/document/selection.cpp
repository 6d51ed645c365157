#include "editor/document/selection.h"

#include <algorithm>

#include "editor/geometry/sewing.h"
#include "sim/core/math.h"
#include "sim/pattern/edge_keys.h"

namespace selvedge::editor {
namespace {

const sim::Panel* panel_named(const sim::Pattern& pattern, const std::string& name) {
    const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                    [&](const sim::Panel& panel) { return panel.name == name; });
    return found == pattern.panels.end() ? nullptr : &*found;
}

template <class Parts>
void clean(std::set<PartRef>& refs, const sim::Pattern& pattern, Parts parts_of) {
    std::erase_if(refs, [&](const PartRef& ref) {
        const sim::Panel* panel = panel_named(pattern, ref.panel);
        return panel == nullptr || ref.index < 0 || static_cast<std::size_t>(ref.index) >= parts_of(*panel).size();
    });
}

}  // namespace

Selection clean_selection(Selection selection, const sim::Pattern& pattern) {
    std::erase_if(selection.panels, [&](const std::string& name) { return panel_named(pattern, name) == nullptr; });
    clean(
        selection.vertices, pattern, [](const sim::Panel& panel) -> const auto& { return panel.vertices; });
    clean(
        selection.edges, pattern, [](const sim::Panel& panel) -> const auto& { return panel.edges; });
    clean(
        selection.internal_lines, pattern, [](const sim::Panel& panel) -> const auto& { return panel.internal_lines; });
    clean(
        selection.notches, pattern, [](const sim::Panel& panel) -> const auto& { return panel.notches; });
    std::erase_if(selection.seams,
                  [&](int seam) { return seam < 0 || static_cast<std::size_t>(seam) >= pattern.seams.size(); });
    const std::set<int> seams = selection.seams;
    for (const int seam : seams) {
        for (const int part : sewing_of(pattern, seam)) selection.seams.insert(part);
    }
    return selection;
}

namespace {

// Where parts of one panel are in its next state.
class PanelCarrier {
 public:
    PanelCarrier(const sim::Panel& before, const sim::Panel& after)
        : before_(before), after_(after), is_turned_(is_turned_over(before, after)) {}

    std::optional<int> edge(int index) const { return find_edge(after_, edge_key(before_, index)); }

    // The vertex between the edges with the keys of those that met there. Where one of them is no more, or others came
    // between them, the one that has its place.
    std::optional<int> vertex(int index) const {
        const auto at = [&](int e) { return before_.edges[as_size(e)]; };
        std::optional<int> from, to;
        for (int e = 0; e < static_cast<int>(before_.edges.size()); ++e) {
            const std::optional<int> now = edge(e);
            if (!now) continue;
            const sim::OutlineEdge& edge = after_.edges[as_size(*now)];
            if (at(e).start == index) from = is_turned_ ? edge.end : edge.start;
            if (at(e).end == index) to = is_turned_ ? edge.start : edge.end;
        }
        if (from && from == to) return from;
        constexpr double kSame = 1e-9;  // m
        const auto is_at_place = [&](const sim::OutlineEdge& edge) {
            return (after_.vertices[as_size(edge.start)] - before_.vertices[as_size(index)]).norm() < kSame;
        };
        const auto found = std::ranges::find_if(after_.edges, is_at_place);
        return found == after_.edges.end() ? std::nullopt : std::optional(found->start);
    }

    std::optional<int> internal_line(int index) const {
        return part(before_.internal_lines, after_.internal_lines, index,
                    [](const sim::InternalLine& one, const sim::InternalLine& other) { return one == other; });
    }

    std::optional<int> notch(int index) const {
        return part(before_.notches, after_.notches, index, [&](const sim::Notch& one, const sim::Notch& other) {
            return one.t == other.t && edge_key(before_, one.edge) == edge_key(after_, other.edge);
        });
    }

 private:
    // An equal one; else, if none came or went, the one with its index.
    template <class T, class IsSame>
    static std::optional<int> part(const std::vector<T>& before, const std::vector<T>& after, int index,
                                   IsSame is_same) {
        const auto is_it = [&](const T& other) { return is_same(before[as_size(index)], other); };
        if (as_size(index) < after.size() && is_it(after[as_size(index)])) return index;
        const auto found = std::ranges::find_if(after, is_it);
        if (found != after.end()) return static_cast<int>(found - after.begin());
        return before.size() == after.size() ? std::optional(index) : std::nullopt;
    }

    const sim::Panel& before_;
    const sim::Panel& after_;
    bool is_turned_;
};

using CarryPart = std::optional<int> (PanelCarrier::*)(int) const;

std::set<PartRef> carried(const std::set<PartRef>& refs, const sim::Pattern& before, const sim::Pattern& after,
                          CarryPart carry) {
    std::set<PartRef> found;
    for (const PartRef& ref : refs) {
        const sim::Panel* was = panel_named(before, ref.panel);
        const sim::Panel* is = panel_named(after, ref.panel);
        if (!was || !is) continue;
        if (const auto index = (PanelCarrier(*was, *is).*carry)(ref.index)) found.insert({ref.panel, *index});
    }
    return found;
}

using SideByKey = std::pair<std::string, sim::EdgeKey>;

std::set<SideByKey> sides_of(const sim::Pattern& pattern, const sim::Seam& seam) {
    std::set<SideByKey> sides;
    for (const sim::SeamSide& side : {seam.first, seam.second}) {
        const sim::Panel& panel = sim::panel_of(pattern, side);
        sides.insert({panel.name, edge_key(panel, side.edge)});
    }
    return sides;
}

// A seam that has a side of one of the seams: the seam itself, or a part of it.
std::set<int> carried_seams(const std::set<int>& seams, const sim::Pattern& before, const sim::Pattern& after) {
    std::set<SideByKey> sides;
    for (const int seam : seams) sides.merge(sides_of(before, before.seams[as_size(seam)]));
    std::set<int> found;
    for (std::size_t i = 0; i < after.seams.size(); ++i) {
        const std::set<SideByKey> own = sides_of(after, after.seams[i]);
        if (std::ranges::any_of(own, [&](const SideByKey& side) { return sides.contains(side); }))
            found.insert(static_cast<int>(i));
    }
    return found;
}

}  // namespace

Selection carried(Selection selection, const sim::Pattern& before, const sim::Pattern& after) {
    selection = clean_selection(std::move(selection), before);
    selection.vertices = carried(selection.vertices, before, after, &PanelCarrier::vertex);
    selection.edges = carried(selection.edges, before, after, &PanelCarrier::edge);
    selection.internal_lines = carried(selection.internal_lines, before, after, &PanelCarrier::internal_line);
    selection.notches = carried(selection.notches, before, after, &PanelCarrier::notch);
    selection.seams = carried_seams(selection.seams, before, after);
    return clean_selection(std::move(selection), after);
}

Selection pickable(Selection selection, const PanelStates& states, const sim::Pattern& pattern) {
    std::erase_if(selection.panels, [&](const std::string& name) { return !states.may_be_picked(name); });
    for (std::set<PartRef>* parts :
         {&selection.vertices, &selection.edges, &selection.internal_lines, &selection.notches}) {
        std::erase_if(*parts, [&](const PartRef& ref) { return !states.may_be_picked(ref.panel); });
    }
    std::erase_if(selection.seams, [&](int index) {
        const sim::Seam& seam = pattern.seams[static_cast<std::size_t>(index)];
        return !states.may_be_picked(sim::panel_of(pattern, seam.first).name) ||
               !states.may_be_picked(sim::panel_of(pattern, seam.second).name);
    });
    return selection;
}

PanelStates clean_states(PanelStates states, const sim::Pattern& pattern) {
    for (std::set<std::string>* names : {&states.hidden, &states.locked})
        std::erase_if(*names, [&](const std::string& name) { return panel_named(pattern, name) == nullptr; });
    return states;
}

PanelStates renamed(PanelStates states, const std::string& from, const std::string& to) {
    for (std::set<std::string>* names : {&states.hidden, &states.locked})
        if (names->erase(from) > 0) names->insert(to);
    return states;
}

}  // namespace selvedge::editor
