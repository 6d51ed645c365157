#pragma once
// Pairs of mesh elements that can touch: a vertex and a triangle, or two edges. Each pair has two sides of one to three
// vertices; the contact normal points from the second side to the first.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/blocks.h"

namespace selvedge::sim {

enum class PairKind { VertexTriangle, EdgeEdge };

// Number of vertices on the first side; the others are on the second.
constexpr std::size_t first_side(PairKind kind) {
    return kind == PairKind::VertexTriangle ? 1 : 2;
}

// Two triangles of a surface.
struct TrianglePair {
    std::uint32_t first = 0, second = 0;
};

// Sixteen pairs of one kind. A free slot refers to the dummy vertex and has a radius of -1,000 km.
struct alignas(64) PairBlock {
    std::array<BlockPoints, 4> vertices{};   // first side, then second side
    std::array<BlockPoints, 2> triangles{};  // which own the sides, or are them
    BlockFloats radius{};                    // m, distance to keep between the sides
    BlockFloats friction{};
    std::array<BlockFloats, 3> divider{};  // unit normal of the dividing plane, found by the last detection
    BlockFloats gap{};                     // m, distance of the sides at that time
    std::array<BlockFloats, 4> weight{};   // of the vertices in the vector between the closest points; signed
    std::array<BlockFloats, 3> normal{};   // unit contact normal, found by the last refresh
    BlockFloats side{};                    // 1; -1 if the sides must be swapped; 0 if unknown, then without contact
};

// An array of blocks, filled from the front.
class PairList {
 public:
    explicit PairList(PairKind kind) : kind_(kind) {}

    PairKind kind() const { return kind_; }
    std::size_t size() const { return size_; }
    std::size_t block_count() const { return (size_ + kBlock - 1) / kBlock; }
    std::vector<PairBlock>& blocks() { return blocks_; }
    const std::vector<PairBlock>& blocks() const { return blocks_; }

    // Pre: no pairs are added for vertices beyond `dummy`, the index of the dummy vertex.
    void clear(std::uint32_t dummy) {
        size_ = 0;
        dummy_ = dummy;
    }
    // Adds a pair with these vertices (offsets), and no more than its radius and friction filled in.
    void add(const std::array<std::uint32_t, 4>& offsets, TrianglePair of, float radius, float friction) {
        PairBlock& block = open_slot();
        const std::size_t at = size_++ % kBlock;
        for (std::size_t k = 0; k < 4; ++k) block.vertices[k][at] = offsets[k];
        block.triangles[0][at] = of.first;
        block.triangles[1][at] = of.second;
        block.radius[at] = radius;
        block.friction[at] = friction;
        block.side[at] = 1;
    }
    // Adds a copy of the pair in slot `at` of a block of another list.
    void add(const PairBlock& from, std::size_t at);

    // Removes these pairs (ascending) and moves the last ones to their places.
    void remove(std::span<const std::size_t> pairs);

 private:
    PairBlock& open_slot();
    void free_slot(std::size_t pair);

    PairKind kind_;
    std::size_t size_ = 0;
    std::uint32_t dummy_ = 0;
    std::vector<PairBlock> blocks_;
};

// Sixteen contacts that sub-steps solve: pairs with their planes, which stay the same until the next refresh. A free
// slot has weights of 0 and a radius of -1,000 km, so it never acts.
struct alignas(64) SelfContactBlock {
    std::array<BlockPoints, 4> vertices{};
    std::array<BlockFloats, 4> weight{};
    std::array<BlockFloats, 3> normal{};  // unit
    BlockFloats radius{};                 // m
    BlockFloats inverse{};                // 1 / sum of weight^2 times inverse mass, kg
    BlockFloats friction{};
    BlockFloats longest_push{};  // m per sub-step, see SelfContactKernels
};

// One of them.
struct SelfContactPlane {
    std::array<std::uint32_t, 4> vertices{};
    std::array<float, 4> weight{};
    std::array<float, 3> normal{};
    float radius = 0, inverse = 0, friction = 0, longest_push = 0;
};

// An array of blocks, filled from the front.
class SelfContactList {
 public:
    std::size_t size() const { return size_; }
    std::span<const SelfContactBlock> blocks() const { return {blocks_.data(), (size_ + kBlock - 1) / kBlock}; }
    void clear() { size_ = 0; }
    void add(const SelfContactPlane& contact);

 private:
    std::size_t size_ = 0;
    std::vector<SelfContactBlock> blocks_;
};

}  // namespace selvedge::sim
