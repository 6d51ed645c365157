// Every table and figure of the thesis at small size. Checks only what does not depend on timing.
#include <gtest/gtest.h>
#include <algorithm>
#include <set>

#include "bench/support/measured_mesh.h"
#include "bench/thesis/point_search.h"
#include "bench/thesis/pointer_mesh.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"

namespace selvedge::bench {
namespace {

constexpr ThesisOptions kQuick{.is_quick = true};

const Table& table_named(const ThesisResult& result, const std::string& name) {
    const auto is_it = [&](const Table& table) { return table.name == name; };
    return *std::find_if(result.tables.begin(), result.tables.end(), is_it);
}

double number(const Table& table, std::size_t row, std::size_t column) {
    return table.rows[row][column].to_json().number();
}

std::set<std::string> table_names(const ThesisResult& result) {
    std::set<std::string> names;
    for (const Table& table : result.tables) names.insert(table.name);
    return names;
}

TEST(Thesis, no_name_is_promised_twice_and_none_of_the_thesis_is_missing) {
    std::set<std::string> tables, figures;
    for (const Experiment& experiment : thesis_experiments()) {
        for (const std::string& name : experiment.tables) EXPECT_TRUE(tables.insert(name).second) << name;
        for (const std::string& name : experiment.figures) EXPECT_TRUE(figures.insert(name).second) << name;
    }
    for (int i = 1; i <= 14; ++i) EXPECT_TRUE(tables.contains("3." + std::to_string(i))) << i;
    for (const char* name : {"4.1", "6.2", "6.3"}) EXPECT_TRUE(tables.contains(name)) << name;
    for (const char* name : {"6.4", "6.5", "6.6"}) EXPECT_TRUE(figures.contains(name)) << name;
    EXPECT_TRUE(figures.contains("3.9"));
    for (int i = 21; i <= 30; ++i) EXPECT_TRUE(figures.contains("3." + std::to_string(i))) << i;
}

TEST(Thesis, transitions_have_a_cost_each_and_none_to_themselves) {
    const ThesisResult result = measure_transition_cost(kQuick);
    EXPECT_EQ(table_names(result), (std::set<std::string>{"3.2", "3.3", "3.4", "3.5", "3.2-3.5"}));
    EXPECT_EQ(table_named(result, "3.2").rows.size(), 10U);
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
        EXPECT_EQ(number(table, level, 1), edges[level]);
        EXPECT_EQ(number(table, level, 5), triangles[level]);
    }
}

TEST(Thesis, uniform_refinement_makes_the_elements_that_the_thesis_counted) {
    const ThesisResult result = measure_uniform_refinement(kQuick);
    const Table& table = table_named(result, "3.7");
    const std::array<std::array<double, 3>, 4> counts{
        {{25, 56, 32}, {81, 264, 160}, {289, 1064, 672}, {1089, 4200, 2720}}};
    for (std::size_t level = 0; level < 4; ++level)
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(number(table, level, 1 + i), counts[level][i]);
    ASSERT_EQ(result.figures.size(), 2U);
    EXPECT_EQ(number(result.figures[0].series, 1, 0), 128);
}

template <class Store>
void expect_the_same_elements() {
    const sim::GarmentMesh base = make_square({.columns = 4, .rows = 4});
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

TEST(Thesis, uniform_drops_have_four_times_the_triangles_on_each_level) {
    const ThesisResult result = measure_uniform_drops(kQuick);
    for (const Table& table : result.tables) {
        ASSERT_EQ(table.rows.size(), 2U);
        EXPECT_EQ(number(table, 0, 1), 32);
        EXPECT_EQ(number(table, 1, 1), 128);
    }
    EXPECT_EQ(table_names(result), (std::set<std::string>{"3.12", "3.13"}));
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
    EXPECT_EQ(table_named(result, "3.14").rows.size(), 8U);
}

TEST(Thesis, tie_breakers_stand_side_by_side_on_both_objects) {
    const ThesisResult result = measure_tie_breakers(kQuick);
    const Table& table = result.figures.at(0).series;
    EXPECT_EQ(table.name, "3.9");
    ASSERT_EQ(table.rows.size(), 8U);
    std::set<std::string> names;
    for (std::size_t row = 0; row < 8; ++row) names.insert(table.rows[row][1].to_text());
    EXPECT_EQ(names, (std::set<std::string>{"least work", "length", "rest length", "curvature"}));
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

TEST(Thesis, step_by_step_timings_have_a_row_for_each_frame) {
    const ThesisResult result = measure_drop_timings(kQuick);
    ASSERT_EQ(result.figures.size(), 6U);
    for (const Figure& figure : result.figures) {
        EXPECT_EQ(figure.series.rows.size(), 9U);
        EXPECT_EQ(figure.series.columns.size(), 6U);
        EXPECT_NEAR(number(figure.series, 8, 0), 0.3, 1e-9);
        EXPECT_GE(number(figure.series, 8, 5), 32);
    }
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
    for (const Capture& capture : result.captures) EXPECT_EQ(capture.image.width_px, 3 * 96 + 2 * 4);
}

TEST(Thesis, of_two_pictures_of_one_surface_that_with_normals_of_its_triangles_differs) {
    const ThesisResult result = measure_surface_lighting(kQuick);
    const render::Image& pair = result.captures.front().image;
    int differ = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) differ += pair.at(x, y) != pair.at(x + 100, y) ? 1 : 0;
    EXPECT_GT(differ, 500);
}

TEST(Thesis, a_surface_through_sampled_points_is_nearer_to_the_fine_cloth_when_it_is_curved) {
    const Table table = measure_surface_distance(kQuick).tables.front();
    ASSERT_EQ(table.rows.size(), 6U);
    const double flat = number(table, 0, 1);
    for (std::size_t kind = 1; kind < 6; ++kind) EXPECT_LT(number(table, kind, 1), flat);
}

TEST(Thesis, a_modifier_bends_more_the_shorter_an_edge_is) {
    const ThesisResult result = measure_curve_modifiers(kQuick);
    const Table& m = result.figures.front().series;
    ASSERT_EQ(m.rows.size(), 81U);
    for (std::size_t i = 1; i < m.rows.size(); ++i) {
        EXPECT_EQ(number(m, i, 1), 0);
        EXPECT_EQ(number(m, i, 2), 1);
        for (std::size_t kind = 3; kind <= 6; ++kind) EXPECT_GE(number(m, i, kind), number(m, i - 1, kind));
    }
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

    sim::Cloth cloth = make_cloth(make_square({.columns = 1, .rows = 1}), {sim::find_fabric("cotton_shirting")});
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
