#include "tests/sim/cloth/fixtures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/adaptive/criteria.h"
#include "sim/cloth/contact.h"
#include "sim/mesh/sew.h"
#include "sim/mesh/square.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

// Places the vertices that uniform refinement creates in the middle of their edges.
struct Midpoints {
    Cloth& cloth;

    void on_capacity(std::size_t capacity) {
        cloth.x.resize(capacity, Vec4f::Zero());
        cloth.x_prev.resize(capacity, Vec4f::Zero());
        cloth.is_pinned.resize(capacity, false);
    }
    void on_split(VertexId c, VertexId a, VertexId b) {
        cloth.x[c.value] = (cloth.x[a.value] + cloth.x[b.value]) / 2;
        cloth.x_prev[c.value] = (cloth.x_prev[a.value] + cloth.x_prev[b.value]) / 2;
        cloth.is_pinned[c.value] = cloth.is_pinned[a.value] && cloth.is_pinned[b.value];
    }
    void on_rejoin(VertexId) {}
};

// The strip as a panel that is drawn rotated by mesh_angle and rotated back when placed.
Pattern strip_pattern(const StripOptions& options) {
    const Eigen::Rotation2Dd turn(options.mesh_angle);
    Panel panel;
    panel.name = "strip";
    const double w = options.width;
    const double l = options.length;
    for (const Vec2d& corner : {Vec2d(0, -l), Vec2d(w, -l), Vec2d(w, 0), Vec2d(0, 0)}) {
        const int at = static_cast<int>(panel.vertices.size());
        panel.vertices.push_back(turn * corner);
        panel.edges.push_back({.start = at, .end = (at + 1) % 4});
    }
    panel.rotation = Eigen::AngleAxisd(-options.mesh_angle, Vec3d::UnitZ()).toRotationMatrix();
    panel.translation = Vec3d(0, 2, 0);
    panel.grain_angle = options.mesh_angle;
    panel.pins = {2, 3};
    Pattern pattern;
    pattern.panels = {panel};
    return pattern;
}

void pin_upper_edge(Cloth& cloth) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        cloth.is_pinned[v.value] = cloth.is_pinned[v.value] || cloth.x[v.value].y() > 2 - 1e-5F;
    }
    refresh_solver(cloth);
}

}  // namespace

const BodyCollider& nothing_near() {
    static const Obstacle far(shapes::sphere(Vec3d(0, -50, 0), 0.05, 4));
    return far.collider;
}

const BodyCollider& ball() {
    static const Obstacle sphere(shapes::sphere(Vec3d(0, 1, 0), 0.15, 24));
    return sphere.collider;
}

Fabric undamped(std::string_view name) {
    Fabric fabric = find_fabric(name);
    fabric.damping = 0;
    fabric.air_drag = 0;
    return fabric;
}

Cloth make_patch(const Fabric& fabric, const PatchOptions& options) {
    const GarmentMesh square = sim::make_square({.columns = options.quads,
                                                 .rows = options.quads,
                                                 .width = options.side,
                                                 .depth = options.side,
                                                 .height = options.height});
    Cloth cloth = make_cloth(square, {fabric}, {.max_level = options.max_level, .substep = options.substep});
    update_normals(cloth);
    refresh_contacts(cloth);
    return cloth;
}

Cloth make_strip(const Fabric& fabric, const StripOptions& options) {
    Cloth cloth = make_cloth(assemble(strip_pattern(options)), {fabric});
    pin_upper_edge(cloth);
    refine(cloth, options.level);
    return cloth;
}

void refine(Cloth& cloth, int level) {
    Midpoints state{cloth};
    set_uniform_level(cloth.mesh, state, level);
    refresh_solver(cloth);
    refresh_contacts(cloth);
    update_normals(cloth);
}

float draw(std::mt19937& random, float low, float high) {
    return low + (high - low) * static_cast<float>(static_cast<double>(random()) / 4294967296.0);
}

void shake(Cloth& cloth, float reach, std::mt19937& random) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        for (int axis = 0; axis < 3; ++axis) cloth.x[v.value][axis] += draw(random, -reach, reach);
    }
    cloth.x_prev = cloth.x;
}

void move_to(Cloth& cloth, const Eigen::Matrix3f& rotation, const Vec3f& shift) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        cloth.x[v.value] = with_zero_w(rotation * cloth.x[v.value].head<3>() + shift);
    }
    cloth.x_prev = cloth.x;
    update_normals(cloth);
}

double total_mass(const Cloth& cloth) {
    double sum = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] > 0) sum += 1.0 / double(cloth.inverse_mass[v.value]);
    }
    return sum;
}

Vec3d centre_of_mass(const Cloth& cloth) {
    Vec3d sum = Vec3d::Zero();
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] <= 0) continue;
        sum += cloth.x[v.value].head<3>().cast<double>() / double(cloth.inverse_mass[v.value]);
    }
    return sum / total_mass(cloth);
}

std::vector<Vec4f> solver_points(const Cloth& cloth, const std::vector<Vec4f>& x) {
    std::vector<Vec4f> points = x;
    for (std::size_t v = 0; v < points.size(); ++v) points[v].w() = cloth.inverse_mass[v];
    points.push_back(Vec4f(0, 1e4F, 0, 0));
    return points;
}

float exact_distance(const BodyCollider& body, const Vec3f& p) {
    return body.surface().closest(p, std::numeric_limits<float>::infinity())->distance;
}

float deepest(const Cloth& cloth, const BodyCollider& body) {
    float least = std::numeric_limits<float>::infinity();
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        least = std::min(least, exact_distance(body, cloth.x[v.value].head<3>()));
    }
    return least;
}

void run(Cloth& cloth, const BodyCollider& body, const StepOptions& options, double seconds) {
    const double step_seconds = double(cloth.substep) * options.substeps;
    const long steps = std::lround(seconds / step_seconds);
    for (long i = 0; i < steps; ++i) step(cloth, body, options);
}

float speed_now(const Cloth& cloth) {
    return rms_speed(cloth, cloth.x_prev, double(cloth.substep));
}

float speed_of_next_frames(Cloth& cloth, const BodyCollider& body, const StepOptions& options) {
    constexpr double kSeconds = 1.0 / 15.0;
    const std::vector<Vec4f> before = cloth.x;
    run(cloth, body, options, kSeconds);
    return rms_speed(cloth, before, kSeconds);
}

}  // namespace selvedge::sim::test
