#pragma once
// A garment as it was meant to hang and as it lies, and the bodies for which it was placed and that wear it.
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/place/limbs.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

// The garment before and after draping: its separate panels, and the same with all seams closed. A seam that did not
// close joins its two sides here at their mean positions.
struct WornGarment {
    GarmentMesh panels;                // as they hang: hang_on_shoulders()
    std::vector<double> rises;         // m, by which they rose to there from where they were placed; by vertex
    std::vector<Vec3d> draped;         // m, per vertex of `panels`
    GarmentMesh closed;                // as they hang
    std::vector<int> in_closed;        // vertex of `closed`, per vertex of `panels`
    std::vector<Vec3d> closed_draped;  // m, per vertex of `closed`
};

// unsewn: as it hangs; placed: its vertices where they were placed, m.
WornGarment undraped(GarmentMesh unsewn, const std::vector<Vec3d>& placed);
// The same with what is draped. sewn: the mesh from which the cloth is made, with the triangles of the placed one in
// their order.
WornGarment compare_drape(const Cloth& cloth, const GarmentMesh& sewn, WornGarment garment);

// The body for which a garment was placed, and the one that wears it.
struct BodyPair {
    const BodyLimbs& meant_for;
    const BodyLimbs& worn_by;
    const MeasuredBody& wearer;
};

using PanelVertices = std::vector<std::vector<std::size_t>>;  // per panel, ascending

PanelVertices vertices_by_panel(const GarmentMesh& mesh);

// Per panel, the first of those that seams join it with.
std::vector<std::size_t> garment_parts(const WornGarment& garment, const PanelVertices& panels);

// The arm to which most of the vertices are nearest.
std::optional<LimbKind> arm_of(const std::vector<std::size_t>& vertices, const std::vector<Vec3d>& x,
                               const BodyLimbs& body);

}  // namespace selvedge::sim
