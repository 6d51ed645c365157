#include "sim/paper/upright_panels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/paper/outline_place.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/shape_role.h"

namespace selvedge::sim {
namespace {

Eigen::Affine2d turned_by(double angle) {
    return Eigen::Affine2d(Eigen::Rotation2Dd(angle));
}

bool is_strip_of_cloth(const Panel& panel) {
    constexpr double kStrip = 2.5, kWidest = 0.15;  // m: waistbands and bindings; a half front is wider
    const Vec2d size = outline_box(panel, 1e-3).sizes();
    return size.maxCoeff() > kStrip * size.minCoeff() && size.minCoeff() < kWidest;
}

// How much wider the cloth is at the lower end of the panel than at the upper one, m.
double widening(const Panel& panel) {
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const double band = 0.1 * box.sizes().y();
    Eigen::AlignedBox2d low, high;
    for (const OutlineEdge& edge : panel.edges) {
        for (const Vec2d& p : outline_polyline(panel, edge, 1e-3)) {
            if (p.y() < box.min().y() + band) low.extend(p);
            if (p.y() > box.max().y() - band) high.extend(p);
        }
    }
    return low.sizes().x() - high.sizes().x();
}

// What each panel looks like as it stands, unless its name says otherwise.
std::vector<GarmentPart> likely_parts(const Pattern& pattern) {
    const std::vector<PanelRole> roles = roles_by_shape(pattern);
    std::vector<GarmentPart> parts;
    for (std::size_t p = 0; p < roles.size(); ++p) {
        GarmentPart part = roles[p].part;
        if (part == GarmentPart::Unknown && looks_like_whole_leg(pattern.panels[p])) part = GarmentPart::Leg;
        const PanelRole named = role_of_name(pattern.panels[p].name);
        const bool is_named = named.part != GarmentPart::Unknown;
        const bool is_face = named.face != Face::None && part == GarmentPart::Sleeve;  // of a torso, a skirt or a leg
        parts.push_back((is_named && part != named.part) || is_face ? GarmentPart::Unknown : part);
    }
    return parts;
}

// Which of the panels are upside down. Each tells itself: a leg or sleeve by its shape; others where they widen to one
// end, else by their shape too. Those that do not tell follow the most cloth of the others.
std::vector<bool> are_upside_down(const std::vector<Panel>& panels) {
    constexpr double kWidens = 0.1;  // of the width
    Pattern as_is, turned;
    for (const Panel& panel : panels) {
        as_is.panels.push_back(panel);
        turned.panels.push_back(mapped_panel(panel, turned_by(std::numbers::pi)));
    }
    const std::vector<GarmentPart> parts = likely_parts(as_is), turned_parts = likely_parts(turned);
    std::vector<double> up;  // of each panel; negative: it is upside down
    double all = 0;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const auto is_any = [&](GarmentPart part) { return parts[p] == part || turned_parts[p] == part; };
        const double widens = widening(panels[p]) / outline_box(panels[p], 1e-3).sizes().x();
        const bool is_limb = is_any(GarmentPart::Leg) || is_any(GarmentPart::Sleeve);
        const double by_shape =
            double(parts[p] != GarmentPart::Unknown) - double(turned_parts[p] != GarmentPart::Unknown);
        up.push_back(!is_limb && std::abs(widens) > kWidens ? widens : by_shape);
        all += outline_area(panels[p]) * std::clamp(up[p], -1.0, 1.0);
    }
    std::vector<bool> upside_down;
    for (const double one : up) upside_down.push_back(one != 0 ? one < 0 : all < 0);
    return upside_down;
}

// A grain that lies level in the drawing does not tell which of its ends is up.
void turn_by_grain(std::vector<Panel>& panels) {
    constexpr double kAcross = 0.25 * std::numbers::pi;  // rad: nearer to level than to upright
    std::vector<std::size_t> across;
    std::vector<Panel> turned;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const double angle = panels[p].grain_angle;
        if (std::abs(angle) <= 0.01 || is_strip_of_cloth(panels[p])) continue;
        panels[p] = mapped_panel(panels[p], turned_by(-angle));
        if (std::abs(angle) <= kAcross) continue;
        across.push_back(p);
        turned.push_back(panels[p]);
    }
    const std::vector<bool> upside_down = are_upside_down(turned);
    for (std::size_t i = 0; i < across.size(); ++i)
        if (upside_down[i]) panels[across[i]] = mapped_panel(turned[i], turned_by(std::numbers::pi));
}

}  // namespace

bool is_mirrored_in_itself(const Panel& panel, Eigen::Index axis) {
    constexpr double kNear = 0.004;  // m
    const Vec2d middle = outline_box(panel, 1e-3).center();
    return std::ranges::all_of(panel.edges, [&](const OutlineEdge& edge) {
        Vec2d image = outline_point(panel, edge, 0.3);
        image[axis] = 2 * middle[axis] - image[axis];
        return nearest_place(panel, image).distance < kNear;
    });
}

bool turn_upright(std::vector<Panel>& panels) {
    turn_by_grain(panels);
    double sideways = 0, upright = 0, up = 0;
    for (const Panel& panel : panels) {
        const bool across = is_mirrored_in_itself(panel, 0), along = is_mirrored_in_itself(panel, 1);
        if (is_strip_of_cloth(panel) || across == along || panel.grain_angle != 0) continue;
        const double area = outline_area(panel);
        (along ? sideways : upright) += area;
        if (along) up += area * widening(mapped_panel(panel, turned_by(std::numbers::pi / 2)));
    }
    if (sideways <= upright) return false;
    for (Panel& panel : panels) {
        panel = mapped_panel(panel, turned_by((up > 0 ? 1 : -1) * std::numbers::pi / 2));
        panel.grain_angle = 0;
    }
    return true;
}

}  // namespace selvedge::sim
