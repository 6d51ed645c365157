#include "sim/place/panel_flanks.h"

#include <algorithm>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// How far the middle of the edge lies to the right of the middle of its panel, m.
double off_axis(const Pattern& pattern, const SeamSide& side) {
    return middle_of_edge(pattern, side).x() - outline_box(panel_of(pattern, side), 1e-3).center().x();
}

bool is_half(const Pattern& pattern, const std::vector<PanelRole>& roles, std::size_t p) {
    if (roles[p].flank != Flank::None) return true;
    const Panel& own = pattern.panels[p];
    return std::ranges::any_of(pattern.panels, [&](const Panel& other) { return are_mirror_images(own, other); });
}

Flank flank_of_partners(const Pattern& pattern, const SewnEdges& sewn, const std::vector<PanelRole>& roles,
                        std::size_t p) {
    double left = 0;
    for (const SewnEdge& edge : sewn[p]) {
        const PanelRole& other = roles[as_size(edge.panel)];
        if (as_size(edge.panel) == p) continue;
        if (other.flank != Flank::None) {
            left += other.flank == Flank::Left ? 1 : -1;
        } else if (other.face != Face::None && !is_half(pattern, roles, as_size(edge.panel))) {
            const double x = off_axis(pattern, edge.other);
            if (x != 0) left += (x > 0) == (other.face == Face::Front) ? 1 : -1;
        }
    }
    return left > 0 ? Flank::Left : left < 0 ? Flank::Right : Flank::None;
}

}  // namespace

SewnEdges sewn_edges(const Pattern& pattern) {
    SewnEdges sewn(pattern.panels.size());
    for (const Seam& seam : pattern.seams) {
        sewn[as_size(seam.first.panel)].push_back({seam.second.panel, seam.first, seam.second, seam.is_reversed});
        sewn[as_size(seam.second.panel)].push_back({seam.first.panel, seam.second, seam.first, seam.is_reversed});
    }
    return sewn;
}

Vec2d middle_of_edge(const Pattern& pattern, const SeamSide& side) {
    const Panel& own = panel_of(pattern, side);
    return outline_point(own, own.edges[as_size(side.edge)], 0.5);
}

double middle_side(const Pattern& pattern, const SewnEdges& sewn, const std::vector<PanelRole>& roles, std::size_t p) {
    double to_twin = 0, to_other_face = 0;
    const double axis = outline_box(pattern.panels[p], 1e-3).center().x();
    for (const SewnEdge& edge : sewn[p]) {
        const PanelRole& other = roles[as_size(edge.panel)];
        const double x = middle_of_edge(pattern, edge.own).x() - axis;
        if (are_mirror_images(pattern.panels[p], pattern.panels[as_size(edge.panel)])) to_twin += x;
        if (other.part == roles[p].part && other.face != roles[p].face) to_other_face += x;
    }
    if (to_twin != 0) return to_twin < 0 ? -1 : 1;
    if (roles[p].part != GarmentPart::Leg && to_other_face != 0) return to_other_face < 0 ? 1 : -1;
    return 0;
}

void find_flanks(const Pattern& pattern, const SewnEdges& sewn, std::vector<PanelRole>& roles) {
    for (std::size_t p = 0; p < roles.size(); ++p) {
        PanelRole& role = roles[p];
        if (role.flank != Flank::None || !is_half(pattern, roles, p) || role.face == Face::None) continue;
        // Neither half of a sleeve has an edge in the middle of the body.
        if (role.part == GarmentPart::Sleeve || role.part == GarmentPart::Cuff) continue;
        const double side = middle_side(pattern, sewn, roles, p);
        if (side == 0) continue;
        // Seen from outside, a front's right is the wearer's left.
        role.flank = (side < 0) == (role.face == Face::Front) ? Flank::Left : Flank::Right;
    }
    // Others take the side of what they are sewn to, in as many steps as it needs.
    for (int step = 0; step < 4; ++step) {
        for (std::size_t p = 0; p < roles.size(); ++p) {
            if (roles[p].flank == Flank::None && is_half(pattern, roles, p))
                roles[p].flank = flank_of_partners(pattern, sewn, roles, p);
        }
    }
}

void label_panels(Pattern& pattern, const SewnEdges& sewn, const std::vector<PanelRole>& roles) {
    using enum GarmentPart;
    for (std::size_t p = 0; p < roles.size(); ++p) {
        const GarmentPart part = roles[p].part;
        const bool is_of_leg =
            std::ranges::any_of(sewn[p], [&](const SewnEdge& edge) { return roles[as_size(edge.panel)].part == Leg; });
        std::string& label = pattern.panels[p].label;
        if (part == Sleeve || (part == Cuff && !is_of_leg)) label = "arm";
        if (part == Leg || part == Skirt || (part == Cuff && is_of_leg)) label = "leg";
        if (part == Torso) label = "body";
    }
}

}  // namespace selvedge::sim
