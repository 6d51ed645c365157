// Figure 3.9: the four ways to choose between two diagonals, side by side.
#include "bench/thesis/drop.h"
#include "bench/thesis/thesis.h"

namespace selvedge {
namespace {

struct TieBreaker {
    const char* name;
    DiagonalChoice choice;
};

constexpr std::array<TieBreaker, 4> kTieBreakers{{{"least work", DiagonalChoice::LeastWork},
                                                  {"length", DiagonalChoice::Length},
                                                  {"rest length", DiagonalChoice::RestLength},
                                                  {"curvature", DiagonalChoice::Curvature}}};

std::uint64_t total(const TransitionCounts& counts) {
    std::uint64_t sum = 0;
    for (const auto& row : counts.by_configuration)
        for (const std::uint64_t n : row) sum += n;
    return sum;
}

void add_row(Table& table, DropObject object, const TieBreaker& tie_breaker, const DropRun& run,
             const DropRun& uniform) {
    double triangles = 0, adaption = 0, steps = 0;
    for (const DropFrame& frame : run.frames) {
        triangles += static_cast<double>(frame.triangles);
        adaption += frame.adaption;
        steps += frame.steps;
    }
    const auto n = static_cast<double>(run.frames.size());
    table.add_row({name_of(object), tie_breaker.name, Cell(triangles / n, 0), total(run.transitions),
                   Cell(adaption / n, 4), Cell((adaption + steps) / n, 3), Cell(1e3 * mean_distance(run, uniform), 1)});
}

}  // namespace

ThesisResult measure_tie_breakers(const ThesisOptions& options) {
    Figure figure;
    figure.is_plotted = false;
    figure.series = {.name = "3.9",
                     .title = "What decides between two diagonals where either would do",
                     .note =
                         "Drops with the criteria A and B, as in table 3.14. Least work is the default; the thesis "
                         "judged the others no better. Distance: of the last drape from the uniform run's.",
                     .columns = {"object", "tie-breaker", "triangles, mean", "transitions", "adaption, ms", "frame, ms",
                                 "distance, mm"}};
    const int runs = options.is_quick ? 1 : 3;
    for (const DropObject object : {DropObject::Cylinder, DropObject::Sphere}) {
        DropOptions drop{.object = object, .seconds = options.is_quick ? 0.3 : 3.0};
        drop.uniform_level = options.is_quick ? 1 : 3;
        const DropRun uniform = run_drop(drop);
        drop.uniform_level.reset();
        drop.criteria = {.collision = true, .curvature = true, .length = false};
        for (const TieBreaker& tie_breaker : kTieBreakers) {
            drop.diagonal = tie_breaker.choice;
            add_row(figure.series, object, tie_breaker, run_drop_repeatedly(drop, runs), uniform);
        }
    }
    ThesisResult result;
    result.figures = {figure};
    return result;
}

}  // namespace selvedge
