#pragma once
// Which unsewn vertices the seams make one.
#include <vector>

#include "sim/mesh/garment_mesh.h"

namespace selvedge {

// Union-find whose representative is the lowest index of each group, so that results do not depend on the order of
// joins.
class DisjointSets {
 public:
    explicit DisjointSets(std::size_t count);
    int find(int element);
    void join(int a, int b);

 private:
    std::vector<int> parent_;
};

// Per vertex, the lowest vertex among those that chains of links connect it to (itself where there are none).
// Pre: links are in range.
std::vector<int> leads_of_linked(const GarmentMesh& mesh);

}  // namespace selvedge
