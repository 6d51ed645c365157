#include "sim/place/free_place.h"

#include <algorithm>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/free_room.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// Of the panel as it is placed, from points of its outline: between them a bent edge bulges out by under 1 mm if it is
// wrapped round an arm. A bent panel lies within the box of its outline, because it is straight along its axis.
Eigen::AlignedBox3d placed_box(const Panel& panel) {
    constexpr int kSamples = 16;  // per edge: of a bent edge or of one that is wrapped round a limb
    Eigen::AlignedBox3d box;
    for (const OutlineEdge& edge : panel.edges) {
        for (int i = 0; i < kSamples; ++i)
            box.extend(panel.place(outline_point(panel, edge, static_cast<double>(i) / kSamples)));
    }
    return box;
}

// What the panels must be moved past, along x.
class Obstacles {
 public:
    explicit Obstacles(const Eigen::AlignedBox3d& moved) : moved_(moved) {}

    void add(const Eigen::AlignedBox3d& box) {
        for (const int axis : {1, 2}) {
            if (box.min()[axis] >= moved_.max()[axis] + kFreeGap || box.max()[axis] <= moved_.min()[axis] - kFreeGap)
                return;
        }
        taken_.push_back(moves_onto({moved_.min().x(), moved_.max().x()}, {box.min().x(), box.max().x()}, kFreeGap));
    }

    double way_past() const { return nearest_free_move(taken_, MoveWay::Either); }

 private:
    Eigen::AlignedBox3d moved_;
    std::vector<TakenMoves> taken_;
};

}  // namespace

Vec3d free_move(const Pattern& pattern, const std::vector<Panel>& panels, const Body* body) {
    Eigen::AlignedBox3d moved;
    for (const Panel& panel : panels) moved.extend(placed_box(panel));
    if (moved.isEmpty()) return Vec3d::Zero();
    Obstacles obstacles(moved);
    for (const Panel& panel : pattern.panels) {
        const Eigen::AlignedBox3d box = placed_box(panel);
        if (!box.isEmpty()) obstacles.add(box);
    }
    if (body != nullptr) {
        for (const auto& triangle : body->triangles) {
            Eigen::AlignedBox3d box;
            for (const int vertex : triangle) box.extend(body->x[static_cast<std::size_t>(vertex)]);
            obstacles.add(box);
        }
    }
    return {obstacles.way_past(), 0, 0};
}

void place_freely(Panel& panel, const Pattern& pattern, const Body* body) {
    constexpr double kChest = 0.7;    // fraction of the stature
    constexpr double kBefore = 0.35;  // m, in front of the body's centre, at least
    double before = kBefore;
    if (body != nullptr) {
        for (const Vec3d& x : body->x) before = std::max(before, x.z() + 2 * kFreeGap);
    }
    panel.rotation = Eigen::Matrix3d::Identity();
    panel.wrap_radius = 0;
    panel.wrap_cone.reset();
    panel.translation = Vec3d::Zero();
    const Vec3d centre = panel.place(outline_box(panel).center());
    panel.translation = Vec3d(0, kChest * pattern.body_height, before) - centre;
    panel.translation += free_move(pattern, {panel}, body);
}

}  // namespace selvedge::sim
