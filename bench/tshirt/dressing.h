#pragma once
// Dresses a body in a garment, lets it settle, and returns a cloth that can be simulated further. Also makes denser
// bodies by subdivision.
#include <optional>

#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/body_collider.h"
#include "sim/core/parallel.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

// Divides each triangle into n^2 coplanar triangles, with the smallest n that gives `triangles` or more. The shape does
// not change; new vertices take part in the skin by the mean of their corners.
sim::Body split_triangles(const sim::Body& body, int triangles);

struct DressingOptions {
    std::optional<double> edge_length{};  // m, of the base mesh; none: the pattern's
    int max_level = 3;
    float shortest_edge = 0.02F;  // m, initial value of AdaptClothOptions::shortest_edge
    int min_leaves = 0;           // with fewer leaf triangles, the settled garment is refined further
};

struct DressedCloth {
    sim::Cloth cloth;
    float shortest_edge = 0;  // m, final value
    bool is_settled = false;
};

DressedCloth dress_cloth(const sim::Pattern& pattern, const sim::Body& body, const DressingOptions& options = {},
                         const sim::Progress& progress = {});

}  // namespace selvedge::bench
