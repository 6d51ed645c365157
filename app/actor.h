#pragma once
// A body that can move, and what it does: of animate and bench motion.
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/body/body.h"
#include "sim/body/clip.h"

namespace selvedge::app {

struct Actor {
    std::shared_ptr<const sim::Body> body;  // with bones and a skin
    sim::Clip clip;
    std::vector<std::string> notes;
    std::string motion_file;     // empty: the motion ships, or is the body's own
    bool can_open_arms = false;  // the clip is the body's own, as it is: MotionChoice::opens_arms would change it
};

struct MotionChoice {
    std::string name;         // a clip of the body's own file, or a shipped motion or a file with one
                              // (sim/motion/motion_file.h); empty: the first of the body's file that moves
    bool opens_arms = false;  // where a motion of the body's own file would put them into the trunk; others always do
};

// Throws InputError. Pre: body.source is not empty.
Actor make_actor(const BodyOptions& body, const MotionChoice& motion);

// Of a body that is made already. source: its name in messages.
Actor make_actor(const sim::MadeBody& own, const std::string& source, const MotionChoice& motion);

}  // namespace selvedge::app
