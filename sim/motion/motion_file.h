#pragma once
// Motions and poses by the angles of a person's joints, which ship with the program or are written by hand
// (patterns/FORMAT.md), and motions by name for any body with a skeleton.
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {

// The clip on a skeleton of its own, which stands upright with arms and legs straight down, sampled at 60 Hz. Between
// keys, angles follow a cubic without overshoot; the motion starts and ends at rest, and a loop continues smoothly.
// Throws InputError with the JSON path.
BodyClips parse_motion(std::string_view text, const std::string& file);

// The shipped ones, sorted. A pose has one key; a motion has more.
std::vector<std::string> motion_names();
std::vector<std::string> pose_names();

// A shipped motion or pose by name ("walk"), a file in the shipped format ("my_walk.json"), or a clip of a BVH, FBX,
// glTF or GLB file ("walk.bvh", "walks.glb#slow"), made to fit this body's skeleton: turned upright (standing_rest.h)
// and without jumps (clip_jumps.h); Clip::notes tells. If the body has a skin, the motion stands on the floor, and arms
// that would cut the trunk are opened (clear_arms.h), but not in a body's own motion. Throws InputError.
Clip find_motion(const std::string& text, const Body& body);

// The same as a pose: the last one of a motion ("sit": seated). It stands on the floor by itself.
Pose find_pose(const std::string& text, const Body& body);

}  // namespace selvedge::sim
