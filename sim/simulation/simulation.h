#pragma once
// The simulation of a garment: its cloth, its further constraints, and what is common to all its steps and adaptations.
// Sewing, draping, motion, the measurement of pressure and the change of a pattern are schedules over it
// (sim/simulation/schedule.h).
//
// StepOptions and AdaptClothOptions are made here only.
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/adaptive/back_face.h"
#include "sim/adaptive/triangle_budget.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/strain_projection.h"
#include "sim/simulation/cloth_constraint.h"
#include "sim/simulation/schedule.h"

namespace selvedge::sim {

struct SimulationOptions {
    Vec3f gravity = StepOptions{}.gravity;  // m/s^2
    ContactOptions contact{};
    std::optional<SelfContactOptions> self_contact{};  // none: cloth passes through itself
    AdaptClothOptions adapt{};             // its budget, visibility and kept vertices are the simulation's own
    std::optional<int> triangle_budget{};  // target number of leaf triangles; none: no limit
    std::optional<Vec3f> seen_from{};      // unit, to a viewer: coarse where cloth faces away; none: nowhere
};

class Simulation {
 public:
    // Where vertices that are led will be after that many seconds. Valid until the next call.
    using Lead = std::function<std::span<const KinematicVertex>(const Cloth& cloth, float seconds)>;

    explicit Simulation(Cloth cloth, const SimulationOptions& options = {});
    // A copy goes on by itself, as after release().
    Simulation(const Simulation& other);
    Simulation& operator=(const Simulation& other);
    Simulation(Simulation&&) noexcept = default;
    Simulation& operator=(Simulation&&) noexcept = default;
    ~Simulation() = default;

    const Cloth& cloth() const { return cloth_; }
    // To change its state. What constraints are made from (mesh, pins, fabrics, masses, sub-steps) changes only with
    // refresh_solver(), which counts as an adaptation, so that they are made anew. A whole other cloth is another
    // Simulation.
    Cloth& cloth() { return cloth_; }

    const SimulationOptions& options() const { return options_; }
    void set_options(const SimulationOptions& options);

    // Instead of those that there were. Cloth at rest goes on.
    void set_constraints(ClothConstraints constraints);

    // Hidden parts of the cloth are coarsened; null: as the options say. It must stay valid.
    void set_visibility(Visibility* visibility) { visibility_ = visibility; }
    // Vertices that no adaptation removes, such as those that the user has pinned.
    void keep(std::span<const VertexId> vertices) { kept_.assign(vertices.begin(), vertices.end()); }
    // Asked before each step. What it refers to must stay valid.
    void lead(Lead lead) { lead_ = std::move(lead); }
    // Afterwards no vertices are kept or led, and only the viewer of the options sees it.
    void release();

    // One adaptation, and one step. Pre (step): the contacts are those of the present leaves, after adapt() or
    // refresh_contacts() with contact().
    AdaptReport adapt(const Collider& body, const Schedule& schedule);
    StepReport step(const Collider& body, const Schedule& schedule);
    // Onto the fabrics' strain limits, without time (sim/cloth/strain_projection.h).
    StrainProjectionReport project(const Collider& body, const Schedule& schedule);

    ContactOptions contact(const Schedule& schedule) const;
    float step_seconds(const Schedule& schedule) const;  // s, simulated

 private:
    StepOptions step_options(const Schedule& schedule) const;
    AdaptClothOptions adapt_options(const Schedule& schedule);
    void make_constraints();

    Cloth cloth_;
    SimulationOptions options_;
    ClothConstraints constraints_;
    std::optional<std::uint32_t> made_for_;  // Cloth::adaptations that the constraints know; none: they are to be made
    std::optional<TriangleBudget> budget_;
    std::optional<Visibility> own_visibility_;  // for SimulationOptions::seen_from
    Visibility* visibility_ = nullptr;          // instead of the own one
    std::vector<VertexId> kept_;
    Lead lead_;
};

}  // namespace selvedge::sim
