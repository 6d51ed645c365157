#pragma once
// Builds a session's frames from placed panels, panels being sewn, or a drape, including the adaptive mesh's hierarchy.
#include <span>

#include "sim/cloth/cloth.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/session/session.h"

namespace selvedge::sim {

// The unsewn garment at its placed position, as level-0 leaves.
void show_placed(SessionFrame& frame, const GarmentMesh& unsewn);

// The leaves of a cloth, with the names of its panels.
void show_cloth(SessionFrame& frame, const Cloth& cloth, const std::vector<std::string>& panel_names);

// Adds a line for each seam link between its two vertices; link indices refer to x, m.
template <class Position>
void add_seam_lines(SessionFrame& frame, std::span<const SeamLink> links, const std::vector<Position>& x) {
    for (const SeamLink& link : links) {
        const Vec3f a = x[static_cast<std::size_t>(link.a)].template head<3>().template cast<float>();
        const Vec3f b = x[static_cast<std::size_t>(link.b)].template head<3>().template cast<float>();
        frame.seam_lines.push_back({a, b});
        frame.seam_line_seams.push_back(link.seam);
    }
}

}  // namespace selvedge::sim
