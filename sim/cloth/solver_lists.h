#pragma once
// The constraints of a cloth: makes them from its leaves and refined triangles, updates them after an adaptation, and
// computes their gains (effective masses).
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/cloth/constraint_set.h"
#include "sim/cloth/curvature_map.h"
#include "sim/cloth/material_frame.h"
#include "sim/cloth/solver_blocks.h"

namespace selvedge::sim {

struct Cloth;

// The parent of a triangle: the refined triangle that contains it.
struct ParentOf {
    std::uint32_t offset = kNoOffset;  // offset in LevelStress
    float of_area = 1;                 // area of the triangle over that of the parent
};

// The constraints of the refined triangles of one level, and the centres of its split edges.
struct ParentLevel {
    ConstraintSet<LimitBlock, LimitRecord> limits;
    ConstraintSet<CoarseBendBlock, BendRecord> bend;
    std::vector<EdgeCentre> centres;  // only those that can move
    float interval = kNeverSolved;    // the minimum of BendBlock::interval over the level
};

// The constraints of a cloth.
struct Constraints {
    ConstraintSet<StretchBlock, StretchRecord> stretch;  // of leaves
    ConstraintSet<BendBlock, BendRecord> bend;           // of leaves
    std::vector<ParentLevel> parents;                    // by level, coarse to fine
    LevelStress stress;
    std::vector<std::uint32_t> triangle_of;  // by slot of stretch: the TriangleId, or kNoBlockSlot
    std::vector<float> thirds;               // by slot of stretch: a third of the leaf's mass, kg
};

// Scratch memory of triangle_bending.cpp, reused between calls.
struct FitScratch {
    std::vector<std::uint32_t> index_of;  // by TriangleId: index in `fits`; kNoBlockSlot: not made
    std::vector<TriangleId> made;
    std::vector<CurvatureFit> fits;
};
struct TouchedScratch {
    std::vector<TriangleId> moved, reshaped;
    std::vector<std::uint8_t> marks;  // by TriangleId
};

// Data for making constraints and their gains.
struct SolverLists {
    std::vector<ParentOf> parent_of;  // by TriangleId
    std::size_t vertices = 0;         // the dummy vertex' index; 0: no constraints were made yet
    std::size_t inserted = 0;         // number of leaves inserted since all constraints were made anew
    bool has_gathers = false;         // whether a seam gathers one of its sides
    // The masses that the gains were computed for. By vertex, including the dummy vertex: inverse masses, 1/kg. By
    // level and vertex: effective masses for the refined triangles of that level, kg, including all vertices that
    // follow.
    std::vector<float> inverse_masses;
    std::vector<std::vector<float>> masses;

    // Scratch. `over`: copies of the stretch constraints beyond the strain limit; those of a run of blocks start at the
    // index of its first block. `over_counts`: the number of blocks of such copies, by run.
    std::vector<OverBlock> over;
    std::vector<std::size_t> over_counts;
    OverBlock dummy{};  // a block of dummy constraints
    FitScratch fits;
    TouchedScratch touched;
    std::vector<std::uint32_t> idle_bends;  // slots
    std::vector<float> requested;           // by triangle id + 1: share of the rigidity passed up to it
    std::vector<float> bearable_shear;      // by triangle id + 1, see LimitRecord
    std::vector<std::vector<float>> masses_now;
    std::vector<double> mass_sums;
    std::vector<std::uint8_t> is_changed;  // by vertex
};

// Makes all blocks anew, reusing their memory. Pre: masses are those of the present leaves.
void make_blocks(Cloth& cloth);

// After an adaptation: removes and inserts constraints according to mesh.changes(). Makes all anew if the blocks have
// become fragmented or the vertex capacity has changed. Pre: masses are those of the present leaves; the blocks are
// those of the leaves before the adaptation.
void change_blocks(Cloth& cloth);

// Updates the parent of t's inner triangles after a transition of t, during an adaptation.
void note_children(Cloth& cloth, TriangleId t);

inline std::array<std::uint32_t, 3> indices(const std::array<VertexId, 3>& v) {
    return {v[0].value, v[1].value, v[2].value};
}

// Sets the corners and the warp and weft directions of a triangle, leaf or refined.
template <class Block>
void set_frame(Block& block, std::size_t at, const std::array<VertexId, 3>& v, const MaterialFrame& frame) {
    for (std::size_t i = 0; i < 3; ++i) block.vertices[i][at] = 4 * v[i].value;
    for (std::size_t i = 0; i < 2; ++i) {
        block.a[i][at] = frame.a[i];
        block.b[i][at] = frame.b[i];
    }
}

// Compliance of a triangle over a sub-step, 1/(kg m^2), for a stiffness in N/m: 1 / ((1 - kMomentum) stiffness area
// h^2), because the momentum of corrections provides the rest of the stiffness.  (Macklin et al. 2016)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness);

// Gains of the constraints, which convert an error into displacements of the vertices, from their inverse masses.
//
// The gains of a block depend only on its constraints and on the masses of its vertices, and an adaptation changes few
// of them. So gains are recomputed only for dirty blocks: those with an added or removed constraint, with a vertex
// whose mass differs from the one that the gains were computed for, or, for coarse bending, with another requested
// share of the rigidity. The result has the same bits as a complete recomputation.

// Updates the gains of dirty blocks and of blocks with changed masses. Pre: masses are those of the present leaves.
void update_effective_masses(Cloth& cloth);

}  // namespace selvedge::sim
