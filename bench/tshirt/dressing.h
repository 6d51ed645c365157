#pragma once
// A garment dressed and settled, kept as a cloth that can move on.
#include <optional>

#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/body_collider.h"
#include "sim/core/parallel.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

// Each triangle in n^2 of the same plane, n the least with which there are `triangles` or more: the same shape, as a
// denser body. No skeleton.
sim::Body split_triangles(const sim::Body& body, int triangles);

struct DressingOptions {
    std::optional<double> edge_length{};  // m, of the base mesh, instead of the pattern's
    int max_level = 3;
    float shortest_edge = 0.02F;  // m, where refining begins
    int least_leaves = 0;         // a settled garment with fewer is refined on, with shorter and shorter edges
};

struct Dressing {
    sim::Cloth cloth;
    float shortest_edge = 0;  // m, that was come to
    bool is_settled = false;
};

Dressing dress_cloth(const sim::Pattern& pattern, const sim::Body& body, const sim::BodyCollider& collider,
                     const DressingOptions& options = {}, const sim::Progress& progress = {});

}  // namespace selvedge::bench
