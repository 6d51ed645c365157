#include <cmath>
#include <numbers>

#include "bench/timing.h"
#include "bench/tshirt/tshirt.h"
#include "sim/body/analytic_collider.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/cloth/stretch.h"
#include "sim/core/quantile.h"

namespace selvedge {
namespace {

constexpr int kSteps = 4;  // of 1/120 s, to an adaption

Vec3f leaning_gravity(double seconds) {
    const double lean = 5 * std::numbers::pi / 180;
    const double turn = 2 * std::numbers::pi * seconds;
    return (9.81 * Vec3d(std::sin(lean) * std::cos(turn), -std::cos(lean), std::sin(lean) * std::sin(turn)))
        .cast<float>();
}

// Adds up what the cycles took.
class Cycles {
 public:
    Cycles(Cloth& cloth, const Collider& body, const SwayOptions& options)
        : cloth_(cloth), body_(body), options_(options) {}

    void run(int cycle, bool is_measured) {
        seconds_ = cycle * kSteps / 120.0;
        const std::size_t allocated = allocations();
        const double start = thread_seconds();
        const AdaptReport adapted = adapt_cloth(cloth_, body_, {.shortest_edge = options_.shortest_edge});
        const double adapted_at = thread_seconds();
        const std::size_t allocated_by_adaption = allocations() - allocated;
        const bool compares = cycle % options_.shares_every == 0;
        const double without = compares ? steps_without_body() : 0;
        const std::size_t before_steps = allocations();
        const double with = four_steps(cloth_, body_);
        if (!is_measured) return;
        const std::size_t allocated_by_steps = allocations() - before_steps;
        if (compares) shares_.push_back((with - without) / (with + adapted_at - start));
        if (compares) return;  // the steps before have warmed what these find
        add(adapted_at - start, with, adapted.splits + adapted.rejoins);
        adaption_allocations_ += allocated_by_adaption;
        step_allocations_ += allocated_by_steps;
    }

    SwayFigures figures() const {
        const auto count = static_cast<double>(whole_.size());
        SwayFigures f;
        f.leaf_triangles = static_cast<int>(std::lround(leaves_ / count));
        f.substeps = options_.substeps;
        f.ms_median = 1e3 * quantile(whole_, 0.5);
        f.ms_p95 = 1e3 * quantile(whole_, 0.95);
        f.ms_adaption = 1e3 * quantile(adaptions_, 0.5);
        f.ms_steps = 1e3 * quantile(steps_, 0.5);
        f.adapt_share = f.ms_adaption / f.ms_median;
        f.collision_share = quantile(shares_, 0.5);
        f.p99_stretch = stretch_ / count;
        f.changes_per_adaption = changes_ / count;
        if (options_.allocations != nullptr) {
            f.allocations_per_adaption = static_cast<double>(adaption_allocations_) / count;
            f.allocations_per_step = static_cast<double>(step_allocations_) / count / kSteps;
        }
        return f;
    }

 private:
    std::size_t allocations() const { return options_.allocations == nullptr ? 0 : options_.allocations(); }

    double four_steps(Cloth& cloth, const Collider& body) const {
        const double start = thread_seconds();
        for (int i = 0; i < kSteps; ++i) {
            step(cloth, body,
                 {.substeps = options_.substeps, .gravity = leaning_gravity(seconds_ + i / 120.0), .extra_damping = 2});
        }
        return thread_seconds() - start;
    }

    // A copy takes them: the cloth itself goes on as if nobody had asked.
    double steps_without_body() const {
        Cloth copy = cloth_;
        return four_steps(copy, NoBody());
    }

    void add(double adaption, double steps, int changes) {
        adaptions_.push_back(adaption);
        steps_.push_back(steps);
        whole_.push_back(adaption + steps);
        changes_ += changes;
        leaves_ += static_cast<double>(cloth_.mesh.leaf_triangles().size());
        std::vector<double> strains;
        for (const TriangleStrain& strain : measure_strain(cloth_)) {
            strains.push_back(static_cast<double>(strain.warp));
            strains.push_back(static_cast<double>(strain.weft));
        }
        stretch_ += quantile(strains, 0.99);
    }

    Cloth& cloth_;
    const Collider& body_;
    const SwayOptions& options_;
    double seconds_ = 0;
    std::vector<double> adaptions_, steps_, whole_, shares_;
    double leaves_ = 0;
    double stretch_ = 0;
    double changes_ = 0;
    std::size_t adaption_allocations_ = 0;
    std::size_t step_allocations_ = 0;
};

}  // namespace

SwayFigures sway(Cloth& cloth, const Collider& body, const SwayOptions& options) {
    Cycles cycles(cloth, body, options);
    for (int cycle = 0; cycle < options.settling_cycles + options.cycles; ++cycle)
        cycles.run(cycle, cycle >= options.settling_cycles);
    return cycles.figures();
}

}  // namespace selvedge
