#pragma once
// The solver's own part of a cloth.
#include <cstdint>
#include <vector>

#include "sim/adaptive/criteria.h"
#include "sim/cloth/collision_criterion.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/resting.h"
#include "sim/cloth/solver_lists.h"
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// States of triangles, saved by their ids while an adaptation is under way: their slots come and go.

template <class State>
class SavedStates {
 public:
    // What was saved in that adaptation, until the next is saved; none if nothing was.
    const State* find(TriangleId t, std::uint32_t adaptation) const {
        return t.value < entries_.size() && entries_[t.value].adaptation == adaptation ? &entries_[t.value].state
                                                                                       : nullptr;
    }
    // Later ones of the same adaptation replace earlier ones.
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

// What the solver has learnt about a triangle, see solver_blocks.h and bias.h.
struct KeptBias {
    Vec3f value = Vec3f::Zero();  // of warp, weft and shear
    Vec3f limit = Vec3f::Zero();  // the same as a refined triangle
    float anchor = 0;             // of friction in shear
};

// The same of a triangle's internal friction in bending, whether a leaf or a refined triangle.
struct KeptBend {
    Vec3f anchor = Vec3f::Zero();  // 1/m, of the curvatures along warp, weft and of twist
    bool is_known = false;         // else friction starts from how the cloth is bent
};

// What criteria remember while an adaptation is under way, in the memory of the last one.
struct CriteriaMemory {
    LeafAnswers shape;  // curvature, length and buckling
    CollisionBatch collision;
};

// What the solver works on, in the memory of the last step, and all that it remembers. Nobody but sim/cloth reads it.
struct SolverState {
    std::vector<Vec4f> points;      // positions with the inverse mass as fourth; one spare point behind them
    std::vector<Vec4f> before;      // one sub-step ago
    std::vector<Vec4f> lost;        // what rounding took from the last moves
    std::vector<Vec4f> predicted;   // before stretch and shear corrected them
    std::vector<Vec4f> carried;     // the same with the momentum of corrections
    std::vector<Vec4f> correction;  // what stretch and shear moved them by in the last sub-step
    Constraints constraints;
    SolverLists lists;
    ContactState contacts;
    RestingState resting;
    std::vector<double> mass_sums;  // kg by vertex, pinned or not; sums of floats, so that they can be undone exactly
    int substeps = 0;               // so far, by 2
    float damping = 0;              // 1/s, mean over the fabrics' area

    // While an adaptation is under way; saved by TriangleId.
    CriteriaMemory adapting;
    SavedStates<KeptBias> saved_bias;
    SavedStates<KeptBend> saved_bend;
};

}  // namespace selvedge::sim
