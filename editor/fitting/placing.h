#pragma once
// From gestures in the room to the commands that place panels.
#include <set>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/fitting/gizmo_drag.h"
#include "sim/dress/arrangement.h"

namespace selvedge {

// Copies of the named panels, in the pattern's order.
std::vector<Panel> panels_of(const Pattern& pattern, const std::set<std::string>& names);

// The middle of the box about what they are in the room, m. Pre: not empty.
Vec3d placed_centre(const std::vector<Panel>& panels);

// The outline in the room, m: closed, within a millimetre.
std::vector<Vec3f> placed_outline(const Panel& panel);

// Places the panels where the motion takes them; how they are bent stays. Pre: not empty.
Command move_command(const std::vector<Panel>& panels, const RigidMotion& motion);

// Wraps the panels round the point: all of them, each about its own middle. Pre: not empty.
Command arrange_command(std::vector<Panel> panels, const ArrangementPoint& point);

}  // namespace selvedge
