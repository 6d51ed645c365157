#pragma once
// Two panels of two triangles each, sewn along the edge from vertex 1 to vertex 2. Material coordinates are
// discontinuous there.
#include <utility>

#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

inline DrawMesh two_panels() {
    DrawMesh mesh;
    mesh.x = {{0, 1, 0}, {0.1F, 1, 0}, {0.1F, 1.3F, 0}, {0, 1.3F, 0}, {0.2F, 1, -0.05F}, {0.2F, 1.3F, -0.05F}};
    mesh.normals.assign(mesh.x.size(), Vec3f::UnitZ());
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    const Vec2f a(0, 0), b(0.1F, 0), c(0.1F, 0.3F), d(0, 0.3F);
    const Vec2f p(-0.7F, 0.013F), q(-0.588F, 0.013F), r(-0.588F, 0.313F), s(-0.7F, 0.313F);
    mesh.u = {{a, b, c}, {a, c, d}, {p, q, r}, {p, r, s}};
    mesh.panel = {0, 0, 1, 1};
    mesh.panel_names = {"front", "left sleeve"};
    mesh.panel_grain_angles = {0.0F, 0.7853982F};
    mesh.panel_sett_offsets = {{0, 0}, {0.0123F, -0.05F}};
    return mesh;
}

// The sleeve's wrong side continues the right side of the front.
inline DrawMesh sewn_right_to_wrong() {
    DrawMesh mesh = two_panels();
    for (const std::size_t t : {2U, 3U}) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        std::swap(mesh.u[t][1], mesh.u[t][2]);
        for (Vec2f& u : mesh.u[t]) u.x() *= -1;
    }
    mesh.turned_corners = find_turned_corners(mesh.triangles);
    mesh.normals = vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners);
    return mesh;
}

}  // namespace selvedge::sim
