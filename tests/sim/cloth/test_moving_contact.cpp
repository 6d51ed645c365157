// Contacts with a body that moves: cloth stays outside, goes along by friction, and is held in the middle where it is
// pinched.
#include "sim/cloth/moving_contact.h"
#include "sim/cloth/solver_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "sim/cloth/cloth.h"
#include "sim/cloth/cloth_penetration.h"
#include "sim/collide/surface_bvh.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

using Motion = std::function<Vec3d(const Vec3d& p, double seconds)>;

struct MovingScene {
    Body body;
    Motion motion;
    double step = 1.0 / 120;  // s
    MovingBodyCollider collider{body};
    double seconds = 0;

    std::vector<Vec3f> at(double t) const {
        std::vector<Vec3f> x;
        for (const Vec3d& p : body.x) x.push_back(motion(p, t).cast<float>());
        return x;
    }

    void run(Cloth& cloth, double duration, const StepOptions& options, const std::function<void()>& watch = {}) {
        for (const double end = seconds + duration - step / 2; seconds < end;) {
            seconds += step;
            collider.move_to(at(seconds));
            sim::step(cloth, collider, options);
            collider.arrive();
            if (watch) watch();
        }
    }
};

StepOptions stepping() {
    StepOptions options{.substeps = 8};
    options.contact.floor = kNoFloor;
    return options;
}

// The mean angle by which vertices that are not near the axis have turned about y since `before`, rad.
double mean_turn(const Cloth& cloth, const std::vector<Vec4f>& before) {
    double sum = 0;
    int count = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f &a = before[v.value], &b = cloth.x[v.value];
        if (std::hypot(a.x(), a.z()) < 0.05F) continue;
        const double turn = std::atan2(double(b.x()), double(b.z())) - std::atan2(double(a.x()), double(a.z()));
        sum += std::remainder(turn, 2 * std::numbers::pi);
        ++count;
    }
    return sum / count;
}

MovingScene turntable(double speed) {  // rad/s
    return {
        .body = shapes::box(Vec3d(-0.3, 0.9, -0.3), Vec3d(0.3, 1.0, 0.3), 12),
        .motion = [=](const Vec3d& p, double t) { return Vec3d(Eigen::AngleAxisd(speed * t, Vec3d::UnitY()) * p); }};
}

TEST(MovingContact, a_turntable_carries_the_cloth_that_lies_on_it) {
    constexpr double kSpeed = 1;
    MovingScene scene = turntable(kSpeed);
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.3, .quads = 6, .height = 1.0035});
    refresh_contacts(cloth);
    const std::vector<Vec4f> before = cloth.x;
    scene.run(cloth, 0.5, stepping());
    EXPECT_NEAR(mean_turn(cloth, before), kSpeed * 0.5, 0.05);
}

TEST(MovingContact, a_turntable_slides_away_under_cloth_without_friction) {
    MovingScene scene = turntable(1);
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.3, .quads = 6, .height = 1.0035});
    refresh_contacts(cloth);
    const std::vector<Vec4f> before = cloth.x;
    StepOptions options = stepping();
    options.contact.friction_scale = 0;
    scene.run(cloth, 0.5, options);
    EXPECT_LT(std::abs(mean_turn(cloth, before)), 0.02);
}

// A limb of 3 cm moves by half of its thickness in each step.
TEST(MovingContact, a_fast_thin_limb_pushes_cloth_along_and_never_leaves_it_behind) {
    constexpr double kSpeed = 4;  // m/s
    Body limb = shapes::sphere(Vec3d::Zero(), 0.015, 16);
    for (Vec3d& p : limb.x) p = Vec3d(20 * p.x(), p.y() + 0.815, p.z());
    MovingScene scene{.body = limb,
                      .motion = [](const Vec3d& p, double t) { return Vec3d(p + Vec3d(0, kSpeed * t, 0)); },
                      .step = 1.0 / 240};
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.2, .quads = 10, .height = 1.0});
    refresh_contacts(cloth);
    std::vector<std::uint32_t> over_it;
    for (const VertexId v : cloth.mesh.leaf_vertices())
        if (std::abs(cloth.x[v.value].z()) < 0.012F) over_it.push_back(v.value);
    ASSERT_GT(over_it.size(), 5U);
    int below = 0;
    float deepest = 0;
    StepOptions options = stepping();
    options.substeps = 4;
    scene.run(cloth, 0.15, options, [&] {
        const double top = 0.83 + kSpeed * scene.seconds;
        for (const std::uint32_t v : over_it)
            if (double(cloth.x[v].y()) < top - 0.015 && std::abs(cloth.x[v].z()) < 0.015F) ++below;
        for (const VertexId v : cloth.mesh.leaf_vertices())
            deepest = std::max(deepest, -scene.collider.contact(cloth.x[v.value].head<3>()).distance);
    });
    EXPECT_LT(deepest, 0.001F);
    EXPECT_EQ(below, 0);
    EXPECT_GT(centre_of_mass(cloth).y(), 1.1) << "the bar took it along";
}

// Two walls that stand 4 cm apart.
Body two_walls() {
    Body walls = shapes::box(Vec3d(-0.2, 0.7, -0.2), Vec3d(-0.02, 1.3, 0.2), 8);
    const Body right = shapes::box(Vec3d(0.02, 0.7, -0.2), Vec3d(0.2, 1.3, 0.2), 8);
    for (const auto& triangle : right.triangles) {
        const int first = static_cast<int>(walls.x.size());
        walls.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    walls.x.insert(walls.x.end(), right.x.begin(), right.x.end());
    return walls;
}

// A strip that hangs between them.
Cloth hanging_strip() {
    Cloth cloth = make_strip(find_fabric("cotton_shirting"), {.width = 0.1, .length = 0.2, .level = 1});
    move_to(cloth, Eigen::AngleAxisf(std::numbers::pi_v<float> / 2, Vec3f::UnitY()).toRotationMatrix(), Vec3f::Zero());
    const Vec3f shift = Vec3f(0, 1, 0) - centre_of_mass(cloth).cast<float>();
    move_to(cloth, Eigen::Matrix3f::Identity(), shift);
    refresh_contacts(cloth);
    return cloth;
}

// The walls close by that on either side, at 0.2 m/s.
MovingScene closing_walls(double by) {
    return {.body = two_walls(), .motion = [=](const Vec3d& p, double t) {
                const double now = std::min(by, 0.2 * t);
                return Vec3d(p + Vec3d(p.x() < 0 ? now : -now, 0, 0));
            }};
}

// A finger of 14 mm comes up within one triangle whose edges are 5 cm long, beside vertices, edges and samples.
TEST(MovingFaces, a_finger_lifts_the_triangle_that_it_comes_upon) {
    constexpr double kSpeed = 1.4;  // m/s
    MovingScene scene{.body = shapes::box(Vec3d(0.010, 0.91, 0.026), Vec3d(0.024, 0.99, 0.040), 16),
                      .motion = [](const Vec3d& p, double t) { return Vec3d(p + Vec3d(0, kSpeed * t, 0)); }};
    Cloth cloth = make_patch(find_fabric("jersey"), {.side = 0.2, .quads = 4, .height = 1.0});
    StepOptions options = stepping();
    options.contact.offset = 0.0003F;
    options.contact.sample_spacing = options.contact.sampled_edge = 1;
    refresh_contacts(cloth, options.contact);
    float deepest = 0, highest = 0;
    scene.run(cloth, 0.1, options, [&] {
        deepest = std::max(deepest, find_penetration(cloth, scene.collider.surface(), {.depth = 0.0005F}).deepest);
        highest = 0.99F + static_cast<float>(kSpeed * scene.seconds);
    });
    EXPECT_LT(deepest, 0.002F) << "half of its width is 7 mm";
    EXPECT_GT(centre_of_mass(cloth).y(), 1.05) << "the finger is at " << highest << " m";
}

TEST(MovingFaces, are_those_near_to_what_is_thin) {
    MovingScene scene{.body = shapes::together(shapes::box(Vec3d(0, 0.9, 0), Vec3d(0.02, 0.999, 0.02), 8),
                                               shapes::box(Vec3d(0.06, 0.9, 0.02), Vec3d(0.16, 0.999, 0.12), 8)),
                      .motion = [](const Vec3d& p, double) { return p; }};
    Cloth cloth = make_patch(find_fabric("jersey"), {.side = 0.4, .quads = 16, .height = 1.0});
    refresh_contacts(cloth);
    scene.run(cloth, 1.0 / 120, stepping());
    const std::vector<MovingFace>& faces = cloth.solver->contacts.moving.faces;
    ASSERT_FALSE(faces.empty());
    for (const MovingFace& face : faces)
        for (const std::uint32_t v : face.carrier.vertices) EXPECT_LT(cloth.x[v].x(), 0.055F);
}

// Two walls close to 3 mm: less than two contact offsets of 3 mm.
TEST(MovingContact, cloth_that_two_sides_pinch_is_held_in_the_middle_and_counted) {
    MovingScene scene = closing_walls(0.0185);
    Cloth cloth = hanging_strip();
    StepOptions options = stepping();
    options.gravity = Vec3f::Zero();
    float deepest = 0;
    scene.run(cloth, 0.4, options, [&] {
        const float wall = 0.02F - static_cast<float>(std::min(0.0185, 0.2 * scene.seconds));
        for (const VertexId v : cloth.mesh.leaf_vertices())
            if (cloth.inverse_mass[v.value] > 0) deepest = std::max(deepest, std::abs(cloth.x[v.value].x()) - wall);
    });
    EXPECT_LT(deepest, 0.0005F);
    EXPECT_GT(cloth.solver->contacts.moving.pinched, 10);
    EXPECT_FALSE(find_bad_vertex(cloth));
    EXPECT_LT(speed_now(cloth), 0.05F) << "held, not shaken";
}

// As an arm that a motion puts into the trunk: they overlap by a centimetre, and part again.
TEST(MovingContact, cloth_between_sides_that_overlap_is_neither_torn_nor_left_on_a_wrong_side) {
    MovingScene scene = closing_walls(0.025);
    scene.motion = [](const Vec3d& p, double t) {
        const double now = t < 0.25 ? std::min(0.025, 0.2 * t) : std::max(0.0, 0.025 - 0.2 * (t - 0.25));
        return Vec3d(p + Vec3d(p.x() < 0 ? now : -now, 0, 0));
    };
    Cloth cloth = hanging_strip();
    StepOptions options = stepping();
    options.gravity = Vec3f::Zero();
    float most = 0;
    int pinched = 0;
    scene.run(cloth, 0.5, options, [&] {
        for (const TriangleStrain& strain : measure_strain(cloth)) most = std::max({most, strain.warp, strain.weft});
        pinched = std::max(pinched, cloth.solver->contacts.moving.pinched);
    });
    EXPECT_GT(pinched, 10);
    EXPECT_LT(most, 0.1F);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        EXPECT_LT(std::abs(cloth.x[v.value].x()), 0.0201F);
        EXPECT_FALSE(is_pinched(cloth.solver->contacts.moving, v));
    }
}

// Near a ball the distance of a chord's middle follows from what its ends know.
TEST(MovingContact, tells_the_distance_between_vertices_from_their_planes) {
    MovingScene scene{.body = shapes::sphere(Vec3d(0, 0.9, 0), 0.1, 24),
                      .motion = [](const Vec3d& p, double t) { return Vec3d(p + Vec3d(0.1 * t, 0, 0)); }};
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.2, .quads = 16, .height = 1.004});
    refresh_contacts(cloth);
    scene.run(cloth, 0.3, stepping());
    int told = 0;
    float largest_error = 0;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const std::array<float, 3> shares{0.5F, 0.3F, 0.2F};
        Vec3f p = Vec3f::Zero();
        for (std::size_t k = 0; k < 3; ++k) p += shares[k] * cloth.x[leaf.v[k].value].head<3>();
        const auto distance = distance_between(cloth.solver->contacts.moving, leaf.v, shares, p);
        if (!distance) continue;
        ++told;
        const auto exact = scene.collider.surface().closest(p, 1);
        ASSERT_TRUE(exact);
        largest_error = std::max(largest_error, std::abs(*distance - exact->distance));
    }
    EXPECT_GT(told, 10);
    EXPECT_LT(largest_error, 0.0004F);
}

}  // namespace
}  // namespace selvedge::sim::test
