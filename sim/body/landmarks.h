#pragma once
// Landmarks of a body that horizontal sections show, and the stature of the whole body for one that has no head or no
// legs. Placement by shares of the stature then works for a bust as for a whole body.
#include <optional>

#include "sim/body/body.h"

namespace selvedge::sim {

inline constexpr int kLandmarkLevels = 200;  // at which find_landmarks() cuts a body

// Heights in m; nullopt where the surface does not show the landmark.
struct LandmarkHeights {
    std::optional<double> crotch;  // below it, two legs
    std::optional<double> waist;   // where the trunk is narrowest, if it is wider below and above
    std::optional<double> armpit;  // below it, the arms are apart from the trunk
    std::optional<double> neck;    // above the shoulders, where the section is half as wide as the trunk
};

// Each level is exact to about a hundredth of the body's height.
LandmarkHeights find_landmarks(const Body& body);

// Heights of the floor and the crown of the whole body, m.
struct Stature {
    double floor = 0;
    double crown = 0;
    bool has_legs = true;  // otherwise `floor` is estimated and lies below the surface
    bool has_head = true;  // otherwise `crown` is estimated and lies above it

    double height() const { return crown - floor; }
};

// The surface's own height range if the body is whole, or if its landmarks do not show that it is not. Otherwise the
// missing end is estimated from the landmarks and the mannequin's proportions.
Stature find_stature(const Body& body);
Stature find_stature(const Body& body, const LandmarkHeights& landmarks);  // find_landmarks(body)

}  // namespace selvedge::sim
