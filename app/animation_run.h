#pragma once
// An animation with what is written of it, frame by frame: a film, and caches for other programs. For the command
// animate and for the Python module, which let it go on in their own ways.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/actor.h"
#include "app/animation_caches.h"
#include "app/filming.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "app/picture.h"
#include "sim/pattern/pattern.h"
#include "sim/session/animation.h"

namespace selvedge::app {

class Command;

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

// Adds the options of motion, picture and output. `arguments` must outlive the parsing.
void add_animation_options(Command& command, AnimateArguments& arguments);

// For messages: "1.5 s".
std::string seconds_text(double seconds);

// Files that will be written.
std::vector<std::filesystem::path> outputs_of(const AnimateArguments& arguments);

// Takes from the pattern what the arguments do not say, and throws InputError for what is wrong, before long work: for
// files that cannot be written, too.
void prepare_animation(AnimateArguments& arguments, const sim::Pattern& pattern);

// What is dressed, and what was found when it was loaded, a sentence each.
struct Worn {
    sim::Pattern pattern;
    std::vector<std::string> notes;
};

class AnimationRun {
 public:
    // Dresses the body. Throws InputError. Pre: prepare_animation(arguments, worn.pattern).
    AnimationRun(AnimateArguments arguments, const Worn& worn, Actor actor, const sim::Progress& progress = {});

    const AnimateArguments& arguments() const { return arguments_; }
    const Actor& actor() const { return actor_; }  // whose notes are of all
    const sim::Animation& animation() const { return animation_; }

    // Opens film and caches. Throws InputError. Called once, before the first frame is written.
    void open_outputs();
    // Adds the frame that is shown to film and caches. Throws InputError. Pre: it was not added yet.
    void write_frame();
    bool advance() { return animation_.advance(); }
    // Makes film and caches appear. Pre: a frame was written; called once.
    void finish();

 private:
    AnimateArguments arguments_;
    Actor actor_;
    sim::Animation animation_;
    std::optional<Filming> film_;
    std::optional<AnimationCaches> caches_;
};

}  // namespace selvedge::app
