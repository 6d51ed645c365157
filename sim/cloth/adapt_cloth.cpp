#include "sim/cloth/adapt_cloth.h"

#include <algorithm>

#include "sim/adaptive/criteria.h"
#include "sim/adaptive/surface_normals.h"
#include "sim/cloth/contact_guard.h"
#include "sim/cloth/contact_surface.h"
#include "sim/cloth/moving_contact.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/state_transfer.h"
#include "sim/collide/collider.h"

namespace selvedge::sim {
namespace {

// The observer of the adaptation: updates the state of the cloth when edges split and rejoin.
struct ClothObserver {
    Cloth& cloth;
    const Collider& body;
    const ContactOptions& contact;
    Visibility* visibility;
    TriangleBudget* budget;
    ContactGuard guard;
    StateTransfer biases{cloth};

    bool permits_rejoin(EdgeId e) const { return guard.permits_rejoin(e); }

    void before(TriangleId t) { biases.before(t); }
    void after(TriangleId t) {
        biases.after(t);
        note_children(cloth, t);
        cloth.solver->adapting.shape.forget(cloth.mesh, t);
    }

    void on_capacity(std::size_t capacity) {
        size_state(cloth, capacity);
        if (visibility != nullptr) visibility->on_capacity(capacity);
    }

    // On a body that moves, the new vertex stays on the side that its ends are on.
    Vec3f outside_body(const Vec3f& middle, const Vec3f& normal, VertexId c, const std::array<VertexId, 2>& ends) {
        if (!body.moving()) return outside(middle, normal, body, contact.offset);
        MovingContacts& moving = cloth.solver->contacts.moving;
        note_split(moving, c, ends[0], ends[1]);
        const auto distance = distance_between(moving, ends, std::array{0.5F, 0.5F}, middle);
        return distance ? Vec3f(middle + moving.last[c.value].normal * std::max(0.0F, contact.offset - *distance))
                        : middle;
    }

    // The centre gets the mean of the ends' positions and of their previous positions, so velocity is averaged too. If
    // it lies inside the body, it is moved out without gaining velocity.
    void on_split(VertexId c, VertexId a, VertexId b) {
        const Vec4f middle = (cloth.x[a.value] + cloth.x[b.value]) * 0.5F;
        const Vec4f velocity = middle - (cloth.x_prev[a.value] + cloth.x_prev[b.value]) * 0.5F;
        const Vec3f normal = sum_of_ends(cloth.mesh, cloth.normals, a, b);
        cloth.x[c.value] = with_zero_w(outside_body(middle.head<3>(), normal, c, {a, b}));
        cloth.x_prev[c.value] = cloth.x[c.value] - velocity;
        cloth.normals[c.value] = normal.squaredNorm() > 0 ? Vec3f(normal.normalized()) : Vec3f::Zero();
        cloth.is_pinned[c.value] = cloth.is_pinned[a.value] && cloth.is_pinned[b.value];  // e.g. on a pinned waistband
        cloth.solver->contacts.standoff[c.value] = 0;
        cloth.solver->adapting.shape.forget_children(cloth.mesh, cloth.mesh.vertex(c).parent);
        cloth.solver->self_contact->contact.on_split(c.value, a.value, b.value);
        guard.note_split(cloth.mesh.vertex(c).parent);
        if (visibility != nullptr) visibility->on_split(c, a, b);
        if (budget != nullptr) budget->on_split();
    }

    void on_rejoin(VertexId c) {
        guard.note_rejoin(cloth.mesh.vertex(c).parent);
        if (budget != nullptr) budget->on_rejoin();
    }
};

SplitLimits split_limits(const AdaptClothOptions& options) {
    return {.shortest_edge = options.shortest_edge, .max_level = options.max_level};
}

// Calls adapt_choosing() with all criteria, each with its switch.
template <class Choice>
AdaptReport adapt_switched(const Choice& choice, Cloth& cloth, ClothObserver& observer,
                           const AdaptClothOptions& options) {
    const CriteriaOptions& on = options.criteria;
    const bool sees = options.visibility != nullptr, counts = options.budget != nullptr;
    const float scale = counts ? options.budget->scale() : 1.0F;

    const SplitLimits limits = split_limits(options);
    const CollisionCriterion collision{.x = cloth.x,
                                       .body = observer.body,
                                       .batch = cloth.solver->adapting.collision,
                                       .limits = limits,
                                       .offset = observer.contact.offset,
                                       .standoff = &cloth.solver->contacts.standoff,
                                       .moving = observer.body.moving() ? &cloth.solver->contacts.moving : nullptr,
                                       .spacing = observer.contact.sample_spacing};
    const CurvatureCriterion curvature(cloth.normals, scaled(options.curvature, scale));
    const LengthCriterion<Vec4f> length(cloth.x, scaled(options.length, scale));
    const BucklingCriterion<Vec4f> buckling(cloth.x, scaled(options.buckling, scale));
    const AnyOf shape(OptionalCriterion(on.curvature, curvature), OptionalCriterion(on.length, length),
                      OptionalCriterion(on.buckling, buckling));
    const bool tests_shape = on.curvature || on.length || on.buckling;
    if (tests_shape) cloth.solver->adapting.shape.ask(cloth.mesh, shape);
    const LookAheadCriterion look_ahead(shape, limits, cloth.solver->adapting.shape);
    const MinimumLevelCriterion minimum{options.minimum_levels};
    const PinnedVertexCriterion kept{options.kept_vertices};
    const BackFaceCriterion back_face{options.visibility};
    const BudgetVeto veto{options.budget};
    const BudgetCriterion keep{options.budget};
    return adapt_choosing(
        choice, cloth.mesh, observer, {.max_level = options.max_level, .transitions = options.transitions},
        ShortestEdgeCriterion{options.shortest_edge}, RejoinSwitch{options.may_rejoin}, OptionalCriterion(counts, veto),
        OptionalCriterion(sees, back_face), OptionalCriterion(tests_shape, look_ahead),
        OptionalCriterion(!options.minimum_levels.empty(), minimum), OptionalCriterion(counts, keep),
        OptionalCriterion(!options.kept_vertices.empty(), kept), OptionalCriterion(on.collision, collision));
}

// A choice of diagonals by the cost that the options give.
struct CheapestDiagonal {
    const std::function<float(const Diagonal&)>& cost;
};

// The edges that the collision criterion will split. None if a budget or a view could veto such a split, or if the body
// moves, whose knees may come through a coarse skirt before the next adaptation: then all edges need contact samples.
SplitOnContact split_on_contact(const AdaptClothOptions& options, const Collider& body) {
    if (body.moving() != nullptr) return std::nullopt;
    if (!options.criteria.collision || options.budget != nullptr || options.visibility != nullptr) return std::nullopt;
    return split_limits(options);
}

}  // namespace

AdaptReport adapt_cloth(Cloth& cloth, const Collider& body, const AdaptClothOptions& options,
                        const ContactOptions& contact) {
    update_normals(cloth);
    ++cloth.adaptations;
    if (options.visibility != nullptr) options.visibility->look(cloth.mesh, cloth.x, cloth.normals);
    if (options.budget != nullptr) options.budget->start(cloth.mesh);
    ClothObserver observer{cloth,          body,
                           contact,        options.visibility,
                           options.budget, {cloth.mesh, cloth.x, self_contact_clearances(cloth)}};
    const AdaptReport report = options.diagonal_cost
                                   ? adapt_switched(CheapestDiagonal{options.diagonal_cost}, cloth, observer, options)
                                   : adapt_switched(MinimalChange{}, cloth, observer, options);
    if (report.changed()) {
        update_solver(cloth);
        cloth.solver->self_contact->has_surface = false;
        if (observer.guard.is_doubtful()) cloth.solver->self_contact->contact.doubt();
    }
    const SplitOnContact split = split_on_contact(options, body);
    if (report.changed() || !are_contacts_made_for(cloth, contact, split)) update_contacts(cloth, contact, split);
    return report;
}

}  // namespace selvedge::sim
