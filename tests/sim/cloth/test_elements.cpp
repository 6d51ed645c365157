// What the solver's lists say about known deformations, and that no internal constraint pushes the cloth as a whole.
#include "sim/cloth/elements.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/cloth/constraints.h"
#include "sim/cloth/stretch.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::test {
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

// The deformed warp and weft directions of a triangle under a linear map of its plane into the room.
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

// Maps the patch's material into the room and measures the strain of its leaves.
std::vector<TriangleStrain> strain_under(const Eigen::Matrix2f& map, float grain_angle, int level) {
    Cloth cloth = make_patch(find_fabric("wool_twill"));
    cloth.grain_angles = {grain_angle};
    refine(cloth, level);
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2f at = map * t.u[k];
            cloth.x[t.v[k].value] = Vec4f(at.x(), 1, -at.y(), 0);
        }
    }
    return measure_strain(cloth);
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

// One change of positions by an internal constraint: what it does to momentum and to angular momentum, compared with
// the sum of what it does to the single vertices.
struct Push {
    Vec3d linear = Vec3d::Zero();
    Vec3d angular = Vec3d::Zero();
    double size = 0;  // sum of |m dx|
};
Push push_between(const Cloth& cloth, const std::vector<Vec4f>& before, const std::vector<Vec4f>& after) {
    Push push;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec3d x = before[v.value].head<3>().cast<double>();
        const Vec3d impulse = (after[v.value].head<3>().cast<double>() - x) / double(cloth.inverse_mass[v.value]);
        push.linear += impulse;
        push.angular += x.cross(impulse);
        push.size += impulse.norm();
    }
    return push;
}

// The forces of one constraint pass through the positions that it saw, so elements are solved one by one.
template <class Elements, class Solve>
void expect_no_push(Cloth& cloth, const Elements& elements, const Solve& solve, double torque_share) {
    double size = 0;
    Vec3d linear = Vec3d::Zero();
    for (const auto& element : elements) {
        const std::vector<Vec4f> before = cloth.x;
        solve(std::span(&element, 1));
        const Push push = push_between(cloth, before, cloth.x);
        EXPECT_LT(push.linear.norm(), 1e-3 * push.size + 1e-10);
        EXPECT_LT(push.angular.norm(), torque_share * push.size + 1e-10);
        size += push.size;
        linear += push.linear;
    }
    EXPECT_GT(size, 1e-5) << "nothing was corrected, so nothing was tested";
    EXPECT_LT(linear.norm(), 1e-4 * size);
}

// About the origin and not at a height, and stiff in bending, so that float steps of the positions are small against
// the corrections.
Cloth shaken_patch(std::mt19937& random, float reach) {
    Fabric fabric = find_fabric("denim");
    fabric.bending_warp = 0.2;  // N m
    fabric.bending_weft = 0.1;
    Cloth cloth = make_patch(fabric, {.height = 0});
    refine(cloth, 1);
    shake(cloth, reach, random);
    return cloth;
}

TEST(InternalConstraints, stretch_and_shear_push_and_turn_nothing_as_a_whole) {
    std::mt19937 random(11);
    Cloth cloth = shaken_patch(random, 0.01F);
    // Shear is taken at unit length of warp and weft, so its torque vanishes only to the order of their strain, which
    // is some 20 % here: a wrong gradient would turn by the arm, 0.05 m, and more.
    expect_no_push(
        cloth, cloth.elements.stretch, [&](auto one) { solve_stretch(one, cloth.inverse_mass, cloth.x); }, 0.01);
}

TEST(InternalConstraints, bending_pushes_nothing_and_turns_nothing) {
    std::mt19937 random(12);
    Cloth cloth = shaken_patch(random, 0.01F);
    expect_no_push(
        cloth, cloth.elements.bend, [&](auto one) { solve_bend(one, cloth.x); }, 0.005);
}

TEST(InternalConstraints, length_limits_push_nothing_and_turn_nothing) {
    std::mt19937 random(13);
    Cloth cloth = shaken_patch(random, 0.03F);
    expect_no_push(
        cloth, cloth.elements.limits, [&](auto one) { limit_lengths(one, cloth.x); }, 0.001);
}

TEST(InternalConstraints, bending_leaves_a_flat_patch_flat_however_it_lies) {
    Cloth cloth = make_patch(find_fabric("denim"), {.height = 0});
    refine(cloth, 2);
    move_to(cloth, Eigen::AngleAxisf(1.0F, Vec3f(1, 2, 3).normalized()).toRotationMatrix(), Vec3f(0.1F, 0.2F, 0.3F));
    const std::vector<Vec4f> before = cloth.x;
    solve_bend(cloth.elements.bend, cloth.x);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        EXPECT_LT((cloth.x[v.value] - before[v.value]).norm(), 1e-6F);
    }
}

TEST(InternalConstraints, a_length_limit_is_met_exactly_and_nothing_shorter_is_touched) {
    std::mt19937 random(14);
    Cloth cloth = shaken_patch(random, 0.03F);
    for (const LengthLimit& limit : cloth.elements.limits) {
        const std::vector<Vec4f> before = cloth.x;
        const float length = (before[limit.b] - before[limit.a]).norm();
        limit_lengths(std::span(&limit, 1), cloth.x);
        const float after = (cloth.x[limit.b] - cloth.x[limit.a]).norm();
        EXPECT_NEAR(after, std::min(length, limit.limit), 1e-5F);
        if (length <= limit.limit) {
            EXPECT_EQ(cloth.x, before);
        }
    }
}

TEST(Elements, there_is_one_per_leaf) {
    Cloth cloth = make_patch(find_fabric("silk"));
    refine(cloth, 1);
    EXPECT_EQ(cloth.elements.vertices.size(), 81U);
    EXPECT_EQ(cloth.elements.stretch.size(), 128U);
    EXPECT_EQ(cloth.elements.limits.size(), 208U);
    EXPECT_EQ(cloth.elements.bend.size(), 208U - 32U);  // the outline has no hinge
}

}  // namespace
}  // namespace selvedge::test
