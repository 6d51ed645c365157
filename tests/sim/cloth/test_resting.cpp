// Cloth at rest costs no computation, every change that could move it reactivates it, and moving cloth never rests.
#include "sim/cloth/contact.h"
#include "sim/cloth/resting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/wind.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

const StepOptions kDamped{.extra_damping = 8, .may_rest = true};

// The time until the cloth is at rest, s; nullopt if it is not within 20 s.
std::optional<double> come_to_rest(Cloth& cloth, const BodyCollider& body, const StepOptions& options = kDamped) {
    constexpr int kMax = 2400;  // steps
    for (int i = 0; i < kMax; ++i) {
        if (step(cloth, body, options).substeps == 0) return double(step_seconds(cloth, options)) * i;
    }
    return std::nullopt;
}

long substeps_in(Cloth& cloth, const BodyCollider& body, const StepOptions& options, int steps) {
    long count = 0;
    for (int i = 0; i < steps; ++i) count += step(cloth, body, options).substeps;
    return count;
}

float farthest_between(const Cloth& one, const Cloth& other) {
    float farthest = 0;
    for (const VertexId v : one.mesh.leaf_vertices()) {
        farthest = std::max(farthest, (one.x[v.value] - other.x[v.value]).norm());
    }
    return farthest;
}

std::uint32_t lowest(const Cloth& cloth) {
    std::uint32_t found = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.x[v.value].y() < cloth.x[found].y()) found = v.value;
    }
    return found;
}

// Two fixtures: a patch on the ball, and (HeldStrip) a strip that hangs by its upper edge with kinematic vertices at
// its hem.
Cloth patch_at_rest() {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.4, .quads = 6, .height = 1.17});
    refine(cloth, 1);
    EXPECT_TRUE(come_to_rest(cloth, ball()).has_value());
    return cloth;
}
struct HeldStrip {
    Cloth cloth = make_strip(find_fabric("cotton_shirting"), {.level = 1});
    std::uint32_t hand = lowest(cloth);
    std::vector<std::uint32_t> hands{hand};

    // Makes one vertex of the hem kinematic, or all of them.
    explicit HeldStrip(bool by_all = false) {
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            const bool is_at_hem = cloth.x[v.value].y() < cloth.x[hand].y() + 1e-3F;
            if (by_all && is_at_hem && v.value != hand) hands.push_back(v.value);
        }
        for (const std::uint32_t v : hands) cloth.is_pinned[v] = true;
        refresh_solver(cloth);
    }
};

TEST(Resting, a_cloth_at_rest_computes_no_substep_and_keeps_its_place_to_the_bit) {
    Cloth cloth = patch_at_rest();
    const std::vector<Vec4f> there = cloth.x;
    EXPECT_EQ(substeps_in(cloth, ball(), kDamped, 500), 0);
    EXPECT_TRUE(is_at_rest(cloth));
    EXPECT_EQ(cloth.x, there);
    EXPECT_EQ(cloth.x_prev, there) << "it has speed";
}

TEST(Resting, nothing_rests_unless_that_is_asked_for) {
    Cloth cloth = patch_at_rest();
    StepOptions options = kDamped;
    options.may_rest = false;
    EXPECT_EQ(substeps_in(cloth, ball(), options, 100), 100 * options.substeps);
    EXPECT_EQ(substeps_in(cloth, ball(), kDamped, 10), 10 * options.substeps) << "its quiet time begins anew";
}

TEST(Resting, it_takes_a_quiet_time_to_come_to_rest) {
    Cloth cloth = make_patch(find_fabric("denim"), {.height = 0.5});
    const StepOptions weightless{.gravity = Vec3f::Zero(), .contact = {.floor = kNoFloor}, .may_rest = true};
    const auto rested = come_to_rest(cloth, nothing_near(), weightless);
    ASSERT_TRUE(rested.has_value()) << "it never moved at all";
    EXPECT_NEAR(*rested, double(kRestSeconds), 2 * double(step_seconds(cloth, weightless)));
}

using Change = std::function<void(Cloth&, StepOptions&)>;
struct NamedChange {
    const char* name;
    Change make;
};

class Wakes : public testing::TestWithParam<NamedChange> {};

TEST_P(Wakes, what_rests) {
    Cloth cloth = patch_at_rest();
    StepOptions options = kDamped;
    GetParam().make(cloth, options);
    EXPECT_EQ(step(cloth, ball(), options).substeps, options.substeps);
    EXPECT_FALSE(is_at_rest(cloth));
}

constexpr float kLittle = 1e-4F;  // m
INSTANTIATE_TEST_SUITE_P(
    Resting, Wakes,
    testing::Values(
        NamedChange{"a_moved_vertex", [](Cloth& cloth, StepOptions&) { cloth.x[3].y() += kLittle; }},
        NamedChange{"a_pushed_vertex", [](Cloth& cloth, StepOptions&) { cloth.x_prev[3].y() += kLittle; }},
        NamedChange{"wind",
                    [](Cloth& cloth, StepOptions&) {
                        blow(cloth, {.velocity = {1, 0, 0}}, 0.01F);
                    }},
        NamedChange{"gravity", [](Cloth&, StepOptions& options) { options.gravity.x() = 0.1F; }},
        NamedChange{"friction", [](Cloth&, StepOptions& options) { options.contact.friction_scale = 0; }},
        NamedChange{"a_pin", [](Cloth& cloth, StepOptions&) { cloth.is_pinned[3] = true, refresh_solver(cloth); }},
        NamedChange{"other_substeps", [](Cloth& cloth, StepOptions&) { set_substep(cloth, cloth.substep / 2); }},
        NamedChange{"a_body_that_has_moved", [](Cloth& cloth, StepOptions&) { forget_contacts(cloth); }},
        NamedChange{"other_friction", [](Cloth& cloth, StepOptions&) { refresh_contacts(cloth); }}),
    [](const auto& instance) { return instance.param.name; });

TEST(Resting, another_body_wakes) {
    Cloth cloth = patch_at_rest();
    const Obstacle lower(shapes::sphere(Vec3d(0, 0.99, 0), 0.15, 24));
    EXPECT_GT(step(cloth, lower.collider, kDamped).substeps, 0);
    run(cloth, lower.collider, kDamped, 0.5);
    EXPECT_LT(centre_of_mass(cloth).y(), centre_of_mass(patch_at_rest()).y() - 0.005) << "it hangs in mid-air";
}

TEST(Resting, an_adaptation_wakes_if_it_changes_something) {
    Cloth cloth = patch_at_rest();
    const AdaptReport nothing = adapt_cloth(
        cloth, ball(), {.criteria = {.collision = false, .curvature = false, .length = false}, .may_rejoin = false});
    ASSERT_FALSE(nothing.changed());
    EXPECT_EQ(step(cloth, ball(), kDamped).substeps, 0);
    const AdaptReport finer = adapt_cloth(cloth, ball(), {.shortest_edge = 0.01F});
    ASSERT_TRUE(finer.changed());
    EXPECT_GT(step(cloth, ball(), kDamped).substeps, 0);
}

// Moves the kinematic vertices evenly by `way` within 1 s; fails if a step computes nothing.
void move_kinematic(HeldStrip& strip, const Vec3f& way, StepOptions options) {
    constexpr int kSteps = 120;
    std::vector<KinematicVertex> kinematic(strip.hands.size());
    options.kinematic = kinematic;
    for (int i = 0; i < kSteps; ++i) {
        for (std::size_t k = 0; k < kinematic.size(); ++k) {
            kinematic[k] = {strip.hands[k], strip.cloth.x[strip.hands[k]].head<3>() + way / kSteps};
        }
        ASSERT_GT(step(strip.cloth, nothing_near(), options).substeps, 0) << "step " << i;
    }
}

TEST(Resting, a_pull_at_one_vertex_moves_all_that_hangs_on_it) {
    HeldStrip strip;
    ASSERT_TRUE(come_to_rest(strip.cloth, nothing_near()).has_value());
    const std::vector<Vec4f> there = strip.cloth.x;
    const Vec3f goal = there[strip.hand].head<3>() + Vec3f(0.1F, 0.05F, 0.3F);
    move_kinematic(strip, Vec3f(0.1F, 0.05F, 0.3F), kDamped);
    EXPECT_LT((strip.cloth.x[strip.hand].head<3>() - goal).norm(), 1e-4F);
    for (const VertexId v : strip.cloth.mesh.leaf_vertices()) {
        if (there[v.value].y() > 1.8F) continue;  // near the clamp
        EXPECT_GT((strip.cloth.x[v.value] - there[v.value]).norm(), 0.01F) << "left behind at " << there[v.value].y();
    }
}

// Slower than the speed of cloth that counts as at rest.
TEST(Resting, a_vertex_that_is_led_at_a_millimetre_a_second_arrives) {
    HeldStrip strip;
    ASSERT_TRUE(come_to_rest(strip.cloth, nothing_near()).has_value());
    const Vec3f start = strip.cloth.x[strip.hand].head<3>();
    StepOptions options = kDamped;
    for (int i = 1; i <= 600; ++i) {
        const KinematicVertex kinematic{strip.hand, start + Vec3f(0, float(i) * 0.001F / 120, 0)};
        options.kinematic = {&kinematic, 1};
        step(strip.cloth, nothing_near(), options);
    }
    EXPECT_NEAR(strip.cloth.x[strip.hand].y() - start.y(), 0.005F, 2 * kKinematicReach);
}

// Two copies of the same cloth, one of which rested for a while, are pulled in the same way.
TEST(Resting, what_rested_and_what_never_did_hang_alike_after_a_pull) {
    HeldStrip resting(true), awake(true);
    ASSERT_TRUE(come_to_rest(resting.cloth, nothing_near()).has_value());
    substeps_in(resting.cloth, nothing_near(), kDamped, 600);
    StepOptions always = kDamped;
    always.may_rest = false;
    run(awake.cloth, nothing_near(), always, 12);
    EXPECT_LT(farthest_between(resting.cloth, awake.cloth), kRestReach) << "before the pull";
    const Vec3f way(0, 0.1F, 0.3F);
    move_kinematic(resting, way, kDamped);
    move_kinematic(awake, way, always);
    EXPECT_TRUE(come_to_rest(resting.cloth, nothing_near()).has_value());
    run(awake.cloth, nothing_near(), always, 12);
    EXPECT_GT(farthest_between(resting.cloth, HeldStrip(true).cloth), 0.1F) << "it never moved";
    // Their initial positions differed by up to kRestReach.
    EXPECT_LT(farthest_between(resting.cloth, awake.cloth), 2 * kRestReach) << "after it";
}

// A pendulum has zero velocity at each turning point, but is not at rest.
TEST(Resting, a_strip_that_swings_is_never_taken_for_resting) {
    for (const float angle : {0.1F, 0.005F}) {
        Cloth cloth = make_strip(undamped(), {.level = 1});
        const Vec3f clamp(0, 2, 0);
        const Eigen::Matrix3f turn = Eigen::AngleAxisf(angle, Vec3f::UnitX()).toRotationMatrix();
        move_to(cloth, turn, clamp - turn * clamp);
        Cloth free = cloth;
        const StepOptions options{.internal_damping = 0, .contact = {.floor = kNoFloor}, .may_rest = true};
        StepOptions always = options;
        always.may_rest = false;
        int turns = 0;
        float last = 0;
        for (int i = 0; i < 480; ++i) {
            ASSERT_GT(step(cloth, nothing_near(), options).substeps, 0) << "step " << i << ", " << angle << " rad";
            step(free, nothing_near(), always);
            const std::uint32_t hem = lowest(cloth);
            const float speed = cloth.x[hem].z() - cloth.x_prev[hem].z();
            turns += speed * last < 0 ? 1 : 0;
            if (speed != 0) last = speed;
        }
        EXPECT_EQ(cloth.x, free.x);
        EXPECT_GE(turns, 2) << "it never turned, so nothing was tested";
    }
}

TEST(Resting, the_same_run_twice_gives_the_same_bits) {
    const auto run_once = [] {
        Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.4, .quads = 6, .height = 1.17});
        int rested = 0;
        for (int i = 0; i < 1200; ++i) {
            if (i % 400 == 399) cloth.x[7].y() += 0.01F;
            if (i % 4 == 0 && !is_at_rest(cloth)) adapt_cloth(cloth, ball(), {.may_rejoin = i < 200});
            rested += step(cloth, ball(), kDamped).substeps == 0 ? 1 : 0;
        }
        EXPECT_GT(rested, 50);
        EXPECT_LT(rested, 1000);
        return cloth.x;
    };
    EXPECT_EQ(run_once(), run_once());
}

}  // namespace
}  // namespace selvedge::sim::test
