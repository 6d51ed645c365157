#include "sim/cloth/solver_lists.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/bias.h"
#include "sim/cloth/block_lanes.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/material_frame.h"

namespace selvedge {
namespace {

std::array<std::uint32_t, 3> indices(const std::array<VertexId, 3>& v) {
    return {v[0].value, v[1].value, v[2].value};
}
std::array<std::uint32_t, 4> indices(const Hinge& hinge) {
    return {hinge.a.value, hinge.b.value, hinge.left.value, hinge.right.value};
}

// Blocks of one kind with their records and colours.
template <class Block, class Record>
struct BlockLists {
    std::vector<Block>& blocks;
    std::vector<Record>& records;
    BlockColoring& coloring;

    // As many as were coloured, all spare.
    void make(std::size_t vertices) {
        blocks.assign(coloring.block_count(), spare_block<Block>(vertices));
        records.assign(coloring.block_count(), spare_record<Record>());
    }
    template <std::size_t N>
    std::uint32_t take(const std::array<std::uint32_t, N>& corners, std::size_t vertices) {
        const std::uint32_t lane = coloring.insert(corners);
        if (coloring.block_count() > blocks.size()) {
            blocks.push_back(spare_block<Block>(vertices));
            records.push_back(spare_record<Record>());
        }
        return lane;
    }
    void give_back(std::uint32_t lane, std::size_t vertices) {
        Block& block = blocks[lane / kBlock];
        const std::size_t at = lane % kBlock;
        coloring.remove(lane, corners_at(block, at));
        copy_lane(spare_block<Block>(vertices), block, at);
        copy_lane(spare_record<Record>(), records[lane / kBlock], at);
    }
};

using StretchLists = BlockLists<StretchBlock, StretchRecord>;
using LimitLists = BlockLists<LimitBlock, LimitRecord>;
using BendLists = BlockLists<BendBlock, BendRecord>;

StretchLists stretch_lists(SolverState& solver) {
    return {solver.blocks.stretch, solver.blocks.records, solver.lanes.stretch};
}
BendLists bend_lists(SolverState& solver) {
    return {solver.blocks.bend, solver.blocks.bend_records, solver.lanes.bend};
}
LimitLists limit_lists(SolverState& solver, std::size_t level) {
    ParentLevel& parents = solver.blocks.parents[level];
    return {parents.triangles, parents.records, solver.lanes.limits[level]};
}

// Over a sub-step, of a triangle of that stiffness.  (XPBD)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness) {
    return 1 / (frame.area * cloth.substep * cloth.substep) / static_cast<float>(stiffness);
}

// Whether a seam edge of the triangle has to be shorter than the triangle's own copy of it: there the cloth is
// gathered, in puckers finer than the mesh.  (SPEC 3.2)
bool is_gathered(const AdaptiveMesh& mesh, const AdaptiveTriangle& triangle) {
    constexpr float kEase = 0.95F;
    for (std::size_t k = 0; k < 3; ++k) {
        const float own = (triangle.u[(k + 1) % 3] - triangle.u[k]).squaredNorm();
        const float rest = mesh.rest_length(triangle.edges[k]);
        if (rest * rest < kEase * kEase * own) return true;
    }
    return false;
}

// The corners and directions of a triangle, a leaf or a parent.
template <class Block>
void set_frame(Block& block, std::size_t at, const std::array<VertexId, 3>& v, const MaterialFrame& frame) {
    for (std::size_t i = 0; i < 3; ++i) block.vertices[i][at] = 4 * v[i].value;
    for (std::size_t i = 0; i < 2; ++i) {
        block.a[i][at] = frame.a[i];
        block.b[i][at] = frame.b[i];
    }
}

// All but the gains. t: a leaf.
void set_stretch(Cloth& cloth, TriangleId t, std::uint32_t lane) {
    const AdaptiveTriangle& leaf = cloth.mesh.triangle(t);
    SolverBlocks& blocks = cloth.solver.blocks;
    StretchBlock& block = blocks.stretch[lane / kBlock];
    StretchRecord& record = blocks.records[lane / kBlock];
    const std::size_t at = lane % kBlock;
    const Fabric& fabric = cloth.fabrics[leaf.panel];
    const MaterialFrame frame = material_frame(leaf.u, cloth.grain_angles[leaf.panel]);
    set_frame(block, at, leaf.vertices, frame);
    block.longest[at] = 1 + static_cast<float>(fabric.strain_limit);
    block.push[at] = is_gathered(cloth.mesh, leaf) ? 0.0F : 1.0F;
    block.slip[at] = static_cast<float>(fabric.shear_hysteresis / (2 * fabric.shear)) / kStick;
    const KeptBias kept = kept_bias(cloth, t);
    for (std::size_t k = 0; k < 3; ++k) block.bias[k][at] = kept.value[static_cast<Eigen::Index>(k)];
    block.anchor[at] = kept.anchor;
    record.compliance[0][at] = compliance_of(cloth, frame, fabric.stretch_warp);
    record.compliance[1][at] = compliance_of(cloth, frame, fabric.stretch_weft);
    record.compliance[2][at] = compliance_of(cloth, frame, fabric.shear);
    const ParentOf& parent = cloth.solver.lanes.parent_of[t.value];
    record.parent[at] = parent.place;
    record.of_area[at] = parent.of_area;
    blocks.triangle_of[lane] = t.value;
    blocks.thirds[lane] = third_of_mass(cloth, leaf.u, leaf.panel);
    cloth.solver.lanes.stretch_of[t.value] = lane;
}

// A refined triangle lets its threads grow by what the fabric gives under the load that garments usually carry.
float longest_of(double stiffness, const Fabric& fabric) {
    constexpr double kUsualLoad = 2.5;  // N/m: a shirt hangs from its shoulders with some 1.6
    constexpr double kLeast = 0.002;    // so that the leaves carry what they can by themselves
    return 1 + static_cast<float>(std::min(fabric.strain_limit, std::max(kLeast, kUsualLoad / stiffness)));
}

// The refined triangle of the same panel across an edge, or else the triangle itself.
TriangleId beside(const AdaptiveMesh& mesh, TriangleId t, std::size_t edge) {
    const AdaptiveTriangle& triangle = mesh.triangle(t);
    const AdaptiveEdge& shared = mesh.edge(triangle.edges[edge]);
    const TriangleId other = shared.sides[0] == t ? shared.sides[1] : shared.sides[0];
    if (!other || is_leaf(mesh.triangle(other)) || mesh.triangle(other).panel != triangle.panel) return t;
    return other;
}

LimitRecord& limit_record(SolverState& solver, TriangleId t) {
    const std::uint32_t lane = solver.lanes.limit_of[t.value];
    return solver.blocks.parents[solver.lanes.limit_level[t.value]].records[lane / kBlock];
}

// It knows those beside it, and they know it.
void join_neighbours(Cloth& cloth, TriangleId t, LimitRecord& record, std::size_t at) {
    SolverState& solver = cloth.solver;
    for (std::size_t k = 0; k < 3; ++k) {
        const TriangleId other = beside(cloth.mesh, t, k);
        record.neighbours[k][at] = place_of(other);
        if (other == t || solver.lanes.limit_of[other.value] == kSpare) continue;
        const std::size_t side = place_of(cloth.mesh.triangle(other), cloth.mesh.triangle(t).edges[k]);
        const std::size_t other_at = solver.lanes.limit_of[other.value] % kBlock;
        limit_record(solver, other).neighbours[side][other_at] = place_of(t);
    }
}

// Those that knew it stand alone there.
void leave_neighbours(SolverState& solver, TriangleId t) {
    const LimitRecord& record = limit_record(solver, t);
    const std::size_t at = solver.lanes.limit_of[t.value] % kBlock;
    for (std::size_t k = 0; k < 3; ++k) {
        const TriangleId other(record.neighbours[k][at] / 4 - 1);
        if (other == t || solver.lanes.limit_of[other.value] == kSpare) continue;
        LimitRecord& knows = limit_record(solver, other);
        const std::size_t other_at = solver.lanes.limit_of[other.value] % kBlock;
        for (BlockPoints& places : knows.neighbours) {
            if (places[other_at] == place_of(t)) places[other_at] = place_of(other);
        }
    }
    for (std::vector<Vec4f>* stress : {&solver.blocks.carried.own, &solver.blocks.carried.above}) {
        (*stress)[t.value + 1].setZero();
    }
}

// All but the gains and what the corners are moved. t: refined.
void set_limit(Cloth& cloth, TriangleId t, std::uint32_t lane) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    ParentLevel& parents = cloth.solver.blocks.parents[triangle.level];
    LimitRecord& record = parents.records[lane / kBlock];
    const std::size_t at = lane % kBlock;
    const Fabric& fabric = cloth.fabrics[triangle.panel];
    const MaterialFrame frame = material_frame(triangle.u, cloth.grain_angles[triangle.panel]);
    set_frame(parents.triangles[lane / kBlock], at, triangle.vertices, frame);
    const std::array<double, 3> stiffness{fabric.stretch_warp, fabric.stretch_weft, fabric.shear};
    const Vec3f bias = kept_limit(cloth, t);
    for (std::size_t k = 0; k < 3; ++k) {
        record.compliance[k][at] = compliance_of(cloth, frame, stiffness[k]);
        record.bias[k][at] = bias[static_cast<Eigen::Index>(k)];
        if (k < 2) record.free_length[k][at] = longest_of(stiffness[k], fabric);
    }
    const ParentOf& parent = cloth.solver.lanes.parent_of[t.value];
    record.place[at] = place_of(t);
    record.parent[at] = parent.place;
    record.of_area[at] = parent.of_area;
    cloth.solver.blocks.carried.below[t.value + 1].setZero();
    cloth.solver.lanes.limit_of[t.value] = lane;
    cloth.solver.lanes.limit_level[t.value] = triangle.level;
    join_neighbours(cloth, t, record, at);
}

// Rigidity against folding about an edge: the cloth bends across it.
float hinge_rigidity(const Fabric& fabric, const Vec2f& along, float grain_angle) {
    const float across_warp = weft_direction(grain_angle).dot(along);  // edge along the weft: the warp bends
    const float share = across_warp * across_warp;
    return static_cast<float>(fabric.bending_warp) * share + static_cast<float>(fabric.bending_weft) * (1 - share);
}

// With cotangent weights of the unfolded rest state the sum of q_i x_i is the mean curvature vector about the hinge.
std::array<float, 4> hinge_weights(const Hinge& hinge) {
    const Vec2f a(-0.5F * hinge.rest_length, 0);
    const Vec2f b(0.5F * hinge.rest_length, 0);
    const auto cotangent = [](const Vec2f& p, const Vec2f& q) {
        return p.dot(q) / std::abs(p.x() * q.y() - p.y() * q.x());
    };
    const float left_a = cotangent(b - a, hinge.left_at - a);
    const float right_a = cotangent(b - a, hinge.right_at - a);
    const float left_b = cotangent(a - b, hinge.left_at - b);
    const float right_b = cotangent(a - b, hinge.right_at - b);
    return {left_b + right_b, left_a + right_a, -left_a - left_b, -right_a - right_b};
}

// What belongs to the fabric and the shape of a hinge.
struct HingeFabric {
    float rigidity = 0;    // N m
    float hysteresis = 0;  // N, KES 2HB
};
HingeFabric hinge_fabric(const Cloth& cloth, const Hinge& hinge) {
    HingeFabric mean;
    const AdaptiveEdge& edge = cloth.mesh.edge(hinge.edge);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint16_t panel = cloth.mesh.triangle(edge.sides[side]).panel;
        const Fabric& fabric = cloth.fabrics[panel];
        mean.rigidity += 0.5F * hinge_rigidity(fabric, hinge.along[side], cloth.grain_angles[panel]);
        mean.hysteresis += 0.5F * static_cast<float>(fabric.bending_hysteresis);
    }
    return mean;
}

// Where nothing was kept of an edge, friction starts from how the cloth is bent.
void set_memory(Cloth& cloth, EdgeId edge, std::uint32_t lane) {
    BendBlock& block = cloth.solver.blocks.bend[lane / kBlock];
    const std::size_t at = lane % kBlock;
    const KeptBend kept = kept_bend(cloth, edge);
    block.pull[at] = kept.pull;
    block.anchor[at] = kept.anchor;
    if (kept.corners != corners_at(block, at)) cloth.solver.lanes.held.push_back({lane, kept.held});
}

// All but the gains. Energy 1/2 B / (A_left + A_right) |sum q x|^2.
//
// A moment is the derivative of energy by sum q x where the cloth bends across the edge alone. Bent elsewhere, the
// three edges of a triangle share it, and their frictions add up to 1 to 1.7 times as much, 1.44 on an average.
void set_bend(Cloth& cloth, const Hinge& hinge, std::uint32_t lane) {
    constexpr float kFrictionShare = 1 / 1.44F;
    constexpr float kLeast = 1e-12F;  // N m: what bends more easily is limp, and has no spring for friction to act on
    const std::array<std::uint32_t, 4> corners = indices(hinge);
    const std::array<float, 4> q = hinge_weights(hinge);
    const float area = 0.5F * hinge.rest_length * (hinge.left_at.y() - hinge.right_at.y());
    const float time = cloth.substep * cloth.substep;
    const HingeFabric fabric = hinge_fabric(cloth, hinge);
    BendBlock& block = cloth.solver.blocks.bend[lane / kBlock];
    BendRecord& record = cloth.solver.blocks.bend_records[lane / kBlock];
    const std::size_t at = lane % kBlock;
    for (std::size_t i = 0; i < 4; ++i) {
        block.vertices[i][at] = 4 * corners[i];
        block.q[i][at] = q[i];
    }
    block.bow[at] = 0.25F / (hinge.rest_length * hinge.rest_length);
    record.compliance[0][at] = area / (std::max(fabric.rigidity, kLeast) * time);
    record.friction[at] = fabric.rigidity > kLeast ? 0.5F * fabric.hysteresis * time * kFrictionShare : 0.0F;
    record.length[at] = hinge.rest_length;
    set_memory(cloth, hinge.edge, lane);
    cloth.solver.lanes.bend_of[hinge.edge.value] = lane;
}

void make_stretch(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    StretchLists lists = stretch_lists(solver);
    const std::span<const LeafTriangle> leaves = cloth.mesh.leaf_triangles();
    lists.coloring.start(solver.lanes.vertices);
    for (const LeafTriangle& leaf : leaves) lists.coloring.add(indices(leaf.v));
    const std::vector<std::uint32_t>& lanes = lists.coloring.assign();
    lists.make(solver.lanes.vertices);
    solver.blocks.triangle_of.assign(lists.blocks.size() * kBlock, kSpare);
    solver.blocks.thirds.assign(lists.blocks.size() * kBlock, 0.0F);
    for (std::size_t i = 0; i < leaves.size(); ++i) set_stretch(cloth, leaves[i].triangle, lanes[i]);
}

void make_bend(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    BendLists lists = bend_lists(solver);
    const std::span<const Hinge> hinges = cloth.mesh.hinges();
    lists.coloring.start(solver.lanes.vertices);
    for (const Hinge& hinge : hinges) lists.coloring.add(indices(hinge));
    const std::vector<std::uint32_t>& lanes = lists.coloring.assign();
    lists.make(solver.lanes.vertices);
    solver.lanes.bend_of.assign(cloth.mesh.edges().capacity(), kSpare);
    for (std::size_t i = 0; i < hinges.size(); ++i) set_bend(cloth, hinges[i], lanes[i]);
}

void make_limits(Cloth& cloth, int level) {
    SolverState& solver = cloth.solver;
    LimitLists lists = limit_lists(solver, static_cast<std::size_t>(level));
    const std::span<const TriangleId> refined = cloth.mesh.refined_triangles(level);
    lists.coloring.start(solver.lanes.vertices);
    for (const TriangleId t : refined) lists.coloring.add(indices(cloth.mesh.triangle(t).vertices));
    const std::vector<std::uint32_t>& lanes = lists.coloring.assign();
    lists.make(solver.lanes.vertices);
    for (std::size_t i = 0; i < refined.size(); ++i) set_limit(cloth, refined[i], lanes[i]);
}

void size_triangles(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    const std::size_t capacity = cloth.mesh.triangles().capacity();
    solver.lanes.stretch_of.resize(capacity, kSpare);
    solver.lanes.limit_of.resize(capacity, kSpare);
    solver.lanes.limit_level.resize(capacity, 0);
    solver.lanes.parent_of.resize(capacity);
    solver.lanes.easy_shear.resize(capacity + 1, 0.0F);
    CarriedStress& carried = solver.blocks.carried;
    for (std::vector<Vec4f>* stress : {&carried.own, &carried.above, &carried.below}) {
        stress->resize(capacity + 1, Vec4f::Zero());
    }
}

void forget_triangles(SolverState& solver) {
    solver.lanes.stretch_of.clear();
    solver.lanes.limit_of.clear();
    solver.lanes.limit_level.clear();
    solver.lanes.parent_of.clear();
    solver.blocks.carried = {};
}

void list_centres(Cloth& cloth) {
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        std::vector<EdgeCentre>& centres = cloth.solver.blocks.parents[static_cast<std::size_t>(level)].centres;
        centres.clear();
        for (const EdgeId e : cloth.mesh.split_edges(level)) {
            const AdaptiveEdge& edge = cloth.mesh.edge(e);
            if (cloth.inverse_mass[edge.centre.value] <= 0) continue;
            centres.push_back({4 * edge.ends[0].value, 4 * edge.ends[1].value, 4 * edge.centre.value});
        }
    }
}

// Stress of shear that what is inside a refined triangle carries well by itself. A triangle gives so much stress per
// unit of its bias.
void add_easy_shear(SolverLanes& lanes, std::uint32_t parent, float of_area, float per_bias, float inside) {
    constexpr float kEasyBias = 0.04F;  // more of it takes long to be learnt
    lanes.easy_shear[parent / 4] += of_area * (kEasyBias * per_bias + inside);
}

void add_easy_shear_of_leaves(SolverState& solver) {
    std::fill(solver.lanes.easy_shear.begin(), solver.lanes.easy_shear.end(), 0.0F);
    for (std::size_t i = 0; i < solver.blocks.stretch.size(); ++i) {
        const StretchRecord& record = solver.blocks.records[i];
        for (std::size_t at = 0; at < kBlock; ++at) {
            const float per_bias = solver.blocks.stretch[i].shear[at] * record.compliance[2][at];
            add_easy_shear(solver.lanes, record.parent[at], record.of_area[at], per_bias, 0);
        }
    }
}

void add_easy_shear_of_limits(SolverState& solver, ParentLevel& parents) {
    for (LimitRecord& record : parents.records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            const float inside = solver.lanes.easy_shear[record.place[at] / 4];
            const float per_bias = record.per_shear[at] * record.compliance[2][at];
            record.easy_shear[at] = inside;
            add_easy_shear(solver.lanes, record.parent[at], record.of_area[at], per_bias, inside);
        }
    }
}

// A refined triangle moves the cloth about its vertices with it. So a vertex weighs as much there as all that follows
// it: its own mass, and half of that of each centre between it and another. Then no correction changes the momentum.
void weigh_parents(Cloth& cloth, const Kernels& loops) {
    SolverState& solver = cloth.solver;
    std::vector<float>& masses = solver.lanes.masses;
    masses.assign(solver.lanes.vertices + 1, 0.0F);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float inverse = cloth.inverse_mass[v.value];
        masses[v.value] = inverse > 0 ? 1 / inverse : 0.0F;
    }
    const auto add = [&](std::uint32_t to, float mass) {
        if (masses[to / 4] > 0) masses[to / 4] += 0.5F * mass;
    };
    for (std::size_t level = solver.blocks.parents.size(); level-- > 0;) {
        ParentLevel& parents = solver.blocks.parents[level];
        for (const EdgeCentre& c : parents.centres) {
            add(c.a, masses[c.centre / 4]);
            add(c.b, masses[c.centre / 4]);
        }
        loops.weigh_limits(parents.triangles, parents.records, masses.data());
        add_easy_shear_of_limits(solver, parents);
    }
}

// Where more than one hinge of so many is too stiff for a visit now and then, all are visited in each sub-step; until
// far fewer are.
int chosen_interval(const Cloth& cloth, const Kernels& loops) {
    constexpr std::size_t kFew = 20, kFewer = 40;
    if (cloth.bend_interval == 1) return 1;
    const SolverBlocks& blocks = cloth.solver.blocks;
    const std::size_t count = loops.count_short_hinges(blocks.bend, blocks.bend_records, cloth.bend_interval,
                                                       cloth.solver.lanes.inverse_masses.data());
    return (blocks.bend_interval == 1 ? kFewer : kFew) * count < cloth.mesh.hinges().size() ? cloth.bend_interval : 1;
}

void weigh_hinges(Cloth& cloth, const Kernels& loops) {
    SolverBlocks& blocks = cloth.solver.blocks;
    blocks.bend_interval = chosen_interval(cloth, loops);
    const float time = cloth.substep * cloth.substep * static_cast<float>(blocks.bend_interval);
    const float scale = blocks.bend_time > 0 ? time / blocks.bend_time : 1.0F;
    loops.weigh_bend(blocks.bend, blocks.bend_records, {.interval = blocks.bend_interval, .pull_scale = scale},
                     cloth.solver.lanes.inverse_masses.data());
    blocks.bend_time = time;
    for (const auto& [lane, held] : cloth.solver.lanes.held) {
        BendBlock& block = blocks.bend[lane / kBlock];
        const std::size_t at = lane % kBlock;
        block.anchor[at] = bending_now(cloth, block, at) - held * block.slip[at];
    }
    cloth.solver.lanes.held.clear();
}

void weigh_blocks(Cloth& cloth) {
    const Kernels& loops = kernels(simd_level());
    SolverState& solver = cloth.solver;
    solver.lanes.inverse_masses = cloth.inverse_mass;
    solver.lanes.inverse_masses.push_back(0.0F);
    loops.weigh_stretch(solver.blocks.stretch, solver.blocks.records, solver.lanes.inverse_masses.data());
    weigh_hinges(cloth, loops);
    add_easy_shear_of_leaves(solver);
    weigh_parents(cloth, loops);
    solver.blocks.over.resize(solver.blocks.stretch.size());
    solver.blocks.over_counts.resize(solver.lanes.stretch.runs().size());
}

void change_stretch(Cloth& cloth, const LeafChanges& changes) {
    SolverState& solver = cloth.solver;
    StretchLists lists = stretch_lists(solver);
    for (const TriangleId t : changes.triangles_gone) {
        std::uint32_t& lane = solver.lanes.stretch_of[t.value];
        keep_bias(cloth, t);
        lists.give_back(lane, solver.lanes.vertices);
        solver.blocks.triangle_of[lane] = kSpare;
        lane = kSpare;
    }
    for (const TriangleId t : changes.triangles_come) {
        const std::uint32_t lane = lists.take(indices(cloth.mesh.triangle(t).vertices), solver.lanes.vertices);
        solver.blocks.triangle_of.resize(lists.blocks.size() * kBlock, kSpare);
        solver.blocks.thirds.resize(lists.blocks.size() * kBlock, 0.0F);
        set_stretch(cloth, t, lane);
    }
}

void change_bend(Cloth& cloth, const LeafChanges& changes) {
    SolverState& solver = cloth.solver;
    BendLists lists = bend_lists(solver);
    solver.lanes.bend_of.resize(cloth.mesh.edges().capacity(), kSpare);
    const auto take_out = [&](EdgeId e) {
        std::uint32_t& lane = solver.lanes.bend_of[e.value];
        if (lane != kSpare) lists.give_back(lane, solver.lanes.vertices);
        lane = kSpare;
    };
    const auto put_in = [&](EdgeId e) {
        const Hinge* hinge = cloth.mesh.hinge(e);
        if (hinge != nullptr) set_bend(cloth, *hinge, lists.take(indices(*hinge), solver.lanes.vertices));
    };
    for (const EdgeId e : changes.edges_come) keep_bend(cloth, e);  // it may have gone and come again
    for (const EdgeId e : changes.hinges_changed) keep_bend(cloth, e);
    for (const EdgeId e : changes.edges_gone) take_out(e);
    for (const EdgeId e : changes.hinges_changed) take_out(e);
    for (const EdgeId e : changes.edges_come) put_in(e);
    for (const EdgeId e : changes.hinges_changed) put_in(e);
}

// One that was released was a leaf by then, and one whose id is another's now is looked at as that.
void change_limits(Cloth& cloth, const LeafChanges& changes) {
    SolverState& solver = cloth.solver;
    for (const TriangleId t : changes.refined_changed) {
        std::uint32_t& lane = solver.lanes.limit_of[t.value];
        if (lane == kSpare) continue;
        keep_limit(cloth, t);
        leave_neighbours(solver, t);
        limit_lists(solver, solver.lanes.limit_level[t.value]).give_back(lane, solver.lanes.vertices);
        lane = kSpare;
    }
    for (const TriangleId t : changes.refined_changed) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        if (is_leaf(triangle)) continue;
        LimitLists lists = limit_lists(solver, triangle.level);
        set_limit(cloth, t, lists.take(indices(triangle.vertices), solver.lanes.vertices));
    }
}

// Lanes that are put in one by one lie less well in memory than those that are put in all at once.
bool is_worn(const Cloth& cloth) {
    const std::size_t leaves = cloth.mesh.leaf_triangles().size();
    const SolverState& solver = cloth.solver;
    return solver.lanes.vertices != cloth.mesh.vertex_capacity() || solver.lanes.inserted > leaves ||
           solver.blocks.stretch.size() * kBlock > 2 * leaves + 64 * kBlock;
}

}  // namespace

std::uint32_t limit_lane(const Cloth& cloth, TriangleId t) {
    const SolverState& solver = cloth.solver;
    if (t.value >= solver.lanes.limit_of.size()) return kSpare;
    const std::uint32_t lane = solver.lanes.limit_of[t.value];
    if (lane == kSpare) return kSpare;
    const LimitBlock& block = solver.blocks.parents[solver.lanes.limit_level[t.value]].triangles[lane / kBlock];
    return corners_at(block, lane % kBlock) == indices(cloth.mesh.triangle(t).vertices) ? lane : kSpare;
}

void note_children(Cloth& cloth, TriangleId t) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    std::vector<ParentOf>& parent_of = cloth.solver.lanes.parent_of;
    const float area = material_area(triangle.u);
    for (std::size_t i = 0; i < layout(triangle.configuration).triangle_count; ++i) {
        const TriangleId child = triangle.internal_triangles[i];
        if (child.value >= parent_of.size()) parent_of.resize(cloth.mesh.triangles().capacity());
        parent_of[child.value] = {place_of(t), material_area(cloth.mesh.triangle(child).u) / area};
    }
}

std::uint32_t stretch_lane(const Cloth& cloth, TriangleId t, const std::array<VertexId, 3>& corners) {
    const SolverState& solver = cloth.solver;
    if (t.value >= solver.lanes.stretch_of.size()) return kSpare;
    const std::uint32_t lane = solver.lanes.stretch_of[t.value];
    if (lane == kSpare || corners_at(solver.blocks.stretch[lane / kBlock], lane % kBlock) != indices(corners)) {
        return kSpare;
    }
    return lane;
}

std::uint32_t bend_lane(const Cloth& cloth, EdgeId e) {
    const SolverState& solver = cloth.solver;
    if (e.value >= solver.lanes.bend_of.size()) return kSpare;
    const std::uint32_t lane = solver.lanes.bend_of[e.value];
    if (lane == kSpare) return kSpare;
    const std::array<VertexId, 2>& ends = cloth.mesh.edge(e).ends;
    const std::array<std::uint32_t, 4> corners = corners_at(solver.blocks.bend[lane / kBlock], lane % kBlock);
    return corners[0] == ends[0].value && corners[1] == ends[1].value ? lane : kSpare;
}

void make_blocks(Cloth& cloth) {
    SolverState& solver = cloth.solver;
    keep_biases(cloth);
    keep_bends(cloth);
    solver.lanes.vertices = cloth.mesh.vertex_capacity();
    solver.lanes.inserted = 0;
    solver.blocks.spare = spare_block<OverBlock>(solver.lanes.vertices);
    const auto levels = static_cast<std::size_t>(cloth.mesh.max_level());
    solver.blocks.parents.resize(levels);
    solver.lanes.limits.resize(levels);
    forget_triangles(solver);
    size_triangles(cloth);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) note_children(cloth, t);
    }
    make_stretch(cloth);
    make_bend(cloth);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) make_limits(cloth, level);
    list_centres(cloth);
    weigh_blocks(cloth);
}

void change_blocks(Cloth& cloth) {
    const LeafChanges& changes = cloth.mesh.changes();
    cloth.solver.lanes.inserted += changes.triangles_come.size();
    if (is_worn(cloth)) {
        make_blocks(cloth);
        return;
    }
    size_triangles(cloth);
    change_stretch(cloth, changes);
    change_bend(cloth, changes);
    change_limits(cloth, changes);
    list_centres(cloth);
    weigh_blocks(cloth);
}

}  // namespace selvedge
