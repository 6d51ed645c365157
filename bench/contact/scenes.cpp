#include "bench/contact/scenes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "bench/support/measured_mesh.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

constexpr double kEdge = 0.02;         // m, of the quads of uniform sheets
constexpr double kFoldRadius = 0.012;  // m

sim::GarmentMesh sheet(double side, double edge, const std::function<Vec3d(const Vec3d&)>& place) {
    const int quads = static_cast<int>(std::lround(side / edge));
    sim::GarmentMesh mesh = sim::make_square({.columns = quads, .rows = quads, .width = side, .depth = side});
    for (Vec3d& x : mesh.x) x = place(x);
    return mesh;
}

// Adds a mesh of one panel as the next panel.
void append(sim::GarmentMesh& mesh, const sim::GarmentMesh& added) {
    const int first = static_cast<int>(mesh.x.size()), panel = static_cast<int>(mesh.panel_names.size());
    mesh.x.insert(mesh.x.end(), added.x.begin(), added.x.end());
    for (sim::GarmentTriangle triangle : added.triangles) {
        for (int& v : triangle.vertices) v += first;
        triangle.panel = panel;
        mesh.triangles.push_back(triangle);
    }
    mesh.panel_names.push_back("sheet " + std::to_string(panel + 1));
    mesh.panel_grain_angles.push_back(0);
}

void pin_border(sim::GarmentMesh& mesh, double side) {
    for (std::size_t v = 0; v < mesh.x.size(); ++v) {
        const double farthest = std::max(std::abs(mesh.x[v].x()), std::abs(mesh.x[v].z()));
        if (farthest > side / 2 - 1e-6) mesh.pins.push_back(static_cast<int>(v));
    }
}

// A sheet folded in half round an axis along z; `rise` (m) is added to the upper half.
Vec3d folded(const Vec3d& x, double height, const std::function<double(double, double)>& rise) {
    const double arc = kFoldRadius * std::numbers::pi;
    if (x.x() < -arc / 2) return {x.x() + arc / 2, height, x.z()};
    if (x.x() > arc / 2) {
        const double along = x.x() - arc / 2;
        return {-along, height + 2 * kFoldRadius + rise(along, x.z()), x.z()};
    }
    const double angle = (x.x() + arc / 2) / kFoldRadius;
    return {kFoldRadius * std::sin(angle), height + kFoldRadius * (1 - std::cos(angle)), x.z()};
}

std::shared_ptr<const sim::Collider> sphere() {
    return std::make_shared<sim::SphereCollider>(Vec3f::Zero(), 0.3F);
}

std::shared_ptr<const sim::Collider> nothing() {
    return std::make_shared<sim::NoBody>();
}

// The sheet above the sphere with that number, turned a little against the others, and sloping by `slope`.
sim::GarmentMesh sheet_over_sphere(int number, double slope) {
    const double turn = 0.13 * number, height = 0.32 + 0.012 * number;
    return sheet(1, kEdge * (1 + 0.07 * number), [&](const Vec3d& x) {
        const double a = x.x() * std::cos(turn) - x.z() * std::sin(turn);
        const double b = x.x() * std::sin(turn) + x.z() * std::cos(turn);
        return Vec3d(a + 0.01 * number, height + slope * a, b + 0.006 * number);
    });
}

}  // namespace

ContactScene thrown_sheet(float speed) {
    ContactScene scene{
        .name = "throw, " + std::to_string(static_cast<int>(speed)) + " m/s", .mesh = {}, .body = nothing()};
    append(scene.mesh, sheet(1, kEdge, [](const Vec3d& x) { return x; }));
    pin_border(scene.mesh, 1);
    append(scene.mesh, sheet(0.5, kEdge, [](const Vec3d& x) -> Vec3d { return x + Vec3d(0.003, 0.1, 0.002); }));
    scene.sheets = 2;
    scene.steps = 121;
    scene.last_velocity = Vec3f(0, -speed, 0);
    return scene;
}

ContactScene pile() {
    ContactScene scene{.name = "pile", .mesh = {}, .body = nothing(), .floor = 0};
    append(scene.mesh, sheet(1, kEdge, [](const Vec3d& x) {
               const double wave = 0.01 * std::sin(9 * x.z() + 4 * x.x()) + 0.004 * std::sin(31 * x.x() + 1);
               return Vec3d(x.x(), x.z() + 0.55, wave);
           }));
    return scene;
}

ContactScene fold() {
    ContactScene scene{.name = "fold, 6 to 50 mm", .mesh = {}, .body = nothing(), .floor = 0, .is_adaptive = true};
    append(scene.mesh, sheet(1, 0.05, [](const Vec3d& x) {
               return folded(x, 0.3, [](double, double z) { return 0.01 * std::sin(5 * z); });
           }));
    return scene;
}

ContactScene layers_on_sphere(int count) {
    ContactScene scene{.name = std::to_string(count) + " layers on a sphere",
                       .mesh = {},
                       .body = sphere(),
                       .floor = -0.3F,
                       .sheets = count};
    for (int i = 0; i < count; ++i) append(scene.mesh, sheet_over_sphere(i, 0));
    return scene;
}

ContactScene tilt() {
    ContactScene scene{.name = "tilt", .mesh = {}, .body = sphere(), .floor = -0.3F, .sheets = 2};
    append(scene.mesh, sheet_over_sphere(0, 0));
    append(scene.mesh, sheet_over_sphere(1, 0.1));
    return scene;
}

ContactScene pull() {
    ContactScene scene{.name = "pull", .mesh = {}, .body = nothing(), .floor = 0};
    append(scene.mesh, sheet(0.6, kEdge, [](const Vec3d& x) {
               return folded(x, 0.05, [](double along, double z) {
                   const double from = along - 0.13, width = 0.04;
                   return -0.045 * std::exp(-(from * from + z * z) / (2 * width * width));
               });
           }));
    return scene;
}

ContactScene twist() {
    constexpr double kRadius = 0.12, kLength = 0.6;  // m
    constexpr int kRings = 30, kAround = 37;
    ContactScene scene{.name = "twist", .mesh = {}, .body = nothing(), .gravity = Vec3f::Zero(), .damping = 2};
    sim::GarmentMesh flat = sim::make_square(
        {.columns = kAround, .rows = kRings, .width = 2 * std::numbers::pi * kRadius, .depth = kLength});
    // Rolls the square up along its columns: the last one is the first.
    const auto rolled = [](int v) { return v / (kAround + 1) * kAround + v % (kAround + 1) % kAround; };
    sim::GarmentMesh tube;
    tube.x.resize(static_cast<std::size_t>(kAround * (kRings + 1)));
    tube.triangles = flat.triangles;
    for (int v = 0; v < static_cast<int>(flat.x.size()); ++v) {
        const Vec3d& x = flat.x[static_cast<std::size_t>(v)];
        const double angle = x.x() / kRadius;
        tube.x[static_cast<std::size_t>(rolled(v))] = {-x.z(), kRadius * std::cos(angle), kRadius * std::sin(angle)};
    }
    for (sim::GarmentTriangle& triangle : tube.triangles) {
        for (int& v : triangle.vertices) v = rolled(v);
    }
    append(scene.mesh, tube);
    std::vector<std::pair<std::uint32_t, Vec3f>> ends;
    for (std::size_t v = 0; v < tube.x.size(); ++v) {
        if (std::abs(tube.x[v].x()) < kLength / 2 - 1e-6) continue;
        scene.mesh.pins.push_back(static_cast<int>(v));
        ends.emplace_back(static_cast<std::uint32_t>(v), tube.x[v].cast<float>());
    }
    const float seconds = 0.8F * static_cast<float>(scene.steps) / 120;
    scene.kinematic = [ends, seconds](const sim::Cloth&, float time) {
        const float share = std::min(1.0F, time / seconds);
        std::vector<sim::KinematicVertex> targets;
        for (const auto& [v, start] : ends) {
            const float side = start.x() > 0 ? 1.0F : -1.0F, angle = side * share * std::numbers::pi_v<float>;
            targets.push_back(
                {.vertex = v,
                 .to = {start.x() - side * 0.06F * share, start.y() * std::cos(angle) - start.z() * std::sin(angle),
                        start.y() * std::sin(angle) + start.z() * std::cos(angle)}});
        }
        return targets;
    };
    return scene;
}

std::vector<ContactScene> all_contact_scenes() {
    std::vector<ContactScene> scenes;
    for (const float speed : {1.0F, 2.0F, 5.0F}) scenes.push_back(thrown_sheet(speed));
    scenes.push_back(pile());
    scenes.push_back(fold());
    scenes.push_back(layers_on_sphere(2));
    scenes.push_back(layers_on_sphere(5));
    scenes.push_back(tilt());
    scenes.push_back(pull());
    scenes.push_back(twist());
    return scenes;
}

}  // namespace selvedge::bench
