#include "bench/fabric/textile_test.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <span>

#include "bench/fabric/report.h"
#include "bench/fabric/theory.h"
#include "bench/support/measured_mesh.h"
#include "sim/collide/collider.h"
#include "sim/core/file.h"
#include "sim/core/gravity.h"
#include "sim/core/json.h"
#include "sim/mesh/sew.h"

namespace selvedge::bench {
std::vector<std::string> textile_test_names() {
    return {"cantilever", "strip", "bias", "drape", "swing", "energy"};
}

double allowed_error(const MeshSetting& mesh) {
    if (mesh.is_adaptive || mesh.level >= 2) return 0.05;
    return mesh.level == 1 ? 0.1 : -1;
}

std::vector<MeshSetting> level_settings(const FabricExperiment& experiment) {
    if (experiment.is_quick) return {{.level = 1}, {.level = 2}};
    return {{.level = 0}, {.level = 1}, {.level = 2}, {.level = 3}, {.level = 3, .is_adaptive = true}};
}

std::vector<double> mesh_angles(const FabricExperiment& experiment) {
    const double degree = std::numbers::pi / 180;
    if (experiment.is_quick) return {17 * degree};
    return {0, 17 * degree, 45 * degree};
}

DrapeBand published_drape(const std::string& fabric_name) {
    for (const sim::EmbeddedFile& file : sim::embedded_fabrics()) {
        if (std::filesystem::path(file.name).stem() != fabric_name) continue;
        const sim::Json json = sim::parse_json(file.text, std::string(file.name));
        if (json.find("cusick_drape_percent") == nullptr) return {};
        const std::vector<double> band =
            sim::JsonView(json, std::string(file.name)).at("cusick_drape_percent").numbers();
        return {band.at(0), band.at(1)};
    }
    return {};
}

// Static tests: cantilever and hanging strips at rest.

namespace {

double weight_of(const sim::Fabric& fabric) {
    return fabric.area_density * sim::kGravity;  // N/m^2
}

double warp_angle(YarnDirection direction) {
    if (direction == YarnDirection::Warp) return 0;
    return direction == YarnDirection::Weft ? std::numbers::pi / 2 : std::numbers::pi / 4;
}

double stiffness(const sim::Fabric& fabric, YarnDirection direction) {
    if (direction == YarnDirection::Bias) return bias_stiffness(fabric);
    return direction == YarnDirection::Warp ? fabric.stretch_warp : fabric.stretch_weft;
}

sim::Fabric without_friction(sim::Fabric fabric) {
    fabric.bending_hysteresis = 0;
    fabric.shear_hysteresis = 0;
    return fabric;
}

double load_of(const sim::Fabric& fabric, YarnDirection direction) {
    constexpr double kE5 = 4.905;   // N/m
    constexpr double kE20 = 19.62;  // N/m
    const double k = stiffness(fabric, direction);
    if (direction == YarnDirection::Bias) return 0.01 * k;
    const double most = k * fabric.strain_limit / 2;
    return most > kE20 ? kE20 : std::min(kE5, most);
}

// The mean strain of a hanging strip between the lines l = from and l = to.
double strain_between(const Specimen& specimen, const ClothRun& run, const StripCut& cut, double from, double to) {
    const auto height = [&](double l) {
        return mean_material_point(run.cloth, Specimen::kCloth, specimen.material(0, l),
                                   specimen.material(cut.width, l))
            .y();
    };
    return (height(from) - height(to)) / (to - from) - 1;
}

// Hangs the strip and measures its strain. It is at rest when it moves by less than 0.5 % of the expected elongation
// per second.
Reading hang(const sim::Fabric& fabric, YarnDirection direction, const StripCut& cut, const MeshSetting& mesh,
             const Stepping& stepping) {
    constexpr float kDamping = 10;  // 1/s
    const bool is_bias = direction == YarnDirection::Bias;
    const double margin = is_bias ? 1.25 * cut.width : 0;  // yarns that end in a clamp prevent shear
    const double from = margin;
    const double to = cut.length - margin;
    const double force = cut.weight + weight_of(fabric) * (cut.length - (from + to) / 2);
    Reading reading;
    reading.expected = is_bias ? bias_strain(fabric, force) : force / stiffness(fabric, direction);
    const Specimen specimen = cut_strip(fabric, cut, {});
    ClothRun run = start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
    reading.is_at_rest = run_to_rest(run, sim::NoBody(),
                                     {.damping = kDamping,
                                      .min_seconds = 0.6,
                                      .max_seconds = 4,
                                      .rest_speed = 0.005 * reading.expected * cut.length});
    const auto strain = [&] { return strain_between(specimen, run, cut, from, to); };
    reading.measured = mean_reading(run, sim::NoBody(), kDamping, strain);
    return reading;
}

StripCut strip_cut(YarnDirection direction, const MeshSetting& mesh) {
    return {.mesh_angle = mesh.angle, .warp_angle = warp_angle(direction), .edge_length = 0.04};
}

}  // namespace

std::string name_of(YarnDirection direction) {
    if (direction == YarnDirection::Warp) return "warp";
    return direction == YarnDirection::Weft ? "weft" : "bias";
}

std::string level_name(const MeshSetting& setting) {
    return setting.is_adaptive ? "adaptive" : std::to_string(setting.level);
}

RunOptions run_options(const MeshSetting& setting, const Stepping& stepping) {
    return {.level = setting.level,
            .is_adaptive = setting.is_adaptive,
            .substeps = stepping.substeps,
            .frame_seconds = stepping.frame_seconds};
}

Reading test_cantilever(const sim::Fabric& tested, YarnDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping) {
    const sim::Fabric fabric = without_friction(tested);
    const double w = weight_of(fabric);
    Reading reading;
    reading.expected = direction == YarnDirection::Warp ? fabric.bending_warp : fabric.bending_weft;
    StripCut cut{.mesh_angle = mesh.angle, .warp_angle = warp_angle(direction)};
    cut.length = std::cbrt(kPeirceQ * reading.expected / w);
    const SpecimenFrame level{.across = Vec3d::UnitZ(), .along = Vec3d::UnitX()};
    const Specimen specimen = cut_ridge_strip(fabric, cut, level);
    ClothRun run = start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
    reading.is_at_rest = run_to_rest(run, sim::NoBody(), {.min_seconds = 0.4, .max_seconds = 6});
    const auto end = [&](int panel, double l) {
        return mean_material_point(run.cloth, panel, specimen.material(0, l), specimen.material(cut.width, l));
    };
    const Vec3d right = end(Specimen::kCloth, cut.length);
    const Vec3d left = end(Specimen::kHolder, -cut.length);
    const double dip = std::atan2(-right.y() - left.y(), right.x() - left.x());
    const double q = q_of_chord_angle(std::clamp(dip, 1e-3, 1.55));
    reading.measured = w * std::pow(cut.length, 3) / q;
    return reading;
}

Reading test_own_weight(const sim::Fabric& fabric, YarnDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping) {
    return hang(without_friction(fabric), direction, strip_cut(direction, mesh), mesh, stepping);
}

Reading test_load(const sim::Fabric& fabric, YarnDirection direction, const MeshSetting& mesh,
                  const Stepping& stepping) {
    StripCut cut = strip_cut(direction, mesh);
    cut.weight = load_of(fabric, direction);
    return hang(without_friction(fabric), direction, cut, mesh, stepping);
}

// Dynamic tests and the drape test.

namespace {

double rest_area(const ClothRun& run, bool of_holder_alone) {
    double area = 0;
    for (const sim::LeafTriangle& t : run.cloth.mesh.leaf_triangles()) {
        if (!of_holder_alone || t.panel == Specimen::kHolder) area += static_cast<double>(sim::material_area(t.u));
    }
    return area;
}

Shadow shadow_of(const ClothRun& run) {
    Shadow shadow;
    for (const sim::LeafTriangle& t : run.cloth.mesh.leaf_triangles()) {
        std::array<Vec3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = run.cloth.x[t.v[k].value].head<3>().cast<double>();
        shadow.draw(corners);
    }
    return shadow;
}

constexpr double kSwingLength = 0.3;  // m

// angle: between the strip and the vertical, rad.
ClothRun let_go(const sim::Fabric& fabric, double angle, const MeshSetting& mesh, const Stepping& stepping) {
    const StripCut cut{.width = 0.1, .length = kSwingLength, .mesh_angle = mesh.angle, .edge_length = 0.04};
    const SpecimenFrame frame{.across = Vec3d::UnitZ(), .along = Vec3d(std::sin(angle), -std::cos(angle), 0)};
    const Specimen specimen = cut_strip(fabric, cut, frame);
    return start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
}

// x of the centre of mass, m.
double sideways(const ClothRun& run) {
    const std::vector<double> mass = masses(run);
    double sum = 0;
    double total = 0;
    for (std::size_t v = 0; v < mass.size(); ++v) {
        sum += mass[v] * static_cast<double>(run.cloth.x[v].x());
        total += mass[v];
    }
    return sum / total;
}

}  // namespace

DrapeReading test_drape(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping) {
    const Specimen specimen = cut_disc(fabric, {.mesh_angle = mesh.angle});
    ClothRun run = start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
    DrapeReading reading;
    reading.is_at_rest =
        run_to_rest(run, sim::NoBody(), {.damping = 3, .min_seconds = 1, .max_seconds = 6, .rest_speed = 2e-3});
    const Shadow shadow = shadow_of(run);
    reading.coefficient = drape_coefficient(shadow.area(), rest_area(run, true), rest_area(run, false));
    reading.folds = count_folds(shadow.outline());
    return reading;
}

// Seven passages through the vertical span three periods.
double swing_period(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping) {
    constexpr std::size_t kPassages = 7;
    constexpr double kLongest = 6;  // s
    ClothRun run = let_go(fabric, 20 * std::numbers::pi / 180, mesh, stepping);
    std::vector<double> passages;
    double before = sideways(run);
    for (double t = 0; t < kLongest && passages.size() < kPassages; t += stepping.frame_seconds) {
        run_frame(run, sim::NoBody());
        const double now = sideways(run);
        if ((before > 0) != (now > 0)) passages.push_back(t + stepping.frame_seconds * before / (before - now));
        before = now;
    }
    if (passages.size() < 3) return 0;
    return 2 * (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

double energy_growth(const sim::Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping) {
    constexpr double kSeconds = 3;
    ClothRun run = let_go(fabric, std::numbers::pi / 2, mesh, stepping);
    double mass = 0;
    for (const double m : masses(run)) mass += m;
    const double work = mass * sim::kGravity * kSwingLength;
    double highest = -work;
    const double start = energy(run).potential;
    for (double t = 0; t < kSeconds; t += stepping.frame_seconds) {
        run_frame(run, sim::NoBody());
        const Energy now = energy(run);
        highest = std::max(highest, now.kinetic + now.potential - start);
    }
    return highest / work;
}

namespace {

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
    std::vector<Vec2d> corners(4);
    for (int quarter = 0; quarter < 4; ++quarter)
        corners[std::size_t(quarter)] = on_circle(cut.support_radius, quarter);
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
        fabrics.back().area_density = cut.weight / (sim::kGravity * bar);
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
