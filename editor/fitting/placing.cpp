#include "editor/fitting/placing.h"

#include <utility>

#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

Command place_command(const std::vector<Panel>& panels) {
    PlacePanels all;
    for (const Panel& panel : panels) {
        all.places.push_back({.panel = panel.name,
                              .translation = panel.translation,
                              .rotation = panel.rotation,
                              .wrap_radius = panel.wrap_radius});
    }
    if (all.places.size() > 1) return all;
    PanelPlace& one = all.places.front();
    return PlacePanel{.panel = std::move(one.panel),
                      .translation = one.translation,
                      .rotation = one.rotation,
                      .wrap_radius = one.wrap_radius};
}

}  // namespace

std::vector<Panel> panels_of(const Pattern& pattern, const std::set<std::string>& names) {
    std::vector<Panel> panels;
    for (const Panel& panel : pattern.panels) {
        if (names.contains(panel.name)) panels.push_back(panel);
    }
    return panels;
}

std::vector<Vec3f> placed_outline(const Panel& panel) {
    constexpr double kChordError = 0.001;  // m
    constexpr double kLongestPart = 0.03;  // m: a bent panel's straight edge is a curve in the room
    std::vector<Vec3f> path;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, kChordError);
        for (std::size_t i = 1; i < line.size(); ++i) {
            const int parts = 1 + static_cast<int>((line[i] - line[i - 1]).norm() / kLongestPart);
            for (int part = 0; part < parts; ++part) {
                const Vec2d u = line[i - 1] + (line[i] - line[i - 1]) * (double(part) / parts);
                path.push_back(panel.place(u).cast<float>());
            }
        }
    }
    if (!path.empty()) path.push_back(path.front());
    return path;
}

Vec3d placed_centre(const std::vector<Panel>& panels) {
    Eigen::AlignedBox3d box;
    for (const Panel& panel : panels) {
        for (const Vec3f& x : placed_outline(panel)) box.extend(x.cast<double>());
    }
    return box.isEmpty() ? panels.front().translation : Vec3d(box.center());
}

Command move_command(const std::vector<Panel>& panels, const RigidMotion& motion) {
    std::vector<Panel> moved = panels;
    for (Panel& panel : moved) {
        panel.translation = motion.centre + motion.turn * (panel.translation - motion.centre) + motion.shift;
        panel.rotation = Eigen::Quaterniond(motion.turn * panel.rotation).normalized().toRotationMatrix();
    }
    return place_command(moved);
}

Command arrange_command(std::vector<Panel> panels, const ArrangementPoint& point) {
    for (Panel& panel : panels) arrange(panel, point);
    return place_command(panels);
}

}  // namespace selvedge
