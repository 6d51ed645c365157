#include "sim/adaptive/leaf_lists.h"

namespace selvedge {

void LeafChanges::clear() {
    for (std::vector<VertexId>* list : {&vertices_gone, &vertices_come}) list->clear();
    for (std::vector<EdgeId>* list : {&edges_gone, &edges_come, &hinges_changed}) list->clear();
    for (std::vector<TriangleId>* list : {&triangles_gone, &triangles_come, &refined_changed}) list->clear();
}

}  // namespace selvedge
