#pragma once
// Hands on a drape: pins hold single vertices where they are, and one vertex may be pulled along.
//
// They hold places of the material; which vertex that is follows anew after each adaptation, for a vertex may be gone.
#include <optional>
#include <span>
#include <vector>

#include "sim/cloth/step.h"
#include "sim/dress/draped_panels.h"

namespace selvedge::sim {

class DragConstraint {
 public:
    void pin(const MaterialPoint& at) { pins_.push_back({.at = at}); }
    void unpin_all() { pins_.clear(); }
    void pull(const MaterialPoint& at, const Vec3f& to);
    bool pull_to(const Vec3f& to);  // false: it is going there already, or pulls nothing
    void let_go() { grip_.reset(); }
    bool is_pulling() const { return grip_.has_value(); }
    bool has_pins() const { return !pins_.empty(); }

    // Each place becomes another: when the pattern under it has changed.
    template <class Map>
    void map_places(const Map& map) {
        for (Held& pin : pins_) pin.at = map(pin.at);
        if (grip_) grip_->held.at = map(grip_->held.at);
    }

    // The cloth is another: which vertices are held is to be found anew, and those of the last are let go by nobody.
    void forget_vertices();

    // Finds the held vertices, and holds and frees what has changed since the last time. base_pins: the pattern's own,
    // base vertices. True if anything has.
    bool take_hold(Cloth& cloth, const std::vector<int>& base_pins);

    // No vertex of this cloth is held, whoever held it.
    void free_all(Cloth& cloth, const std::vector<int>& base_pins);

    // Whether the pull goes elsewhere since this was asked the last time.
    bool take_news();

    std::span<const VertexId> held() const { return held_; }

    // Where the pulled vertex is led in the next seconds: towards its goal, no faster than a hand, not into the body,
    // and no farther than the cloth about it gives.
    std::span<const KinematicVertex> lead(const Cloth& cloth, const Collider& body, float seconds);

    std::vector<Vec3f> pin_positions(const Cloth& cloth) const;  // m

 private:
    struct Held {
        MaterialPoint at;
        VertexId vertex{};
    };
    struct Grip {
        Held held;
        Vec3f goal = Vec3f::Zero();  // m
    };

    std::vector<Held> pins_;
    std::optional<Grip> grip_;
    std::vector<VertexId> held_;  // by pins, then by the grip
    std::vector<KinematicVertex> led_;
    bool has_news_ = false;
};

}  // namespace selvedge::sim
