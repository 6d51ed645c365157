#pragma once
// Checks whether panels of higher layers lie outside those of lower ones, wherever both are flat and near each other.
// Crumpled cloth has no clear outside, and is not judged.
#include <optional>

#include "sim/cloth/cloth.h"

namespace selvedge::sim {

struct LayerOrderOptions {
    float reach = 0.02F;  // m, distance up to which two panels lie on each other
};

struct LayerOrder {
    int judged = 0;                        // vertices of leaf triangles that lie flat on flat cloth of a lower layer
    int wrong = 0;                         // of these, those that lie inside of it
    std::optional<VertexId> wrong_vertex;  // one of these
};

// Pre: all positions are finite.
LayerOrder measure_layer_order(const Cloth& cloth, const LayerOrderOptions& options = {});

}  // namespace selvedge::sim
