#pragma once
// The constraints of one kind: blocks of sixteen for the SIMD kernels, their graph colouring, the blocks whose gains
// are out of date, and the slot of each triangle's constraint.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/cloth/solver_blocks.h"
#include "sim/core/assert.h"
#include "sim/core/blocks.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

// The blocks whose gains are out of date. After an adaptation these are only the blocks with a changed constraint or a
// changed vertex mass. Kernels take spans of blocks, so they are called for each run of consecutive dirty blocks.

class DirtyBlocks {
 public:
    void mark_slot(std::uint32_t slot) { mark_block(slot / kBlock); }
    void mark_block(std::size_t block) {
        if (block >= is_marked_.size()) is_marked_.resize(std::max(block + 1, 2 * is_marked_.size()), 0);
        if (is_marked_[block] != 0) return;
        is_marked_[block] = 1;
        marked_.push_back(static_cast<std::uint32_t>(block));
    }
    void mark_all(std::size_t blocks) {
        for (std::size_t block = 0; block < blocks; ++block) mark_block(block);
    }
    void clear() {
        for (const std::uint32_t block : marked_) is_marked_[block] = 0;
        marked_.clear();
    }

    // Calls visit(first, count) for each run, in ascending order. The blocks stay dirty until clear().
    template <class Visit>
    void for_runs(const Visit& visit) {
        std::sort(marked_.begin(), marked_.end());
        for (std::size_t i = 0; i < marked_.size();) {
            std::size_t count = 1;
            while (i + count < marked_.size() && marked_[i + count] == marked_[i] + count) ++count;
            visit(static_cast<std::size_t>(marked_[i]), count);
            i += count;
        }
    }

 private:
    std::vector<std::uint8_t> is_marked_;  // by block
    std::vector<std::uint32_t> marked_;
};

// Graph colouring: sorts constraints into blocks of sixteen that share no vertex, so that a block can be computed with
// SIMD instructions.

// Greedy: each constraint gets the first colour that none of its vertices has. add() and assign() colour all
// constraints at once; blocks of one colour are consecutive. Then insert() and remove() change single constraints: a
// new one gets a free slot in a block of its colour, or a new block at the end. Memory is reused.
class BlockColoring {
 public:
    // Where a constraint goes for which no colour is left: into a block of its own; or into a block with other such
    // constraints. These may share vertices, so they must be solved in turn, in the order of their slots, which is the
    // order of insert() as long as nothing is removed.
    enum class Colorless { Alone, InTurn };

    // Removes all constraints. Vertex indices must be below `vertices`.
    void start(std::size_t vertices, Colorless colorless = Colorless::Alone);

    // Adds a constraint; vertices: N indices.
    template <std::size_t N>
    void add(const std::array<std::uint32_t, N>& vertices) {
        colors_.push_back(color_for(vertices));
    }

    // The slot of each constraint, in the order of add(): number slot % kBlock in block slot / kBlock. Every colour
    // starts a new block. Colourless constraints that were added get a block each.
    const std::vector<std::uint32_t>& assign();
    std::size_t block_count() const { return block_colors_.size(); }  // after assign()

    // Call them after assign(). insert() returns a slot; it may increase block_count() by one.
    template <std::size_t N>
    std::uint32_t insert(const std::array<std::uint32_t, N>& vertices) {
        return take_slot(color_for(vertices));
    }
    // Pre: the constraint that has this slot has these vertices.
    template <std::size_t N>
    void remove(std::uint32_t slot, const std::array<std::uint32_t, N>& vertices) {
        const std::uint32_t color = block_colors_[slot / kBlock];
        if (color < kColors) {
            for (const std::uint32_t v : vertices) used_[v] &= ~(std::uint64_t{1} << color);
        }
        free_slots_[list_of(color)].push_back(slot);
    }

    // The colour of each block. Constraints of one colour share no vertex, even in different blocks; except that a
    // block in turn has a colour of its own.
    const std::vector<std::uint32_t>& colors() const { return block_colors_; }
    bool is_in_turn(std::size_t block) const {
        return colorless_ == Colorless::InTurn && block_colors_[block] >= kColors;
    }

    // Consecutive blocks of one colour.
    struct Run {
        std::size_t first, count;
    };
    // The runs of all blocks, in order.
    const std::vector<Run>& runs() const { return runs_; }

 private:
    // Number of shared colours: one bit each in used_. Blocks of constraints for which none is left have a colour of
    // their own, from kColors.
    static constexpr std::uint32_t kColors = 64;
    static constexpr std::size_t list_of(std::uint32_t color) { return color < kColors ? color : kColors; }

    template <std::size_t N>
    std::uint32_t color_for(const std::array<std::uint32_t, N>& vertices) {
        std::uint64_t used = 0;
        for (const std::uint32_t v : vertices) used |= used_[v];
        if (~used == 0) return kColors;
        const auto color = static_cast<std::uint32_t>(__builtin_ctzll(~used));
        for (const std::uint32_t v : vertices) used_[v] |= std::uint64_t{1} << color;
        return color;
    }
    std::uint32_t take_slot(std::uint32_t color);
    std::uint32_t next_in_turn();
    void add_block(std::uint32_t color);

    std::vector<std::uint64_t> used_;    // by vertex: one bit per colour in use there
    std::vector<std::uint32_t> colors_;  // by constraint, between start() and assign()
    std::vector<std::uint32_t> slots_;
    std::vector<std::uint32_t> block_colors_;
    std::array<std::vector<std::uint32_t>, kColors + 1> free_slots_{};  // by colour; the next to use is last
    std::vector<Run> runs_;
    std::uint32_t alone_ = 0;  // number of blocks without a shared colour
    Colorless colorless_ = Colorless::Alone;
    std::uint32_t next_in_turn_ = 0;  // the first slot of the last block in turn that was never used
};

// Each constraint belongs to a triangle and has a slot: number slot % kBlock in block slot / kBlock. It keeps its slot
// until it is removed. The cost of changes is proportional to their number. A free slot holds a dummy constraint, which
// refers only to the vertex `dummy_vertex`.
template <class Block, class Record>
class ConstraintSet {
 public:
    std::vector<Block> blocks;
    std::vector<Record> records;  // one per block: data for updating gains and biases, not read by the inner solve
    BlockColoring coloring;
    DirtyBlocks dirty;

    // Makes all constraints anew. id_of(item): the triangle; corners_of(item): the vertices of its constraint;
    // set(item, slot) fills the slot.
    template <class Items, class IdOf, class CornersOf, class Set>
    void make(const Items& items, std::size_t dummy_vertex, const IdOf& id_of, const CornersOf& corners_of,
              const Set& set) {
        coloring.start(dummy_vertex);
        for (const auto& item : items) coloring.add(corners_of(item));
        const std::vector<std::uint32_t>& slots = coloring.assign();
        blocks.assign(coloring.block_count(), dummy_block<Block>(dummy_vertex));
        records.assign(coloring.block_count(), dummy_record<Record>());
        slot_of_.clear();
        for (std::size_t i = 0; i < slots.size(); ++i) {
            set(items[i], slots[i]);
            note(id_of(items[i]), slots[i]);
        }
        dirty.clear();
        dirty.mark_all(blocks.size());
    }

    // set(slot) fills the slot. Pre: the triangle has no slot; make() was called, possibly without items.
    template <std::size_t N, class Set>
    void insert(TriangleId t, const std::array<std::uint32_t, N>& corners, std::size_t dummy_vertex, const Set& set) {
        SELVEDGE_ASSERT(slot_of(t) == kNoBlockSlot);
        const std::uint32_t slot = coloring.insert(corners);
        if (coloring.block_count() > blocks.size()) {
            append_block(blocks, dummy_block<Block>(dummy_vertex));
            append_block(records, dummy_record<Record>());
        }
        dirty.mark_slot(slot);
        set(slot);
        note(t, slot);
    }

    // Pre: the triangle has a slot.
    void remove(TriangleId t, std::size_t dummy_vertex) {
        const std::uint32_t slot = slot_of(t);
        SELVEDGE_ASSERT(slot != kNoBlockSlot);
        const std::size_t at = slot % kBlock;
        coloring.remove(slot, corners_at(blocks[slot / kBlock], at));
        dirty.mark_slot(slot);
        copy_slot(dummy_block<Block>(dummy_vertex), blocks[slot / kBlock], at);
        copy_slot(dummy_record<Record>(), records[slot / kBlock], at);
        slot_of_[t.value] = kNoBlockSlot;
    }

    // Forgets the slots of all triangles. Used before the constraints of all levels are made anew.
    void forget() { slot_of_.clear(); }

    // kNoBlockSlot: the triangle has no slot.
    std::uint32_t slot_of(TriangleId t) const { return t.value < slot_of_.size() ? slot_of_[t.value] : kNoBlockSlot; }

    // The same, but only if the slot was made for these corners; after a mesh change the id may belong to another
    // triangle.
    std::uint32_t slot_of(TriangleId t, const std::array<std::uint32_t, 3>& corners) const {
        const std::uint32_t slot = slot_of(t);
        if (slot == kNoBlockSlot) return kNoBlockSlot;
        for (std::size_t k = 0; k < 3; ++k) {
            if (blocks[slot / kBlock].vertices[k][slot % kBlock] != 4 * corners[k]) return kNoBlockSlot;
        }
        return slot;
    }

    // Calls visit(blocks, records) for each run of blocks of one colour.
    template <class Visit>
    void for_colors(const Visit& visit) {
        for (const auto& [first, count] : coloring.runs()) visit(blocks_at(first, count), records_at(first, count));
    }

    // Calls update(blocks, records), which computes gains, for each run of dirty blocks; then clears the dirty flags.
    template <class UpdateMasses>
    void update_dirty_masses(const UpdateMasses& update) {
        dirty.for_runs(
            [&](std::size_t first, std::size_t count) { update(blocks_at(first, count), records_at(first, count)); });
        dirty.clear();
    }

    std::span<Block> blocks_at(std::size_t first, std::size_t count) { return std::span(blocks).subspan(first, count); }
    std::span<Record> records_at(std::size_t first, std::size_t count) {
        return std::span(records).subspan(first, count);
    }

 private:
    void note(TriangleId t, std::uint32_t slot) {
        if (t.value >= slot_of_.size()) slot_of_.resize(t.value + 1, kNoBlockSlot);
        slot_of_[t.value] = slot;
    }
    std::vector<std::uint32_t> slot_of_;  // by TriangleId
};

}  // namespace selvedge::sim
