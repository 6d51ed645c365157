#pragma once
// What was learnt about triangles, kept by their ids while an adaption is under way: their lanes come and go.
#include <cstdint>
#include <vector>

#include "sim/core/ids.h"

namespace selvedge {

template <class State>
class SavedStates {
 public:
    // What was saved in that adaption, until the next is saved; none if nothing was.
    const State* find(TriangleId t, std::uint32_t adaption) const {
        return t.value < entries_.size() && entries_[t.value].adaption == adaption ? &entries_[t.value].state : nullptr;
    }
    // Later ones of the same adaption replace earlier ones.
    void save(TriangleId t, std::uint32_t adaption, const State& state) {
        if (t.value >= entries_.size()) entries_.resize(2 * t.value + 1);
        entries_[t.value] = {.state = state, .adaption = adaption};
    }

 private:
    struct Entry {
        State state{};
        std::uint32_t adaption = UINT32_MAX;
    };
    std::vector<Entry> entries_;
};

}  // namespace selvedge
