#include "bench/fabric/specimen.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "sim/mesh/sew.h"

namespace selvedge::bench {
namespace {

constexpr double kG = 9.81;           // m/s^2
constexpr double kChordError = 5e-4;  // m

// In its own plane the panel is rotated by the mesh angle; its rotation in 3D undoes this.
sim::Panel turned_panel(const std::string& name, const std::vector<Vec2d>& corners, double mesh_angle,
                        const SpecimenFrame& frame) {
    sim::Panel panel;
    panel.name = name;
    const int count = static_cast<int>(corners.size());
    for (int i = 0; i < count; ++i) {
        panel.vertices.push_back(Eigen::Rotation2Dd(mesh_angle) * corners[static_cast<std::size_t>(i)]);
        panel.edges.push_back({.start = i, .end = (i + 1) % count});
    }
    Eigen::Matrix3d axes;
    axes << frame.across, frame.along, frame.across.cross(frame.along);
    panel.rotation = axes * Eigen::AngleAxisd(-mesh_angle, Vec3d::UnitZ()).toRotationMatrix();
    return panel;
}

sim::Panel rectangle(const std::string& name, const StripCut& cut, double from, double to, const SpecimenFrame& frame) {
    const std::vector<Vec2d> corners{{0, from}, {cut.width, from}, {cut.width, to}, {0, to}};
    sim::Panel panel = turned_panel(name, corners, cut.mesh_angle, frame);
    panel.grain_angle = cut.mesh_angle + cut.warp_angle;
    return panel;
}

void make_arc(sim::OutlineEdge& edge, double radius, bool turns_right) {
    edge.kind = sim::CurveKind::Arc;
    edge.arc_radius = radius;
    edge.turns_right = turns_right;
}

Vec2d on_circle(double radius, int quarter) {
    const double angle = quarter * std::numbers::pi / 2;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

const SpecimenFrame kLevel{.across = Vec3d::UnitX(), .along = -Vec3d::UnitZ()};

sim::Panel disc_panel(const DiscCut& cut) {
    std::vector<Vec2d> corners;
    for (int quarter = 0; quarter < 4; ++quarter) corners.push_back(on_circle(cut.support_radius, quarter));
    sim::Panel panel = turned_panel("support", corners, cut.mesh_angle, kLevel);
    for (sim::OutlineEdge& edge : panel.edges) make_arc(edge, cut.support_radius, false);
    panel.grain_angle = cut.mesh_angle;
    return panel;
}

// Half of the ring, counter-clockwise from this quarter. Edges: 0 outward, 1 and 2 on the rim, 3 inward, 4 and 5 on the
// edge of the support, clockwise.
sim::Panel half_ring(const std::string& name, const DiscCut& cut, int quarter) {
    const double r = cut.support_radius;
    const std::vector<Vec2d> corners{on_circle(r, quarter),
                                     on_circle(cut.radius, quarter),
                                     on_circle(cut.radius, quarter + 1),
                                     on_circle(cut.radius, quarter + 2),
                                     on_circle(r, quarter + 2),
                                     on_circle(r, quarter + 1)};
    sim::Panel panel = turned_panel(name, corners, cut.mesh_angle, kLevel);
    for (const std::size_t rim : {1U, 2U}) make_arc(panel.edges[rim], cut.radius, false);
    for (const std::size_t inner : {4U, 5U}) make_arc(panel.edges[inner], r, true);
    panel.grain_angle = cut.mesh_angle;
    return panel;
}

std::vector<int> vertices_of(const sim::GarmentMesh& mesh, int panel) {
    std::vector<int> vertices;
    for (const sim::GarmentTriangle& t : mesh.triangles) {
        if (t.panel == panel) vertices.insert(vertices.end(), t.vertices.begin(), t.vertices.end());
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

Specimen sew_specimen(const sim::Pattern& pattern, const std::vector<sim::Fabric>& fabrics, double edge_length,
                      double mesh_angle) {
    const sim::MeshOptions meshing{.target_edge = edge_length, .chord_error = kChordError};
    Specimen specimen{.mesh = assemble(pattern, meshing), .fabrics = fabrics};
    merge_seams(specimen.mesh);
    specimen.mesh.pins = vertices_of(specimen.mesh, Specimen::kHolder);
    specimen.mesh_angle = mesh_angle;
    return specimen;
}

}  // namespace

Specimen cut_strip(const sim::Fabric& fabric, const StripCut& cut, const SpecimenFrame& frame) {
    const double holder = 2 * cut.edge_length;
    const double bar = cut.width;  // m, height of the weight
    sim::Pattern pattern;
    pattern.panels.push_back(rectangle("clamp", cut, -holder, 0, frame));
    pattern.panels.push_back(rectangle("strip", cut, 0, cut.length, frame));
    pattern.seams.push_back({.first = {0, 2}, .second = {1, 0}});
    std::vector<sim::Fabric> fabrics{fabric, fabric};
    if (cut.weight > 0) {
        pattern.panels.push_back(rectangle("weight", cut, cut.length, cut.length + bar, frame));
        pattern.seams.push_back({.first = {1, 2}, .second = {2, 0}});
        fabrics.push_back(fabric);
        fabrics.back().area_density = cut.weight / (kG * bar);
    }
    return sew_specimen(pattern, fabrics, cut.edge_length, cut.mesh_angle);
}

Specimen cut_ridge_strip(const sim::Fabric& fabric, const StripCut& cut, const SpecimenFrame& frame) {
    sim::Pattern pattern;
    pattern.panels = {rectangle("left", cut, -cut.length, 0, frame), rectangle("right", cut, 0, cut.length, frame)};
    pattern.seams.push_back({.first = {0, 2}, .second = {1, 0}});
    Specimen specimen = sew_specimen(pattern, {fabric, fabric}, cut.edge_length, cut.mesh_angle);
    const std::vector<int> left = specimen.mesh.pins;
    const std::vector<int> right = vertices_of(specimen.mesh, Specimen::kCloth);
    specimen.mesh.pins.clear();
    std::ranges::set_intersection(left, right, std::back_inserter(specimen.mesh.pins));
    return specimen;
}

Specimen cut_disc(const sim::Fabric& fabric, const DiscCut& cut) {
    sim::Pattern pattern;
    pattern.panels = {disc_panel(cut), half_ring("ring_a", cut, 0), half_ring("ring_b", cut, 2)};
    pattern.seams = {{.first = {0, 0}, .second = {1, 5}}, {.first = {0, 1}, .second = {1, 4}},
                     {.first = {0, 2}, .second = {2, 5}}, {.first = {0, 3}, .second = {2, 4}},
                     {.first = {1, 0}, .second = {2, 3}}, {.first = {1, 3}, .second = {2, 0}}};
    return sew_specimen(pattern, {fabric, fabric, fabric}, cut.edge_length, cut.mesh_angle);
}

}  // namespace selvedge::bench
