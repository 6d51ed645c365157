#include <gtest/gtest.h>
#include <cmath>
#include <set>

#include "render/draw/renderer.h"
#include "render/marks/show.h"

namespace selvedge::render {
namespace {

// Two squares side by side, each a panel of two triangles, strained by 3 % along y.
Scene stretched(ShowMode mode) {
    Scene scene;
    ClothItem cloth;
    cloth.show = mode;
    sim::DrawMesh& mesh = cloth.mesh;
    constexpr float length = 1.03F;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, length, 0}, {1, length, 0}, {2, length, 0}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    for (const auto& t : mesh.triangles) {
        const auto u = [&](std::size_t i) { return Vec2f(mesh.x[t[i]].x(), mesh.x[t[i]].y() / length); };
        mesh.u.push_back({u(0), u(1), u(2)});
    }
    mesh.panel = {0, 0, 1, 1};
    mesh.panel_names = {"left_front", "left_back"};
    mesh.panel_grain_angles = {0, 1.5707963F};  // the second panel's warp runs along -x
    mesh.level = {0, 0, 1, 1};
    mesh.vertex_level = {0, 0, 1, 0, 0, 2};
    scene.cloths.push_back(cloth);
    return scene;
}

TEST(Show, strain_is_painted_by_each_panels_own_threads) {
    Scene warp = stretched(ShowMode::StrainWarp), weft = stretched(ShowMode::StrainWeft);
    const auto legend = fill_show(warp);
    fill_show(weft);
    ASSERT_TRUE(legend && legend->scale);
    EXPECT_EQ(legend->scale->ticks.back().label, "+3 %");
    for (std::size_t corner = 0; corner < 3; ++corner) {
        EXPECT_NEAR(warp.cloths[0].paint->places[0][corner], 1, 1e-3F) << "3 % is the map's upper end";
        EXPECT_NEAR(warp.cloths[0].paint->places[2][corner], 0.5F, 1e-3F) << "at rest is the middle";
        EXPECT_NEAR(weft.cloths[0].paint->places[0][corner], 0.5F, 1e-3F);
        EXPECT_NEAR(weft.cloths[0].paint->places[2][corner], 1, 1e-3F);
    }
}

TEST(Show, the_greater_strain_is_that_of_either_direction) {
    Scene scene = stretched(ShowMode::Strain);
    fill_show(scene);
    ASSERT_EQ(scene.cloths[0].paint->places.size(), scene.cloths[0].mesh.triangles.size());
    for (const auto& corners : scene.cloths[0].paint->places)
        for (const float place : corners) EXPECT_NEAR(place, 1, 1e-3F);
}

TEST(Show, clearance_is_painted_per_vertex_from_the_figures_given) {
    Scene scene = stretched(ShowMode::Clearance);
    fill_show(scene, {.clearance = {0, 0.005F, 0.01F, 0.02F, 0.02F, 0.02F}});
    const ClothPaint& paint = *scene.cloths[0].paint;
    EXPECT_NEAR(paint.places[0][0], 0, 1e-4F);
    EXPECT_NEAR(paint.places[0][1], 0.25F, 1e-4F);
    EXPECT_NEAR(paint.places[0][2], 1, 1e-4F);
}

// The scene with a cloth for each of its two panels, as if they were of different fabrics.
Scene in_two_fabrics(const Scene& scene) {
    Scene two = scene;
    two.cloths.push_back(two.cloths.front());
    two.cloths[0].mesh = with_triangles(scene.cloths[0].mesh, {0, 1});
    two.cloths[1].mesh = with_triangles(scene.cloths[0].mesh, {2, 3});
    return two;
}

TEST(Show, panels_of_two_fabrics_share_one_scale_and_one_legend) {
    for (const ShowMode mode :
         {ShowMode::StrainWarp, ShowMode::StrainWeft, ShowMode::Strain, ShowMode::Clearance, ShowMode::Panels}) {
        const ShowInput facts{.clearance = {0, 0.005F, 0.01F, 0.02F, 0.02F, 0.02F}};
        Scene one = stretched(mode), two = in_two_fabrics(one);
        const auto legend_of_one = fill_show(one, facts), legend_of_two = fill_show(two, facts);
        const ClothPaint& whole = *one.cloths[0].paint;
        for (std::size_t part = 0; part < 2; ++part) {
            const auto& paint = two.cloths[part].paint;
            ASSERT_TRUE(paint && paint->places.size() == 2) << "mode " << int(mode) << ", part " << part;
            EXPECT_EQ(paint->map, whole.map);
            for (std::size_t t = 0; t < 2; ++t) EXPECT_EQ(paint->places[t], whole.places[2 * part + t]);
        }
        ASSERT_EQ(legend_of_two->rows.size(), legend_of_one->rows.size());
        EXPECT_EQ(legend_of_two->notes, legend_of_one->notes);
    }
}

TEST(Show, a_seam_between_two_fabrics_is_no_hem_and_all_their_cloth_is_quiet) {
    Scene one = stretched(ShowMode::Seams), two = in_two_fabrics(one);
    const auto legend_of_one = fill_show(one), legend_of_two = fill_show(two);
    ASSERT_EQ(legend_of_two->rows.size(), legend_of_one->rows.size());
    for (std::size_t i = 0; i < legend_of_one->rows.size(); ++i)
        EXPECT_EQ(legend_of_two->rows[i].figure, legend_of_one->rows[i].figure);
    EXPECT_EQ(two.cloths[1].colour, one.cloths[0].colour);
    Scene vertices = in_two_fabrics(stretched(ShowMode::Vertices)), of_one = stretched(ShowMode::Vertices);
    fill_show(vertices);
    fill_show(of_one);
    EXPECT_EQ(vertices.solids, of_one.solids);
    EXPECT_EQ(vertices.cloths[1].ink, of_one.cloths[0].ink);
}

TEST(Show, the_legend_of_levels_counts_the_triangles_of_all_fabrics) {
    Scene scene = in_two_fabrics(stretched(ShowMode::Level));
    const auto legend = fill_show(scene);
    ASSERT_TRUE(legend && legend->rows.size() == 2);
    EXPECT_EQ(legend->rows[0].figure, "2");
    EXPECT_EQ(legend->rows[1].figure, "2");
}

TEST(Show, each_panel_has_one_colour_which_the_legend_names) {
    Scene scene = stretched(ShowMode::Panels);
    const auto legend = fill_show(scene);
    ASSERT_TRUE(legend && legend->rows.size() == 2);
    EXPECT_EQ(legend->rows[0].label, "left front");
    EXPECT_NE(legend->rows[0].colour, legend->rows[1].colour);
    const ClothPaint& paint = *scene.cloths[0].paint;
    for (std::size_t t = 0; t < 4; ++t) {
        const auto at = static_cast<std::size_t>(std::lround(paint.places[t][0] * float(paint.map.size() - 1)));
        EXPECT_EQ(paint.map[at], legend->rows[t / 2].colour);
        EXPECT_EQ(paint.places[t][0], paint.places[t][1]);
        EXPECT_EQ(paint.places[t][0], paint.places[t][2]);
    }
}

TEST(Show, a_vertex_is_half_as_large_with_each_level_and_has_its_levels_colour) {
    Scene scene = stretched(ShowMode::Vertices);
    const auto legend = fill_show(scene);
    ASSERT_EQ(scene.solids.size(), 1U);
    const SolidItem& solid = scene.solids[0];
    std::array<float, 3> radius{};
    for (std::size_t i = 0; i < solid.x.size(); ++i) {
        for (int level = 0; level < 3; ++level) {
            if (solid.colours[i] != level_colour(level)) continue;
            float nearest = 1e9F;
            for (const Vec3f& x : scene.cloths[0].mesh.x) nearest = std::min(nearest, (solid.x[i] - x).norm());
            radius[static_cast<std::size_t>(level)] = nearest;
        }
    }
    EXPECT_GT(radius[0], 0.01F);
    EXPECT_NEAR(radius[1] / radius[0], 0.5F, 1e-3F);
    EXPECT_NEAR(radius[2] / radius[0], 0.25F, 1e-3F);
    ASSERT_TRUE(legend && legend->rows.size() == 3);
    EXPECT_EQ(legend->rows[0].figure, "4");
    EXPECT_EQ(legend->rows[2].figure, "1");
}

TEST(Show, seams_have_a_colour_each_and_hems_another) {
    Scene scene = stretched(ShowMode::Seams);
    const auto legend = fill_show(scene);
    ASSERT_TRUE(legend && legend->rows.size() == 2);
    EXPECT_EQ(legend->rows[0].label, "left front + back") << "common words once";
    EXPECT_EQ(legend->rows[0].figure, "103 cm");
    EXPECT_EQ(legend->rows[1].label, "hems");
    std::set<sim::Rgb8> colours(scene.solids.at(0).colours.begin(), scene.solids.at(0).colours.end());
    EXPECT_EQ(colours, (std::set<sim::Rgb8>{legend->rows[0].colour, legend->rows[1].colour}));
}

TEST(Show, the_level_legend_counts_triangles_up_to_the_highest_level) {
    const Legend legend = level_legend(stretched(ShowMode::Level).cloths[0].mesh);
    ASSERT_EQ(legend.rows.size(), 2U);
    EXPECT_EQ(legend.rows[1].colour, level_colour(1));
    EXPECT_EQ(legend.rows[1].figure, "2");
}

TEST(Show, levels_that_a_mesh_does_not_know_are_not_made_up) {
    for (const ShowMode mode : {ShowMode::Level, ShowMode::Vertices}) {
        Scene known = stretched(mode), unknown = stretched(mode);
        unknown.cloths[0].mesh.level.clear();
        unknown.cloths[0].mesh.vertex_level.clear();
        EXPECT_TRUE(fill_show(known)->notes.empty());
        const auto legend = fill_show(unknown);
        ASSERT_EQ(legend->notes.size(), 1U);
        EXPECT_EQ(legend->notes[0][1], "not known");
        EXPECT_EQ(legend->rows.size(), 1U);
    }
}

TEST(Show, a_hierarchy_becomes_a_scene_of_leaves_and_outlines) {
    const std::array<Vec2f, 3> u{Vec2f(0, 0), Vec2f(1, 0), Vec2f(0, 1)};
    Scene scene;
    const Legend legend = fill_hierarchy(
        scene, {{.u = u, .level = 0, .is_leaf = false}, {.u = u, .level = 1, .is_leaf = true}}, StackSide::Behind);
    ASSERT_EQ(scene.cloths.size(), 1U);
    EXPECT_EQ(scene.cloths[0].mesh.triangles.size(), 2U);
    EXPECT_EQ(scene.cloths[0].paint->places.size(), 2U);
    EXPECT_FALSE(scene.solids.at(0).triangles.empty());
    ASSERT_EQ(legend.notes.size(), 2U);
    EXPECT_EQ(legend.notes[0][1], "2");
    EXPECT_EQ(legend.notes[1][1], "1");
}

TEST(Show, modes_that_paint_nothing_have_no_legend) {
    for (const ShowMode mode : {ShowMode::Tartan, ShowMode::Edges, ShowMode::Plain}) {
        Scene scene = stretched(mode);
        EXPECT_FALSE(fill_show(scene));
        EXPECT_FALSE(scene.cloths[0].paint);
        EXPECT_TRUE(scene.solids.empty());
    }
}

TEST(FigureLegend, limits_are_round_and_never_below_the_figure) {
    for (const auto& [value, round] :
         {std::pair{0.01, 0.01}, {0.011, 0.012}, {0.037, 0.04}, {0.071, 0.08}, {0.081, 0.1}, {6.0, 6.0}, {0.3, 0.3}})
        EXPECT_NEAR(round_up(value), round, 1e-9 * round) << value;
}

TEST(FigureLegend, strain_is_written_in_percent_with_its_sign) {
    std::vector<double> strains(100, 0.001);
    strains[0] = -0.0423;
    strains[1] = 0.0961;
    strains[2] = 0.02;
    const Legend legend = strain_legend("Strain", 0.05, strains);
    ASSERT_EQ(legend.notes.size(), 3U);
    EXPECT_EQ(legend.notes[0][1], "+2.0 %");
    EXPECT_EQ(legend.notes[1][1], "+9.6 %");
    EXPECT_EQ(legend.notes[2][1], "-4.2 %");
    ASSERT_TRUE(legend.scale && legend.scale->ticks.size() == 3);
    EXPECT_EQ(legend.scale->ticks[0].label, "-5 %");
    EXPECT_EQ(legend.scale->ticks[1].label, "0");
    EXPECT_EQ(legend.scale->ticks[2].label, "+5 %");
}

TEST(FigureLegend, no_strain_has_no_sign_of_compression) {
    EXPECT_EQ(strain_legend("Strain", 0.01, {-0.0001}).notes[1][1], "+0.0 %");
}

TEST(FigureLegend, clearance_is_written_in_millimetres_and_what_is_inside_is_said) {
    const Legend clear = clearance_legend(0.05, {0.003, 0.012, 0.1});
    EXPECT_EQ(clear.scale->ticks[1].label, "25");
    EXPECT_EQ(clear.scale->ticks[2].label, "50 mm");
    ASSERT_EQ(clear.notes.size(), 3U);
    EXPECT_EQ(clear.notes[0][1], "12 mm");
    EXPECT_EQ(clear.notes[2][1], "100 mm");
    const Legend inside = clearance_legend(0.05, {0.003, -0.0012});
    ASSERT_EQ(inside.notes.size(), 4U);
    EXPECT_EQ(inside.notes[3][1], "1.2 mm");
}

}  // namespace

namespace {

constexpr std::uint32_t kCells = 8;

// A tube of two panels, each covering half of the circumference: two seams, and hems at the top and bottom.
sim::DrawMesh tube() {
    sim::DrawMesh mesh;
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i < 2 * kCells; ++i) {
            const float turn = 3.14159265F * float(i) / float(kCells);
            mesh.x.emplace_back(0.2F * std::cos(turn), 0.1F * float(j), 0.2F * std::sin(turn));
        }
    }
    const auto at = [](std::uint32_t i, std::uint32_t j) { return j * 2 * kCells + i % (2 * kCells); };
    for (std::uint32_t j = 0; j < kCells; ++j) {
        for (std::uint32_t i = 0; i < 2 * kCells; ++i) {
            const auto u = [](std::uint32_t a, std::uint32_t b) { return Vec2f(0.1F * float(a), 0.1F * float(b)); };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            mesh.u.push_back({u(i, j), u(i + 1, j), u(i + 1, j + 1)});
            mesh.u.push_back({u(i, j), u(i + 1, j + 1), u(i, j + 1)});
            const std::uint16_t panel = i < kCells ? 0 : 1;
            mesh.panel.insert(mesh.panel.end(), {panel, panel});
        }
    }
    return mesh;
}

TEST(SeamLines, a_tube_of_two_panels_has_two_seams_of_its_height_and_two_hems_of_each) {
    const SeamLines lines = find_seam_lines(tube());
    ASSERT_EQ(lines.seams.size(), 2U);
    for (const SeamLine& seam : lines.seams) {
        EXPECT_EQ(seam.panels, (std::array<std::uint16_t, 2>{0, 1}));
        ASSERT_EQ(seam.paths.size(), 1U);
        EXPECT_EQ(seam.paths[0].size(), kCells + 1);
        EXPECT_NEAR(seam.length, 0.8, 1e-6);
    }
    EXPECT_EQ(lines.hems.size(), 4U) << "above and below, of either panel";
}

TEST(SeamLines, paths_run_from_edge_to_edge_without_a_gap) {
    const sim::DrawMesh mesh = tube();
    const SeamLines lines = find_seam_lines(mesh);
    ASSERT_FALSE(lines.seams.empty());
    for (const SeamLine& seam : lines.seams) {
        ASSERT_FALSE(seam.paths.empty());
        for (std::size_t i = 1; i < seam.paths[0].size(); ++i) {
            const float step = (mesh.x[seam.paths[0][i]] - mesh.x[seam.paths[0][i - 1]]).norm();
            EXPECT_NEAR(step, 0.1F, 1e-6F);
        }
    }
}

TEST(SeamLines, one_panel_sewn_to_a_tube_has_one_seam_with_itself_and_closed_hems) {
    sim::DrawMesh mesh = tube();
    mesh.panel.assign(mesh.panel.size(), 0);
    const SeamLines lines = find_seam_lines(mesh);
    ASSERT_EQ(lines.seams.size(), 1U);
    EXPECT_EQ(lines.seams[0].panels, (std::array<std::uint16_t, 2>{0, 0}));
    ASSERT_EQ(lines.hems.size(), 2U);
    for (const SeamLine& hem : lines.hems) {
        ASSERT_EQ(hem.paths.size(), 1U);
        EXPECT_EQ(hem.paths[0].front(), hem.paths[0].back()) << "closed";
        EXPECT_EQ(hem.paths[0].size(), 2 * kCells + 1);
    }
}

TEST(SeamLines, every_marked_edge_is_on_exactly_one_path_where_lines_fork) {
    sim::DrawMesh mesh = tube();
    for (std::size_t t = 0; t < mesh.panel.size(); ++t) mesh.panel[t] = static_cast<std::uint16_t>(t / 2 % 2);
    std::size_t edges = 0;
    for (const SeamLine& seam : find_seam_lines(mesh).seams) {
        for (const VertexPath& path : seam.paths) edges += path.size() - 1;
    }
    EXPECT_EQ(edges, 2U * kCells * kCells) << "between any two columns of cells";
}

}  // namespace

}  // namespace selvedge::render
