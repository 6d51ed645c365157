#pragma once
// Maps material points of panels to 3D positions on the drape.
#include <cstdint>
#include <vector>

#include "sim/cloth/cloth.h"

namespace selvedge::sim {

// A point in a panel's material coordinates, independent of the mesh.
struct MaterialPoint {
    std::uint16_t panel = 0;
    Vec2f u = Vec2f::Zero();  // m

    bool operator==(const MaterialPoint&) const = default;
};

// The current leaf triangles, sorted into a grid per panel. The cloth must outlive this object and keep its leaves.
class DrapedPanels {
 public:
    explicit DrapedPanels(const Cloth& cloth);

    // 3D position (m), interpolated in the triangle that contains the point; outside the panel that of the nearest
    // triangle.
    Vec3f position(const MaterialPoint& at) const;

    // The vertex of that triangle that is nearest in the material; a null id where the panel has no cloth.
    VertexId nearest_vertex(const MaterialPoint& at) const;

    // The material coordinates of the vertex in the given panel; zero when it has none there.
    static MaterialPoint place_of(const Cloth& cloth, VertexId v, std::uint16_t panel);

 private:
    struct Cells {
        Vec2f low = Vec2f::Zero();
        float size = 1;  // m
        int columns = 0, rows = 0;
        std::vector<std::vector<std::uint32_t>> leaves;  // per cell: indices of the leaf triangles that overlap it
        std::vector<std::uint32_t> all;
    };
    const LeafTriangle* nearest_leaf(const MaterialPoint& at) const;

    const Cloth& cloth_;
    std::vector<Cells> panels_;
};

}  // namespace selvedge::sim
