#include "editor/document/selection.h"

#include <algorithm>

#include "editor/geometry/sewing.h"

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
