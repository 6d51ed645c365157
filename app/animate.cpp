// selvedge animate GARMENT: dresses a body and lets it move; writes a film, animation caches and a report.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/actor.h"
#include "app/animation_caches.h"
#include "app/arguments.h"
#include "app/commands.h"
#include "app/film.h"
#include "app/filming.h"
#include "app/garment_options.h"
#include "app/interface_fonts.h"
#include "app/options.h"
#include "app/picture.h"
#include "app/progress_bar.h"
#include "app/report_inputs.h"
#include "app/stop_signal.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/core/printable.h"
#include "sim/dress/dressing_pose.h"
#include "sim/exchange/pc2_file.h"
#include "sim/session/animation.h"
#include "sim/session/animation_report.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

struct AnimateArguments {
    GarmentOptions garment;
    BodyOptions body;
    MotionChoice motion;
    sim::AnimationOptions animation;
    int frames_per_second = 25;
    PictureOptions picture;
    bool camera_stays = false;
    Path film;  // empty: no such output
    CacheChoice caches;
    Path report_file;
};

std::vector<Path> all_outputs(const AnimateArguments& arguments) {
    std::vector<Path> outputs = arguments.caches.files;
    for (const Path& cache : arguments.caches.files)
        if (cache.extension() == ".pc2") outputs.push_back(sim::mesh_beside(cache));
    for (const Path& file : {arguments.film, arguments.report_file}) {
        if (!file.empty()) outputs.push_back(file);
    }
    return outputs;
}

FilmFormat film_format(const AnimateArguments& arguments, int frames) {
    return {.width_px = arguments.picture.width_px,
            .height_px = arguments.picture.height_px,
            .frames_per_second = arguments.frames_per_second,
            .frames = frames};
}

void check_outputs(const AnimateArguments& arguments) {
    constexpr int kMostFrames = 1'000'000;  // the number is known when the motion is: no older frame is in the way yet
    if (!arguments.film.empty()) check_film(arguments.film, film_format(arguments, kMostFrames), "--film");
    check_caches(arguments.caches.files);
    if (!arguments.report_file.empty()) check_output(arguments.report_file);
    if (arguments.picture.show == render::ShowMode::Hierarchy)
        throw sim::InputError("", "--show", "hierarchy is a picture of one moment: see selvedge dress");
    check_distinct(all_outputs(arguments), input_files(arguments.garment, arguments.body));
}

std::string seconds_text(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f s", seconds);
    return text.data();
}

void print_summary(const AnimateArguments& arguments, const sim::Animation& animation, const Actor& actor) {
    const sim::MotionQuality& quality = animation.quality();
    std::printf("%s on %s, '%s': %d of %d frames, %s, about %zu triangles\n",
                sim::printable(animation.dress_report().garment).c_str(), sim::printable(actor.body->name).c_str(),
                sim::printable(actor.clip.name).c_str(), animation.frame() + 1, animation.frame_count(),
                seconds_text(animation.seconds()).c_str(), animation.cloth().mesh.leaf_triangles().size());
    std::printf(
        "stretch: 99 %% of the triangles at most %.1f %%, one %.1f %%; deeper in the body than 1 mm: %d vertices and "
        "%d faces in all frames; at most %d vertices pinched\n",
        100 * quality.p99_stretch, 100 * quality.max_stretch, quality.deep_vertices, quality.deep_faces,
        quality.pinched);
    constexpr int kMany = 20;
    if (quality.pinched > kMany && actor.can_open_arms)
        std::printf(
            "note: limbs that lie inside of other parts of the body stretch the cloth between them; --open-arms moves "
            "arms out of the trunk\n");
    for (const std::string& note : actor.notes) std::printf("note: %s\n", sim::printable(note).c_str());
    for (const std::string& note : animation.dress_report().notes)
        std::printf("note: %s\n", sim::printable(note).c_str());
    for (const Path& file : all_outputs(arguments)) std::printf("wrote %s\n", sim::printable(file.string()).c_str());
}

// Whether more of a clip is asked for than there is. A pose is held anyway.
bool ends_early(const sim::Clip& clip, const sim::AnimationOptions& animation) {
    if (clip.is_loop || clip.seconds == 0) return false;
    constexpr double kRounding = 0.05;  // s, of a length as it is printed
    const double last =
        animation.seconds ? animation.from + *animation.seconds * animation.speed : animation.to.value_or(clip.seconds);
    return last > clip.seconds + kRounding;
}

void check_times(const sim::AnimationOptions& animation, const sim::Clip& clip) {
    if (animation.from > clip.seconds)
        throw sim::InputError("", "--from", "is behind the end of '" + clip.name + "', " + seconds_text(clip.seconds));
    if (animation.to && *animation.to <= animation.from)
        throw sim::InputError("", "--to", "is not behind --from, " + seconds_text(animation.from));
}

int run(AnimateArguments arguments) {
    std::vector<std::string> notes;
    const sim::Pattern pattern = load_garments(arguments.garment, notes);
    name_inputs(arguments.garment, arguments.body, arguments.picture, pattern);
    fill_in(arguments.garment, arguments.picture, pattern);
    check_outputs(arguments);
    if (!arguments.film.empty()) {
        check_can_draw(arguments.picture);
        arguments.picture.legend_font = read_legend_font();
    }
    arguments.animation.dress = arguments.garment.dress;
    arguments.animation.frames_per_second = arguments.frames_per_second;

    std::optional<sim::ThreadLimit> limit;
    if (arguments.garment.threads) limit.emplace(*arguments.garment.threads);
    Actor actor = make_actor(arguments.body, arguments.motion);
    check_times(arguments.animation, actor.clip);
    if (ends_early(actor.clip, arguments.animation))
        notes.push_back("'" + actor.clip.name + "' ends after " + seconds_text(actor.clip.seconds) +
                        ": then its last pose is held");
    actor.notes.insert(actor.notes.begin(), notes.begin(), notes.end());
    ProgressBar bar(progress_bar_options(arguments.garment.is_quiet));
    sim::Animation animation(pattern, actor.body, sim::dressing_pose(*actor.body), actor.clip, arguments.animation,
                             bar.progress());
    const StopSignal stop;
    if (!arguments.film.empty()) check_film(arguments.film, film_format(arguments, animation.frame_count()), "--film");
    std::optional<Filming> film;
    if (!arguments.film.empty())
        film.emplace(Filming::Options{.file = arguments.film,
                                      .format = film_format(arguments, animation.frame_count()),
                                      .camera_stays = arguments.camera_stays},
                     arguments.picture, animation);
    AnimationCaches caches(arguments.caches, arguments.frames_per_second, arguments.picture, animation);
    do {
        if (film) film->add(animation);
        caches.add(animation);
        bar.show("moving", static_cast<double>(animation.frame()) / std::max(1, animation.frame_count() - 1));
    } while (!stop.is_raised() && animation.advance());
    if (film) film->finish();
    caches.finish();
    if (!arguments.report_file.empty())
        sim::write_file_atomically(
            arguments.report_file,
            to_json(animation, actor.clip.name,
                    report_inputs(arguments.garment, arguments.body, *arguments.picture.pattern, actor.motion_file),
                    actor.notes));
    bar.finish();
    if (!arguments.garment.is_quiet) print_summary(arguments, animation, actor);
    print_faults(animation.dress_report());
    for (const std::string& fault : animation.motion_faults())
        std::printf("defect: in motion: %s\n", sim::printable(fault).c_str());
    if (stop.is_raised()) {
        std::fprintf(stderr, "selvedge: stopped after %s of %s\n", seconds_text(animation.seconds()).c_str(),
                     seconds_text(animation.timeline().seconds()).c_str());
        return stop.exit_code();
    }
    return exit_code_of(outcome_of(animation));
}

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

void add_animate_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<AnimateArguments>();
    arguments->picture.width_px = arguments->picture.height_px = 720;
    Command& command = add_command(app, "animate", "Dress a body and let it move: a film, or a cache for Blender");
    add_garment_options(command, arguments->garment);
    add_thread_options(command, arguments->garment);
    add_body_options(command, arguments->body,
                     "Body that moves: mannequin[:sex=female,bust=92,...], or a .glb, .gltf or .fbx file with bones "
                     "(default: the pattern's, or mannequin:sex=female)");
    add_motion_options(command, *arguments);
    add_picture_options(command, arguments->picture);
    add_output_options(command, *arguments);
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
        exit_code = run(*arguments);
    });
}

}  // namespace selvedge::app
