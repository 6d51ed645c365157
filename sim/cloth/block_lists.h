#pragma once
// Blocks of one kind with their records and colours, as they are made and kept: see solver_lists.h.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/adaptive/leaf_lists.h"
#include "sim/cloth/block_lanes.h"
#include "sim/cloth/coloring.h"
#include "sim/cloth/dirty_blocks.h"
#include "sim/cloth/material_frame.h"

namespace selvedge {

struct Cloth;

inline std::array<std::uint32_t, 3> indices(const std::array<VertexId, 3>& v) {
    return {v[0].value, v[1].value, v[2].value};
}

// Blocks of one kind with their records and colours.
template <class Block, class Record>
struct BlockLists {
    std::vector<Block>& blocks;
    std::vector<Record>& records;
    BlockColoring& coloring;
    DirtyBlocks& dirty;

    // Anew, for all of these: corners_of(item) are the vertices of a constraint, set(item, lane) puts it into its lane.
    template <class Items, class CornersOf, class Set>
    void make(const Items& items, std::size_t vertices, const CornersOf& corners_of, const Set& set) {
        coloring.start(vertices);
        for (const auto& item : items) coloring.add(corners_of(item));
        const std::vector<std::uint32_t>& lanes = coloring.assign();
        blocks.assign(coloring.block_count(), spare_block<Block>(vertices));
        records.assign(coloring.block_count(), spare_record<Record>());
        for (std::size_t i = 0; i < lanes.size(); ++i) set(items[i], lanes[i]);
        dirty.clear();
        dirty.mark_all(blocks.size());
    }
    template <std::size_t N>
    std::uint32_t take(const std::array<std::uint32_t, N>& corners, std::size_t vertices) {
        const std::uint32_t lane = coloring.insert(corners);
        if (coloring.block_count() > blocks.size()) {
            blocks.push_back(spare_block<Block>(vertices));
            records.push_back(spare_record<Record>());
        }
        dirty.mark_slot(lane);
        return lane;
    }
    // Post: the lane is kSpare.
    void give_back(std::uint32_t& lane, std::size_t vertices) {
        Block& block = blocks[lane / kBlock];
        const std::size_t at = lane % kBlock;
        coloring.remove(lane, corners_at(block, at));
        dirty.mark_slot(lane);
        copy_lane(spare_block<Block>(vertices), block, at);
        copy_lane(spare_record<Record>(), records[lane / kBlock], at);
        lane = kSpare;
    }
};

// The corners and directions of a triangle, a leaf or a parent.
template <class Block>
void set_frame(Block& block, std::size_t at, const std::array<VertexId, 3>& v, const MaterialFrame& frame) {
    for (std::size_t i = 0; i < 3; ++i) block.vertices[i][at] = 4 * v[i].value;
    for (std::size_t i = 0; i < 2; ++i) {
        block.a[i][at] = frame.a[i];
        block.b[i][at] = frame.b[i];
    }
}

// Over a sub-step, of a triangle of that stiffness, N/m.  (XPBD)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness);

}  // namespace selvedge
