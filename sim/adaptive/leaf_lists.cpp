#include "sim/adaptive/leaf_lists.h"

namespace selvedge {

void LeafChanges::clear() {
    for (std::vector<VertexId>* list : {&vertices_gone, &vertices_come}) list->clear();
    for (std::vector<EdgeId>* list : {&edges_gone, &edges_come, &hinges_changed}) list->clear();
    for (std::vector<TriangleId>* list : {&triangles_gone, &triangles_come}) list->clear();
}

float material_area(const std::array<Vec2f, 3>& u) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    return 0.5F * (a.x() * b.y() - a.y() * b.x());
}

}  // namespace selvedge
