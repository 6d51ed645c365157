#include "app/animate_run.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "app/progress_bar.h"
#include "app/report_inputs.h"
#include "app/stop_signal.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/core/printable.h"
#include "sim/session/animation_report.h"

namespace selvedge::app {
namespace {

void print_summary(const AnimationRun& run) {
    const sim::Animation& animation = run.animation();
    const Actor& actor = run.actor();
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
    for (const std::filesystem::path& file : outputs_of(run.arguments()))
        std::printf("wrote %s\n", sim::printable(file.string()).c_str());
}

}  // namespace

int run_animate(AnimateArguments arguments) {
    Worn worn;
    worn.pattern = load_garments(arguments.garment, worn.notes);
    prepare_animation(arguments, worn.pattern);
    std::optional<sim::ThreadLimit> limit;
    if (arguments.garment.threads) limit.emplace(*arguments.garment.threads);
    Actor actor = make_actor(arguments.body, arguments.motion);
    ProgressBar bar(progress_bar_options(arguments.garment.is_quiet));
    AnimationRun run(std::move(arguments), worn, std::move(actor), bar.progress());
    const sim::Animation& animation = run.animation();
    const StopSignal stop;
    run.open_outputs();
    do {
        run.write_frame();
        bar.show("moving", static_cast<double>(animation.frame()) / std::max(1, animation.frame_count() - 1));
    } while (!stop.is_raised() && run.advance());
    run.finish();
    const AnimateArguments& asked = run.arguments();
    if (!asked.report_file.empty())
        sim::write_file_atomically(
            asked.report_file,
            to_json(animation, run.actor().clip.name,
                    report_inputs(asked.garment, asked.body, *asked.picture.pattern, run.actor().motion_file),
                    run.actor().notes));
    bar.finish();
    if (!asked.garment.is_quiet) print_summary(run);
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
