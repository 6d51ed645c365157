// The tests of textile_test.h that want a strip at rest.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/fabric/elastica.h"
#include "bench/fabric/specimen.h"
#include "bench/fabric/textile_test.h"
#include "bench/support/bias_theory.h"
#include "bench/support/material_points.h"
#include "sim/body/analytic_collider.h"

namespace selvedge {
namespace {

constexpr double kG = 9.81;  // m/s^2

double weight_of(const Fabric& fabric) {
    return fabric.area_density * kG;  // N/m^2
}

double warp_angle(ThreadDirection direction) {
    if (direction == ThreadDirection::Warp) return 0;
    return direction == ThreadDirection::Weft ? std::numbers::pi / 2 : std::numbers::pi / 4;
}

double stiffness(const Fabric& fabric, ThreadDirection direction) {
    if (direction == ThreadDirection::Bias) return bias_stiffness(fabric);
    return direction == ThreadDirection::Warp ? fabric.stretch_warp : fabric.stretch_weft;
}

Fabric without_friction(Fabric fabric) {
    fabric.bending_hysteresis = 0;
    fabric.shear_hysteresis = 0;
    return fabric;
}

double load_of(const Fabric& fabric, ThreadDirection direction) {
    constexpr double kE5 = 4.905;   // N/m
    constexpr double kE20 = 19.62;  // N/m
    const double k = stiffness(fabric, direction);
    if (direction == ThreadDirection::Bias) return 0.01 * k;
    const double most = k * fabric.strain_limit / 2;
    return most > kE20 ? kE20 : std::min(kE5, most);
}

// The strain between the lines l = from and l = to of a hanging strip.
double strain_between(const Specimen& specimen, const ClothRun& run, const StripCut& cut, double from, double to) {
    const auto height = [&](double l) {
        return mean_material_point(run.cloth, Specimen::kCloth, specimen.material(0, l),
                                   specimen.material(cut.width, l))
            .y();
    };
    return (height(from) - height(to)) / (to - from) - 1;
}

// Hangs the strip and reads its strain. At rest means that it creeps by less than a two-hundredth of what is expected
// in a second.
Reading hang(const Fabric& fabric, ThreadDirection direction, const StripCut& cut, const MeshSetting& mesh,
             const Stepping& stepping) {
    constexpr float kDamping = 10;  // 1/s
    const bool is_bias = direction == ThreadDirection::Bias;
    const double margin = is_bias ? 1.25 * cut.width : 0;  // threads that end in a clamp keep cloth from shearing
    const double from = margin;
    const double to = cut.length - margin;
    const double force = cut.weight + weight_of(fabric) * (cut.length - (from + to) / 2);
    Reading reading;
    reading.expected = is_bias ? bias_strain(fabric, force) : force / stiffness(fabric, direction);
    const Specimen specimen = cut_strip(fabric, cut, {});
    ClothRun run = start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
    reading.is_at_rest = run_to_rest(run, NoBody(),
                                     {.damping = kDamping,
                                      .least_seconds = 0.6,
                                      .max_seconds = 4,
                                      .rest_speed = 0.005 * reading.expected * cut.length});
    const auto strain = [&] { return strain_between(specimen, run, cut, from, to); };
    reading.measured = mean_reading(run, NoBody(), kDamping, strain);
    return reading;
}

StripCut strip_cut(ThreadDirection direction, const MeshSetting& mesh) {
    return {.mesh_angle = mesh.angle, .warp_angle = warp_angle(direction), .edge_length = 0.04};
}

}  // namespace

std::string name_of(ThreadDirection direction) {
    if (direction == ThreadDirection::Warp) return "warp";
    return direction == ThreadDirection::Weft ? "weft" : "bias";
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

Reading test_cantilever(const Fabric& tested, ThreadDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping) {
    const Fabric fabric = without_friction(tested);
    const double w = weight_of(fabric);
    Reading reading;
    reading.expected = direction == ThreadDirection::Warp ? fabric.bending_warp : fabric.bending_weft;
    StripCut cut{.mesh_angle = mesh.angle, .warp_angle = warp_angle(direction)};
    cut.length = std::cbrt(kPeirceQ * reading.expected / w);
    const SpecimenFrame level{.across = Vec3d::UnitZ(), .along = Vec3d::UnitX()};
    const Specimen specimen = cut_ridge_strip(fabric, cut, level);
    ClothRun run = start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
    reading.is_at_rest = run_to_rest(run, NoBody(), {.least_seconds = 0.4, .max_seconds = 6});
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

Reading test_own_weight(const Fabric& fabric, ThreadDirection direction, const MeshSetting& mesh,
                        const Stepping& stepping) {
    return hang(without_friction(fabric), direction, strip_cut(direction, mesh), mesh, stepping);
}

Reading test_load(const Fabric& fabric, ThreadDirection direction, const MeshSetting& mesh, const Stepping& stepping) {
    StripCut cut = strip_cut(direction, mesh);
    cut.weight = load_of(fabric, direction);
    return hang(without_friction(fabric), direction, cut, mesh, stepping);
}

}  // namespace selvedge
