#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/body/skin.h"
#include "sim/body/tented.h"
#include "sim/motion/motion_file.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim {
namespace {

// A closed block with a top of 20 x 20 cm at height 0, in steps of 2 mm, with a knob of 4 mm radius and 6 mm height.
Body block_with_knob() {
    constexpr int kSteps = 100;
    const auto height = [](double x, double z) { return std::hypot(x, z) < 0.004 ? 0.006 : 0.0; };
    Body body;
    for (const bool is_top : {true, false}) {
        for (int i = 0; i <= kSteps; ++i) {
            for (int k = 0; k <= kSteps; ++k) {
                const double x = 0.002 * i - 0.1, z = 0.002 * k - 0.1;
                body.x.emplace_back(x, is_top ? height(x, z) : -0.1, z);
            }
        }
    }
    const auto at = [](bool is_top, int i, int k) {
        return (is_top ? 0 : (kSteps + 1) * (kSteps + 1)) + i * (kSteps + 1) + k;
    };
    const auto add = [&](std::array<int, 3> t, bool is_turned) {
        if (is_turned) std::swap(t[1], t[2]);
        body.triangles.push_back(t);
    };
    for (const bool is_top : {true, false}) {
        for (int i = 0; i < kSteps; ++i) {
            for (int k = 0; k < kSteps; ++k) {
                add({at(is_top, i, k), at(is_top, i, k + 1), at(is_top, i + 1, k)}, !is_top);
                add({at(is_top, i + 1, k), at(is_top, i, k + 1), at(is_top, i + 1, k + 1)}, !is_top);
            }
        }
    }
    for (int i = 0; i < kSteps; ++i) {
        for (const int side : {0, kSteps}) {
            add({at(true, side, i), at(false, side, i), at(true, side, i + 1)}, side != 0);
            add({at(true, side, i + 1), at(false, side, i), at(false, side, i + 1)}, side != 0);
            add({at(true, i, side), at(false, i, side), at(true, i + 1, side)}, side == 0);
            add({at(true, i + 1, side), at(false, i, side), at(false, i + 1, side)}, side == 0);
        }
    }
    return body;
}

TEST(Tented, hangs_from_a_knob_to_the_ground_round_it) {
    const Body body = block_with_knob(), met = tented(body);
    const auto is_inner = [](const Vec3d& x) { return x.y() > -0.01 && x.cwiseAbs().maxCoeff() < 0.06; };
    double steepest = 0, highest = 0;
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        if (!is_inner(body.x[v])) continue;
        EXPECT_GE(met.x[v].y(), body.x[v].y() - 1e-12);
        highest = std::max(highest, met.x[v].y());
    }
    EXPECT_NEAR(highest, 0.006, 1e-6);
    for (const auto& t : met.triangles) {
        const auto corner = [&](int k) { return met.x[std::size_t(t[std::size_t(k)])]; };
        const Vec3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        if (is_inner(corner(0))) steepest = std::max(steepest, std::acos(std::clamp(normal.y(), -1.0, 1.0)));
    }
    EXPECT_LT(steepest, 0.6);  // rad: against 1.25 of the knob
    EXPECT_GT(steepest, 0.2);
}

TEST(Tented, leaves_what_is_flat) {
    const Body body = block_with_knob(), met = tented(body);
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        const Vec3d& x = body.x[v];
        if (x.y() < -0.01 || x.cwiseAbs().maxCoeff() > 0.06 || std::hypot(x.x(), x.z()) < 0.05) continue;
        EXPECT_LT((met.x[v] - x).norm(), 1e-12);
    }
}

TEST(Tented, moves_with_its_bones_as_the_body_does) {
    const Body& body = test::mannequin();
    const Body met = tented(body);
    const Pose seated = find_pose("sit", body);
    const std::vector<Vec3d> x = skin(body, seated), raised = skin(met, seated);
    double farthest = 0;
    int count = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        const double at_rest = (met.x[v] - body.x[v]).norm();
        EXPECT_NEAR((raised[v] - x[v]).norm(), at_rest, 0.3 * at_rest + 1e-6);  // blended bones shorten it
        farthest = std::max(farthest, at_rest);
        count += at_rest > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(count, 10);
    EXPECT_LT(farthest, 0.03);
}

}  // namespace
}  // namespace selvedge::sim
