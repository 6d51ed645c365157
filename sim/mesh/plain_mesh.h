#pragma once
// A mesh as drawn or exported: what is left of a garment when nothing moves any more. Whoever has leaves hands them
// over as this; renderer and exporters know no cloth.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct PlainMesh {
    std::vector<Vec3f> x;        // positions, m
    std::vector<Vec3f> normals;  // per vertex, unit
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<Vec2f, 3>> u;     // per corner, m; empty when there are none
    std::vector<std::uint16_t> panel;        // per triangle; empty: one group
    std::vector<std::uint8_t> level;         // per triangle; empty: all 0
    std::vector<std::uint8_t> vertex_level;  // per vertex: of the edges it was born with; empty: not known
    std::vector<std::string> panel_names;
    std::vector<float> panel_grain_angles;    // rad
    std::vector<Vec2f> panel_sett_offsets{};  // m, (weft, warp), see Panel::sett_offset; empty: none is moved

    bool operator==(const PlainMesh&) const = default;
};

// The panel of a triangle: 0 where the mesh names none.
inline std::uint16_t panel_of(const PlainMesh& mesh, std::size_t triangle) {
    return mesh.panel.empty() ? std::uint16_t{0} : mesh.panel[triangle];
}

// Unit normals at vertices, weighted by the area of the triangles about them; +y where there is no area.
// Pre: indices are in range.
std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& x,
                                  const std::vector<std::array<std::uint32_t, 3>>& triangles);

// The mesh's own normals where it has one for each vertex, else those that follow from its triangles.
std::vector<Vec3f> vertex_normals(const PlainMesh& mesh);

// All triangles of an adaptive mesh, those that were refined too, as plain data: to be shown.  (thesis fig. 3.17)

struct HierarchyTriangle {
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};  // material coordinates, m
    std::uint16_t panel = 0;
    std::uint8_t level = 0;
    bool is_leaf = true;
};

using TriangleHierarchy = std::vector<HierarchyTriangle>;

}  // namespace selvedge::sim
