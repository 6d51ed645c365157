#include "sim/cloth/strain_projection.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/material_frame.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

struct YarnTriangle {
    std::array<std::uint32_t, 3> v{};
    MaterialFrame frame;
    float longest = 1;  // of warp and weft
};

YarnTriangle triangle_of(const LeafTriangle& leaf, const ClothMaterial& material) {
    return {.v = {leaf.v[0].value, leaf.v[1].value, leaf.v[2].value},
            .frame = material_frame(leaf.u, material.grain_angles[leaf.panel]),
            .longest = 1 + static_cast<float>(material.fabrics[leaf.panel].strain_limit)};
}

Vec3f yarn(const YarnTriangle& triangle, const std::array<float, 2>& along, const std::vector<Vec4f>& points) {
    const Vec4f &x0 = points[triangle.v[0]], &x1 = points[triangle.v[1]], &x2 = points[triangle.v[2]];
    return (along[0] * (x1 - x0) + along[1] * (x2 - x0)).head<3>();
}

float over_limit(const YarnTriangle& triangle, const std::vector<Vec4f>& points) {
    const float warp = yarn(triangle, triangle.frame.a, points).norm();
    return std::max(warp, yarn(triangle, triangle.frame.b, points).norm()) - triangle.longest;
}

// The yarns of the leaf triangles and the triangles at each vertex.
class Yarns {
 public:
    Yarns(const Cloth& cloth, float tolerance) : tolerance_(tolerance), triangles_at_(cloth.x.size()) {
        for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
            const auto index = static_cast<std::uint32_t>(triangles_.size());
            for (const VertexId v : leaf.v) triangles_at_[v.value].push_back(index);
            triangles_.push_back(triangle_of(leaf, cloth.material));
        }
        is_active_.assign(triangles_.size(), false);
    }

    // The largest strain beyond the limit. Activates the triangles that are beyond it by more than the tolerance.
    float look(const std::vector<Vec4f>& points) {
        float worst = 0;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const float over = over_limit(triangles_[t], points);
            worst = std::max(worst, over);
            if (over > tolerance_) activate(t);
        }
        return worst;
    }

    // One Gauss-Seidel iteration over the active triangles, in their order. A triangle whose correction moved vertices
    // activates its neighbours.
    void sweep(std::vector<Vec4f>& points) {
        const std::size_t count = active_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const YarnTriangle& triangle = triangles_[active_[i]];
            const bool warp = shorten(triangle, triangle.frame.a, points);
            const bool weft = shorten(triangle, triangle.frame.b, points);
            if (!warp && !weft) continue;
            for (const std::uint32_t v : triangle.v)
                std::ranges::for_each(triangles_at_[v], [&](auto t) { activate(t); });
        }
    }

 private:
    // Returns whether the yarn was too long and could be corrected.
    static bool shorten(const YarnTriangle& triangle, const std::array<float, 2>& along, std::vector<Vec4f>& points) {
        const Vec3f direction = yarn(triangle, along, points);
        const float length = direction.norm();
        if (length <= triangle.longest) return false;
        const std::array<float, 3> gradient{-along[0] - along[1], along[0], along[1]};
        float sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += points[triangle.v[k]].w() * gradient[k] * gradient[k];
        if (sum <= 0) return false;
        const Vec3f step = direction * ((triangle.longest - length) / length / sum);
        for (std::size_t k = 0; k < 3; ++k) {
            Vec4f& x = points[triangle.v[k]];
            x.head<3>() += step * (x.w() * gradient[k]);
        }
        return true;
    }

    void activate(std::uint32_t t) {
        if (is_active_[t]) return;
        is_active_[t] = true;
        active_.push_back(t);
    }

    float tolerance_;
    std::vector<YarnTriangle> triangles_;
    std::vector<std::vector<std::uint32_t>> triangles_at_;  // by vertex
    std::vector<bool> is_active_;
    std::vector<std::uint32_t> active_;
};

// The points of the solver, loaded from the cloth at zero velocity, and stored with the cloth's own velocities.
class StillPoints {
 public:
    explicit StillPoints(Cloth& cloth) : cloth_(cloth) {
        SolverState& solver = *cloth.solver;
        for (std::size_t v = 0; v < cloth.x.size(); ++v) {
            solver.points[v] = cloth.x[v];
            solver.points[v].w() = cloth.inverse_mass[v];
        }
        solver.before = solver.points;
    }
    void store() {
        for (std::size_t v = 0; v < cloth_.x.size(); ++v) {
            const Vec4f moved = with_zero_w(cloth_.solver->points[v].head<3>()) - cloth_.x[v];
            cloth_.x[v] += moved;
            cloth_.x_prev[v] += moved;
        }
    }

 private:
    Cloth& cloth_;
};

}  // namespace

double total_excess(const Cloth& cloth) {
    constexpr float tolerance = StrainProjectionOptions{}.tolerance;
    double sum = 0;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const float over = over_limit(triangle_of(leaf, cloth.material), cloth.x);
        if (over > tolerance) sum += static_cast<double>(over - tolerance);
    }
    return sum;
}

StrainProjectionReport project_strain(Cloth& cloth, const Collider& body, const StepOptions& stepping,
                                      const StrainProjectionOptions& options) {
    SolverState& solver = *cloth.solver;
    SELVEDGE_ASSERT(solver.points.size() == cloth.x.size() + 1);
    StrainProjectionReport report;
    Yarns yarns(cloth, options.tolerance);
    report.worst_over = yarns.look(cloth.x);
    StillPoints points(cloth);
    report.deepest_face = deepest_watched_face(cloth, body);
    if (report.worst_over <= options.tolerance && report.deepest_face <= options.depth) return report;

    ContactOptions contact = stepping.contact;
    contact.friction_scale = 0;
    const MovingPoints moving{floats(solver.points), floats(solver.before), cloth.x.size()};
    SelfContact& self_contact = solver.self_contact->contact;
    if (stepping.self_contact) {
        update_contact_surface(cloth);
        self_contact.begin_step(moving, *stepping.self_contact);
    }
    std::vector<Vec4f> start, best = solver.points;  // a garment that is too small has no solution
    while (report.iterations < options.iterations &&
           (report.worst_over > options.tolerance || report.deepest_face > options.depth)) {
        solver.before = solver.points;
        for (int i = 0; i < options.sweeps_per_iteration; ++i) yarns.sweep(solver.points);
        push_out_samples(cloth, kernels(simd_level()), body, contact);
        start = solver.before;
        push_out_faces(cloth, body, contact);
        solver.before = start;  // so that the next two limit the whole move
        hold_vertices(cloth, kernels(simd_level()), body, options.longest_move, contact);
        if (stepping.self_contact) self_contact.substep(moving, *stepping.self_contact);
        ++report.iterations;
        const float worst = yarns.look(solver.points), deepest = deepest_watched_face(cloth, body);
        const float deeper = std::max(deepest, options.depth) - std::max(report.deepest_face, options.depth);
        if (deeper > 0 || (deeper == 0 && worst >= report.worst_over)) continue;
        report.worst_over = worst;
        report.deepest_face = deepest;
        best = solver.points;
    }
    solver.points = best;
    if (stepping.self_contact) self_contact.end_step(moving, *stepping.self_contact);
    points.store();
    return report;
}

}  // namespace selvedge::sim
