#pragma once
// User constraints on a drape: pins hold vertices in place, and one vertex can be dragged.
//
// Constraints are stored as material points. After each adaptation the nearest leaf vertex is found again, because the
// previous one may have been removed.
#include <optional>
#include <span>
#include <vector>

#include "sim/cloth/step.h"
#include "sim/dress/carry_over.h"

namespace selvedge::sim {

class DragConstraint {
 public:
    void pin(const MaterialPoint& at) { pins_.push_back({.at = at}); }
    void unpin_all() { pins_.clear(); }
    void pull(const MaterialPoint& at, const Vec3f& to);
    bool pull_to(const Vec3f& to);  // false: no change of the goal, or nothing is dragged
    void let_go() { drag_.reset(); }
    bool is_pulling() const { return drag_.has_value(); }
    bool has_pins() const { return !pins_.empty(); }

    // Maps all stored material points, after the pattern has changed.
    template <class Map>
    void map_anchors(const Map& map) {
        for (Anchor& pin : pins_) pin.at = map(pin.at);
        if (drag_) drag_->held.at = map(drag_->held.at);
    }

    // Call when the cloth was replaced: clears the held vertices, without unpinning those of the old cloth.
    void forget_vertices();

    // Finds the held vertices again and updates the cloth's pinned vertices. base_pins: base vertices that the pattern
    // pins. Returns whether the held vertices changed.
    bool update_held(Cloth& cloth, const std::vector<int>& base_pins);

    // Removes all constraints, and unpins all vertices of this cloth except base_pins.
    void free_all(Cloth& cloth, const std::vector<int>& base_pins);

    // Whether the goal of the drag has changed since the last call.
    bool take_goal_change();

    std::span<const VertexId> held() const { return held_; }

    // Target of the dragged vertex for the next `seconds`: towards the goal, at most 1.5 m/s, outside the body, and
    // limited by the strain of the adjacent cloth.
    std::span<const KinematicVertex> kinematic_target(const Cloth& cloth, const Collider& body, float seconds);

    std::vector<Vec3f> pin_positions(const Cloth& cloth) const;  // m

 private:
    struct Anchor {
        MaterialPoint at;
        VertexId vertex{};
    };
    struct Drag {
        Anchor held;
        Vec3f goal = Vec3f::Zero();  // m
    };

    std::vector<Anchor> pins_;
    std::optional<Drag> drag_;
    std::vector<VertexId> held_;  // of the pins, then of the drag
    std::vector<KinematicVertex> kinematic_;
    bool goal_has_changed_ = false;
};

}  // namespace selvedge::sim
