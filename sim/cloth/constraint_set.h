#pragma once
// The constraints of one kind: blocks for the kernels, colours, which blocks wait for their gains, and where the
// constraint of a triangle stands.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/cloth/block_lanes.h"
#include "sim/cloth/coloring.h"
#include "sim/cloth/dirty_blocks.h"
#include "sim/core/assert.h"
#include "sim/core/ids.h"

namespace selvedge {

// Each constraint has a slot: lane slot % kBlock of block slot / kBlock. It belongs to a triangle, and keeps its slot
// until it is removed, at a cost in proportion to what comes and goes. A slot that is free is a spare one: it moves the
// spare point alone.
template <class Block, class Record>
class ConstraintSet {
 public:
    std::vector<Block> blocks;
    std::vector<Record> records;  // block by block: what weighing and learning need besides
    BlockColoring coloring;
    DirtyBlocks dirty;

    // All anew. id_of(item): the triangle; corners_of(item): the vertices of its constraint; set(item, slot) fills the
    // slot.
    template <class Items, class IdOf, class CornersOf, class Set>
    void make(const Items& items, std::size_t spare_point, const IdOf& id_of, const CornersOf& corners_of,
              const Set& set) {
        coloring.start(spare_point);
        for (const auto& item : items) coloring.add(corners_of(item));
        const std::vector<std::uint32_t>& slots = coloring.assign();
        blocks.assign(coloring.block_count(), spare_block<Block>(spare_point));
        records.assign(coloring.block_count(), spare_record<Record>());
        slot_of_.clear();
        for (std::size_t i = 0; i < slots.size(); ++i) {
            set(items[i], slots[i]);
            note(id_of(items[i]), slots[i]);
        }
        dirty.clear();
        dirty.mark_all(blocks.size());
    }

    // set(slot) fills the slot. Pre: the triangle has none; make() was called, with or without items.
    template <std::size_t N, class Set>
    void insert(TriangleId t, const std::array<std::uint32_t, N>& corners, std::size_t spare_point, const Set& set) {
        SELVEDGE_ASSERT(slot_of(t) == kSpare);
        const std::uint32_t slot = coloring.insert(corners);
        if (coloring.block_count() > blocks.size()) {
            blocks.push_back(spare_block<Block>(spare_point));
            records.push_back(spare_record<Record>());
        }
        dirty.mark_slot(slot);
        set(slot);
        note(t, slot);
    }

    // Pre: it has one.
    void remove(TriangleId t, std::size_t spare_point) {
        const std::uint32_t slot = slot_of(t);
        SELVEDGE_ASSERT(slot != kSpare);
        const std::size_t at = slot % kBlock;
        coloring.remove(slot, corners_at(blocks[slot / kBlock], at));
        dirty.mark_slot(slot);
        copy_lane(spare_block<Block>(spare_point), blocks[slot / kBlock], at);
        copy_lane(spare_record<Record>(), records[slot / kBlock], at);
        slot_of_[t.value] = kSpare;
    }

    // While all are made anew, level by level: no triangle has a slot.
    void forget() { slot_of_.clear(); }

    // kSpare: it has none.
    std::uint32_t slot_of(TriangleId t) const { return t.value < slot_of_.size() ? slot_of_[t.value] : kSpare; }

    // The same if it was made for these corners: while the mesh changes, an id may be another triangle's by now.
    std::uint32_t slot_of(TriangleId t, const std::array<std::uint32_t, 3>& corners) const {
        const std::uint32_t slot = slot_of(t);
        if (slot == kSpare) return kSpare;
        for (std::size_t k = 0; k < 3; ++k) {
            if (blocks[slot / kBlock].vertices[k][slot % kBlock] != 4 * corners[k]) return kSpare;
        }
        return slot;
    }

    // Colour by colour: visit(blocks, records).
    template <class Visit>
    void for_colors(const Visit& visit) {
        for (const auto& [first, count] : coloring.runs()) visit(blocks_at(first, count), records_at(first, count));
    }

    // weigh(blocks, records) makes the gains of those that wait for them.
    template <class Weigh>
    void weigh_dirty(const Weigh& weigh) {
        dirty.for_runs(
            [&](std::size_t first, std::size_t count) { weigh(blocks_at(first, count), records_at(first, count)); });
        dirty.clear();
    }

    std::span<Block> blocks_at(std::size_t first, std::size_t count) { return std::span(blocks).subspan(first, count); }
    std::span<Record> records_at(std::size_t first, std::size_t count) {
        return std::span(records).subspan(first, count);
    }

 private:
    void note(TriangleId t, std::uint32_t slot) {
        if (t.value >= slot_of_.size()) slot_of_.resize(t.value + 1, kSpare);
        slot_of_[t.value] = slot;
    }
    std::vector<std::uint32_t> slot_of_;  // by TriangleId
};

}  // namespace selvedge
