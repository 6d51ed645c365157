// Tables 3.12-3.13 (uniform drops), 3.14 (adaptive drops) and 3.1 (transitions in adaptive drops); figures 3.23-3.24
// (pictures) and 3.25-3.30 (times per frame).
#include <algorithm>
#include <cmath>

#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"

namespace selvedge::bench {
namespace {

constexpr int kStepsPerFrame = 4;

// Means over a run. Times in ms: per adaptation, per step, per frame.
struct Means {
    double triangles = 0;
    std::size_t max_triangles = 0;
    double adaptation = 0;
    double step = 0;
    double collision = 0;
    double frame = 0;
};

Means means_of(const ThesisDropRun& run) {
    Means means;
    for (const ThesisDropFrame& frame : run.frames) {
        means.triangles += static_cast<double>(frame.triangles);
        means.max_triangles = std::max(means.max_triangles, frame.triangles);
        means.adaptation += frame.adaptation;
        means.step += frame.steps / kStepsPerFrame;
        means.collision += frame.collision / kStepsPerFrame;
        means.frame += frame.adaptation + frame.steps;
    }
    const auto n = static_cast<double>(run.frames.size());
    for (double* mean : {&means.triangles, &means.adaptation, &means.step, &means.collision, &means.frame}) *mean /= n;
    return means;
}

int runs_of(const ThesisOptions& options) {
    return options.is_quick ? 1 : 3;
}

double seconds_of(const ThesisOptions& options) {
    return options.is_quick ? 0.4 : 3.0;
}

Table uniform_table(const std::string& name, ThesisDropObject object, const ThesisOptions& options) {
    Table table{.name = name,
                .title = std::string("Uniform drop on a ") + name_of(object),
                .note =
                    "Base mesh of 32 triangles, the same level everywhere. Means over the run: ms of an adaptation "
                    "pass (it asks each edge and changes nothing), of a step of 1/120 s with all it does, and of "
                    "the collision within it (what the step takes more than the same one with nothing near).",
                .columns = {"level", "triangles", "adaptation, ms", "step, ms", "of it collision, ms"}};
    for (int level = 0; level <= (options.is_quick ? 1 : 3); ++level) {
        const Means means = means_of(run_thesis_drop_repeatedly(
            {.object = object, .uniform_level = level, .seconds = seconds_of(options), .times_parts = true},
            runs_of(options)));
        table.add_row(
            {level, means.max_triangles, Cell(means.adaptation, 4), Cell(means.step, 4), Cell(means.collision, 4)});
    }
    return table;
}

struct Combination {
    const char* name;
    sim::CriteriaOptions criteria;
};

std::vector<Combination> combinations(const ThesisOptions& options) {
    const auto with = [](bool a, bool b, bool c) {
        return sim::CriteriaOptions{.collision = a, .curvature = b, .length = c};
    };
    std::vector<Combination> all{{"A", with(true, false, false)},  {"B", with(false, true, false)},
                                 {"C", with(false, false, true)},  {"A+B", with(true, true, false)},
                                 {"A+C", with(true, false, true)}, {"B+C", with(false, true, true)},
                                 {"A+B+C", with(true, true, true)}};
    if (options.is_quick) all = {all[0], all[6]};
    return all;
}

void add_counts(sim::TransitionCounts& sum, const sim::TransitionCounts& counts) {
    for (std::size_t from = 0; from < sim::kConfigurations; ++from)
        for (std::size_t to = 0; to < sim::kConfigurations; ++to)
            sum.by_configuration[from][to] += counts.by_configuration[from][to];
}

void add_drop_row(Table& table, ThesisDropObject object, const std::string& name, const ThesisDropRun& run,
                  const ThesisDropRun& uniform) {
    const Means means = means_of(run);
    table.add_row({name_of(object), name, Cell(means.triangles, 0), means.max_triangles, Cell(means.adaptation, 4),
                   Cell(means.step, 4), Cell(means.collision, 4), Cell(means.frame, 3),
                   Cell(means.frame / means_of(uniform).frame, 2), Cell(1e3 * mean_distance(run, uniform), 1)});
}

void add_adaptive_rows(Table& table, ThesisDropObject object, const ThesisOptions& options,
                       sim::TransitionCounts& transitions) {
    const int runs = runs_of(options);
    ThesisDropOptions drop{.object = object, .seconds = seconds_of(options), .times_parts = true};
    drop.uniform_level = options.is_quick ? 1 : 3;
    const ThesisDropRun uniform = run_thesis_drop_repeatedly(drop, runs);
    add_drop_row(table, object, "uniform", uniform, uniform);
    drop.shift = 0.001;
    add_drop_row(table, object, "uniform, shifted", run_thesis_drop_repeatedly(drop, runs), uniform);
    drop.shift = 0;
    drop.uniform_level.reset();
    for (const Combination& combination : combinations(options)) {
        drop.criteria = combination.criteria;
        const ThesisDropRun run = run_thesis_drop_repeatedly(drop, runs);
        add_drop_row(table, object, combination.name, run, uniform);
        add_counts(transitions, run.transitions);
    }
}

// Adds the transitions of cloths that fall off the object, among which coarsening is more frequent.
void add_falls(const ThesisOptions& options, sim::TransitionCounts& transitions) {
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere})
        for (const Combination& combination : combinations(options))
            add_counts(transitions, run_thesis_drop({.object = object,
                                                     .falls_off = true,
                                                     .criteria = combination.criteria,
                                                     .seconds = seconds_of(options)})
                                        .transitions);
}

std::string state_name(std::size_t state) {
    return "S" + std::to_string(state);
}

Table frequency_table(const sim::TransitionCounts& counts) {
    std::uint64_t total = 0;
    for (std::size_t from = 0; from < sim::kStates; ++from)
        for (std::size_t to = 0; to < sim::kStates; ++to) total += counts.between_states(from, to);
    const auto percent = [&](std::size_t from, std::size_t to) {
        return 100.0 * static_cast<double>(counts.between_states(from, to)) /
               static_cast<double>(std::max<std::uint64_t>(total, 1));
    };
    Table table{.name = "3.1",
                .title = "How often each transition was made, % of " + std::to_string(total),
                .note =
                    "Rows: from. Columns: to. Recorded over the adaptive runs of table 3.14, and as many that fall off "
                    "again. The thesis recorded "
                    "30,471 transitions, of which S0 to S7 9.1 % and S7 to S0 2.7 %; here " +
                    Cell(percent(0, 7), 1).to_text() + " % and " + Cell(percent(7, 0), 1).to_text() + " %.",
                .columns = {"from"}};
    for (std::size_t to = 0; to < sim::kStates; ++to) table.columns.push_back(state_name(to));
    table.columns.push_back("transitions");
    for (std::size_t from = 0; from < sim::kStates; ++from) {
        std::vector<Cell> row{state_name(from)};
        std::uint64_t sum = 0;
        for (std::size_t to = 0; to < sim::kStates; ++to) {
            row.push_back(Cell(percent(from, to), 2));
            sum += counts.between_states(from, to);
        }
        row.push_back(sum);
        table.add_row(std::move(row));
    }
    return table;
}

}  // namespace

ThesisResult measure_uniform_drops(const ThesisOptions& options) {
    ThesisResult result;
    result.tables = {uniform_table("3.12", ThesisDropObject::Cylinder, options),
                     uniform_table("3.13", ThesisDropObject::Sphere, options)};
    return result;
}

ThesisResult measure_adaptive_drops(const ThesisOptions& options) {
    Table table{.name = "3.14",
                .title = "Adaptive drops with the criteria A collision, B curvature, C edge length",
                .note =
                    "Base mesh of 32 triangles, at most level 3; a frame is one adaptation and four steps. Share: of "
                    "the uniform level 3's time. Distance: mean distance of the last drape from that of the "
                    "uniform run, over 33 x 33 material points; shifted: a uniform run that started 1 mm aside.",
                .columns = {"object", "criteria", "triangles, mean", "triangles, most", "adaptation, ms", "step, ms",
                            "of it collision, ms", "frame, ms", "share of uniform", "distance, mm"}};
    sim::TransitionCounts transitions;
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere})
        add_adaptive_rows(table, object, options, transitions);
    add_falls(options, transitions);
    ThesisResult result;
    result.tables = {frequency_table(transitions), table};
    return result;
}

// Figures 3.23-3.24: pictures of adaptive drops. Figures 3.25-3.30: the times of each frame while a cloth falls on an
// object and slides off it.

namespace {

constexpr sim::CriteriaOptions kAB{.collision = true, .curvature = true, .length = false};

struct Timed {
    const char* name;   // of the figure
    const char* title;  // how the mesh is refined
    ThesisDropOptions drop;
};

// These configurations differ from the thesis, whose figs. 3.25-3.30 show Cylinder [A], Sphere [A], Cylinder [B],
// Sphere [B], Sphere [A+B] and Sphere [C].
std::vector<Timed> timed_drops(const ThesisOptions& options) {
    std::vector<Timed> all;
    const std::vector<const char*> names{"3.25", "3.26", "3.27", "3.28", "3.29", "3.30"};
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere}) {
        ThesisDropOptions drop{
            .object = object, .falls_off = true, .seconds = options.is_quick ? 0.3 : 4.0, .times_parts = true};
        drop.uniform_level = options.is_quick ? 1 : 3;
        all.push_back({names[all.size()], "uniform", drop});
        drop.uniform_level.reset();
        drop.criteria = kAB;
        all.push_back({names[all.size()], "adaptive, A+B", drop});
        drop.criteria = {};
        all.push_back({names[all.size()], "adaptive, A+B+C", drop});
    }
    return all;
}

Figure figure_of(const Timed& timed, const ThesisDropRun& run) {
    Figure figure;
    figure.series = {
        .name = timed.name,
        .title = std::string("Onto and off a ") + name_of(timed.drop.object) + ", " + timed.title,
        .note =
            "ms of each frame of 1/30 s: one adaptation, four steps parted into simulation and "
            "collision, and rendering: making the arrays of vertices that the renderer draws.",
        .columns = {"time, s", "adaptation, ms", "simulation, ms", "collision, ms", "rendering, ms", "triangles"}};
    figure.y_label = "ms";
    figure.right_column = "triangles";
    for (const ThesisDropFrame& frame : run.frames)
        figure.series.add_row({Cell(frame.time, 3), Cell(frame.adaptation, 4), Cell(frame.steps - frame.collision, 4),
                               Cell(frame.collision, 4), Cell(frame.drawing, 4), frame.triangles});
    return figure;
}

}  // namespace

ThesisResult measure_drop_timings(const ThesisOptions& options) {
    ThesisResult result;
    for (const Timed& timed : timed_drops(options))
        result.figures.push_back(figure_of(timed, run_thesis_drop_repeatedly(timed.drop, options.is_quick ? 1 : 3)));
    return result;
}

ThesisResult measure_drop_captures(const ThesisOptions& options) {
    ThesisResult result;
    DropPainter painter(options.is_quick ? 96 : 640);
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere}) {
        const std::string figure = object == ThesisDropObject::Cylinder ? "3.23" : "3.24";
        const double interval = options.is_quick ? 0.2 : 0.4;  // s
        int frame = 0;
        const auto capture = [&](const sim::Cloth& cloth, double time) {
            if (++frame % std::lround(30 * interval) != 0) return;
            result.captures.push_back({figure, Cell(time, 1).to_text() + "s", painter.draw(cloth, object)});
        };
        run_thesis_drop({.object = object, .criteria = kAB, .seconds = 5 * interval, .watch = capture});
    }
    return result;
}

}  // namespace selvedge::bench
