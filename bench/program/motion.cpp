// selvedge bench motion: a garment on a body that moves, against the same garment on the body at rest.
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "app/actor.h"
#include "app/arguments.h"
#include "app/options.h"
#include "app/progress_bar.h"
#include "bench/motion/motion.h"
#include "bench/program/commands.h"
#include "bench/support/table.h"
#include "bench/tshirt/dressing.h"
#include "sim/core/parallel.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {

void add_bench_motion(app::Command& program, int& exit_code) {
    struct Arguments {
        std::string pattern = "patterns/tshirt.json";
        app::BodyOptions body{.source = "mannequin", .load = {}};
        app::MotionChoice motion;
        MotionExperiment experiment{};
        int body_triangles = 0;  // 0: as it is
        bool is_live = false;
        bool is_quiet = false;
    };
    auto arguments = std::make_shared<Arguments>();
    app::Command& command = add_command(program, "motion", "A garment on a body that moves, frame by frame");
    add_option(command, "GARMENT", arguments->pattern, "Garment file (default patterns/tshirt.json)");
    app::add_body_options(command, arguments->body,
                          "Body that moves: mannequin or a file with bones (default mannequin)");
    MotionExperiment& experiment = arguments->experiment;
    add_option(command, "--motion", arguments->motion.name, "As of selvedge animate", {.type = "NAME|FILE[#CLIP]"});
    add_flag(command, "--open-arms", arguments->motion.opens_arms, "As of selvedge animate");
    add_option(command, "--from", experiment.from, "Where in the motion to begin, s",
               {.range = app::Limits<double>{0.0, 3600.0}});
    add_option(command, "--seconds", experiment.seconds, "Length, s (default 4)",
               {.range = app::Limits<double>{0.1, 3600.0}});
    add_option(command, "--speed", experiment.speed, "Speed of the motion (default 1)",
               {.range = app::Limits<double>{0.05, 20.0}});
    add_option(command, "--substeps", experiment.substeps, "Per 1/120 s, in motion and at rest (default 24)",
               {.range = app::Limits<int>{1, 100}});
    add_option(command, "--min-leaves", experiment.min_leaves, "Triangles at the start (default 6000)",
               {.range = app::Limits<int>{1, 1'000'000}});
    add_option(command, "--body-triangles", arguments->body_triangles, "Divide the body's triangles into so many",
               {.range = app::Limits<int>{1, 10'000'000}});
    add_flag(command, "!--no-self-collision", experiment.self_contact, "Let the cloth pass through itself");
    add_flag(command, "--live", arguments->is_live, "Measure it in the editor's session too");
    add_flag(command, "-q,--quiet", arguments->is_quiet, "Show no progress");
    set_action(command, [arguments, &exit_code] {
        MotionExperiment& chosen = arguments->experiment;
        chosen.pattern = sim::load_pattern(arguments->pattern).pattern;
        const sim::ThreadLimit one(1);
        app::Actor actor = app::make_actor(arguments->body, arguments->motion);
        chosen.body = arguments->body_triangles == 0
                          ? actor.body
                          : std::make_shared<const sim::Body>(split_triangles(*actor.body, arguments->body_triangles));
        chosen.clip = actor.clip;
        app::ProgressBar bar(app::progress_bar_options(arguments->is_quiet));
        const MotionStatistics statistics = measure_motion(chosen, bar.progress());
        std::optional<LiveStatistics> live;
        if (arguments->is_live) live = measure_live(chosen, bar.progress());
        bar.finish();
        std::cout << to_markdown(table_of(statistics));
        if (live) std::cout << '\n' << to_markdown(table_of(*live));
        exit_code = 0;
    });
}

}  // namespace selvedge::bench
