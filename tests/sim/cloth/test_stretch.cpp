// The material frame of a triangle and the measured strain, for known deformations.
#include <gtest/gtest.h>
#include <cmath>

#include "sim/cloth/cloth.h"
#include "sim/cloth/curvature_map.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
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
