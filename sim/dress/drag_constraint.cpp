#include "sim/dress/drag_constraint.h"

#include <algorithm>
#include <utility>

#include "sim/cloth/contact.h"
#include "sim/collide/collider.h"

namespace selvedge::sim {
namespace {

// Chosen by experiment.
constexpr float kFastest = 1.5F;  // m/s, maximum speed of the dragged vertex
constexpr float kApproach = 12;   // 1/s: it slows down near the goal
constexpr float kGives = 0.02F;   // strain of adjacent edges at which the drag begins to slow down ...
constexpr float kHolds = 0.08F;   // ... and at which it stops

// Pins the pattern's base vertices, split vertices between two pinned ones (the rule of on_split), and the held
// vertices.
void refresh_pins(Cloth& cloth, const std::vector<int>& base_pins, const std::vector<VertexId>& held) {
    std::fill(cloth.is_pinned.begin(), cloth.is_pinned.end(), false);
    for (const int pin : base_pins) cloth.is_pinned[static_cast<std::size_t>(pin)] = true;
    std::vector<VertexId> inner;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.mesh.vertex(v).parent) inner.push_back(v);
    }
    std::ranges::stable_sort(inner, {}, [&](VertexId v) { return cloth.mesh.vertex(v).level; });
    for (const VertexId v : inner) {
        const AdaptiveEdge& edge = cloth.mesh.edge(cloth.mesh.vertex(v).parent);
        cloth.is_pinned[v.value] = cloth.is_pinned[edge.ends[0].value] && cloth.is_pinned[edge.ends[1].value];
    }
    for (const VertexId v : held) {
        cloth.is_pinned[v.value] = true;
        cloth.x_prev[v.value] = cloth.x[v.value];
    }
    refresh_solver(cloth);
}

// The fraction of a drag move that the strain of the adjacent cloth allows: 1 while it is loose, 0 at the strain
// kHolds, negative (back) above it.
float share_of_way(const Cloth& cloth, VertexId v, const Vec3f& way) {
    const Vec3f x = cloth.x[v.value].head<3>();
    float share = 1;
    for (const TriangleId t : cloth.mesh.triangles_at(v)) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        const std::size_t k = corner_at(triangle, v);
        for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
            const Vec3f arm = x - cloth.x[triangle.vertices[other].value].head<3>();
            const float rest = (triangle.u[other] - triangle.u[k]).norm();
            const float strain = arm.norm() / std::max(rest, 1e-6F) - 1;
            if (arm.dot(way) <= 0) continue;  // the move does not lengthen it
            share = std::min(share, (kHolds - strain) / (kHolds - kGives));
        }
    }
    return std::clamp(share, -0.2F, 1.0F);
}

}  // namespace

void DragConstraint::pull(const MaterialPoint& at, const Vec3f& to) {
    drag_ = Drag{.held = {.at = at}, .goal = to};
    goal_has_changed_ = true;
}

bool DragConstraint::pull_to(const Vec3f& to) {
    if (!drag_ || drag_->goal == to) return false;
    drag_->goal = to;
    goal_has_changed_ = true;
    return true;
}

void DragConstraint::forget_vertices() {
    held_.clear();
    for (Anchor& pin : pins_) pin.vertex = {};
    if (drag_) drag_->held.vertex = {};
}

bool DragConstraint::update_held(Cloth& cloth, const std::vector<int>& base_pins) {
    if (pins_.empty() && !drag_ && held_.empty()) return false;
    const DrapedPanels draped(cloth);
    const std::vector<VertexId> before = held_;
    held_.clear();
    const auto find = [&](Anchor& held) {
        const bool is_new = !held.vertex;
        held.vertex = draped.nearest_vertex(held.at);
        if (!held.vertex) return;
        if (is_new) held.at = DrapedPanels::place_of(cloth, held.vertex, held.at.panel);
        held_.push_back(held.vertex);
    };
    for (Anchor& pin : pins_) find(pin);
    if (drag_) find(drag_->held);
    if (held_ == before) return false;
    refresh_pins(cloth, base_pins, held_);
    return true;
}

void DragConstraint::free_all(Cloth& cloth, const std::vector<int>& base_pins) {
    *this = {};
    refresh_pins(cloth, base_pins, held_);
}

bool DragConstraint::take_goal_change() {
    return std::exchange(goal_has_changed_, false);
}

std::span<const KinematicVertex> DragConstraint::kinematic_target(const Cloth& cloth, const Collider& body,
                                                                  float seconds) {
    kinematic_.clear();
    if (!drag_ || !drag_->held.vertex) return kinematic_;
    const VertexId v = drag_->held.vertex;
    const Vec3f x = cloth.x[v.value].head<3>();
    Vec3f way = (drag_->goal - x) * std::min(1.0F, kApproach * seconds);
    const float most = kFastest * seconds;
    if (way.norm() > most) way *= most / way.norm();
    Vec3f to = outside(x + way * share_of_way(cloth, v, way), cloth.normals[v.value], body, ContactOptions{}.offset);
    to.y() = std::max(to.y(), ContactOptions{}.floor + ContactOptions{}.offset);
    // A projection that would jump around a limb is rejected: the vertex stays.
    if ((to - x).norm() > 2 * most) to = x;
    kinematic_.push_back({.vertex = v.value, .to = to});
    return kinematic_;
}

std::vector<Vec3f> DragConstraint::pin_positions(const Cloth& cloth) const {
    std::vector<Vec3f> positions;
    for (const Anchor& pin : pins_) {
        if (pin.vertex) positions.emplace_back(cloth.x[pin.vertex.value].head<3>());
    }
    return positions;
}

}  // namespace selvedge::sim
