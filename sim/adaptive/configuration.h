#pragma once
// States, configurations and transitions of one triangle, derived at compile time from lists of the internal triangles
// of each configuration (configuration_tables.h).  (thesis 3.3, figs. 3.5, 3.7 and 3.8)
//
//            V2                 A triangle's points: its vertices V0 V1 V2 and the midpoints M0 M1 M2 of its external
//           /  \                edges E0 = V0V1, E1 = V1V2, E2 = V2V0. Its state S0..S7 is which external edges are
//      E2 M2    M1 E1           split; its configuration C0..C10 is one triangulation that conforms to them:
//         /      \              C0: nothing inside; C1..C3: one edge split; C4/C5, C6/C7, C8/C9: two edges split, with
//        /        \             one or the other diagonal of the remaining quad; C10: all three edges split, four
//       V0---M0---V1            regular children.
//            E0
#include <array>
#include <cstddef>
#include <cstdint>

namespace selvedge::sim {

enum class Configuration : std::uint8_t { C0, C1, C2, C3, C4, C5, C6, C7, C8, C9, C10 };

inline constexpr std::size_t kConfigurations = 11;
inline constexpr std::size_t kStates = 8;

constexpr std::size_t index_of(Configuration c) {
    return static_cast<std::size_t>(c);
}

// Bit k is set when the external edge Ek is split.
using SplitMask = std::uint8_t;

// Local points: 0 1 2 are V0 V1 V2, 3 4 5 are M0 M1 M2.
using LocalPoint = std::uint8_t;

// Local edges: 0 1 2 are E0 E1 E2; 3+2k is the child VkMk of Ek, 4+2k its child MkVk+1; 9 10 11 are the internal edges.
using LocalEdge = std::uint8_t;
inline constexpr LocalEdge kFirstInternalEdge = 9;
inline constexpr std::size_t kLocalEdges = 12;

inline constexpr std::uint8_t kNoSlot = 0xFF;

struct InternalTriangle {
    std::array<LocalPoint, 3> points{};  // anticlockwise, starting with the smallest
    std::array<LocalEdge, 3> edges{};    // edges[k] joins points[k] and points[k+1]
};

struct InternalEdge {
    std::array<LocalPoint, 2> points{};  // the smaller first
    constexpr bool operator==(const InternalEdge&) const = default;
};

// The internal triangles and edges of one configuration; slot i of the arrays is the thesis' ti or ei.
struct Layout {
    std::array<InternalTriangle, 4> triangles{};
    std::uint8_t triangle_count = 0;
    std::array<InternalEdge, 3> edges{};
    std::uint8_t edge_count = 0;
    SplitMask split = 0;
    std::array<std::uint8_t, 3> slot_at_unsplit{kNoSlot, kNoSlot, kNoSlot};  // the triangle that has Ek as a whole edge
    std::array<std::uint8_t, 3> slot_at_corner{kNoSlot, kNoSlot, kNoSlot};   // the first one anticlockwise round Vk
};

// A direct transition from one configuration to another. Elements that both share keep their ids. A new element reuses
// the id of a removed one while there are any left.  (thesis 3.3.4)
struct Transition {
    std::array<std::uint8_t, 4> triangle_from{kNoSlot, kNoSlot, kNoSlot, kNoSlot};  // by new slot: shared old slot
    std::array<std::uint8_t, 3> edge_from{kNoSlot, kNoSlot, kNoSlot};
    std::array<std::uint8_t, 4> triangle_over{kNoSlot, kNoSlot, kNoSlot, kNoSlot};  // by new slot: old slot, id reused
    std::array<std::uint8_t, 3> edge_over{kNoSlot, kNoSlot, kNoSlot};
    std::array<bool, 4> drops_triangle{};  // by old slot: not in the new configuration
    std::array<bool, 3> drops_edge{};
    int work = 0;  // number of triangles and edges that are in one of the two configurations only
};

const Layout& layout(Configuration c);
const Transition& transition(Configuration from, Configuration to);

// S0..S7 as 0..7: S1 S2 S3 have E0, E1, E2 split, S4 S5 S6 have E0E1, E1E2, E2E0.
std::size_t state_of(SplitMask split);
std::size_t state_of(Configuration c);

// The two configurations of a state with two split edges, each with the internal edge that only it has.
struct AmbiguousSplit {
    std::array<Configuration, 2> configurations;
    std::array<InternalEdge, 2> diagonals;  // from a vertex to the midpoint of the edge opposite
};

bool is_ambiguous(SplitMask split);
AmbiguousSplit ambiguous_split(SplitMask split);  // pre: is_ambiguous(split)

// The configuration that conforms to `split` with the least Transition::work from `from`; of two equal ones the first.
Configuration minimal_change(Configuration from, SplitMask split);

}  // namespace selvedge::sim
