#include "bench/thesis/surface_scene.h"

#include <cmath>
#include <numbers>

#include "sim/adaptive/uniform.h"
#include "sim/body/analytic_collider.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/mesh/assemble.h"
#include "sim/pattern/pattern.h"

namespace selvedge {
namespace {

constexpr double kSquareSide = 0.5;                  // m: its edges are 5 cm, as garments have them
constexpr double kPinnedWidth = 0.8;                 // of the side, between the pinned corners
constexpr double kFlagWidth = 1.2, kFlagDrop = 0.8;  // m
constexpr int kStepsPerFrame = 4;

Pattern rectangle(double width, double height) {
    Panel panel;
    panel.name = "cloth";
    panel.vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    Pattern pattern;
    pattern.panels = {panel};
    return pattern;
}

// The edge length whose mesh comes nearest to so many triangles.
GarmentMesh rectangle_of(double width, double height, int triangles) {
    const Pattern pattern = rectangle(width, height);
    const double mean = std::sqrt(width * height / triangles * 2.3094);  // of equilateral triangles
    GarmentMesh nearest;
    const auto off = [&](const GarmentMesh& mesh) {
        return std::abs(static_cast<int>(mesh.triangles.size()) - triangles);
    };
    for (double share = 1.25; share > 0.75; share -= 0.01) {
        GarmentMesh mesh = assemble(pattern, {.target_edge = share * mean});
        if (off(mesh) < off(nearest)) nearest = std::move(mesh);
    }
    return nearest;
}

// Pinned at its upper corners, which are brought nearer; what is between bulges forward, so that it is as long as it
// was.
GarmentMesh pinned_square() {
    GarmentMesh mesh = rectangle_of(kSquareSide, kSquareSide, kSurfaceTriangles);
    const double bulge = 2.8 / std::numbers::pi * std::sqrt(1 - kPinnedWidth) * kSquareSide;
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        Vec3d& x = mesh.x[i];
        const bool is_top = x.y() > kSquareSide - 1e-9;
        if (is_top && (x.x() < 1e-9 || x.x() > kSquareSide - 1e-9)) mesh.pins.push_back(static_cast<int>(i));
        const double across = x.x() / kSquareSide;
        x = Vec3d((across - 0.5) * kSquareSide * kPinnedWidth, x.y() + 1, bulge * std::sin(std::numbers::pi * across));
    }
    return mesh;
}

GarmentMesh flag() {
    GarmentMesh mesh = rectangle_of(kFlagWidth, kFlagDrop, kSurfaceTriangles);
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        if (mesh.x[i].x() < 1e-9) mesh.pins.push_back(static_cast<int>(i));
        mesh.x[i] += Vec3d(0, 1, 0.02 * std::sin(9 * mesh.x[i].x()));
    }
    return mesh;
}

// It freshens and veers, always in the same way.
Wind wind_at(double time) {
    const double strength = 6 + 1.5 * std::sin(1.9 * time) + std::sin(4.3 * time + 1);
    const double veer = 0.35 * std::sin(1.3 * time) + 0.25 * std::sin(3.7 * time + 2);
    return {.velocity = Vec3d(strength * std::cos(veer), 0.2, strength * std::sin(veer)).cast<float>()};
}

}  // namespace

SurfaceScene make_surface_scene(SurfaceExperiment experiment, int level) {
    GarmentMesh base = experiment == SurfaceExperiment::Flag ? flag() : pinned_square();
    Cloth cloth = make_cloth(base, {find_fabric("cotton_shirting")});
    refresh_contacts(cloth);
    const MinimumLevelDisc everywhere{.panel = 0, .centre = Vec2f::Zero(), .radius = 10, .level = level};
    adapt_cloth(cloth, NoBody{},
                {.criteria = {.collision = false, .curvature = false, .length = false},
                 .minimum_levels = {&everywhere, 1},
                 .shortest_edge = 0},
                {});
    return {.experiment = experiment, .base = std::move(base), .cloth = std::move(cloth)};
}

void run_frame(SurfaceScene& scene) {
    const StepOptions options{.extra_damping = scene.experiment == SurfaceExperiment::Flag ? 0.0F : 1.0F};
    for (int i = 0; i < kStepsPerFrame; ++i) {
        const float seconds = step_seconds(scene.cloth, options);
        if (scene.experiment == SurfaceExperiment::Flag)
            blow(scene.cloth, wind_at(scene.frames * kSurfaceFrame + i * static_cast<double>(seconds)), seconds);
        step(scene.cloth, NoBody{}, options);
    }
    ++scene.frames;
}

void run_for(SurfaceScene& scene, double seconds) {
    const auto frames = std::lround(seconds / kSurfaceFrame);
    for (long i = 0; i < frames; ++i) run_frame(scene);
}

}  // namespace selvedge
