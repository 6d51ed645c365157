#include "editor/inspectors/object_tree.h"

#include <algorithm>

#include "editor/geometry/sewing.h"
#include "editor/inspectors/material_inspector.h"
#include "sim/pattern/garments.h"

namespace selvedge::editor {
namespace {

// Adds the part if it is wanted, or if its whole panel is listed. Returns 1 if its name is wanted.
int list_part(ListedPanel& listed, const ListedPart& part, const std::string& name, const std::string& wanted) {
    const bool is_wanted = has_all_words(name, wanted);
    if (is_wanted || listed.is_found) listed.parts.push_back(part);
    return is_wanted ? 1 : 0;
}

void list_lines(const sim::Panel& panel, const std::string& wanted, ListedPanel& listed, ObjectTree& tree) {
    for (std::size_t i = 0; i < panel.internal_lines.size(); ++i) {
        const std::string& name = panel.internal_lines[i].name;
        const ListedPart part{.kind = PartKind::InternalLine,
                              .index = static_cast<int>(i),
                              .title = name.empty() ? "Line " + std::to_string(i) : name};
        tree.internal_lines += list_part(listed, part, part.title, wanted);
    }
}

void list_darts(const sim::Pattern& pattern, const std::string& wanted, ListedPanel& listed, ObjectTree& tree) {
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
        const sim::Seam& seam = pattern.seams[s];
        if (seam.first.panel != listed.index || !is_dart(pattern, seam)) continue;
        const std::string title = seam.name.empty() ? "Dart of edges " + std::to_string(seam.first.edge) + " and " +
                                                          std::to_string(seam.second.edge)
                                                    : seam.name;
        const ListedPart part{.kind = PartKind::Dart, .index = static_cast<int>(s), .title = title};
        tree.darts += list_part(listed, part, title + " " + seam_name(pattern, seam), wanted);
    }
}

void list_edges(const sim::Panel& panel, const std::string& wanted, ListedPanel& listed, ObjectTree& tree) {
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        const std::string& label = panel.edges[e].label;
        const std::string title = "Edge " + std::to_string(e) + (label.empty() ? "" : ", " + label);
        const ListedPart part{.kind = PartKind::Edge, .index = static_cast<int>(e), .title = title};
        tree.edges += list_part(listed, part, label, wanted);
    }
}

std::string group_of(const sim::Pattern& pattern, const sim::Panel& panel, PanelGrouping grouping) {
    if (grouping == PanelGrouping::Fabrics) return fabric_of(pattern, panel);
    const std::string& garment = garment_of(pattern, panel);
    return garment.empty() ? "Garment" : garment;
}

// The groups without panels, in their order.
std::vector<PanelGroup> empty_groups(const sim::Pattern& pattern, PanelGrouping grouping) {
    std::vector<std::string> names;
    if (grouping == PanelGrouping::Garments) {
        names = garment_names(pattern);
        std::ranges::reverse(names);
        std::ranges::replace(names, std::string(), std::string("Garment"));
    } else {
        for (const sim::Panel& panel : pattern.panels) names.push_back(fabric_of(pattern, panel));
        std::ranges::sort(names);
        names.erase(std::unique(names.begin(), names.end()), names.end());
    }
    std::vector<PanelGroup> groups;
    for (const std::string& name : names) groups.push_back({.name = name, .panels = {}});
    return groups;
}

std::string counted(int count, const char* one, const char* several) {
    return std::to_string(count) + " " + (count == 1 ? one : several);
}

}  // namespace

bool is_dart(const sim::Pattern& pattern, const sim::Seam& seam) {
    if (seam.first.panel != seam.second.panel) return false;
    const std::vector<sim::OutlineEdge>& edges = panel_of(pattern, seam.first).edges;
    const sim::OutlineEdge& first = edges.at(static_cast<std::size_t>(seam.first.edge));
    const sim::OutlineEdge& second = edges.at(static_cast<std::size_t>(seam.second.edge));
    return first.end == second.start || second.end == first.start;
}

ObjectTree list_objects(const sim::Pattern& pattern, PanelGrouping grouping, const std::string& wanted) {
    ObjectTree tree{.groups = empty_groups(pattern, grouping)};
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const sim::Panel& panel = pattern.panels[p];
        ListedPanel listed{.index = static_cast<int>(p), .is_found = has_all_words(panel.name, wanted)};
        tree.panels += listed.is_found ? 1 : 0;
        list_lines(panel, wanted, listed, tree);
        list_darts(pattern, wanted, listed, tree);
        list_edges(panel, wanted, listed, tree);
        if (!listed.is_found && listed.parts.empty()) continue;
        const auto group = std::ranges::find(tree.groups, group_of(pattern, panel, grouping), &PanelGroup::name);
        if (group != tree.groups.end()) group->panels.push_back(std::move(listed));
    }
    std::erase_if(tree.groups, [](const PanelGroup& group) { return group.panels.empty(); });
    for (const int s : one_of_each_sewing(pattern)) {
        const sim::Seam& seam = pattern.seams[static_cast<std::size_t>(s)];
        if (!is_dart(pattern, seam) && has_all_words(seam.sewing + " " + seam_name(pattern, seam), wanted))
            tree.seams.push_back(s);
    }
    return tree;
}

std::string count_text(const ObjectTree& tree, const std::string& wanted) {
    std::vector<std::string> counts;
    if (tree.panels > 0) counts.push_back(counted(tree.panels, "panel", "panels"));
    if (tree.internal_lines > 0) counts.push_back(counted(tree.internal_lines, "internal line", "internal lines"));
    if (tree.darts > 0) counts.push_back(counted(tree.darts, "dart", "darts"));
    if (tree.edges > 0 && !wanted.empty()) counts.push_back(counted(tree.edges, "edge", "edges"));
    if (tree.found_seams() > 0) counts.push_back(counted(tree.found_seams(), "seam", "seams"));
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        text += (i == 0 ? "" : i + 1 < counts.size() ? ", " : " and ") + counts[i];
    }
    return text;
}

}  // namespace selvedge::editor
