#include "sim/paper/upright_panels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/paper/outline_place.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

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
    for (Panel& panel : panels) {
        if (std::abs(panel.grain_angle) > 0.01 && !is_strip_of_cloth(panel))
            panel = mapped_panel(panel, turned_by(-panel.grain_angle));
    }
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
