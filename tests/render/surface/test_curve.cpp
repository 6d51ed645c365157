#include "render/surface/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/surface/curved_mesh.h"
#include "sim/adaptive/check.h"
#include "sim/collide/collider.h"
#include "sim/dress/report.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::render {
namespace {

// Puts the leaf vertices of a horizontal patch on a wave of this height, m.
void wave(sim::Cloth& cloth, float height) {
    for (const sim::VertexId v : cloth.mesh.leaf_vertices()) {
        Vec4f& x = cloth.x[v.value];
        x.y() = 2 + height * std::sin(20 * x.x() + 6 * x.z());
    }
}

sim::Cloth waving_patch(float height = 0.03F) {
    sim::Cloth cloth = sim::test::make_patch(sim::test::undamped());
    wave(cloth, height);
    return cloth;
}

sim::PlainMesh leaves_of(const sim::Cloth& cloth) {
    return sim::plain_mesh(cloth, {"patch"});
}

TEST(SurfaceOverCloth, is_the_curved_mesh_of_the_leaves) {
    sim::Cloth cloth = waving_patch();
    sim::test::refine(cloth, 1);
    wave(cloth, 0.03F);
    const sim::PlainMesh leaves = leaves_of(cloth);
    const sim::SphereCollider body{Vec3f(0, 1.9F, 0), 0.1F};
    CurveOptions near_body;
    near_body.move.body = &body;
    for (const CurveOptions& options : {CurveOptions{}, CurveOptions{.kind = SurfaceKind::Restore},
                                        CurveOptions{.level = 2}, CurveOptions{.deepest_level = 1}, near_body}) {
        SurfaceOverCloth over;
        const sim::PlainMesh drawn = plain_mesh(over.curve(cloth, options), leaves);
        EXPECT_EQ(drawn, curved_mesh(leaves, {.curve = options}));
        EXPECT_GT(drawn.triangles.size(), leaves.triangles.size());
    }
}

TEST(SurfaceOverCloth, follows_the_cloth_from_frame_to_frame) {
    sim::Cloth cloth = waving_patch(0);
    SurfaceOverCloth over;
    over.curve(cloth, {.level = 2});
    for (const float height : {0.01F, 0.03F, -0.02F}) {
        wave(cloth, height);
        const sim::PlainMesh leaves = leaves_of(cloth);
        const CurvedSurface& surface = over.curve(cloth, {.level = 2});
        EXPECT_EQ(plain_mesh(surface, leaves), curved_mesh(leaves, {.curve = {.level = 2}}));
        EXPECT_TRUE(check(surface.mesh).empty());
    }
}

TEST(SurfaceOverCloth, refines_at_once_what_begins_to_bend) {
    sim::Cloth cloth = waving_patch(0);
    SurfaceOverCloth over;
    EXPECT_EQ(over.curve(cloth).mesh.leaf_triangles().size(), cloth.mesh.leaf_triangles().size());
    wave(cloth, 0.03F);
    const sim::PlainMesh leaves = leaves_of(cloth);
    EXPECT_EQ(plain_mesh(over.curve(cloth), leaves).triangles.size(), curved_mesh(leaves).triangles.size());
}

TEST(SurfaceOverCloth, that_glides_moves_new_vertices_out_gradually) {
    sim::Cloth cloth = waving_patch(0);
    SurfaceOverCloth over;
    CurveOptions gliding{.glides = true};
    gliding.move.max_step = 0.0005F;
    over.curve(cloth, gliding);
    wave(cloth, 0.03F);
    const CurvedSurface& surface = over.curve(cloth, gliding);
    const auto are_shown = [&](const auto& as) {
        const auto vertices = surface.mesh.leaf_vertices();
        return std::ranges::count_if(vertices, [&](sim::VertexId v) { return as(surface.shown[v.value]); });
    };
    const auto added = are_shown([](float shown) { return shown == 0; });
    EXPECT_GT(added, 0) << "at the middles of their edges";
    over.curve(cloth, gliding);
    EXPECT_GT(are_shown([](float shown) { return shown > 0 && shown < 1; }), added / 2);
    for (int frame = 0; frame < 200; ++frame) over.curve(cloth, gliding);
    EXPECT_EQ(are_shown([](float shown) { return shown < 1; }), 0);
    EXPECT_GT(surface.mesh.leaf_triangles().size(), cloth.mesh.leaf_triangles().size());
}

TEST(SurfaceOverCloth, is_made_anew_and_refined_at_once_when_the_leaves_change) {
    sim::Cloth cloth = waving_patch();
    SurfaceOverCloth over;
    EXPECT_EQ(over.curve(cloth, {.glides = true}).mesh.base_triangle_count(), 32U);
    sim::test::refine(cloth, 1);
    wave(cloth, 0.03F);
    const CurvedSurface& surface = over.curve(cloth, {.glides = true});
    EXPECT_EQ(surface.mesh.base_triangle_count(), 128U);
    EXPECT_EQ(plain_mesh(surface, leaves_of(cloth)), curved_mesh(leaves_of(cloth)));
}

TEST(SurfaceOverCloth, is_made_anew_for_another_cloth_after_as_many_adaptations) {
    const sim::Cloth first = waving_patch();
    sim::Cloth second = sim::test::make_patch(sim::test::undamped(), {.side = 0.5});  // the same indices
    wave(second, 0.03F);
    ASSERT_EQ(first.adaptations, second.adaptations);
    SurfaceOverCloth over;
    over.curve(first);
    EXPECT_EQ(plain_mesh(over.curve(second), leaves_of(second)), curved_mesh(leaves_of(second)));
}

TEST(SurfaceOverCloth, is_made_anew_for_other_curves) {
    const sim::Cloth cloth = waving_patch();
    SurfaceOverCloth over;
    over.curve(cloth, {.level = 2});
    const CurveOptions flat{.kind = SurfaceKind::Flat, .level = 1};
    EXPECT_EQ(plain_mesh(over.curve(cloth, flat), leaves_of(cloth)), curved_mesh(leaves_of(cloth), {.curve = flat}));
}

}  // namespace
}  // namespace selvedge::render
