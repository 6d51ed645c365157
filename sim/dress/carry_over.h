#pragma once
// State transfer when a pattern changes: the new cloth continues from the current drape. Also the map between the
// panels of the old and the new pattern, and the map from material points to positions on a drape.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/simulation/simulation.h"

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

// What changed between two patterns, from the drape's point of view; compare() returns the strongest change.
enum class PatternChange {
    None,      // nothing that the drape shows: the placement of panels, names other than panels'
    Setts,     // the sett's offset on a panel, or one panel's name
    Fabrics,   // fabric or grain direction
    Outlines,  // outline geometry, also points of it or the order of its edges; elastics, pins or mesh resolution
    Kind       // other panels or outlines; seams that join other places; another order of garments: restart_reason
};
PatternChange compare(const Pattern& before, const Pattern& after);

// The number of garments of `before` if `after` has the same with others over them, which are sewn to none of them;
// otherwise 0. The panels and seams of the others follow those of `before`, as after put_over().
std::size_t count_worn_under(const Pattern& before, Pattern after);

// For example "there is one seam more: sewn anew from where the panels are placed". Pre: compare() returns Kind.
std::string restart_reason(const Pattern& before, const Pattern& after);

struct DrapeState {
    const Cloth& cloth;
    const Pattern& pattern;
    std::span<const OpenSeam> open_seams;  // ascending; they stay open
};

struct TransferredDrape {
    Simulation simulation;
    GarmentMesh mesh;            // level 0, sewn
    std::vector<OpenSeam> open;  // seams that stay open, ascending
};

// Gives `mesh`, the unsewn mesh of `after`, the shape of the current drape: sewn, refined by the criteria, at rest.
// Each material point of a panel is placed where the corresponding point of the old panel was. Pre: compare() does not
// return Kind. Throws InputError when the mesh cannot be sewn. deepest_level: the new cloth's.
TransferredDrape transfer_drape(const DrapeState& drape, const Pattern& after, GarmentMesh mesh,
                                const std::vector<Fabric>& fabrics, const Collider& body,
                                const SimulationOptions& options, int deepest_level);

// Maps points of a panel to corresponding points of another state of it. A point on the outline keeps its stretch, in
// most cases an edge (OutlineMatch), and its fraction of that stretch's length; interior points follow by mean value
// coordinates. (Floater 2003; Hormann and Floater 2006)
class OutlineMap {
 public:
    // Pre: the outlines match, or are the same; all edges are of non-zero length.
    OutlineMap(const Panel& from, const Panel& to);

    // The identity for equal panels. Points outside a concave outline may be mapped to a poor position near it.
    Vec2d operator()(const Vec2d& u) const;

 private:
    bool is_identity_ = false;
    std::vector<Vec2d> from_;
    std::vector<Vec2d> to_;
};

}  // namespace selvedge::sim
