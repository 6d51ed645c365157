#pragma once
// Adapts the 3D placement of panels to a body other than the one they were placed for, and clears a way for the seams.
// Also arrangement points: positions around a body at which a panel can be placed.
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/landmarks.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

class BodyCollider;

// Shifts each panel. What seams join keeps its heights among itself, as cloth does not grow with its wearer: its
// highest point goes to the same place between floor, hips, waist, shoulders and crown, also of a body without head or
// legs (sim/body/landmarks.h); what reaches above the shoulders goes with them. Each panel moves with the centre of the
// torso's section at its height. A panel of a sleeve turns about the shoulder with
// its arm, if that hangs at another angle (sim/place/limb_pieces.h). `from` is the body that the pattern names. Does
// not change the pattern when both bodies are equal. Returns the stature that `onto` was taken to have.
Stature anchor_panels(Pattern& pattern, const MeasuredBody& from, const MeasuredBody& onto);

struct ClearedPanels {
    std::vector<std::string> notes;  // one per panel that was moved, or is a tube that meets its limb
    std::vector<std::string> stuck;  // "panel 'collar' stands in the body, and nowhere near is clear of it"
};

// Moves each panel that intersects the body outward along its front normal until it is clear, by at most 40 cm; also
// until it is outside of the cloth that is worn and of all panels of lower layers.
ClearedPanels clear_panels(GarmentMesh& unsewn, const BodyCollider& body, const GarmentMesh& worn = {});

// The vertical shift of the whole unsewn garment (m, negative: down) with which its seams can close. The body blocks a
// shoulder seam that is too low or an underarm seam that is too high. The shift minimises how deep the straight lines
// between linked vertices run through the body, and then lifts those off the body that graze it from above.
double seam_clearing_lift(const GarmentMesh& unsewn, const BodyCollider& body);

// Applies close_level_gaps(), seam_clearing_lift() and clear_panels(). The notes tell all. `worn`: cloth under the
// garment, where it is. measured: the body; null: its shoulders are not known.
ClearedPanels make_sewable(GarmentMesh& unsewn, const BodyCollider& body, const GarmentMesh& worn = {},
                           const MeasuredBody* measured = nullptr);

// Arrangement points: positions around a body at which a panel can be placed, wrapped on a cylinder about the torso or
// limb. They are computed from plane sections of the body and, where it has one, its skeleton (arms, legs).

struct ArrangementPoint {
    std::string name;                // "chest front", "left upper arm outside"
    Vec3d position = Vec3d::Zero();  // m, on the cylinder about the limb or torso, clear of the body
    Vec3d outward = Vec3d::UnitZ();  // unit, away from the axis
    Vec3d upward = Vec3d::UnitY();   // unit, along the axis, towards the head, shoulder or hip
    double radius = 0;               // m, of that cylinder
};

// The point turned about the line through `centre` along its `upward`, rad.
ArrangementPoint turned(ArrangementPoint point, const Vec3d& centre, double angle);

// All points in a fixed order: torso from neck to below the hip, then arms, then legs; at each torso level front, back,
// left, right. Points too close to the body are left out.
std::vector<ArrangementPoint> arrangement_points(const Body& body);

// Places the centre of the panel's bounding box at the point, right side outward, the panel's +y along `upward`, and
// wraps the panel around the cylinder.
void arrange(Panel& panel, const ArrangementPoint& point);

// From the nearest of a net of points on the panel, its outline among them, to the body, m; negative inside.
float clearance_of(const Panel& panel, const BodyCollider& body);

}  // namespace selvedge::sim
