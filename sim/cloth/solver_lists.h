#pragma once
// Makes the solver's blocks from the leaves of a cloth and from its hierarchy, and keeps them up to date: each
// constraint has a lane, and leaves it when it goes, at a cost in proportion to what an adaption changed. For gains see
// effective_masses.h.
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/cloth/coloring.h"
#include "sim/cloth/dirty_blocks.h"
#include "sim/cloth/solver_blocks.h"

namespace selvedge {

struct Cloth;

// The refined triangle that another is inside of.
struct ParentOf {
    std::uint32_t place = kNoPlace;  // in CarriedStress
    float of_area = 1;               // share of the parent's area
};

// Where the constraints of a cloth stand in its blocks. kSpare: it has none.
struct SolverLanes {
    BlockColoring stretch, bend;
    std::vector<BlockColoring> limits;      // by level
    std::vector<std::uint32_t> stretch_of;  // by TriangleId, of leaves
    std::vector<std::uint32_t> bend_of;     // by EdgeId
    std::vector<std::uint32_t> limit_of;    // by TriangleId, of refined triangles
    std::vector<std::uint8_t> limit_level;  // by TriangleId: in whose blocks
    std::vector<ParentOf> parent_of;        // by TriangleId
    std::size_t vertices = 0;               // the spare point's index; 0: none were made yet
    std::size_t inserted = 0;               // leaves since all were made anew
    struct HeldHinge {
        std::uint32_t lane;
        float held;  // of its friction, -1 to 1
    };
    std::vector<HeldHinge> held;    // scratch: whose anchors wait for the hinges to be weighed
    std::vector<float> easy_shear;  // scratch, as places, see LimitRecord
    DirtyBlocks dirty_stretch, dirty_bend;
    std::vector<DirtyBlocks> dirty_limits;   // by level
    std::vector<std::uint8_t> short_hinges;  // by block, see count_short_hinges
    std::size_t short_hinge_count = 0;
    // Masses by vertex, and of the spare point, that the gains were made for: 1/kg; and by level, kg, each with all
    // that follows it where a refined triangle of that level moves it.
    std::vector<float> inverse_masses;
    std::vector<std::vector<float>> masses;
    std::vector<std::vector<float>> masses_now;  // scratch
    std::vector<double> mass_sums;               // scratch
    std::vector<std::uint8_t> is_changed;        // scratch, by vertex
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

// The lane of an edge's hinge if it has one that was made for these ends, else kSpare.
std::uint32_t bend_lane(const Cloth& cloth, EdgeId e);

}  // namespace selvedge
