// Experiment C of chapter 6: a dress of 488 triangles, simulated on a walking character and drawn as a curved surface.
// Table 6.4 and figure 6.10: levels 0 to 3 and adaptive; figure 6.7: the curve modifiers at level 2.  (thesis 6.3)
#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "bench/support/cloth_run.h"
#include "bench/thesis/character_painter.h"
#include "bench/thesis/character_run.h"
#include "bench/thesis/labels.h"
#include "bench/thesis/surface_tables.h"
#include "bench/thesis/thesis.h"
#include "render/surface/adapt_surface.h"
#include "render/surface/curve.h"

namespace selvedge::bench {
namespace {

constexpr float kSurfaceOffset = 0.003F;  // m, that the cloth keeps from the body, and so does the surface

// One row of table 6.4: a curved surface over the coarse dress.
class DrawnSurface {
 public:
    DrawnSurface(const DressedCharacter& character, SurfaceRow row)
        : row_(std::move(row)),
          surface_(render::make_curved_surface(character.base,
                                               {.modifier = curve_modifier(render::SurfaceKind::Quadratic)})),
          visibility_({}) {
        if (row_.level) set_surface_level(surface_, *row_.level);
    }

    // Returns ms of CPU time.
    double move(const CharacterRun& run) {
        return 1e3 * time_once([&] {
                   render::leaf_normals(run.cloth().mesh, run.cloth().x, normals_);
                   if (!row_.level) {
                       visibility_.move_to({.eye = viewer_of(run.body_x())});
                       adapt_surface(surface_,
                                     {.visibility = row_.coarsens_back_faces ? &visibility_ : nullptr, .glides = true});
                   }
                   update_surface(surface_, run.cloth().x, normals_,
                                  {.body = &run.collider(), .offset = kSurfaceOffset});
               });
    }

    const SurfaceRow& row() const { return row_; }
    sim::DrawMesh mesh() const { return mesh_of(surface_, surface_.light_normals); }
    std::size_t triangles() const { return surface_.mesh.leaf_triangles().size(); }

 private:
    SurfaceRow row_;
    render::CurvedSurface surface_;
    sim::Visibility visibility_;
    std::vector<Vec4f> normals_;
};

// ms per frame of 1/30 s.
struct Range {
    double sum = 0, least = std::numeric_limits<double>::infinity(), most = 0;

    void add(double value) {
        sum += value;
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

struct SurfaceSums {
    double triangles = 0, surface = 0, drawing = 0;
    render::Image lit{}, edges{};
};

class DressDrawing {
 public:
    DressDrawing(const DressedCharacter& character, const ThesisOptions& options)
        : painter_(*character.body, options.is_quick ? 96 : 640), run_(character, {.level = 0}) {
        frames_ = options.is_quick ? 2 : 120;
        warm_frames_ = options.is_quick ? 1 : static_cast<int>(kWalkStart * 30);
        pictures_ = options.is_quick ? 1 : 3;
        for (const SurfaceRow& row : surface_rows()) surfaces_.emplace_back(character, row);
        sums_.resize(surfaces_.size());
    }

    void measure() {
        CharacterTimes ignored;
        for (int i = 0; i < warm_frames_; ++i) run_.frame(ignored);
        for (int i = 1; i <= frames_; ++i) {
            CharacterTimes times;
            run_.frame(times);
            collision_.add(times.collision);
            simulation_ += times.simulation + times.collision;
            for (std::size_t row = 0; row < surfaces_.size(); ++row) {
                sums_[row].surface += surfaces_[row].move(run_);
                sums_[row].triangles += static_cast<double>(surfaces_[row].triangles());
                if (i % (frames_ / pictures_) == 0) draw(row, i == frames_);
            }
        }
    }

    Table table(const DressedCharacter& character) const {
        Table table{.name = "6.4",
                    .title = "The curved surface of experiment C, a dress on an animated character",
                    .note = std::to_string(character.base.triangles.size()) +
                            " coarse triangles, simulated once for all rows: the simulation is that of four steps of "
                            "1/120 s, with collision; the range is that of the collision over the frames. Means over 4 "
                            "s of walking, per "
                            "frame of 1/30 s; CPU time of one thread. Surface: adaptation and update, kept out of the "
                            "body. Drawing: a picture of dress and body (640 px high, software renderer, all its "
                            "threads) by the clock. Quadratic modifier. The viewer of the last row stands in front.",
                    .columns = {"surface", "drawn triangles", "coarse simulation, ms", "of it collision, ms",
                                "range of the collision, ms", "surface, ms", "drawing, ms"}};
        const std::string range = Cell(collision_.least, 2).to_text() + " to " + Cell(collision_.most, 2).to_text();
        for (std::size_t i = 0; i < surfaces_.size(); ++i)
            table.add_row({surfaces_[i].row().name, Cell(sums_[i].triangles / frames_, 0),
                           Cell(simulation_ / frames_, 2), Cell(collision_.sum / frames_, 2), range,
                           Cell(sums_[i].surface / frames_, 3), Cell(sums_[i].drawing / pictures_, 1)});
        return table;
    }

    Trend trend() const {
        const SurfaceSums &level3 = sums_[3], &adaptive = sums_[4], &coarse_back = sums_[5];
        return {.item = "T6.4",
                .reported =
                    "the adaptive surfaces draw fewer triangles than level 3, with back-face coarsening the "
                    "fewest.",
                .measured = Cell(level3.triangles / frames_, 0).to_text() + " triangles at level 3, " +
                            Cell(adaptive.triangles / frames_, 0).to_text() + " adaptive, " +
                            Cell(coarse_back.triangles / frames_, 0).to_text() + " with coarse back faces.",
                .agrees = coarse_back.triangles < adaptive.triangles && adaptive.triangles < level3.triangles};
    }

    Capture sheet() const {
        std::vector<Tile> tiles;
        for (render::Image SurfaceSums::*picture : {&SurfaceSums::lit, &SurfaceSums::edges}) {
            for (std::size_t i = 0; i < surfaces_.size(); ++i)
                tiles.push_back(
                    {surfaces_[i].row().name + ": " + std::to_string(surfaces_[i].triangles()), sums_[i].*picture});
        }
        return {"6.10", "surfaces", labelled_sheet(tiles, 3)};
    }

    // Figure 6.7, where the run is now.
    Capture modifiers(const DressedCharacter& character) {
        constexpr int kKinds = 5;  // flat, constant, linear, quadratic, cubic
        std::vector<Vec4f> normals;
        render::leaf_normals(run_.cloth().mesh, run_.cloth().x, normals);
        std::vector<Tile> tiles;
        for (int i = 0; i < kKinds; ++i) {
            const auto kind = static_cast<render::SurfaceKind>(i);
            render::CurvedSurface surface =
                render::make_curved_surface(character.base, {.modifier = curve_modifier(kind)});
            set_surface_level(surface, 2);
            update_surface(surface, run_.cloth().x, normals, {.body = &run_.collider(), .offset = kSurfaceOffset});
            tiles.push_back({name(kind), picture(mesh_of(surface, surface.light_normals), render::ShowMode::Plain, 2)});
        }
        return {"6.7", "modifiers", labelled_sheet(tiles, kKinds)};
    }

 private:
    render::Image picture(const sim::DrawMesh& mesh, render::ShowMode show, int scale) {
        return painter_.draw({.dress = &mesh, .body_x = run_.body_x(), .show = show, .place = place_of(run_.body_x())},
                             {.azimuth = 0, .elevation = 0.05F}, scale);
    }

    // Those that are kept are larger and not timed: edges that are closer than a few pixels would fade.
    void draw(std::size_t row, bool is_last) {
        const sim::DrawMesh mesh = surfaces_[row].mesh();
        sums_[row].drawing += 1e3 * time_both([&] { keep(picture(mesh, render::ShowMode::Plain, 1)); }).wall;
        if (!is_last) return;
        sums_[row].lit = picture(mesh, render::ShowMode::Plain, 2);
        sums_[row].edges = picture(mesh, render::ShowMode::Edges, 2);
    }

    CharacterPainter painter_;
    CharacterRun run_;
    std::vector<DrawnSurface> surfaces_;
    std::vector<SurfaceSums> sums_;
    double simulation_ = 0;  // ms, with collision
    Range collision_;
    int frames_ = 0, warm_frames_ = 0, pictures_ = 0;
};

}  // namespace

ThesisResult measure_dress_surface(const ThesisOptions& options) {
    const DressedCharacter character = make_dressed_character(options);
    DressDrawing drawing(character, options);
    drawing.measure();
    return {.tables = {drawing.table(character)},
            .captures = {drawing.sheet(), drawing.modifiers(character)},
            .trends = {drawing.trend()}};
}

}  // namespace selvedge::bench
