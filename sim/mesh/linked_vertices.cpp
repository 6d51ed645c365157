#include "sim/mesh/linked_vertices.h"

#include <algorithm>
#include <numeric>

namespace selvedge {

DisjointSets::DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int element) {
    auto at = static_cast<std::size_t>(element);
    while (parent_[at] != static_cast<int>(at)) {
        parent_[at] = parent_[static_cast<std::size_t>(parent_[at])];
        at = static_cast<std::size_t>(parent_[at]);
    }
    return static_cast<int>(at);
}

void DisjointSets::join(int a, int b) {
    const int root_a = find(a);
    const int root_b = find(b);
    parent_[static_cast<std::size_t>(std::max(root_a, root_b))] = std::min(root_a, root_b);
}

std::vector<int> leads_of_linked(const GarmentMesh& mesh) {
    DisjointSets sets(mesh.x.size());
    for (const SeamLink& link : mesh.links) sets.join(link.a, link.b);
    std::vector<int> leads(mesh.x.size());
    for (std::size_t i = 0; i < leads.size(); ++i) leads[i] = sets.find(static_cast<int>(i));
    return leads;
}

}  // namespace selvedge
