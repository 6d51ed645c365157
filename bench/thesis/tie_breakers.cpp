// Figure 3.9: the four ways to choose between two diagonals, as pictures side by side and in numbers.
#include <array>
#include <cmath>

#include "bench/thesis/labels.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"

namespace selvedge::bench {
namespace {

struct TieBreaker {
    const char* name;
    DiagonalChoice choice;
};

constexpr std::array<TieBreaker, 4> kTieBreakers{{{"least work", DiagonalChoice::MinimalChange},
                                                  {"length", DiagonalChoice::Length},
                                                  {"rest length", DiagonalChoice::RestLength},
                                                  {"curvature", DiagonalChoice::Curvature}}};
constexpr const char* kTieBreakerFigure = "3.9";

struct Statistics {
    double triangles = 0;   // mean over the frames
    double adaptation = 0;  // ms, mean
    double frame = 0;       // ms, mean
    double distance = 0;    // mm, of the last drape from the uniform run's
    std::uint64_t transitions = 0;
};

std::uint64_t total(const sim::TransitionCounts& counts) {
    std::uint64_t sum = 0;
    for (const auto& row : counts.by_configuration)
        for (const std::uint64_t n : row) sum += n;
    return sum;
}

Statistics statistics_of(const ThesisDropRun& run, const ThesisDropRun& uniform) {
    Statistics sum{.distance = 1e3 * mean_distance(run, uniform), .transitions = total(run.transitions)};
    const auto n = static_cast<double>(run.frames.size());
    for (const ThesisDropFrame& frame : run.frames) {
        sum.triangles += static_cast<double>(frame.triangles) / n;
        sum.adaptation += frame.wall.adaptation / n;
        sum.frame += frame.wall.total_update() / n;
    }
    return sum;
}

// The largest difference of the mean triangle counts from that of the default, as a share of it.
double spread(const std::vector<Statistics>& all) {
    double most = 0;
    for (const Statistics& one : all)
        most = std::max(most, std::abs(one.triangles - all.front().triangles) / all.front().triangles);
    return most;
}

}  // namespace

ThesisResult measure_tie_breakers(const ThesisOptions& options) {
    constexpr double kAlike = 0.05;
    Table table{.name = "figure-3.9",
                .title = "What decides between two diagonals where either would do",
                .note =
                    "Drops with the criteria A and B, as in table 3.14; means over the frames. Least work is the "
                    "default. Distance: of the last drape from the uniform run's.",
                .columns = {"object", "tie-breaker", "triangles", "transitions", "adaptation, ms", "frame, ms",
                            "distance, mm"}};
    ThesisResult result;
    DropPainter painter(options.is_quick ? 96 : 640);
    double widest = 0;
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere}) {
        ThesisDropOptions drop{.object = object, .seconds = options.is_quick ? 0.3 : 3.0};
        drop.uniform_level = options.is_quick ? 1 : 3;
        const ThesisDropRun uniform = run_thesis_drop(drop);
        drop.uniform_level.reset();
        drop.criteria = {.collision = true, .curvature = true, .length = false};
        std::vector<Statistics> all;
        std::vector<Tile> tiles;
        for (const TieBreaker& tie_breaker : kTieBreakers) {
            drop.diagonal = tie_breaker.choice;
            render::Image last;
            drop.watch = [&](const sim::Cloth& cloth, double time) {
                if (time > drop.seconds - 0.02) last = painter.draw(cloth, object);
            };
            const Statistics& one = all.emplace_back(statistics_of(run_thesis_drop(drop), uniform));
            tiles.push_back({std::string(tie_breaker.name) + ", " + name_of(object), std::move(last)});
            table.add_row({name_of(object), tie_breaker.name, Cell(one.triangles, 0), one.transitions,
                           Cell(one.adaptation, 4), Cell(one.frame, 3), Cell(one.distance, 1)});
        }
        widest = std::max(widest, spread(all));
        result.captures.push_back({kTieBreakerFigure, name_of(object), labelled_sheet(tiles, 2)});
    }
    result.tables = {table};
    result.trends = {{.item = "F3.9",
                      .reported = "the four refinements are very similar, so that the default is valid.",
                      .measured = "mean triangle counts differ from the default's by at most " +
                                  Cell(100 * widest, 1).to_text() + " % (alike: up to " +
                                  Cell(100 * kAlike, 0).to_text() + " %).",
                      .agrees = widest <= kAlike}};
    return result;
}

}  // namespace selvedge::bench
