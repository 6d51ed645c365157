#pragma once
// A memory pool whose elements are addressed by typed 32-bit ids (thesis 3.5.1), and these id types. The pool grows by
// whole blocks and never moves an element. Freed ids are reused last-in first-out, so that splitting an edge again just
// after a rejoin returns the same ids. Memory is allocated only when the number of live elements exceeds its previous
// maximum.
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "sim/core/assert.h"

namespace selvedge::sim {

template <class T, class ElementId>
class Pool {
 public:
    static constexpr unsigned kBlockBits = 10;
    static constexpr std::size_t kBlockSize = std::size_t{1} << kBlockBits;

    // Reuses the id that was released last; new ids are taken in increasing order.
    ElementId create(const T& element) {
        const ElementId id = take<1>()[0];
        (*this)[id] = element;
        return id;
    }

    // Takes several ids at once, the last released first. The caller must overwrite the elements' old contents.
    template <std::size_t kCount>
    std::array<ElementId, kCount> take() {
        if (free_count_ < kCount) grow();
        std::array<ElementId, kCount> ids;
        for (std::size_t i = 0; i < kCount; ++i) ids[i] = free_[free_count_ - 1 - i];
        free_count_ -= kCount;
        return ids;
    }

    // Pre: id is alive. The element's contents are not cleared, which avoids a cache miss. Mesh checks detect stale
    // links as ids that are reachable and free.
    void release(ElementId id) {
        SELVEDGE_ASSERT(free_count_ < free_.size());
        free_[free_count_++] = id;
    }

    T& operator[](ElementId id) { return blocks_[id.value >> kBlockBits][id.value & (kBlockSize - 1)]; }
    const T& operator[](ElementId id) const { return blocks_[id.value >> kBlockBits][id.value & (kBlockSize - 1)]; }

    std::size_t size() const { return capacity() - free_count_; }                        // number of live elements
    std::size_t capacity() const { return blocks_.size() * kBlockSize; }                 // every id is below this
    std::span<const ElementId> free_ids() const { return {free_.data(), free_count_}; }  // the last is reused next

    // Memory per element, including its entry in the free list.
    static constexpr std::size_t kBytesPerElement = sizeof(T) + sizeof(ElementId);

 private:
    void grow() {
        const std::size_t first = capacity_;
        blocks_.emplace_back(kBlockSize);
        capacity_ = blocks_.size() * kBlockSize;
        free_.resize(capacity_);
        for (std::size_t i = capacity(); i > first; --i) {
            free_[free_count_++] = ElementId(static_cast<std::uint32_t>(i - 1));
        }
    }

    std::vector<std::vector<T>> blocks_;  // the inner vectors never grow
    std::vector<ElementId> free_;         // size: capacity; only the first free_count_ are free
    std::size_t free_count_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace selvedge::sim

// Typed 32-bit indices: the compiler rejects a VertexId where an EdgeId is expected. A default id is "none".

namespace selvedge::sim {

template <class Tag>
struct Id {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t value = kNone;

    constexpr Id() = default;
    constexpr explicit Id(std::uint32_t index) : value(index) {}
    constexpr explicit operator bool() const { return value != kNone; }
    constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using TriangleId = Id<struct TriangleTag>;

}  // namespace selvedge::sim

template <class Tag>
struct std::hash<selvedge::sim::Id<Tag>> {
    std::size_t operator()(selvedge::sim::Id<Tag> id) const noexcept { return id.value; }
};
