#include "app/animation_run.h"

#include <array>
#include <cstdio>
#include <utility>

#include "app/film.h"
#include "app/interface_fonts.h"
#include "sim/core/error.h"
#include "sim/dress/dressing_pose.h"
#include "sim/exchange/pc2_file.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

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
    check_distinct(outputs_of(arguments), input_files(arguments.garment, arguments.body));
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

// notes: of the garment; they go before the actor's.
Actor checked_actor(Actor actor, const sim::AnimationOptions& options, std::vector<std::string> notes) {
    check_times(options, actor.clip);
    if (ends_early(actor.clip, options))
        notes.push_back("'" + actor.clip.name + "' ends after " + seconds_text(actor.clip.seconds) +
                        ": then its last pose is held");
    actor.notes.insert(actor.notes.begin(), notes.begin(), notes.end());
    return actor;
}

}  // namespace

std::string seconds_text(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f s", seconds);
    return text.data();
}

std::vector<Path> outputs_of(const AnimateArguments& arguments) {
    std::vector<Path> outputs = arguments.caches.files;
    for (const Path& cache : arguments.caches.files)
        if (cache.extension() == ".pc2") outputs.push_back(sim::mesh_beside(cache));
    for (const Path& file : {arguments.film, arguments.report_file}) {
        if (!file.empty()) outputs.push_back(file);
    }
    return outputs;
}

void prepare_animation(AnimateArguments& arguments, const sim::Pattern& pattern) {
    name_inputs(arguments.garment, arguments.body, arguments.picture, pattern);
    fill_in(arguments.garment, arguments.picture, pattern);
    check_outputs(arguments);
    if (!arguments.film.empty()) {
        check_can_draw(arguments.picture);
        arguments.picture.legend_font = read_legend_font();
    }
    arguments.animation.dress = arguments.garment.dress;
    arguments.animation.frames_per_second = arguments.frames_per_second;
}

AnimationRun::AnimationRun(AnimateArguments arguments, const Worn& worn, Actor actor, const sim::Progress& progress)
    : arguments_(std::move(arguments)),
      actor_(checked_actor(std::move(actor), arguments_.animation, worn.notes)),
      animation_(worn.pattern, actor_.body, sim::dressing_pose(*actor_.body), actor_.clip, arguments_.animation,
                 progress) {}

void AnimationRun::open_outputs() {
    const FilmFormat format = film_format(arguments_, animation_.frame_count());
    if (!arguments_.film.empty()) {
        check_film(arguments_.film, format, "--film");
        film_.emplace(
            Filming::Options{.file = arguments_.film, .format = format, .camera_stays = arguments_.camera_stays},
            arguments_.picture, animation_);
    }
    caches_.emplace(arguments_.caches, arguments_.frames_per_second, arguments_.picture, animation_);
}

void AnimationRun::write_frame() {
    if (film_) film_->add(animation_);
    caches_->add(animation_);
}

void AnimationRun::finish() {
    if (film_) film_->finish();
    caches_->finish();
}

}  // namespace selvedge::app
