#include "sim/cloth/limit_lists.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/cloth/bias.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"

namespace selvedge {
namespace {

// A refined triangle lets its threads grow by what the fabric gives under the load that garments usually carry.
float longest_of(double stiffness, const Fabric& fabric) {
    constexpr double kUsualLoad = 2.5;  // N/m: a shirt hangs from its shoulders with some 1.6
    constexpr double kLeast = 0.005;    // the flat triangle through the corners of bent cloth is off by some of that
    return 1 + static_cast<float>(std::min(fabric.strain_limit, std::max(kLeast, kUsualLoad / stiffness)));
}

using Limits = ConstraintSet<LimitBlock, LimitRecord>;

void forget_stress(CarriedStress& carried, TriangleId t) {
    carried.above[t.value + 1].setZero();
}

// All but the gains and what the corners are moved. t: refined.
void set_limit(Cloth& cloth, TriangleId t, std::uint32_t slot) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    Limits& limits = cloth.solver.constraints.parents[triangle.level].limits;
    LimitRecord& record = limits.records[slot / kBlock];
    const std::size_t at = slot % kBlock;
    const Fabric& fabric = cloth.material.fabrics[triangle.panel];
    const MaterialFrame frame = material_frame(triangle.u, cloth.material.grain_angles[triangle.panel]);
    set_frame(limits.blocks[slot / kBlock], at, triangle.vertices, frame);
    const std::array<double, 3> stiffness{fabric.stretch_warp, fabric.stretch_weft, fabric.shear};
    set_lane(record.bias, at, kept_limit(cloth, t));
    for (std::size_t k = 0; k < 3; ++k) {
        record.compliance[k][at] = compliance_of(cloth, frame, stiffness[k]);
        if (k < 2) record.free_length[k][at] = longest_of(stiffness[k], fabric);
    }
    const ParentOf& parent = cloth.solver.lists.parent_of[t.value];
    record.place[at] = place_of(t);
    record.parent[at] = parent.place;
    record.of_area[at] = parent.of_area;
    CarriedStress& carried = cloth.solver.constraints.carried;
    for (std::vector<Vec4f>* sums : {&carried.below, &carried.off}) (*sums)[t.value + 1].setZero();
}

// Stress of shear that what is inside a refined triangle carries well by itself. A triangle gives so much stress per
// unit of its bias.
void add_easy_shear(SolverLists& lists, std::uint32_t parent, float of_area, float per_bias, float inside) {
    constexpr float kEasyBias = 0.05F;  // more of it takes long to be learnt
    lists.easy_shear[parent / 4] += of_area * (kEasyBias * per_bias + inside);
}

void add_easy_shear_of_leaves(SolverState& solver) {
    std::fill(solver.lists.easy_shear.begin(), solver.lists.easy_shear.end(), 0.0F);
    const auto& stretch = solver.constraints.stretch;
    for (std::size_t i = 0; i < stretch.blocks.size(); ++i) {
        const StretchRecord& record = stretch.records[i];
        for (std::size_t at = 0; at < kBlock; ++at) {
            const float per_bias = stretch.blocks[i].shear[at] * record.compliance[2][at];
            add_easy_shear(solver.lists, record.parent[at], record.of_area[at], per_bias, 0);
        }
    }
}

void add_easy_shear_of_limits(SolverState& solver, ParentLevel& parents) {
    for (LimitRecord& record : parents.limits.records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            const float inside = solver.lists.easy_shear[record.place[at] / 4];
            const float per_bias = record.per_shear[at] * record.compliance[2][at];
            record.easy_shear[at] = inside;
            add_easy_shear(solver.lists, record.parent[at], record.of_area[at], per_bias, inside);
        }
    }
}

}  // namespace

void make_limits(Cloth& cloth, int level) {
    SolverState& solver = cloth.solver;
    solver.constraints.parents[static_cast<std::size_t>(level)].limits.make(
        cloth.mesh.refined_triangles(level), solver.lists.vertices, std::identity{},
        [&](TriangleId t) { return indices(cloth.mesh.triangle(t).vertices); },
        [&](TriangleId t, std::uint32_t slot) { set_limit(cloth, t, slot); });
}

// One that was released was a leaf by then, and one whose id is another's now is looked at as that.
void change_limits(Cloth& cloth, const LeafChanges& changes) {
    Constraints& constraints = cloth.solver.constraints;
    const std::size_t spare_point = cloth.solver.lists.vertices;
    for (const TriangleId t : changes.refined_changed) {
        for (ParentLevel& level : constraints.parents) {
            if (level.limits.slot_of(t) == kSpare) continue;
            keep_limit(cloth, t, level);
            forget_stress(constraints.carried, t);
            level.limits.remove(t, spare_point);
        }
    }
    for (const TriangleId t : changes.refined_changed) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        if (is_leaf(triangle)) continue;
        constraints.parents[triangle.level].limits.insert(t, indices(triangle.vertices), spare_point,
                                                          [&](std::uint32_t slot) { set_limit(cloth, t, slot); });
    }
}

void list_centres(Cloth& cloth) {
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        std::vector<EdgeCentre>& centres = cloth.solver.constraints.parents[static_cast<std::size_t>(level)].centres;
        centres.clear();
        for (const EdgeId e : cloth.mesh.split_edges(level)) {
            const AdaptiveEdge& edge = cloth.mesh.edge(e);
            if (cloth.inverse_mass[edge.centre.value] <= 0) continue;
            centres.push_back({4 * edge.ends[0].value, 4 * edge.ends[1].value, 4 * edge.centre.value});
        }
    }
}

// A refined triangle moves the cloth about its vertices with it. So a vertex weighs as much there as all that follows
// it: its own mass, and half of that of each centre between it and another. Then no correction changes the momentum.
// Sums of floats in doubles: the same in any order.
void list_limit_masses(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    SolverLists& lists = solver.lists;
    lists.masses.resize(solver.constraints.parents.size());
    lists.masses_now.resize(solver.constraints.parents.size());
    std::vector<double>& sums = lists.mass_sums;
    sums.assign(lists.vertices + 1, 0.0);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float inverse = cloth.inverse_mass[v.value];
        sums[v.value] = inverse > 0 ? static_cast<double>(1 / inverse) : 0.0;
    }
    const auto add = [&](std::uint32_t to, double mass) {
        if (sums[to / 4] > 0) sums[to / 4] += 0.5 * mass;
    };
    for (std::size_t level = solver.constraints.parents.size(); level-- > 0;) {
        for (const EdgeCentre& c : solver.constraints.parents[level].centres) {
            add(c.a, sums[c.centre / 4]);
            add(c.b, sums[c.centre / 4]);
        }
        std::vector<float>& masses = lists.masses_now[level];
        masses.resize(sums.size());
        std::ranges::transform(sums, masses.begin(), [](double sum) { return static_cast<float>(sum); });
    }
}

// Easy shear is summed up for all: nearly each sum holds something that changed.
void weigh_limits(Cloth& cloth, const Kernels& loops) {
    SolverState& solver = cloth.solver;
    add_easy_shear_of_leaves(solver);
    for (std::size_t level = solver.constraints.parents.size(); level-- > 0;) {
        ParentLevel& parents = solver.constraints.parents[level];
        parents.limits.weigh_dirty(
            [&](auto blocks, auto records) { loops.weigh_limits(blocks, records, solver.lists.masses[level].data()); });
        add_easy_shear_of_limits(solver, parents);
    }
}

}  // namespace selvedge
