#include "sim/exchange/thick_cloth.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/edge_table.h"

namespace selvedge::sim {
namespace {

using Side = TriangleSide<std::uint32_t>;

// Corners (three per triangle) in groups, one per fan of triangles round a vertex, and the sides at which fans end.
struct Fans {
    std::vector<std::uint32_t> of_corner;
    std::uint32_t count = 0;
    std::vector<Side> border;
};

// Whether the vertex normals look to the same side of both triangles, as seen along the surface.
bool is_one_surface(const DrawMesh& mesh, const Side& a, const Side& b) {
    const bool are_opposite = a.rises == b.rises;
    return std::ranges::all_of(std::array{true, false}, [&](bool at_low) {
        const bool turned_a = is_turned(mesh, a.triangle, a.corner(at_low));
        return (turned_a != is_turned(mesh, b.triangle, b.corner(at_low))) == are_opposite;
    });
}

Fans find_fans(const DrawMesh& mesh) {
    const EdgeTable<std::uint32_t> table(mesh.triangles);
    DisjointSets corners(3 * mesh.triangles.size());
    Fans fans;
    for (const auto edge : table.edges()) {
        if (edge.size() == 2 && is_one_surface(mesh, edge[0], edge[1])) {
            for (const bool at_low : {true, false})
                corners.join(static_cast<int>(3 * edge[0].triangle + edge[0].corner(at_low)),
                             static_cast<int>(3 * edge[1].triangle + edge[1].corner(at_low)));
        } else {
            fans.border.insert(fans.border.end(), edge.begin(), edge.end());
        }
    }
    std::ranges::sort(fans.border, {}, [](const Side& side) { return std::tuple(side.triangle, side.k); });
    fans.of_corner.resize(3 * mesh.triangles.size());
    for (std::size_t corner = 0; corner < fans.of_corner.size(); ++corner) {
        const auto lowest = static_cast<std::size_t>(corners.find(static_cast<int>(corner)));  // <= corner
        fans.of_corner[corner] = lowest == corner ? fans.count++ : fans.of_corner[lowest];
    }
    return fans;
}

// What the triangles round a vertex add up to.
struct FanSum {
    Vec3d x = Vec3d::Zero();
    Vec3d normal = Vec3d::Zero();  // times twice the area
    double area = 0;
    double thickness_by_area = 0;
    float thickness = 0;  // of one of them, if all have no area

    Vec3d unit_normal() const { return normal.isZero(0) ? Vec3d(Vec3d::UnitY()) : Vec3d(normal.stableNormalized()); }
    double mean_thickness() const { return area > 0 ? thickness_by_area / area : double(thickness); }
};

std::vector<FanSum> sum_fans(const DrawMesh& mesh, const Fans& fans, std::span<const float> thickness) {
    std::vector<FanSum> sums(fans.count);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3d x = mesh.x[a].cast<double>();
        const Vec3d normal = (mesh.x[b].cast<double>() - x).cross(mesh.x[c].cast<double>() - x);
        SELVEDGE_ASSERT(panel_of(mesh, t) < thickness.size());
        const float own = thickness[panel_of(mesh, t)];
        for (std::size_t k = 0; k < 3; ++k) {
            FanSum& sum = sums[fans.of_corner[3 * t + k]];
            sum.x = mesh.x[mesh.triangles[t][k]].cast<double>();
            sum.normal += is_turned(mesh, t, k) ? Vec3d(-normal) : normal;
            sum.area += normal.norm();
            sum.thickness_by_area += normal.norm() * double(own);
            sum.thickness = own;
        }
    }
    return sums;
}

// Two vertices per fan: fan i has 2 i, half a thickness along its normal, and 2 i + 1 on the other side.
void add_vertices(const std::vector<FanSum>& fans, DrawMesh& solid) {
    for (const FanSum& fan : fans) {
        const Vec3d normal = fan.unit_normal(), offset = fan.mean_thickness() / 2 * normal;
        solid.x.emplace_back((fan.x + offset).cast<float>());
        solid.x.emplace_back((fan.x - offset).cast<float>());
        solid.normals.emplace_back(normal.cast<float>());
        solid.normals.emplace_back(-normal.cast<float>());
    }
}

// Adds triangles with the material coordinates of corners of triangles of the thin mesh.
class SolidBuilder {
 public:
    SolidBuilder(const DrawMesh& mesh, const Fans& fans, DrawMesh& solid) : mesh_(mesh), fans_(fans), solid_(solid) {}

    enum class Face { Front, Back };
    struct Corner {
        std::size_t k = 0;  // of the thin triangle
        Face face = Face::Front;
    };

    void add(std::size_t triangle, const std::array<Corner, 3>& corners) {
        std::array<std::uint32_t, 3> vertices{};
        std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_beyond = (corners[i].face == Face::Back) != is_turned(mesh_, triangle, corners[i].k);
            vertices[i] = 2 * fans_.of_corner[3 * triangle + corners[i].k] + (is_beyond ? 1U : 0U);
            if (!mesh_.u.empty()) u[i] = mesh_.u[triangle][corners[i].k];
        }
        solid_.triangles.push_back(vertices);
        if (!mesh_.u.empty()) solid_.u.push_back(u);
        if (!mesh_.panel.empty()) solid_.panel.push_back(mesh_.panel[triangle]);
    }

 private:
    const DrawMesh& mesh_;
    const Fans& fans_;
    DrawMesh& solid_;
};

}  // namespace

DrawMesh with_thickness(const DrawMesh& mesh, std::span<const float> thickness) {
    const Fans fans = find_fans(mesh);
    DrawMesh solid;
    solid.panel_names = mesh.panel_names;
    solid.panel_grain_angles = mesh.panel_grain_angles;
    solid.panel_sett_offsets = mesh.panel_sett_offsets;
    add_vertices(sum_fans(mesh, fans, thickness), solid);
    using enum SolidBuilder::Face;
    SolidBuilder builder(mesh, fans, solid);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) builder.add(t, {{{0, Front}, {1, Front}, {2, Front}}});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) builder.add(t, {{{0, Back}, {2, Back}, {1, Back}}});
    for (const Side& side : fans.border) {
        const std::size_t a = side.k, b = (a + 1) % 3;
        builder.add(side.triangle, {{{b, Front}, {a, Front}, {a, Back}}});
        builder.add(side.triangle, {{{b, Front}, {a, Back}, {b, Back}}});
    }
    return solid;
}

}  // namespace selvedge::sim
