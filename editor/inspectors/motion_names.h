#pragma once
// The poses and motions that a user can choose from, for the Body tab and the timeline.
#include <string>
#include <vector>

#include "editor/workspace/workspace.h"

namespace selvedge::editor {

struct MotionChoices {
    std::vector<std::string>
        texts;  // as Drape::choose_motion() and choose_pose() take them; the first one, empty: none
    std::vector<std::string> titles;  // as they are shown
    int chosen = 0;                   // -1: none of them
    std::string shown;                // title of what is chosen
};

// No motion, those of the body's file, the shipped ones, and the file that is chosen.
MotionChoices motion_choices(const Drape& drape);

// The pose in which the body is dressed, its own if that is another, the shipped poses, the ends of shipped motions
// that stop, and files of poses that were chosen.
MotionChoices pose_choices(const Drape& drape);

// "arms_up" as "Arms up".
std::string title_of(const std::string& name);

}  // namespace selvedge::editor
