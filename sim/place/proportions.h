#pragma once
// Where the parts of a body's trunk lie between its floor and its crown. On people, hips and shoulders are at about the
// same shares of the stature (Drillis and Contini 1966). On figures of cartoons and games, whose heads are large and
// legs short, they are not: there they follow from the joints that the skeleton names.
#include "sim/body/body.h"
#include "sim/body/landmarks.h"

namespace selvedge::sim {

struct Proportions {
    double floor = 0;      // m
    double hips = 0;       // m, of the hip joints
    double shoulders = 0;  // m, of the shoulder joints
    double crown = 0;      // m
    bool is_usual = true;  // hips and shoulders are at the usual shares

    // The height of what lies at this share of the stature on people, m.
    double at(double share) const;

    // The stature of a person with so long a trunk, m.
    double stature_by_trunk() const;
};

Proportions find_proportions(const Body& body, const Stature& stature);

}  // namespace selvedge::sim
