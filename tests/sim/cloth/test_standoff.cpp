// Standoffs: the chords of coarse cloth stay out of a round body, and the contact offset may change.
#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sim/cloth/moving_contact.h"
#include "sim/collide/moving_body.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

constexpr float kSmall = 0.0003F;  // m, contact offset

StepOptions with_offset(float offset) {
    StepOptions stepping{.gravity = Vec3f(0, -9.81F, 0), .extra_damping = 12};
    stepping.contact.offset = offset;
    stepping.contact.floor = kNoFloor;
    stepping.contact.sample_spacing = stepping.contact.sampled_edge = 1;  // m: no samples
    return stepping;
}

// A patch of edges of 3.3 cm that hangs over the ball. Such a chord dips 0.9 mm into it.
Cloth patch_on_the_ball() {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.2, .quads = 6, .height = 1.16, .max_level = 0});
    refresh_contacts(cloth, with_offset(kSmall).contact);
    return cloth;
}

// The least distance of the middle of an edge from the ball, m.
float least_clearance(const Cloth& cloth) {
    float least = 1;
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
        const Vec4f middle = (cloth.x[edge.a.value] + cloth.x[edge.b.value]) / 2;
        least = std::min(least, exact_distance(ball(), middle.head<3>()));
    }
    return least;
}

float largest_standoff(const Cloth& cloth) {
    return *std::ranges::max_element(cloth.solver->contacts.standoff);
}

void fall(Cloth& cloth, bool with_standoffs) {
    for (int i = 0; i < 120; ++i) {
        if (with_standoffs && i % 4 == 0) update_standoffs(cloth, ball());
        step(cloth, ball(), with_offset(kSmall));
    }
}

TEST(Standoff, keeps_the_chords_of_coarse_cloth_out_of_a_ball) {
    Cloth without = patch_on_the_ball(), with = patch_on_the_ball();
    fall(without, false);
    fall(with, true);
    EXPECT_LT(least_clearance(without), -0.0005F);
    EXPECT_GT(least_clearance(with), -ball().max_error() - 1e-4F);
    EXPECT_GT(largest_standoff(with), 0.0005F);
    EXPECT_LE(largest_standoff(with), kMaxStandoff);
}

TEST(Standoff, is_none_where_no_body_is) {
    Cloth cloth = patch_on_the_ball();
    fall(cloth, true);
    ASSERT_GT(largest_standoff(cloth), 0.0005F);
    for (int i = 0; i < 10; ++i) update_standoffs(cloth, nothing_near());
    EXPECT_EQ(largest_standoff(cloth), 0);
}

TEST(Standoff, gives_no_velocity) {
    Cloth cloth = patch_on_the_ball();
    fall(cloth, false);
    const std::vector<Vec4f> x = cloth.x, x_prev = cloth.x_prev;
    update_standoffs(cloth, ball());
    float moved = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f by = cloth.x[v.value] - x[v.value];
        EXPECT_LT((cloth.x_prev[v.value] - x_prev[v.value] - by).norm(), 1e-6F);
        moved = std::max(moved, by.norm());
    }
    EXPECT_GT(moved, 0.0002F);
}

// A chord from the top of a ball, whose middle is clear of it: a quarter of the way from there it is 3 mm deep.
TEST(Standoff, finds_cloth_that_is_deepest_beside_its_middle_on_a_body_that_moves) {
    const MovingBodyCollider moving(shapes::sphere(Vec3d(0, 1, 0), 0.15, 48));
    Cloth cloth =
        make_patch(find_fabric("cotton_shirting"), {.side = 0.16, .quads = 1, .height = 1.151, .max_level = 0});
    std::vector<VertexId> on_top;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const bool is_on_top = cloth.x[v.value].x() < 0;
        const float z = 0.05F * cloth.x[v.value].z();
        cloth.x[v.value].head<3>() = is_on_top ? Vec3f(0, 1.151F, z) : Vec3f(0.16F, 1.111F, z);
        cloth.x_prev[v.value] = cloth.x[v.value];
        if (is_on_top) on_top.push_back(v);
    }
    ASSERT_EQ(on_top.size(), 2U);
    ContactOptions options{.offset = kSmall};
    options.sample_spacing = options.sampled_edge = 1;  // m: no samples
    refresh_contacts(cloth, options);
    find_moving_contacts(cloth, moving, options, 12);
    update_standoffs(cloth, moving);
    for (const VertexId v : on_top) EXPECT_EQ(cloth.solver->contacts.standoff[v.value], kMaxStandoff);
}

// What the corners of a patch know of the skin tells nothing of a bump between them.
TEST(Standoff, finds_a_bump_of_a_body_that_moves) {
    Body body = shapes::sphere(Vec3d(0, 1, 0), 0.15, 192);
    const auto top = std::ranges::max_element(body.x, {}, [](const Vec3d& x) { return x.y(); });
    top->y() += 0.0015;
    const MovingBodyCollider moving(body);
    Cloth cloth =
        make_patch(find_fabric("cotton_shirting"), {.side = 0.02, .quads = 1, .height = 1.1497, .max_level = 0});
    ContactOptions options{.offset = kSmall};
    options.sample_spacing = options.sampled_edge = 1;  // m: no samples
    refresh_contacts(cloth, options);
    const LeafEdge diagonal = *std::ranges::max_element(cloth.mesh.leaf_edges(), {}, &LeafEdge::rest_length);
    const auto clearance = [&] {
        const Vec4f middle = (cloth.x[diagonal.a.value] + cloth.x[diagonal.b.value]) / 2;
        return moving.surface().closest(middle.head<3>(), 1)->distance;
    };
    EXPECT_LT(clearance(), -0.001F);
    for (int i = 0; i < 6; ++i) {
        find_moving_contacts(cloth, moving, options, 12);
        cloth.solver->points = solver_points(cloth, cloth.x);
        end_moving_contacts(cloth, options);
        update_standoffs(cloth, moving);
    }
    EXPECT_GT(clearance(), 0);
}

// The cache of contacts holds heights above the offset surface.
TEST(Standoff, lets_cloth_settle_on_a_smaller_contact_offset) {
    Cloth cloth = patch_on_the_ball();
    for (int i = 0; i < 120; ++i) step(cloth, ball(), with_offset(0.003F));
    const auto nearest = [&] {
        float least = 1;
        for (const VertexId v : cloth.mesh.leaf_vertices())
            least = std::min(least, exact_distance(ball(), cloth.x[v.value].head<3>()));
        return least;
    };
    EXPECT_GT(nearest(), 0.002F);
    for (int i = 0; i < 120; ++i) step(cloth, ball(), with_offset(kSmall));
    EXPECT_LT(nearest(), 0.001F);
}

}  // namespace
}  // namespace selvedge::sim::test
