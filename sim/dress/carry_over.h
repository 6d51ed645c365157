#pragma once
// State transfer when a pattern changes: the new cloth continues from the current drape. Also the map between the
// panels of the old and the new pattern.
#include <optional>
#include <string>
#include <vector>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/dress/draped_panels.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// What changed between two patterns, from the drape's point of view; compare() returns the strongest change.
enum class PatternChange {
    None,      // nothing that the drape shows: the placement of panels, names other than panels'
    Setts,     // the sett's offset on a panel, or one panel's name
    Fabrics,   // fabric or grain direction
    Outlines,  // outline geometry, pins or mesh resolution
    Kind       // panels, edges or seams were added or removed: see restart_reason
};
PatternChange compare(const Pattern& before, const Pattern& after);

// For example "'front' has one edge more: sewn anew from where it is placed". Pre: compare() returns Kind.
std::string restart_reason(const Pattern& before, const Pattern& after);

struct DrapeState {
    const Cloth& cloth;
    const Pattern& pattern;
    const std::vector<int>& open_seams;  // ascending; they stay open
};

struct TransferredDrape {
    Cloth cloth;
    GarmentMesh mesh;  // level 0, sewn
};

// Meshes `after` in the shape of the current drape: sewn, refined by the criteria, at rest. Each material point of a
// panel is placed where the corresponding point of the old panel was. Pre: compare() does not return Kind. Throws
// InputError when the mesh cannot be sewn. deepest_level: the new cloth's.
TransferredDrape transfer_drape(const DrapeState& drape, const Pattern& after, GarmentMesh unsewn,
                                const std::vector<Fabric>& fabrics, const Collider& body,
                                const AdaptClothOptions& adapting, int deepest_level);

// Maps points of a panel to corresponding points of another panel with the same edges. A point on the outline keeps its
// edge and its fraction of that edge's length; interior points follow by mean value coordinates. (Floater 2003; Hormann
// and Floater 2006)

class OutlineMap {
 public:
    // Pre: both panels have the same number of edges, all of non-zero length.
    OutlineMap(const Panel& from, const Panel& to);

    // The identity for equal panels. Points outside a concave outline may be mapped to a poor position near it.
    Vec2d operator()(const Vec2d& u) const;

 private:
    bool is_identity_ = false;
    std::vector<Vec2d> from_;
    std::vector<Vec2d> to_;
};

}  // namespace selvedge::sim
