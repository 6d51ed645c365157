#pragma once
// Jumps of a clip: two frames between which joints move, or turn, faster than a person's do. Many files of motions
// begin with a frame or two of the T-pose in which their skeleton is set up, and jump from there to the motion; others
// join takes without a transition. A garment is torn by either.
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"

namespace selvedge::sim {

// Between two times of keys.
struct ClipJump {
    double from = 0;        // s
    double to = 0;          // s
    double way = 0;         // of the joint that jumps the farthest, m for a person of average size; 0: joints only turn
    double turn = 0;        // rad, of the joint that turns the farthest
    bool is_whole = false;  // the person jumps, not one limb of a recording
};

// In ascending order. The skeleton may be in any unit: it is measured by its legs. A loop has none.
std::vector<ClipJump> find_jumps(const Body& skeleton, const Clip& clip);

// Leaves out what is before a jump of the whole person in the first half second and behind one in the last, and blends
// over any other: where the bones that jump were before it goes over into the motion, the longer the farther. What was
// done is added to Clip::notes.
void mend_jumps(const Body& skeleton, Clip& clip);

// "0.25 s"
std::string moment_text(double seconds);

}  // namespace selvedge::sim
