#pragma once
// States of triangles, saved by their ids while an adaptation is under way: their slots come and go.
#include <cstdint>
#include <vector>

#include "sim/core/ids.h"

namespace selvedge {

template <class State>
class SavedStates {
 public:
    // What was saved in that adaptation, until the next is saved; none if nothing was.
    const State* find(TriangleId t, std::uint32_t adaptation) const {
        return t.value < entries_.size() && entries_[t.value].adaptation == adaptation ? &entries_[t.value].state
                                                                                       : nullptr;
    }
    // Later ones of the same adaptation replace earlier ones.
    void save(TriangleId t, std::uint32_t adaptation, const State& state) {
        if (t.value >= entries_.size()) entries_.resize(t.value + 1);
        entries_[t.value] = {.state = state, .adaptation = adaptation};
    }

 private:
    struct Entry {
        State state{};
        std::uint32_t adaptation = UINT32_MAX;
    };
    std::vector<Entry> entries_;
};

}  // namespace selvedge
