#include "sim/pattern/garments.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "sim/core/disjoint_sets.h"
#include "sim/core/error.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {
namespace {

using Names = std::set<std::string, std::less<>>;

// The name itself, or else with the prefix, or else with the lowest number that makes it new. Adds it to `taken`.
std::string unique_name(const std::string& name, const std::string& prefix, Names& taken) {
    std::string found = taken.contains(name) && !prefix.empty() ? prefix + "_" + name : name;
    const std::string base = found;
    for (int i = 2; taken.contains(found); ++i) found = base + "_" + std::to_string(i);
    taken.insert(found);
    return found;
}

// Seam names have no comma and no plus sign, and the names of unnamed seams are made of their panels' names.
std::string without_separators(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == ',' || c == '+'; }, '_');
    return name;
}

void name_garments(Pattern& outer, const Pattern& pattern) {
    Names taken;
    for (const std::string& name : garment_names(pattern)) taken.insert(name);
    std::map<std::string, std::string> renamed;
    for (const Garment& garment : garments_of(outer)) renamed[garment.name] = unique_name(garment.name, "", taken);
    for (Panel& panel : outer.panels) panel.garment = renamed[garment_of(outer, panel)];
}

void name_panels(Pattern& outer, const Pattern& pattern) {
    Names taken;
    for (const Panel& panel : pattern.panels) taken.insert(panel.name);
    // Names that are not taken stay, so no new name may be one of them.
    for (const Panel& panel : outer.panels) {
        if (std::ranges::find(pattern.panels, panel.name, &Panel::name) == pattern.panels.end())
            taken.insert(panel.name);
    }
    std::map<std::string, std::string> renamed;
    for (Panel& panel : outer.panels) {
        if (std::ranges::find(pattern.panels, panel.name, &Panel::name) == pattern.panels.end()) continue;
        const std::string was = panel.name;
        panel.name = renamed[was] = unique_name(was, without_separators(panel.garment), taken);
    }
    for (Panel& panel : outer.panels) {
        for (std::string* source : {&panel.mirror_of, &panel.copy_of}) {
            if (const auto found = renamed.find(*source); found != renamed.end()) *source = found->second;
        }
    }
}

void name_seams(Pattern& outer, const Pattern& pattern) {
    Names taken;
    for (const Seam& seam : pattern.seams) taken.insert(seam.name);
    for (Seam& seam : outer.seams) {
        if (seam.name.empty()) continue;
        seam.name = unique_name(seam.name, without_separators(panel_of(outer, seam.first).garment), taken);
    }
    Names sewings;
    for (const Seam& seam : pattern.seams) sewings.insert(seam.sewing);
    std::map<std::string, std::string> renamed;
    for (Seam& seam : outer.seams) {
        if (seam.sewing.empty()) continue;
        const auto [name, is_new] = renamed.try_emplace(seam.sewing);
        if (is_new) name->second = unique_name(seam.sewing, panel_of(outer, seam.first).garment, sewings);
        seam.sewing = name->second;
    }
}

void raise_layers(Pattern& outer, const Pattern& pattern) {
    const auto by_layer = [](const Panel& a, const Panel& b) { return a.layer < b.layer; };
    const int highest = std::ranges::max_element(pattern.panels, by_layer)->layer;
    const int lowest = std::ranges::min_element(outer.panels, by_layer)->layer;
    for (Panel& panel : outer.panels) {
        panel.layer += highest + 1 - lowest;
        if (panel.layer > kHighestLayer) {
            throw InputError("", "layer",
                             "over what is worn, '" + panel.name + "' would be in layer " +
                                 std::to_string(panel.layer) + ": at most " + std::to_string(kHighestLayer));
        }
    }
}

void keep_fabrics(Pattern& outer, const Pattern& pattern) {
    if (outer.fabric == pattern.fabric) return;
    for (Panel& panel : outer.panels) {
        if (panel.fabric.empty()) panel.fabric = outer.fabric.empty() ? Fabric().name : outer.fabric;
    }
}

// What the outer garment shows stays with its panels.
void keep_surfaces(Pattern& outer, const Pattern& pattern) {
    std::optional<SurfaceDesign> shown = outer.surface;
    const bool is_other_tartan =
        outer.tartan != pattern.tartan || outer.sett_size != pattern.sett_size || pattern.surface.has_value();
    if (!shown && is_other_tartan && !outer.tartan.empty())
        shown = SurfaceDesign{.source = outer.tartan, .size = outer.sett_size, .position = outer.sett_position};
    if (!shown || shown == pattern.surface) return;
    for (Panel& panel : outer.panels) {
        if (!panel.surface) panel.surface = shown;
    }
}

std::vector<std::string> note_differences(const Pattern& pattern, const Pattern& outer) {
    std::vector<std::string> notes;
    const auto note = [&](const std::string& what) {
        notes.push_back("'" + outer.name + "' names another " + what + " than '" + pattern.name +
                        "', over which it is worn: that of '" + pattern.name + "' counts");
    };
    if (outer.body != pattern.body || (outer.body.empty() && outer.body_height != pattern.body_height)) note("body");
    if (outer.edge_length != pattern.edge_length) note("edge length");
    return notes;
}

}  // namespace

const std::string& garment_of(const Pattern& pattern, const Panel& panel) {
    return panel.garment.empty() ? pattern.name : panel.garment;
}

std::vector<Garment> garments_of(const Pattern& pattern) {
    std::vector<Garment> garments;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        auto found = std::ranges::find(garments, garment_of(pattern, panel), &Garment::name);
        if (found == garments.end()) {
            garments.push_back({garment_of(pattern, panel), {}, panel.layer, panel.layer});
            found = garments.end() - 1;
        }
        found->panels.push_back(static_cast<int>(p));
        found->lowest_layer = std::min(found->lowest_layer, panel.layer);
        found->highest_layer = std::max(found->highest_layer, panel.layer);
    }
    std::ranges::stable_sort(garments, {}, &Garment::lowest_layer);
    return garments;
}

std::vector<std::string> garment_names(const Pattern& pattern) {
    std::vector<std::string> names;
    for (Garment& garment : garments_of(pattern)) names.push_back(std::move(garment.name));
    return names;
}

std::vector<std::size_t> sewn_parts(const Pattern& pattern) {
    DisjointSets sets(pattern.panels.size());
    for (const Seam& seam : pattern.seams) sets.join(seam.first.panel, seam.second.panel);
    std::vector<std::size_t> parts;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p)
        parts.push_back(static_cast<std::size_t>(sets.find(static_cast<int>(p))));
    return parts;
}

std::vector<std::string> put_over(Pattern& pattern, Pattern outer) {
    if (outer.panels.empty()) return {};
    std::vector<std::string> notes = note_differences(pattern, outer);
    if (pattern.name.empty()) pattern.name = "garment";
    for (Panel& panel : pattern.panels) panel.garment = garment_of(pattern, panel);
    if (!pattern.panels.empty()) raise_layers(outer, pattern);
    name_garments(outer, pattern);
    name_panels(outer, pattern);
    name_seams(outer, pattern);
    keep_fabrics(outer, pattern);
    keep_surfaces(outer, pattern);
    const auto first = static_cast<int>(pattern.panels.size());
    for (Seam& seam : outer.seams) {
        seam.first.panel += first;
        seam.second.panel += first;
        pattern.seams.push_back(std::move(seam));
    }
    for (Panel& panel : outer.panels) {
        panel.sheet_position.reset();  // it would lie on a panel of `pattern`
        pattern.panels.push_back(std::move(panel));
    }
    return notes;
}

bool take_off(Pattern& pattern, std::string_view garment) {
    std::vector<int> moved(pattern.panels.size(), -1);
    std::vector<Panel> stay;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        if (garment_of(pattern, pattern.panels[p]) == garment) continue;
        moved[p] = static_cast<int>(stay.size());
        stay.push_back(pattern.panels[p]);
    }
    if (stay.size() == pattern.panels.size()) return false;
    for (Seam& seam : pattern.seams) {
        for (SeamSide* side : {&seam.first, &seam.second}) side->panel = moved[static_cast<std::size_t>(side->panel)];
    }
    std::erase_if(pattern.seams, [](const Seam& seam) { return seam.first.panel < 0 || seam.second.panel < 0; });
    for (Panel& panel : stay) {
        for (std::string* source : {&panel.mirror_of, &panel.copy_of}) {
            if (std::ranges::find(stay, *source, &Panel::name) == stay.end()) source->clear();
        }
    }
    pattern.panels = std::move(stay);
    return true;
}

}  // namespace selvedge::sim
