#include "sim/simulation/simulation.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "sim/cloth/resting.h"
#include "sim/collide/collider.h"
#include "sim/core/view_point.h"

namespace selvedge::sim {
namespace {

void set_target(std::optional<TriangleBudget>& budget, std::optional<int> target) {
    if (!target) return budget.reset();
    const auto count = static_cast<std::size_t>(*target);
    if (!budget) budget.emplace(BudgetOptions{.target = count});
    budget->set_target(count);
}

void set_viewer(std::optional<Visibility>& visibility, const std::optional<Vec3f>& seen_from) {
    if (!seen_from) return visibility.reset();
    const ViewPoint view{.eye = *seen_from, .is_orthographic = true};
    // rad, half the field of view of a usual lens: by so much a camera sees farther round the rim of what fills its
    // picture than the direction from its middle tells
    constexpr float kHalfView = 0.21F;
    constexpr BackFaceOptions kParallel{};
    if (!visibility)
        visibility.emplace(view, BackFaceOptions{.split_margin = kParallel.split_margin + kHalfView,
                                                 .rejoin_margin = kParallel.rejoin_margin + kHalfView});
    visibility->move_to(view);
}

}  // namespace

Simulation::Simulation(Cloth cloth, const SimulationOptions& options) : cloth_(std::move(cloth)) {
    set_options(options);
}

Simulation::Simulation(const Simulation& other)
    : cloth_(other.cloth_),
      options_(other.options_),
      constraints_(other.constraints_),
      made_for_(other.made_for_),
      budget_(other.budget_),
      own_visibility_(other.own_visibility_) {}

Simulation& Simulation::operator=(const Simulation& other) {
    Simulation copy(other);
    *this = std::move(copy);
    return *this;
}

void Simulation::set_options(const SimulationOptions& options) {
    options_ = options;
    set_target(budget_, options_.triangle_budget);
    set_viewer(own_visibility_, options_.seen_from);
}

void Simulation::release() {
    visibility_ = nullptr;
    kept_.clear();
    lead_ = {};
}

ContactOptions Simulation::contact(const Schedule& schedule) const {
    ContactOptions contact = options_.contact;
    contact.offset = std::min(contact.offset, schedule.offset);
    contact.sample_spacing = std::min(contact.sample_spacing, schedule.sample_spacing);
    contact.friction_scale *= schedule.friction;
    contact.floor -= schedule.lowered_floor;
    return contact;
}

StepOptions Simulation::step_options(const Schedule& schedule) const {
    StepOptions stepping{.substeps = schedule.substeps,
                         .gravity = schedule.gravity > 0 ? Vec3f(schedule.gravity * options_.gravity) : Vec3f::Zero(),
                         .extra_damping = schedule.damping,
                         .limit_iterations = schedule.limit_iterations,
                         .max_move_per_substep = schedule.longest_move,
                         .contact = contact(schedule),
                         .seams = schedule.seams,
                         .seam_gap = schedule.seam_gap,
                         .seam_gap_rate = schedule.seam_gap_rate,
                         .floor_rate = schedule.floor_rise / static_cast<float>(schedule.substeps),
                         .kinematic = schedule.kinematic,
                         .may_rest = schedule.may_rest};
    stepping.stretch_bias_rate *= schedule.bias_rate;
    stepping.shear_bias_rate *= schedule.bias_rate;
    if (schedule.meets_itself && options_.self_contact) {
        stepping.self_contact = options_.self_contact;
        stepping.self_contact->thickness_scale *= schedule.thickness;
    }
    return stepping;
}

AdaptClothOptions Simulation::adapt_options(const Schedule& schedule) {
    AdaptClothOptions adapting = options_.adapt;
    adapting.kept_vertices = kept_;
    adapting.visibility = visibility_ != nullptr ? visibility_ : (own_visibility_ ? &*own_visibility_ : nullptr);
    adapting.budget = budget_ ? &*budget_ : nullptr;
    if (!schedule.may_split) adapting.shortest_edge = std::numeric_limits<float>::max();
    adapting.may_rejoin = adapting.may_rejoin && schedule.may_rejoin;
    return adapting;
}

void Simulation::set_constraints(ClothConstraints constraints) {
    constraints_ = std::move(constraints);
    made_for_.reset();
    reactivate(cloth_);
}

void Simulation::make_constraints() {
    if (constraints_.empty() || made_for_ == cloth_.adaptations) return;
    for (const auto& constraint : constraints_) constraint->make(cloth_);
    made_for_ = cloth_.adaptations;
}

AdaptReport Simulation::adapt(const Collider& body, const Schedule& schedule) {
    const bool are_made = made_for_ == cloth_.adaptations;
    const AdaptReport report = adapt_cloth(cloth_, body, adapt_options(schedule), contact(schedule));
    if (!are_made) return report;
    for (const auto& constraint : constraints_)
        if (report.changed()) constraint->change(cloth_);
    made_for_ = cloth_.adaptations;
    return report;
}

StepReport Simulation::step(const Collider& body, const Schedule& schedule) {
    StepOptions stepping = step_options(schedule);
    if (lead_) stepping.kinematic = lead_(cloth_, step_seconds(schedule));
    if (constraints_.empty()) return sim::step(cloth_, body, stepping);
    make_constraints();
    for (const auto& constraint : constraints_) {
        constraint->begin_step(cloth_, schedule.held_by != nullptr ? *schedule.held_by : body, stepping);
        stepping.may_rest = stepping.may_rest && constraint->is_at_rest();
    }
    stepping.solve_more = [&](float* points, const float* before) {
        for (const auto& constraint : constraints_) constraint->solve(points, before);
    };
    return sim::step(cloth_, body, stepping);
}

StrainProjectionReport Simulation::project(const Collider& body, const Schedule& schedule) {
    return project_strain(cloth_, body, step_options(schedule));
}

float Simulation::step_seconds(const Schedule& schedule) const {
    return cloth_.substep * static_cast<float>(schedule.substeps);
}

}  // namespace selvedge::sim
