// Implements symmetric_copies of panel_edit.h: mirror images of panels, sewn as their originals.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

// left_sleeve for right_sleeve and vice versa; other names unchanged.
std::string name_across(const std::string& name) {
    for (const auto& [one, other] : {std::pair<std::string, std::string>{"left", "right"}, {"right", "left"}}) {
        const std::size_t at = name.find(one);
        if (at != std::string::npos) return name.substr(0, at) + other + name.substr(at + one.size());
    }
    return name;
}

// Whether the panel crosses the middle of the body and faces to the front or the back: the plane x = 0 passes through
// the middle half of its width, and it is turned by less than 15 degrees from that plane's normal.
bool stands_in_the_middle(const sim::Panel& panel) {
    constexpr double kCosOfTurn = 0.966;
    const Eigen::AlignedBox2d box = outline_box(panel);
    return std::abs(panel.place(box.center()).x()) < box.sizes().x() / 4 && std::abs(panel.rotation(0, 0)) > kCosOfTurn;
}

// The edge that is the mirror image of `edge` on the other half of the panel. None: there is no such edge.
std::optional<int> edge_across(const sim::Panel& panel, int edge) {
    constexpr double kAlike = 0.001;  // m
    const double middle = outline_box(panel).center().x();
    const auto is_image = [&](const sim::OutlineEdge& other) {
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Vec2d own = outline_point(panel, panel.edges[as_size(edge)], t);
            const Vec2d image(2 * middle - own.x(), own.y());
            if ((outline_point(panel, other, 1 - t) - image).norm() > kAlike) return false;
        }
        return true;
    };
    const auto found = std::find_if(panel.edges.begin(), panel.edges.end(), is_image);
    if (found == panel.edges.end()) return {};
    return static_cast<int>(found - panel.edges.begin());
}

// Sews copies on the other side of the body as their originals are sewn on theirs. `copies`: the copy of each original.
class SeamMirror {
 public:
    SeamMirror(sim::Pattern& draft, const std::map<int, int>& copies) : draft_(draft), copies_(copies) {}

    void mirror() {
        const std::vector<sim::Seam> seams = draft_.seams;
        for (const sim::Seam& seam : seams) {
            if (!copies_.contains(seam.first.panel) && !copies_.contains(seam.second.panel)) continue;
            const std::optional<sim::SeamSide> first = across(seam.first), second = across(seam.second);
            if (!first || !second || *first == *second) continue;
            if (seam_at(draft_, *first) || seam_at(draft_, *second)) continue;
            sim::Seam& image = draft_.seams.emplace_back(sim::copy_of(seam));
            image.first = *first;
            image.second = *second;
            image.sewing = seam.sewing;
        }
        separate_sewings(draft_, seams.size());
    }

 private:
    std::optional<sim::SeamSide> across(const sim::SeamSide& side) const {
        const sim::Panel& panel = draft_.panels[as_size(side.panel)];
        const auto copy = copies_.find(side.panel);
        const std::optional<int> image = copy != copies_.end() ? copy->second : linked_image(side.panel);
        if (image) return sim::SeamSide{*image, sim::mirrored_edge(side.edge, edge_count(panel))};
        if (!stands_in_the_middle(panel)) return {};
        const std::optional<int> edge = edge_across(panel, side.edge);
        if (!edge) return {};
        return sim::SeamSide{side.panel, *edge};
    }

    std::optional<int> linked_image(int panel) const {
        const sim::Panel& own = draft_.panels[as_size(panel)];
        for (std::size_t i = 0; i < draft_.panels.size(); ++i) {
            const sim::Panel& other = draft_.panels[i];
            const bool is_image = other.mirror_of == own.name || own.mirror_of == other.name;
            if (is_image && edge_count(other) == edge_count(own)) return static_cast<int>(i);
        }
        return {};
    }

    sim::Pattern& draft_;
    const std::map<int, int>& copies_;
};

}  // namespace

std::vector<int> symmetric_copies(sim::Pattern& pattern, const std::vector<int>& panels, bool is_linked,
                                  const Vec2d& shift) {
    for (const int panel : panels) {
        const sim::Panel& own = panel_of(pattern, panel);
        if (!is_linked || own.mirror_of.empty()) continue;
        throw GeometryError("Panel " + own.name + " is kept a mirror image of " + own.mirror_of + " already.",
                            {{own.name, -1, -1}, {own.mirror_of, -1, -1}});
    }
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    Eigen::AlignedBox1d across;  // of the panels on the sheet
    for (const int panel : panels) {
        const Eigen::AlignedBox2d box = outline_box(panel_of(pattern, panel));
        const double origin = positions[as_size(panel)].x();
        across.extend(Eigen::AlignedBox1d(origin + box.min().x(), origin + box.max().x()));
    }
    return edit_pattern(pattern, [&](sim::Pattern& draft) {
        std::vector<int> added;
        std::map<int, int> copies;
        for (const int panel : panels) {
            if (is_linked) give_keys(draft.panels[as_size(panel)]);
            const sim::Panel own = draft.panels[as_size(panel)];
            sim::Panel image = mirror_image(own);
            image.copy_of.clear();
            image.name = free_panel_name(draft, name_across(own.name));
            image.mirror_of = is_linked ? own.name : "";
            const Vec2d& position = positions[as_size(panel)];
            image.sheet_position = Vec2d(across.min()[0] + across.max()[0] - position.x(), position.y()) + shift;
            added.push_back(static_cast<int>(draft.panels.size()));
            copies.emplace(panel, added.back());
            draft.panels.push_back(std::move(image));
        }
        SeamMirror(draft, copies).mirror();
        return added;
    });
}

}  // namespace selvedge::editor
