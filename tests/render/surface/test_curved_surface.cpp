#include "render/surface/curved_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/adaptive/check.h"
#include "sim/collide/collider.h"
#include "tests/render/surface/fixtures.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::render::test {
namespace {

// Mean distance from the arch's cylinder, m.
float off_the_arch(const CurvedSurface& surface) {
    float sum = 0;
    for (const sim::VertexId v : surface.mesh.leaf_vertices())
        sum += std::abs(surface.x[v.value].head<2>().norm() - 0.4F);
    return sum / static_cast<float>(surface.mesh.leaf_vertices().size());
}

TEST(CurvedSurface, has_four_times_the_triangles_with_each_level) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    for (int level = 0; level <= 3; ++level) {
        const CurvedSurface surface = surface_at_level(base, level);
        EXPECT_EQ(surface.mesh.leaf_triangles().size(), base.triangles.size() << (2 * level));
        EXPECT_TRUE(check(surface.mesh).empty());
    }
}

TEST(CurvedSurface, goes_through_the_coarse_cloths_vertices) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    const CurvedSurface surface = surface_at_level(base, 3);
    for (std::size_t v = 0; v < base.x.size(); ++v)
        EXPECT_EQ(Vec3f(surface.x[v].head<3>()), Vec3f(base.x[v].cast<float>()));
}

TEST(CurvedSurface, of_a_coarse_arch_is_rounder_than_its_facets) {
    const sim::GarmentMesh base = shaped_square(8, on_arch);
    const float flat = off_the_arch(surface_at_level(base, 2, SurfaceKind::Flat));
    const float curved = off_the_arch(surface_at_level(base, 2));
    EXPECT_GT(flat, 0.001F);
    EXPECT_LT(curved, 0.4F * flat);
}

TEST(CurvedSurface, has_each_vertex_at_the_same_place_whatever_else_is_split) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    const Coarse coarse = coarse_of(base);
    const ByMaterial uniform = by_material(surface_at_level(base, 3));
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        CurvedSurface surface = make_curved_surface(base, {.max_level = 3});
        SurfaceObserver observer(surface, SurfaceObserver::SpawnPosition::Curve);
        for (int i = 0; i < 5; ++i)
            adapt(surface.mesh, observer, {},
                  sim::test::RandomCriterion{.random = random, .split_share = 0.3, .rejoin_share = 0.2});
        plan_surface(surface);
        move_surface(surface, coarse.x, coarse.normals);
        ASSERT_GT(surface.mesh.leaf_triangles().size(), base.triangles.size());
        for (const auto& [material, x] : by_material(surface)) {
            ASSERT_TRUE(uniform.contains(material));
            EXPECT_EQ(x, uniform.at(material));
        }
    }
}

// Where the middle of an edge's curve lies, from the edge's ends, their normals and the length of its material.
Vec4f middle_of_curve(const CurvedSurface& surface, sim::EdgeId e) {
    const auto [a, b] = surface.mesh.edge(e).ends;
    const Vec4f &xa = surface.x[a.value], &xb = surface.x[b.value];
    const Vec4f &na = surface.normals[a.value], &nb = surface.normals[b.value];
    const Vec4f chord = xb - xa;
    const float m = modified(surface.modifier, surface.mesh.rest_length(e) / chord.norm());
    return (xa + xb) / 2 + (nb * chord.dot(nb) - na * chord.dot(na)) * (m / 8);
}

// The arch is a tenth narrower than its material, so lengths matter.
TEST(CurvedSurface, bends_the_edges_inside_triangles_by_the_length_of_their_material_too) {
    const sim::GarmentMesh base = shaped_square(4, [](double x, double y) {
        const Vec3d on = on_arch(x, y);
        return Vec3d(0.9 * on.x(), on.y(), on.z());
    });
    const CurvedSurface surface = surface_at_level(base, 3, SurfaceKind::Quadratic);
    int inside = 0;
    for (int level = 0; level < 2; ++level) {
        for (const sim::TriangleId id : surface.mesh.refined_triangles(level)) {
            const sim::AdaptiveTriangle& t = surface.mesh.triangle(id);
            for (std::size_t i = 0; i < layout(t.configuration).edge_count; ++i, ++inside) {
                const sim::EdgeId e = t.internal_edges[i];
                const Vec4f centre = surface.x[surface.mesh.centre(e).value];
                EXPECT_LT((centre - middle_of_curve(surface, e)).norm(), 1e-6F) << "level " << level;
            }
        }
    }
    EXPECT_EQ(inside, 3 * 32 + 3 * 128);
}

TEST(CurvedSurface, has_new_vertices_on_their_curves_while_an_adaptation_is_under_way) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    const Coarse coarse = coarse_of(base);
    for (const SurfaceKind kind : {SurfaceKind::Constant, SurfaceKind::Quadratic}) {
        CurvedSurface surface = make_curved_surface(base, {.modifier = curve_modifier(kind), .max_level = 2});
        update_surface(surface, coarse.x, coarse.normals);
        set_surface_level(surface, 2);
        const std::vector<Vec4f> at_once = surface.x;
        move_surface(surface, coarse.x, coarse.normals);
        for (const sim::VertexId v : surface.mesh.leaf_vertices())
            EXPECT_LT((surface.x[v.value] - at_once[v.value]).norm(), 1e-6F) << name(kind);
    }
}

TEST(CurvedSurface, comes_back_bit_by_bit_when_it_is_coarsened_and_refined_again) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    CurvedSurface surface = surface_at_level(base, 3);
    const Coarse coarse = coarse_of(base);
    const ByMaterial before = by_material(surface);
    set_surface_level(surface, 1);
    update_surface(surface, coarse.x, coarse.normals);
    EXPECT_LT(by_material(surface).size(), before.size());
    set_surface_level(surface, 3);
    update_surface(surface, coarse.x, coarse.normals);
    EXPECT_EQ(by_material(surface), before);
}

TEST(CurvedSurface, moves_with_the_cloth) {
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    CurvedSurface surface = surface_at_level(base, 2);
    const std::vector<Vec4f> before = surface.x;
    Coarse coarse = coarse_of(base);
    const Vec4f shift(0.25F, -0.5F, 1, 0);
    for (Vec4f& x : coarse.x) x += shift;
    update_surface(surface, coarse.x, coarse.normals);
    for (const sim::VertexId v : surface.mesh.leaf_vertices())
        EXPECT_LT((surface.x[v.value] - before[v.value] - shift).norm(), 1e-5F);
}

TEST(CurvedSurface, closes_over_a_seam_where_material_coordinates_jump) {
    const sim::GarmentMesh base = sim::test::tube(6, 3);
    const CurvedSurface surface = surface_at_level(base, 2);
    // At the seam, two material points share each vertex and so have one position.
    std::map<std::uint32_t, std::pair<float, float>> range;  // of u along the tube's circumference, by vertex
    for (const sim::LeafTriangle& t : surface.mesh.leaf_triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            auto [found, is_new] = range.try_emplace(t.v[k].value, t.u[k].x(), t.u[k].x());
            found->second.first = std::min(found->second.first, t.u[k].x());
            found->second.second = std::max(found->second.second, t.u[k].x());
        }
    }
    const auto jumps = std::count_if(range.begin(), range.end(),
                                     [](const auto& at) { return at.second.second - at.second.first > 0.5F; });
    EXPECT_EQ(jumps, 3 * 4 + 1);
    EXPECT_TRUE(check(surface.mesh).empty());
}

TEST(CurvedSurface, is_lit_by_the_normals_of_its_triangles) {
    const CurvedSurface surface = surface_at_level(shaped_square(4, on_waves), 3);
    std::vector<Vec4f> made_anew;
    leaf_normals(surface.mesh, surface.x, made_anew);
    float most = 0;
    for (const sim::VertexId v : surface.mesh.leaf_vertices()) {
        EXPECT_NEAR(surface.light_normals[v.value].norm(), 1, 1e-5F);
        EXPECT_EQ(surface.light_normals[v.value], made_anew[v.value]);
        most = std::max(most, (surface.light_normals[v.value] - surface.normals[v.value]).norm());
    }
    EXPECT_GT(most, 0.02F);  // interpolated normals hide detail
}

TEST(CurvedSurface, does_not_dip_into_the_body_that_the_cloth_lies_on) {
    constexpr float radius = 0.15F, offset = 0.003F;
    const sim::SphereCollider ball(Vec3f::Zero(), radius);
    // A cap whose coarse vertices lie on the offset surface: flat chords penetrate deeply.
    const sim::GarmentMesh base = shaped_square(4, [&](double x, double y) {
        return Vec3d(Vec3d(0.7 * x, 0.4, -0.7 * y).normalized() * double(radius + offset));
    });
    const auto deepest = [&](const MoveOptions& options) {
        CurvedSurface surface =
            make_curved_surface(base, {.modifier = curve_modifier(SurfaceKind::Flat), .max_level = 3});
        const Coarse coarse = coarse_of(base);
        set_surface_level(surface, 3);
        update_surface(surface, coarse.x, coarse.normals, options);
        float least = 1;
        for (const sim::VertexId v : surface.mesh.leaf_vertices())
            least = std::min(least, surface.x[v.value].norm() - radius);
        return least;
    };
    EXPECT_LT(deepest({}), 0);
    EXPECT_GT(deepest({.body = &ball, .offset = offset}), offset - 1e-4F);
}

TEST(CurvedSurface, far_from_the_body_is_left_alone) {
    const sim::SphereCollider ball(Vec3f(0, -2, 0), 0.2F);
    const sim::GarmentMesh base = shaped_square(4, on_waves);
    CurvedSurface surface = surface_at_level(base, 2);
    const std::vector<Vec4f> before = surface.x;
    const Coarse coarse = coarse_of(base);
    update_surface(surface, coarse.x, coarse.normals, {.body = &ball});
    EXPECT_EQ(surface.x, before);
}

// A roof: two planes that meet in a ridge along y; the ridge's edges are the crease.
struct Roof {
    sim::GarmentMesh base = shaped_square(4, [](double x, double y) { return Vec3d(x, 0.25 - std::abs(x), -y); });
    std::vector<CreaseEdge> ridge;

    Roof() {
        for (int row = 0; row < 4; ++row) ridge.push_back({5 * row + 2, 5 * (row + 1) + 2});
    }
    CurvedSurface surface(const std::vector<CreaseEdge>& creases) const {
        CurvedSurface surface = make_curved_surface(base, {.max_level = 3, .creases = creases});
        const Coarse coarse = coarse_of(base);
        set_surface_level(surface, 3);
        update_surface(surface, coarse.x, coarse.normals);
        return surface;
    }
};

// Largest distance of the surface from the two planes, m.
float off_the_roof(const CurvedSurface& surface) {
    float most = 0;
    for (const sim::VertexId v : surface.mesh.leaf_vertices()) {
        const Vec4f& x = surface.x[v.value];
        most = std::max(most, std::abs(x.y() - (0.25F - std::abs(x.x()))));
    }
    return most;
}

TEST(CurvedSurface, stays_sharp_along_a_crease_and_is_rounded_off_without_one) {
    const Roof roof;
    EXPECT_GT(off_the_roof(roof.surface({})), 0.01F);
    EXPECT_LT(off_the_roof(roof.surface(roof.ridge)), 1e-6F);
}

TEST(CurvedSurface, is_lit_on_each_side_of_a_crease_by_that_sides_normal) {
    const Roof roof;
    const CurvedSurface surface = roof.surface(roof.ridge);
    const float slope = std::sqrt(0.5F);
    EXPECT_EQ(surface.creases.light_normals.size(), 2U * (4 * 8 + 1));
    for (const auto& [vertex, normal] : surface.creases.light_normals) {
        EXPECT_NEAR(std::abs(normal.x()), slope, 1e-5F);
        EXPECT_NEAR(normal.y(), slope, 1e-5F);
    }
    EXPECT_TRUE(surface_at_level(roof.base, 3).creases.empty());
}

TEST(CurvedSurface, ends_a_crease_smoothly_where_it_ends) {
    const Roof roof;
    const CurvedSurface half = roof.surface({roof.ridge[0], roof.ridge[1]});
    for (const sim::VertexId v : half.mesh.leaf_vertices()) EXPECT_TRUE(half.x[v.value].allFinite());
    EXPECT_TRUE(check(half.mesh).empty());
    EXPECT_GT(off_the_roof(half), 0.01F);
}

}  // namespace
}  // namespace selvedge::render::test
