// What a simulation does with constraints that are added to its cloth.
#include "sim/simulation/simulation.h"

#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "sim/cloth/contact.h"
#include "sim/cloth/resting.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

struct Calls {
    int made = 0, changed = 0, begun = 0, solved = 0;
};

// Counts how often it is called, and its copies with it.
class Counter : public ClothConstraint {
 public:
    explicit Counter(std::shared_ptr<Calls> calls, bool is_at_rest = true)
        : calls_(std::move(calls)), is_at_rest_(is_at_rest) {}
    std::unique_ptr<ClothConstraint> copy() const override { return std::make_unique<Counter>(*this); }
    void make(const Cloth&) override { ++calls_->made; }
    void change(const Cloth&) override { ++calls_->changed; }
    void begin_step(const Cloth&, const Collider&, const StepOptions&) override { ++calls_->begun; }
    void solve(float*, const float*) override { ++calls_->solved; }
    bool is_at_rest() const override { return is_at_rest_; }

 private:
    std::shared_ptr<Calls> calls_;
    bool is_at_rest_;
};

Simulation floating_patch(const std::shared_ptr<Calls>& calls, bool is_at_rest = true) {
    Simulation simulation(make_patch(find_fabric("cotton_shirting")),
                          {.gravity = Vec3f::Zero(), .contact = {.floor = kNoFloor}});
    refresh_contacts(simulation.cloth(), simulation.contact({}));
    ClothConstraints constraints;
    constraints.add(std::make_unique<Counter>(calls, is_at_rest));
    simulation.set_constraints(std::move(constraints));
    return simulation;
}

TEST(Simulation, makes_a_constraint_before_the_first_step_and_again_when_pins_or_substeps_change) {
    const auto calls = std::make_shared<Calls>();
    Simulation simulation = floating_patch(calls);
    for (int i = 0; i < 2; ++i) simulation.step(nothing_near(), {});
    EXPECT_EQ(calls->made, 1);
    EXPECT_EQ(calls->begun, 2);
    EXPECT_EQ(calls->solved, 2 * Schedule{}.substeps);
    simulation.cloth().is_pinned[0] = true;
    refresh_solver(simulation.cloth());
    simulation.step(nothing_near(), {});
    EXPECT_EQ(calls->made, 2);
    set_substep(simulation.cloth(), simulation.cloth().substep / 2);
    simulation.step(nothing_near(), {});
    EXPECT_EQ(calls->made, 3);
}

TEST(Simulation, changes_a_constraint_after_an_adaptation_that_changed_the_mesh) {
    const auto calls = std::make_shared<Calls>();
    Simulation simulation = floating_patch(calls);
    simulation.step(nothing_near(), {});
    simulation.adapt(nothing_near(), {});
    EXPECT_EQ(calls->changed, 0) << "flat cloth is not split";
    SimulationOptions options = simulation.options();
    options.adapt.minimum_levels = {&kDab, 1};
    simulation.set_options(options);
    ASSERT_GT(simulation.adapt(nothing_near(), {}).splits, 0);
    simulation.step(nothing_near(), {});
    EXPECT_EQ(calls->changed, 1);
    EXPECT_EQ(calls->made, 1);
}

TEST(Simulation, gives_its_copy_constraints_of_its_own) {
    const auto calls = std::make_shared<Calls>();
    Simulation simulation = floating_patch(calls);
    simulation.step(nothing_near(), {});
    Simulation copy = simulation;
    copy.step(nothing_near(), {});
    EXPECT_EQ(calls->made, 1) << "the copy's was made already";
    EXPECT_EQ(calls->solved, 2 * Schedule{}.substeps);
    simulation.set_constraints({});
    simulation.step(nothing_near(), {});
    EXPECT_EQ(calls->solved, 2 * Schedule{}.substeps);
}

TEST(Simulation, lets_cloth_rest_whose_constraints_rest) {
    for (const bool is_at_rest : {true, false}) {
        Simulation simulation = floating_patch(std::make_shared<Calls>(), is_at_rest);
        for (int i = 0; i < 120; ++i) simulation.step(nothing_near(), {.may_rest = true});
        EXPECT_EQ(sim::is_at_rest(simulation.cloth()), is_at_rest);
    }
}

TEST(Simulation, steps_cloth_at_rest_on_when_it_gets_other_constraints) {
    Simulation simulation = floating_patch(std::make_shared<Calls>());
    for (int i = 0; i < 120; ++i) simulation.step(nothing_near(), {.may_rest = true});
    ASSERT_TRUE(is_at_rest(simulation.cloth()));
    simulation.set_constraints({});
    EXPECT_GT(simulation.step(nothing_near(), {.may_rest = true}).substeps, 0);
}

}  // namespace
}  // namespace selvedge::sim::test
