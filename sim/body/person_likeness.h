#pragma once
// Whether a surface is a person's: its landmarks, the shares of its stature at which they lie, its proportions, two
// legs, and that it stands upright. It knows no unit of length. What a garment can be placed on is a person: whole, or
// without head or legs, as dress forms are.
#include <optional>
#include <string>

#include "sim/body/body.h"
#include "sim/body/landmarks.h"

namespace selvedge::sim {

struct PersonLikeness {
    std::string lacks;             // why it is no person, as in "no head and no two legs were found on it"; else empty
    LandmarkHeights landmarks{};   // in the unit of the surface
    Stature stature{};             // in the unit of the surface
    std::optional<Vec2d> faces{};  // x and z of where its feet point; none: they do not show it

    bool is_person() const { return lacks.empty(); }
    bool is_whole() const { return is_person() && landmarks.crotch && stature.has_head && stature.has_legs; }
};

// Of a surface in any unit, y up, turned consistently. It need not be closed: levels at which it is open show nothing.
PersonLikeness person_likeness(const Body& body);

// How many triangles it cuts for that by planes, about: what long triangles cost.
double cuts_of_likeness(const Body& body);

}  // namespace selvedge::sim
