#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "sim/core/error.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/outline.h"
#include "tests/sim/mesh/shapes.h"
#include "tests/support/right_wrong.h"

namespace selvedge::sim {
namespace {

GarmentMesh sew_soundly(const Pattern& pattern, const MeshOptions& options = {}) {
    const GarmentMesh unsewn = assemble(pattern, options);
    const GarmentMesh sewn = sew_together(unsewn);
    for (const GarmentMesh* mesh : {&unsewn, &sewn}) {
        const auto faults = check_mesh(*mesh);
        EXPECT_EQ(faults.size(), 0U) << faults[0];
    }
    EXPECT_EQ(unsewn.triangles.size(), sewn.triangles.size());
    EXPECT_TRUE(sewn.links.empty());
    return sewn;
}

Pattern two_squares() {
    Pattern pattern;
    pattern.panels = {rectangle("left", 0.3, 0.3), rectangle("right", 0.3, 0.3)};
    pattern.panels[1].translation = {0.4, 0, 0};
    pattern.seams = {{{0, 1}, {1, 3}}};
    return pattern;
}

TEST(Assemble, links_matching_samples_of_both_sides_with_the_ends) {
    const Pattern pattern = two_squares();
    const GarmentMesh unsewn = assemble(pattern);
    ASSERT_EQ(unsewn.links.size(), 7U);
    for (const SeamLink& link : unsewn.links) {
        const Vec3d& a = unsewn.x[static_cast<std::size_t>(link.a)];
        const Vec3d& b = unsewn.x[static_cast<std::size_t>(link.b)];
        EXPECT_NEAR(a.y(), b.y(), 1e-15);
        EXPECT_NEAR(b.x() - a.x(), 0.1, 1e-15);
    }
    EXPECT_EQ(unsewn.panel_names, (std::vector<std::string>{"left", "right"}));
}

// The length of all sides on that edge of the panel, m.
double length_on(const GarmentMesh& mesh, int panel, int edge) {
    double sum = 0;
    for (const GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            if (t.panel == panel && t.lines[k].edge == edge) sum += (t.u[(k + 1) % 3] - t.u[k]).norm();
    }
    return sum;
}

TEST(Assemble, knows_the_outline_edge_of_each_side_at_the_border_before_and_after_sewing) {
    const Pattern pattern = two_squares();
    const GarmentMesh unsewn = assemble(pattern);
    for (const GarmentMesh& mesh : {unsewn, sew_together(unsewn)}) {
        EXPECT_TRUE(check_mesh(mesh).empty());
        for (int panel = 0; panel < 2; ++panel)
            for (int edge = 0; edge < 4; ++edge) EXPECT_NEAR(length_on(mesh, panel, edge), 0.3, 1e-12);
    }
}

TEST(Assemble, keeps_the_lines_of_triangles_that_are_split_so_that_sewn_edges_do_not_coincide) {
    Pattern pattern = two_squares();
    pattern.panels[0].edges[0].label = "hem";
    pattern.seams = {{{0, 0}, {0, 1}}, {{0, 2}, {0, 3}}};
    const GarmentMesh sewn = sew_soundly(pattern, {.target_edge = 0.12});
    for (int edge = 0; edge < 4; ++edge) EXPECT_NEAR(length_on(sewn, 0, edge), 0.3, 1e-12);
}

TEST(Assemble, places_mirrored_and_turned_panels_but_keeps_their_material_coordinates) {
    Pattern pattern;
    pattern.panels = {rectangle("back", 0.3, 0.2)};
    Panel& panel = pattern.panels[0];
    panel.is_mirrored = true;
    panel.rotation = Eigen::AngleAxisd(kPi / 2, Vec3d::UnitX()).toRotationMatrix();
    panel.translation = {1, 2, 3};
    panel.grain_angle = 0.4;
    const GarmentMesh mesh = assemble(pattern);
    for (const GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d expected(1 - t.u[k].x(), 2, 3 + t.u[k].y());
            EXPECT_LT((mesh.x[static_cast<std::size_t>(t.vertices[k])] - expected).norm(), 1e-14);
        }
    }
    EXPECT_EQ(mesh.panel_grain_angles, std::vector<double>{0.4});
}

TEST(Assemble, leaves_out_what_is_not_worn_and_its_seams) {
    Pattern pattern = two_squares();
    pattern.panels.push_back(rectangle("below", 0.3, 0.3));
    pattern.seams.push_back({{0, 0}, {2, 2}});
    pattern.panels[1].is_worn = false;
    pattern.panels[1].pins = {0};
    const GarmentMesh mesh = assemble(pattern);
    EXPECT_EQ(mesh.panel_names.size(), 3U);
    for (const GarmentTriangle& triangle : mesh.triangles) EXPECT_NE(triangle.panel, 1);
    ASSERT_FALSE(mesh.links.empty());
    for (const SeamLink& link : mesh.links) EXPECT_EQ(link.seam, 1);
    EXPECT_TRUE(mesh.pins.empty());
    EXPECT_EQ(check_mesh(mesh).size(), 0U);
    for (Panel& panel : pattern.panels) panel.is_worn = false;
    EXPECT_THROW(assemble(pattern), InputError);
}

TEST(Assemble, carries_pins_to_the_corners_they_name) {
    Pattern pattern = two_squares();
    pattern.panels[1].pins = {2};
    const GarmentMesh unsewn = assemble(pattern);
    ASSERT_EQ(unsewn.pins.size(), 1U);
    EXPECT_LT((unsewn.x[static_cast<std::size_t>(unsewn.pins[0])] - Vec3d(0.7, 0.3, 0)).norm(), 1e-15);
    const GarmentMesh sewn = sew_together(unsewn);
    ASSERT_EQ(sewn.pins.size(), 1U);
    EXPECT_LT((sewn.x[static_cast<std::size_t>(sewn.pins[0])] - Vec3d(0.7, 0.3, 0)).norm(), 1e-15);
}

TEST(MergeSeams, joins_two_squares_half_way_between_them) {
    const GarmentMesh unsewn = assemble(two_squares());
    GarmentMesh sewn = unsewn;
    const std::vector<int> sewn_vertex = merge_seams(sewn);
    EXPECT_EQ(sewn.x.size() + 7, unsewn.x.size());
    for (const SeamLink& link : unsewn.links) {
        const int merged = sewn_vertex[static_cast<std::size_t>(link.a)];
        EXPECT_EQ(merged, sewn_vertex[static_cast<std::size_t>(link.b)]);
        EXPECT_NEAR(sewn.x[static_cast<std::size_t>(merged)].x(), 0.35, 1e-15);
    }
    for (std::size_t t = 0; t < unsewn.triangles.size(); ++t) {
        EXPECT_EQ(unsewn.triangles[t].u, sewn.triangles[t].u);
        EXPECT_EQ(unsewn.triangles[t].panel, sewn.triangles[t].panel);
    }
    const Topology topology = topology_of(sew_soundly(two_squares()));
    EXPECT_EQ(topology.euler, 1);
    EXPECT_EQ(topology.boundary_loops, 1);
}

TEST(MergeSeams, joins_starts_to_starts_when_a_seam_is_not_reversed) {
    Pattern pattern = two_squares();
    pattern.seams[0].is_reversed = false;
    const GarmentMesh unsewn = assemble(pattern);
    const SeamLink& first = unsewn.links.front();
    EXPECT_NEAR(unsewn.x[static_cast<std::size_t>(first.a)].y(), 0, 1e-15);
    EXPECT_NEAR(unsewn.x[static_cast<std::size_t>(first.b)].y(), 0.3, 1e-15);
    const Topology topology = topology_of(sew_soundly(pattern));
    EXPECT_EQ(topology.euler, 1);
    EXPECT_EQ(topology.boundary_loops, 1);
}

TEST(MergeSeams, sews_three_panels_to_a_moebius_band) {
    Pattern pattern;
    for (const char* name : {"a", "b", "c"}) pattern.panels.push_back(rectangle(name, 0.3, 0.1));
    pattern.seams = {{{0, 1}, {1, 3}}, {{1, 1}, {2, 3}}, {.first = {2, 1}, .second = {0, 3}, .is_reversed = false}};
    const Topology topology = topology_of(sew_soundly(pattern));
    EXPECT_EQ(topology.euler, 0);
    EXPECT_EQ(topology.boundary_loops, 1) << "a tube has two";
}

TEST(MergeSeams, sews_a_mirrored_panel_right_side_to_wrong_side_as_the_other_one) {
    Pattern pattern = two_squares();
    const GarmentMesh plain = assemble(pattern);
    test::mirror_panel(pattern, 1);
    EXPECT_TRUE(joins_right_to_wrong(pattern.seams[0]));
    const GarmentMesh mirrored = assemble(pattern);
    ASSERT_EQ(mirrored.links.size(), plain.links.size());
    const auto at = [](const GarmentMesh& mesh, int v) { return mesh.x[static_cast<std::size_t>(v)]; };
    for (std::size_t i = 0; i < plain.links.size(); ++i) {
        EXPECT_LT((at(mirrored, mirrored.links[i].a) - at(plain, plain.links[i].a)).norm(), 1e-12);
        EXPECT_LT((at(mirrored, mirrored.links[i].b) - at(plain, plain.links[i].b)).norm(), 1e-12);
    }
}

TEST(MergeSeams, closes_a_dart_to_its_tip) {
    for (double width : {0.05, 0.01, 0.0005}) {
        Pattern pattern;
        pattern.panels = {square_with_dart(0.5, width, 0.2)};
        pattern.seams = {{{0, 1}, {0, 2}}};
        const GarmentMesh unsewn = assemble(pattern);
        EXPECT_EQ(unsewn.links.size(), 4U) << "the tip is one vertex already";
        const Topology topology = topology_of(sew_soundly(pattern));
        EXPECT_EQ(topology.euler, 1);
        EXPECT_EQ(topology.boundary_loops, 1);
    }
}

TEST(MergeSeams, closes_a_slit_without_width_into_the_ring_it_cut_open) {
    Pattern pattern;
    pattern.panels = {polygon(
        "poncho",
        {{0, 0}, {0.4, 0}, {0.4, 0.3}, {0.3, 0.5}, {0.5, 0.5}, {0.4, 0.3}, {0.4, 0}, {0.8, 0}, {0.8, 0.8}, {0, 0.8}})};
    pattern.seams = {{{0, 1}, {0, 5}}};
    const GarmentMesh sewn = sew_soundly(pattern);
    const Topology topology = topology_of(sewn);
    EXPECT_EQ(topology.euler, 0);
    EXPECT_EQ(topology.boundary_loops, 2);
    EXPECT_EQ(count_seam_edges(assemble(pattern), sewn), 6);
}

TEST(MergeSeams, leaves_three_panels_on_one_edge_for_the_check_to_find) {
    Pattern pattern = two_squares();
    pattern.panels.push_back(rectangle("third", 0.3, 0.3));
    pattern.seams.push_back({{0, 1}, {2, 3}});
    const auto faults = check_mesh(sew_together(assemble(pattern)));
    ASSERT_EQ(faults.size(), 6U) << "one for each seam edge";
    EXPECT_NE(faults[0].find("3 triangles meet"), std::string::npos) << faults[0];
}

TEST(MergeSeams, merges_the_corner_where_three_seams_meet) {
    Pattern pattern;
    pattern.panels = {rectangle("floor", 0.2, 0.2), rectangle("wall", 0.2, 0.2), rectangle("side", 0.2, 0.2)};
    // All three meet at their corner 0: edge 0 of each panel is sewn to edge 3 of the next.
    pattern.seams = {{{0, 0}, {1, 3}}, {{1, 0}, {2, 3}}, {{2, 0}, {0, 3}}};
    const GarmentMesh unsewn = assemble(pattern);
    GarmentMesh sewn = unsewn;
    const std::vector<int> sewn_vertex = merge_seams(sewn);
    std::vector<int> corner;
    for (const GarmentTriangle& t : unsewn.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (t.u[k].norm() < 1e-12) corner.push_back(sewn_vertex[static_cast<std::size_t>(t.vertices[k])]);
        }
    }
    ASSERT_GE(corner.size(), 3U);
    for (int vertex : corner) EXPECT_EQ(vertex, corner[0]);
    EXPECT_EQ(topology_of(sew_soundly(pattern)).boundary_loops, 1);
}

TEST(MergeSeams, closes_tubes_however_narrow) {
    for (double around : {0.6, 0.2, 0.1, 0.05, 0.02}) {
        for (double length : {0.5, 0.1, 0.03}) {
            Pattern pattern;
            pattern.panels = {rectangle("sleeve", around, length)};
            pattern.seams = {{{0, 1}, {0, 3}}};
            const Topology topology = topology_of(sew_soundly(pattern));
            EXPECT_EQ(topology.euler, 0) << around << " " << length;
            EXPECT_EQ(topology.boundary_loops, 2) << around << " " << length;
        }
    }
}

TEST(MergeSeams, closes_tubes_of_two_panels_however_narrow) {
    for (double width : {0.3, 0.1, 0.04}) {
        Pattern pattern;
        pattern.panels = {rectangle("front", width, 0.3), rectangle("back", width, 0.3)};
        pattern.seams = {{{0, 1}, {1, 3}}, {{0, 3}, {1, 1}}};
        const Topology topology = topology_of(sew_soundly(pattern));
        EXPECT_EQ(topology.euler, 0) << width;
        EXPECT_EQ(topology.boundary_loops, 2) << width;
    }
}

TEST(MergeSeams, makes_a_cone_of_a_corner_sewn_to_itself) {
    for (double side : {0.3, 0.1, 0.04}) {
        Pattern pattern;
        pattern.panels = {rectangle("corner", side, side)};
        pattern.seams = {{{0, 0}, {0, 1}}};
        const Topology topology = topology_of(sew_soundly(pattern));
        EXPECT_EQ(topology.euler, 1) << side;
        EXPECT_EQ(topology.boundary_loops, 1) << side;
    }
}

TEST(MergeSeams, makes_a_pillow_of_two_squares_sewn_all_round) {
    for (double side : {0.4, 0.12, 0.05}) {
        Pattern pattern;
        pattern.panels = {rectangle("front", side, side), rectangle("back", side, side)};
        pattern.seams = {{{0, 0}, {1, 0}}, {{0, 1}, {1, 3}}, {{0, 2}, {1, 2}}, {{0, 3}, {1, 1}}};
        const Topology topology = topology_of(sew_soundly(pattern));
        EXPECT_EQ(topology.euler, 2) << side;
        EXPECT_EQ(topology.boundary_loops, 0) << side;
    }
}

// A sleeve cap with ease: its curve is longer than the armhole's, but both get the same number of samples.
TEST(MergeSeams, sets_a_sleeve_cap_into_an_armhole_that_is_shorter) {
    Pattern pattern;
    pattern.panels = {rectangle("body", 0.4, 0.45), rectangle("sleeve", 0.42, 0.2)};
    OutlineEdge& armhole = pattern.panels[0].edges[1];
    armhole.kind = CurveKind::Quadratic;
    armhole.control[0] = {0.3, 0.22};
    OutlineEdge& cap = pattern.panels[1].edges[2];
    cap.kind = CurveKind::Cubic;
    cap.control = {Vec2d(0.33, 0.36), Vec2d(0.09, 0.36)};
    pattern.seams = {{{0, 1}, {1, 2}}};
    const GarmentMesh sewn = sew_soundly(pattern);
    EXPECT_EQ(topology_of(sewn).euler, 1);
    const MeshReport report = report_mesh(pattern, sewn);
    ASSERT_TRUE(report.worst_mismatch);
    const double body = outline_length(pattern.panels[0], armhole);
    const double sleeve = outline_length(pattern.panels[1], cap);
    EXPECT_NEAR(report.worst_mismatch->ratio, std::max(body, sleeve) / std::min(body, sleeve), 1e-12);
    const GarmentMesh unsewn = assemble(pattern);
    EXPECT_EQ(count_seam_edges(unsewn, sewn), static_cast<int>(unsewn.links.size()) - 1);
    EXPECT_GT(report.min_angle_deg, 25);
}

TEST(ReportMesh, counts_what_there_is) {
    const Pattern pattern = two_squares();
    const GarmentMesh unsewn = assemble(pattern);
    const MeshReport report = report_mesh(pattern, sew_together(unsewn));
    EXPECT_EQ(report.triangles, static_cast<int>(unsewn.triangles.size()));
    EXPECT_EQ(report_mesh(pattern, unsewn).min_angle_deg, report.min_angle_deg);
    ASSERT_TRUE(report.worst_mismatch);
    EXPECT_NEAR(report.worst_mismatch->ratio, 1, 1e-12);
    EXPECT_GT(report.min_angle_deg, 30);
}

TEST(ReportMesh, has_no_mismatch_without_seams) {
    Pattern pattern;
    pattern.panels = {rectangle("only", 0.3, 0.3)};
    EXPECT_FALSE(report_mesh(pattern, assemble(pattern)).worst_mismatch);
}

TEST(SeamRestLength, is_the_average_within_the_ease) {
    EXPECT_DOUBLE_EQ(seam_rest_length(1.0, 1.04), 1.02);
    EXPECT_DOUBLE_EQ(seam_rest_length(1.04, 1.0), 1.02);
    EXPECT_DOUBLE_EQ(seam_rest_length(0.3, 0.3), 0.3);
}

TEST(SeamRestLength, is_the_shorter_side_of_gathers) {
    EXPECT_DOUBLE_EQ(seam_rest_length(1.0, 1.3), 1.0);
    EXPECT_DOUBLE_EQ(seam_rest_length(2.2, 1.0), 1.0);
}

TEST(SeamRestLength, takes_another_limit_of_ease) {
    EXPECT_DOUBLE_EQ(seam_rest_length(1.0, 1.3, {.ease = 0.5}), 1.15);
}

// Adds a square of two triangles, with its corner vertices in counter-clockwise order.
void add_square(GarmentMesh& mesh, const Vec3d& shift) {
    const auto first = static_cast<int>(mesh.x.size());
    const std::vector<Vec2d> u{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const Vec2d& p : u) mesh.x.push_back(Vec3d(p.x(), p.y(), 0) + shift);
    mesh.triangles.push_back({{first, first + 1, first + 2}, {u[0], u[1], u[2]}, 0});
    mesh.triangles.push_back({{first, first + 2, first + 3}, {u[0], u[2], u[3]}, 0});
}

GarmentMesh named(GarmentMesh mesh) {
    mesh.panel_names = {"square"};
    mesh.panel_grain_angles = {0};
    return mesh;
}

double total_area(const GarmentMesh& mesh) {
    double area = 0;
    for (const GarmentTriangle& t : mesh.triangles) area += area_of(t.u);
    return area;
}

TEST(SeparateCoincidingEdges, leaves_a_mesh_alone_that_sews_well) {
    GarmentMesh mesh = named({});
    add_square(mesh, {0, 0, 0});
    add_square(mesh, {1, 0, 0});
    mesh.links = {{1, 4, 0}, {2, 7, 0}};
    EXPECT_EQ(separate_coinciding_edges(mesh), 0);
    EXPECT_EQ(mesh.triangles.size(), 4U);
}

TEST(SeparateCoincidingEdges, keeps_two_diagonals_apart_whose_ends_are_sewn_together) {
    GarmentMesh mesh = named({});
    add_square(mesh, {0, 0, 0});
    add_square(mesh, {0, 0, 0});
    mesh.links = {{0, 6, 0}, {1, 5, 0}, {2, 4, 0}};  // the diagonals 0-2 and 4-6 would become one edge
    EXPECT_FALSE(check_mesh(sew_together(mesh)).empty());
    EXPECT_EQ(separate_coinciding_edges(mesh), 2);
    const GarmentMesh sewn = sew_together(mesh);
    const auto faults = check_mesh(sewn);
    EXPECT_TRUE(faults.empty()) << faults[0];
    EXPECT_NEAR(total_area(sewn), 2, 1e-12);
}

TEST(SeparateCoincidingEdges, saves_a_corner_triangle_whose_two_outline_edges_are_sewn_together) {
    GarmentMesh mesh = named({});
    add_square(mesh, {0, 0, 0});
    mesh.links = {{0, 2, 0}};  // sews 0-1 to 2-1: the diagonal 0-2 would vanish
    EXPECT_FALSE(check_mesh(sew_together(mesh)).empty());
    EXPECT_GT(separate_coinciding_edges(mesh), 1);
    const GarmentMesh sewn = sew_together(mesh);
    const auto faults = check_mesh(sewn);
    EXPECT_EQ(faults.size(), 0U) << faults[0];
    EXPECT_NEAR(total_area(sewn), 1, 1e-12);
}

}  // namespace

}  // namespace selvedge::sim
