#pragma once
// Makes the constraints from the leaves of a cloth and from its hierarchy, and keeps them up to date. For gains see
// effective_masses.h.
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/cloth/constraint_set.h"
#include "sim/cloth/curvature_map.h"
#include "sim/cloth/solver_blocks.h"

namespace selvedge::sim {

struct Cloth;

// The refined triangle that another is inside of.
struct ParentOf {
    std::uint32_t place = kNoPlace;  // in RestrictedStress
    float of_area = 1;               // share of the parent's area
};

// The refined triangles of one level, and the centres of its split edges.
struct ParentLevel {
    ConstraintSet<LimitBlock, LimitRecord> limits;
    ConstraintSet<CoarseBendBlock, BendRecord> bend;
    std::vector<EdgeCentre> centres;  // that may move
    float interval = kNeverVisited;   // sub-steps from one visit of its bending to the next: the shortest of all
};

// The constraints of a cloth.
struct Constraints {
    ConstraintSet<StretchBlock, StretchRecord> stretch;  // of leaves
    ConstraintSet<BendBlock, BendRecord> bend;           // of leaves
    std::vector<ParentLevel> parents;                    // coarse to fine
    RestrictedStress carried;
    std::vector<std::uint32_t> triangle_of;  // by slot of stretch: the TriangleId, or kSpare
    std::vector<float> thirds;               // by slot of stretch: a third of the leaf's mass, kg
};

// Scratch of triangle_bending.cpp, in the memory of the last time.
struct FitScratch {
    std::vector<std::uint32_t> place_of;  // by TriangleId, in `fits`; kSpare: not made
    std::vector<TriangleId> made;
    std::vector<CurvatureFit> fits;
};
struct TouchedScratch {
    std::vector<TriangleId> moved, reshaped;
    std::vector<std::uint8_t> marks;  // by TriangleId
};

// What making and weighing constraints needs besides.
struct SolverLists {
    std::vector<ParentOf> parent_of;  // by TriangleId
    std::size_t vertices = 0;         // the spare point's index; 0: none were made yet
    std::size_t inserted = 0;         // leaves since all were made anew
    bool has_gathers = false;         // a seam that gathers one of its sides
    // Masses by vertex, and of the spare point, that the gains were made for: 1/kg; and by level, kg, each with all
    // that follows it where a refined triangle of that level moves it.
    std::vector<float> inverse_masses;
    std::vector<std::vector<float>> masses;

    // Scratch. What one pass over stretch found, from the first of the blocks that it looked at on; and how many blocks
    // of it there are, by run of blocks.
    std::vector<OverBlock> over;
    std::vector<std::size_t> over_counts;
    OverBlock spare{};  // of spare slots
    FitScratch fits;
    TouchedScratch touched;
    std::vector<std::uint32_t> idle_bends;  // slots
    std::vector<float> asked;               // as places: share of the rigidity that was handed up
    std::vector<float> easy_shear;          // as places, see LimitRecord
    std::vector<std::vector<float>> masses_now;
    std::vector<double> mass_sums;
    std::vector<std::uint8_t> is_changed;  // by vertex
};

// Makes all blocks anew, in the memory that they have. Pre: masses are those of the present leaves.
void make_blocks(Cloth& cloth);

// After an adaptation: the slots of what went, by mesh.changes(), are given to what came. Makes all anew where that
// is more expensive, or where the blocks were made for fewer vertices. Pre: masses are those of the present leaves; the
// blocks were those of the leaves before.
void change_blocks(Cloth& cloth);

// While an adaptation is under way: t has other triangles inside.
void note_children(Cloth& cloth, TriangleId t);

inline std::array<std::uint32_t, 3> indices(const std::array<VertexId, 3>& v) {
    return {v[0].value, v[1].value, v[2].value};
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

// 1/(kg m^2), over a sub-step, of a triangle of that stiffness, N/m, of which momentum makes a share.  (Macklin et
// al. 2016)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness);

// The blocks of refined triangles, a part of solver_lists.h: one-sided limits with what they carry.

struct Cloth;
struct Kernels;

void make_limits(Cloth& cloth, int level);
void change_limits(Cloth& cloth, const LeafChanges& changes);

// The centres of split edges that may move, level by level.
void list_centres(Cloth& cloth);

// What the corners of refined triangles weigh now, level by level. Pre: centres are listed.
void list_limit_masses(Cloth& cloth);

// Gains of dirty blocks, from the masses and from what the leaves' blocks have got as theirs.
void update_limit_masses(Cloth& cloth, const Kernels& loops);

// Gains of the solver's blocks: what a constraint moves its vertices by, from their inverse masses.
//
// A block's gains depend on its constraints and on the masses of its vertices alone, and an adaptation changes few of
// either. So the masses are compared with those that the gains were made for, and only the blocks round a vertex whose
// mass changed, in which a constraint was added or removed, or, of coarse bending, that are asked for another share,
// get theirs anew: the same bits as all anew.

struct Cloth;

// Of the blocks that are marked as dirty and of those round changed masses. Pre: masses are those of the present
// leaves.
void update_effective_masses(Cloth& cloth);

}  // namespace selvedge::sim
