#pragma once
// A budget of leaf triangles that the adaptation keeps to, whatever the cloth does; the target may change while it
// runs. (thesis 5; SPEC 1.3)
//
// A controller scales the thresholds of the other criteria: before each adaptation the logarithm of the scale moves by
// gain times log(count / target). Thresholds act late, for a new vertex gets its true normal only with the next
// adaptation, and in leaps, for whole regions are bent alike; so within an adaptation splits stop at the upper end of a
// narrow band about the target, and rejoins at its lower end.
#include <cstddef>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/adaptive/criteria.h"

namespace selvedge::sim {

struct BudgetOptions {
    std::size_t target = 6000;    // leaf triangles
    float band = 0.02F;           // share of the target, either way, that is as good as the target
    float gain = 0.3F;            // per adaptation
    float least_scale = 0.01F;    // of the thresholds: what lies quite flat is not split, however great the target
    float greatest_scale = 8.0F;  // beyond it edges are rejoined whatever the criteria say, until the target is met
};

// Lives as long as the cloth. Part of the state that the adaptation's observer keeps: pass its calls on.
class TriangleBudget {
 public:
    explicit TriangleBudget(const BudgetOptions& options = {});

    void set_target(std::size_t leaf_triangles) { options_.target = leaf_triangles; }
    std::size_t target() const { return options_.target; }

    // Before each adaptation.
    void start(const AdaptiveMesh& mesh);
    float scale() const { return scale_; }  // of the thresholds, in this adaptation

    // An edge has two triangles, and each of them becomes two. At a boundary it has but one: such a count is put right
    // by the next start().
    void on_split() { count_ += 2; }
    void on_rejoin() { count_ -= 2; }

    bool may_split() const { return count_ < upper_; }
    bool may_rejoin() const { return count_ > lower_; }
    bool must_rejoin() const { return is_at_end_ && count_ > upper_; }

 private:
    BudgetOptions options_;
    float scale_ = 1.0F;
    bool is_at_end_ = false;
    std::ptrdiff_t count_ = 0;
    std::ptrdiff_t lower_ = 0;
    std::ptrdiff_t upper_ = 0;
};

// Keeps splits below the band and, where even the greatest thresholds leave too many triangles, rejoins.
struct BudgetVeto {
    static constexpr bool is_veto = true;
    const TriangleBudget* budget;

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const {
        return mesh.is_split(e) ? budget->must_rejoin() : !budget->may_split();
    }
};

// Keeps rejoins above the band. It asks for no split: what to split is for the others to say.
struct BudgetCriterion {
    const TriangleBudget* budget;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return budget->may_rejoin(); }
};

// Thresholds times a scale.
CurvatureOptions scaled(const CurvatureOptions& options, float scale);
LengthOptions scaled(const LengthOptions& options, float scale);
BucklingOptions scaled(const BucklingOptions& options, float scale);

}  // namespace selvedge::sim
