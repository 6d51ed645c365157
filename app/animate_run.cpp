#include "app/animate_run.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "app/film.h"
#include "app/filming.h"
#include "app/progress_bar.h"
#include "app/report_inputs.h"
#include "app/stop_signal.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/core/printable.h"
#include "sim/dress/dressing_pose.h"
#include "sim/exchange/pc2_file.h"
#include "sim/session/animation_report.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

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

}  // namespace

int run_animate(AnimateArguments arguments) {
    std::vector<std::string> notes;
    const sim::Pattern pattern = load_garments(arguments.garment, notes);
    name_inputs(arguments.garment, arguments.body, arguments.picture, pattern);
    fill_in(arguments.garment, arguments.picture, pattern);
    check_outputs(arguments);
    if (!arguments.film.empty()) {
        check_can_draw(arguments.picture);
        arguments.picture.legend_font = render::read_legend_font();
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

}  // namespace selvedge::app
