#include "sim/cloth/solver_lists.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/cloth/cloth.h"
#include "sim/cloth/material_frame.h"

namespace selvedge {
namespace {

using Weights = std::array<float, 3>;

// What a spare lane stands on: a point of its own behind those of the mesh, which cannot move.
std::uint32_t spare_offset(const Cloth& cloth) {
    return static_cast<std::uint32_t>(4 * cloth.mesh.vertex_capacity());
}

template <class Block>
void clear_blocks(std::vector<Block>& blocks, std::size_t count, std::uint32_t spare) {
    Block empty{};
    for (BlockPoints& points : empty.vertices) points.fill(spare);
    blocks.assign(count, empty);
}

// Sum of w grad^2 of a direction with the gradients -(g0 + g1), g0, g1.
float weighed(const std::array<float, 2>& g, const Weights& w) {
    return w[0] * (g[0] + g[1]) * (g[0] + g[1]) + w[1] * g[0] * g[0] + w[2] * g[1] * g[1];
}

float weighed_cross(const MaterialFrame& f, const Weights& w) {
    return w[0] * (f.a[0] + f.a[1]) * (f.b[0] + f.b[1]) + w[1] * f.a[0] * f.b[0] + w[2] * f.a[1] * f.b[1];
}

// Over a sub-step, of a triangle of that stiffness.  (XPBD)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness) {
    return 1 / (frame.area * cloth.substep * cloth.substep) / static_cast<float>(stiffness);
}

// Whether a seam edge of the triangle has to be shorter than the triangle's own copy of it: there the cloth is
// gathered, in puckers finer than the mesh.  (SPEC 3.2)
bool is_gathered(const AdaptiveMesh& mesh, const LeafTriangle& leaf) {
    constexpr float kEase = 0.95F;
    const AdaptiveTriangle& triangle = mesh.triangle(leaf.triangle);
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

struct StretchLane {
    StretchBlock& block;
    StretchRecord& record;
    std::size_t at;

    // Pre: two vertices at least can move.
    void set_gains(const MaterialFrame& frame, const Weights& w, const std::array<float, 3>& compliance) {
        const float of_warp = weighed(frame.a, w);
        const float of_weft = weighed(frame.b, w);
        const float cross = weighed_cross(frame, w);
        const float warp = 1 / (of_warp + compliance[0]);
        const float weft = 1 / (of_weft + compliance[1]);
        block.warp[at] = warp;
        block.weft[at] = weft;
        block.cross[at] = cross;
        block.shear[at] = 1 / (of_warp + of_weft + compliance[2] - cross * cross * (warp + weft));
        for (std::size_t k = 0; k < 3; ++k) record.compliance[k][at] = compliance[k];
    }
};

void make_stretch(const Cloth& cloth, SolverBlocks& blocks, BlockColoring& coloring) {
    coloring.start(cloth.mesh.vertex_capacity());
    const std::span<const LeafTriangle> leaves = cloth.mesh.leaf_triangles();
    for (const LeafTriangle& leaf : leaves) coloring.add<3>({leaf.v[0].value, leaf.v[1].value, leaf.v[2].value});
    const std::vector<std::uint32_t>& lanes = coloring.assign();
    clear_blocks(blocks.stretch, coloring.block_count(), spare_offset(cloth));
    blocks.over.resize(coloring.block_count());
    for (StretchBlock& block : blocks.stretch) block.longest.fill(std::numeric_limits<float>::max());
    blocks.records.assign(coloring.block_count(), {});
    blocks.leaf_of.assign(coloring.block_count() * kBlock, kSpare);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const LeafTriangle& leaf = leaves[i];
        const Fabric& fabric = cloth.fabrics[leaf.panel];
        const MaterialFrame frame = material_frame(leaf.u, cloth.grain_angles[leaf.panel]);
        StretchLane lane{blocks.stretch[lanes[i] / kBlock], blocks.records[lanes[i] / kBlock], lanes[i] % kBlock};
        Weights w{};
        for (std::size_t k = 0; k < 3; ++k) w[k] = cloth.inverse_mass[leaf.v[k].value];
        set_frame(lane.block, lane.at, leaf.v, frame);
        lane.set_gains(frame, w,
                       {compliance_of(cloth, frame, fabric.stretch_warp),
                        compliance_of(cloth, frame, fabric.stretch_weft), compliance_of(cloth, frame, fabric.shear)});
        lane.block.longest[lane.at] = 1 + static_cast<float>(fabric.strain_limit);
        lane.block.push[lane.at] = is_gathered(cloth.mesh, leaf) ? 0.0F : 1.0F;
        const Vec3f& bias = cloth.bias[leaf.triangle.value].value;
        for (int k = 0; k < 3; ++k) lane.block.bias[static_cast<std::size_t>(k)][lane.at] = bias[k];
        blocks.leaf_of[lanes[i]] = static_cast<std::uint32_t>(i);
    }
}

// A refined triangle lets its threads grow by what the fabric gives under the load that garments usually carry.
float longest_of(double stiffness, const Fabric& fabric) {
    constexpr double kUsualLoad = 2.5;  // N/m: a shirt hangs from its shoulders with some 1.6
    constexpr double kLeast = 0.002;    // so that the leaves carry what they can by themselves
    return 1 + static_cast<float>(std::min(fabric.strain_limit, std::max(kLeast, kUsualLoad / stiffness)));
}

// Half of an excess is taken back per level: what is left the levels below see.
void set_limit(const Cloth& cloth, const AdaptiveTriangle& triangle, const std::vector<float>& masses,
               LimitBlock& block, std::size_t at) {
    constexpr float kRelaxation = 0.5F;
    const Fabric& fabric = cloth.fabrics[triangle.panel];
    const MaterialFrame frame = material_frame(triangle.u, cloth.grain_angles[triangle.panel]);
    Weights w{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = triangle.vertices[i].value;
        w[i] = cloth.inverse_mass[v] > 0 ? 1 / masses[v] : 0.0F;
    }
    set_frame(block, at, triangle.vertices, frame);
    block.longest_warp[at] = longest_of(fabric.stretch_warp, fabric);
    block.longest_weft[at] = longest_of(fabric.stretch_weft, fabric);
    const float warp = kRelaxation / (weighed(frame.a, w) + compliance_of(cloth, frame, fabric.stretch_warp));
    const float weft = kRelaxation / (weighed(frame.b, w) + compliance_of(cloth, frame, fabric.stretch_weft));
    const std::array<float, 3> grad_a{-(frame.a[0] + frame.a[1]), frame.a[0], frame.a[1]};
    const std::array<float, 3> grad_b{-(frame.b[0] + frame.b[1]), frame.b[0], frame.b[1]};
    for (std::size_t i = 0; i < 3; ++i) {
        block.warp[i][at] = w[i] * grad_a[i] * warp;
        block.weft[i][at] = w[i] * grad_b[i] * weft;
    }
}

void make_limits(const Cloth& cloth, int level, const std::vector<float>& masses, ParentLevel& parents,
                 BlockColoring& coloring) {
    const std::span<const TriangleId> refined = cloth.mesh.refined_triangles(level);
    coloring.start(cloth.mesh.vertex_capacity());
    for (const TriangleId t : refined) {
        const std::array<VertexId, 3>& v = cloth.mesh.triangle(t).vertices;
        coloring.add<3>({v[0].value, v[1].value, v[2].value});
    }
    const std::vector<std::uint32_t>& lanes = coloring.assign();
    clear_blocks(parents.triangles, coloring.block_count(), spare_offset(cloth));
    for (LimitBlock& block : parents.triangles) {
        block.longest_warp.fill(1);
        block.longest_weft.fill(1);
    }
    for (std::size_t i = 0; i < refined.size(); ++i) {
        set_limit(cloth, cloth.mesh.triangle(refined[i]), masses, parents.triangles[lanes[i] / kBlock],
                  lanes[i] % kBlock);
    }
}

// A refined triangle moves the cloth about its vertices with it. So a vertex weighs as much there as all that follows
// it: its own mass, and half of that of each centre between it and another. Then no correction changes the momentum.
void make_parents(const Cloth& cloth, SolverBlocks& blocks, SolverScratch& scratch) {
    std::vector<float>& masses = scratch.masses;
    masses.resize(cloth.inverse_mass.size());
    for (std::size_t v = 0; v < masses.size(); ++v) {
        masses[v] = cloth.inverse_mass[v] > 0 ? 1 / cloth.inverse_mass[v] : 0.0F;
    }
    blocks.parents.resize(static_cast<std::size_t>(cloth.mesh.max_level()));
    for (int level = cloth.mesh.max_level() - 1; level >= 0; --level) {
        ParentLevel& parents = blocks.parents[static_cast<std::size_t>(level)];
        parents.centres.clear();
        for (const EdgeId e : cloth.mesh.split_edges(level)) {
            const std::uint32_t a = cloth.mesh.end(e, 0).value;
            const std::uint32_t b = cloth.mesh.end(e, 1).value;
            const std::uint32_t c = cloth.mesh.centre(e).value;
            masses[a] += 0.5F * masses[c];
            masses[b] += 0.5F * masses[c];
            if (cloth.inverse_mass[c] > 0) parents.centres.push_back({4 * a, 4 * b, 4 * c});
        }
        make_limits(cloth, level, masses, parents, scratch.coloring);
    }
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

// Energy 1/2 B / (A_left + A_right) |sum q x|^2, of a hinge that is visited every `interval` sub-steps: what it
// does lasts that long, so the move that it makes at once counts as often. Hinges that share vertices take half of each
// other's corrections away on an average, and what a visit takes too little adds to the compliance: where the fabric's
// is larger, it is made smaller by as much.
void set_bend(const Cloth& cloth, const Hinge& hinge, int interval, BendBlock& block, std::size_t at) {
    const std::array<std::uint32_t, 4> vertices{hinge.a.value, hinge.b.value, hinge.left.value, hinge.right.value};
    const std::array<float, 4> q = hinge_weights(hinge);
    const float area = 0.5F * hinge.rest_length * (hinge.left_at.y() - hinge.right_at.y());
    const AdaptiveEdge& edge = cloth.mesh.edge(hinge.edge);
    float rigidity = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint16_t panel = cloth.mesh.triangle(edge.sides[side]).panel;
        rigidity += 0.5F * hinge_rigidity(cloth.fabrics[panel], hinge.along[side], cloth.grain_angles[panel]);
    }
    float sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        sum += cloth.inverse_mass[vertices[i]] * q[i] * q[i];
        block.vertices[i][at] = 4 * vertices[i];
        block.q[i][at] = q[i];
    }
    const float visits = static_cast<float>(interval);
    const float compliance = area / (rigidity * cloth.substep * cloth.substep * visits);
    const float seen = sum * visits * (interval > 2 ? 2.0F : 1.0F);
    block.gain[at] = 1 / (seen + std::max(0.0F, compliance - (seen - 0.5F * sum)));
}

void make_bend(const Cloth& cloth, SolverBlocks& blocks, BlockColoring& coloring) {
    coloring.start(cloth.mesh.vertex_capacity());
    const std::span<const Hinge> hinges = cloth.mesh.hinges();
    for (const Hinge& h : hinges) coloring.add<4>({h.a.value, h.b.value, h.left.value, h.right.value});
    const std::vector<std::uint32_t>& lanes = coloring.assign();
    clear_blocks(blocks.bend, coloring.block_count(), spare_offset(cloth));
    for (std::size_t i = 0; i < hinges.size(); ++i) {
        set_bend(cloth, hinges[i], cloth.bend_interval, blocks.bend[lanes[i] / kBlock], lanes[i] % kBlock);
    }
}

}  // namespace

void make_blocks(const Cloth& cloth, SolverBlocks& blocks, SolverScratch& scratch) {
    make_stretch(cloth, blocks, scratch.coloring);
    make_parents(cloth, blocks, scratch);
    make_bend(cloth, blocks, scratch.coloring);
}

}  // namespace selvedge
