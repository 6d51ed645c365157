// Figures 3.23-3.24, pictures of adaptive drops, and 3.25-3.30, how long each frame takes while a cloth drops on an
// object and falls off it.
#include <cmath>

#include "bench/thesis/drop.h"
#include "bench/thesis/drop_picture.h"
#include "bench/thesis/thesis.h"

namespace selvedge {
namespace {

constexpr CriteriaOptions kAB{.collision = true, .curvature = true, .length = false};

struct Timed {
    const char* name;   // of the figure
    const char* title;  // what the cloth does to be fine enough
    DropOptions drop;
};

// The captions of the thesis' six figures are not to be had; these are ours, in an order of our own.
std::vector<Timed> timed_drops(const ThesisOptions& options) {
    std::vector<Timed> all;
    const std::vector<const char*> names{"3.25", "3.26", "3.27", "3.28", "3.29", "3.30"};
    for (const DropObject object : {DropObject::Cylinder, DropObject::Sphere}) {
        DropOptions drop{
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

Figure figure_of(const Timed& timed, const DropRun& run) {
    Figure figure;
    figure.series = {
        .name = timed.name,
        .title = std::string("Onto and off a ") + name_of(timed.drop.object) + ", " + timed.title,
        .note =
            "ms of each frame of 1/30 s: one adaption, four steps parted into simulation and "
            "collision, and rendering: making the arrays of vertices that the renderer draws.",
        .columns = {"time, s", "adaption, ms", "simulation, ms", "collision, ms", "rendering, ms", "triangles"}};
    figure.y_label = "ms";
    figure.right_column = "triangles";
    for (const DropFrame& frame : run.frames)
        figure.series.add_row({Cell(frame.time, 3), Cell(frame.adaption, 4), Cell(frame.steps - frame.collision, 4),
                               Cell(frame.collision, 4), Cell(frame.drawing, 4), frame.triangles});
    return figure;
}

}  // namespace

ThesisResult measure_drop_timings(const ThesisOptions& options) {
    ThesisResult result;
    for (const Timed& timed : timed_drops(options))
        result.figures.push_back(figure_of(timed, run_drop_repeatedly(timed.drop, options.is_quick ? 1 : 3)));
    return result;
}

ThesisResult measure_drop_captures(const ThesisOptions& options) {
    ThesisResult result;
    DropPainter painter(options.is_quick ? 96 : 640);
    for (const DropObject object : {DropObject::Cylinder, DropObject::Sphere}) {
        const std::string figure = object == DropObject::Cylinder ? "3.23" : "3.24";
        const double interval = options.is_quick ? 0.2 : 0.4;  // s
        int frame = 0;
        const auto capture = [&](const Cloth& cloth, double time) {
            if (++frame % std::lround(30 * interval) != 0) return;
            result.captures.push_back({figure, Cell(time, 1).to_text() + "s", painter.draw(cloth, object)});
        };
        run_drop({.object = object, .criteria = kAB, .seconds = 5 * interval, .watch = capture});
    }
    return result;
}

}  // namespace selvedge
