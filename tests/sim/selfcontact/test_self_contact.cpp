// Cloth that meets cloth: nothing passes through, what crosses comes apart, and layers keep their order.
#include "sim/selfcontact/self_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/selfcontact/sheets.h"

namespace selvedge::sim::test {
namespace {

constexpr float kEdge = 0.02F;  // m
constexpr int kSubsteps = 12;

int crossings(Sheets& sheets) {
    return static_cast<int>(find_crossing_triangles(sheets.surface, sheets.now.front().data()).size());
}

// One step without any force: each vertex keeps its velocity but for what the contacts change.
void coast(Sheets& sheets, SelfContact& contact, const SelfContactOptions& options = {}) {
    contact.begin_step(sheets.points(), options);
    for (int i = 0; i < kSubsteps; ++i) {
        for (std::size_t v = 0; v + 1 < sheets.now.size(); ++v) {
            if (sheets.now[v].w() <= 0) continue;
            const Vec3f move = (sheets.now[v] - sheets.before[v]).head<3>();
            sheets.before[v] = sheets.now[v];
            sheets.now[v].head<3>() += move;
        }
        contact.substep(sheets.points(), options);
    }
    contact.end_step(sheets.points(), options);
}

void add_pinned_sheet(Sheets& sheets) {
    add_flat_sheet(sheets, 12, kEdge, 0, 0);
    for (Vec4f& x : sheets.now) x.w() = 0;
    sheets.before = sheets.now;
}

// Gives the vertices from `first` on a velocity, m per sub-step.
void throw_from(Sheets& sheets, std::size_t first, const Vec3f& move) {
    for (std::size_t v = first; v + 1 < sheets.now.size(); ++v) sheets.before[v].head<3>() -= move;
}

TEST(FindCrossing, an_edge_through_a_triangle_crosses_it_and_one_beside_it_does_not) {
    Sheets sheets;
    add_flat_sheet(sheets, 1, kEdge, 0, 0);
    add_sheet(sheets, 1, kEdge, 0, [](const Vec2f& u) { return Vec3f(0.015F, u.x() - 0.01F, -0.005F - u.y()); });
    const ContactEdge& upright = sheets.surface.edges[sheets.surface.triangles[2].edges[0]];
    ASSERT_EQ(upright.ends[0], sheets.surface.triangles[2].vertices[0]);
    const auto found =
        find_crossing(sheets.surface, sheets.now.front().data(), sheets.surface.triangles[2].edges[0], 0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->along, 0.5F, 1e-5F);
    const Vec3f at = sheets.now[0].head<3>() * found->corners[0] +
                     sheets.now[sheets.surface.triangles[0].vertices[1]].head<3>() * found->corners[1] +
                     sheets.now[sheets.surface.triangles[0].vertices[2]].head<3>() * found->corners[2];
    EXPECT_LT((at - Vec3f(0.015F, 0, -0.005F)).norm(), 1e-5F);
    EXPECT_FALSE(find_crossing(sheets.surface, sheets.now.front().data(), sheets.surface.triangles[2].edges[0], 1));
}

TEST(FindCrossing, flat_cloth_in_any_position_does_not_cross_itself) {
    for (const float angle : {0.1F, 0.7F, 1.3F, 2.9F}) {
        const Eigen::Matrix3f turn(Eigen::AngleAxisf(angle, Vec3f(1, 2, -1).normalized()));
        Sheets sheets;
        add_sheet(sheets, 20, kEdge, 0, [&](const Vec2f& u) -> Vec3f { return turn * Vec3f(u.x(), 0.7F, -u.y()); });
        EXPECT_EQ(crossings(sheets), 0) << angle;
    }
}

TEST(FindCrossing, edges_that_lie_exactly_above_those_of_a_sheet_that_they_cross_are_found) {
    Sheets sheets;
    add_flat_sheet(sheets, 4, kEdge, 0, 0);
    add_sheet(sheets, 4, kEdge, 1, [](const Vec2f& u) { return Vec3f(u.x(), 0.03F - u.x(), -u.y()); });
    EXPECT_GT(crossings(sheets), 3);
}

TEST(SelfContact, a_sheet_thrown_at_another_at_any_speed_does_not_pass_through_it) {
    for (const float speed : {0.5F, 2.0F, 5.0F}) {  // m/s
        Sheets sheets;
        add_flat_sheet(sheets, 12, kEdge, 0, 0);
        const std::size_t first = sheets.now.size() - 1;
        add_flat_sheet(sheets, 8, kEdge, 1, 0.05F);
        for (std::size_t v = first; v + 1 < sheets.now.size(); ++v)
            sheets.now[v].head<3>() += Vec3f(0.043F, 0, -0.037F);
        sheets.before = sheets.now;
        throw_from(sheets, first, {0, -speed / 1440, 0});
        SelfContact contact;
        contact.set_surface(sheets.surface, sheets.vertices());
        for (int step = 0; step < 60; ++step) {
            coast(sheets, contact);
            ASSERT_EQ(crossings(sheets), 0) << speed << " m/s, step " << step;
        }
        const Vec3f below = sheets.now[6 * 13 + 6].head<3>(), above = sheets.now[first + 4 * 9 + 4].head<3>();
        EXPECT_GT(above.y(), below.y());
        EXPECT_TRUE(contact.is_clean());
    }
}

TEST(SelfContact, momentum_is_conserved_when_sheets_collide) {
    Sheets sheets;
    add_flat_sheet(sheets, 8, kEdge, 0, 0);
    const std::size_t first = sheets.now.size() - 1;
    add_flat_sheet(sheets, 8, 0.9F * kEdge, 1, 0.01F);
    throw_from(sheets, first, {0.0002F, -0.001F, 0});
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    const auto momentum = [&] {
        Vec3d sum = Vec3d::Zero();
        for (std::size_t v = 0; v + 1 < sheets.now.size(); ++v) {
            if (sheets.now[v].w() > 0) sum += (sheets.now[v] - sheets.before[v]).head<3>().cast<double>();
        }
        return sum;
    };
    const Vec3d start = momentum();
    for (int step = 0; step < 10; ++step) coast(sheets, contact);
    EXPECT_GT(contact.counts().acted, 0);
    EXPECT_LT((momentum() - start).norm(), 1e-3 * start.norm());
}

TEST(SelfContact, sheets_at_rest_need_no_further_detection) {
    Sheets sheets;
    add_flat_sheet(sheets, 8, kEdge, 0, 0);
    add_flat_sheet(sheets, 8, kEdge, 1, 0.0011F);
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    for (int step = 0; step < 20; ++step) coast(sheets, contact);
    EXPECT_EQ(contact.counts().detections, 1);
}

TEST(SelfContact, sheets_at_rest_need_no_further_refresh) {
    Sheets sheets;
    add_flat_sheet(sheets, 8, kEdge, 0, 0);
    add_flat_sheet(sheets, 8, kEdge, 1, 0.001F);
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    for (int step = 0; step < 10; ++step) coast(sheets, contact);
    EXPECT_EQ(contact.counts().refreshes, 1);
}

// A pull and a push in each sub-step leave a vertex where it was, although it has a speed of 0.5 m/s.
TEST(SelfContact, vertices_that_are_pushed_back_in_each_substep_count_as_resting) {
    Sheets sheets;
    add_flat_sheet(sheets, 8, kEdge, 0, 0);
    add_flat_sheet(sheets, 8, kEdge, 1, 0.02F);
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    coast(sheets, contact);
    const long detections = contact.counts().local_detections + contact.counts().detections;
    const SelfContactOptions options;
    for (int step = 0; step < 5; ++step) {
        contact.begin_step(sheets.points(), options);
        for (int i = 0; i < 12; ++i) {
            sheets.before[40].head<3>() = sheets.now[40].head<3>() - Vec3f(0, 0.0004F, 0);
            contact.substep(sheets.points(), options);
        }
        contact.end_step(sheets.points(), options);
    }
    EXPECT_EQ(contact.counts().local_detections + contact.counts().detections, detections);
}

// Each vertex of these sheets lies over one of the other sheet, round which there are up to six triangles, and each
// edge over an edge.
TEST(SelfContact, pairs_with_the_same_closest_points_make_one_contact) {
    constexpr int kQuads = 8;
    Sheets sheets;
    add_flat_sheet(sheets, kQuads, kEdge, 0, 0);
    add_flat_sheet(sheets, kQuads, kEdge, 1, 0.001F);
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    contact.begin_step(sheets.points(), {});
    const long vertices = 2 * (kQuads + 1) * (kQuads + 1), edges = kQuads * (3 * kQuads + 2);
    EXPECT_GE(contact.counts().contacts, vertices);
    EXPECT_LE(contact.counts().contacts, vertices + edges + edges / 10);  // rounding doubles some
}

TEST(SelfContact, falling_together_needs_no_further_detection) {
    Sheets sheets;
    add_flat_sheet(sheets, 8, kEdge, 0, 0);
    add_flat_sheet(sheets, 8, kEdge, 1, 0.002F);
    throw_from(sheets, 0, {0, -0.003F, 0});
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    for (int step = 0; step < 20; ++step) coast(sheets, contact);
    EXPECT_EQ(contact.counts().detections, 1);
}

TEST(SelfContact, layers_that_cross_from_the_start_come_apart_in_order) {
    Sheets sheets;
    add_pinned_sheet(sheets);
    const std::size_t first = sheets.now.size() - 1;
    add_sheet(sheets, 12, kEdge, 1,
              [](const Vec2f& u) { return Vec3f(u.x() + 0.004F, 0.004F - 0.05F * u.x(), -u.y() - 0.003F); });
    ASSERT_GT(crossings(sheets), 20);
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    for (int step = 0; step < 120; ++step) {
        coast(sheets, contact);
        for (Vec4f& before : sheets.before)
            before = sheets.now[static_cast<std::size_t>(&before - sheets.before.data())];
    }
    EXPECT_EQ(crossings(sheets), 0);
    int below = 0;
    for (std::size_t v = first; v < first + 169; ++v) {
        const Vec3f& x = sheets.now[v].head<3>();
        const bool is_over = x.x() > 0 && x.x() < 0.24F && x.z() < 0 && x.z() > -0.24F;
        below += is_over && x.y() < 0 ? 1 : 0;
    }
    EXPECT_LE(below, 3);
}

TEST(SelfContact, a_vertex_pushed_through_a_sheet_goes_back) {
    Sheets sheets;
    add_pinned_sheet(sheets);
    const std::size_t first = sheets.now.size() - 1;
    add_flat_sheet(sheets, 8, kEdge, 0, 0.0015F);
    for (std::size_t v = first; v + 1 < sheets.now.size(); ++v) sheets.now[v].head<3>() += Vec3f(0.043F, 0, -0.037F);
    sheets.before = sheets.now;
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    coast(sheets, contact);
    ASSERT_TRUE(contact.is_clean());
    sheets.now[first + 40].y() -= 0.006F;
    sheets.before[first + 40].y() -= 0.006F;
    ASSERT_GT(crossings(sheets), 0);
    contact.doubt();
    contact.set_surface(sheets.surface, sheets.vertices());
    coast(sheets, contact);
    EXPECT_EQ(crossings(sheets), 0);
    EXPECT_GT(sheets.now[first + 40].y(), 0);
}

TEST(SelfContact, friction_stops_a_slow_sheet_that_is_pressed_on_another) {
    Sheets sheets;
    add_pinned_sheet(sheets);
    const std::size_t first = sheets.now.size() - 1;
    add_flat_sheet(sheets, 4, kEdge, 1, 0.001F);
    for (std::size_t v = first; v + 1 < sheets.now.size(); ++v) sheets.now[v].head<3>() += Vec3f(0.08F, 0, -0.08F);
    sheets.before = sheets.now;
    throw_from(sheets, first, {2e-5F, 0, 0});
    SelfContact contact;
    contact.set_surface(sheets.surface, sheets.vertices());
    for (int step = 0; step < 30; ++step) {
        coast(sheets, contact);
        throw_from(sheets, first, {0, -5e-6F, 0});  // presses
    }
    float fastest = 0;
    for (std::size_t v = first; v < first + 25; ++v) {
        fastest = std::max(fastest, std::abs(sheets.now[v].x() - sheets.before[v].x()));
    }
    EXPECT_LT(fastest, 1e-6F);
}

TEST(SelfContact, vertices_that_are_being_sewn_together_may_meet) {
    Sheets sheets;
    add_flat_sheet(sheets, 4, kEdge, 0, 0);
    const std::size_t first = sheets.now.size() - 1;
    add_sheet(sheets, 4, kEdge, 0, [](const Vec2f& u) { return Vec3f(0.0804F + u.x(), 0, -u.y()); });
    ContactSurface unsewn = sheets.surface, sewn = sheets.surface;
    for (std::uint32_t v = 0; v < sheets.vertices(); ++v) sewn.sewn.push_back(v);
    for (std::uint32_t row = 0; row <= 4; ++row) sewn.sewn[first + 5 * row] = 5 * row + 4;
    for (const bool is_sewn : {true, false}) {
        Sheets meeting = sheets;
        SelfContact contact;
        contact.set_surface(is_sewn ? sewn : unsewn, meeting.vertices());
        coast(meeting, contact);
        EXPECT_EQ(contact.counts().acted == 0, is_sewn);
    }
}

TEST(SelfContact, avx2_and_avx512_give_the_same_bits) {
    if (detected_simd_level() != SimdLevel::Avx512) GTEST_SKIP() << "this processor has no AVX-512";
    const auto collide = [](SimdLevel level) {
        const SimdLimit limit(level);
        Sheets sheets;
        add_flat_sheet(sheets, 12, kEdge, 0, 0);
        const std::size_t first = sheets.now.size() - 1;
        add_flat_sheet(sheets, 12, 0.97F * kEdge, 1, 0.01F);
        throw_from(sheets, first, {0.0003F, -0.001F, 0.0001F});
        SelfContact contact;
        contact.set_surface(sheets.surface, sheets.vertices());
        for (int step = 0; step < 20; ++step) coast(sheets, contact);
        return sheets.now;
    };
    EXPECT_EQ(collide(SimdLevel::Avx2), collide(SimdLevel::Avx512));
}

}  // namespace
}  // namespace selvedge::sim::test
