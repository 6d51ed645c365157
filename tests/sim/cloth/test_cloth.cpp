// Masses, pins, velocities and invalid numbers; the effect of an adaptation on the state of the vertices.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/adaptive/check.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/material_frame.h"
#include "sim/cloth/solver_state.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

// Shapes the cloth into a wave along x of this height, or flat for 0. Lengths are kept only roughly; the criteria
// request splits all the same.
void wave(Cloth& cloth, float height) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float x = cloth.x[v.value].x();
        cloth.x[v.value].y() = 2 + height * std::sin(12 * x) * std::cos(9 * cloth.x[v.value].z());
    }
    cloth.x_prev = cloth.x;
    update_normals(cloth);
}

TEST(Cloth, weighs_its_area_times_its_density) {
    const Fabric fabric = find_fabric("wool_twill");
    const Cloth cloth = make_patch(fabric, {.side = 0.4});
    EXPECT_NEAR(total_mass(cloth), 0.16 * fabric.area_density, 1e-6);
}

TEST(Cloth, weighs_the_same_after_any_number_of_adaptations) {
    const Fabric fabric = find_fabric("denim");
    const double mass = 0.16 * fabric.area_density;
    Cloth cloth = make_patch(fabric, {.side = 0.4});
    long changes = 0;
    for (const float height : {0.05F, 0.1F, 0.02F, 0.0F, 0.12F, 0.0F, 0.0F, 0.0F}) {
        wave(cloth, height);
        const AdaptReport report = adapt_cloth(cloth, nothing_near());
        changes += report.splits + report.rejoins;
        EXPECT_NEAR(total_mass(cloth), mass, 1e-5 * mass);
        EXPECT_TRUE(check(cloth.mesh).empty()) << check(cloth.mesh).front();
    }
    EXPECT_GT(changes, 100) << "the waves made hardly anything split, so nothing was tested";
    const std::vector<std::uint32_t>& lanes = cloth.solver->constraints.triangle_of;
    const auto dummy = std::count(lanes.begin(), lanes.end(), kNoBlockSlot);
    EXPECT_EQ(lanes.size() - static_cast<std::size_t>(dummy), cloth.mesh.leaf_triangles().size());
}

TEST(Cloth, a_refined_patch_has_no_vertex_without_mass) {
    Cloth cloth = make_patch(find_fabric("silk"));
    for (const int level : {1, 2, 3}) {
        refine(cloth, level);
        for (const VertexId v : cloth.mesh.leaf_vertices()) EXPECT_GT(cloth.inverse_mass[v.value], 0);
        EXPECT_NEAR(total_mass(cloth), 0.16 * find_fabric("silk").area_density, 1e-6);
    }
}

TEST(Cloth, at_rest_has_no_speed_and_a_moving_one_the_speed_of_its_vertices) {
    Cloth cloth = make_patch(find_fabric("silk"));
    EXPECT_EQ(speed_now(cloth), 0);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        cloth.x_prev[v.value] = cloth.x[v.value] - Vec4f(0.3F, 0, 0.4F, 0) * cloth.substep;
    }
    EXPECT_NEAR(speed_now(cloth), 0.5F, 1e-3F);
}

TEST(FindBadVertex, finds_nothing_in_a_sound_cloth) {
    EXPECT_FALSE(find_bad_vertex(make_patch(find_fabric("silk"))).has_value());
}

TEST(FindBadVertex, finds_what_is_no_number_and_what_has_left_the_room) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float bad : {kNan, kInfinity, -kInfinity, 1e6F, -1e6F}) {
        for (int axis = 0; axis < 3; ++axis) {
            Cloth cloth = make_patch(find_fabric("silk"));
            cloth.x[7][axis] = bad;
            EXPECT_EQ(find_bad_vertex(cloth), VertexId(7)) << bad << " on axis " << axis;
        }
    }
}

TEST(UpdateNormals, point_to_the_right_side_and_have_unit_length) {
    Cloth cloth = make_patch(find_fabric("silk"));
    refine(cloth, 2);
    update_normals(cloth);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        EXPECT_LT((cloth.normals[v.value] - Vec3f::UnitY()).norm(), 1e-5F);
    }
}

// A patch of 0.25 m quads over a ball that intersects the edges of one quad and contains no vertex.
class BallUnderAPatch : public testing::Test {
 protected:
    static constexpr float kRadius = 0.1F;
    const Obstacle ball_{shapes::sphere(Vec3d(0.125, 1.95, 0), kRadius, 24)};
    Cloth cloth_ = make_patch(find_fabric("cotton_shirting"), {.side = 1.0, .quads = 4, .height = 2.0});
    const AdaptClothOptions collision_only_{.criteria = {.collision = true, .curvature = false, .length = false}};

    AdaptReport adapt_once() { return adapt_cloth(cloth_, ball_.collider, collision_only_); }
    std::vector<EdgeId> split_base_edges() const {
        const auto split = cloth_.mesh.split_edges(0);
        return {split.begin(), split.end()};
    }
};

TEST_F(BallUnderAPatch, splits_the_edges_that_cut_it_and_no_edge_far_away) {
    ASSERT_GT(deepest(cloth_, ball_.collider), 0.003F);
    EXPECT_GT(adapt_once().splits, 0);
    EXPECT_TRUE(check(cloth_.mesh).empty());
    ASSERT_FALSE(split_base_edges().empty());
    for (const EdgeId e : split_base_edges()) {
        const Vec4f middle = (cloth_.x[cloth_.mesh.end(e, 0).value] + cloth_.x[cloth_.mesh.end(e, 1).value]) / 2;
        EXPECT_LT(exact_distance(ball_.collider, middle.head<3>()), 0.003F);
    }
}

TEST_F(BallUnderAPatch, new_vertices_stand_outside_it) {
    adapt_once();
    EXPECT_GT(deepest(cloth_, ball_.collider), 0.003F - ball_.collider.max_error() - 1e-4F);
}

TEST_F(BallUnderAPatch, lets_the_edges_rejoin_once_it_is_away) {
    adapt_once();
    ASSERT_GT(cloth_.mesh.leaf_triangles().size(), cloth_.mesh.base_triangle_count());
    move_to(cloth_, Eigen::Matrix3f::Identity(), Vec3f(0, 1, 0));
    for (int i = 0; i <= cloth_.mesh.max_level(); ++i) adapt_once();
    EXPECT_EQ(cloth_.mesh.leaf_triangles().size(), cloth_.mesh.base_triangle_count());
    EXPECT_EQ(sample_count(cloth_.solver->contacts), 0U) << "it is split where it dips";
}

TEST_F(BallUnderAPatch, does_not_flicker_while_nothing_moves) {
    for (int i = 0; i < 4; ++i) adapt_once();
    const AdaptReport again = adapt_once();
    EXPECT_EQ(again.splits, 0);
    EXPECT_EQ(again.rejoins, 0);
}

TEST_F(BallUnderAPatch, a_split_gives_the_centre_the_mean_velocity_of_the_ends) {
    std::mt19937 random(3);
    for (const VertexId v : cloth_.mesh.leaf_vertices()) {
        const Vec3f velocity(draw(random, -1, 1), draw(random, -1, 1), draw(random, -1, 1));
        cloth_.x_prev[v.value] = cloth_.x[v.value] - with_zero_w(velocity) * cloth_.substep;
    }
    const auto moved = [&](VertexId v) { return Vec4f(cloth_.x[v.value] - cloth_.x_prev[v.value]); };
    adapt_once();
    ASSERT_FALSE(split_base_edges().empty());
    for (const EdgeId e : split_base_edges()) {
        const Vec4f mean = (moved(cloth_.mesh.end(e, 0)) + moved(cloth_.mesh.end(e, 1))) / 2;
        EXPECT_LT((moved(cloth_.mesh.centre(e)) - mean).norm(), 1e-6F);
    }
}

TEST(AdaptCloth, does_nothing_to_a_flat_patch_that_touches_nothing) {
    Cloth cloth = make_patch(find_fabric("silk"));
    const std::vector<Vec4f> before = cloth.x;
    const AdaptReport report = adapt_cloth(cloth, nothing_near());
    EXPECT_FALSE(report.changed());
    EXPECT_EQ(cloth.x, before);
}

TEST(AdaptCloth, asks_only_the_criteria_that_are_switched_on) {
    for (const CriteriaOptions criteria : {CriteriaOptions{.collision = true, .curvature = false, .length = false},
                                           CriteriaOptions{.collision = false, .curvature = false, .length = true},
                                           CriteriaOptions{.collision = false, .curvature = false, .length = false}}) {
        Cloth cloth = make_patch(find_fabric("silk"));
        wave(cloth, 0.05F);  // longer than at rest everywhere: only curvature would request splits
        EXPECT_EQ(adapt_cloth(cloth, nothing_near(), {.criteria = criteria}).splits, 0);
    }
    Cloth cloth = make_patch(find_fabric("silk"));
    wave(cloth, 0.05F);
    EXPECT_GT(adapt_cloth(cloth, nothing_near(), {.criteria = {.collision = false, .length = false}}).splits, 0);
}

TEST(AdaptCloth, splits_no_edge_shorter_than_the_shortest_that_is_asked_for) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.4, .quads = 4});
    for (int i = 0; i < 6; ++i) {
        wave(cloth, 0.08F);
        adapt_cloth(cloth, nothing_near(), {.criteria = {}, .shortest_edge = 0.06F});
    }
    ASSERT_GT(cloth.mesh.split_edges(0).size(), 0U);
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        for (const EdgeId e : cloth.mesh.split_edges(level)) EXPECT_GE(cloth.mesh.rest_length(e), 0.06F);
    }
}

TEST(AdaptCloth, rejoins_nothing_while_told_to_keep_what_is_split) {
    Cloth cloth = make_patch(find_fabric("silk"));
    wave(cloth, 0.1F);
    ASSERT_GT(adapt_cloth(cloth, nothing_near()).splits, 0);
    wave(cloth, 0);
    EXPECT_EQ(adapt_cloth(cloth, nothing_near(), {.criteria = {}, .may_rejoin = false}).rejoins, 0);
    EXPECT_GT(adapt_cloth(cloth, nothing_near(), {.criteria = {}, .may_rejoin = true}).rejoins, 0);
}

}  // namespace

// The material frame of a triangle and the measured strain, for known deformations.

namespace {

constexpr std::array<float, 5> kGrainAngles{0.0F, 0.3F, 0.785398F, -1.2F, 3.0F};

Vec2f warp_of(float angle) {
    return {-std::sin(angle), std::cos(angle)};
}
Vec2f weft_of(float angle) {
    return {std::cos(angle), std::sin(angle)};
}

std::array<Vec2f, 3> random_triangle(std::mt19937& random) {
    std::array<Vec2f, 3> u{};
    do {
        for (Vec2f& p : u) p = Vec2f(draw(random, -0.1F, 0.1F), draw(random, -0.1F, 0.1F));
    } while (cross2((u[1] - u[0]).cast<double>(), (u[2] - u[0]).cast<double>()) < 0.001);
    return u;
}

// The deformed warp and weft directions of a triangle under a linear map of its plane into 3D.
struct Threads {
    Vec3f warp = Vec3f::Zero();
    Vec3f weft = Vec3f::Zero();
};
Threads deformed(const std::array<Vec2f, 3>& u, const MaterialFrame& frame, const Eigen::Matrix<float, 3, 2>& map) {
    const Vec3f e1 = map * (u[1] - u[0]);
    const Vec3f e2 = map * (u[2] - u[0]);
    return {frame.a[0] * e1 + frame.a[1] * e2, frame.b[0] * e1 + frame.b[1] * e2};
}

TEST(MaterialFrame, gives_back_any_linear_map_of_warp_and_weft_at_every_grain_angle) {
    std::mt19937 random(7);
    for (const float angle : kGrainAngles) {
        for (int i = 0; i < 50; ++i) {
            const std::array<Vec2f, 3> u = random_triangle(random);
            Eigen::Matrix<float, 3, 2> map;
            for (int k = 0; k < 6; ++k) map.data()[k] = draw(random, -1.5F, 1.5F);
            const Threads threads = deformed(u, material_frame(u, angle), map);
            EXPECT_LT((threads.warp - map * warp_of(angle)).norm(), 1e-4F);
            EXPECT_LT((threads.weft - map * weft_of(angle)).norm(), 1e-4F);
        }
    }
}

TEST(MaterialFrame, tells_stretch_along_the_warp_from_stretch_along_the_weft) {
    std::mt19937 random(8);
    for (const float angle : kGrainAngles) {
        const std::array<Vec2f, 3> u = random_triangle(random);
        const Vec2f warp = warp_of(angle);
        const Vec2f weft = weft_of(angle);
        Eigen::Matrix<float, 3, 2> map = Eigen::Matrix<float, 3, 2>::Zero();
        map.topRows<2>() = 1.1F * warp * warp.transpose() + 0.95F * weft * weft.transpose();
        const Threads threads = deformed(u, material_frame(u, angle), map);
        EXPECT_NEAR(threads.warp.norm(), 1.1F, 1e-5F);
        EXPECT_NEAR(threads.weft.norm(), 0.95F, 1e-5F);
        EXPECT_NEAR(threads.warp.dot(threads.weft), 0, 1e-5F);
    }
}

TEST(MaterialFrame, has_the_area_of_the_triangle) {
    const MaterialFrame frame = material_frame({Vec2f(1, 1), Vec2f(1.3F, 1), Vec2f(1.1F, 1.2F)}, 0.4F);
    EXPECT_NEAR(frame.area, 0.03F, 1e-6F);
}

// Maps the patch's material coordinates into 3D and measures the strain of its leaves.
std::vector<TriangleStrain> strain_under(const Eigen::Matrix2f& map, float grain_angle, int level) {
    Cloth cloth = make_patch(find_fabric("wool_twill"));
    cloth.material.grain_angles = {grain_angle};
    refine(cloth, level);
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2f at = map * t.u[k];
            cloth.x[t.v[k].value] = Vec4f(at.x(), 1, -at.y(), 0);
        }
    }
    const std::vector<TriangleStrain> strain = measure_strain(cloth);
    EXPECT_EQ(strain.size(), cloth.mesh.leaf_triangles().size());
    return strain;
}

TEST(MeasureStrain, finds_the_same_stretch_in_every_leaf_of_a_pulled_patch) {
    const float angle = 0.6F;
    const Vec2f warp = warp_of(angle);
    const Eigen::Matrix2f map = Eigen::Matrix2f::Identity() + 0.08F * warp * warp.transpose();
    for (const int level : {0, 2}) {
        for (const TriangleStrain& strain : strain_under(map, angle, level)) {
            EXPECT_NEAR(strain.warp, 0.08F, 1e-4F);
            EXPECT_NEAR(strain.weft, 0, 1e-4F);
            EXPECT_NEAR(strain.shear, 0, 1e-4F);
        }
    }
}

TEST(MeasureStrain, keeps_pure_shear_apart_from_stretch) {
    const float shear = 0.2F;  // rad: the weft leans towards the warp, both keep their lengths
    Eigen::Matrix2f map;
    map.col(0) = Vec2f(std::cos(shear), std::sin(shear));
    map.col(1) = Vec2f(0, 1);
    for (const TriangleStrain& strain : strain_under(map, 0, 1)) {
        EXPECT_NEAR(strain.warp, 0, 1e-4F);
        EXPECT_NEAR(strain.weft, 0, 1e-4F);
        EXPECT_NEAR(strain.shear, shear, 1e-3F);
    }
}

}  // namespace

}  // namespace selvedge::sim::test
