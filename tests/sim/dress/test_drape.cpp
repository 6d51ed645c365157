// Sewing on a body, also where seams cannot close, and draping.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/resting.h"
#include "sim/collide/body_collider.h"
#include "sim/collide/collider.h"
#include "sim/collide/penetration.h"
#include "sim/dress/drape.h"
#include "sim/dress/dressing.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"
#include "sim/mesh/square.h"
#include "sim/selfcontact/crossings.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/mesh/shapes.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

const SphereCollider& exact_ball() {
    static const SphereCollider sphere(Vec3f(0, 1, 0), 0.15F);
    return sphere;
}

Cloth cloth_above_the_ball() {
    return make_cloth(sim::make_square({.columns = 6, .rows = 6, .width = 0.4, .depth = 0.4, .height = 1.17}),
                      {find_fabric("cotton_shirting")}, {.max_level = 2});
}

SewingResult sew_on_body(const GarmentMesh& unsewn, const std::vector<Fabric>& fabrics, const Collider& body) {
    SewingRun run(unsewn, fabrics, {});
    while (run.advance(body)) continue;
    return std::move(run).result();
}

// Falls until max_seconds, without settling.
DrapeOptions endless() {
    return {.max_seconds = 1e6,
            .rest_time = std::numeric_limits<double>::infinity(),
            .relax_time = 0.1,
            .coarse_time = 0,
            .may_rest = true};
}

TEST(DrapeRun, a_cloth_at_rest_is_neither_adapted_nor_stepped) {
    Simulation simulation(cloth_above_the_ball());
    const Cloth& cloth = simulation.cloth();
    DrapeRun run(simulation, endless());
    for (int frame = 0; frame < 600 && !is_at_rest(cloth); ++frame) run.advance(simulation, exact_ball());
    ASSERT_TRUE(is_at_rest(cloth));
    ASSERT_GT(cloth.mesh.leaf_triangles().size(), cloth.mesh.base_triangle_count());
    const std::vector<Vec4f> there = cloth.x;
    const std::uint32_t adaptations = cloth.adaptations;
    run.clear_times();
    for (int frame = 0; frame < 60; ++frame) run.advance(simulation, exact_ball());
    EXPECT_EQ(cloth.x, there);
    EXPECT_EQ(cloth.adaptations, adaptations);
    EXPECT_TRUE(run.result().adaptation_ms.empty());
    EXPECT_EQ(run.result().rms_speed, 0);
}

// Work is counted: so many triangles in so many steps, and the pairs that contact of the cloth with itself looked at.
TEST(DrapeRun, counts_its_work_and_knows_what_moves_most) {
    SimulationOptions options;
    options.adapt.max_level = 0;
    Simulation simulation(cloth_above_the_ball(), options);
    DrapeOptions draping = endless();
    draping.max_seconds = 0.5;
    draping.finish_time = 0;
    DrapeRun run(simulation, draping);
    while (run.advance(simulation, exact_ball())) continue;
    const auto triangles = static_cast<double>(simulation.cloth().mesh.leaf_triangles().size());
    const double steps = static_cast<double>(run.result().step_ms.size());
    EXPECT_EQ(run.result().work, triangles * steps);
    ASSERT_TRUE(run.result().fastest.has_value());
    EXPECT_LT(run.result().work, most_work(simulation.cloth()));
}

TEST(DrapeRun, rests_only_where_that_is_asked_for) {
    Simulation simulation(cloth_above_the_ball());
    const Cloth& cloth = simulation.cloth();
    DrapeOptions options = endless();
    options.may_rest = false;
    DrapeRun run(simulation, options);
    for (int frame = 0; frame < 300; ++frame) run.advance(simulation, exact_ball());
    EXPECT_FALSE(is_at_rest(cloth));
    EXPECT_EQ(run.result().step_ms.size(), 4 * 300U);
}

TEST(DrapeRun, adapts_calm_cloth_in_every_third_frame) {
    Simulation simulation(cloth_above_the_ball());
    DrapeOptions options = endless();
    options.may_rest = false;
    DrapeRun run(simulation, options);
    for (int frame = 0; frame < 300; ++frame) run.advance(simulation, exact_ball());
    ASSERT_LT(run.result().rms_speed, options.calm_speed);
    const std::size_t before = run.result().adaptation_ms.size();
    for (int frame = 0; frame < 30; ++frame) run.advance(simulation, exact_ball());
    EXPECT_EQ(run.result().adaptation_ms.size() - before, 10U);
}

// The time at which a square that hangs by its upper edge, with nothing to move it, is known to be at rest, s.
double seconds_to_rest(double least_rest_time) {
    GarmentMesh mesh = sim::make_square({.columns = 4, .rows = 4, .width = 0.2, .depth = 0.2, .height = 1});
    for (std::size_t v = 0; v < mesh.x.size(); ++v) mesh.pins.push_back(static_cast<int>(v));
    Simulation simulation(make_cloth(mesh, {find_fabric("cotton_shirting")}, {.max_level = 1}));
    DrapeRun run(simulation,
                 {.least_rest_time = least_rest_time, .relax_time = 0.1, .coarse_time = 0, .finish_time = 0});
    while (run.advance(simulation, NoBody())) continue;
    EXPECT_TRUE(run.result().settled);
    return run.result().simulated_seconds;
}

TEST(DrapeRun, what_hardly_moves_is_watched_for_less_time) {
    EXPECT_NEAR(seconds_to_rest(0.2) - seconds_to_rest(1.0), -0.8, 0.05);
}

TEST(DrapeRun, gives_up_a_garment_that_hangs_calmly) {
    Simulation simulation(cloth_above_the_ball());
    DrapeRun run(simulation, {.relax_time = 0.1, .coarse_time = 0});
    EXPECT_FALSE(run.hangs_calmly());
    while (!run.hangs_calmly()) ASSERT_TRUE(run.advance(simulation, exact_ball()));
    const double seconds = run.result().simulated_seconds;
    run.give_up(simulation, GiveUp::TooSmall);
    EXPECT_FALSE(run.hangs_calmly());
    while (run.advance(simulation, exact_ball())) continue;
    EXPECT_EQ(run.result().given_up, GiveUp::TooSmall);
    EXPECT_FALSE(run.result().settled);
    EXPECT_EQ(run.result().stopped_because(), "too small");
    EXPECT_LE(run.result().simulated_seconds, seconds + 3 * DrapeOptions{}.finish_time + 0.1);
}

TEST(DrapeRun, has_its_last_phase_within_half_a_frame_of_a_limit_that_leaves_time_for_it) {
    for (const double limit : {0.8, 0.81, 0.82, 0.83}) {
        Simulation simulation(cloth_above_the_ball());
        DrapeRun run(simulation, {.max_seconds = limit, .relax_time = 0.1, .coarse_time = 0});
        while (run.phase() != DrapePhase::Finish) ASSERT_TRUE(run.advance(simulation, exact_ball())) << limit;
        EXPECT_NEAR(run.result().simulated_seconds + DrapeOptions{}.finish_time, limit, 0.0168);
    }
}

TEST(DrapeRun, gives_up_before_it_relaxes_what_fits_nowhere) {
    Simulation simulation(cloth_above_the_ball());
    DrapeRun run(simulation, {});
    run.give_up(simulation, GiveUp::TooSmall);
    EXPECT_EQ(run.phase(), DrapePhase::Finish);
    while (run.advance(simulation, exact_ball())) continue;
    EXPECT_EQ(run.result().stopped_because(), "too small");
    EXPECT_LE(run.result().simulated_seconds, 3 * DrapeOptions{}.finish_time + 0.1);
}

// Frames of finer sub-steps after a long strip that is stretched to three times its length was given up.
int frames_to_finish(GiveUp why) {
    Simulation simulation(
        make_cloth(sim::make_square({.columns = 200, .rows = 2, .width = 4, .depth = 0.04, .height = 1.5}),
                   {find_fabric("cotton_shirting")}, {.max_level = 0}));
    for (Vec4f& x : simulation.cloth().x) x.x() *= 3;
    simulation.cloth().x_prev = simulation.cloth().x;
    DrapeRun run(simulation, {});
    run.give_up(simulation, why);
    int frames = 1;
    while (run.advance(simulation, exact_ball())) ++frames;
    return frames;
}

TEST(DrapeRun, takes_one_finer_frame_when_cloth_is_given_up_as_too_small) {
    EXPECT_GT(frames_to_finish(GiveUp::SlipsDown), 1);
    EXPECT_EQ(frames_to_finish(GiveUp::TooSmall), 1);
}

// A ball with bumps of 4 mm, each as wide as a triangle of the cloth.
Body ball_with_bumps() {
    Body body = shapes::sphere(Vec3d(0, 1, 0), 0.15, 80);
    for (Vec3d& x : body.x) {
        const Vec3d out = (x - Vec3d(0, 1, 0)).normalized();
        for (int i = 0; i < 12; ++i) {
            const double angle = 2.1 * i, slope = 0.15 + 0.06 * i;
            const Vec3d bump(std::sin(slope) * std::cos(angle), std::cos(slope), std::sin(slope) * std::sin(angle));
            const double width = 0.15 * (out - bump).norm() / 0.004;
            x += 0.004 * std::exp(-width * width) * out;
        }
    }
    return body;
}

TEST(DrapeRun, ends_with_no_face_inside_the_body) {
    const Body body = ball_with_bumps();
    const BodyCollider collider(body);
    Simulation simulation(cloth_above_the_ball(), {.self_contact = SelfContactOptions{}});
    const Cloth& cloth = simulation.cloth();
    DrapeRun run(simulation, {.max_seconds = 3, .relax_time = 0.1, .coarse_time = 0});
    while (run.advance(simulation, collider)) continue;
    const DrawMesh mesh = draw_mesh(cloth, {});
    const Penetration found = find_penetration(mesh.x, mesh.triangles, collider.surface());
    EXPECT_EQ(found.faces, 0) << found.deepest;
    EXPECT_EQ(found.edges, 0);
    EXPECT_TRUE(find_crossing_triangles(contact_surface(cloth), cloth.x.front().data()).empty());
}

// A square that hangs from its upper edge, with its lower edge 0.15 m below the floor.
Cloth cloth_that_hangs_through_the_floor() {
    Pattern pattern;
    pattern.panels = {rectangle("curtain", {.width = 0.4, .height = 0.4, .y = -0.15})};
    GarmentMesh mesh = assemble(pattern);
    for (std::size_t v = 0; v < mesh.x.size(); ++v) {
        if (mesh.x[v].y() > 0.249) mesh.pins.push_back(static_cast<int>(v));
    }
    return make_cloth(mesh, {find_fabric("cotton_shirting")}, {.max_level = 1});
}

TEST(DrapeRun, takes_a_hem_that_begins_below_the_floor_along_slowly) {
    Simulation simulation(cloth_that_hangs_through_the_floor(), {.self_contact = SelfContactOptions{}});
    const Cloth& cloth = simulation.cloth();
    DrapeRun run(simulation, {.max_seconds = 6});
    ASSERT_LT(lowest_height(cloth), -0.149F);
    float fastest = 0, lowest = lowest_height(cloth), frame = 4 * step_seconds(cloth, {});
    for (int i = 0; i < 15; ++i) {
        run.advance(simulation, NoBody());
        fastest = std::max(fastest, (lowest_height(cloth) - lowest) / frame);
        lowest = lowest_height(cloth);
    }
    EXPECT_LT(lowest, -0.01F);
    EXPECT_LT(fastest, 0.3F) << "m/s";
    EXPECT_GT(fastest, 0.1F) << "m/s";
    while (run.advance(simulation, NoBody())) continue;
    EXPECT_GT(lowest_height(cloth), -1e-5F);
    EXPECT_TRUE(run.result().settled);
    EXPECT_TRUE(find_crossing_triangles(contact_surface(cloth), cloth.x.front().data()).empty());
}

// A box of 0.2 x 0.12 m, so with a girth of 0.64 m, standing on the floor.
class SewOnABox : public testing::Test {
 protected:
    SewingResult sew(const Pattern& pattern) {
        unsewn_ = assemble(pattern);
        const std::vector<Fabric> fabrics(pattern.panels.size(), find_fabric("cotton_shirting"));
        return sew_on_body(unsewn_, fabrics, collider_);
    }
    double deepest(const GarmentMesh& mesh) const {
        double least = 1;
        for (const Vec3d& x : mesh.x) {
            const auto closest = collider_.surface().closest(x.cast<float>(), std::numeric_limits<float>::infinity());
            least = std::min(least, double(closest->distance));
        }
        return least;
    }

    const Body box_ = shapes::box(Vec3d(-0.1, 0, -0.06), Vec3d(0.1, 1.4, 0.06), 12);
    const BodyCollider collider_{box_, {.cell = 0.004F, .band = 0.016F}};
    GarmentMesh unsewn_;
};

TEST_F(SewOnABox, closes_two_panels_into_a_tube_that_is_long_enough) {
    const SewingResult result = sew(tube(0.40, 0.3, 0.8, 0.15));
    ASSERT_FALSE(result.bad_vertex);
    EXPECT_TRUE(result.open.empty());
    EXPECT_TRUE(result.sewn.links.empty());
    EXPECT_EQ(result.sewn.x.size(), unsewn_.x.size() - unsewn_.links.size());
    EXPECT_TRUE(check_mesh(result.sewn).empty());
    const Topology topology = topology_of(result.sewn);
    EXPECT_EQ(topology.boundary_loops, 2);
    EXPECT_EQ(topology.euler, 0);
    EXPECT_GT(deepest(result.sewn), -0.0005);
    EXPECT_GT(result.simulated_seconds, 0);
}

// A hem that the floor bends up while the seams close stays so.
TEST_F(SewOnABox, closes_a_tube_that_was_placed_below_the_floor_without_bending_it) {
    const SewingResult result = sew(tube(0.40, 0.4, -0.15, 0.15));
    EXPECT_TRUE(result.open.empty());
    double lowest = 0, highest = 0;
    for (const Vec3d& x : result.sewn.x) {
        lowest = std::min(lowest, x.y());
        highest = std::max(highest, x.y());
    }
    EXPECT_GT(highest - lowest, 0.39);
}

// A third panel cuts through the front one, at an angle of 0.5 radians.
Pattern tube_with_panel_across() {
    Pattern pattern = tube(0.40, 0.3, 0.8, 0.15);
    Panel across = rectangle("across", {.width = 0.2, .height = 0.2, .y = 0.85, .z = 0.12});
    across.rotation = Eigen::AngleAxisd(0.5, Vec3d::UnitX()).toRotationMatrix();
    pattern.panels.push_back(across);
    return pattern;
}

// Pinned panels stay as far apart as they were placed.
TEST(SewingRun, what_folds_hold_open_is_sewn_and_what_is_as_wide_as_a_limb_stays_open) {
    const auto open_seams_of = [](double apart) {
        Pattern pattern;
        pattern.panels = {rectangle("front", {.width = 0.2, .height = 0.2, .z = apart}),
                          rectangle("back", {.width = 0.2, .height = 0.2, .z = 0, .is_back = true})};
        pattern.seams = {{.first = {0, 1}, .second = {1, 3}}};
        GarmentMesh unsewn = assemble(pattern);
        for (int v = 0; v < static_cast<int>(unsewn.x.size()); ++v) unsewn.pins.push_back(v);
        SewingRun run(unsewn, std::vector<Fabric>(2, find_fabric("cotton_shirting")), {});
        while (run.advance(NoBody())) continue;
        return std::move(run).result().open.size();
    };
    EXPECT_EQ(open_seams_of(0.018), 0U);
    EXPECT_EQ(open_seams_of(0.06), 1U);
}

TEST_F(SewOnABox, panels_that_cross_come_apart_while_seams_close) {
    const GarmentMesh unsewn = assemble(tube_with_panel_across());
    const std::vector<Fabric> fabrics(3, find_fabric("cotton_shirting"));
    const auto crossings_when_sewn = [&](const SewingOptions& options) {
        SewingRun run(unsewn, fabrics, options);
        while (run.advance(collider_)) continue;
        const Cloth sewn = make_cloth(std::move(run).result().sewn, fabrics, {.max_level = 0});
        return find_crossing_triangles(contact_surface(sewn), sewn.x.front().data()).size();
    };
    EXPECT_GT(crossings_when_sewn({}), 0U);
    EXPECT_EQ(crossings_when_sewn({.simulation = {.self_contact = SelfContactOptions{}}}), 0U);
}

TEST_F(SewOnABox, panels_that_cross_come_apart_as_soon_as_contact_is_switched_on_while_they_hang) {
    DressOptions options{.max_level = 0, .max_seconds = 60, .has_gravity = false, .self_collision = false};
    Dressing dressing;
    dressing.set_options(options);
    dressing.set_body(std::make_shared<const Body>(box_));
    dressing.set_pattern(tube_with_panel_across());
    dressing.sew();
    const auto crossings_after = [&](int frames) {
        for (int i = 0; i < frames && dressing.stage() != DressingStage::Done; ++i) dressing.advance();
        return find_crossing_triangles(contact_surface(*dressing.cloth()), dressing.cloth()->x.front().data()).size();
    };
    while (!dressing.is_hanging()) dressing.advance();
    EXPECT_GT(crossings_after(60), 0U);
    options.self_collision = true;
    dressing.set_options(options);
    EXPECT_EQ(crossings_after(30), 0U);
}

TEST_F(SewOnABox, leaves_the_body_inside_the_tube) {
    const SewingResult result = sew(tube(0.40, 0.3, 0.8, 0.15));
    double front = -1;
    double back = 1;
    for (const GarmentTriangle& t : result.sewn.triangles) {
        Vec3d middle = Vec3d::Zero();
        for (const int v : t.vertices) middle += result.sewn.x[std::size_t(v)] / 3;
        if (std::abs(middle.x()) > 0.05) continue;
        if (t.panel == 0) front = std::max(front, -middle.z());
        if (t.panel == 1) back = std::min(back, -middle.z());
    }
    EXPECT_LT(front, -0.06) << "the front panel went through the body";
    EXPECT_GT(back, 0.06) << "the back panel went through the body";
}

TEST_F(SewOnABox, gives_the_same_bits_twice) {
    const SewingResult first = sew(tube(0.40, 0.3, 0.8, 0.15));
    const SewingResult second = sew(tube(0.40, 0.3, 0.8, 0.15));
    EXPECT_EQ(first.sewn.x, second.sewn.x);
}

TEST_F(SewOnABox, sews_nothing_where_there_is_no_seam) {
    Pattern pattern = tube(0.40, 0.3, 0.8, 0.15);
    pattern.seams.clear();
    const SewingResult result = sew(pattern);
    EXPECT_TRUE(result.open.empty());
    EXPECT_EQ(result.sewn.x.size(), unsewn_.x.size());
}

// A wall between the two sides of the seam, far wider and higher than the panels, keeps them apart.
TEST(SewOnABody, a_seam_that_cannot_close_is_open_and_gapes_by_the_body_between) {
    const Body wall = shapes::box(Vec3d(-0.6, 0, -0.06), Vec3d(0.6, 1.6, 0.06), 12);
    const BodyCollider collider(wall, {.cell = 0.006F, .band = 0.024F});
    const std::vector<Fabric> fabrics(2, find_fabric("cotton_shirting"));
    const SewingResult result = sew_on_body(assemble(tabard(0.14, 0.3, 0.5, 0.15)), fabrics, collider);
    ASSERT_FALSE(result.bad_vertex);
    EXPECT_TRUE(result.sewn.links.empty());
    EXPECT_TRUE(check_mesh(result.sewn).empty());
    double least = 1;  // m, on the panel's own side of the wall's centre plane
    for (const GarmentTriangle& t : result.sewn.triangles) {
        for (const int v : t.vertices) {
            const double z = result.sewn.x[std::size_t(v)].z();
            least = std::min(least, t.panel == 0 ? z : -z);
        }
    }
    EXPECT_GT(least, 0.0595) << "a panel went through the wall";
    ASSERT_EQ(result.open.size(), 1U);
    EXPECT_EQ(result.open[0].seam, 0);
    EXPECT_GT(result.open[0].gap, 0.12F);
    EXPECT_LT(result.open[0].gap, 0.3F);
}

}  // namespace
}  // namespace selvedge::sim::test
