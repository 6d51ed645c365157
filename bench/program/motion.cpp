// selvedge bench motion: a garment on a body that moves, against the same garment on the body at rest.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "app/actor.h"
#include "app/options.h"
#include "app/progress_bar.h"
#include "bench/motion/motion.h"
#include "bench/program/commands.h"
#include "bench/support/table.h"
#include "bench/tshirt/dressing.h"
#include "sim/core/parallel.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {

void add_bench_motion(CLI::App& program, int& exit_code) {
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
    CLI::App* command = program.add_subcommand("motion", "A garment on a body that moves, frame by frame");
    command->add_option("GARMENT", arguments->pattern, "Garment file (default patterns/tshirt.json)");
    app::add_body_options(*command, arguments->body,
                          "Body that moves: mannequin or a file with bones (default mannequin)");
    MotionExperiment& experiment = arguments->experiment;
    command->add_option("--motion", arguments->motion.name, "As of selvedge animate")->type_name("NAME|FILE[#CLIP]");
    command->add_flag("--open-arms", arguments->motion.opens_arms, "As of selvedge animate");
    command->add_option("--from", experiment.from, "Where in the motion to begin, s")->check(CLI::Range(0.0, 3600.0));
    command->add_option("--seconds", experiment.seconds, "Length, s (default 4)")->check(CLI::Range(0.1, 3600.0));
    command->add_option("--speed", experiment.speed, "Speed of the motion (default 1)")->check(CLI::Range(0.05, 20.0));
    command->add_option("--substeps", experiment.substeps, "Per 1/120 s, in motion and at rest (default 24)")
        ->check(CLI::Range(1, 100));
    command->add_option("--min-leaves", experiment.min_leaves, "Triangles at the start (default 6000)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--body-triangles", arguments->body_triangles, "Divide the body's triangles into so many")
        ->check(CLI::Range(1, 10'000'000));
    command->add_flag("!--no-self-collision", experiment.self_contact, "Let the cloth pass through itself");
    command->add_flag("--live", arguments->is_live, "Measure it in the editor's session too");
    command->add_flag("-q,--quiet", arguments->is_quiet, "Show no progress");
    command->callback([arguments, &exit_code] {
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
