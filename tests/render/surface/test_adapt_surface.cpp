#include "render/surface/adapt_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/adaptive/check.h"
#include "sim/collide/collider.h"
#include "tests/render/surface/fixtures.h"

namespace selvedge::render::test {
namespace {

constexpr float kMaxJump = 0.0005F;  // m

std::size_t triangles(const CurvedSurface& surface) {
    return surface.mesh.leaf_triangles().size();
}

CurvedSurface settled(const sim::GarmentMesh& base, const AdaptSurfaceOptions& options = {}) {
    CurvedSurface surface = make_curved_surface(base, {.max_level = 3});
    const Coarse coarse = coarse_of(base);
    settle_surface(surface, coarse.x, coarse.normals, options);
    return surface;
}

TEST(AdaptSurface, leaves_flat_cloth_as_it_is) {
    const sim::GarmentMesh base = shaped_square(4, [](double x, double y) { return Vec3d(x, 0, -y); });
    EXPECT_EQ(triangles(settled(base)), base.triangles.size());
}

TEST(AdaptSurface, refines_what_is_bent_and_keeps_what_is_flat) {
    // The left half is flat, the right half an arch.
    const sim::GarmentMesh base = shaped_square(8, [](double x, double y) {
        return x < 0 ? Vec3d(x, 0, -y) : Vec3d(0.2 * std::sin(x / 0.2), 0.2 * std::cos(x / 0.2) - 0.2, -y);
    });
    const CurvedSurface surface = settled(base);
    EXPECT_GT(triangles(surface), 2 * base.triangles.size());
    EXPECT_LT(triangles(surface), base.triangles.size() << 6);
    for (const sim::LeafTriangle& t : surface.mesh.leaf_triangles()) {
        const float right =
            std::max({surface.x[t.v[0].value].x(), surface.x[t.v[1].value].x(), surface.x[t.v[2].value].x()});
        if (right < -0.26F) {
            EXPECT_EQ(t.level, 0);
        }
    }
    EXPECT_TRUE(check(surface.mesh).empty());
}

TEST(AdaptSurface, refines_edges_that_are_shorter_than_their_material) {
    // Too flat for the curvature criterion, but compressed by a tenth.
    const sim::GarmentMesh base =
        shaped_square(4, [](double x, double y) { return Vec3d(0.9 * x, 0.15 * (0.25 - x * x - y * y), -0.9 * y); });
    const SurfaceCriteria only_buckling{.curvature = false, .buckling = true};
    const SurfaceCriteria none{.curvature = false, .buckling = false};
    EXPECT_GT(triangles(settled(base, {.criteria = only_buckling})), 8 * base.triangles.size());
    const SurfaceCriteria only_curvature{.curvature = true, .buckling = false};
    EXPECT_EQ(triangles(settled(base, {.criteria = none})), base.triangles.size());
    EXPECT_EQ(triangles(settled(base, {.criteria = only_curvature})), base.triangles.size());
}

TEST(AdaptSurface, keeps_what_is_turned_away_coarse) {
    const sim::GarmentMesh base = shaped_square(8, [](double x, double y) {
        return Vec3d(0.16 * std::sin(6 * x), 0.16 * std::cos(6 * x), -y);  // nearly a closed tube
    });
    sim::Visibility from_above({.eye = Vec3f(0, 5, 0)});
    const CurvedSurface all = settled(base), seen = settled(base, {.visibility = &from_above});
    EXPECT_LT(5 * triangles(seen), 4 * triangles(all));
    const auto fine_on_top = [](const CurvedSurface& surface) {
        const auto leaves = surface.mesh.leaf_triangles();
        return std::count_if(leaves.begin(), leaves.end(), [&](const sim::LeafTriangle& t) {
            const auto is_on_top = [&](sim::VertexId v) { return surface.x[v.value].y() > 0.03F; };
            return std::all_of(t.v.begin(), t.v.end(), is_on_top);
        });
    };
    EXPECT_EQ(fine_on_top(seen), fine_on_top(all));
}

TEST(AdaptSurface, splits_no_edge_whose_curve_hardly_leaves_its_chord) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    const std::size_t fine = triangles(settled(base)),
                      coarse = triangles(settled(base, {.criteria = {.min_bulge = 0.004F}}));
    EXPECT_LT(2 * coarse, fine);
    EXPECT_GT(coarse, base.triangles.size());
    EXPECT_EQ(triangles(settled(base, {.criteria = {.min_bulge = 1}})), base.triangles.size());
}

TEST(AdaptSurface, never_splits_below_the_shortest_edge) {
    const CurvedSurface surface = settled(shaped_square(4, on_waves), {.criteria = {.shortest_edge = 0.1F}});
    for (const sim::LeafEdge& e : surface.mesh.leaf_edges()) EXPECT_GE(e.rest_length, 0.05F);
    EXPECT_GT(triangles(surface), triangles(make_curved_surface(shaped_square(4, on_waves))));
}

// Largest move of a vertex; a new vertex starts at the midpoint of its edge.
float greatest_jump(const CurvedSurface& before, const CurvedSurface& after) {
    float most = 0;
    for (const sim::VertexId v : after.mesh.leaf_vertices()) {
        const sim::EdgeId parent = after.mesh.vertex(v).parent;
        const bool was_there = v.value < before.x.size() && v.value >= before.mesh.base_vertex_count() && parent &&
                               parent.value < before.mesh.edges().capacity() && before.mesh.edge(parent).centre == v &&
                               before.mesh.edge(parent).ends == after.mesh.edge(parent).ends;
        if (was_there) {
            most = std::max(most, (after.x[v.value] - before.x[v.value]).norm());
        } else if (parent) {
            const auto [a, b] = after.mesh.edge(parent).ends;
            most = std::max(most, (after.x[v.value] - (after.x[a.value] + after.x[b.value]) * 0.5F).norm());
        }
    }
    return most;
}

// Largest distance from the midpoint of its edge at which a vertex was removed by a rejoin.
float greatest_leap_of_what_went(const CurvedSurface& before, const CurvedSurface& after) {
    float most = 0;
    for (int level = 0; level < before.mesh.max_level(); ++level) {
        for (const sim::EdgeId e : before.mesh.split_edges(level)) {
            if (after.mesh.is_split(e) && after.mesh.centre(e) == before.mesh.centre(e)) continue;
            const auto [a, b] = before.mesh.edge(e).ends;
            const Vec4f middle = (before.x[a.value] + before.x[b.value]) * 0.5F;
            most = std::max(most, (before.x[before.mesh.centre(e).value] - middle).norm());
        }
    }
    return most;
}

TEST(AdaptSurface, glides_so_that_no_vertex_jumps_and_arrives_where_it_would_be_at_once) {
    const sim::GarmentMesh base = shaped_square(6, on_waves);
    const Coarse coarse = coarse_of(base);
    CurvedSurface surface = make_curved_surface(base, {.max_level = 3});
    update_surface(surface, coarse.x, coarse.normals);
    int still = 0;
    for (int frame = 0; frame < 600 && still < 30; ++frame) {
        const CurvedSurface before = surface;
        const bool changed = adapt_surface(surface, {.glides = true}).changed();
        update_surface(surface, coarse.x, coarse.normals);
        ASSERT_LT(greatest_jump(before, surface), kMaxJump);
        ASSERT_LT(greatest_leap_of_what_went(before, surface), 1e-6F);
        still = changed || surface.x != before.x ? 0 : still + 1;
    }
    EXPECT_EQ(still, 30);
    // Which edges are split may differ within the hysteresis; the positions of the vertices must not.
    const ByMaterial uniform = by_material(surface_at_level(base, 3)), glided = by_material(surface);
    for (const auto& [material, x] : glided) EXPECT_EQ(x, uniform.at(material));
    const double at_once = static_cast<double>(by_material(settled(base)).size());
    EXPECT_NEAR(static_cast<double>(glided.size()), at_once, 0.1 * at_once);
}

TEST(AdaptSurface, glides_out_and_rejoins_what_is_no_longer_seen) {
    const sim::GarmentMesh base =
        shaped_square(8, [](double x, double y) { return Vec3d(0.16 * std::sin(6 * x), 0.16 * std::cos(6 * x), -y); });
    const Coarse coarse = coarse_of(base);
    sim::Visibility view({.eye = Vec3f(0, 5, 0)});
    CurvedSurface surface = settled(base, {.visibility = &view});
    const CurvedSurface start = surface;
    float angle = 0;
    int splits = 0, rejoins = 0;
    for (int frame = 0; frame < 900; ++frame) {
        angle = std::min(3.14159F, angle + 0.01F);
        view.move_to({.eye = Vec3f(5 * std::sin(angle), 5 * std::cos(angle), 0)});
        const CurvedSurface before = surface;
        const sim::AdaptReport report = adapt_surface(surface, {.visibility = &view, .glides = true});
        update_surface(surface, coarse.x, coarse.normals);
        splits += report.splits;
        rejoins += report.rejoins;
        ASSERT_LT(greatest_jump(before, surface), kMaxJump) << frame;
        ASSERT_LT(greatest_leap_of_what_went(before, surface), 1e-6F) << frame;
    }
    EXPECT_GT(splits, 100);
    EXPECT_GT(rejoins, 100);
    EXPECT_TRUE(check(surface.mesh).empty());
}

TEST(AdaptSurface, glides_down_to_a_lower_level_too) {
    const sim::GarmentMesh base = shaped_square(6, on_waves);
    const Coarse coarse = coarse_of(base);
    CurvedSurface surface = settled(base);
    const auto deepest = [&] {
        int level = 0;
        for (const sim::LeafTriangle& t : surface.mesh.leaf_triangles()) level = std::max<int>(level, t.level);
        return level;
    };
    ASSERT_EQ(deepest(), 3);
    for (int frame = 0; frame < 300; ++frame) {
        const CurvedSurface before = surface;
        adapt_surface(surface, {.max_level = 1, .glides = true});
        update_surface(surface, coarse.x, coarse.normals);
        ASSERT_LT(greatest_jump(before, surface), kMaxJump) << frame;
        ASSERT_LT(greatest_leap_of_what_went(before, surface), 1e-6F) << frame;
    }
    EXPECT_EQ(deepest(), 1);
}

TEST(AdaptSurface, settles_at_once_whatever_was_on_its_way) {
    const sim::GarmentMesh base = shaped_square(6, on_waves);
    const Coarse coarse = coarse_of(base);
    CurvedSurface surface = make_curved_surface(base, {.max_level = 3});
    for (int frame = 0; frame < 5; ++frame) {
        adapt_surface(surface, {.glides = true});
        update_surface(surface, coarse.x, coarse.normals);
    }
    settle_surface(surface, coarse.x, coarse.normals);
    const std::vector<Vec4f> at_rest = surface.x;
    update_surface(surface, coarse.x, coarse.normals);
    EXPECT_EQ(surface.x, at_rest);
    const ByMaterial uniform = by_material(surface_at_level(base, 3));
    for (const auto& [material, x] : by_material(surface)) EXPECT_EQ(x, uniform.at(material));
}

TEST(AdaptSurface, keeps_clear_of_the_body_while_vertices_glide) {
    constexpr float radius = 0.15F, offset = 0.003F;
    const sim::SphereCollider ball(Vec3f::Zero(), radius);
    const sim::GarmentMesh base = shaped_square(4, [&](double x, double y) {
        return Vec3d(Vec3d(0.7 * x, 0.4, -0.7 * y).normalized() * double(radius + offset));
    });
    const Coarse coarse = coarse_of(base);
    CurvedSurface surface = make_curved_surface(base, {.max_level = 3});
    const MoveOptions move{.body = &ball, .offset = offset};
    long arrived = 0;  // new vertices on their curves
    for (int frame = 0; frame < 200; ++frame) {
        adapt_surface(surface, {.max_level = frame < 100 ? 3 : 1, .glides = true});
        update_surface(surface, coarse.x, coarse.normals, move);
        for (const sim::VertexId v : surface.mesh.leaf_vertices()) {
            if (surface.shown[v.value] < 1) continue;
            ASSERT_GT(surface.x[v.value].norm(), radius + offset - 1e-4F) << frame;
            arrived += v.value >= surface.mesh.base_vertex_count() ? 1 : 0;
        }
    }
    EXPECT_GT(arrived, 1000);
}

}  // namespace
}  // namespace selvedge::render::test
