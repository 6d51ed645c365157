#pragma once
// A triangle budget: the adaptation keeps the number of leaf triangles near a target, which may change at run time.
// (thesis 5.5.2, figs. 5.10 and 5.11)
//
// A controller scales the thresholds of the other criteria: before each adaptation the logarithm of the scale changes
// by gain times log(count / target). Thresholds act with delay, because a new vertex gets its true normal only at the
// next adaptation, and in jumps, because whole regions are bent alike. So within an adaptation, splits stop at the
// upper end of a narrow band about the target, and rejoins at its lower end.
#include <cstddef>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/adaptive/criteria.h"

namespace selvedge::sim {

struct BudgetOptions {
    std::size_t target = 6000;  // leaf triangles
    float band = 0.02F;         // tolerance: share of the target, above and below
    float gain = 0.3F;          // of the controller, per adaptation
    float min_scale = 0.01F;    // minimum scale of the thresholds: flat cloth is not split, however large the target
    float max_scale = 8.0F;     // at this value surplus edges are rejoined whatever the criteria say
};

// Lives as long as the cloth. The observer of the adaptation must forward on_split and on_rejoin to it.
class TriangleBudget {
 public:
    explicit TriangleBudget(const BudgetOptions& options = {});

    void set_target(std::size_t leaf_triangles) { options_.target = leaf_triangles; }
    std::size_t target() const { return options_.target; }

    // Call it before each adaptation.
    void start(const AdaptiveMesh& mesh);
    float scale() const { return scale_; }  // of the thresholds, in this adaptation

    // A split turns each of the edge's two triangles into two. A boundary edge has only one; the next start() corrects
    // the count.
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

// Vetoes splits once the count has reached the upper end of the band; forces rejoins where even the largest thresholds
// leave too many triangles.
struct BudgetVeto {
    static constexpr bool is_veto = true;
    const TriangleBudget* budget;

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const {
        return mesh.is_split(e) ? budget->must_rejoin() : !budget->may_split();
    }
};

// Prevents rejoins once the count has reached the lower end of the band. It requests no split.
struct BudgetCriterion {
    const TriangleBudget* budget;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return budget->may_rejoin(); }
};

// The thresholds multiplied by a scale.
CurvatureOptions scaled(const CurvatureOptions& options, float scale);
LengthOptions scaled(const LengthOptions& options, float scale);
BucklingOptions scaled(const BucklingOptions& options, float scale);

}  // namespace selvedge::sim
