// Garments on bodies that move: what follows the body, what is counted, and a whole animation.
#include "sim/body/yielding_flesh.h"
#include "sim/cloth/solver_state.h"
#include "sim/session/animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/adaptive/triangle_budget.h"
#include "sim/body/joint_names.h"
#include "sim/cloth/moving_contact.h"
#include "sim/dress/dressing_pose.h"
#include "sim/dress/motion_run.h"
#include "sim/motion/motion_file.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern_file.h"
#include "sim/session/animation_report.h"
#include "sim/session/dress.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"
#include "tests/support/checkout.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

std::vector<Vec3f> moved_points(const Body& body, const std::function<Vec3d(const Vec3d&)>& motion) {
    std::vector<Vec3f> x;
    for (const Vec3d& p : body.x) x.push_back(motion(p).cast<float>());
    return x;
}

SimulationOptions without_floor() {
    SimulationOptions options = simulation_options({});
    options.contact.floor = kNoFloor;
    return options;
}

TEST(MotionRun, takes_pinned_vertices_along_with_the_body) {
    const Body table = shapes::box(Vec3d(-0.3, 0.9, -0.3), Vec3d(0.3, 1.0, 0.3), 8);
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.3, .quads = 6, .height = 1.0035});
    refresh_contacts(cloth);
    std::uint32_t pinned = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices())
        if (cloth.x[v.value].x() < cloth.x[pinned].x()) pinned = v.value;
    cloth.is_pinned[pinned] = true;
    refresh_solver(cloth);
    const Vec3f start = cloth.x[pinned].head<3>();
    Simulation simulation(std::move(cloth), without_floor());
    const auto turn = [](double t) { return Eigen::AngleAxisd(2 * t, Vec3d::UnitY()); };  // 2 rad/s
    MotionRun run(simulation, table, [&](double t, const Region&, std::vector<Vec3f>& x) {
        x = moved_points(table, [&](const Vec3d& p) { return turn(t) * p; });
    });
    run.advance_to(simulation, 0.5);
    const Vec3d expected = turn(0.5) * start.cast<double>();
    EXPECT_LT((simulation.cloth().x[pinned].head<3>().cast<double>() - expected).norm(), 1e-4);
}

// How often a step of MotionRun asks for the body, on which a bump goes to the side at that speed (m/s).
int parts_of_a_step(const Vec3d& bump, double speed) {
    const Body table = shapes::box(Vec3d(-0.3, 0.9, -0.3), Vec3d(0.3, 1.0, 0.3), 8);
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.3, .quads = 6, .height = 1.0035});
    refresh_contacts(cloth);
    Simulation simulation(std::move(cloth), without_floor());
    int asked = 0;
    MotionRun run(simulation, table, [&](double t, const Region& region, std::vector<Vec3f>& x) {
        ++asked;
        EXPECT_TRUE(region.contains(Vec3f(0.15F, 1.0035F, 0.15F))) << "a corner of the cloth";
        x = moved_points(table, [&](const Vec3d& p) {
            return Vec3d(p + ((p - bump).norm() < 0.01 ? Vec3d(speed * t, 0, 0) : Vec3d::Zero()));
        });
    });
    asked = 0;
    run.advance_to(simulation, run.options().step_seconds);
    return asked;
}

TEST(MotionRun, divides_a_step_where_the_body_moves_fast_near_the_cloth) {
    const Vec3d near(0, 1, 0), far(0.3, 0.9, 0.3);
    EXPECT_EQ(parts_of_a_step(near, 1), 1);
    EXPECT_EQ(parts_of_a_step(near, 6), 1 + 3) << "50 mm are divided into three parts of at most 20 mm";
    EXPECT_EQ(parts_of_a_step(near, 100), 1 + 4) << "no more";
    EXPECT_EQ(parts_of_a_step(far, 6), 1);
}

// The target changes while the cloth is carried round.
TEST(MotionRun, holds_a_triangle_budget_within_five_percent_one_second_after_it_changed) {
    const Body ball = shapes::sphere(Vec3d(0, 1, 0), 0.15, 24);
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.6, .quads = 8, .height = 1.16});
    refresh_contacts(cloth);
    SimulationOptions options = without_floor();
    options.adapt.shortest_edge = 0.01F;
    Simulation simulation(std::move(cloth), options);
    MotionRun run(simulation, ball, [&](double t, const Region&, std::vector<Vec3f>& x) {
        const Vec3d by(0.05 * std::sin(6 * t), 0, 0);
        x = moved_points(ball, [&](const Vec3d& p) { return p + by; });
    });
    double seconds = 0;
    for (const int target : {400, 800, 400}) {
        options.triangle_budget = target;
        simulation.set_options(options);
        run.advance_to(simulation, seconds += 1);
        const auto count = static_cast<double>(simulation.cloth().mesh.leaf_triangles().size());
        EXPECT_NEAR(count, target, 0.05 * target) << "target " << target;
    }
}

TEST(MotionQuality, counts_what_is_deep_but_not_what_is_pinched) {
    const Body ball = shapes::sphere(Vec3d(0, 1, 0), 0.15, 24);
    Cloth cloth =
        make_patch(find_fabric("cotton_shirting"), {.side = 0.02, .quads = 1, .height = 1.148, .max_level = 0});
    const MovingBodyCollider collider(ball);
    MotionQuality quality;
    quality.note(cloth, collider, 0.04);
    EXPECT_EQ(quality.deep_vertices, 4);
    EXPECT_EQ(quality.deep_faces, 2);
    EXPECT_NEAR(quality.deepest_face, 0.002, 0.0005);
    cloth.solver->contacts.moving.last.resize(cloth.x.size());
    for (LastContact& last : cloth.solver->contacts.moving.last) last.is_pinched = true;
    MotionQuality pinched;
    pinched.note(cloth, collider, 0.04);
    EXPECT_EQ(pinched.deep_vertices, 0);
    EXPECT_EQ(pinched.deep_faces, 0);
    EXPECT_EQ(pinched.pinched, 4);
}

TEST(MotionQuality, counts_faces_that_only_an_edge_brings_into_the_body) {
    const Body ball = shapes::sphere(Vec3d(0, 1, 0), 0.15, 24);
    const Cloth cloth =
        make_patch(find_fabric("cotton_shirting"), {.side = 0.4, .quads = 1, .height = 1.148, .max_level = 0});
    MotionQuality quality;  // only the middle of the diagonal is inside
    quality.note(cloth, MovingBodyCollider(ball), 0.04);
    EXPECT_EQ(quality.deep_vertices, 0);
    EXPECT_EQ(quality.deep_faces, 2);
    EXPECT_NEAR(quality.deepest_face, 0.002, 0.0005);
}

TEST(MotionQuality, tells_how_long_one_triangle_is_overstretched) {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.2, .quads = 1, .height = 3, .max_level = 0});
    const MovingBodyCollider collider(shapes::sphere(Vec3d(0, 1, 0), 0.15, 12));
    MotionQuality quality;
    for (const float scale : {1.2F, 1.2F, 1.0F, 1.2F}) {
        Cloth stretched = cloth;
        for (Vec4f& x : stretched.x) x.x() *= scale;
        quality.note(stretched, collider, 0.04);
    }
    EXPECT_NEAR(quality.overstretched_seconds, 0.08, 1e-9);
    EXPECT_NEAR(quality.max_stretch, 0.2, 0.001);
}

// Angle of the left upper arm from the vertical, rad.
double arm_angle(const Body& body, const Pose& pose) {
    const JointBones joints = find_joints(body.bones);
    const auto frames = bone_frames(body, pose);
    const auto at = [&](Joint joint) { return frames[static_cast<std::size_t>(joints[joint])].translation(); };
    const Vec3d along = (at(Joint::LeftLowerArm) - at(Joint::LeftUpperArm)).normalized();
    return std::acos(-along.y());
}

TEST(DressingPose, lowers_the_arms_of_a_t_pose_and_leaves_others_as_they_are) {
    const Body& standing = mannequin();
    EXPECT_NEAR(arm_angle(standing, dressing_pose(standing)), arm_angle(standing, rest_pose(standing)), 1e-9);
    const Body t_pose = posed(standing, find_pose("T", standing));
    ASSERT_GT(arm_angle(t_pose, rest_pose(t_pose)), 80 * std::numbers::pi / 180);
    EXPECT_NEAR(arm_angle(t_pose, dressing_pose(t_pose)), arm_angle(standing, find_pose("A", standing)), 0.05);
}

// Sleeves of panels that are placed for arms that hang at an angle.
TEST(Dress, dresses_a_body_in_a_t_pose_by_lowering_its_arms_and_moving_them_back) {
    const Pattern tshirt = load_pattern(source_folder() + "/patterns/tshirt.json").pattern;
    const Body t_pose = posed(mannequin(), find_pose("T", mannequin()));
    const DressedGarment dressed = dress(tshirt, t_pose, {.max_level = 1});
    EXPECT_TRUE(dressed.report.settled);
    for (const DressFault& fault : dressed.report.faults) ADD_FAILURE() << fault.kind << ": " << fault.place;
    float farthest = 0;  // cloth on the raised arms
    for (const Vec3f& x : dressed.mesh.x) farthest = std::max(farthest, std::abs(x.x()));
    EXPECT_GT(farthest, 0.3F);
}

TEST(Posed, has_the_pose_as_its_rest_pose_and_can_still_be_moved) {
    const Body& standing = mannequin();
    const Body raised = posed(standing, find_pose("arms_up", standing));
    std::vector<Vec3f> again;  // with flesh that gives way, in the fold of the shoulder
    FleshSurface(raised).positions(raised, rest_pose(raised), again);
    const std::vector<Vec3d> back = skin(raised, rest_pose(standing));
    double largest = 0, moved = 0;
    for (std::size_t v = 0; v < raised.x.size(); ++v) {
        const double again_off = (again[v].cast<double>() - raised.x[v]).norm();
        largest = std::max({largest, again_off, (back[v] - standing.x[v]).norm()});
        moved = std::max(moved, (raised.x[v] - standing.x[v]).norm());
    }
    EXPECT_LT(largest, 1e-6);
    EXPECT_GT(moved, 0.5);
}

TEST(Animation, goes_from_the_dressed_pose_over_into_the_motion_with_the_hips_in_place) {
    const auto body = std::make_shared<const Body>(mannequin());
    const Clip walk = find_motion("walk", *body);
    const AnimationOptions options{.blend_seconds = 1.5, .from = 0.4, .seconds = 1};
    BodyTimeline timeline(body, dressing_pose(*body), walk, options);
    EXPECT_DOUBLE_EQ(timeline.seconds(), 2.5);
    std::vector<Vec3f> x, wanted, before, dressed;
    timeline.positions(1.5, Region(), x);
    FleshSurface(*body).positions(*body, sample(*body, walk, 0.4), wanted);
    timeline.positions(0, Region(), before);
    FleshSurface(*body).positions(*body, dressing_pose(*body), dressed);
    EXPECT_EQ(before, dressed) << "where its patterns expect it";
    const Vec3f way = x[0] - wanted[0];
    EXPECT_GT(way.norm(), 0.2F) << "that the walk has gone by 0.4 s";
    EXPECT_NEAR(way.y(), 0, 1e-6F);
    float largest = 0, shift = 0;
    for (std::size_t v = 0; v < x.size(); ++v) largest = std::max(largest, (x[v] - wanted[v] - way).norm());
    const auto middle = [](const std::vector<Vec3f>& points) {
        Vec3f sum = Vec3f::Zero();
        for (const Vec3f& p : points) sum += p;
        return Vec3f(sum / static_cast<float>(points.size()));
    };
    shift = (middle(before) - middle(x)).norm();
    EXPECT_LT(largest, 1e-5F);
    EXPECT_LT(shift, 0.15F) << "not by the way that the walk has gone";
}

TEST(MotionQuality, tells_what_a_person_would_see_as_wrong) {
    MotionQuality quality;
    quality.deepest_vertex = 0.0009;
    quality.deep_faces = 5;
    quality.deepest_face = 0.0029;
    quality.overstretched_seconds = 0.08;
    EXPECT_TRUE(quality.faults().empty());
    quality.deep_vertices = 2;
    quality.deep_faces = 3;
    quality.deepest_face = 0.0168;
    quality.overstretched_seconds = 0.44;
    quality.deepest = {.seconds = 1.5, .place = {0.1F, 1, -0.25F}, .panel = 1};
    quality.most_overstretched = {.seconds = 2, .place = {0, 1.5F, 0}, .panel = 2};
    const std::vector<std::string> panels{"front", "left sleeve"};
    const std::vector<std::string> faults = quality.faults(panels);
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_EQ(
        faults[0],
        "cloth is in the body by 16.8 mm at 1.50 s, at (0.10, 1.00, -0.25) m in panel 'left sleeve'; by more than "
        "1 mm are, summed over the frames, 2 vertices and 3 faces");
    EXPECT_EQ(faults[1], "a triangle is stretched by more than 15 % for 0.44 s, until 2.00 s, at (0.00, 1.50, 0.00) m");
    quality.deep_vertices = 1;
    EXPECT_TRUE(quality.faults()[0].ends_with("1 vertex and 3 faces")) << quality.faults()[0];
}

// A tube skirt of two panels that hangs from the hips of a walking mannequin.
TEST(Animation, keeps_a_garment_outside_of_a_body_that_walks) {
    const auto body = std::make_shared<const Body>(mannequin());
    AnimationOptions options{.frames_per_second = 25, .blend_seconds = 0.5, .seconds = 0.7};
    options.dress.max_seconds = 2;
    Animation animation(tube(0.44, 0.4, 0.75, 0.2), body, dressing_pose(*body), find_motion("walk", *body), options);
    EXPECT_EQ(animation.frame_count(), 31);
    int frames = 1;
    while (animation.advance()) ++frames;
    EXPECT_EQ(frames, 31);
    EXPECT_NEAR(animation.seconds(), 1.2, 1e-9);
    const MotionQuality& quality = animation.quality();
    EXPECT_FALSE(quality.has_bad_number);
    EXPECT_EQ(quality.deep_vertices, 0);
    EXPECT_LT(quality.deepest_face, 0.003);
    EXPECT_LT(quality.p99_stretch, 0.05);
    const std::string report = to_json(animation, "walk", {});
    EXPECT_NE(report.find("\"planned_frames\": 31"), std::string::npos) << report;
}

}  // namespace
}  // namespace selvedge::sim::test
