#pragma once
// The state of the solver within a cloth: constraints, contacts, per-vertex working arrays, and the state that is saved
// during an adaptation. Only sim/cloth reads it.
#include <cstdint>
#include <vector>

#include "sim/adaptive/criteria.h"
#include "sim/cloth/collision_criterion.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/resting.h"
#include "sim/cloth/self_contact_state.h"
#include "sim/cloth/solver_lists.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// States of triangles, saved by id during an adaptation, because the slots of changed triangles are reassigned.

template <class State>
class SavedStates {
 public:
    // The state saved last in that adaptation, or null. Valid until the next save().
    const State* find(TriangleId t, std::uint32_t adaptation) const {
        return t.value < entries_.size() && entries_[t.value].adaptation == adaptation ? &entries_[t.value].state
                                                                                       : nullptr;
    }
    // A later state of the same triangle replaces an earlier one.
    void save(TriangleId t, std::uint32_t adaptation, const State& state) {
        if (t.value >= entries_.size()) entries_.resize(t.value + 1);
        entries_[t.value] = {.state = state, .adaptation = adaptation};
    }

 private:
    struct Entry {
        State state{};
        std::uint32_t adaptation = UINT32_MAX;
    };
    std::vector<Entry> entries_;
};

// Saved state of a triangle: the biases of stretch and shear and the anchor of friction in shear. See
// solver_blocks.h and state_transfer.h.
struct SavedBias {
    Vec3f value = Vec3f::Zero();  // bias of warp, weft and shear of a leaf
    Vec3f limit = Vec3f::Zero();  // bias of the coarse strain limit of a refined triangle
    float anchor = 0;             // of friction in shear
};

// Saved state of a triangle's internal friction in bending, for leaves and refined triangles.
struct SavedBend {
    Vec3f anchor = Vec3f::Zero();  // 1/m, of the curvatures along warp, weft and of twist
    bool is_known = false;         // if not, the anchor of a leaf starts at its present curvature
};

// Working memory of the criteria during an adaptation, reused by the next one.
struct CriteriaMemory {
    CachedSplitRequests shape;  // results of curvature, length and buckling
    CollisionBatch collision;
};

// The state of the solver and its working memory, which is reused by the next step.
struct SolverState {
    std::vector<Vec4f> points;      // positions, w: inverse mass; the last one is the dummy vertex
    std::vector<Vec4f> before;      // positions one sub-step ago
    std::vector<Vec4f> lost;        // rounding errors of the last displacements
    std::vector<Vec4f> predicted;   // positions before the corrections by stretch and shear
    std::vector<Vec4f> start;       // predicted plus the momentum of corrections; scratch of solve_coarse_bend
    std::vector<Vec4f> correction;  // displacements by stretch and shear in the last sub-step
    Constraints constraints;
    SolverLists lists;
    ContactState contacts;
    SelfContactHolder self_contact;
    RestingState resting;
    std::vector<double> mass_sums;  // kg, by vertex, pinned or not; floats summed in doubles: subtraction is exact
    int substeps = 0;               // number of sub-steps so far, modulo 2
    float damping = 0;              // 1/s, mean of the fabrics' damping, weighted by area

    // Used during an adaptation; saved states are by TriangleId.
    CriteriaMemory adapting;
    SavedStates<SavedBias> saved_bias;
    SavedStates<SavedBend> saved_bend;
};

}  // namespace selvedge::sim
