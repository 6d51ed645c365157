// The projection of a contact against Coulomb's law, written plainly and in double precision; its carriers; and its
// kernels, which do the same for sixteen carriers.
#include "sim/cloth/body_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "sim/cloth/contact.h"
#include "sim/cloth/kernels.h"

namespace selvedge::sim::test {
namespace {

using Points = std::vector<Vec4f>;
using MovedPlane = MetPlane<OnePoint, Vec3f>;

class Random {
 public:
    explicit Random(unsigned seed) : random_(seed) {}
    float between(float from, float to) { return std::uniform_real_distribution<float>(from, to)(random_); }
    Vec3f vector(float reach) {
        const float x = between(-reach, reach), y = between(-reach, reach);
        return {x, y, between(-reach, reach)};
    }
    Vec3f direction() { return vector(1).normalized(); }

 private:
    std::mt19937 random_;
};

// What a motion since the last sub-step leaves of a point below a plane: it sticks to the surface where its sliding is
// at most what friction can hold, else it slides by the rest.
Vec3d coulomb(const Vec3d& x, const Vec3d& from, const Vec3d& surface_motion, const Vec3d& normal, double depth,
              double pressed, double friction) {
    const Vec3d out = x + depth * normal;
    const Vec3d moved = out - from - surface_motion;
    const Vec3d sliding = moved - moved.dot(normal) * normal;
    const double held = friction * pressed;
    if (sliding.norm() <= held) return out - sliding;
    return out - sliding.normalized() * held;
}

TEST(Projection, leaves_a_point_where_coulombs_law_does) {
    Random random(5);
    int stuck = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3f x = random.vector(0.1F), from = x + random.vector(0.001F);
        const float depth = random.between(0, 0.006F), friction = random.between(0, 1);
        const MovedPlane plane{.normal = random.direction(),
                               .depth = depth,
                               .gained = random.between(0, depth),
                               .motion = random.vector(0.001F)};
        const Vec3f left = projected(x, from, plane, friction);
        const Vec3d normal = plane.normal.cast<double>().normalized();
        const Vec3d expected = coulomb(x.cast<double>(), from.cast<double>(), plane.motion.cast<double>(), normal,
                                       double(depth), double(depth - plane.gained), double(friction));
        EXPECT_LT((left.cast<double>() - expected).norm(), 1e-7);
        const Vec3d moved = expected - (from + plane.motion).cast<double>();
        stuck += (moved - moved.dot(normal) * normal).norm() < 1e-6 ? 1 : 0;
    }
    EXPECT_GT(stuck, 100);
    EXPECT_LT(stuck, 900);
}

TEST(Projection, is_the_same_for_a_body_at_rest_as_for_a_surface_that_moves_by_nothing) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const Vec3f x = random.vector(1), from = x + random.vector(0.001F), normal = random.direction();
        const MetPlane<OnePoint> still{.normal = normal, .depth = 0.0005F, .gained = 0.0001F};
        const MovedPlane moved{.normal = normal, .depth = 0.0005F, .gained = 0.0001F, .motion = Vec3f::Zero()};
        EXPECT_EQ(projected(x, from, still, 0.3F), projected(x, from, moved, 0.3F));
    }
}

TEST(Projection, takes_a_point_along_with_the_surface_if_friction_can_hold_all) {
    const Vec3f from(0.02F, 0.01F, -0.03F), motion(0.0003F, 0.0001F, -0.0002F), normal = Vec3f::UnitY();
    const Vec3f x = from + Vec3f(0.0001F, -0.0004F, 0.0001F);
    const MovedPlane plane{.normal = normal, .depth = 0.0005F, .motion = motion};
    const Vec3f left = projected(x, from, plane, 1.0F);
    EXPECT_LT((left - from - motion).norm(), 1e-8F);
}

TEST(Projection, holds_nothing_by_depth_that_gives_no_velocity) {
    const Vec3f from(0.02F, 0.01F, -0.03F), sliding(0.0003F, 0, 0);
    const MovedPlane plane{.normal = Vec3f::UnitY(), .depth = 0.001F, .gained = 0.001F, .motion = Vec3f::Zero()};
    EXPECT_LT((projected(Vec3f(from + sliding), from, plane, 1.0F) - from - sliding - Vec3f(0, 0.001F, 0)).norm(),
              1e-8F);
}

Points three_points() {  // w: masses of 1, 2 and 4 g
    return {{0, 0, 0, 1000}, {0.02F, 0, 0, 500}, {0, 0.02F, 0, 250}};
}

TEST(Carrier, is_moved_by_an_impulse_that_its_vertices_share) {
    const Carrier carrier{.vertices = {0, 1, 2}, .shares = {0.5F, 0.3F, 0.2F}};
    const Points before = three_points();
    Points points = before;
    const Vec3f by(0.001F, -0.002F, 0.003F);
    shift(carrier, by, points);
    EXPECT_LT((point_of(carrier, points) - point_of(carrier, before) - by).norm(), 1e-8F);
    const auto impulse = [&](std::size_t k) -> Vec3f {
        return (points[k] - before[k]).head<3>() / before[k].w() / carrier.shares[k];
    };
    EXPECT_LT((impulse(0) - impulse(1)).norm(), 1e-5F * impulse(0).norm());
    EXPECT_LT((impulse(0) - impulse(2)).norm(), 1e-5F * impulse(0).norm());
}

TEST(Carrier, moves_by_its_other_vertices_if_one_is_pinned_and_not_if_all_are) {
    const Carrier carrier{.vertices = {0, 1, 2}, .shares = {0.5F, 0.3F, 0.2F}};
    Points points = three_points();
    points[0].w() = 0;
    const Points before = points;
    shift(carrier, Vec3f(0, 0, 0.001F), points);
    EXPECT_EQ(points[0], before[0]);
    EXPECT_LT((point_of(carrier, points) - point_of(carrier, before) - Vec3f(0, 0, 0.001F)).norm(), 1e-8F);
    points[1].w() = points[2].w() = 0;
    const Points pinned = points;
    shift(carrier, Vec3f(0, 0, 0.001F), points);
    EXPECT_EQ(points, pinned);
}

TEST(BodySide, rises_with_its_offset_and_turns_with_its_surface) {
    const BodySide side{.plane = {.point = Vec3f(0, 0.01F, 0),
                                  .motion = Vec3f(0, 0.002F, 0),
                                  .normal = Vec3f::UnitY(),
                                  .turn = Vec3f(1, 0, 0)},
                        .offset = {.start = 0.001F, .change = 0.002F}};
    const MovedPlane half = met(side, Vec3f(0, 0.012F, 0), {.end = 0.5F, .length = 0.25F});
    EXPECT_LT((half.normal - Vec3f(0.5F, 1, 0).normalized()).norm(), 1e-6F);
    EXPECT_NEAR(half.depth, 0.002F - 0.001F * half.normal.y(), 1e-8F);
    EXPECT_NEAR(half.gained, 0.0005F, 1e-9F);
    EXPECT_LT((half.motion - Vec3f(0, 0.0005F, 0)).norm(), 1e-9F);
    EXPECT_EQ(met(side, Vec3f(0, 0.1F, 0), {.end = 0.5F, .length = 0.25F}).depth, 0);
}

BodySide random_side(Random& random, const Vec3f& near) {
    const Vec3f normal = random.direction();
    return {.plane = {.point = near - normal * random.between(0, 0.003F),
                      .motion = random.vector(0.002F),
                      .normal = normal,
                      .turn = random.vector(0.1F)},
            .offset = {.start = 0.002F, .change = random.between(0, 0.001F)}};
}

// Three vertices for each of sixteen samples, which are near the sides of a body, and vertices on their own there.
struct Sixteen {
    Points points, before;
    MovingVertexBlock vertices;
    SampleBlock samples;
    MovingSideBlock sides;                        // of the samples
    std::array<Carrier, kBlock> carriers{};       // the samples, for masses that are equal
    std::array<BodySide, kBlock> side_of{};       // the vertices'
    std::array<BodySide, kBlock> side_beneath{};  // the samples'

    explicit Sixteen(unsigned seed) {
        Random random(seed);
        for (std::uint32_t at = 0; at < kBlock; ++at) {
            for (std::uint32_t k = 0; k < 4; ++k) {
                const Vec3f x = random.vector(0.1F), then = x + random.vector(0.0005F);
                points.push_back({x.x(), x.y(), x.z(), 1000});
                before.push_back({then.x(), then.y(), then.z(), 1000});
            }
            const std::uint32_t vertex = 4 * at + 3;
            vertices.vertices[at] = 4 * vertex;
            vertices.friction[at] = samples.friction[at] = random.between(0, 1);
            side_of[at] = random_side(random, points[vertex].head<3>());
            set_side(vertices.side, at, side_of[at]);
            const float s = random.between(0, 0.5F), t = random.between(0, 0.5F);
            carriers[at] = {.vertices = {4 * at, 4 * at + 1, 4 * at + 2},
                            .shares = {s, t, 1 - s - t},
                            .friction = samples.friction[at]};
            for (std::size_t k = 0; k < 3; ++k) {
                samples.vertices[k][at] = 4 * carriers[at].vertices[k];
                samples.shares[k][at] = carriers[at].shares[k];
            }
            side_beneath[at] = random_side(random, point_of(carriers[at], points));
            set_side(sides, at, side_beneath[at]);
        }
    }
};

constexpr StepShare kShare{.end = 0.75F, .length = 0.25F};
constexpr float kFewUlps = 4 * 7.5e-9F;  // of 0.1 m

void expect_near(const Points& a, const Points& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t v = 0; v < a.size(); ++v) EXPECT_LT((a[v] - b[v]).norm(), kFewUlps) << "vertex " << v;
}

class ContactKernelsAtLevel : public testing::TestWithParam<SimdLevel> {
 protected:
    void SetUp() override {
        if (GetParam() > detected_simd_level()) GTEST_SKIP() << "not on this processor";
    }
};

TEST_P(ContactKernelsAtLevel, project_sixteen_vertices_as_one_by_one) {
    Sixteen at_once(7), in_turn(7);
    const Points start = at_once.points;
    kernels(GetParam())
        .hold_on_planes({&at_once.vertices, 1}, kShare, 0.5F, floats(at_once.before), floats(at_once.points));
    int moved = 0;
    for (std::uint32_t at = 0; at < kBlock; ++at) {
        const std::uint32_t v = 4 * at + 3;
        const Carrier carrier{.vertices = {v, v, v}, .friction = in_turn.vertices.friction[at]};
        const MovedPlane plane = met(in_turn.side_of[at], point_of(carrier, in_turn.points), kShare);
        push_out(carrier, plane, 0.5F, in_turn.points, in_turn.before);
        moved += in_turn.points[v] != start[v] ? 1 : 0;
    }
    EXPECT_GT(moved, 4);
    EXPECT_LT(moved, 16);
    expect_near(at_once.points, in_turn.points);
    expect_near(at_once.before, in_turn.before);
}

// Samples gain velocity by the rise of their planes.
TEST_P(ContactKernelsAtLevel, project_sixteen_samples_as_one_by_one) {
    Sixteen at_once(8), in_turn(8);
    const Points start = at_once.points;
    kernels(GetParam())
        .push_samples_on_planes(at_once.samples, at_once.sides, kShare, 0.5F, floats(at_once.points),
                                floats(at_once.before));
    int moved = 0;
    for (std::uint32_t at = 0; at < kBlock; ++at) {
        const Carrier& carrier = in_turn.carriers[at];
        MovedPlane plane = met(in_turn.side_beneath[at], point_of(carrier, in_turn.points), kShare);
        plane.gained = 0;
        push_out(carrier, plane, 0.5F, in_turn.points, in_turn.before);
        moved += in_turn.points[4 * at] != start[4 * at] ? 1 : 0;
    }
    EXPECT_GT(moved, 4);
    EXPECT_LT(moved, 16);
    expect_near(at_once.points, in_turn.points);
    expect_near(at_once.before, in_turn.before);
}

INSTANTIATE_TEST_SUITE_P(Simd, ContactKernelsAtLevel,
                         testing::Values(SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512),
                         [](const auto& level) { return std::string(name_of(level.param)); });

bool are_same_bits(const Points& a, const Points& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4f)) == 0;
}

TEST(ContactKernels, of_avx2_and_avx512_give_the_same_bits_on_sides_that_move) {
    if (detected_simd_level() < SimdLevel::Avx512) GTEST_SKIP() << "no AVX-512 on this processor";
    Sixteen narrow(9), wide(9);
    const auto push = [](const Kernels& loops, Sixteen& all) {
        loops.push_samples_on_planes(all.samples, all.sides, kShare, 1, floats(all.points), floats(all.before));
        loops.hold_on_planes({&all.vertices, 1}, kShare, 1, floats(all.before), floats(all.points));
    };
    push(kernels(SimdLevel::Avx2), narrow);
    push(kernels(SimdLevel::Avx512), wide);
    EXPECT_TRUE(are_same_bits(narrow.points, wide.points));
    EXPECT_TRUE(are_same_bits(narrow.before, wide.before));
    EXPECT_FALSE(are_same_bits(narrow.points, Sixteen(9).points));
}

}  // namespace
}  // namespace selvedge::sim::test
