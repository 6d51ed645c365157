#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <random>

#include "sim/core/error.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sample_outline.h"
#include "sim/mesh/sew.h"
#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/segment_distance.h"
#include "tests/sim/mesh/shapes.h"

namespace selvedge::sim {
namespace {

PanelMesh mesh_of(const Panel& panel, double target_edge = 0.05) {
    Pattern pattern;
    pattern.panels = {panel};
    const MeshOptions options{.target_edge = target_edge};
    return triangulate(panel, count_segments(pattern, options)[0], {.target_edge = target_edge});
}

double min_angle_deg(const PanelMesh& mesh) {
    double smallest = kPi;
    for (const auto& t : mesh.triangles) {
        const auto u = [&](int vertex) { return mesh.u[static_cast<std::size_t>(vertex)]; };
        smallest = std::min(smallest, smallest_angle(u(t[0]), u(t[1]), u(t[2])));
    }
    return smallest * 180 / kPi;
}

// Expects a valid mesh with the topology of a disc and the area of its outline.
void expect_sound(const PanelMesh& mesh) {
    const GarmentMesh garment = as_garment(mesh);
    const std::vector<std::string> faults = check_mesh(garment);
    EXPECT_TRUE(faults.empty()) << faults[0];
    EXPECT_NEAR(area_of(mesh), outline_area_of(mesh), 1e-12 + 1e-10 * area_of(mesh));
    const Topology topology = topology_of(garment);
    EXPECT_EQ(topology.euler, 1);
    EXPECT_EQ(topology.boundary_loops, 1);
}

TEST(Triangulate, adds_no_point_on_the_outline) {
    const Panel panel = rectangle("r", 0.6, 0.4);
    const std::vector<int> segments{3, 17, 40, 1};
    const PanelMesh mesh = triangulate(panel, segments, {.target_edge = 0.05});
    expect_sound(mesh);
    EXPECT_EQ(mesh.outline.size(), 61U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.runs[i].segments, segments[i]);
    for (std::size_t i = mesh.outline.size(); i < mesh.u.size(); ++i) {
        std::vector<Vec2d> outline(mesh.u.begin(), mesh.u.begin() + 61);
        EXPECT_GT(distance_to_outline(mesh.u[i], outline), 1e-3);
    }
}

TEST(Triangulate, makes_well_shaped_triangles_of_the_target_size) {
    const PanelMesh mesh = mesh_of(rectangle("r", 0.6, 0.8));
    expect_sound(mesh);
    EXPECT_GT(min_angle_deg(mesh), 35);
    const double ideal = 0.48 / (std::sqrt(3.0) / 4 * 0.05 * 0.05);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), ideal, 0.15 * ideal);
}

TEST(Triangulate, fills_a_concave_panel_and_nothing_beyond_it) {
    const PanelMesh mesh = mesh_of(
        polygon("t-shape", {{0.2, 0}, {0.4, 0}, {0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0, 0.6}, {0, 0.4}, {0.2, 0.4}}));
    expect_sound(mesh);
    EXPECT_NEAR(area_of(mesh), 0.2 * 0.4 + 0.6 * 0.2, 1e-12);
    EXPECT_GT(min_angle_deg(mesh), 30);
}

TEST(Triangulate, keeps_darts_open_however_narrow) {
    for (double width : {0.04, 0.01, 0.001, 1e-4, 1e-5}) {
        const PanelMesh mesh = mesh_of(square_with_dart(0.5, width, 0.15));
        expect_sound(mesh);
        EXPECT_NEAR(area_of(mesh), 0.25 - width * 0.15 / 2, 1e-12) << width;
        EXPECT_GT(min_angle_deg(mesh), 25) << width;
    }
}

TEST(Triangulate, gives_each_bank_of_a_slit_without_width_its_own_vertices) {
    const PanelMesh mesh =
        mesh_of(polygon("slit", {{0, 0}, {0.25, 0}, {0.25, 0.2}, {0.25, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}));
    expect_sound(mesh);
    EXPECT_NEAR(area_of(mesh), 0.25, 1e-12);
    EXPECT_EQ(mesh.runs[1].segments, 4);
    for (int i = 0; i < 4; ++i) {
        const int one_bank = mesh.outline[static_cast<std::size_t>(mesh.runs[1].first + i)];
        const int other_bank = mesh.outline[static_cast<std::size_t>(mesh.runs[2].first + 4 - i)];
        EXPECT_NE(one_bank, other_bank);
        EXPECT_EQ(mesh.u[static_cast<std::size_t>(one_bank)], mesh.u[static_cast<std::size_t>(other_bank)]);
    }
}

// A poncho: a slit joins the neck hole to the outline.
TEST(Triangulate, cuts_out_a_hole_that_a_slit_joins_to_the_outline) {
    Panel panel =
        polygon("poncho", {{0, 0}, {0.5, 0}, {0.5, 0.4}, {0.5, 0.6}, {0.5, 0.4}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (std::size_t i : {2U, 3U}) {  // a circle of radius 0.1, clockwise
        panel.edges[i].kind = CurveKind::Arc;
        panel.edges[i].arc_radius = 0.1;
        panel.edges[i].turns_right = true;
    }
    const PanelMesh mesh = mesh_of(panel);
    expect_sound(mesh);
    EXPECT_LT(area_of(mesh), 1 - kPi * 0.01 * 0.9);
    EXPECT_GT(area_of(mesh), 1 - kPi * 0.01);
    EXPECT_GT(min_angle_deg(mesh), 30);
}

// A ring whose outer and inner boundary touch in one point; the outline is one loop.
TEST(Triangulate, keeps_apart_two_corners_that_touch_in_a_point) {
    const Panel ring = polygon(
        "ring", {{0.3, 0}, {0.6, 0}, {0.6, 0.6}, {0, 0.6}, {0, 0}, {0.3, 0}, {0.2, 0.3}, {0.3, 0.4}, {0.4, 0.3}});
    const PanelMesh mesh = mesh_of(ring);
    expect_sound(mesh);
    EXPECT_NEAR(area_of(mesh), 0.36 - 0.04, 1e-12);
}

TEST(Triangulate, grades_towards_a_finely_sampled_outline) {
    const Panel panel = rectangle("r", 0.6, 0.4);
    const PanelMesh mesh = triangulate(panel, {60, 8, 12, 8}, {.target_edge = 0.05});
    expect_sound(mesh);
    EXPECT_GT(min_angle_deg(mesh), 25);
}

TEST(Triangulate, meshes_a_strip_too_narrow_for_interior_points) {
    const PanelMesh mesh = mesh_of(rectangle("band", 0.8, 0.02));
    expect_sound(mesh);
    EXPECT_GT(min_angle_deg(mesh), 18);
}

TEST(Triangulate, gives_the_same_bits_each_time) {
    const Panel panel = square_with_dart(0.6, 0.03, 0.2);
    const PanelMesh first = mesh_of(panel);
    const PanelMesh second = mesh_of(panel);
    EXPECT_EQ(first.triangles, second.triangles);
    EXPECT_EQ(first.u, second.u);
}

void expect_refused(const Panel& panel, const std::string& problem) {
    const std::vector<int> segments(panel.edges.size(), 2);
    try {
        triangulate(panel, segments);
        ADD_FAILURE() << "accepted: " << problem;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("panel '" + panel.name + "'"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(problem), std::string::npos) << error.what();
    }
}

TEST(Triangulate, names_the_panel_and_edges_of_an_outline_that_crosses_itself) {
    expect_refused(polygon("bow", {{0, 0}, {1, 1}, {1, 0}, {0, 0.9}}), "crosses itself: edges 0 and 2");
}

TEST(Triangulate, refuses_a_clockwise_outline) {
    expect_refused(polygon("cw", {{0, 0}, {0, 1}, {1, 1}, {1, 0}}), "clockwise");
}

TEST(Triangulate, refuses_an_outline_that_crosses_itself_in_a_corner) {
    expect_refused(polygon("eight", {{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}, {1, 1}, {0.5, 0.5}}), "pinches itself");
}

TEST(Triangulate, refuses_cloth_that_hangs_together_by_a_point) {
    expect_refused(polygon("pinched", {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}),
                   "pinches itself");
}

TEST(Triangulate, refuses_edges_without_length_and_open_outlines) {
    expect_refused(polygon("spot", {{0, 0}, {1, 0}, {1, 0}, {0, 1}}), "edge 1 has no length");
    Panel open = rectangle("open", 1, 1);
    open.edges[1].end = 3;
    expect_refused(open, "open after edge 1");
}

TEST(Triangulate, refuses_numbers_that_are_not_finite) {
    Panel panel = rectangle("nan", 1, 1);
    panel.vertices[2].x() = std::nan("");
    expect_refused(panel, "no finite number");
}

TEST(Triangulate, refuses_a_panel_that_needs_too_many_triangles) {
    const Panel panel = rectangle("sail", 30, 30);
    EXPECT_THROW(triangulate(panel, {600, 600, 600, 600}, {.target_edge = 0.05}), InputError);
}

}  // namespace

// Random panels: for any outline the mesh is valid and the outline is kept.

namespace {

// A star-shaped polygon with 3 to 14 corners, often with deep notches.
Panel random_panel(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const int corners = 3 + static_cast<int>(unit(random) * 12);
    const double size = 0.05 + 0.6 * unit(random);
    const double roughness = unit(random);
    std::vector<Vec2d> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * kPi * (i + 0.7 * unit(random)) / corners;
        const double radius = size * (1 - 0.85 * roughness * unit(random));
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return polygon("random", points);
}

TEST(RandomPanels, become_sound_meshes_that_keep_their_outline) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> segment_count(1, 9);
    for (int run = 0; run < 200; ++run) {
        const Panel panel = random_panel(random);
        std::vector<int> segments;
        for (std::size_t i = 0; i < panel.edges.size(); ++i) segments.push_back(segment_count(random));
        if (outline_area_of({panel.vertices, {}, {0, 1, 2}, {}}) <= 0 && panel.vertices.size() == 3) continue;
        const bool is_relaxed = run % 4 == 0;  // most runs skip relaxing, for speed; the mesh must still be valid
        const PanelMesh mesh = triangulate(panel, segments, {.relaxations = is_relaxed ? 12 : 0});
        const GarmentMesh garment = as_garment(mesh);
        const std::vector<std::string> faults = check_mesh(garment);
        ASSERT_TRUE(faults.empty()) << "run " << run << ": " << faults[0];
        EXPECT_NEAR(area_of(mesh), outline_area_of(mesh), 1e-10) << "run " << run;
        EXPECT_EQ(topology_of(garment).euler, 1) << "run " << run;
        int outline_count = 0;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            EXPECT_EQ(mesh.runs[i].first, outline_count);
            EXPECT_EQ(mesh.runs[i].segments, segments[i]);
            outline_count += segments[i];
        }
        EXPECT_EQ(static_cast<int>(mesh.outline.size()), outline_count);
    }
}

// A panel that is sewn to its mirror image along its whole outline is a closed surface. Small panels with notches test
// all ways in which interior edges of the two sides can coincide.
TEST(RandomPanels, sewn_to_their_mirror_image_are_closed_surfaces) {
    std::mt19937 random(2);
    for (int run = 0; run < 100; ++run) {
        Pattern pattern;
        const Panel front = random_panel(random);
        std::vector<Vec2d> mirrored;
        for (auto p = front.vertices.rbegin(); p != front.vertices.rend(); ++p) mirrored.emplace_back(-p->x(), p->y());
        pattern.panels = {front, polygon("mirrored", mirrored)};
        const auto corners = static_cast<int>(mirrored.size());
        for (int i = 0; i < corners; ++i) {
            pattern.seams.push_back({{0, i}, {1, (2 * corners - 2 - i) % corners}});
        }
        const GarmentMesh sewn = sew_together(assemble(pattern, {.relaxations = run % 4 == 0 ? 12 : 0}));
        const std::vector<std::string> faults = check_mesh(sewn);
        ASSERT_TRUE(faults.empty()) << "run " << run << ": " << faults[0];
        const Topology topology = topology_of(sewn);
        EXPECT_EQ(topology.euler, 2) << "run " << run;
        EXPECT_EQ(topology.boundary_loops, 0) << "run " << run;
    }
}

}  // namespace

// Published GarmentCode patterns, meshed with several target edge lengths.

namespace {

struct RealPattern {
    const char* file;
    double worst_ratio;  // length ratio of seam sides
    int boundary_loops;
};

std::ostream& operator<<(std::ostream& out, const RealPattern& pattern) {
    return out << pattern.file;
}

class RealPatterns : public testing::TestWithParam<RealPattern> {
 protected:
    void SetUp() override {
        const char* data = std::getenv("SELVEDGE_TEST_DATA");
        if (data == nullptr) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
        pattern_ = load_pattern(std::filesystem::path(data) / "garmentcode" / GetParam().file).pattern;
    }

    Pattern pattern_;
};

TEST_P(RealPatterns, are_sewn_into_one_sound_surface_at_every_size) {
    for (double target_edge : {0.03, 0.04, 0.05, 0.06}) {
        const GarmentMesh sewn = sew_together(assemble(pattern_, {.target_edge = target_edge}));
        const auto faults = check_mesh(sewn);
        EXPECT_EQ(faults.size(), 0U) << faults[0];
        const Topology topology = topology_of(sewn);
        EXPECT_EQ(topology.boundary_loops, GetParam().boundary_loops);
        EXPECT_EQ(topology.euler, 2 - GetParam().boundary_loops);
        const MeshReport report = report_mesh(pattern_, sewn);
        EXPECT_GT(report.min_angle_deg, 21) << target_edge << " " << report.min_angle_panel;
        ASSERT_TRUE(report.worst_mismatch);
        EXPECT_NEAR(report.worst_mismatch->ratio, GetParam().worst_ratio, 0.01);
    }
}

TEST_P(RealPatterns, have_hundreds_of_triangles_by_default_and_the_same_bits_each_time) {
    const GarmentMesh first = assemble(pattern_);
    const GarmentMesh second = assemble(pattern_);
    EXPECT_GT(first.triangles.size(), 300U);
    EXPECT_LT(first.triangles.size(), 1200U);
    ASSERT_EQ(first.triangles.size(), second.triangles.size());
    EXPECT_EQ(first.x, second.x);
    for (std::size_t i = 0; i < first.triangles.size(); ++i) {
        EXPECT_EQ(first.triangles[i].vertices, second.triangles[i].vertices);
        EXPECT_EQ(first.triangles[i].u, second.triangles[i].u);
    }
}

INSTANTIATE_TEST_SUITE_P(GarmentCode, RealPatterns,
                         testing::Values(RealPattern{"shirt_mean_specification.json", 1.003, 4},
                                         RealPattern{"dress_pencil_specification.json", 1.302, 4}),
                         [](const auto& tested) {
                             const std::string file = tested.param.file;
                             return file.substr(0, file.find("_specification"));
                         });

}  // namespace

}  // namespace selvedge::sim
