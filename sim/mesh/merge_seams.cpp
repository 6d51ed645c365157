#include "sim/mesh/merge_seams.h"

#include <algorithm>

#include "sim/mesh/linked_vertices.h"

namespace selvedge {

SewnMesh merge_seams(const GarmentMesh& unsewn) {
    const std::vector<int> lead = leads_of_linked(unsewn);
    SewnMesh sewn;
    sewn.sewn_vertex.assign(unsewn.x.size(), -1);
    std::vector<int> members;
    for (std::size_t i = 0; i < unsewn.x.size(); ++i) {
        const auto first = static_cast<std::size_t>(lead[i]);  // never behind i: the lead is the lowest of its group
        if (first == i) {
            sewn.sewn_vertex[i] = static_cast<int>(sewn.mesh.x.size());
            sewn.mesh.x.emplace_back(Vec3d::Zero());
            members.push_back(0);
        }
        sewn.sewn_vertex[i] = sewn.sewn_vertex[first];
        const auto merged = static_cast<std::size_t>(sewn.sewn_vertex[i]);
        sewn.mesh.x[merged] += unsewn.x[i];
        ++members[merged];
    }
    for (std::size_t i = 0; i < members.size(); ++i) sewn.mesh.x[i] /= members[i];

    const auto renamed = [&](int vertex) { return sewn.sewn_vertex[static_cast<std::size_t>(vertex)]; };
    sewn.mesh.triangles = unsewn.triangles;
    for (GarmentTriangle& triangle : sewn.mesh.triangles) {
        for (int& vertex : triangle.vertices) vertex = renamed(vertex);
    }
    for (int pin : unsewn.pins) {
        if (std::ranges::find(sewn.mesh.pins, renamed(pin)) == sewn.mesh.pins.end())
            sewn.mesh.pins.push_back(renamed(pin));
    }
    sewn.mesh.panel_names = unsewn.panel_names;
    sewn.mesh.panel_grain_angles = unsewn.panel_grain_angles;
    sewn.mesh.panel_sett_offsets = unsewn.panel_sett_offsets;
    return sewn;
}

}  // namespace selvedge
