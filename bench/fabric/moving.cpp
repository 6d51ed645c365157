// The tests of textile_test.h in which cloth moves, or folds as it falls.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/fabric/shadow.h"
#include "bench/fabric/specimen.h"
#include "bench/fabric/textile_test.h"
#include "sim/body/analytic_collider.h"

namespace selvedge {
namespace {

constexpr double kG = 9.81;  // m/s^2

double rest_area(const ClothRun& run, bool of_holder_alone) {
    double area = 0;
    for (const LeafTriangle& t : run.cloth.mesh.leaf_triangles()) {
        if (!of_holder_alone || t.panel == Specimen::kHolder) area += static_cast<double>(material_area(t.u));
    }
    return area;
}

Shadow shadow_of(const ClothRun& run) {
    Shadow shadow;
    for (const LeafTriangle& t : run.cloth.mesh.leaf_triangles()) {
        std::array<Vec3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = run.cloth.x[t.v[k].value].head<3>().cast<double>();
        shadow.draw(corners);
    }
    return shadow;
}

constexpr double kSwingLength = 0.3;  // m

// angle: from the plumb line to the strip, rad.
ClothRun let_go(const Fabric& fabric, double angle, const MeshSetting& mesh, const Stepping& stepping) {
    const StripCut cut{.width = 0.1, .length = kSwingLength, .mesh_angle = mesh.angle, .edge_length = 0.04};
    const SpecimenFrame frame{.across = Vec3d::UnitZ(), .along = Vec3d(std::sin(angle), -std::cos(angle), 0)};
    const Specimen specimen = cut_strip(fabric, cut, frame);
    return start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
}

// Mean over the mass, m.
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

DrapeReading test_drape(const Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping) {
    const Specimen specimen = cut_disc(fabric, {.mesh_angle = mesh.angle});
    ClothRun run = start_run(specimen.mesh, specimen.fabrics, run_options(mesh, stepping));
    DrapeReading reading;
    reading.is_at_rest =
        run_to_rest(run, NoBody(), {.damping = 3, .least_seconds = 1, .max_seconds = 6, .rest_speed = 2e-3});
    const Shadow shadow = shadow_of(run);
    reading.coefficient = drape_coefficient(shadow.area(), rest_area(run, true), rest_area(run, false));
    reading.folds = count_folds(shadow.outline());
    return reading;
}

// From the first passage of the plumb line to the seventh are three periods.
double swing_period(const Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping) {
    constexpr std::size_t kPassages = 7;
    constexpr double kLongest = 6;  // s
    ClothRun run = let_go(fabric, 20 * std::numbers::pi / 180, mesh, stepping);
    std::vector<double> passages;
    double before = sideways(run);
    for (double t = 0; t < kLongest && passages.size() < kPassages; t += stepping.frame_seconds) {
        run_frame(run, NoBody());
        const double now = sideways(run);
        if ((before > 0) != (now > 0)) passages.push_back(t + stepping.frame_seconds * before / (before - now));
        before = now;
    }
    if (passages.size() < 3) return 0;
    return 2 * (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

double energy_growth(const Fabric& fabric, const MeshSetting& mesh, const Stepping& stepping) {
    constexpr double kSeconds = 3;
    ClothRun run = let_go(fabric, std::numbers::pi / 2, mesh, stepping);
    double mass = 0;
    for (const double m : masses(run)) mass += m;
    const double work = mass * kG * kSwingLength;
    double highest = -work;
    const double start = energy(run).potential;
    for (double t = 0; t < kSeconds; t += stepping.frame_seconds) {
        run_frame(run, NoBody());
        const Energy now = energy(run);
        highest = std::max(highest, now.kinetic + now.potential - start);
    }
    return highest / work;
}

}  // namespace selvedge
