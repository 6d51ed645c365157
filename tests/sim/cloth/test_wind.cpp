#include "sim/cloth/wind.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/cloth/fixtures.h"

namespace selvedge::test {
namespace {

constexpr float kArea = 0.16F;  // m^2, of the patch

// Mean velocity, m/s.
Vec3f drift(const Cloth& cloth) {
    Vec4f sum = Vec4f::Zero();
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] <= 0) continue;
        sum += (cloth.x[v.value] - cloth.x_prev[v.value]) / (cloth.inverse_mass[v.value] * cloth.substep);
    }
    return sum.head<3>() / static_cast<float>(total_mass(cloth));
}

TEST(Wind, presses_on_what_stands_across_it_with_the_dynamic_pressure_of_the_air) {
    const Fabric fabric = undamped();
    Cloth cloth = make_patch(fabric);
    const float seconds = 1e-4F;  // too short to follow the wind
    blow(cloth, {.velocity = Vec3f(0, 3, 0), .density = 1.2F, .coefficient = 1.1F}, seconds);
    const double force = 0.5 * 1.2 * 1.1 * 9 * double(kArea);
    EXPECT_NEAR(double(drift(cloth).y()) * total_mass(cloth), force * double(seconds), 0.01 * force * double(seconds));
    EXPECT_NEAR(drift(cloth).x(), 0, 1e-6F);
}

TEST(Wind, along_the_cloth_only_drags) {
    Fabric fabric = undamped();
    fabric.air_drag = 0;
    Cloth smooth = make_patch(fabric);
    blow(smooth, {.velocity = Vec3f(5, 0, 0)}, 0.01F);
    EXPECT_NEAR(drift(smooth).norm(), 0, 1e-6F);

    fabric.air_drag = 0.05;
    Cloth rough = make_patch(fabric);
    blow(rough, {.velocity = Vec3f(5, 0, 0)}, 0.01F);
    const float expected = 5 * (1 - std::exp(-0.05F / float(fabric.area_density) * 0.01F));
    EXPECT_NEAR(drift(rough).x(), expected, 0.01F * expected);
}

TEST(Wind, never_carries_cloth_faster_than_it_blows) {
    for (const char* name : {"silk", "denim"}) {
        Cloth cloth = make_patch(undamped(name));
        for (int i = 0; i < 50; ++i) {
            blow(cloth, {.velocity = Vec3f(0, 40, 0)}, 0.1F);
            EXPECT_LE(drift(cloth).y(), 40.01F) << name;
        }
        EXPECT_GT(drift(cloth).y(), 39.0F) << name;
    }
}

TEST(Wind, in_still_air_a_falling_sheet_comes_to_its_terminal_speed) {
    const Fabric fabric = undamped();
    Cloth cloth = make_patch(fabric, {.height = 60});
    const StepOptions options{.contact = {.floor = kNoFloor}};
    for (int i = 0; i < 240; ++i) {
        blow(cloth, {.coefficient = 1.2F}, step_seconds(cloth, options));
        step(cloth, nothing_near(), options);
    }
    const double terminal = std::sqrt(2 * fabric.area_density * 9.81 / (1.2 * 1.2));
    EXPECT_NEAR(double(-drift(cloth).y()), terminal, 0.06 * terminal);
}

TEST(Wind, does_not_move_what_is_pinned) {
    Cloth cloth = make_patch(undamped());
    const VertexId pinned = cloth.mesh.leaf_vertices()[0];
    cloth.is_pinned[pinned.value] = true;
    refresh_solver(cloth);
    blow(cloth, {.velocity = Vec3f(1, 8, 2)}, 0.05F);
    EXPECT_EQ(cloth.x_prev[pinned.value], cloth.x[pinned.value]);
}

}  // namespace
}  // namespace selvedge::test
