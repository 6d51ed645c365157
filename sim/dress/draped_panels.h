#pragma once
// Where a drape has its material: from a place in a panel to the room.
#include <cstdint>
#include <vector>

#include "sim/cloth/cloth.h"

namespace selvedge::sim {

// A place in the material, whatever mesh lies over it.
struct MaterialPoint {
    std::uint16_t panel = 0;
    Vec2f u = Vec2f::Zero();  // m

    bool operator==(const MaterialPoint&) const = default;
};

// The leaf triangles of one moment, sorted by place. The cloth must outlive it and keep its leaves.
class DrapedPanels {
 public:
    explicit DrapedPanels(const Cloth& cloth);

    // Interpolated in the triangle over the point; outside of the panel, at the nearest place in it. m
    Vec3f position(const MaterialPoint& at) const;

    // The leaf vertex nearest to the point in the material; none where the panel has no cloth.
    VertexId nearest_vertex(const MaterialPoint& at) const;

    // The vertex' own place, in the panel asked for.
    static MaterialPoint place_of(const Cloth& cloth, VertexId v, std::uint16_t panel);

 private:
    struct Cells {
        Vec2f low = Vec2f::Zero();
        float size = 1;  // m
        int columns = 0, rows = 0;
        std::vector<std::vector<std::uint32_t>> leaves;  // by cell: indices of leaf triangles over it
        std::vector<std::uint32_t> all;
    };
    const LeafTriangle* nearest_leaf(const MaterialPoint& at) const;

    const Cloth& cloth_;
    std::vector<Cells> panels_;
};

}  // namespace selvedge::sim
