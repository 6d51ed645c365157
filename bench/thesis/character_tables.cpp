// Tables 5.1 to 5.4 and figures 5.5 to 5.11: a dress that is fixed at the shoulders on a walking character; the cost of
// the character, of the cloth at each level and adaptive, and of collision by the thesis' cylinders and spheres and by
// our hierarchy.  (thesis 5.6)
#include "bench/thesis/character_tables.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "bench/support/cloth_run.h"
#include "bench/support/plot.h"
#include "bench/support/svg.h"
#include "bench/thesis/character_painter.h"
#include "bench/thesis/cloth_property.h"
#include "bench/thesis/labels.h"
#include "bench/thesis/thesis.h"
#include "render/scene/solids.h"
#include "sim/cloth/cloth_penetration.h"

namespace selvedge::bench {
namespace {

constexpr render::Direction kFront{.azimuth = 0, .elevation = 0.05F};
constexpr render::Direction kFromSide{.azimuth = 1.5708F, .elevation = 0.05F};
constexpr render::Direction kBack{.azimuth = 3.1416F, .elevation = 0.05F};

constexpr const char* kScene =
    "A dress on a body that walks (the mannequin and the shipped motion, unless --body names another), fixed at the "
    "shoulders; cotton shirting; no contact of cloth with cloth. ";

double wall_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int picture_px(const ThesisOptions& options) {
    return options.is_quick ? 96 : 640;
}

sim::DrawMesh dress_mesh_of(const DressedCharacter& character, const sim::Cloth& cloth) {
    return draw_mesh(cloth, character.panel_names);
}

// Pictures of a dress where a run is: lit, and with its triangles coloured by level.
class RunPainter {
 public:
    RunPainter(const DressedCharacter& character, int height_px)
        : character_(character), painter_(*character.body, height_px) {}

    render::Image draw(const CharacterRun& run, render::ShowMode show, const render::Direction& from,
                       std::vector<render::SolidItem> solids) {
        const sim::DrawMesh mesh = dress_mesh_of(character_, run.cloth());
        return painter_.draw({.dress = &mesh,
                              .body_x = run.body_x(),
                              .show = show,
                              .solids = std::move(solids),
                              .place = place_of(run.body_x())},
                             from);
    }

    // ms by the clock.
    double dress_alone(const CharacterRun& run) {
        return wall_ms([&] {
            const sim::DrawMesh mesh = dress_mesh_of(character_, run.cloth());
            painter_.draw({.dress = &mesh, .place = place_of(run.body_x())}, kFront);
        });
    }
    double body_alone(const CharacterRun& run) {
        return wall_ms([&] { painter_.draw({.body_x = run.body_x(), .place = place_of(run.body_x())}, kFront); });
    }

 private:
    const DressedCharacter& character_;
    CharacterPainter painter_;
};

// Means over the measured frames of one row.
struct RowStatistics {
    std::string name;
    double triangles = 0;
    CharacterTimes times{};  // ms per frame of 1/30 s
    double rendering = 0;    // ms, the dress alone
    double in_contact = 0;   // vertices
    CollisionQueries queries{};
    double deep_faces = 0;                                 // deeper in the body than 1 mm, % of all
    LimbTimes limbs{};                                     // s per pose
    double body_rendering = 0;                             // ms
    std::vector<std::array<render::Image, 2>> pictures{};  // by moment: lit, by level
    std::vector<double> moments{};                         // s of the walk
};

struct RunLength {
    int warm_frames = 0;  // before the walk; not measured
    int frames = 0;
    int pictures = 0;  // evenly spaced
};

RunLength run_length(const ThesisOptions& options) {
    if (options.is_quick) return {.warm_frames = 1, .frames = 2, .pictures = 1};
    return {.warm_frames = static_cast<int>(std::lround(kWalkStart * 30)), .frames = 120, .pictures = 2};
}

double deep_share(const CharacterRun& run) {
    const auto found = find_penetration(run.cloth(), run.collider().surface(), {.depth = 0.001F});
    return 100.0 * found.faces / static_cast<double>(run.cloth().mesh.leaf_triangles().size());
}

void add(CollisionQueries& sums, const CollisionQueries& one) {
    for (double CollisionQueries::*part :
         {&CollisionQueries::vertices, &CollisionQueries::cylinder_candidates, &CollisionQueries::cylinder_ms,
          &CollisionQueries::sphere_candidates, &CollisionQueries::sphere_ms, &CollisionQueries::nearest_ms,
          &CollisionQueries::hierarchy_ms, &CollisionQueries::missed})
        sums.*part += one.*part;
}

class RowMeasurer {
 public:
    RowMeasurer(const DressedCharacter& character, const ThesisOptions& options)
        : character_(character),
          length_(run_length(options)),
          limbs_(*character.body),
          painter_(character, picture_px(options)) {}

    RowStatistics measure(const SurfaceRow& row) {
        return measure(row.name, {.level = row.level, .coarsens_back_faces = row.coarsens_back_faces});
    }

    RowStatistics measure(const std::string& name, const CharacterRunOptions& options) {
        RowStatistics sums{.name = name};
        CharacterRun run(character_, options);
        CharacterTimes ignored;
        for (int i = 0; i < length_.warm_frames; ++i) run.frame(ignored);
        const double start = run.seconds();
        for (int i = 1; i <= length_.frames; ++i) {
            run.frame(sums.times);
            sums.triangles += static_cast<double>(run.cloth().mesh.leaf_triangles().size());
            sums.in_contact += run.vertices_in_contact();
            limbs_.move_to(*character_.body, run.pose(), run.body_x(), &sums.limbs);
            add(sums.queries, query_vertices(run.cloth(), limbs_, run.collider()));
            sums.deep_faces += deep_share(run);
            if (i % (length_.frames / length_.pictures) != 0) continue;
            picture(run, sums);
            sums.moments.push_back(run.seconds() - start);
        }
        divide(sums);
        return sums;
    }

 private:
    void picture(const CharacterRun& run, RowStatistics& sums) {
        const render::SolidItem fixed = fixed_edges(run.cloth());
        sums.pictures.push_back({painter_.draw(run, render::ShowMode::Plain, kFront, {fixed}),
                                 painter_.draw(run, render::ShowMode::Level, kFront, {fixed})});
        double dress = std::numeric_limits<double>::infinity(), body = dress;
        for (int i = 0; i < 2; ++i) {  // alternately: a picture of what was drawn last is cheaper
            dress = std::min(dress, painter_.dress_alone(run));
            body = std::min(body, painter_.body_alone(run));
        }
        sums.rendering += dress;
        sums.body_rendering += body;
    }

    void divide(RowStatistics& sums) const {
        const double frames = length_.frames, pictures = length_.pictures;
        for (double* sum : {&sums.triangles, &sums.deep_faces, &sums.times.skinning, &sums.times.structures,
                            &sums.times.simulation, &sums.times.collision, &sums.times.adaptation, &sums.in_contact,
                            &sums.limbs.structures, &sums.limbs.planes})
            *sum /= frames;
        CollisionQueries total;
        std::swap(total, sums.queries);
        for (double CollisionQueries::*part :
             {&CollisionQueries::vertices, &CollisionQueries::cylinder_candidates, &CollisionQueries::cylinder_ms,
              &CollisionQueries::sphere_candidates, &CollisionQueries::sphere_ms, &CollisionQueries::nearest_ms,
              &CollisionQueries::hierarchy_ms, &CollisionQueries::missed})
            sums.queries.*part = total.*part / frames;
        for (double* sum : {&sums.rendering, &sums.body_rendering}) *sum /= pictures;
    }

    const DressedCharacter& character_;
    RunLength length_;
    LimbBounds limbs_;
    RunPainter painter_;
};

// Table 5.2.
Table character_table(const std::vector<RowStatistics>& rows, const DressedCharacter& character) {
    RowStatistics mean;
    for (const RowStatistics& row : rows) {
        const double share = 1 / static_cast<double>(rows.size());
        mean.times.skinning += share * row.times.skinning / kStepsPerAdaptation;
        mean.times.structures += share * row.times.structures / kStepsPerAdaptation;
        mean.limbs.structures += share * 1e3 * row.limbs.structures;
        mean.limbs.planes += share * 1e3 * row.limbs.planes;
        mean.body_rendering += share * row.body_rendering;
    }
    Table table{.name = "5.2",
                .title = "Time to update the character each time it is animated",
                .note = "Means over the blended frames of all runs of table 5.3; " +
                        std::to_string(character.body->triangles.size()) +
                        " triangles. Total: of the structures that collision needs. The hierarchy finds the normals "
                        "that it needs when it is searched. CPU time of one thread, but rendering: one picture of "
                        "the body (640 px high, software renderer, all its threads) by the clock.",
                .columns = {"structures", "total, ms", "of it bounding structures, ms",
                            "of it face normals and plane distances, ms", "skinning, ms", "rendering, ms"}};
    table.add_row({"cylinders and spheres (thesis)", Cell(mean.limbs.structures + mean.limbs.planes, 3),
                   Cell(mean.limbs.structures, 3), Cell(mean.limbs.planes, 3), Cell(mean.times.skinning, 3),
                   Cell(mean.body_rendering, 1)});
    table.add_row({"hierarchy of boxes (Selvedge)", Cell(mean.times.structures, 3), Cell(mean.times.structures, 3),
                   Cell(), Cell(mean.times.skinning, 3), Cell(mean.body_rendering, 1)});
    return table;
}

double total_of(const RowStatistics& row) {
    return row.times.simulation + row.times.collision + row.times.adaptation + row.rendering;
}

// Table 5.3.
Table cloth_table(const std::vector<RowStatistics>& rows, const DressedCharacter& character) {
    Table table{.name = "5.3",
                .title = "Triangles and times of the dress on the walking character",
                .note = std::string(kScene) + std::to_string(character.base.triangles.size()) +
                        " base triangles. Means over 4 s of walking, per frame of 1/30 s: four steps, one adaptation, "
                        "one picture. CPU time of one thread, but rendering: a picture of the dress alone (640 px "
                        "high, software renderer, all its threads) by the clock. Uniform rows are refined once and do "
                        "not adapt. The viewer of the last row stands in front.",
                .columns = {"experiment", "triangles", "simulation, ms", "collision, ms", "adaptation, ms",
                            "rendering, ms", "total, ms", "deeper in the body than 1 mm, % of the triangles"}};
    for (const RowStatistics& row : rows)
        table.add_row({row.name, Cell(row.triangles, 0), Cell(row.times.simulation, 2), Cell(row.times.collision, 2),
                       Cell(row.times.adaptation, 2), Cell(row.rendering, 1), Cell(total_of(row), 1),
                       Cell(row.deep_faces, 2)});
    return table;
}

// Table 5.4.
Table collision_table(const std::vector<RowStatistics>& rows, const LimbOptions& limbs) {
    Table table{
        .name = "5.4",
        .title = "Collision: potentially colliding triangles (PCT), and the time to collect them",
        .note =
            "Means over the frames of table 5.3, one query for each cloth vertex per frame. The slices list each "
            "triangle that is within " +
            Cell(1e3 * limbs.margin, 0).to_text() + " mm (and " + Cell(1e3 * limbs.slack, 0).to_text() +
            " mm for skin that does not follow its bone wholly), so that the triangle nearest to a vertex there is "
            "among the candidates; missed: where it is not "
            "(by over 0.1 mm). Hierarchy: our search for the same triangles of the same vertices. In collision: "
            "vertices held at their distance from the body at the end of a step. CPU time of one thread.",
        .columns = {"experiment", "PCT, cylinders", "collecting by cylinders, ms", "PCT, spheres",
                    "collecting by spheres, ms", "nearest of the PCT, ms", "hierarchy (Selvedge), ms", "missed",
                    "cloth vertices", "vertices in collision"}};
    for (const RowStatistics& row : rows) {
        const CollisionQueries& q = row.queries;
        table.add_row({row.name, Cell(q.cylinder_candidates, 0), Cell(q.cylinder_ms, 3), Cell(q.sphere_candidates, 0),
                       Cell(q.sphere_ms, 3), Cell(q.nearest_ms, 3), Cell(q.hierarchy_ms, 3), Cell(q.missed, 2),
                       Cell(q.vertices, 0), Cell(row.in_contact, 0)});
    }
    return table;
}

// Table 5.4, of runs.
Table collider_table(const RowStatistics& by_limbs, const RowStatistics& by_hierarchy) {
    Table table{.name = "5.4-runs",
                .title = "The adaptive dress on each collider",
                .note =
                    "Means over 4 s of walking, per frame of 1/30 s; CPU time of one thread. With the cylinders and "
                    "spheres, each contact point asks for the nearest of its potentially colliding triangles, "
                    "listed out to " +
                    Cell(1e3 * LimbCollider::kReach, 0).to_text() +
                    " mm, and the body stands still while the cloth steps: a step is divided so that the skin "
                    "moves at most half of that at once, if the sub-steps are as many. With the hierarchy, contact "
                    "points follow planes that move with the skin. Adaptation includes its queries. Depth is that in "
                    "the exact surface.",
                .columns = {"collider", "triangles", "structures, ms", "collision, ms", "simulation, ms",
                            "adaptation, ms", "deeper in the body than 1 mm, % of the triangles"}};
    for (const auto& [name, row] : {std::pair("cylinders and spheres (thesis)", &by_limbs),
                                    std::pair("hierarchy of boxes (Selvedge)", &by_hierarchy)})
        table.add_row({name, Cell(row->triangles, 0), Cell(row->times.structures, 2), Cell(row->times.collision, 2),
                       Cell(row->times.simulation, 2), Cell(row->times.adaptation, 2), Cell(row->deep_faces, 2)});
    return table;
}

std::string short_name_of(const RowStatistics& row) {
    return row.name.starts_with("adaptive,") ? "adaptive + back-face" : row.name;
}

// Figure 5.9: two rows of pictures for each moment, lit and by level.
Capture sheet_of(const std::vector<RowStatistics>& rows) {
    std::vector<Tile> tiles;
    for (std::size_t moment = 0; moment < rows.front().pictures.size(); ++moment) {
        for (std::size_t kind = 0; kind < 2; ++kind) {
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const std::string letter = "(" + std::string(1, static_cast<char>('a' + i)) + ") ";
                tiles.push_back(
                    {letter + short_name_of(rows[i]) + ", " + Cell(rows[i].moments[moment], 1).to_text() + " s",
                     rows[i].pictures[moment][kind]});
            }
        }
    }
    return {"5.9", "experiments", labelled_sheet(tiles, 3)};
}

// Level 0 with contact at its vertices alone, at the moments of figure 5.9.
Capture sheet_at_vertices(const RowStatistics& row) {
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i < row.pictures.size(); ++i)
        for (const render::Image& picture : row.pictures[i])
            tiles.push_back({"level 0, contact at vertices, " + Cell(row.moments[i], 1).to_text() + " s", picture});
    return {"5.9", "contact-at-vertices", labelled_sheet(tiles, static_cast<int>(tiles.size()))};
}

Trend cost_trend(const std::vector<RowStatistics>& rows) {
    const RowStatistics &level3 = rows[3], &adaptive = rows[4], &coarse_back = rows[5];
    const auto cloth_ms = [](const RowStatistics& row) { return total_of(row) - row.rendering; };
    return {.item = "T5.3",
            .reported = "the adaptive meshes are meant to cost less than level 3, and coarse back faces less still.",
            .measured = "simulation, collision and adaptation take " + Cell(cloth_ms(level3), 1).to_text() +
                        " ms at level 3, " + Cell(cloth_ms(adaptive), 1).to_text() + " ms adaptive and " +
                        Cell(cloth_ms(coarse_back), 1).to_text() + " ms with coarse back faces, of " +
                        Cell(level3.triangles, 0).to_text() + ", " + Cell(adaptive.triangles, 0).to_text() + " and " +
                        Cell(coarse_back.triangles, 0).to_text() + " triangles.",
            .agrees = cloth_ms(coarse_back) < cloth_ms(adaptive) && cloth_ms(adaptive) < cloth_ms(level3)};
}

Trend depth_trend(const std::vector<RowStatistics>& rows, const RowStatistics& at_vertices) {
    return {.item = "F5.9",
            .reported = "level 0 visibly interpenetrates the body, because its vertices are too few.",
            .measured = Cell(rows[0].deep_faces, 2).to_text() +
                        " % of the triangles of level 0 are deeper in the "
                        "body than 1 mm, " +
                        Cell(rows[3].deep_faces, 2).to_text() + " % of level 3 and " +
                        Cell(rows[4].deep_faces, 2).to_text() +
                        " % of the adaptive mesh: contact points between the vertices hold coarse cloth off the body. "
                        "With contact at the vertices alone, as in the thesis, it is " +
                        Cell(at_vertices.deep_faces, 2).to_text() + " % of level 0.",
            .agrees = rows[0].deep_faces > rows[3].deep_faces};
}

}  // namespace

CollisionQueries query_vertices(const sim::Cloth& cloth, const LimbBounds& limbs,
                                const sim::MovingBodyCollider& hierarchy) {
    std::vector<Vec3f> points;
    for (const sim::VertexId v : cloth.mesh.leaf_vertices()) points.emplace_back(cloth.x[v.value].head<3>());
    std::vector<std::uint32_t> cylinders, spheres;
    std::vector<std::size_t> cylinder_end, sphere_end;
    CollisionQueries queries{.vertices = static_cast<double>(points.size())};
    queries.cylinder_ms = 1e3 * time_once([&] {
                              for (const Vec3f& p : points) {
                                  limbs.collect_from_cylinders(p, cylinders);
                                  cylinder_end.push_back(cylinders.size());
                              }
                          });
    queries.sphere_ms = 1e3 * time_once([&] {
                            for (const Vec3f& p : points) {
                                limbs.collect_from_spheres(p, spheres);
                                sphere_end.push_back(spheres.size());
                            }
                        });
    queries.cylinder_candidates = static_cast<double>(cylinders.size());
    queries.sphere_candidates = static_cast<double>(spheres.size());
    std::vector<float> distance(points.size(), std::numeric_limits<float>::infinity());
    const auto nearest = [&](const std::vector<std::uint32_t>& all, const std::vector<std::size_t>& end) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t first = i == 0 ? 0 : end[i - 1];
            const auto found = limbs.nearest(points[i], std::span(all).subspan(first, end[i] - first));
            if (found) distance[i] = std::min(distance[i], std::abs(found->distance));
        }
    };
    queries.nearest_ms = 1e3 * time_once([&] {
                             nearest(cylinders, cylinder_end);
                             nearest(spheres, sphere_end);
                         });
    const auto margin = static_cast<float>(limbs.options().margin);
    std::vector<sim::ContactBlock> blocks((points.size() + sim::kContactLanes - 1) / sim::kContactLanes);
    for (std::size_t i = 0; i < blocks.size() * sim::kContactLanes; ++i)
        blocks[i / sim::kContactLanes].set_point(i % sim::kContactLanes, points[std::min(i, points.size() - 1)]);
    queries.hierarchy_ms = 1e3 * time_once([&] { hierarchy.contacts(blocks, margin); });
    constexpr float kSame = 1e-4F;  // m
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float exact = std::abs(blocks[i / sim::kContactLanes].distance[i % sim::kContactLanes]);
        queries.missed += exact < margin && distance[i] > exact + kSame ? 1 : 0;
    }
    return queries;
}

ThesisResult list_character_parameters(const ThesisOptions&) {
    Table table = table_of({.stepping = CharacterRun::step_options(),
                            .adapting = CharacterRun::adapt_options(),
                            .step_seconds = kClothStep,
                            .steps_per_adaptation = kStepsPerAdaptation},
                           "5.1", "The simulation parameters of all experiments of chapter 5");
    table.note =
        "Read from the options that the runs take. The product's defaults, but for the shortest edge (the level alone "
        "limits the refinement, as in the thesis) and the extra damping, which stands for the air, as for garments on "
        "bodies that move.";
    return {.tables = {table}};
}

ThesisResult measure_character(const ThesisOptions& options) {
    const DressedCharacter character = make_dressed_character(options);
    RowMeasurer measurer(character, options);
    std::vector<RowStatistics> rows;
    for (const SurfaceRow& row : surface_rows()) rows.push_back(measurer.measure(row));
    const RowStatistics at_vertices = measurer.measure("level 0", {.level = 0, .touches_at_vertices = true});
    const RowStatistics by_limbs = measurer.measure("adaptive on cylinders and spheres", {.collides_with_limbs = true});
    const RowStatistics& by_hierarchy = *std::ranges::find(rows, std::string("adaptive"), &RowStatistics::name);
    return {.tables = {character_table(rows, character), cloth_table(rows, character), collision_table(rows, {}),
                       collider_table(by_limbs, by_hierarchy)},
            .captures = {sheet_of(rows), sheet_at_vertices(at_vertices)},
            .trends = {cost_trend(rows), depth_trend(rows, at_vertices)}};
}

namespace {

constexpr double kPose = kWalkStart + 0.35;  // s: a stride, with both arms swung

sim::Rgb8 bone_colour(int bone) {
    constexpr std::array<sim::Rgb8, 7> kColours{{{0xC7, 0x5B, 0x4A},
                                                 {0x4A, 0x7F, 0xC1},
                                                 {0xE0, 0xB0, 0x4B},
                                                 {0x6B, 0xA3, 0x5F},
                                                 {0x96, 0x6A, 0xB5},
                                                 {0x4F, 0xB0, 0xAE},
                                                 {0xD9, 0x86, 0xA8}}};
    constexpr sim::Rgb8 kGrey{0xB9, 0xB9, 0xB4};
    return bone == kDeformable ? kGrey : kColours[static_cast<std::size_t>(bone) % kColours.size()];
}

// A skin over the body with its rigid triangles in a colour of their bone, and the deformable ones in grey.
render::SolidItem bone_map_item(const sim::Body& body, const std::vector<int>& map, std::span<const Vec3f> x) {
    constexpr float kAbove = 0.001F;  // m
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& [a, b, c] : body.triangles)
        triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    const std::vector<Vec3f> normals = sim::vertex_normals({x.begin(), x.end()}, triangles);
    render::SolidItem solid;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto first = static_cast<std::uint32_t>(solid.x.size());
        for (const std::uint32_t v : triangles[t]) {
            solid.x.emplace_back(x[v] + kAbove * normals[v]);
            solid.normals.push_back(normals[v]);
            solid.colours.push_back(bone_colour(map[t]));
        }
        solid.triangles.push_back({first, first + 1, first + 2});
    }
    return solid;
}

// The outer edges of the slices: a circle of chords at both ends of each stack, and their lines along it.
render::SolidItem cylinder_item(const LimbBounds& limbs) {
    constexpr sim::Rgb8 kRed{0xB4, 0x2A, 0x2A};
    constexpr float kRadius = 0.0006F;  // m
    render::SolidItem solid;
    const int slices = limbs.options().slices;
    const auto length = static_cast<float>(limbs.options().stack_length);
    for (const LimbBounds::Cylinder& cylinder : limbs.cylinders()) {
        for (std::size_t i = 0; i < cylinder.stacks.size(); ++i) {
            const LimbBounds::Stack& stack = cylinder.stacks[i];
            if (stack.radius < 0) continue;
            const float low = cylinder.low + static_cast<float>(i) * length;
            const float high = std::min(cylinder.high, low + length);
            const auto at = [&](int slice, float z) {
                const double angle = 2 * std::numbers::pi * slice / slices;
                const Vec2f out(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
                const Vec2f beside = stack.centre + stack.radius * out;
                return LimbBounds::to_world(cylinder, {beside.x(), beside.y(), z});
            };
            for (int slice = 0; slice < slices; ++slice) {
                add_rod(solid, at(slice, low), at(slice + 1, low), kRadius, kRed);
                add_rod(solid, at(slice, high), at(slice + 1, high), kRadius, kRed);
                add_rod(solid, at(slice, low), at(slice, high), kRadius, kRed);
            }
        }
    }
    return solid;
}

render::SolidItem sphere_item(const LimbBounds& limbs) {
    constexpr sim::Rgb8 kBlue{0x4A, 0x7F, 0xC1};
    render::SolidItem solid;
    for (const LimbBounds::Sphere& sphere : limbs.spheres())
        add_ball(solid, sphere.centre, sphere.radius, kBlue, render::BallDetail::Fine);
    return solid;
}

}  // namespace

ThesisResult draw_cylinders(const ThesisOptions& options) {
    const Character character = make_character(options);
    const BlendedMotion motion(*character.body, character.walk, kPose);
    std::vector<Vec3f> x;
    sim::SkinnedSurface(*character.body).positions(*character.body, motion.pose(kPose), x);
    LimbBounds limbs(*character.body, {.margin = 0, .slack = 0});
    limbs.move_to(*character.body, motion.pose(kPose), x);
    CharacterPainter painter(*character.body, options.is_quick ? 96 : 1000);
    const auto picture = [&](render::SolidItem solid) {
        std::vector<render::SolidItem> solids;
        solids.push_back(std::move(solid));
        return painter.draw({.body_x = x, .solids = std::move(solids), .place = place_of(x), .is_whole = true},
                            {.azimuth = 0.5F, .elevation = 0.08F});
    };
    return {.captures = {{"5.5", "cylinders",
                          labelled_sheet({{"bone map: rigid in colour",
                                           picture(bone_map_item(*character.body, limbs.bone_map(), x))},
                                          {"cylinders: stacks of 2 cm, 32 slices", picture(cylinder_item(limbs))},
                                          {"spheres of the deformable", picture(sphere_item(limbs))}},
                                         3)}}};
}

namespace {

constexpr double kTimelineSeconds = 0.2;

// Figure 5.6 as a drawing: animation frames above, blended frames and cloth updates below, with their shares.
std::string timeline_svg(const BlendedMotion& motion, const std::vector<double>& updates, double start) {
    constexpr double kWidth = 1000, kHeight = 260, kLeft = 40, kAxis = 150;
    constexpr std::string_view kRed = "#C62828", kYellow = "#D9A400";
    SvgDrawing drawing(kWidth, kHeight);
    const auto x_of = [&](double time) { return kLeft + (kWidth - 2 * kLeft) * (time - start) / kTimelineSeconds; };
    drawing.line({{kLeft, kAxis}, {kWidth - kLeft, kAxis}});
    const auto first = static_cast<long>(std::ceil(start / kAnimationFrame - 1e-9));
    for (long i = first; static_cast<double>(i) * kAnimationFrame <= start + kTimelineSeconds + 1e-9; ++i) {
        const double x = x_of(static_cast<double>(i) * kAnimationFrame);
        drawing.line({{x, kAxis - 60}, {x, kAxis}}, {.stroke = kRed, .width_px = 3});
        drawing.text({x, kAxis - 68}, "F" + std::to_string(i), {.fill = kRed, .anchor = "middle", .is_bold = true});
        const double ms = 1e3 * (static_cast<double>(i) * kAnimationFrame - start);
        drawing.text({x, kAxis + 95}, Cell(ms, 0).to_text() + " ms", {.size_px = 12, .anchor = "middle"});
    }
    for (const double time : updates) {
        if (time < start - 1e-9 || time > start + kTimelineSeconds + 1e-9) continue;
        const double x = x_of(time);
        const BlendedMotion::Moment moment = motion.at(time);
        drawing.line({{x, kAxis}, {x, kAxis + 35}}, {.stroke = kYellow, .width_px = 3});
        drawing.dot({x, kAxis}, 4, kYellow);
        drawing.text({x, kAxis + 52}, Cell(100 * moment.share, 0).to_text() + " %",
                     {.size_px = 11, .anchor = "middle"});
    }
    drawing.text({kLeft, 24}, "Animation frames, 25 per second", {.fill = kRed, .is_bold = true});
    drawing.text({kLeft, 44}, "Blended frames and cloth updates, 120 per second, and the share of the later frame",
                 {.fill = kYellow, .is_bold = true});
    return drawing.to_text();
}

}  // namespace

ThesisResult draw_timeline(const ThesisOptions& options) {
    const DressedCharacter character = make_dressed_character(options);
    CharacterRun run(character, {.level = 0});
    CharacterTimes ignored;
    const double start = options.is_quick ? 0 : kWalkStart;
    while (run.seconds() < start + kTimelineSeconds) run.frame(ignored);
    return {.drawings = {{"5.6", "Animation frames, blended frames and cloth updates of a run",
                          timeline_svg(run.motion(), run.updates(), start)}}};
}

ThesisResult draw_back_faces(const ThesisOptions& options) {
    const DressedCharacter character = make_dressed_character(options);
    CharacterRun run(character, {.coarsens_back_faces = true});
    CharacterTimes ignored;
    const double end = options.is_quick ? 0.1 : kWalkStart + 1;
    while (run.seconds() < end) run.frame(ignored);
    RunPainter painter(character, options.is_quick ? 96 : 900);
    const auto levels = [&](const render::Direction& from) {
        return painter.draw(run, render::ShowMode::Level, from, {});
    };
    const auto edges = [&](const render::Direction& from) {
        return painter.draw(run, render::ShowMode::Plain, from, {edges_by_sight(run.cloth(), viewer_of(run.body_x()))});
    };
    const std::string count = std::to_string(run.cloth().mesh.leaf_triangles().size()) + " triangles";
    return {
        .captures = {
            {"5.7", "front-back",
             labelled_sheet({{"front, as the viewer sees it: " + count, levels(kFront)}, {"back", levels(kBack)}}, 2)},
            {"5.8", "front-side-back",
             labelled_sheet({{"front, as the viewer sees it", edges(kFront)},
                             {"side (the viewer is at the left)", edges(kFromSide)},
                             {"back; unseen edges green", edges(kBack)}},
                            3)}}};
}

namespace {

struct BudgetChange {
    double seconds = 0;  // of the walk
    std::size_t target = 0;
};

struct BudgetRun {
    Figure figure;
    double worst = 0;    // share by which the count is off its target, later than kSettling after a change
    int settled = 0;     // frames so late
    double slowest = 0;  // s from a change until the count stays within kHeld
};

constexpr double kSettling = 1;  // s
constexpr double kHeld = 0.05;   // share of the target

BudgetRun run_budget(const DressedCharacter& character, const std::string& name, const std::string& title,
                     const std::vector<BudgetChange>& changes, double seconds, int warm_frames) {
    BudgetRun result{.figure = {.series = {.name = name,
                                           .title = title,
                                           .note = std::string(kScene) + "One adaptation per 1/30 s.",
                                           .columns = {"time, s", "triangles", "target"}},
                                .y_label = "triangles"}};
    CharacterRun run(character, {.budget = changes.front().target, .seconds = kWalkStart + seconds});
    CharacterTimes ignored;
    for (int i = 0; i < warm_frames; ++i) run.frame(ignored);
    const double start = run.seconds();
    std::size_t next = 0;
    double changed = 0;
    while (run.seconds() - start < seconds - 1e-9) {
        const double time = run.seconds() - start;
        if (next < changes.size() && time >= changes[next].seconds - 1e-9) {
            changed = time;
            run.budget()->set_target(changes[next++].target);
        }
        run.frame(ignored);
        const auto count = static_cast<double>(run.cloth().mesh.leaf_triangles().size());
        const auto target = static_cast<double>(run.budget()->target());
        const double now = run.seconds() - start, off = std::abs(count / target - 1);
        if (off > kHeld) result.slowest = std::max(result.slowest, now - changed);
        if (now - changed > kSettling) {
            result.worst = std::max(result.worst, off);
            ++result.settled;
        }
        result.figure.series.add_row({Cell(now, 3), Cell(count, 0), Cell(target, 0)});
    }
    return result;
}

Trend budget_trend(const std::string& item, const BudgetRun& run) {
    return {.item = item,
            .reported = "the adaptive mesh achieves a changing triangle budget.",
            .measured = "later than 1 s after a change, the count is at most " + Cell(100 * run.worst, 1).to_text() +
                        " % off its target; it stays within 5 % from " + Cell(run.slowest, 2).to_text() +
                        " s after each change on.",
            .agrees = run.settled > 0 && run.worst <= kHeld};
}

}  // namespace

ThesisResult measure_changing_budget(const ThesisOptions& options) {
    const DressedCharacter character = make_dressed_character(options);
    const double scale = options.is_quick ? 0.03 : 1;
    const int warm = run_length(options).warm_frames;
    const auto scaled = [&](std::vector<BudgetChange> changes) {
        for (BudgetChange& change : changes) change.seconds *= scale;
        return changes;
    };
    const BudgetRun there_and_back =
        run_budget(character, "5.10", "Triangles against a target of 3,000, 6,000 and 3,000",
                   scaled({{0, 3000}, {3, 6000}, {6, 3000}}), 9 * scale, warm);
    const BudgetRun many =
        run_budget(character, "5.11", "Triangles against a target that changes every 2 s",
                   scaled({{0, 2000}, {2, 5000}, {4, 3500}, {6, 8000}, {8, 2500}}), 10 * scale, warm);
    return {.figures = {there_and_back.figure, many.figure},
            .trends = {budget_trend("F5.10", there_and_back), budget_trend("F5.11", many)}};
}

}  // namespace selvedge::bench
