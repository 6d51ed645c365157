#pragma once
// Elements addressed by typed 32-bit ids. The pool grows by whole blocks and never moves an element while it lives;
// ids are freed last-in first-out, so that splitting again what was just rejoined finds the ids it had.
// In steady state (no more elements alive than once before) nothing is allocated.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/assert.h"

namespace selvedge {

template <class T, class ElementId>
class Pool {
 public:
    static constexpr unsigned kBlockBits = 10;
    static constexpr std::size_t kBlockSize = std::size_t{1} << kBlockBits;

    // Takes the id that was released last, or the lowest that was never used.
    ElementId create(const T& element) {
        if (free_.empty()) grow();
        const ElementId id = free_.back();
        free_.pop_back();
        (*this)[id] = element;
        return id;
    }

    // Pre: id is alive. What is left behind is T{}, so that no stale link looks sound.
    void release(ElementId id) {
        SELVEDGE_ASSERT(free_.size() < capacity());
        (*this)[id] = T{};
        free_.push_back(id);
    }

    T& operator[](ElementId id) { return blocks_[id.value >> kBlockBits][id.value & (kBlockSize - 1)]; }
    const T& operator[](ElementId id) const { return blocks_[id.value >> kBlockBits][id.value & (kBlockSize - 1)]; }

    std::size_t size() const { return capacity() - free_.size(); }        // elements alive
    std::size_t capacity() const { return blocks_.size() * kBlockSize; }  // every id is below it
    std::span<const ElementId> free_ids() const { return free_; }         // the next to be taken is the last

    // What one element costs, its place in the free list included.
    static constexpr std::size_t kBytesPerElement = sizeof(T) + sizeof(ElementId);

 private:
    void grow() {
        const std::size_t first = capacity();
        blocks_.emplace_back(kBlockSize);
        free_.reserve(capacity());
        for (std::size_t i = capacity(); i > first; --i) free_.push_back(ElementId(static_cast<std::uint32_t>(i - 1)));
    }

    std::vector<std::vector<T>> blocks_;  // the inner vectors never grow
    std::vector<ElementId> free_;
};

}  // namespace selvedge
