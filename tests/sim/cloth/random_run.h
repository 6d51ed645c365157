#pragma once
// Randomised test of a small cloth: any fabric, levels and criteria that change while it moves, pins, a body that is
// removed and put back, steps of any length. After each act it validates the cloth. A source of choices (Choices)
// decides what happens.
#include <gtest/gtest.h>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"

namespace selvedge::sim::test {

class Choices {
 public:
    virtual ~Choices() = default;
    virtual std::uint32_t next(std::uint32_t below) = 0;  // 0 .. below - 1

    float between(float low, float high) { return low + (high - low) * static_cast<float>(next(256)) / 255; }
    // Uniform on a logarithmic scale.
    double log_between(double low, double high);
    bool one_in(std::uint32_t n) { return next(n) == 0; }
};

// A fabric with any values that a file may contain (sim/pattern/fabric.cpp).
Fabric any_fabric(Choices& choices);

// The mechanical energy of a cloth, J.
struct Energy {
    double kinetic = 0;
    double elastic = 0;  // upper bound for warp, weft, shear and bending, with or without the biases
    double lift = 0;     // potential energy in gravity
};
Energy energy_of(const Cloth& cloth);

class RandomRun {
 public:
    explicit RandomRun(Choices& choices);

    // Changes something or nothing, adapts once and makes some steps. Returns the description of a fault, if it finds
    // one.
    std::optional<std::string> act();

    // From now on, adds this downward speed, m/s, to every vertex after each step.
    void kick(float speed) { kick_ = speed; }

    const Cloth& cloth() const { return cloth_; }
    long changes() const { return changes_; }  // splits and rejoins so far

 private:
    void change_pins();
    void change_body();
    void change_time();
    void change_criteria();
    void change_something();
    void adapt();
    std::optional<std::string> make_step();
    std::optional<std::string> energy_fault(const Energy& before, double depth);
    std::optional<std::string> fault() const;
    const Collider& body() const;
    bool is_inside_body() const;
    double depth() const;  // m, of the deepest vertex or contact sample below the contact offset

    Choices& choices_;
    Cloth cloth_;
    double mass_ = 0;  // kg, including pinned vertices
    SphereCollider sphere_;
    NoBody nothing_;
    bool is_away_ = false;
    StepOptions stepping_;
    AdaptClothOptions options_;
    MinimumLevelDisc disc_;
    TriangleBudget budget_;
    Visibility visibility_;
    long changes_ = 0;
    float kick_ = 0;
};

}  // namespace selvedge::sim::test

// Random runs by seed.

namespace selvedge::sim::test {

class RandomChoices final : public Choices {
 public:
    explicit RandomChoices(unsigned seed) : random_(seed) {}
    std::uint32_t next(std::uint32_t below) override { return static_cast<std::uint32_t>(random_() % below); }

 private:
    std::mt19937 random_;
};

// Makes 25 adaptations and returns the number of splits and rejoins. Fails at the first fault.
inline long run_seed(unsigned seed) {
    RandomChoices choices(seed);
    RandomRun run(choices);
    for (int i = 0; i < 25; ++i) {
        const auto fault = run.act();
        EXPECT_FALSE(fault.has_value()) << "seed " << seed << ", act " << i << ": " << *fault;
        if (fault) break;
    }
    return run.changes();
}

}  // namespace selvedge::sim::test
