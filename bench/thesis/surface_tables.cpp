#include "bench/thesis/surface_tables.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "bench/support/cloth_run.h"
#include "bench/support/table.h"
#include "bench/thesis/base_mesh.h"
#include "bench/thesis/labels.h"
#include "bench/thesis/thesis.h"
#include "sim/adaptive/criteria.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"
#include "sim/core/parallel.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {
namespace {

constexpr double kTurn = 0.8;  // rad/s, at which the viewer of back-face coarsening moves round the cloth

double clock_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// m, the largest displacement of a non-base vertex of `to` from its position in `from`. A vertex that `from` does not
// have counts from the midpoint of its edge in `from`.
double largest_move(const render::CurvedSurface& from, const render::CurvedSurface& to) {
    float most = 0;
    for (const sim::VertexId v : to.mesh.leaf_vertices()) {
        const sim::EdgeId parent = to.mesh.vertex(v).parent;
        if (!parent) continue;
        const bool was_there = parent.value < from.mesh.edges().capacity() && from.mesh.edge(parent).centre == v;
        const auto [a, b] = to.mesh.edge(parent).ends;
        const Vec4f before = was_there ? from.x[v.value] : Vec4f((from.x[a.value] + from.x[b.value]) * 0.5F);
        most = std::max(most, (to.x[v.value] - before).norm());
    }
    return static_cast<double>(most);
}

sim::ViewPoint viewer(SurfaceExperiment experiment, double time) {
    const render::Camera camera = surface_camera(experiment);
    const Eigen::AngleAxisf turn(static_cast<float>(kTurn * time), Vec3f::UnitY());
    return {.eye = camera.target + turn * (camera.eye - camera.target)};
}

class Run {
 public:
    Run(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options)
        : row_(row),
          scene_(make_surface_scene(experiment)),
          surface_(render::make_curved_surface(scene_.base, {.modifier = curve_modifier(options.kind)})),
          visibility_(viewer(experiment, 0)) {
        if (row.level) set_surface_level(surface_, *row.level);
    }

    void frame(SurfaceStatistics& sums) {
        sums.simulation_ms += 1e3 * time_once([&] { run_frame(scene_); });
        const render::CurvedSurface before = surface_;
        sums.surface_ms += 1e3 * time_once([&] { move(); });
        sums.triangles += static_cast<double>(surface_.mesh.leaf_triangles().size());
        if (!row_.level) sums.largest_jump_m = std::max(sums.largest_jump_m, jump_since(before));
    }

    const render::CurvedSurface& surface() const { return surface_; }

 private:
    void move() {
        const std::vector<Vec4f> normals = surface_normals(scene_.cloth);
        if (!row_.level) {
            visibility_.move_to(viewer(scene_.experiment, scene_.frames * kSurfaceFrame));
            adapt_surface(surface_, {.visibility = row_.coarsens_back_faces ? &visibility_ : nullptr, .glides = true});
        }
        update_surface(surface_, scene_.cloth.x, normals);
    }

    // Compares with the earlier surface moved to the same cloth, without splits, rejoins or gliding vertices.
    double jump_since(render::CurvedSurface before) const {
        move_surface(before, scene_.cloth.x, surface_normals(scene_.cloth), {.max_step = 0});
        return largest_move(before, surface_);
    }

    const SurfaceRow& row_;
    SurfaceScene scene_;
    render::CurvedSurface surface_;
    sim::Visibility visibility_;
};

}  // namespace

std::vector<SurfaceRow> surface_rows() {
    return {{.name = "level 0", .level = 0},
            {.name = "level 1", .level = 1},
            {.name = "level 2", .level = 2},
            {.name = "level 3", .level = 3},
            {.name = "adaptive"},
            {.name = "adaptive, back faces coarse", .coarsens_back_faces = true}};
}

std::vector<Vec4f> surface_normals(const sim::Cloth& coarse) {
    std::vector<Vec4f> normals;
    render::leaf_normals(coarse.mesh, coarse.x, normals);
    return normals;
}

SurfaceStatistics run_surface(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options,
                              render::Renderer& renderer) {
    Run run(experiment, row, options);
    SurfaceStatistics statistics;
    const long frames = std::max(1L, std::lround(options.seconds / kSurfaceFrame));
    const long interval = std::max(1L, frames / options.drawn_frames);
    long drawn = 0;
    for (long i = 1; i <= frames; ++i) {
        run.frame(statistics);
        if (i % interval != 0) continue;
        const sim::DrawMesh mesh = mesh_of(run.surface(), run.surface().light_normals);
        statistics.drawing_ms +=
            clock_ms([&] { keep(draw_surface(renderer, mesh, experiment, render::ShowMode::Edges, options.side_px)); });
        ++drawn;
    }
    // At twice the size, not timed: edges that are closer than a few pixels would fade.
    const sim::DrawMesh last = mesh_of(run.surface(), run.surface().light_normals);
    statistics.triangles_in_picture = last.triangles.size();
    statistics.picture = draw_surface(renderer, last, experiment, render::ShowMode::Edges, 2 * options.side_px);
    for (double* mean : {&statistics.triangles, &statistics.simulation_ms, &statistics.surface_ms})
        *mean /= static_cast<double>(frames);
    statistics.drawing_ms /= static_cast<double>(drawn);
    return statistics;
}

render::Camera surface_camera(SurfaceExperiment experiment) {
    if (experiment == SurfaceExperiment::Flag)
        return {.eye = Vec3f(0.75F, 1.5F, 4.2F), .target = Vec3f(0.6F, 1.25F, 0)};
    return {.eye = Vec3f(0.5F, 1.45F, 1.5F), .target = Vec3f(0, 1.24F, 0)};
}

sim::DrawMesh mesh_of(const render::CurvedSurface& surface, const std::vector<Vec4f>& normals) {
    sim::DrawMesh mesh;
    std::vector<std::uint32_t> places(surface.mesh.vertex_capacity());
    for (const sim::VertexId v : surface.mesh.leaf_vertices()) {
        places[v.value] = static_cast<std::uint32_t>(mesh.x.size());
        mesh.x.emplace_back(surface.x[v.value].head<3>());
        mesh.normals.emplace_back(normals[v.value].head<3>());
    }
    for (const sim::LeafTriangle& t : surface.mesh.leaf_triangles()) {
        mesh.triangles.push_back({places[t.v[0].value], places[t.v[1].value], places[t.v[2].value]});
        mesh.u.push_back(t.u);
        mesh.level.push_back(t.level);
    }
    return mesh;
}

render::Image draw_surface(render::Renderer& renderer, const sim::DrawMesh& mesh, SurfaceExperiment experiment,
                           render::ShowMode show, int side_px) {
    render::Scene scene;
    scene.cloths.push_back({.mesh = mesh, .sett = {}, .show = show});
    scene.camera = zoomed(surface_camera(experiment), 1.25F);
    scene.light = studio_light(scene.camera);
    scene.has_ground = false;
    return renderer.draw(scene, {.width_px = side_px, .height_px = side_px});
}

namespace {

constexpr double kSquareSide = 0.5;                  // m; gives edges of about 5 cm, as in garments
constexpr double kPinnedWidth = 0.8;                 // distance of the pinned corners, as a share of the side
constexpr double kFlagWidth = 1.2, kFlagDrop = 0.8;  // m

sim::Pattern rectangle(double width, double height) {
    sim::Panel panel;
    panel.name = "cloth";
    panel.vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    sim::Pattern pattern;
    pattern.panels = {panel};
    return pattern;
}

// With about `triangles` triangles; a flag of these proportions has 248 at best, not 250.
sim::GarmentMesh rectangle_of(double width, double height, int triangles) {
    constexpr double kUsual = 0.965;  // of the equilateral edge length: gives the square 250 triangles at once
    constexpr int kTolerance = 2;
    sim::Pattern pattern = rectangle(width, height);
    pattern.edge_length = kUsual * std::sqrt(width * height / triangles * 2.3094);  // m
    return assemble(pattern, {.target_edge = edge_length_for(pattern, triangles, kTolerance)});
}

// A square pinned at its upper corners, which are moved closer together. The cloth between them bulges forward, so that
// it keeps about its width.
sim::GarmentMesh pinned_square() {
    sim::GarmentMesh mesh = rectangle_of(kSquareSide, kSquareSide, kSurfaceTriangles);
    const double bulge = 2.8 / std::numbers::pi * std::sqrt(1 - kPinnedWidth) * kSquareSide;
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        Vec3d& x = mesh.x[i];
        const bool is_top = x.y() > kSquareSide - 1e-9;
        if (is_top && (x.x() < 1e-9 || x.x() > kSquareSide - 1e-9)) mesh.pins.push_back(static_cast<int>(i));
        const double across = x.x() / kSquareSide;
        x = Vec3d((across - 0.5) * kSquareSide * kPinnedWidth, x.y() + 1, bulge * std::sin(std::numbers::pi * across));
    }
    return mesh;
}

sim::GarmentMesh flag() {
    sim::GarmentMesh mesh = rectangle_of(kFlagWidth, kFlagDrop, kSurfaceTriangles);
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        if (mesh.x[i].x() < 1e-9) mesh.pins.push_back(static_cast<int>(i));
        mesh.x[i] += Vec3d(0, 1, 0.02 * std::sin(9 * mesh.x[i].x()));
    }
    return mesh;
}

// Strength (m/s) and direction vary with time; deterministic.
sim::Wind wind_at(double time) {
    const double strength = 6 + 1.5 * std::sin(1.9 * time) + std::sin(4.3 * time + 1);
    const double veer = 0.35 * std::sin(1.3 * time) + 0.25 * std::sin(3.7 * time + 2);
    return {.velocity = Vec3d(strength * std::cos(veer), 0.2, strength * std::sin(veer)).cast<float>()};
}

}  // namespace

SurfaceScene make_surface_scene(SurfaceExperiment experiment, int level) {
    sim::GarmentMesh base = experiment == SurfaceExperiment::Flag ? flag() : pinned_square();
    sim::Cloth cloth = make_cloth(base, {sim::find_fabric("cotton_shirting")});
    refresh_contacts(cloth);
    const sim::MinimumLevelDisc everywhere{.panel = 0, .centre = Vec2f::Zero(), .radius = 10, .level = level};
    adapt_cloth(cloth, sim::NoBody{},
                {.criteria = {.collision = false, .curvature = false, .length = false},
                 .minimum_levels = {&everywhere, 1},
                 .shortest_edge = 0},
                {});
    return {.experiment = experiment, .base = std::move(base), .cloth = std::move(cloth)};
}

void run_frame(SurfaceScene& scene) {
    const sim::StepOptions options{.extra_damping = scene.experiment == SurfaceExperiment::Flag ? 0.0F : 1.0F};
    for (int i = 0; i < kStepsPerFrame; ++i) {
        const float seconds = step_seconds(scene.cloth, options);
        if (scene.experiment == SurfaceExperiment::Flag)
            blow(scene.cloth, wind_at(scene.frames * kSurfaceFrame + i * static_cast<double>(seconds)), seconds);
        step(scene.cloth, sim::NoBody{}, options);
    }
    ++scene.frames;
}

void run_for(SurfaceScene& scene, double seconds) {
    const auto frames = std::lround(seconds / kSurfaceFrame);
    for (long i = 0; i < frames; ++i) run_frame(scene);
}

// Tables 6.2 and 6.3: coarse cloth drawn as a curved surface, with pictures (figures 6.8 and 6.9). 6.2-distance: the
// distance of the curved surface from cloth simulated on a fine mesh. Figure 6.6: lighting with interpolated and with
// recomputed normals.

namespace {

constexpr const char* kNote =
    "One thread. Means over the frames of 1/30 s: ms of four steps of the coarse cloth, of adapting and moving the "
    "surface, and, by the clock, of a picture (640x640, software renderer, all its threads). Jump: the farthest that "
    "a vertex moves in a frame because levels change. Constant modifier. The viewer of coarse back faces walks round "
    "the "
    "cloth. Last row: the cloth itself simulated at level 3.";

std::string letter(SurfaceExperiment experiment) {
    return experiment == SurfaceExperiment::Flag ? "B, a flag in the wind" : "A, a square pinned at two corners";
}

struct Shown {
    Table table;
    Capture sheet;
    Trend trend;
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

// Whether each finer level costs more surface and drawing, and the adaptive surface less than level 3.
Trend trend_of(const std::string& name, const std::vector<SurfaceStatistics>& rows) {
    const SurfaceStatistics &level3 = rows[3], &adaptive = rows[4], &level0 = rows[0];
    const auto surface = [](const SurfaceStatistics& row) { return row.surface_ms + row.drawing_ms; };
    const double share = adaptive.triangles / level3.triangles;
    const double cost = surface(adaptive) / surface(level3);
    return {.item = "T" + name,
            .reported =
                "the adaptive surface draws fewer triangles than level 3, and costs less; the simulation stays "
                "that of the coarse mesh.",
            .measured = "the adaptive surface draws " + Cell(100 * share, 0).to_text() + " % of level 3's triangles (" +
                        Cell(adaptive.triangles, 0).to_text() + " of " + Cell(level3.triangles, 0).to_text() +
                        "), surface and drawing take " + Cell(100 * cost, 0).to_text() +
                        " % of its time, and the simulation " + Cell(adaptive.simulation_ms, 2).to_text() + " ms (" +
                        Cell(level0.simulation_ms, 2).to_text() + " ms at level 0).",
            .agrees = share < 1 && cost < 1};
}

Shown show(const std::string& name, const std::string& figure, SurfaceExperiment experiment,
           const ThesisOptions& options) {
    const sim::ThreadLimit one(1);
    const SurfaceRunOptions running = run_options(experiment, options);
    Shown shown{.table = {.name = name,
                          .title = "The curved surface of experiment " + letter(experiment),
                          .note = kNote,
                          .columns = {"surface", "drawn triangles", "simulation, ms", "surface, ms", "ns per triangle",
                                      "drawing, ms", "largest jump, mm"}},
                .sheet = {figure, "sheet", {}},
                .trend = {}};
    render::Renderer renderer;
    std::vector<Tile> tiles;
    std::vector<SurfaceStatistics> rows;
    for (const SurfaceRow& row : surface_rows()) {
        const SurfaceStatistics& statistics = rows.emplace_back(run_surface(experiment, row, running, renderer));
        tiles.push_back({row.name + (row.coarsens_back_faces ? ", from behind: " : ": ") +
                             std::to_string(statistics.triangles_in_picture),
                         statistics.picture});
        shown.table.add_row(
            {row.name, Cell(statistics.triangles, 0), Cell(statistics.simulation_ms, 3), Cell(statistics.surface_ms, 3),
             Cell(1e6 * statistics.surface_ms / statistics.triangles, 1), Cell(statistics.drawing_ms, 1),
             row.level ? Cell() : Cell(1e3 * statistics.largest_jump_m, 3)});
    }
    shown.table.add_row(fine_row(experiment, running.seconds));
    shown.sheet.image = labelled_sheet(tiles, 3);
    shown.trend = trend_of(name, rows);
    return shown;
}

// Mean distance between vertices at the same material points, mm.
double mean_distance_mm(const render::CurvedSurface& drawn, const sim::Cloth& fine) {
    double sum = 0;
    for (const sim::VertexId v : drawn.mesh.leaf_vertices())
        sum += static_cast<double>((drawn.x[v.value] - fine.x[v.value]).norm());
    return 1e3 * sum / static_cast<double>(drawn.mesh.leaf_vertices().size());
}

// Both meshes are refined uniformly and in the same order, so that equal ids denote equal material points.
double distance_mm(const SurfaceScene& scene, render::SurfaceKind kind, const std::vector<Vec4f>& x,
                   const sim::Cloth& fine) {
    render::CurvedSurface surface = render::make_curved_surface(scene.base, {.modifier = curve_modifier(kind)});
    std::vector<Vec4f> normals;
    render::leaf_normals(surface.mesh, x, normals);
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
    for (int i = 0; i < render::kSurfaceKinds; ++i) {
        const auto kind = static_cast<render::SurfaceKind>(i);
        table.add_row({name(kind), Cell(distance_mm(coarse, kind, fine.cloth.x, fine.cloth), 3),
                       Cell(distance_mm(coarse, kind, coarse.cloth.x, fine.cloth), 3)});
    }
    return table;
}

Capture lighting(const ThesisOptions& options) {
    SurfaceScene scene = make_surface_scene(SurfaceExperiment::PinnedSquare);
    run_for(scene, options.is_quick ? 0.1 : 3);
    render::CurvedSurface surface =
        render::make_curved_surface(scene.base, {.modifier = curve_modifier(render::SurfaceKind::Quadratic)});
    set_surface_level(surface, 3);
    update_surface(surface, scene.cloth.x, surface_normals(scene.cloth));
    render::Renderer renderer;
    const auto drawn = [&](const std::vector<Vec4f>& normals) {
        return draw_surface(renderer, mesh_of(surface, normals), scene.experiment, render::ShowMode::Plain,
                            options.is_quick ? 96 : 640);
    };
    return {"6.6", "interpolated-recomputed",
            labelled_sheet({{"interpolated normals", drawn(surface.normals)},
                            {"recomputed normals", drawn(surface.light_normals)}},
                           2)};
}

}  // namespace

ThesisResult measure_curved_surface(const ThesisOptions& options) {
    ThesisResult result;
    for (Shown shown : {show("6.2", "6.8", SurfaceExperiment::PinnedSquare, options),
                        show("6.3", "6.9", SurfaceExperiment::Flag, options)}) {
        result.tables.push_back(std::move(shown.table));
        result.captures.push_back(std::move(shown.sheet));
        result.trends.push_back(std::move(shown.trend));
    }
    return result;
}

ThesisResult measure_surface_distance(const ThesisOptions& options) {
    return {.tables = {distances(options)}};
}

ThesisResult measure_surface_lighting(const ThesisOptions& options) {
    return {.captures = {lighting(options)}};
}

}  // namespace selvedge::bench
