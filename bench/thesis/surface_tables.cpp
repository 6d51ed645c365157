// Tables 6.2 and 6.3, cloth that is simulated coarse and drawn curved, with what they look like; 6.2-distance, how near
// that comes to the cloth simulated fine; figures 6.4 and 6.5, what a modifier does to a curve, and 6.6, which normals
// the light sees.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/contact_sheet.h"
#include "bench/thesis/surface_run.h"
#include "bench/thesis/thesis.h"
#include "bench/timing.h"
#include "sim/core/parallel.h"

namespace selvedge {
namespace {

constexpr const char* kNote =
    "One thread. Means over the frames of 1/30 s: ms of four steps of the coarse cloth, of adapting and moving the "
    "surface, and, by the clock, of a picture (640x640, software renderer, all its threads). Jump: the farthest that "
    "a vertex moves in a frame because levels change. Last row: the cloth itself simulated at level 3.";

std::string letter(SurfaceExperiment experiment) {
    return experiment == SurfaceExperiment::Flag ? "B, a flag in the wind" : "A, a square pinned at two corners";
}

struct Shown {
    Table table;
    Capture sheet;
};

SurfaceRunOptions run_options(SurfaceExperiment experiment, const ThesisOptions& options) {
    if (options.is_quick) return {.seconds = 0.2, .side_px = 96, .drawn_frames = 1};
    return {.seconds = experiment == SurfaceExperiment::Flag ? 4.0 : 3.0};
}

std::vector<Cell> fine_row(SurfaceExperiment experiment, double seconds) {
    SurfaceScene fine = make_surface_scene(experiment, 3);
    const double ms = 1e3 * time_once([&] { run_for(fine, seconds); });
    return {"simulated at level 3",
            fine.cloth.mesh.leaf_triangles().size(),
            Cell(ms / std::max(1, fine.frames), 3),
            {},
            {},
            {},
            {}};
}

Shown show(const std::string& name, SurfaceExperiment experiment, const ThesisOptions& options) {
    const ThreadLimit one(1);
    const SurfaceRunOptions running = run_options(experiment, options);
    Shown shown{.table = {.name = name,
                          .title = "The curved surface of experiment " + letter(experiment),
                          .note = kNote,
                          .columns = {"surface", "drawn triangles", "simulation, ms", "surface, ms", "ns per triangle",
                                      "drawing, ms", "largest jump, mm"}},
                .sheet = {name, "sheet", {}}};
    Renderer renderer;
    std::vector<Image> pictures;
    for (const SurfaceRow& row : surface_rows()) {
        const SurfaceFigures figures = run_surface(experiment, row, running, renderer);
        pictures.push_back(figures.picture);
        shown.table.add_row({row.name, Cell(figures.triangles, 0), Cell(figures.simulation_ms, 3),
                             Cell(figures.surface_ms, 3), Cell(1e6 * figures.surface_ms / figures.triangles, 1),
                             Cell(figures.drawing_ms, 1), row.level ? Cell() : Cell(1e3 * figures.largest_jump_m, 3)});
    }
    shown.table.add_row(fine_row(experiment, running.seconds));
    shown.sheet.image = contact_sheet(pictures, 3);
    return shown;
}

// Mean distance of vertices of the same material points, mm.
double mean_distance_mm(const CurvedSurface& drawn, const Cloth& fine) {
    double sum = 0;
    for (const VertexId v : drawn.mesh.leaf_vertices())
        sum += static_cast<double>((drawn.x[v.value] - fine.x[v.value]).norm());
    return 1e3 * sum / static_cast<double>(drawn.mesh.leaf_vertices().size());
}

// Both meshes are refined everywhere and in the same order, so that the same ids are the same points.
double distance_mm(const SurfaceScene& scene, SurfaceKind kind, const std::vector<Vec4f>& x, const Cloth& fine) {
    CurvedSurface surface = make_curved_surface(scene.base, {.modifier = curve_modifier(kind)});
    std::vector<Vec4f> normals;
    leaf_normals(surface.mesh, x, normals);
    set_surface_level(surface, 3);
    update_surface(surface, x, normals);
    return mean_distance_mm(surface, fine);
}

Table distances(const ThesisOptions& options) {
    Table table{
        .name = "6.2-distance",
        .title = "Experiment A at rest: mean distance to the cloth simulated at level 3, mm",
        .note =
            "Of the same material points. Sampled: the coarse vertices stand where the fine cloth has them, so "
            "that only the surface between them counts. Own: the coarse cloth was simulated by itself; it comes "
            "to rest in other folds, and how it is drawn hardly matters to that.",
        .columns = {"surface", "sampled", "own"}};
    const double seconds = options.is_quick ? 0.2 : 8;
    SurfaceScene coarse = make_surface_scene(SurfaceExperiment::PinnedSquare);
    SurfaceScene fine = make_surface_scene(SurfaceExperiment::PinnedSquare, 3);
    run_for(coarse, seconds);
    run_for(fine, seconds);
    for (int i = 0; i < kSurfaceKinds; ++i) {
        const auto kind = static_cast<SurfaceKind>(i);
        table.add_row({name(kind), Cell(distance_mm(coarse, kind, fine.cloth.x, fine.cloth), 3),
                       Cell(distance_mm(coarse, kind, coarse.cloth.x, fine.cloth), 3)});
    }
    return table;
}

// An edge of length 1 whose end normals lean out by 30 degrees.
CurveEnds arch(float r) {
    const float s = 0.5F, c = std::sqrt(0.75F);
    return {.a = Vec4f::Zero(),
            .b = Vec4f::UnitX(),
            .normal_a = Vec4f(-s, c, 0, 0),
            .normal_b = Vec4f(s, c, 0, 0),
            .rest_length = r};
}

float multiplier(SurfaceKind kind, float r) {
    if (kind != SurfaceKind::Restore) return modified(curve_modifier(kind), r);
    const CurveEnds ends = arch(r);
    return restoring(r, arc_over_chord(ends.b, ends.normal_a * 0.5F, ends.normal_b * 0.5F));
}

std::vector<std::string> with_kinds(const std::string& first) {
    std::vector<std::string> columns{first};
    for (int i = 0; i < kSurfaceKinds; ++i) columns.emplace_back(name(static_cast<SurfaceKind>(i)));
    return columns;
}

Figure modifiers() {
    Figure figure{.series = {.name = "6.4",
                             .title = "The curve modifier M by rest length over length",
                             .note = "Restore: of an arch of 30 degrees.",
                             .columns = with_kinds("r")},
                  .y_label = "M"};
    for (int i = 0; i <= 80; ++i) {
        const float r = 0.8F + 0.01F * static_cast<float>(i);
        std::vector<Cell> row{Cell(double(r), 2)};
        for (int k = 0; k < kSurfaceKinds; ++k) row.emplace_back(double(multiplier(static_cast<SurfaceKind>(k), r)), 4);
        figure.series.add_row(row);
    }
    return figure;
}

Figure curves() {
    Figure figure{.series = {.name = "6.5",
                             .title = "The curve of an edge a fifth shorter than its material, by modifier",
                             .note = "An edge of length 1 whose end normals lean out by 30 degrees.",
                             .columns = with_kinds("x")},
                  .y_label = "height"};
    const CurveWeights weights(5);
    for (std::size_t i = 0; i <= weights.steps(); ++i) {
        std::vector<Cell> row;
        for (int k = 0; k < kSurfaceKinds; ++k) {
            const EdgeCurve curve = make_edge_curve(arch(1.25F), curve_modifier(static_cast<SurfaceKind>(k)));
            const Vec4f point = weights.point(curve, i);
            if (row.empty()) row.emplace_back(static_cast<double>(i) / static_cast<double>(weights.steps()), 4);
            row.emplace_back(double(point.y()), 4);
        }
        figure.series.add_row(row);
    }
    return figure;
}

Capture lighting(const ThesisOptions& options) {
    SurfaceScene scene = make_surface_scene(SurfaceExperiment::PinnedSquare);
    run_for(scene, options.is_quick ? 0.1 : 3);
    CurvedSurface surface = make_curved_surface(scene.base, {.modifier = curve_modifier(SurfaceKind::Quadratic)});
    set_surface_level(surface, 3);
    update_surface(surface, scene.cloth.x, surface_normals(scene.cloth));
    Renderer renderer;
    std::vector<Image> pair;
    for (const auto* normals : {&surface.normals, &surface.light_normals})
        pair.push_back(draw_surface(renderer, mesh_of(surface, *normals), scene.experiment, ShowMode::Plain,
                                    options.is_quick ? 96 : 640));
    return {"6.6", "interpolated-recomputed", contact_sheet(pair, 2)};
}

}  // namespace

ThesisResult measure_curved_surface(const ThesisOptions& options) {
    ThesisResult result;
    for (const auto& [name, experiment] :
         {std::pair{"6.2", SurfaceExperiment::PinnedSquare}, std::pair{"6.3", SurfaceExperiment::Flag}}) {
        Shown shown = show(name, experiment, options);
        result.tables.push_back(std::move(shown.table));
        result.captures.push_back(std::move(shown.sheet));
    }
    return result;
}

ThesisResult measure_surface_distance(const ThesisOptions& options) {
    return {.tables = {distances(options)}, .figures = {}, .captures = {}};
}

ThesisResult measure_curve_modifiers(const ThesisOptions&) {
    return {.tables = {}, .figures = {modifiers(), curves()}, .captures = {}};
}

ThesisResult measure_surface_lighting(const ThesisOptions& options) {
    return {.tables = {}, .figures = {}, .captures = {lighting(options)}};
}

}  // namespace selvedge
