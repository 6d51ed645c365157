#include "editor/document/pattern_patch.h"

#include <algorithm>

namespace selvedge {
namespace {

// All but panels and seams.
Pattern rest_of(const Pattern& pattern) {
    Pattern rest;
    rest.name = pattern.name;
    rest.fabric = pattern.fabric;
    rest.tartan = pattern.tartan;
    rest.sett_size = pattern.sett_size;
    rest.sett_position = pattern.sett_position;
    rest.matched_sett = pattern.matched_sett;
    rest.body = pattern.body;
    rest.body_height = pattern.body_height;
    rest.edge_length = pattern.edge_length;
    return rest;
}

void replace(std::vector<Panel>& panels, std::size_t first, std::size_t count, const std::vector<Panel>& by) {
    const auto begin = panels.begin() + static_cast<std::ptrdiff_t>(first);
    panels.insert(panels.erase(begin, begin + static_cast<std::ptrdiff_t>(count)), by.begin(), by.end());
}

void replace_rest(Pattern& pattern, Pattern rest) {
    rest.panels = std::move(pattern.panels);
    rest.seams = std::move(pattern.seams);
    pattern = std::move(rest);
}

}  // namespace

PatternPatch difference(const Pattern& before, const Pattern& after) {
    PatternPatch patch;
    const std::vector<Panel>& a = before.panels;
    const std::vector<Panel>& b = after.panels;
    const std::size_t least = std::min(a.size(), b.size());
    while (patch.first_panel < least && a[patch.first_panel] == b[patch.first_panel]) ++patch.first_panel;
    std::size_t last = 0;  // so many at the end are the same
    while (last < least - patch.first_panel && a[a.size() - 1 - last] == b[b.size() - 1 - last]) ++last;
    const auto middle = [&](const std::vector<Panel>& panels) {
        return std::vector<Panel>(panels.begin() + static_cast<std::ptrdiff_t>(patch.first_panel),
                                  panels.end() - static_cast<std::ptrdiff_t>(last));
    };
    patch.panels_before = middle(a);
    patch.panels_after = middle(b);
    if (before.seams != after.seams) patch.seams.emplace(before.seams, after.seams);
    Pattern rest_before = rest_of(before);
    Pattern rest_after = rest_of(after);
    if (!(rest_before == rest_after)) patch.rest.emplace(std::move(rest_before), std::move(rest_after));
    return patch;
}

void apply(Pattern& pattern, const PatternPatch& patch) {
    replace(pattern.panels, patch.first_panel, patch.panels_before.size(), patch.panels_after);
    if (patch.seams) pattern.seams = patch.seams->second;
    if (patch.rest) replace_rest(pattern, patch.rest->second);
}

void undo(Pattern& pattern, const PatternPatch& patch) {
    replace(pattern.panels, patch.first_panel, patch.panels_after.size(), patch.panels_before);
    if (patch.seams) pattern.seams = patch.seams->first;
    if (patch.rest) replace_rest(pattern, patch.rest->first);
}

}  // namespace selvedge
