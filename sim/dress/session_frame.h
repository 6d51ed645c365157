#pragma once
// What a session shows: frames made from panels that stand, are being sewn, or hang.
#include "sim/cloth/cloth.h"
#include "sim/dress/session.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::sim {

// The unsewn garment where its panels stand, as its leaves would be.
void show_placed(SessionFrame& frame, const GarmentMesh& unsewn);

// The leaves of a cloth; its panels go by these names.
void show_cloth(SessionFrame& frame, const Cloth& cloth, const std::vector<std::string>& panel_names);

// Lines between vertices that seams bring together: vertices as in x, m.
template <class Position>
void show_threads(SessionFrame& frame, const std::vector<SeamLink>& links, const std::vector<Position>& x) {
    for (const SeamLink& link : links) {
        const Vec3f a = x[static_cast<std::size_t>(link.a)].template head<3>().template cast<float>();
        const Vec3f b = x[static_cast<std::size_t>(link.b)].template head<3>().template cast<float>();
        frame.threads.push_back({a, b});
        frame.thread_seams.push_back(link.seam);
    }
}

// The triangles of a cloth's adaptive mesh as plain data.

// Base triangles in their order, each before what it was refined to.
TriangleHierarchy triangle_hierarchy(const Cloth& cloth);

}  // namespace selvedge::sim
