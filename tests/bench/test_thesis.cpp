// Every table and figure of the thesis at small size. Checks only what does not depend on timing.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/support/measured_mesh.h"
#include "bench/thesis/captions.h"
#include "bench/thesis/cloth_property.h"
#include "bench/thesis/edge_pair_mesh.h"
#include "bench/thesis/labels.h"
#include "bench/thesis/point_search.h"
#include "bench/thesis/pointer_mesh.h"
#include "bench/thesis/pointer_transitions.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"
#include "bench/thesis/traversal.h"
#include "sim/cloth/solver_state.h"
#include "sim/mesh/square.h"
#include "tests/bench/support.h"

namespace selvedge::bench {
namespace {

const Table& table_named(const ThesisResult& result, std::string_view name) {
    const auto is_it = [&](const Table& table) { return table.name == name; };
    return *std::find_if(result.tables.begin(), result.tables.end(), is_it);
}

std::set<std::string> table_names(const ThesisResult& result) {
    std::set<std::string> names;
    for (const Table& table : result.tables) names.insert(table.name);
    return names;
}

TEST(Thesis, no_name_is_promised_twice_and_every_name_is_in_a_caption) {
    std::set<std::string> tables, figures;
    for (const Experiment& experiment : thesis_experiments()) {
        for (const std::string& name : experiment.tables) EXPECT_TRUE(tables.insert(name).second) << name;
        for (const std::string& name : experiment.figures) EXPECT_TRUE(figures.insert(name).second) << name;
    }
    const auto has_caption = [](const std::string& name) {
        return std::ranges::any_of(thesis_captions(), [&](const Caption& caption) { return is_of(caption, name); });
    };
    for (const std::string& name : tables) EXPECT_TRUE(has_caption(name)) << name;
    for (const std::string& name : figures) EXPECT_TRUE(has_caption(name)) << name;
}

TEST(Thesis, transitions_have_a_cost_each_and_none_to_themselves) {
    const ThesisResult result = measure_transition_cost(kQuick);
    EXPECT_EQ(table_names(result), (std::set<std::string>{"3.2", "3.3", "3.4", "3.5", "3.2-3.5"}));
    const Table& clearing = table_named(result, "3.2");
    ASSERT_EQ(clearing.rows.size(), 11U) << "C0 is a configuration too";
    for (std::size_t c = 0; c < 11; ++c)
        for (std::size_t column = 3; column < 5; ++column) EXPECT_GT(number(clearing, c, column), 0) << c;
    for (const char* name : {"3.3", "3.4", "3.5"}) {
        const Table& table = table_named(result, name);
        ASSERT_EQ(table.rows.size(), 11U);
        for (std::size_t from = 0; from < 11; ++from)
            for (std::size_t to = 0; to < 11; ++to)
                EXPECT_EQ(table.rows[from][1 + to].is_empty(), from == to) << name << " " << from << " " << to;
    }
    const Table& means = table_named(result, "3.2-3.5");
    EXPECT_EQ(number(means, 0, 4), 0.145);
    EXPECT_EQ(number(means, 0, 6), 58.8);
}

TEST(Thesis, recursion_and_lists_reach_every_leaf_of_a_mesh_of_128_triangles) {
    const ThesisResult result = measure_traversal(kQuick);
    const Table& table = result.tables.at(0);
    ASSERT_EQ(table.rows.size(), 4U);
    const std::array<double, 4> edges{208, 800, 3136, 12416}, triangles{128, 512, 2048, 8192};
    for (std::size_t level = 0; level < 4; ++level) {
        EXPECT_EQ(number(table, level, 1), triangles[level]);
        EXPECT_EQ(number(table, level, 2), edges[level]);
        for (std::size_t column = 3; column < 6; ++column) EXPECT_GT(number(table, level, column), 0);
    }
}

// An uneven mesh: every third edge is split, as far as that is permitted.
sim::AdaptiveMesh uneven_mesh(const sim::GarmentMesh& base) {
    sim::AdaptiveMesh mesh(base);
    for (int level = 0; level < 2; ++level) {
        const std::vector<sim::EdgeId> edges(mesh.unsplit_edges(level).begin(), mesh.unsplit_edges(level).end());
        for (std::size_t i = 0; i < edges.size(); i += level == 0 ? 2 : 1) {
            if (mesh.may_split(edges[i])) mesh.split(edges[i]);
        }
        mesh.retriangulate(level);
    }
    mesh.refresh_lists();
    return mesh;
}

TEST(Traversal, collects_each_leaf_once) {
    const sim::GarmentMesh base = sim::make_square({.columns = 4, .rows = 4});
    const sim::AdaptiveMesh mesh = uneven_mesh(base);
    ASSERT_GT(mesh.leaf_triangles().size(), 64U);
    TemporaryLists lists;
    collect_leaves(mesh, lists);
    std::set<std::uint32_t> edges, vertices, leaf_edges, leaf_vertices;
    for (const sim::EdgeId e : lists.edges) EXPECT_TRUE(edges.insert(e.value).second);
    for (const sim::VertexId v : lists.vertices) EXPECT_TRUE(vertices.insert(v.value).second);
    for (const sim::LeafEdge& e : mesh.leaf_edges()) leaf_edges.insert(e.edge.value);
    for (const sim::VertexId v : mesh.leaf_vertices()) leaf_vertices.insert(v.value);
    EXPECT_EQ(edges, leaf_edges);
    EXPECT_EQ(vertices, leaf_vertices);
}

TEST(Traversal, makes_no_difference_to_what_a_step_does) {
    const sim::GarmentMesh base = sim::make_square({.columns = 4, .rows = 4, .height = 1});
    const sim::AdaptiveMesh mesh = uneven_mesh(base);
    SpringState recursion = make_spring_state(mesh, base.x), listed = recursion, flat = recursion;
    TemporaryLists lists;
    collect_leaves(mesh, lists);
    for (int i = 0; i < 50; ++i) {
        step_by_recursion(mesh, recursion);
        step_by_lists(mesh, lists, listed);
        step_by_flat_lists(mesh, flat);
    }
    float lowest = 1;
    for (const sim::VertexId v : mesh.leaf_vertices()) {
        EXPECT_EQ(recursion.x[v.value], listed.x[v.value]) << "the same order of the same sums";
        EXPECT_LT((recursion.x[v.value] - flat.x[v.value]).norm(), 2e-3F) << "another order of corrections";
        lowest = std::min(lowest, recursion.x[v.value].y());
    }
    EXPECT_LT(lowest, 0.995F) << "it falls";
    EXPECT_GT(lowest, 0.98F) << "50 ms of free fall are 12 mm";
    EXPECT_EQ(recursion.x[0].y(), 1.0F) << "pinned";
}

TEST(Thesis, uniform_refinement_makes_the_elements_that_the_thesis_counted) {
    const ThesisResult result = measure_uniform_refinement(kQuick);
    const Table& table = table_named(result, "3.7");
    const std::array<std::array<double, 3>, 4> counts{
        {{25, 56, 32}, {81, 264, 160}, {289, 1064, 672}, {1089, 4200, 2720}}};
    for (std::size_t level = 0; level < 4; ++level)
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(number(table, level, 1 + i), counts[level][i]);
    ASSERT_EQ(result.figures.size(), 2U);
    ASSERT_EQ(result.figures[0].series.rows.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {  // triangles that exist before
        EXPECT_EQ(number(result.figures[0].series, i, 0), 32 << (2 * i));
        EXPECT_EQ(number(result.figures[1].series, i, 0), 128 << (2 * i));
    }
    EXPECT_EQ(result.figures[0].y_label, "us per existing triangle");
}

template <class Store>
void expect_the_same_elements() {
    const sim::GarmentMesh base = sim::make_square({.columns = 4, .rows = 4});
    PointerMesh<Store> mesh(base);
    for (const auto& [vertices, edges, triangles] :
         {std::array<std::size_t, 3>{25, 56, 32}, {81, 264, 160}, {289, 1064, 672}, {1089, 4200, 2720}}) {
        EXPECT_EQ(mesh.vertex_count(), vertices);
        EXPECT_EQ(mesh.edge_count(), edges);
        EXPECT_EQ(mesh.triangle_count(), triangles);
        if (mesh.level() < 3) mesh.refine();
    }
    while (mesh.level() > 0) mesh.coarsen();
    EXPECT_EQ(mesh.vertex_count(), 25U);
    EXPECT_EQ(mesh.edge_count(), 56U);
    EXPECT_EQ(mesh.triangle_count(), 32U);
    mesh.refine();
    EXPECT_EQ(mesh.triangle_count(), 160U);
}

TEST(PointerMesh, makes_the_same_elements_as_the_adaptive_mesh_and_goes_back) {
    expect_the_same_elements<NewDelete>();
    expect_the_same_elements<Pools>();
    expect_the_same_elements<ListPools>();
}

TEST(ListPools, give_a_freed_element_out_again_and_never_one_that_is_in_use) {
    ListPools pools;
    std::set<PointerEdge*> used;
    for (int i = 0; i < 3000; ++i) EXPECT_TRUE(used.insert(pools.make<PointerEdge>()).second);
    PointerEdge* const one = *used.begin();
    one->level = 7;
    pools.drop(one);
    EXPECT_EQ(pools.make<PointerEdge>(), one);
    EXPECT_EQ(one->level, 0) << "it comes back as a new one";
}

TEST(EdgePairMesh, makes_the_same_elements_as_the_adaptive_mesh_and_goes_back) {
    const sim::GarmentMesh base = sim::make_square({.columns = 4, .rows = 4});
    EdgePairMesh mesh(base);
    for (const auto& [vertices, edges, triangles] :
         {std::array<std::size_t, 3>{25, 56, 32}, {81, 264, 160}, {289, 1064, 672}, {1089, 4200, 2720}}) {
        EXPECT_EQ(mesh.vertex_count(), vertices);
        EXPECT_EQ(mesh.edge_count(), edges);
        EXPECT_EQ(mesh.triangle_count(), triangles);
        for (const HalfEdge* half : mesh.finest_edges()) {
            ASSERT_NE(half->triangle, nullptr);
            if (half->twin == nullptr) continue;
            EXPECT_EQ(half->twin->twin, half);
            EXPECT_NE(half->twin->start, half->start);
            EXPECT_NE(half->twin->triangle, half->triangle);
        }
        if (mesh.level() < 3) mesh.refine();
    }
    while (mesh.level() > 0) mesh.coarsen();
    EXPECT_EQ(mesh.vertex_count(), 25U);
    EXPECT_EQ(mesh.half_edge_count(), 96U);
    mesh.refine();
    EXPECT_EQ(mesh.triangle_count(), 160U);
}

TEST(Thesis, an_edge_pair_takes_more_memory_than_an_edge_trio) {
    const Table table = measure_edge_pair(kQuick).tables.at(0);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_LT(number(table, 0, 1), number(table, 1, 1));
    EXPECT_LT(number(table, 0, 2), number(table, 1, 2));
}

TEST(PointerTransitions, leave_three_entries_of_adjacency_for_each_leaf_and_none_when_cleared) {
    PointerTransitions bed(sim::make_square({.columns = 2, .rows = 2}));
    EXPECT_EQ(bed.adjacency_count(), 0U);
    for (std::size_t c = 0; c < sim::kConfigurations; ++c) {
        const auto configuration = static_cast<sim::Configuration>(c);
        bed.configure_all(configuration);
        const std::size_t leaves = c == 0 ? 1 : sim::layout(configuration).triangle_count;
        EXPECT_EQ(bed.adjacency_count(), 8 * 3 * leaves) << c;
        bed.clear_all();
        EXPECT_EQ(bed.adjacency_count(), 0U) << c;
    }
}

TEST(Thesis, memory_is_bytes_times_elements) {
    const Table table = measure_memory(kQuick).tables.at(0);
    const auto bytes = [&](std::size_t kind) { return number(table, 0, 2 + kind); };
    EXPECT_LT(bytes(0), 144);
    EXPECT_LT(bytes(1), 52);
    EXPECT_LT(bytes(2), 120);
    const std::array<double, 3> counts{1089, 4200, 2720};
    double together = 0;
    for (std::size_t kind = 0; kind < 3; ++kind) {
        EXPECT_EQ(number(table, 5, 2 + kind), counts[kind] * bytes(kind));
        together += counts[kind] * bytes(kind);
    }
    EXPECT_EQ(number(table, 5, 5), together);
    EXPECT_EQ(number(table, 5, 6), 1089 * 144 + 4200 * 52 + 2720 * 120);
}

using Names = std::vector<std::string>;

// The times that the captions of tables 3.12 to 3.14 and figures 3.25 to 3.30 name, in ms, by name.
const Names kTimes{"total update, ms", "simulation, ms", "collision, ms",
                   "adaptation, ms",   "rendering, ms",  "total update CPU, ms"};

std::size_t column_of(const Table& table, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(table.columns, name) - table.columns.begin());
}

double number(const Table& table, std::size_t row, const std::string& column) {
    return number(table, row, column_of(table, column));
}

// Each row of a table of drops: something was simulated, collided, adapted and drawn, and the total is their sum.
void expect_times_that_add_up(const Table& table) {
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double sum = number(table, row, "simulation, ms") + number(table, row, "collision, ms") +
                           number(table, row, "adaptation, ms");
        EXPECT_NEAR(number(table, row, "total update, ms"), sum, 1e-9) << table.name << " " << row;
        for (const std::string& name : kTimes) EXPECT_GT(number(table, row, name), 0) << table.name << " " << name;
    }
}

TEST(Thesis, uniform_drops_have_four_times_the_triangles_on_each_level) {
    const ThesisResult result = measure_uniform_drops(kQuick);
    for (const Table& table : result.tables) {
        ASSERT_EQ(table.rows.size(), 6U);
        for (const std::size_t cloth : {0U, 2U, 4U}) {
            const Names cloths{"selvedge", "vertices only", "mass-spring"};
            EXPECT_EQ(table.rows[cloth][0].to_text(), cloths[cloth / 2]);
            EXPECT_EQ(number(table, cloth, "triangles"), 32);
            EXPECT_EQ(number(table, cloth + 1, "triangles"), 128);
        }
        Names columns{"cloth", "level", "triangles"};
        columns.insert(columns.end(), kTimes.begin(), kTimes.end());
        columns.emplace_back("of it each step, ms");
        EXPECT_EQ(table.columns, columns);
        expect_times_that_add_up(table);
    }
    EXPECT_NE(result.tables.at(0).title.find("cylinder"), std::string::npos) << "3.12";
    EXPECT_NE(result.tables.at(1).title.find("sphere"), std::string::npos) << "3.13";
    EXPECT_EQ(table_names(result), (std::set<std::string>{"3.12", "3.13"}));
}

TEST(Drop, of_vertices_only_has_no_contact_points_between_them) {
    const auto samples = [](DropCloth cloth) {
        std::size_t most = 0;
        run_thesis_drop({.cloth = cloth, .uniform_level = 1, .seconds = 0.1, .watch = [&](const sim::Cloth& c, double) {
                             most = std::max(most, sample_count(c.solver->contacts));
                         }});
        return most;
    };
    EXPECT_GT(samples(DropCloth::Selvedge), 100U);
    EXPECT_EQ(samples(DropCloth::VerticesOnly), 0U);
}

TEST(Thesis, transition_frequencies_sum_to_the_total_that_the_title_names) {
    const ThesisResult result = measure_adaptive_drops(kQuick);
    const Table& table = table_named(result, "3.1");
    ASSERT_EQ(table.rows.size(), 8U);
    double percent = 0, count = 0;
    for (std::size_t from = 0; from < 8; ++from) {
        EXPECT_EQ(number(table, from, 1 + from), 0) << "nothing passes to the state that it is in";
        for (std::size_t to = 0; to < 8; ++to) percent += number(table, from, 1 + to);
        count += number(table, from, 9);
    }
    EXPECT_NEAR(percent, 100, 1e-9);
    EXPECT_GT(count, 50);
    EXPECT_NE(table.title.find("of " + std::to_string(static_cast<int>(count))), std::string::npos) << table.title;
    const Table& drops = table_named(result, "3.14");
    Names columns{"object", "cloth", "criteria", "triangles, mean", "triangles, most"};
    columns.insert(columns.end(), kTimes.begin(), kTimes.end());
    columns.insert(columns.end(), {"share of uniform", "distance, mm", "bend, 1/m"});
    EXPECT_EQ(drops.columns, columns);
    EXPECT_EQ(drops.rows.size(), 2U * (4 + 3)) << "uniform, shifted, A, A+B+C; mass-spring without shifted";
    expect_times_that_add_up(drops);
}

TEST(Thesis, tie_breakers_stand_side_by_side_on_both_objects) {
    const ThesisResult result = measure_tie_breakers(kQuick);
    const Table& table = result.tables.at(0);
    EXPECT_EQ(table.name, "figure-3.9");
    ASSERT_EQ(table.rows.size(), 8U);
    std::set<std::string> names;
    for (std::size_t row = 0; row < 8; ++row) names.insert(table.rows[row][1].to_text());
    EXPECT_EQ(names, (std::set<std::string>{"least work", "length", "rest length", "curvature"}));
    ASSERT_EQ(result.captures.size(), 2U);
    for (const Capture& capture : result.captures) {
        EXPECT_EQ(capture.name, "3.9");
        EXPECT_GE(capture.image.width_px, 2 * 96);
        EXPECT_GE(capture.image.height_px, 2 * 96);
    }
}

TEST(Drop, does_the_same_each_time) {
    const ThesisDropOptions options{.object = ThesisDropObject::Sphere, .seconds = 0.5};
    const ThesisDropRun once = run_thesis_drop(options), again = run_thesis_drop(options);
    EXPECT_EQ(mean_distance(once, again), 0);
    EXPECT_EQ(once.transitions.by_configuration, again.transitions.by_configuration);
}

TEST(Drop, rests_on_its_object_or_falls_off_it) {
    const auto lowest = [](const ThesisDropRun& run) {
        float low = 1000;
        for (const Vec3f& x : run.grid) low = std::min(low, x.y());
        return low;
    };
    for (const ThesisDropObject object : {ThesisDropObject::Sphere, ThesisDropObject::Cylinder}) {
        ThesisDropOptions options{.object = object, .criteria = {}, .seconds = 2.5};
        EXPECT_GT(lowest(run_thesis_drop(options)), -0.5F) << name_of(object);
        options.falls_off = true;
        EXPECT_LT(lowest(run_thesis_drop(options)), -1.0F) << name_of(object);
    }
}

TEST(Thesis, step_by_step_timings_show_what_the_captions_name_for_each_update) {
    const ThesisResult result = measure_drop_timings(kQuick);
    const std::array<const char*, 6> scenes{"Cylinder [A]", "Sphere [A]",   "Cylinder [B]",
                                            "Sphere [B]",   "Sphere [A+B]", "Sphere [C]"};
    Names columns{"time, s"};
    columns.insert(columns.end(), kTimes.begin(), kTimes.end());
    columns.emplace_back("triangles");
    ASSERT_EQ(result.figures.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        const Figure& figure = result.figures[i];
        EXPECT_EQ(figure.series.name, "3." + std::to_string(25 + i));
        EXPECT_EQ(figure.series.title.rfind(scenes[i], 0), 0U) << figure.series.title;
        EXPECT_EQ(figure.series.columns, columns);
        EXPECT_EQ(figure.y_label, "ms");
        EXPECT_EQ(figure.right_column, "triangles");
        ASSERT_EQ(figure.series.rows.size(), 9U);
        EXPECT_NEAR(number(figure.series, 8, 0), 0.3, 1e-9);
        EXPECT_GE(number(figure.series, 8, "triangles"), 32);
        expect_times_that_add_up(figure.series);
    }
}

TEST(Thesis, captures_of_drops_show_six_moments_on_the_sphere_and_each_combination_on_both_objects) {
    const ThesisResult result = measure_drop_captures(kQuick);
    ASSERT_EQ(result.captures.size(), 2U);
    const auto sheet = [](int columns, int rows) { return std::pair(columns * 100 - 4, rows * 100 - 4); };
    const auto size = [](const render::Image& image) { return std::pair(image.width_px, image.height_px); };
    EXPECT_EQ(result.captures[0].name, "3.23");
    EXPECT_EQ(size(result.captures[0].image), sheet(3, 2));
    EXPECT_EQ(result.captures[1].name, "3.24");
    EXPECT_EQ(size(result.captures[1].image), sheet(2, 2)) << "A and A+B+C; the sphere above the cylinder";
}

// The updates of a cloth that falls on an object and slides off it, refined by these criteria.
ThesisDropRun falls_off(ThesisDropObject object, const sim::CriteriaOptions& criteria) {
    return run_thesis_drop({.object = object, .falls_off = true, .criteria = criteria, .seconds = 2.0});
}

constexpr sim::CriteriaOptions kA{.collision = true, .curvature = false, .length = false};

TEST(Drop, collision_refines_where_it_touches_either_object_and_coarsens_at_once_when_it_has_left) {
    for (const ThesisDropObject object : {ThesisDropObject::Sphere, ThesisDropObject::Cylinder}) {
        std::size_t most = 0;
        int away_after = 0;
        for (const ThesisDropFrame& frame : falls_off(object, kA).frames) {
            most = std::max(most, frame.triangles);
            // m; from there on no edge of the base mesh, of 35 cm or less, cuts the object: sqrt(R^2 + (L/2)^2) - R
            const bool is_away = frame.gap > 0.06;
            if (is_away) {
                EXPECT_EQ(frame.triangles, 32U) << name_of(object) << " at " << frame.time << " s";
            }
            if (is_away && most > 32) ++away_after;
        }
        EXPECT_GT(most, 200U) << name_of(object);
        EXPECT_GT(away_after, 5) << name_of(object) << ": it has not left";
    }
}

TEST(Drop, each_of_collision_and_length_refines_more_beside_the_others_and_length_makes_wrinkles) {
    struct Result {
        double triangles = 0;  // mean over the updates
        double bend = 0;       // 1/m, of the last drape
    };
    const auto drop = [](ThesisDropObject object, bool a, bool b, bool c) {
        const ThesisDropRun run = run_thesis_drop(
            {.object = object, .criteria = {.collision = a, .curvature = b, .length = c}, .seconds = 1.5});
        double sum = 0;
        for (const ThesisDropFrame& frame : run.frames) sum += static_cast<double>(frame.triangles);
        return Result{.triangles = sum / static_cast<double>(run.frames.size()), .bend = mean_bend(run)};
    };
    const ThesisDropObject sphere = ThesisDropObject::Sphere;
    const Result a = drop(sphere, true, false, false), ac = drop(sphere, true, false, true);
    EXPECT_GT(ac.triangles, 1.5 * a.triangles);
    EXPECT_GT(ac.bend, 1.2 * a.bend) << "wrinkles";
    const Result b = drop(sphere, false, true, false), ab = drop(sphere, true, true, false);
    EXPECT_GT(drop(sphere, false, true, true).triangles, 1.03 * b.triangles);
    EXPECT_GT(drop(sphere, true, true, true).triangles, 1.03 * ab.triangles);
    EXPECT_GT(ab.triangles, 1.1 * b.triangles);
    const ThesisDropObject cylinder = ThesisDropObject::Cylinder;
    EXPECT_GT(drop(cylinder, true, true, false).triangles, 1.5 * drop(cylinder, false, true, false).triangles);
}

TEST(Points, grid_and_octree_find_every_point_that_they_hold_and_no_other) {
    std::vector<Vec3f> points;
    for (int i = 0; i < 1000; ++i)
        points.emplace_back(0.001F * static_cast<float>(i), 0.001F * static_cast<float>(i * 7 % 1000),
                            0.001F * static_cast<float>(i * 31 % 1000));
    points.push_back(points[500] + Vec3f(1e-6F, 0, 0));  // in the same cell as another point, at any depth
    const Cube cube{.low = Vec3f::Constant(0.25F), .side = 0.5F};
    const PointGrid grid(points, cube);
    const PointOctree octree(points, cube);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::uint32_t expected = cube.contains(points[i]) ? i : kNoPoint;
        EXPECT_EQ(grid.find(points[i]), expected);
        EXPECT_EQ(octree.find(points[i]), expected);
    }
    EXPECT_EQ(grid.find(Vec3f::Constant(0.3333F)), kNoPoint);
    EXPECT_EQ(octree.find(Vec3f::Constant(0.3333F)), kNoPoint);
}

TEST(Thesis, grid_and_octree_hold_the_same_points_and_all_of_them_when_they_fill_the_cube) {
    const Table table = measure_point_search(kQuick).tables.at(0);
    EXPECT_EQ(number(table, 0, 1), 512);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        EXPECT_EQ(number(table, row, 1), number(table, row, 2));
        if (row > 0) {
            EXPECT_LT(number(table, row, 1), number(table, row - 1, 1));
        }
    }
}

TEST(Thesis, curved_surfaces_are_drawn_at_four_levels_and_adaptively_and_no_vertex_jumps) {
    const ThesisResult result = measure_curved_surface(kQuick);
    EXPECT_EQ(table_names(result), (std::set<std::string>{"6.2", "6.3"}));
    for (const Table& table : result.tables) {
        ASSERT_EQ(table.rows.size(), 7U);
        const double base = number(table, 0, 1);
        EXPECT_NEAR(base, 250, 5) << table.name;
        for (std::size_t level = 1; level < 4; ++level)
            EXPECT_EQ(number(table, level, 1), base * static_cast<double>(1 << (2 * level))) << table.name;
        for (const std::size_t adaptive : {4U, 5U}) {
            EXPECT_GE(number(table, adaptive, 1), base) << table.name;
            EXPECT_LT(number(table, adaptive, 1), base * 64) << table.name;
            EXPECT_LT(number(table, adaptive, 6), 0.5) << table.name;
        }
    }
    ASSERT_EQ(result.captures.size(), 2U);
    EXPECT_EQ(result.captures[0].name, "6.8");
    EXPECT_EQ(result.captures[1].name, "6.9");
    for (const Capture& capture : result.captures) EXPECT_EQ(capture.image.width_px, 3 * 2 * 96 + 2 * 4);
}

TEST(Thesis, of_two_pictures_of_one_surface_that_with_normals_of_its_triangles_differs) {
    const ThesisResult result = measure_surface_lighting(kQuick);
    const render::Image& pair = result.captures.front().image;
    int differ = 0;
    const int top = pair.height_px - 96;  // below the labels
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) differ += pair.at(x, top + y) != pair.at(x + 100, top + y) ? 1 : 0;
    EXPECT_GT(differ, 500);
}

TEST(Thesis, a_surface_through_sampled_points_is_nearer_to_the_fine_cloth_when_it_is_curved) {
    const Table table = measure_surface_distance(kQuick).tables.front();
    ASSERT_EQ(table.rows.size(), 6U);
    const double flat = number(table, 0, 1);
    for (std::size_t kind = 1; kind < 6; ++kind) EXPECT_LT(number(table, kind, 1), flat);
}

// The thesis' table 6.1, as integers.
TEST(Thesis, lagrange_weights_are_the_published_ones) {
    const Table table = list_curve_weights(kQuick).tables.at(0);
    ASSERT_EQ(table.rows.size(), 9U);
    const auto expect_row = [&](std::size_t row, std::array<double, 4> weights, double denominator) {
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(number(table, row, 2 + k), weights[k] / denominator, 1e-6) << row;
            EXPECT_NEAR(number(table, 8 - row, 5 - k), weights[k] / denominator, 1e-6) << "mirrored " << row;
        }
    };
    expect_row(0, {1, 0, 0, 0}, 1);
    expect_row(1, {455, 819, -315, 65}, 1024);
    expect_row(2, {15, 135, -27, 5}, 128);
    expect_row(3, {-35, 945, 135, -21}, 1024);
    expect_row(4, {-1, 9, 9, -1}, 16);
    EXPECT_EQ(table.rows[4][6].to_text(), "(-1, 9, 9, -1) / 16");
}

TEST(Thesis, three_curve_shapes_bend_more_the_shorter_an_edge_is) {
    const ThesisResult result = draw_curve_shapes(kQuick);
    const Table& table = result.tables.at(0);
    ASSERT_EQ(table.columns.size(), 5U);
    EXPECT_NEAR(number(table, 0, 1), 1, 1e-9) << "M of an edge at its rest length";
    EXPECT_NEAR(number(table, 3, 1), 1 / (0.8 * 0.8), 1e-9);
    for (std::size_t shape = 2; shape < 5; ++shape) {
        for (std::size_t row = 1; row < table.rows.size(); ++row) {
            EXPECT_GT(number(table, row, shape) / number(table, row, 0),
                      number(table, row - 1, shape) / number(table, row - 1, 0));
        }
    }
    EXPECT_TRUE(result.trends.at(0).agrees);
}

TEST(Thesis, the_soft_cap_leaves_values_up_to_one) {
    const Table series = draw_soft_cap(kQuick).figures.at(0).series;
    for (std::size_t row = 0; row < series.rows.size(); ++row) {
        const double m = number(series, row, 0);
        EXPECT_NEAR(number(series, row, 1), m <= 1 ? m : 1 + (m - 1) / m, 1e-4) << m;
    }
}

TEST(Thesis, the_cloths_settings_are_those_that_the_simulation_takes) {
    ClothProperty property;
    property.stepping.substeps = 17;
    property.adapting.curvature.split_angle = 0.5F;
    const Table table = table_of(property, "listing-3.5", "settings");
    const auto value = [&](const std::string& parameter) {
        const auto row =
            std::ranges::find_if(table.rows, [&](const auto& cells) { return cells[0].to_text() == parameter; });
        return row == table.rows.end() ? std::string("none") : (*row)[1].to_text();
    };
    EXPECT_EQ(value("sub-steps per step"), "17");
    EXPECT_EQ(value("curvature: split above"), "28.6");
    EXPECT_EQ(value("fabric"), property.fabric.name);
}

TEST(Thesis, configurations_are_drawn_with_all_their_internal_triangles) {
    const ThesisResult result = draw_configurations(kQuick);
    ASSERT_EQ(result.drawings.size(), 3U);
    const std::string& svg = result.drawings[2].svg;
    std::size_t names = 0;
    for (std::size_t at = svg.find(">t"); at != std::string::npos; at = svg.find(">t", at + 1)) ++names;
    EXPECT_EQ(names, 3 * 2 + 6 * 3 + 4U);
}

TEST(Thesis, a_length_is_corrected_by_the_lighter_end_and_a_hanging_cloth_is_measured_at_each_level) {
    const ThesisResult result = measure_length_corrections(kQuick);
    const Table& one = table_named(result, "listing-3.12");
    for (std::size_t row = 0; row < 3; ++row) EXPECT_NEAR(number(one, row, 2), 11, 1e-4) << "10 % more than 10 cm";
    EXPECT_NEAR(number(one, 1, 3), 3 * number(one, 1, 4), 1e-4) << "masses of 1 : 3";
    EXPECT_EQ(number(one, 2, 3), 0) << "pinned";
    EXPECT_NEAR(number(one, 3, 2), 13, 1e-4) << "both are pinned";
    EXPECT_NEAR(number(one, 4, 2), 10.5, 1e-4) << "not too long";
    const Table& hanging = table_named(result, "listing-3.12-hanging");
    ASSERT_EQ(hanging.rows.size(), 2U);
    EXPECT_EQ(number(hanging, 0, 1), 56);
    EXPECT_EQ(number(hanging, 1, 1), 208);
}

TEST(LabelledSheet, enlarges_the_labels_of_wide_sheets_as_far_as_they_fit) {
    const auto height_of = [](const std::string& label) {
        return labelled_sheet({{label, render::Image(300, 10)},
                               {"b", render::Image(300, 10)},
                               {"c", render::Image(300, 10)},
                               {"d", render::Image(300, 10)},
                               {"e", render::Image(300, 10)}},
                              5)
            .height_px;
    };
    EXPECT_EQ(height_of("short"), 10 + 2 * 13) << "1,500 px wide";
    EXPECT_EQ(height_of("a label that is twice too long for its tile"), 10 + 13);
}

// A picture shows something if it has more than a few colours.
std::size_t colour_count(const render::Image& image) {
    return std::set<render::Rgba8>(image.pixels.begin(), image.pixels.end()).size();
}

TEST(Thesis, pictures_of_the_mesh_and_of_collision_grids_show_something) {
    std::vector<Capture> captures;
    for (const auto& draw : {draw_mesh_pictures, draw_test_pattern, draw_hanging_tartans, draw_collision_grids}) {
        for (Capture& capture : draw(kQuick).captures) captures.push_back(std::move(capture));
    }
    std::set<std::string> names;
    for (const Capture& capture : captures) {
        names.insert(capture.name);
        EXPECT_GT(colour_count(capture.image), 200U) << capture.name;
    }
    EXPECT_EQ(names, (std::set<std::string>{"3.16", "3.17", "3.18", "3.19", "3.20", "4.7", "4.8"}));
}

}  // namespace

// The choices of a diagonal that the thesis tried, on two crossing diagonals of one cloth.

namespace {

class DiagonalCost : public testing::Test {
 protected:
    bool prefers_first(DiagonalChoice choice) const {
        const auto cost = diagonal_cost(cloth, choice);
        return cost(first) < cost(second);
    }

    sim::Cloth cloth = make_cloth(sim::make_square({.columns = 1, .rows = 1}), {sim::find_fabric("cotton_shirting")});
    sim::Diagonal first{.a = sim::VertexId(0), .b = sim::VertexId(3), .u_a = {0, 0}, .u_b = {1, 1}};
    sim::Diagonal second{.a = sim::VertexId(1), .b = sim::VertexId(2), .u_a = {1, 0}, .u_b = {0, 0.5F}};
};

TEST_F(DiagonalCost, of_the_minimal_change_does_not_exist) {
    EXPECT_FALSE(diagonal_cost(cloth, DiagonalChoice::MinimalChange));
}

TEST_F(DiagonalCost, is_the_length_in_the_material) {
    EXPECT_FALSE(prefers_first(DiagonalChoice::RestLength));
    second.u_b = {0, 2};
    EXPECT_TRUE(prefers_first(DiagonalChoice::RestLength));
}

TEST_F(DiagonalCost, is_the_length_in_space) {
    cloth.x[0] = {-1, 0, 0, 0};
    EXPECT_FALSE(prefers_first(DiagonalChoice::Length));
    cloth.x[0] = cloth.x[3];
    EXPECT_TRUE(prefers_first(DiagonalChoice::Length));
}

TEST_F(DiagonalCost, is_lower_where_the_surface_bends_less) {
    for (Vec3f& normal : cloth.normals) normal = Vec3f::UnitY();
    cloth.normals[0] = Vec3f::UnitX();
    EXPECT_FALSE(prefers_first(DiagonalChoice::Curvature));
    cloth.normals[1] = -Vec3f::UnitY();
    EXPECT_TRUE(prefers_first(DiagonalChoice::Curvature));
}

}  // namespace

}  // namespace selvedge::bench
