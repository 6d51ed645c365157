#pragma once
// A static triangle mesh for rendering and export, and the triangle hierarchy of an adaptive mesh as plain data. The
// simulation converts its leaf triangles to a DrawMesh, so that renderer and exporters do not depend on the cloth.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct DrawMesh {
    std::vector<Vec3f> x;        // positions, m
    std::vector<Vec3f> normals;  // per vertex, unit
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<Vec2f, 3>> u;     // per corner, m; empty: no material coordinates
    std::vector<std::uint16_t> panel;        // per triangle; empty: one panel
    std::vector<std::uint8_t> level;         // per triangle; empty: all 0
    std::vector<std::uint8_t> vertex_level;  // per vertex: level of the edges created with it; empty: unknown
    std::vector<std::string> panel_names;
    std::vector<float> panel_grain_angles;    // rad
    std::vector<Vec2f> panel_sett_offsets{};  // m, (weft, warp), see Panel::sett_offset; empty: all zero
    // Per triangle: bit k is set where the vertex normal of corner k looks to the wrong side of the triangle, because a
    // seam joins right side to wrong side there. Triangles are anticlockwise seen from their right side. Empty:
    // nowhere.
    std::vector<std::uint8_t> turned_corners{};

    bool operator==(const DrawMesh&) const = default;
};

// The panel of a triangle: 0 where the mesh names none.
inline std::uint16_t panel_of(const DrawMesh& mesh, std::size_t triangle) {
    return mesh.panel.empty() ? std::uint16_t{0} : mesh.panel[triangle];
}

// The mesh with these of its triangles only, in this order. Every vertex stays.
DrawMesh with_triangles(DrawMesh mesh, const std::vector<std::size_t>& kept);

// Whether the vertex normal of corner k looks to the wrong side of the triangle.
inline bool is_turned(const DrawMesh& mesh, std::size_t triangle, std::size_t k) {
    return !mesh.turned_corners.empty() && (mesh.turned_corners[triangle] >> k & 1U) != 0;
}

// DrawMesh::turned_corners from the directions in which neighbouring triangles have their common edges: the normal of a
// vertex looks to the right side of the first triangle of each fan round it. Empty if all are consistent.
std::vector<std::uint8_t> find_turned_corners(const std::vector<std::array<std::uint32_t, 3>>& triangles);

// Unit normals per vertex: area-weighted mean of the adjacent triangles' normals; +y where that mean is zero.
// turned_corners: as in DrawMesh. Pre: indices are in range.
std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& x,
                                  const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                  const std::vector<std::uint8_t>& turned_corners = {});

// mesh.normals if there is one per vertex, otherwise normals computed from the triangles.
std::vector<Vec3f> vertex_normals(const DrawMesh& mesh);

// A triangle of an adaptive mesh, refined or leaf, as plain data for display.  (thesis fig. 3.17)
struct HierarchyTriangle {
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};  // material coordinates, m
    std::uint16_t panel = 0;
    std::uint8_t level = 0;
    bool is_leaf = true;
};

using TriangleHierarchy = std::vector<HierarchyTriangle>;

}  // namespace selvedge::sim
