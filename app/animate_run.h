#pragma once
// What the command animate does once its options are known: dresses a body, lets it move, and writes and prints what
// came of it.
#include <filesystem>

#include "app/actor.h"
#include "app/animation_caches.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "app/picture.h"
#include "sim/session/animation.h"

namespace selvedge::app {

struct AnimateArguments {
    GarmentOptions garment;
    BodyOptions body;
    MotionChoice motion;
    sim::AnimationOptions animation;
    int frames_per_second = 25;
    PictureOptions picture;
    bool camera_stays = false;
    std::filesystem::path film;  // empty: no such output
    CacheChoice caches;
    std::filesystem::path report_file;
};

// Returns the exit code. Throws InputError for wrong input, and for a file that cannot be written. A signal that stops
// the program ends the motion early.
int run_animate(AnimateArguments arguments);

}  // namespace selvedge::app
