#include "bench/drop/bias_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/support/square.h"
#include "sim/collide/collider.h"

namespace selvedge::bench {
namespace {

constexpr int kLength = 4;      // widths, of the strip
constexpr double kFrom = 1.25;  // widths below the clamp: upper gauge line
constexpr double kTo = 2.75;
constexpr double kG = 9.81;  // m/s^2

// One column of quads in the plane z = 0 that hangs down from y = 0. The lowest quad is the weight, a separate panel.
sim::GarmentMesh hanging_strip(double width) {
    const int rows = kLength + 1;
    sim::GarmentMesh strip = make_square({.columns = 1, .rows = rows, .width = width, .depth = width * rows});
    for (Vec3d& x : strip.x) x = Vec3d(x.x(), -x.z() - width * rows / 2, 0);
    for (sim::GarmentTriangle& t : strip.triangles) {
        const double middle = (t.u[0].y() + t.u[1].y() + t.u[2].y()) / 3;
        t.panel = middle < width ? 1 : 0;
    }
    strip.pins = {2 * rows, 2 * rows + 1};
    strip.panel_names = {"strip", "weight"};
    strip.panel_grain_angles = {std::numbers::pi / 4, std::numbers::pi / 4};
    return strip;
}

// Area density of the weight, kg/m^2: together with the strip's own weight below the middle of the gauge length, it
// causes options.strain. At least the density of the fabric.
double weight_density(const sim::Fabric& fabric, const BiasStripOptions& options) {
    const double force = options.strain * bias_stiffness(fabric);  // N/m
    const double strip_below = kLength - (kFrom + kTo) / 2;        // widths
    return std::max(force / (kG * options.element) - strip_below * fabric.area_density, fabric.area_density);
}

}  // namespace

BiasStrip measure_bias(const sim::Fabric& fabric, const BiasStripOptions& options) {
    const double width = options.element;
    sim::Fabric weight = fabric;
    weight.area_density = weight_density(fabric, options);
    ClothRun run =
        start_run(hanging_strip(width), {fabric, weight},
                  {.level = options.level, .substeps = options.substeps, .frame_seconds = options.frame_seconds});
    BiasStrip result;
    const RestOptions resting;
    result.is_at_rest = run_to_rest(run, sim::NoBody(), resting);

    const double top = width * (kLength + 1);  // material height of the clamp
    const auto line = [&](double below) {
        const double height = top - below * width;
        return mean_material_point(run.cloth, 0, Vec2d(0, height), Vec2d(width, height));
    };
    const double rest = (kTo - kFrom) * width;
    const auto strain = [&] { return (line(kFrom).y() - line(kTo).y()) / rest - 1; };
    const double measured = mean_reading(run, sim::NoBody(), resting.damping, strain);
    const double own = (kLength - (kFrom + kTo) / 2) * width * fabric.area_density;  // kg/m, strip below gauge middle
    const double force = kG * (own + width * weight.area_density);
    result.stiffness_ratio = bias_strain(fabric, force) / measured;
    return result;
}

}  // namespace selvedge::bench
