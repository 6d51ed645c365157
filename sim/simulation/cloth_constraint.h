#pragma once
// Constraints besides those that every cloth has, such as an elastic along an edge. A Simulation solves them in each
// sub-step of each phase, as the last of stretch; docs/adding-a-constraint.md adds one.
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"

namespace selvedge::sim {

class ClothConstraint {
 public:
    virtual ~ClothConstraint() = default;
    virtual std::unique_ptr<ClothConstraint> copy() const = 0;

    // Called before the first step, and whenever the cloth is another, as when panels were sewn, or its pins, fabrics,
    // masses or the length of its sub-steps changed. Pre: the solver's masses are those of the present leaves.
    virtual void make(const Cloth& cloth) = 0;
    // Called after an adaptation that changed the mesh; cloth.mesh.changes() lists how.
    virtual void change(const Cloth& cloth) { make(cloth); }
    // Called before each step, with the body that holds the cloth.
    virtual void begin_step(const Cloth&, const Collider&, const StepOptions&) {}
    // One iteration. points: by vertex, x, y, z (m) and the inverse mass (1/kg), then the dummy vertex, which cannot
    // move; before: the same where the sub-step began.
    virtual void solve(float* points, const float* before) = 0;
    // Whether cloth that lies still may rest; false while the constraint itself is still changing.
    virtual bool is_at_rest() const { return true; }

 protected:
    ClothConstraint() = default;
    ClothConstraint(const ClothConstraint&) = default;
    ClothConstraint& operator=(const ClothConstraint&) = default;
};

// The compliance of a spring of that stiffness (N/m) over a sub-step, 1/kg: 1 / ((1 - kMomentum) stiffness h^2). The
// momentum of corrections provides the rest of the stiffness (docs/solver.md). Of what is stiff per area or per length:
// the stiffness of one element.
float compliance_of_spring(const Cloth& cloth, float stiffness);

// Constraints as a value: a copy has copies of them.
class ClothConstraints {
 public:
    ClothConstraints() = default;
    ClothConstraints(const ClothConstraints& other) { add(other); }
    ClothConstraints(ClothConstraints&&) noexcept = default;
    ClothConstraints& operator=(const ClothConstraints& other) {
        ClothConstraints copy(other);
        all_ = std::move(copy.all_);
        return *this;
    }
    ClothConstraints& operator=(ClothConstraints&&) noexcept = default;
    ~ClothConstraints() = default;

    void add(std::unique_ptr<ClothConstraint> constraint) { all_.push_back(std::move(constraint)); }
    void add(const ClothConstraints& others) {
        for (const auto& other : others.all_) all_.push_back(other->copy());
    }

    bool empty() const { return all_.empty(); }
    auto begin() const { return all_.begin(); }
    auto end() const { return all_.end(); }

 private:
    std::vector<std::unique_ptr<ClothConstraint>> all_;
};

}  // namespace selvedge::sim
