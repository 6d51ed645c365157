#pragma once
// Groups of the numbers 0 to count - 1, joined pair by pair (union-find).
#include <cstddef>
#include <vector>

namespace selvedge::sim {

// The representative is the lowest index of each group, so that results do not depend on the order of joins.
class DisjointSets {
 public:
    explicit DisjointSets(std::size_t count);
    int find(int element);
    void join(int a, int b);

 private:
    std::vector<int> parent_;
};

}  // namespace selvedge::sim
