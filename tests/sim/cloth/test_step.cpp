// Simulated motion compared with mechanics: fall, rest, momentum, pins, hanging, draping, wind; and determinism.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <thread>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/step.h"
#include "sim/cloth/wind.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

const ContactOptions kNoContact{.floor = kNoFloor};

double seconds_of(const Cloth& cloth, const StepOptions& options, int steps) {
    return double(cloth.substep) * options.substeps * steps;
}

TEST(Step, free_cloth_falls_with_g_and_keeps_its_shape) {
    const StepOptions options{.contact = kNoContact};
    Cloth cloth = make_patch(undamped());
    refine(cloth, 1);
    const std::vector<Vec4f> start = cloth.x;
    const int steps = 24;
    for (int i = 0; i < steps; ++i) step(cloth, nothing_near(), options);
    const double t = seconds_of(cloth, options, steps);
    const double fallen = 0.5 * 9.81 * t * t;
    const double one_substep_late = 9.81 * t * double(cloth.substep);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f moved = cloth.x[v.value] - start[v.value];
        EXPECT_NEAR(moved.y(), -fallen, one_substep_late);
        EXPECT_NEAR(moved.x(), 0, 1e-4F);
        EXPECT_NEAR(moved.z(), 0, 1e-4F);
    }
    EXPECT_NEAR(speed_now(cloth), 9.81 * t, 0.02);
}

TEST(Step, a_falling_cloth_keeps_its_velocity_when_its_sub_steps_become_shorter_or_longer) {
    const StepOptions options{.max_move_per_substep = 1, .contact = kNoContact};
    for (const float ratio : {0.25F, 3.0F}) {
        Cloth cloth = make_patch(undamped());
        refine(cloth, 1);
        for (int i = 0; i < 24; ++i) step(cloth, nothing_near(), options);
        const double speed = double(speed_now(cloth)), height = centre_of_mass(cloth).y();
        ASSERT_GT(speed, 2);
        set_substep(cloth, cloth.substep * ratio);
        EXPECT_NEAR(double(speed_now(cloth)), speed, 1e-3 * speed) << ratio;
        const int steps = 10;
        for (int i = 0; i < steps; ++i) step(cloth, nothing_near(), options);
        const double t = seconds_of(cloth, options, steps);
        const double one_substep = (speed + 9.81 * t) * double(cloth.substep);
        EXPECT_NEAR(height - centre_of_mass(cloth).y(), speed * t + 0.5 * 9.81 * t * t, one_substep) << ratio;
    }
}

TEST(Step, the_speed_limit_of_contacts_is_the_only_limit_to_falling) {
    Cloth cloth = make_patch(undamped(), {.height = 90});
    const StepOptions options{.max_move_per_substep = 0.001F, .contact = kNoContact};
    run(cloth, nothing_near(), options, 1.0);
    EXPECT_NEAR(speed_now(cloth), 0.001F / cloth.substep, 0.01F);
}

float farthest_move(const Cloth& cloth, const std::vector<Vec4f>& from) {
    float farthest = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        farthest = std::max(farthest, (cloth.x[v.value] - from[v.value]).norm());
    }
    return farthest;
}

// Up to rounding, which causes some micrometres in 120 sub-steps.
TEST(Step, a_flat_patch_at_rest_stays_where_it_is_without_gravity) {
    Cloth cloth = make_patch(find_fabric("denim"), {.height = 0.5});
    refine(cloth, 1);
    const std::vector<Vec4f> start = cloth.x;
    for (int i = 0; i < 10; ++i) step(cloth, nothing_near(), {.gravity = Vec3f::Zero(), .contact = kNoContact});
    EXPECT_LT(farthest_move(cloth, start), 1e-5F);
}

// Only rounding errors act, and they have no preferred direction.
TEST(Step, a_flat_patch_that_lies_askew_does_not_drift_away) {
    for (const int level : {0, 1, 2}) {
        Cloth cloth = make_patch(find_fabric("denim"), {.height = 0});
        refine(cloth, level);
        move_to(cloth, Eigen::AngleAxisf(0.7F, Vec3f(3, 1, 2).normalized()).toRotationMatrix(), {0.1F, 1.2F, 0.2F});
        const std::vector<Vec4f> start = cloth.x;
        run(cloth, nothing_near(), {.gravity = Vec3f::Zero(), .contact = kNoContact}, 1.0);
        EXPECT_LT(farthest_move(cloth, start), 1e-4F) << "in a second, level " << level;
    }
}

Vec3d momentum(const Cloth& cloth) {
    Vec3d sum = Vec3d::Zero();
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f moved = cloth.x[v.value] - cloth.x_prev[v.value];
        sum += moved.head<3>().cast<double>() / (double(cloth.inverse_mass[v.value]) * double(cloth.substep));
    }
    return sum;
}

// Internal forces cannot change the total momentum.
TEST(Step, a_crumpled_patch_gains_no_momentum_of_its_own) {
    for (const int level : {0, 1}) {
        std::mt19937 random(31);
        Cloth cloth = make_patch(undamped("wool_twill"), {.height = 0});
        refine(cloth, level);
        shake(cloth, 0.02F, random);
        const double mass = total_mass(cloth);
        double fastest = 0;
        double drift = 0;
        for (int i = 0; i < 30; ++i) {
            step(cloth, nothing_near(), {.gravity = Vec3f::Zero(), .max_move_per_substep = 10, .contact = kNoContact});
            fastest = std::max(fastest, double(speed_now(cloth)));
            drift = std::max(drift, momentum(cloth).norm() / mass);
        }
        EXPECT_GT(fastest, 0.1) << "it hardly moved, so nothing was tested";
        EXPECT_LT(drift, 0.01 * fastest) << "m/s of the centre of mass, level " << level;
    }
}

TEST(Step, no_spare_lane_is_taken_for_a_triangle_beyond_its_strain_limit) {
    Cloth cloth = make_patch(find_fabric("denim"));
    refine(cloth, 1);
    step(cloth, nothing_near(), {.contact = kNoContact});
    const Constraints& constraints = cloth.solver->constraints;
    std::size_t spares = 0;
    for (std::size_t slot = 0; slot < constraints.triangle_of.size(); ++slot) {
        if (constraints.triangle_of[slot] != kNoBlockSlot) continue;
        ++spares;
        EXPECT_GT(constraints.stretch.blocks[slot / kBlock].longest[slot % kBlock], 1e30F)
            << "a spare lane would count as over";
    }
    EXPECT_GT(spares, 0U);
}

TEST(Step, pinned_vertices_do_not_move_at_all) {
    Cloth cloth = make_patch(find_fabric("jersey"));
    cloth.is_pinned[0] = true;
    cloth.is_pinned[4] = true;
    refresh_solver(cloth);
    const Vec4f first = cloth.x[0];
    const Vec4f second = cloth.x[4];
    for (int i = 0; i < 60; ++i) {
        step(cloth, nothing_near(), {.contact = kNoContact});
        if (i % 4 == 3) adapt_cloth(cloth, nothing_near());
        EXPECT_EQ(cloth.x[0], first);
        EXPECT_EQ(cloth.x[4], second);
    }
    EXPECT_GT(speed_now(cloth), 0.01F) << "nothing moved, so nothing was tested";
}

TEST(Step, pulled_seams_close_to_the_gap_that_is_allowed) {
    Cloth cloth = make_patch(find_fabric("silk"), {.quads = 2});
    const std::array<SeamPull, 1> seam{{{0, 2}}};  // two corners, 0.4 m apart
    StepOptions options{.gravity = Vec3f::Zero(), .extra_damping = 12, .contact = kNoContact, .seams = seam};
    for (int i = 0; i < 240; ++i) {
        options.seam_gap = std::max(0.1F, 0.4F - 0.005F * float(i));
        step(cloth, nothing_near(), options);
        ASSERT_LE((cloth.x[0] - cloth.x[2]).norm(), options.seam_gap + 1e-4F);
    }
}

// A cotton strip of 0.1 x 1 m: in theory it stretches by less than 0.1 mm. The rest is the error of the solver.
class HangingStrip : public testing::TestWithParam<int> {};

TEST_P(HangingStrip, comes_to_rest_and_keeps_its_length) {
    for (const double mesh_angle : {0.0, 0.2967, 0.7854}) {
        Cloth cloth = make_strip(find_fabric("cotton_shirting"), {.mesh_angle = mesh_angle, .level = GetParam()});
        const StepOptions options{.extra_damping = 4, .contact = kNoContact};
        run(cloth, nothing_near(), options, 3.0);
        ASSERT_FALSE(find_bad_vertex(cloth).has_value());
        EXPECT_LT(speed_of_next_frames(cloth, nothing_near(), options), 0.01F) << "mesh turned by " << mesh_angle;
        float warp = 0;
        for (const TriangleStrain& strain : measure_strain(cloth)) warp = std::max(warp, strain.warp);
        EXPECT_LT(warp, 0.02F) << "warp strain, mesh turned by " << mesh_angle;
        float lowest = 2;
        for (const VertexId v : cloth.mesh.leaf_vertices()) lowest = std::min(lowest, cloth.x[v.value].y());
        EXPECT_NEAR(lowest, 1.0F, 0.02F) << "hem, mesh turned by " << mesh_angle;
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, HangingStrip, testing::Values(0, 1, 2));

// A strip much softer than cotton: strain w L / k = 4 % at the clamp, total elongation w L^2 / (2 k).
TEST(Step, a_soft_strip_stretches_under_its_weight_as_theory_says) {
    Fabric fabric = find_fabric("cotton_shirting");
    fabric.stretch_warp = 60;  // N/m
    fabric.strain_limit = 0.5;
    const double weight = fabric.area_density * 9.81;
    Cloth cloth = make_strip(fabric);
    run(cloth, nothing_near(), {.extra_damping = 4, .contact = kNoContact}, 4.0);
    float lowest = 2;
    for (const VertexId v : cloth.mesh.leaf_vertices()) lowest = std::min(lowest, cloth.x[v.value].y());
    const double expected = weight / (2 * fabric.stretch_warp);
    EXPECT_NEAR(1 - lowest, expected, 0.2 * expected);
}

struct DropSteps {
    float substep = 1.0F / 960.0F;  // s
    int substeps = 8;
};

struct Dropped {
    Cloth cloth;
    float speed = 0;  // m/s, of the mean motion between two adaptations; the median of the last 15
};

// A patch dropped on the ball with the adaptation of a garment.
Dropped drop_on_ball(const std::string& fabric, const DropSteps& drape, double seconds) {
    Cloth cloth = make_patch(find_fabric(fabric),
                             {.side = 0.5, .quads = 6, .height = 1.2, .max_level = 2, .substep = drape.substep});
    const StepOptions options{.substeps = drape.substeps, .extra_damping = 2};
    const double frame = 4 * double(drape.substep) * drape.substeps;
    std::vector<float> speeds;
    for (double t = 0; t < seconds; t += frame) {
        adapt_cloth(cloth, ball());
        const std::vector<Vec4f> before = cloth.x;
        for (int i = 0; i < 4; ++i) step(cloth, ball(), options);
        speeds.push_back(rms_speed(cloth, before, frame));
    }
    std::nth_element(speeds.end() - 15, speeds.end() - 8, speeds.end());
    return {std::move(cloth), *(speeds.end() - 8)};
}

class EveryFabric : public testing::TestWithParam<std::string> {};

TEST_P(EveryFabric, comes_to_rest_on_a_ball_and_never_inside) {
    const auto [cloth, speed] = drop_on_ball(GetParam(), {}, 5.0);
    ASSERT_FALSE(find_bad_vertex(cloth).has_value());
    EXPECT_GT(deepest(cloth, ball()), -0.0005F);
    EXPECT_LT(speed, 0.01F);
    EXPECT_GT(centre_of_mass(cloth).y(), 0.8) << "it slid off the ball";
}

TEST_P(EveryFabric, survives_sub_steps_eight_times_as_long) {
    const auto [cloth, speed] = drop_on_ball(GetParam(), {.substep = 1.0F / 120.0F, .substeps = 1}, 4.0);
    ASSERT_FALSE(find_bad_vertex(cloth).has_value());
    EXPECT_GT(deepest(cloth, ball()), -0.0005F);
    EXPECT_LT(speed, 0.1F);
}

std::vector<std::string> shipped() {
    return fabric_names();
}
INSTANTIATE_TEST_SUITE_P(Shipped, EveryFabric, testing::ValuesIn(shipped()),
                         [](const auto& instance) { return instance.param; });

// FNV-1a hash over x and x_prev of every step.
struct HashedRun {
    std::uint64_t hash = 14695981039346656037U;

    void add(const std::vector<Vec4f>& points) {
        for (const Vec4f& p : points) {
            for (const float value : p) hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211U;
        }
    }
};
std::uint64_t hash_of_500_steps(Cloth cloth, const Collider& body) {
    HashedRun run;
    for (int i = 0; i < 500; ++i) {
        if (i % 4 == 0) adapt_cloth(cloth, body);
        step(cloth, body, {});
        run.add(cloth.x);
        run.add(cloth.x_prev);
    }
    EXPECT_GT(cloth.mesh.leaf_triangles().size(), cloth.mesh.base_triangle_count());
    return run.hash;
}

// Two garments of a batch, each on its own CPU thread.
TEST(Step, the_same_cloth_on_two_threads_side_by_side_gives_the_same_bits_over_500_steps) {
    const Obstacle sphere(shapes::sphere(Vec3d(0, 1, 0), 0.15, 24));
    const Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.5, .quads = 8, .height = 1.2});
    std::uint64_t beside = 0;
    std::thread other([&] { beside = hash_of_500_steps(cloth, sphere.collider); });
    const std::uint64_t here = hash_of_500_steps(cloth, sphere.collider);
    other.join();
    EXPECT_EQ(here, beside);
}

TEST(Step, the_same_run_twice_gives_the_same_bits) {
    const Cloth first = drop_on_ball("silk", {}, 1.0).cloth;
    const Cloth second = drop_on_ball("silk", {}, 1.0).cloth;
    ASSERT_GT(first.mesh.leaf_triangles().size(), first.mesh.base_triangle_count());
    ASSERT_EQ(first.x.size(), second.x.size());
    EXPECT_EQ(std::memcmp(first.x.data(), second.x.data(), first.x.size() * sizeof(Vec4f)), 0);
    EXPECT_EQ(std::memcmp(first.x_prev.data(), second.x_prev.data(), first.x.size() * sizeof(Vec4f)), 0);
}

// At a height of 2 m floats are 2.4e-7 m apart; this gravity adds 1 % of that to the displacement of a sub-step.
TEST(Step, an_acceleration_too_small_for_the_floats_of_one_substep_is_not_lost) {
    Cloth cloth = make_patch(undamped());
    const double before = centre_of_mass(cloth).y();
    run(cloth, nothing_near(), {.gravity = Vec3f(0, -0.002F, 0), .internal_damping = 0, .contact = {.floor = kNoFloor}},
        1.0);
    EXPECT_NEAR(centre_of_mass(cloth).y() - before, -0.001, 0.0001);
}

constexpr float kPatchArea = 0.16F;  // m^2, of the patch

// Mean velocity, m/s.
Vec3f drift(const Cloth& cloth) {
    Vec4f sum = Vec4f::Zero();
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] <= 0) continue;
        sum += (cloth.x[v.value] - cloth.x_prev[v.value]) / (cloth.inverse_mass[v.value] * cloth.substep);
    }
    return sum.head<3>() / static_cast<float>(total_mass(cloth));
}

TEST(Wind, presses_on_what_stands_across_it_with_the_dynamic_pressure_of_the_air) {
    const Fabric fabric = undamped();
    Cloth cloth = make_patch(fabric);
    const float seconds = 1e-4F;  // too short to follow the wind
    blow(cloth, {.velocity = Vec3f(0, 3, 0), .density = 1.2F, .coefficient = 1.1F}, seconds);
    const double force = 0.5 * 1.2 * 1.1 * 9 * double(kPatchArea);
    EXPECT_NEAR(double(drift(cloth).y()) * total_mass(cloth), force * double(seconds), 0.01 * force * double(seconds));
    EXPECT_NEAR(drift(cloth).x(), 0, 1e-6F);
}

TEST(Wind, along_the_cloth_only_drags) {
    Fabric fabric = undamped();
    fabric.air_drag = 0;
    Cloth smooth = make_patch(fabric);
    blow(smooth, {.velocity = Vec3f(5, 0, 0)}, 0.01F);
    EXPECT_NEAR(drift(smooth).norm(), 0, 1e-6F);

    fabric.air_drag = 0.05;
    Cloth rough = make_patch(fabric);
    blow(rough, {.velocity = Vec3f(5, 0, 0)}, 0.01F);
    const float expected = 5 * (1 - std::exp(-0.05F / float(fabric.area_density) * 0.01F));
    EXPECT_NEAR(drift(rough).x(), expected, 0.01F * expected);
}

TEST(Wind, never_carries_cloth_faster_than_it_blows) {
    for (const char* name : {"silk", "denim"}) {
        Cloth cloth = make_patch(undamped(name));
        for (int i = 0; i < 50; ++i) {
            blow(cloth, {.velocity = Vec3f(0, 40, 0)}, 0.1F);
            EXPECT_LE(drift(cloth).y(), 40.01F) << name;
        }
        EXPECT_GT(drift(cloth).y(), 39.0F) << name;
    }
}

TEST(Wind, in_still_air_a_falling_sheet_comes_to_its_terminal_speed) {
    const Fabric fabric = undamped();
    Cloth cloth = make_patch(fabric, {.height = 60});
    const StepOptions options{.contact = {.floor = kNoFloor}};
    for (int i = 0; i < 240; ++i) {
        blow(cloth, {.coefficient = 1.2F}, step_seconds(cloth, options));
        step(cloth, nothing_near(), options);
    }
    const double terminal = std::sqrt(2 * fabric.area_density * 9.81 / (1.2 * 1.2));
    EXPECT_NEAR(double(-drift(cloth).y()), terminal, 0.06 * terminal);
}

TEST(Wind, does_not_move_what_is_pinned) {
    Cloth cloth = make_patch(undamped());
    const VertexId pinned = cloth.mesh.leaf_vertices()[0];
    cloth.is_pinned[pinned.value] = true;
    refresh_solver(cloth);
    blow(cloth, {.velocity = Vec3f(1, 8, 2)}, 0.05F);
    EXPECT_EQ(cloth.x_prev[pinned.value], cloth.x[pinned.value]);
}

}  // namespace
}  // namespace selvedge::sim::test
