// Tables 3.12-3.13 (uniform drops), 3.14 (adaptive drops) and 3.1 (transitions in adaptive drops); figures 3.23-3.24
// (pictures) and 3.25-3.30 (times per update).
#include <algorithm>
#include <array>

#include "bench/thesis/drop_trends.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"
#include "render/image/text.h"

namespace selvedge::bench {
namespace {

constexpr int kFramesPerPicture = 6;  // of the tables: drawing in software takes far longer than an update

// Means over a run. Times in ms per update.
struct Means {
    double triangles = 0;
    std::size_t max_triangles = 0;
    DropTimes wall;
    double update_cpu = 0;

    double step() const { return (wall.simulation + wall.collision) / kStepsPerFrame; }
};

Means means_of(const ThesisDropRun& run) {
    Means means;
    double pictures = 0;
    for (const ThesisDropFrame& frame : run.frames) {
        pictures += frame.wall.rendering > 0 ? 1 : 0;
        means.triangles += static_cast<double>(frame.triangles);
        means.max_triangles = std::max(means.max_triangles, frame.triangles);
        means.wall.adaptation += frame.wall.adaptation;
        means.wall.simulation += frame.wall.simulation;
        means.wall.collision += frame.wall.collision;
        means.wall.rendering += frame.wall.rendering;
        means.update_cpu += frame.update_cpu;
    }
    const auto n = static_cast<double>(run.frames.size());
    for (double* mean :
         {&means.triangles, &means.wall.adaptation, &means.wall.simulation, &means.wall.collision, &means.update_cpu})
        *mean /= n;
    means.wall.rendering /= std::max(1.0, pictures);
    return means;
}

int runs_of(const ThesisOptions& options) {
    return options.is_quick ? 1 : 3;
}

double seconds_of(const ThesisOptions& options) {
    return options.is_quick ? 0.4 : 3.0;
}

// Wide and high, of the pictures whose drawing is timed.
int side_px_of(const ThesisOptions& options) {
    return options.is_quick ? 64 : 512;
}

// The columns of times that all tables and figures of drops share, in this order.
const std::vector<std::string> kTimeColumns{"total update, ms", "simulation, ms", "collision, ms",
                                            "adaptation, ms",   "rendering, ms",  "total update CPU, ms"};

std::vector<std::string> with_times(std::vector<std::string> before, const std::vector<std::string>& after) {
    before.insert(before.end(), kTimeColumns.begin(), kTimeColumns.end());
    before.insert(before.end(), after.begin(), after.end());
    return before;
}

void add_times(std::vector<Cell>& row, const DropTimes& wall, double update_cpu) {
    for (const double ms : {wall.total_update(), wall.simulation, wall.collision, wall.adaptation, wall.rendering})
        row.emplace_back(ms, 4);
    row.emplace_back(update_cpu, 4);
}

constexpr const char* kUpdateNote =
    "Base mesh of 32 triangles, 1 m wide. An update is 1/30 s: one adaptation and four steps; the total is simulation, "
    "collision and adaptation. Collision: contact within the steps, timed where it happens. Rendering: one picture of "
    "the cloth, drawn offscreen by software. Wall-clock times on one thread, and the CPU time of the total. Settings: "
    "those of a garment's drape, without a floor, contact of cloth with cloth, or phases that calm the cloth.";

constexpr const char* kMassSpringNote =
    " Mass-spring: the thesis' own cloth (springs, bending elements, Verlet, length corrections after Provot at 10 %), "
    "with four sub-steps instead of twelve.";

const char* name_of(DropCloth cloth) {
    constexpr std::array<const char*, 3> kNames{"selvedge", "vertices only", "mass-spring"};
    return kNames[static_cast<std::size_t>(cloth)];
}

Table uniform_table(const std::string& name, ThesisDropObject object, const ThesisOptions& options) {
    Table table{.name = name,
                .title = std::string("Uniform drop on a ") + name_of(object) + ", ms per update",
                .note = std::string(kUpdateNote) + " The same level everywhere: the adaptation asks each edge and " +
                        "changes nothing. Vertices only: the same cloth without contact points between its vertices." +
                        kMassSpringNote,
                .columns = with_times({"cloth", "level", "triangles"}, {"of it each step, ms"})};
    DropPainter painter(side_px_of(options));
    for (const DropCloth cloth : {DropCloth::Selvedge, DropCloth::VerticesOnly, DropCloth::MassSpring}) {
        for (int level = 0; level <= (options.is_quick ? 1 : 3); ++level) {
            const Means means = means_of(run_thesis_drop_repeatedly({.object = object,
                                                                     .cloth = cloth,
                                                                     .uniform_level = level,
                                                                     .seconds = seconds_of(options),
                                                                     .painter = &painter,
                                                                     .frames_per_picture = kFramesPerPicture},
                                                                    runs_of(options)));
            std::vector<Cell> row{name_of(cloth), level, means.max_triangles};
            add_times(row, means.wall, means.update_cpu);
            row.emplace_back(means.step(), 4);
            table.add_row(std::move(row));
        }
    }
    return table;
}

constexpr sim::CriteriaOptions kA{.collision = true, .curvature = false, .length = false};
constexpr sim::CriteriaOptions kB{.collision = false, .curvature = true, .length = false};
constexpr sim::CriteriaOptions kC{.collision = false, .curvature = false, .length = true};
constexpr sim::CriteriaOptions kAB{.collision = true, .curvature = true, .length = false};

struct Combination {
    const char* name;
    sim::CriteriaOptions criteria;
};

std::vector<Combination> combinations(const ThesisOptions& options) {
    std::vector<Combination> all{{"A", kA},
                                 {"B", kB},
                                 {"C", kC},
                                 {"A+B", kAB},
                                 {"A+C", {.collision = true, .curvature = false, .length = true}},
                                 {"B+C", {.collision = false, .curvature = true, .length = true}},
                                 {"A+B+C", {.collision = true, .curvature = true, .length = true}}};
    if (options.is_quick) all = {all[0], all[6]};
    return all;
}

void add_counts(sim::TransitionCounts& sum, const sim::TransitionCounts& counts) {
    for (std::size_t from = 0; from < sim::kConfigurations; ++from)
        for (std::size_t to = 0; to < sim::kConfigurations; ++to)
            sum.by_configuration[from][to] += counts.by_configuration[from][to];
}

void add_drop_row(Table& table, const ThesisDropOptions& drop, const std::string& name, const ThesisDropRun& run,
                  const ThesisDropRun& uniform) {
    const Means means = means_of(run);
    std::vector<Cell> row{name_of(drop.object), name_of(drop.cloth), name, Cell(means.triangles, 0),
                          means.max_triangles};
    add_times(row, means.wall, means.update_cpu);
    row.emplace_back(means.update_cpu / means_of(uniform).update_cpu, 2);
    row.emplace_back(1e3 * mean_distance(run, uniform), 1);
    row.emplace_back(mean_bend(run), 2);
    table.add_row(std::move(row));
}

// The rows of one cloth on one object; its transitions are counted if it is this program's.
void add_adaptive_rows(Table& table, ThesisDropOptions drop, const ThesisOptions& options,
                       sim::TransitionCounts& transitions) {
    const int runs = runs_of(options);
    drop.uniform_level = options.is_quick ? 1 : 3;
    const ThesisDropRun uniform = run_thesis_drop_repeatedly(drop, runs);
    add_drop_row(table, drop, "uniform", uniform, uniform);
    if (drop.cloth == DropCloth::Selvedge) {
        drop.shift = 0.001;
        add_drop_row(table, drop, "uniform, shifted", run_thesis_drop_repeatedly(drop, runs), uniform);
        drop.shift = 0;
    }
    drop.uniform_level.reset();
    for (const Combination& combination : combinations(options)) {
        drop.criteria = combination.criteria;
        const ThesisDropRun run = run_thesis_drop_repeatedly(drop, runs);
        add_drop_row(table, drop, combination.name, run, uniform);
        if (drop.cloth == DropCloth::Selvedge) add_counts(transitions, run.transitions);
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
    result.trends = drop_trends(result);
    return result;
}

ThesisResult measure_adaptive_drops(const ThesisOptions& options) {
    Table table{.name = "3.14",
                .title = "Adaptive drops with the criteria A collision, B curvature, C edge length, ms per update",
                .note = std::string(kUpdateNote) + kMassSpringNote +
                        " At most level 3. Share: of the CPU time of the same cloth's uniform level 3. Distance: mean "
                        "distance of the last drape from that of the uniform run, over 33 x 33 material points; "
                        "shifted: a uniform run that started 1 mm aside. Bend: mean turning angle per length over "
                        "these points, more where there are more wrinkles.",
                .columns = with_times({"object", "cloth", "criteria", "triangles, mean", "triangles, most"},
                                      {"share of uniform", "distance, mm", "bend, 1/m"})};
    sim::TransitionCounts transitions;
    DropPainter painter(side_px_of(options));
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere})
        for (const DropCloth cloth : {DropCloth::Selvedge, DropCloth::MassSpring})
            add_adaptive_rows(table,
                              {.object = object,
                               .cloth = cloth,
                               .seconds = seconds_of(options),
                               .painter = &painter,
                               .frames_per_picture = kFramesPerPicture},
                              options, transitions);
    add_falls(options, transitions);
    ThesisResult result;
    result.tables = {frequency_table(transitions), table};
    result.trends = drop_trends(result);
    return result;
}

// Figures 3.23-3.24: pictures of adaptive drops. Figures 3.25-3.30: the times of each update while a cloth falls on an
// object and slides off it.

namespace {

struct Timed {
    const char* name;   // of the figure
    const char* title;  // the thesis' own
    ThesisDropObject object;
    sim::CriteriaOptions criteria;
};

constexpr std::array<Timed, 6> kTimed{{{"3.25", "Cylinder [A]", ThesisDropObject::Cylinder, kA},
                                       {"3.26", "Sphere [A]", ThesisDropObject::Sphere, kA},
                                       {"3.27", "Cylinder [B]", ThesisDropObject::Cylinder, kB},
                                       {"3.28", "Sphere [B]", ThesisDropObject::Sphere, kB},
                                       {"3.29", "Sphere [A+B]", ThesisDropObject::Sphere, kAB},
                                       {"3.30", "Sphere [C]", ThesisDropObject::Sphere, kC}}};

constexpr const char* kFarNote =
    " Without A, coarse triangles have contact points between their vertices, and these take time also where the cloth "
    "is far from the object.";

Figure figure_of(const Timed& timed, const ThesisDropRun& run) {
    Figure figure;
    figure.series = {.name = timed.name,
                     .title = std::string(timed.title) + ": each update of a cloth that falls on it and slides off",
                     .note = std::string(kUpdateNote) +
                             " Friction is a fifth of the fabric's, so that the cloth slides." +
                             (timed.criteria.collision ? "" : kFarNote),
                     .columns = with_times({"time, s"}, {"triangles"})};
    figure.y_label = "ms";
    figure.is_y_logarithmic = true;  // drawing in software takes far longer than an update
    figure.right_column = "triangles";
    for (const ThesisDropFrame& frame : run.frames) {
        std::vector<Cell> row{Cell(frame.time, 3)};
        add_times(row, frame.wall, frame.update_cpu);
        row.emplace_back(frame.triangles);
        figure.series.add_row(std::move(row));
    }
    return figure;
}

}  // namespace

ThesisResult measure_drop_timings(const ThesisOptions& options) {
    ThesisResult result;
    DropPainter painter(side_px_of(options));
    for (const Timed& timed : kTimed) {
        const ThesisDropOptions drop{.object = timed.object,
                                     .falls_off = true,
                                     .criteria = timed.criteria,
                                     .seconds = options.is_quick ? 0.3 : 3.0,
                                     .painter = &painter};
        result.figures.push_back(figure_of(timed, run_thesis_drop_repeatedly(drop, runs_of(options))));
    }
    result.trends = drop_trends(result);
    return result;
}

namespace {

render::Image labelled(render::Image image, const std::string& label) {
    draw_text(image, 8, 8, label, {.scale = std::max(1, image.width_px / 200)});
    return image;
}

// Figure 3.23: moments of a cloth that lands on the sphere and slides off it.

// m from the sphere: from there on no edge of the base mesh, of 35 cm or less, cuts it: sqrt(R^2 + (L/2)^2) - R.
constexpr float kOutOfReach = 0.06F;

// Of the refined leaf triangles, those of which all corners are out of reach of the sphere.
struct RefinedCount {
    std::size_t all = 0, out_of_reach = 0;
};

void count_refined(const sim::Cloth& cloth, RefinedCount& count) {
    const auto is_away = [&](sim::VertexId v) { return cloth.x[v.value].head<3>().norm() > kDropRadius + kOutOfReach; };
    for (const sim::LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        if (t.level == 0) continue;
        ++count.all;
        count.out_of_reach += std::ranges::all_of(t.v, is_away) ? 1 : 0;
    }
}

Trend coarsening_trend(const ThesisDropRun& run, const RefinedCount& refined) {
    constexpr double kFew = 0.05;
    std::size_t most = 0, away = 0, still_refined = 0;
    for (const ThesisDropFrame& frame : run.frames) {
        most = std::max(most, frame.triangles);
        const bool is_away = most > run.frames.front().triangles && frame.gap > static_cast<double>(kOutOfReach);
        away += is_away ? 1 : 0;
        still_refined += is_away && frame.triangles > run.frames.front().triangles ? 1 : 0;
    }
    const double share =
        static_cast<double>(refined.out_of_reach) / static_cast<double>(std::max<std::size_t>(1, refined.all));
    return {.item = "F3.23",
            .reported = "parts of the cloth that are no longer in contact coarsen at once.",
            .measured = "at most " + std::to_string(most) + " triangles; of the refined ones " +
                        Cell(100 * share, 1).to_text() + " % lie wholly more than 6 cm from the sphere (alike: up to " +
                        Cell(100 * kFew, 0).to_text() + " %), and " + std::to_string(still_refined) + " of the " +
                        std::to_string(away) + " frames in which the whole cloth does have any.",
            .agrees = refined.all > 0 && away > 0 && still_refined == 0 && share <= kFew};
}

void capture_coarsening(DropPainter& painter, const ThesisOptions& options, ThesisResult& result) {
    constexpr std::size_t kPictures = 6;
    const int interval = options.is_quick ? 3 : 5;  // frames between pictures
    std::vector<render::Image> pictures;
    RefinedCount refined;
    int frame = 0;
    const auto capture = [&](const sim::Cloth& cloth, double time) {
        count_refined(cloth, refined);
        if (++frame % interval != 0 || pictures.size() == kPictures) return;
        const std::string label =
            Cell(time, 2).to_text() + " s, " + std::to_string(cloth.mesh.leaf_triangles().size()) + " triangles";
        pictures.push_back(labelled(painter.draw(cloth, ThesisDropObject::Sphere), label));
    };
    const ThesisDropRun run = run_thesis_drop({.object = ThesisDropObject::Sphere,
                                               .falls_off = true,
                                               .criteria = kA,
                                               .seconds = 9 * interval / 30.0,
                                               .watch = capture});
    result.captures.push_back({"3.23", "sphere-A", contact_sheet(pictures, 3)});
    result.trends.push_back(coarsening_trend(run, refined));
}

// Figure 3.24: the last moment of the runs of table 3.14, spheres above, cylinders below.
Capture capture_combinations(DropPainter& painter, const ThesisOptions& options) {
    std::vector<render::Image> pictures;
    const std::vector<Combination> all = combinations(options);
    for (const ThesisDropObject object : {ThesisDropObject::Sphere, ThesisDropObject::Cylinder}) {
        for (const Combination& combination : all) {
            render::Image last;
            const double end = seconds_of(options);
            const auto capture = [&](const sim::Cloth& cloth, double time) {
                if (time > end - 0.5 / 30) last = painter.draw(cloth, object);
            };
            run_thesis_drop({.object = object, .criteria = combination.criteria, .seconds = end, .watch = capture});
            pictures.push_back(labelled(std::move(last), combination.name));
        }
    }
    return {"3.24", "combinations", contact_sheet(pictures, static_cast<int>(all.size()))};
}

}  // namespace

ThesisResult measure_drop_captures(const ThesisOptions& options) {
    ThesisResult result;
    DropPainter painter(options.is_quick ? 96 : 400);
    capture_coarsening(painter, options, result);
    result.captures.push_back(capture_combinations(painter, options));
    return result;
}

}  // namespace selvedge::bench
