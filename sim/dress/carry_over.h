#pragma once
// A changed pattern on a drape: the cloth goes on from where it hangs.
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

// What of a pattern the drape follows from.
enum class PatternChange {
    None,      // nothing: names, or where panels lie and stand
    Setts,     // what is printed on it
    Fabrics,   // or grain
    Outlines,  // points are elsewhere
    Kind       // panels, edges or seams have come or gone: see why_sewn_anew
};
PatternChange compare(const Pattern& before, const Pattern& after);

// "'front' has one edge more: sewn anew from where it is placed". Pre: compare() says Kind.
std::string why_sewn_anew(const Pattern& before, const Pattern& after);

struct CarriedDrape {
    const Cloth& cloth;
    const Pattern& pattern;
    const std::vector<int>& open_seams;  // ascending: they stay open
};

struct CarriedOver {
    Cloth cloth;
    std::vector<int> pins;  // base vertices that the pattern pins
};

// The unsewn mesh of `after` sewn where the drape hangs, as fine as it is, at rest. Each place of a panel is where the
// like place of the old one was. Pre: compare() says no Kind. Throws InputError where it cannot be sewn.
CarriedOver carry_over(const CarriedDrape& drape, const Pattern& after, const GarmentMesh& unsewn,
                       const std::vector<Fabric>& fabrics, const Collider& body, const AdaptClothOptions& adapting);

// From a place in a panel to the like place in another with the same edges: points of the outline go to points of the
// same edges at the same share of their length, what is inside follows by mean value coordinates.
// (Floater 2003; Hormann and Floater 2006)

class OutlineMap {
 public:
    // Pre: as many edges in both, each with a length.
    OutlineMap(const Panel& from, const Panel& to);

    // Equal panels leave every point as it is. What lies outside of a hollow outline may come out anywhere near it.
    Vec2d operator()(const Vec2d& u) const;

 private:
    bool is_identity_ = false;
    std::vector<Vec2d> from_;
    std::vector<Vec2d> to_;
};

}  // namespace selvedge::sim
