// Cloth whose panels are sewn right side to wrong side moves as if all had the same right side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "sim/adaptive/check.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/triangle_bending.h"
#include "sim/cloth/wind.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/right_wrong.h"

namespace selvedge::sim::test {
namespace {

// A vertical sheet, 0.4 m wide and 0.6 m long, of two panels that meet in a vertical seam; the right one has another
// grain. Pinned along its upper edge. slant: m, by which rows zigzag.
GarmentMesh two_panels(double slant = 0.02) {
    constexpr int kWide = 6, kLong = 8;
    GarmentMesh mesh;
    for (int row = 0; row <= kLong; ++row) {
        for (int column = 0; column <= kWide; ++column) {
            const double off = slant * ((row + column) % 2);
            mesh.x.emplace_back(0.4 * column / kWide - 0.2, 2 - 0.6 * row / kLong - off, 0);
            if (row == 0) mesh.pins.push_back(column);
        }
    }
    const auto u_of = [&](int vertex) { return Vec2d(mesh.x[static_cast<std::size_t>(vertex)].head<2>()); };
    for (int row = 0; row < kLong; ++row) {
        for (int column = 0; column < kWide; ++column) {
            const int a = row * (kWide + 1) + column, b = a + 1, c = a + kWide + 1, d = c + 1;
            for (const std::array<int, 3>& v : {std::array{a, c, b}, std::array{b, c, d}}) {
                mesh.triangles.push_back({v, {u_of(v[0]), u_of(v[1]), u_of(v[2])}, column < kWide / 2 ? 0 : 1});
            }
        }
    }
    mesh.panel_names = {"left", "right"};
    mesh.panel_grain_angles = {0, 0.3};
    return mesh;
}

GarmentMesh mirrored(GarmentMesh mesh) {
    mirror_panel(mesh, 1);
    return mesh;
}

Cloth cloth_of(const GarmentMesh& mesh) {
    return make_cloth(mesh, std::vector<Fabric>(mesh.panel_names.size(), find_fabric("cotton_shirting")),
                      {.max_level = 2});
}

// Bends the sheet and stretches it a little, differently everywhere.
void crumple(Cloth& cloth) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        Vec4f& x = cloth.x[v.value];
        x = Vec4f(1.01F * x.x(), x.y() + 0.01F * std::sin(9 * x.x()),
                  0.05F * std::sin(14 * x.x() + 3 * x.y()) + 0.03F * std::cos(11 * x.y()), 0);
    }
    cloth.x_prev = cloth.x;
}

TEST(RightWrongCloth, strains_as_cloth_whose_panels_face_the_same_way) {
    Cloth plain = cloth_of(two_panels()), half = cloth_of(mirrored(two_panels()));
    EXPECT_TRUE(half.mesh.has_right_wrong_edges());
    crumple(plain);
    crumple(half);
    const std::vector<TriangleStrain> expected = measure_strain(plain), found = measure_strain(half);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(found[i].warp, expected[i].warp, 1e-5F);
        EXPECT_NEAR(found[i].weft, expected[i].weft, 1e-5F);
        EXPECT_NEAR(found[i].shear, expected[i].shear, 1e-5F);
    }
}

// Seen from the other side, the curvatures along the yarns change their sign; that of the twist changes twice.
TEST(RightWrongCloth, bends_as_cloth_whose_panels_face_the_same_way) {
    for (const int level : {0, 1}) {
        Cloth plain = cloth_of(two_panels()), half = cloth_of(mirrored(two_panels()));
        refine(plain, level);
        refine(half, level);
        crumple(plain);
        crumple(half);
        std::map<std::array<VertexId, 3>, TriangleId> leaf_of;  // by its vertices: children have other ids
        const auto sorted = [](std::array<VertexId, 3> v) {
            std::sort(v.begin(), v.end());
            return v;
        };
        for (const LeafTriangle& leaf : half.mesh.leaf_triangles()) leaf_of[sorted(leaf.v)] = leaf.triangle;
        float largest = 0;
        for (const LeafTriangle& leaf : plain.mesh.leaf_triangles()) {
            const BendSlot expected = bend_slot(plain, leaf.triangle),
                           found = bend_slot(half, leaf_of.at(sorted(leaf.v)));
            const Vec3f k = curvature_now(plain, *expected.block, expected.at);
            const Vec3f other = curvature_now(half, *found.block, found.at);
            const float sign = leaf.panel == 1 ? -1 : 1;
            EXPECT_LT((Vec3f(sign * other.x(), sign * other.y(), other.z()) - k).norm(), 1e-3F * (1 + k.norm()))
                << "level " << level << ", panel " << leaf.panel;
            largest = std::max(largest, k.norm());
        }
        EXPECT_GT(largest, 5);
    }
}

TEST(RightWrongCloth, has_normals_of_one_orientation) {
    Cloth plain = cloth_of(two_panels()), half = cloth_of(mirrored(two_panels()));
    crumple(plain);
    crumple(half);
    update_normals(plain);
    update_normals(half);
    for (const VertexId v : plain.mesh.leaf_vertices()) {
        EXPECT_LT((plain.normals[v.value] - half.normals[v.value]).norm(), 1e-5F);
    }
}

TEST(RightWrongCloth, is_drawn_with_normals_of_the_right_side_of_each_triangle) {
    Cloth half = cloth_of(mirrored(two_panels()));
    crumple(half);
    const DrawMesh mesh = draw_mesh(half, {"left", "right"});
    ASSERT_EQ(mesh.turned_corners.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3f right = (mesh.x[b] - mesh.x[a]).cross(mesh.x[c] - mesh.x[a]);
        for (std::size_t k = 0; k < 3; ++k) {
            const float cosine = right.normalized().dot(mesh.normals[mesh.triangles[t][k]]);
            EXPECT_GT(is_turned(mesh, t, k) ? -cosine : cosine, 0.5F);
        }
    }
    EXPECT_TRUE(draw_mesh(cloth_of(two_panels()), {"left", "right"}).turned_corners.empty());
}

TEST(RightWrongCloth, is_blown_as_cloth_whose_panels_face_the_same_way) {
    Cloth plain = cloth_of(two_panels()), half = cloth_of(mirrored(two_panels()));
    const Wind wind{.velocity = {1, 0, 3}};
    for (Cloth* cloth : {&plain, &half}) {
        crumple(*cloth);
        blow(*cloth, wind, 0.01F);
    }
    for (const VertexId v : plain.mesh.leaf_vertices())
        EXPECT_LT((plain.x_prev[v.value] - half.x_prev[v.value]).norm(), 1e-7F);
}

double sum_of_masses(const Cloth& cloth) {
    double sum = 0;  // kg, pinned vertices included
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) sum += 3 * third_of_mass(cloth, leaf.u, leaf.panel);
    return sum;
}

// Largest distance of the base vertices of two cloths, m.
float farthest(const Cloth& first, const Cloth& second) {
    float most = 0;
    for (std::uint32_t v = 0; v < first.mesh.base_vertex_count(); ++v)
        most = std::max(most, (first.x[v] - second.x[v]).norm());
    return most;
}

TEST(RightWrongCloth, moves_as_cloth_whose_panels_face_the_same_way) {
    Cloth plain = cloth_of(two_panels()), half = cloth_of(mirrored(two_panels()));
    for (Cloth* cloth : {&plain, &half}) {
        crumple(*cloth);
        adapt_cloth(*cloth, nothing_near(), {.max_level = 0});
        for (int i = 0; i < 24; ++i) step(*cloth, nothing_near(), {.contact = {.floor = kNoFloor}});
    }
    const Cloth start = cloth_of(two_panels());
    EXPECT_GT(farthest(start, plain), 0.03F);
    EXPECT_LT(farthest(plain, half), 0.001F) << farthest(plain, half);
}

// Without adaptation, which may choose other diagonals in a mirrored triangle. 480 steps bring it to rest.
void hang(Cloth& cloth, int level, int steps) {
    adapt_cloth(cloth, nothing_near(), {.max_level = 0});
    refine(cloth, level);
    for (int i = 0; i < steps; ++i) step(cloth, nothing_near(), {.extra_damping = 2, .contact = {.floor = kNoFloor}});
}

TEST(RightWrongCloth, comes_to_rest_where_cloth_does_whose_panels_face_the_same_way) {
    GarmentMesh sheet = two_panels(0);
    for (Vec3d& x : sheet.x) x = Vec3d(x.x(), 2, 2 - x.y());  // sticks out and sags
    for (const int level : {0, 1, 2}) {
        Cloth plain = cloth_of(sheet), half = cloth_of(mirrored(sheet));
        for (Cloth* cloth : {&plain, &half}) hang(*cloth, level, 480);
        EXPECT_GT(farthest(cloth_of(sheet), plain), 0.1F);
        EXPECT_LT(farthest(plain, half), 0.002F) << "level " << level << ": " << farthest(plain, half);
    }
}

TEST(RightWrongCloth, keeps_its_mass_and_a_sound_mesh_while_it_adapts) {
    GarmentMesh band = moebius_band(3);
    band.pins = {0, 1};
    for (const GarmentMesh& mesh : {mirrored(two_panels()), band}) {
        Cloth cloth = cloth_of(mesh);
        const double mass = sum_of_masses(cloth);
        crumple(cloth);
        long changes = 0;
        for (int i = 0; i < 240; ++i) {
            if (i % 4 == 0) {
                const AdaptReport report = adapt_cloth(cloth, nothing_near(), {.max_level = 2});
                changes += report.splits + report.rejoins;
                ASSERT_TRUE(check(cloth.mesh).empty()) << check(cloth.mesh).front();
            }
            step(cloth, nothing_near(), {.contact = {.floor = kNoFloor}});
        }
        EXPECT_NEAR(sum_of_masses(cloth), mass, 1e-5 * mass);
        EXPECT_FALSE(find_bad_vertex(cloth));
        EXPECT_GT(changes, 100);
    }
}

// No orientation fits a Moebius band; where its cut lies must not matter. (At finer levels it buckles, into folds that
// depend on rounding, without any mirrored panel as well.)
TEST(RightWrongCloth, of_a_moebius_band_hangs_alike_wherever_its_cut_lies) {
    std::vector<Cloth> bands;
    for (const int mirrored : {-1, 1, 2}) {
        GarmentMesh band = moebius_band(3);
        band.pins = {0, 1};
        mirror_panel(band, mirrored);
        bands.push_back(cloth_of(band));
        ASSERT_TRUE(bands.back().mesh.has_cuts());
        hang(bands.back(), 0, 480);
        update_normals(bands.back());
        for (const VertexId v : bands.back().mesh.leaf_vertices())
            EXPECT_NEAR(bands.back().normals[v.value].norm(), 1, 1e-4F);
    }
    EXPECT_LT(farthest(bands[0], bands[1]), 0.001F) << farthest(bands[0], bands[1]);
    EXPECT_LT(farthest(bands[0], bands[2]), 0.001F) << farthest(bands[0], bands[2]);
}

// A flat sheet asks for no split, also where the signs of its normals differ.
TEST(RightWrongCloth, that_lies_flat_is_not_split_at_a_cut) {
    GarmentMesh sheet = two_panels();
    for (GarmentTriangle& t : sheet.triangles) {
        if (t.panel != 0) continue;
        for (Vec2d& u : t.u) u.y() += 7;  // no neighbour has its material coordinates
    }
    // Two rows of the sheet, one of them with its right side down: a cut, because both panels reach both.
    for (GarmentTriangle& t : sheet.triangles) {
        if (t.panel == 1 && std::ranges::min(t.vertices) >= 28) {
            std::swap(t.vertices[1], t.vertices[2]);
            std::swap(t.u[1], t.u[2]);
            for (Vec2d& u : t.u) u.x() *= -1;
        }
    }
    Cloth cloth = cloth_of(sheet);
    EXPECT_TRUE(check(cloth.mesh).empty());
    ASSERT_TRUE(cloth.mesh.has_right_wrong_edges());
    EXPECT_EQ(adapt_cloth(cloth, nothing_near(), {.max_level = 2}).splits, 0);
}

}  // namespace
}  // namespace selvedge::sim::test
