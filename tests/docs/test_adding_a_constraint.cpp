// The example of docs/adding-a-constraint.md works.
#include <gtest/gtest.h>
#include <cstring>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/solver_lists.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"
#include "sim/mesh/square.h"
#include "tests/docs/foundation.h"

namespace selvedge::sim {
namespace {

constexpr float kNoFloor = -1000;  // m

Cloth horizontal_square() {
    Cloth cloth = make_cloth(sim::make_square(), {find_fabric("cotton_shirting")});
    refresh_contacts(cloth);
    return cloth;
}

void split_all(Cloth& cloth, int level) {
    const MinimumLevelDisc disc{.panel = 0, .centre = Vec2f::Zero(), .radius = 10, .level = level};
    adapt_cloth(cloth, NoBody{}, {.criteria = {false, false, false}, .minimum_levels = {&disc, 1}, .shortest_edge = 0});
}

// [test]
TEST(Foundation, bears_the_weight_of_the_cloth_where_theory_says) {
    Cloth cloth = horizontal_square();
    Foundation foundation;
    make_foundation(foundation, cloth);
    StepOptions options{.extra_damping = 20, .contact = {.floor = kNoFloor}};
    options.solve_more = [&](float* points) { solve_foundation(foundation, points); };
    for (int i = 0; i < 120; ++i) step(cloth, NoBody{}, options);
    const auto depth = static_cast<float>(find_fabric("cotton_shirting").area_density * 9.81) / foundation.stiffness;
    for (const VertexId v : cloth.mesh.leaf_vertices()) EXPECT_NEAR(cloth.x[v.value].y(), -depth, 0.05F * depth);
}
// [/test]

TEST(Foundation, changes_with_the_mesh_as_if_it_were_made_anew) {
    Cloth cloth = horizontal_square();
    split_all(cloth, 3);  // now the mesh has room for what follows
    split_all(cloth, 1);
    Foundation changed, made;
    make_foundation(changed, cloth);
    split_all(cloth, 2);
    change_foundation(changed, cloth);
    make_foundation(made, cloth);
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const std::uint32_t a = changed.set.slot_of(leaf.triangle), b = made.set.slot_of(leaf.triangle);
        ASSERT_NE(a, kNoBlockSlot);
        EXPECT_EQ(corners_at(changed.set.blocks[a / kBlock], a % kBlock), indices(leaf.v));
        EXPECT_EQ(changed.set.blocks[a / kBlock].gain[a % kBlock], made.set.blocks[b / kBlock].gain[b % kBlock]);
    }
}

// Heights after 0.1 s with the kernels of this level, or of the highest that this processor has.
std::vector<Vec4f> fallen_at(SimdLevel level) {
    const SimdLimit limit(level);
    Cloth cloth = horizontal_square();
    Foundation foundation;
    make_foundation(foundation, cloth);
    StepOptions options{.contact = {.floor = kNoFloor}};
    options.solve_more = [&](float* points) { solve_foundation(foundation, points); };
    for (int i = 0; i < 12; ++i) step(cloth, NoBody{}, options);
    return cloth.x;
}

TEST(Foundation, has_the_same_bits_with_both_vector_levels) {
    const std::vector<Vec4f> wide = fallen_at(SimdLevel::Avx512), narrow = fallen_at(SimdLevel::Avx2);
    EXPECT_EQ(std::memcmp(wide.data(), narrow.data(), wide.size() * sizeof(Vec4f)), 0);
    const std::vector<Vec4f> plain = fallen_at(SimdLevel::Plain);
    for (std::size_t v = 0; v < wide.size(); ++v) EXPECT_NEAR(wide[v].y(), plain[v].y(), 1e-6F);
}

TEST(Foundation, keeps_a_cloth_from_resting) {
    const NoBody body;
    Cloth cloth = horizontal_square();
    StepOptions options{.gravity = Vec3f::Zero(), .contact = {.floor = kNoFloor}, .may_rest = true};
    for (int i = 0; i < 120; ++i) step(cloth, body, options);
    EXPECT_EQ(step(cloth, body, options).substeps, 0) << "it rests without one";
    options.solve_more = [](float*) {};
    EXPECT_GT(step(cloth, body, options).substeps, 0);
}

}  // namespace
}  // namespace selvedge::sim
