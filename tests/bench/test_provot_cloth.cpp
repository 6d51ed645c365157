// The thesis' own cloth: forces of bending, corrections of lengths, collisions.
#include "bench/thesis/provot_cloth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bench/support/measured_mesh.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/collide/collider.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

constexpr float kSubstep = 1.0F / 480;  // s

sim::Cloth patch(double height = 0) {
    return make_cloth(sim::make_square({.columns = 4, .rows = 4, .height = height}),
                      {sim::find_fabric("cotton_shirting")}, {.substep = kSubstep});
}

ProvotOptions options_for(const sim::Cloth& cloth) {
    return {.spring = stable_spring(static_cast<float>(cloth.material.fabrics[0].area_density), 0.25F, kSubstep)};
}

// Two triangles about the x axis; each is turned up by `angle` / 2 out of the plane.
std::array<Vec3f, 4> hinge(float angle) {
    const float c = std::cos(angle / 2), s = std::sin(angle / 2);
    return {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0.3F, 0.8F * c, 0.8F * s), Vec3f(0.6F, -0.5F * c, 0.5F * s)};
}

TEST(ProvotCloth, bending_forces_flatten_a_hinge_and_neither_push_nor_turn_it_as_a_whole) {
    for (const float angle : {-0.8F, 0.4F}) {
        const std::array<Vec3f, 4> x = hinge(angle), f = bending_forces(x, 0.01F);
        Vec3f force = Vec3f::Zero(), torque = Vec3f::Zero();
        float power = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            force += f[i];
            torque += x[i].cross(f[i]);
            power += f[i].dot(hinge(angle * 0.99F)[i] - x[i]);
        }
        EXPECT_LT(force.norm(), 1e-6F);
        EXPECT_LT(torque.norm(), 1e-6F);
        EXPECT_GT(power, 0) << angle;
    }
    for (const Vec3f& f : bending_forces(hinge(0), 0.01F)) EXPECT_LT(f.norm(), 1e-6F);
}

TEST(ProvotCloth, falls_freely_where_nothing_holds_it) {
    sim::Cloth cloth = patch();
    ProvotOptions options = options_for(cloth);
    options.damping = 0;
    for (int i = 0; i < 60; ++i) provot_step(cloth, sim::NoBody{}, options);  // 0.5 s
    for (const sim::VertexId v : cloth.mesh.leaf_vertices())
        EXPECT_NEAR(cloth.x[v.value].y(), -9.81F / 2 * 0.25F, 9.81F * 0.5F * kSubstep);
}

TEST(ProvotCloth, corrections_keep_what_hangs_near_the_allowed_length_where_weak_springs_do_not) {
    const auto lowest_after = [](int corrections) {
        sim::Cloth cloth = patch();
        for (std::size_t v = 0; v < 5; ++v) cloth.is_pinned[v] = true;
        refresh_solver(cloth);
        ProvotOptions options = options_for(cloth);
        options.spring *= 0.004F;
        options.corrections = corrections;
        options.damping = 4;
        for (int i = 0; i < 480; ++i) provot_step(cloth, sim::NoBody{}, options);
        return -sim::lowest_height(cloth);
    };
    EXPECT_GT(lowest_after(0), 1.4F);
    EXPECT_LT(lowest_after(4), 1.2F);
}

TEST(ProvotCloth, stays_outside_of_a_sphere_at_its_vertices_and_finite_at_every_level) {
    const sim::SphereCollider sphere(Vec3f::Zero(), 0.25F);
    for (const int level : {0, 2}) {
        sim::Cloth cloth = patch(0.3);
        const sim::MinimumLevelDisc disc{.panel = 0, .centre = Vec2f::Zero(), .radius = 10, .level = level};
        adapt_cloth(cloth, sphere, {.criteria = {false, false, false}, .minimum_levels = {&disc, 1}});
        ProvotOptions options = options_for(cloth);
        options.spring = stable_spring(0.12F, 0.25F / static_cast<float>(1 << level), kSubstep);
        for (int i = 0; i < 120; ++i) provot_step(cloth, sphere, options);
        EXPECT_FALSE(find_bad_vertex(cloth).has_value());
        for (const sim::VertexId v : cloth.mesh.leaf_vertices())
            EXPECT_GT(sphere.contact(cloth.x[v.value].head<3>()).distance, 0.0F);
    }
}

}  // namespace
}  // namespace selvedge::bench
