#pragma once
// Bends the base body to one set of shape parameters: each vertex goes to the weighted mean of where torso, head,
// limbs, hands and feet would take it.
#include <vector>

#include "sim/mannequin/base.h"
#include "sim/mannequin/curves.h"

namespace selvedge::sim {

// How the trunk is bent to its girths: heights are remapped, and every horizontal slice is scaled about the trunk's
// axis by a profile over eleven levels.

// What calibration turns until the tape reads as asked.
struct ShapeParameters {
    double height = 0;       // m
    double stature = 1;      // height over the base body's
    double inseam = 0;       // height that the base body's crotch level goes to, m
    double arm = 1;          // arm length over the base body's
    double shoulder = 1;     // shoulder width over the base body's, as far as the chest allows
    double clearance = 0.9;  // least shoulder width, in parts of the upper chest's scale
    double stance = 0;       // of each leg, outward from the vertical, rad
    double bust_ratio = 1;   // bust over that of a base body of this height
    GirthValues scale;       // radial scales at the levels of the girths
};

// The head's size changes with the root of the height ratio: tall people do not have much larger heads.
double head_scale(const ShapeParameters& shape);

// Upper arms and the shoulder's slope, which widen less than the chest.
double shoulder_slope_scale(const ShapeParameters& shape);

// The least scale of the shoulder's width at which the arms clear the chest.
double least_shoulder(const ShapeParameters& shape, Sex sex);

class TorsoShape {
 public:
    // The base must outlive it.
    TorsoShape(const MannequinBase& base, const ShapeParameters& shape);

    Vec3d bend(const Vec3d& x) const;

    // Where a height of the base body goes.
    double height_of(double y) const { return heights_(y); }

 private:
    double lobe(double dy, double cosine) const;

    const MannequinBase& base_;
    double stature_;
    std::vector<double> levels_;
    Pchip heights_;
    EvenTable radial_;  // scale of a slice
    Pchip front_bias_;  // how much more of it goes to the front
    Pchip widening_;    // of the shoulder girdle, in x only
    double lobes_ = 0;  // how far the breasts stand out over the rib cage
};

struct BentBody {
    std::vector<Vec3d> x;
    Landmarks landmarks;
};

BentBody bend_body(const MannequinBase& base, const ShapeParameters& shape);

// Upper and lower arm along their bones, m.
double arm_length(const Joints& joints);

}  // namespace selvedge::sim
