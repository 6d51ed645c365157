// A drape under way, frame by frame.
#include "sim/dress/drape.h"

#include <gtest/gtest.h>

#include "sim/adaptive/square.h"
#include "sim/body/analytic_collider.h"

namespace selvedge::test {
namespace {

const SphereCollider& ball() {
    static const SphereCollider sphere(Vec3f(0, 1, 0), 0.15F);
    return sphere;
}

Cloth cloth_above_the_ball() {
    return make_cloth(make_square({.columns = 6, .rows = 6, .width = 0.4, .depth = 0.4, .height = 1.17}),
                      {find_fabric("cotton_shirting")}, {.max_level = 2});
}

// Falls for ever, as far as its time goes.
DrapeOptions endless() {
    return {.max_seconds = 1e6, .rest_time = 1e6, .relax_time = 0.1, .coarse_time = 0, .may_rest = true};
}

TEST(DrapeRun, a_cloth_at_rest_is_neither_adapted_nor_stepped) {
    Cloth cloth = cloth_above_the_ball();
    DrapeRun run(cloth, endless());
    for (int frame = 0; frame < 600 && !is_at_rest(cloth); ++frame) run.advance(cloth, ball());
    ASSERT_TRUE(is_at_rest(cloth));
    ASSERT_GT(cloth.mesh.leaf_triangles().size(), cloth.mesh.base_triangle_count());
    const std::vector<Vec4f> there = cloth.x;
    const std::uint32_t adaptions = cloth.adaptations;
    run.forget_times();
    for (int frame = 0; frame < 60; ++frame) run.advance(cloth, ball());
    EXPECT_EQ(cloth.x, there);
    EXPECT_EQ(cloth.adaptations, adaptions);
    EXPECT_TRUE(run.result().adaption_ms.empty());
    EXPECT_EQ(run.result().rms_speed, 0);
}

TEST(DrapeRun, rests_only_where_that_is_asked_for) {
    Cloth cloth = cloth_above_the_ball();
    DrapeOptions options = endless();
    options.may_rest = false;
    DrapeRun run(cloth, options);
    for (int frame = 0; frame < 300; ++frame) run.advance(cloth, ball());
    EXPECT_FALSE(is_at_rest(cloth));
    EXPECT_EQ(run.result().adaption_ms.size(), 300U);
}

}  // namespace
}  // namespace selvedge::test
