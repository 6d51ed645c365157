#pragma once
// Makes the solver's blocks from the leaves of a cloth and from its hierarchy, and keeps them up to date: each
// constraint has a lane, and leaves it when it goes, at a cost in proportion to what an adaption changed. For gains see
// effective_masses.h.
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/cloth/coloring.h"
#include "sim/cloth/curvature_map.h"
#include "sim/cloth/dirty_blocks.h"
#include "sim/cloth/solver_blocks.h"

namespace selvedge {

struct Cloth;

// The refined triangle that another is inside of.
struct ParentOf {
    std::uint32_t place = kNoPlace;  // in CarriedStress
    float of_area = 1;               // share of the parent's area
};

inline constexpr std::uint8_t kLeafList = 0xFF;

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

// Where the constraints of a cloth stand in its blocks. kSpare: it has none.
struct SolverLanes {
    BlockColoring stretch, bend;
    std::vector<BlockColoring> coarse_bend;  // by level
    std::vector<BlockColoring> limits;       // by level
    std::vector<std::uint32_t> stretch_of;   // by TriangleId, of leaves
    std::vector<std::uint32_t> bend_of;      // by TriangleId, of leaves and refined triangles
    std::vector<std::uint8_t> bend_list;     // by TriangleId: in whose blocks, by level, or kLeafList
    std::vector<std::uint32_t> limit_of;     // by TriangleId, of refined triangles
    std::vector<std::uint8_t> limit_level;   // by TriangleId: in whose blocks
    std::vector<ParentOf> parent_of;         // by TriangleId
    std::size_t vertices = 0;                // the spare point's index; 0: none were made yet
    std::size_t inserted = 0;                // leaves since all were made anew
    DirtyBlocks dirty_stretch, dirty_bend;
    std::vector<DirtyBlocks> dirty_limits, dirty_coarse_bend;  // by level
    // Masses by vertex, and of the spare point, that the gains were made for: 1/kg; and by level, kg, each with all
    // that follows it where a refined triangle of that level moves it.
    std::vector<float> inverse_masses;
    std::vector<std::vector<float>> masses;

    // Scratch.
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

// After an adaption: the lanes of what went, by mesh.changes(), are given to what came. Makes all anew where that is
// dearer, or where the blocks were made for fewer vertices. Pre: masses are those of the present leaves; the blocks
// were those of the leaves before.
void change_blocks(Cloth& cloth);

// While an adaption is under way: t has other triangles inside.
void note_children(Cloth& cloth, TriangleId t);

// The lane of a refined triangle if it has one that was made for its corners, else kSpare.
std::uint32_t limit_lane(const Cloth& cloth, TriangleId t);

// The same of a leaf.
std::uint32_t stretch_lane(const Cloth& cloth, TriangleId t);

}  // namespace selvedge
