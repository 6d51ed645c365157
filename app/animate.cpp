// selvedge animate GARMENT: dresses a body and lets it move; writes a film, animation caches and a report.
#include <memory>

#include "app/animate_run.h"
#include "app/arguments.h"
#include "app/commands.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "app/picture.h"
#include "sim/core/error.h"

namespace selvedge::app {
namespace {

void add_motion_options(Command& command, AnimateArguments& arguments) {
    sim::AnimationOptions& animation = arguments.animation;
    add_option(command, "--motion", arguments.motion.name,
               "A shipped motion or pose, a clip of the body's file, or a file with one (default: the first of the "
               "body's file that moves)",
               {.type = "NAME|FILE[#CLIP]", .group = "Motion"});
    add_flag(command, "--open-arms", arguments.motion.opens_arms,
             "Open the arms of the body's own motion where they would cut its trunk", {.group = "Motion"});
    add_number<double>(command, "--from", {0, 3600}, "Where in the motion to begin, s (default 0)",
                       {.type = "S", .group = "Motion"}, [&animation](double seconds) { animation.from = seconds; });
    const auto seconds = [&animation](double length) { animation.seconds = length; };
    add_number<double>(command, "--seconds", {0, 3600},
                       "How much of it to show after --blend, s (default: all; of a loop, once)",
                       {.type = "S", .group = "Motion"}, seconds);
    add_number<double>(
        command, "--to", {0, 3600},
        "Where in the motion to end, s, instead of --seconds; behind its end, a loop goes on, and of any "
        "other the last pose is held",
        {.type = "S", .group = "Motion", .excludes = {"--seconds"}}, [&animation](double to) { animation.to = to; });
    add_number<double>(command, "--speed", {0.05, 20}, "Speed of the motion (default 1)",
                       {.type = "FACTOR", .group = "Motion"}, [&animation](double speed) { animation.speed = speed; });
    add_number<double>(command, "--blend", {0.1, 60}, "Time from the dressed pose into the motion, s (default 1.5)",
                       {.type = "S", .group = "Motion"},
                       [&animation](double blend) { animation.blend_seconds = blend; });
    add_number<int>(command, "--fps", {1, 240}, "Frames per second (default 25)", {.type = "N", .group = "Motion"},
                    [&arguments](int rate) { arguments.frames_per_second = rate; });
}

void add_output_options(Command& command, AnimateArguments& arguments) {
    add_option(command, "--film", arguments.film, "A film: .mp4 or .gif by ffmpeg, or a folder of PNG files (frames/)",
               {.type = "FILE", .group = "Output"});
    add_flag(command, "--fixed-camera", arguments.camera_stays,
             "The camera stays where it is, and has all in the picture", {.group = "Output"});
    add_option(
        command, "--export", arguments.caches.files,
        "The moving garment on one mesh: .pc2, .glb (with the body) or a folder, frames/, with one .obj per frame; "
        "may be repeated",
        {.type = "FILE", .group = "Output", .takes_one_value = true});
    add_number<int>(command, "--export-triangles", {1, 1'000'000},
                    "The exported mesh has at most so many triangles (default 20000)", {.type = "N", .group = "Output"},
                    [&arguments](int triangles) { arguments.caches.most_triangles = triangles; });
    add_flag(command, "--export-skinned", arguments.caches.binds_garment,
             "The garment of .glb goes with the body's bones, and morph targets hold what is left (default: morph "
             "targets alone)",
             {.group = "Output"});
    add_number<int>(command, "--texture-size", {64, 16384}, "Side of the textures of .glb, in pixels (default 2048)",
                    {.type = "PX", .group = "Output"},
                    [&arguments](int size_px) { arguments.caches.atlas.size_px = size_px; });
    add_flag(command, "--no-textures{false}", arguments.caches.has_textures, "A .glb without colour",
             {.group = "Output"});
    add_option(command, "--report", arguments.report_file, "What came of it, as JSON",
               {.type = "JSON", .group = "Output"});
}

}  // namespace

void add_animation_options(Command& command, AnimateArguments& arguments) {
    arguments.picture.width_px = arguments.picture.height_px = 720;
    add_motion_options(command, arguments);
    add_picture_options(command, arguments.picture);
    add_output_options(command, arguments);
}

void add_animate_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<AnimateArguments>();
    Command& command = add_command(app, "animate", "Dress a body and let it move: a film, or a cache for Blender");
    add_garment_options(command, arguments->garment);
    add_thread_options(command, arguments->garment);
    add_body_options(command, arguments->body,
                     "Body that moves: mannequin[:sex=female,bust=92,...], or a .glb, .gltf or .fbx file with bones "
                     "(default: the pattern's, or mannequin:sex=female)");
    add_animation_options(command, *arguments);
    set_footer(
        command,
        "The body is dressed at rest, goes over into the motion within --blend seconds, and moves. Ctrl-C ends early\n"
        "and leaves a film and caches of what was done.\n"
        "Exit code: 0 done, 2 wrong input or a file that could not be written, 3 a fault of the drape, at rest or in\n"
        "motion, 130 interrupted, 143 terminated.\n"
        "Examples:\n"
        "  selvedge animate patterns/tshirt.json --motion walk --film walk.mp4\n"
        "  selvedge animate patterns/skirt.json --body dancer.glb --film dance/ --export dance.glb\n"
        "  selvedge animate patterns/tshirt.json --motion walk.bvh --seconds 4 --export cache.pc2");
    set_action(command, [arguments, &exit_code] {
        if (arguments->film.empty() && arguments->caches.files.empty() && arguments->report_file.empty())
            throw sim::InputError("", "animate", "has nothing to write: add --film, --export or --report");
        exit_code = run_animate(*arguments);
    });
}

}  // namespace selvedge::app
