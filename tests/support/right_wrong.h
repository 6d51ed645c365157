#pragma once
// Garments with seams that join right side to wrong side: any garment with a panel seen from the other side of its
// cloth, and a Moebius band.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim::test {

// Mirrors a panel's material coordinates and directs its triangles the other way round. Vertices stay.
inline void mirror_panel(GarmentMesh& mesh, int panel) {
    for (GarmentTriangle& t : mesh.triangles) {
        if (t.panel != panel) continue;
        std::swap(t.vertices[1], t.vertices[2]);
        std::swap(t.u[1], t.u[2]);
        for (Vec2d& u : t.u) u.x() *= -1;
    }
    const auto at = static_cast<std::size_t>(panel);
    if (panel >= 0 && at < mesh.panel_grain_angles.size()) mesh.panel_grain_angles[at] *= -1;
}

// The same for a panel of a pattern, without notches and internal lines: it is seen from the other side and stays where
// it is. Edge e of n becomes edge n - 1 - e.
inline void mirror_panel(Pattern& pattern, int index) {
    Panel& panel = pattern.panels[static_cast<std::size_t>(index)];
    for (Vec2d& v : panel.vertices) v.x() *= -1;
    panel.is_mirrored = !panel.is_mirrored;
    panel.grain_angle *= -1;
    std::reverse(panel.edges.begin(), panel.edges.end());
    for (OutlineEdge& edge : panel.edges) {
        std::swap(edge.start, edge.end);
        for (Vec2d& p : edge.control) p.x() *= -1;
        if (edge.kind == CurveKind::Cubic) std::swap(edge.control[0], edge.control[1]);
    }
    for (Seam& seam : pattern.seams) {
        for (SeamSide* side : {&seam.first, &seam.second}) {
            if (side->panel != index) continue;
            side->edge = static_cast<int>(panel.edges.size()) - 1 - side->edge;
            seam.is_reversed = !seam.is_reversed;
        }
    }
}

// A Moebius band of panels in a row, each three quads wide and two high, of 5 cm. All seams but the last one join right
// side to right side.
inline GarmentMesh moebius_band(int panels) {
    constexpr int kWide = 3, kHigh = 2;
    constexpr double kQuad = 0.05;  // m
    GarmentMesh mesh;
    const int columns = kWide * panels;
    const double radius = kQuad * columns / (2.0 * std::numbers::pi);
    for (int column = 0; column < columns; ++column) {
        const double angle = 2.0 * std::numbers::pi * column / columns, half = angle / 2;
        for (int row = 0; row <= kHigh; ++row) {
            const double off = kQuad * (row - 0.5 * kHigh), r = radius + off * std::cos(half);
            mesh.x.emplace_back(r * std::cos(angle), off * std::sin(half), -r * std::sin(angle));
        }
    }
    const auto vertex = [&](int column, int row) {
        return column < columns ? column * (kHigh + 1) + row : kHigh - row;
    };
    const auto u = [&](int column, int row) { return Vec2d(kQuad * column, kQuad * row); };
    for (int column = 0; column < columns; ++column) {
        const int panel = column / kWide, own = column % kWide;
        for (int row = 0; row < kHigh; ++row) {
            const int a = vertex(column, row), b = vertex(column + 1, row), c = vertex(column + 1, row + 1),
                      d = vertex(column, row + 1);
            mesh.triangles.push_back({{a, b, c}, {u(own, row), u(own + 1, row), u(own + 1, row + 1)}, panel});
            mesh.triangles.push_back({{a, c, d}, {u(own, row), u(own + 1, row + 1), u(own, row + 1)}, panel});
        }
    }
    for (int panel = 0; panel < panels; ++panel) {
        mesh.panel_names.push_back("panel" + std::to_string(panel));
        mesh.panel_grain_angles.push_back(0.0);
    }
    return mesh;
}

}  // namespace selvedge::sim::test
