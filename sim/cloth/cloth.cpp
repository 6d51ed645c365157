#include "sim/cloth/cloth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/adaptive/surface_normals.h"
#include "sim/cloth/material_frame.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/state_transfer.h"
#include "sim/core/assert.h"

namespace selvedge::sim {

SolverHandle::SolverHandle() : state_(std::make_unique<SolverState>()) {}
SolverHandle::~SolverHandle() = default;
SolverHandle::SolverHandle(const SolverHandle& other)
    : state_(other.state_ ? std::make_unique<SolverState>(*other.state_) : nullptr) {}
SolverHandle::SolverHandle(SolverHandle&& other) noexcept = default;
SolverHandle& SolverHandle::operator=(const SolverHandle& other) {
    if (this != &other) state_ = other.state_ ? std::make_unique<SolverState>(*other.state_) : nullptr;
    return *this;
}
SolverHandle& SolverHandle::operator=(SolverHandle&& other) noexcept = default;
namespace {

constexpr float kRoom = 100;  // m: a larger coordinate is the result of an error

float mean_damping(const Cloth& cloth) {
    double sum = 0;
    double area = 0;
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const double a = material_area(triangle.u);
        sum += a * cloth.material.fabrics[triangle.panel].damping;
        area += a;
    }
    return area > 0 ? static_cast<float>(sum / area) : 0.0F;
}

void set_inverse_mass(Cloth& cloth, std::uint32_t v) {
    const auto mass = static_cast<float>(cloth.solver->mass_sums[v]);
    cloth.inverse_mass[v] = mass > 0 && !cloth.is_pinned[v] ? 1 / mass : 0.0F;
}

// Each leaf contributes a third of its mass to each of its corners. The total mass is constant up to rounding.
void refresh_masses(Cloth& cloth) {
    cloth.solver->mass_sums.assign(cloth.x.size(), 0.0);
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const auto third = static_cast<double>(third_of_mass(cloth, triangle.u, triangle.panel));
        for (const VertexId v : triangle.v) cloth.solver->mass_sums[v.value] += third;
    }
    for (std::uint32_t v = 0; v < cloth.x.size(); ++v) set_inverse_mass(cloth, v);
}

// Removed leaves still have their vertices and masses in the solver's slots.
void update_masses(Cloth& cloth) {
    const LeafChanges& changes = cloth.mesh.changes();
    SolverState& solver = *cloth.solver;
    solver.mass_sums.resize(cloth.x.size(), 0.0);
    for (const TriangleId t : changes.triangles_removed) {
        const std::uint32_t slot = solver.constraints.stretch.slot_of(t);
        const StretchBlock& block = solver.constraints.stretch.blocks[slot / kBlock];
        const auto third = static_cast<double>(solver.constraints.thirds[slot]);
        for (const BlockPoints& corner : block.vertices) {
            solver.mass_sums[corner[slot % kBlock] / 4] -= third;
            set_inverse_mass(cloth, corner[slot % kBlock] / 4);
        }
    }
    for (const TriangleId t : changes.triangles_added) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        const auto third = static_cast<double>(third_of_mass(cloth, triangle.u, triangle.panel));
        for (const VertexId v : triangle.vertices) {
            solver.mass_sums[v.value] += third;
            set_inverse_mass(cloth, v.value);
        }
    }
}

}  // namespace

void size_state(Cloth& cloth, std::size_t capacity) {
    cloth.x.resize(capacity, Vec4f::Zero());
    cloth.x_prev.resize(capacity, Vec4f::Zero());
    cloth.inverse_mass.resize(capacity, 0.0F);
    cloth.normals.resize(capacity, Vec3f::Zero());
    cloth.is_pinned.resize(capacity, false);
    cloth.solver->contacts.standoff.resize(capacity + 1, 0.0F);
}

Cloth make_cloth(const GarmentMesh& garment, std::vector<Fabric> fabrics, const ClothOptions& options) {
    SELVEDGE_ASSERT(garment.links.empty());
    SELVEDGE_ASSERT(fabrics.size() == garment.panel_names.size());
    Cloth cloth{.mesh = AdaptiveMesh(garment, {.max_level = options.max_level})};
    cloth.material.fabrics = std::move(fabrics);
    for (const double angle : garment.panel_grain_angles)
        cloth.material.grain_angles.push_back(static_cast<float>(angle));
    cloth.material.layers = garment.panel_layers;
    for (const Vec2d& offset : garment.panel_sett_offsets) cloth.material.sett_offsets.push_back(offset.cast<float>());
    cloth.substep = options.substep;
    size_state(cloth, cloth.mesh.vertex_capacity());
    for (std::size_t v = 0; v < garment.x.size(); ++v) cloth.x[v] = with_zero_w(garment.x[v].cast<float>());
    cloth.x_prev = cloth.x;
    for (const int pin : garment.pins) cloth.is_pinned[static_cast<std::size_t>(pin)] = true;
    refresh_solver(cloth);
    return cloth;
}

float third_of_mass(const Cloth& cloth, const std::array<Vec2f, 3>& u, std::uint16_t panel) {
    return material_area(u) * static_cast<float>(cloth.material.fabrics[panel].area_density) / 3;
}

void refresh_solver(Cloth& cloth) {
    ++cloth.adaptations;
    size_state(cloth, cloth.mesh.vertex_capacity());
    refresh_masses(cloth);
    cloth.solver->damping = mean_damping(cloth);
    make_blocks(cloth);
    reactivate(cloth);
}

void update_solver(Cloth& cloth) {
    for (const VertexId v : cloth.mesh.changes().vertices_added) {
        if (v.value >= cloth.solver->lost.size()) continue;
        cloth.solver->lost[v.value].setZero();
        cloth.solver->correction[v.value].setZero();
    }
    update_masses(cloth);
    change_blocks(cloth);
    reactivate(cloth);
}

void set_substep(Cloth& cloth, float substep) {
    for (std::size_t v = 0; v < cloth.x.size(); ++v) {
        cloth.x_prev[v] = cloth.x[v] - (cloth.x[v] - cloth.x_prev[v]) * (substep / cloth.substep);
    }
    const float ratio = substep / cloth.substep;
    rescale_biases(cloth, ratio);
    for (Vec4f& correction : cloth.solver->correction) correction *= ratio * ratio;
    cloth.substep = substep;
    refresh_solver(cloth);
}

void update_normals(Cloth& cloth) {
    sum_normals(cloth.mesh, cloth.normals, [&](const std::array<VertexId, 3>& v) -> Vec3f {
        const Vec3f x0 = cloth.x[v[0].value].head<3>();
        const Vec3f x1 = cloth.x[v[1].value].head<3>();
        const Vec3f x2 = cloth.x[v[2].value].head<3>();
        return (x1 - x0).cross(x2 - x0);
    });
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float length = cloth.normals[v.value].norm();
        if (length > 0) cloth.normals[v.value] /= length;
    }
}

float rms_speed(const Cloth& cloth, const std::vector<Vec4f>& before, double seconds) {
    SELVEDGE_ASSERT(before.size() == cloth.x.size());
    double energy = 0;
    double total = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] <= 0) continue;
        const double mass = 1.0 / cloth.inverse_mass[v.value];
        energy += mass * (cloth.x[v.value] - before[v.value]).squaredNorm();
        total += mass;
    }
    return total > 0 ? static_cast<float>(std::sqrt(energy / total) / seconds) : 0.0F;
}

float lowest_height(const Cloth& cloth) {
    float lowest = std::numeric_limits<float>::infinity();
    for (const VertexId v : cloth.mesh.leaf_vertices()) lowest = std::min(lowest, cloth.x[v.value].y());
    return lowest;
}

std::optional<VertexId> find_bad_vertex(const Cloth& cloth) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float size = cloth.x[v.value].cwiseAbs().maxCoeff();
        if (!(size < kRoom) || !std::isfinite(cloth.x[v.value].sum())) return v;
    }
    return std::nullopt;
}

std::vector<TriangleStrain> measure_strain(const Cloth& cloth) {
    std::vector<TriangleStrain> strains;
    strains.reserve(cloth.mesh.leaf_triangles().size());
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const MaterialFrame frame = material_frame(triangle.u, cloth.material.grain_angles[triangle.panel]);
        const Vec4f e1 = cloth.x[triangle.v[1].value] - cloth.x[triangle.v[0].value];
        const Vec4f e2 = cloth.x[triangle.v[2].value] - cloth.x[triangle.v[0].value];
        const Vec4f warp = e1 * frame.a[0] + e2 * frame.a[1];
        const Vec4f weft = e1 * frame.b[0] + e2 * frame.b[1];
        const float lengths = warp.norm() * weft.norm();
        const float cosine = lengths > 0 ? std::clamp(warp.dot(weft) / lengths, -1.0F, 1.0F) : 0.0F;
        strains.push_back({warp.norm() - 1, weft.norm() - 1, std::abs(std::asin(cosine))});
    }
    return strains;
}

DrawMesh draw_mesh(const Cloth& cloth, const std::vector<std::string>& panel_names) {
    DrawMesh mesh;
    mesh.panel_names = panel_names;
    mesh.panel_grain_angles = cloth.material.grain_angles;
    mesh.panel_sett_offsets = cloth.material.sett_offsets;
    std::vector<std::uint32_t> index(cloth.x.size(), 0);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        index[v.value] = static_cast<std::uint32_t>(mesh.x.size());
        mesh.x.push_back(cloth.x[v.value].head<3>());
        mesh.vertex_level.push_back(cloth.mesh.vertex(v).level);
    }
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        const std::array<std::uint32_t, 3> v{index[t.v[0].value], index[t.v[1].value], index[t.v[2].value]};
        mesh.triangles.push_back(v);
        mesh.u.push_back(t.u);
        mesh.panel.push_back(t.panel);
        mesh.level.push_back(t.level);
    }
    if (cloth.mesh.has_right_wrong_edges()) mesh.turned_corners = find_turned_corners(mesh.triangles);
    mesh.normals = vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners);
    return mesh;
}

namespace {

void add_with_inner(const AdaptiveMesh& mesh, TriangleId id, TriangleHierarchy& all) {
    const AdaptiveTriangle& t = mesh.triangle(id);
    all.push_back({.u = t.u, .panel = t.panel, .level = t.level, .is_leaf = is_leaf(t)});
    if (is_leaf(t)) return;
    const std::size_t inner = layout(t.configuration).triangle_count;
    for (std::size_t i = 0; i < inner; ++i) add_with_inner(mesh, t.internal_triangles[i], all);
}

}  // namespace

TriangleHierarchy triangle_hierarchy(const Cloth& cloth) {
    TriangleHierarchy all;
    all.reserve(cloth.mesh.triangles().size());
    for (std::size_t t = 0; t < cloth.mesh.base_triangle_count(); ++t)
        add_with_inner(cloth.mesh, TriangleId(static_cast<std::uint32_t>(t)), all);
    return all;
}

}  // namespace selvedge::sim
