// Contacts: no vertex or sample enters the body, and cloth sticks or slides according to Coulomb's law.
#include "sim/cloth/contact.h"
#include "sim/cloth/solver_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_blocks.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

constexpr float kOffset = 0.003F;

// The contact offset minus the maximum error of the distance field, m.
float min_clearance(const BodyCollider& body) {
    return kOffset - body.max_error() - 1e-4F;
}

TEST(Outside, leaves_alone_what_is_far_enough_away) {
    for (const Vec3f& x : {Vec3f(0, 1.16F, 0), Vec3f(0.5F, 1, 0), Vec3f(0, 1.1531F, 0)}) {
        EXPECT_EQ(outside(x, Vec3f::UnitY(), ball(), kOffset), x);
    }
}

TEST(Outside, moves_what_is_inside_or_too_near_onto_the_offset_surface) {
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        const Vec3f direction = Vec3f(draw(random, -1, 1), draw(random, -1, 1), draw(random, -1, 1)).normalized();
        const Vec3f x = Vec3f(0, 1, 0) + direction * draw(random, 0.05F, 0.1525F);
        const Vec3f moved = outside(x, direction, ball(), kOffset);
        EXPECT_NEAR(exact_distance(ball(), moved), kOffset, ball().max_error() + 2e-4F);
        EXPECT_LT((moved - x).normalized().cross(direction).norm(), 0.1F) << "it left sideways";
    }
}

TEST(Outside, leaves_a_thin_part_on_the_side_that_the_cloth_is_on) {
    const Obstacle plate(shapes::box(Vec3d(-0.2, 0.99, -0.2), Vec3d(0.2, 1.0, 0.2), 8));
    const Vec3f nearer_to_the_top(0.01F, 0.998F, 0.02F);
    EXPECT_NEAR(outside(nearer_to_the_top, Vec3f::UnitY(), plate.collider, kOffset).y(), 1.003F, 5e-4F);
    EXPECT_NEAR(outside(nearer_to_the_top, -Vec3f::UnitY(), plate.collider, kOffset).y(), 0.987F, 5e-4F);
}

// A body that moves by 4 mm cannot touch what was 10 mm away: its cached distance is kept, less 4 mm.
TEST(KeepFarContacts, forgets_only_what_a_moved_body_may_touch) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.2, .quads = 2});
    std::vector<Vec4f>& query = cloth.solver->contacts.query_point;
    ASSERT_GE(query.size(), 3U);
    query[0].w() = 0.01F;
    query[1].w() = 0.003F;
    query[2].w() = -0.0001F;
    keep_far_contacts(cloth, 0.004F);
    EXPECT_NEAR(query[0].w(), 0.006F, 1e-6F);
    EXPECT_LT(query[1].w(), ContactCacheArrays::kInvalidBelow);
    EXPECT_LT(query[2].w(), ContactCacheArrays::kInvalidBelow);
}

TEST(RefreshContacts, samples_every_edge_longer_than_the_spacing_and_triangles_that_could_dip_into_a_body) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.4, .quads = 4});
    for (const int level : {0, 1, 2, 3}) {
        refine(cloth, level);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<float>> samples;
        std::size_t middles = 0;
        for (std::size_t lane = 0; lane < kBlock * cloth.solver->contacts.samples.size(); ++lane) {
            const SampleBlock& block = cloth.solver->contacts.samples[lane / kBlock];
            const std::array<float, 3> shares{block.shares[0][lane % kBlock], block.shares[1][lane % kBlock],
                                              block.shares[2][lane % kBlock]};
            if (shares[0] == 0) continue;
            EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1, 1e-5F);
            const auto [a, b, c] = corners_at(block, lane % kBlock);
            if (shares[2] > 0) {
                ++middles;
            } else {
                samples[std::minmax(a, b)].push_back(a < b ? shares[1] : shares[0]);
            }
        }
        // Inner points of a lattice with three parts per side, the centroid, or more.
        std::size_t expected = 0;
        for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
            const float longest =
                std::max({(t.u[1] - t.u[0]).norm(), (t.u[2] - t.u[1]).norm(), (t.u[0] - t.u[2]).norm()});
            const auto parts = static_cast<std::size_t>(std::max(3.0F, std::ceil(longest / 0.025F)));
            if (longest >= ContactOptions{}.sampled_edge) expected += (parts - 1) * (parts - 2) / 2;
        }
        EXPECT_EQ(middles, expected);
        for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
            std::vector<float> t = samples[std::minmax(edge.a.value, edge.b.value)];
            t.push_back(0);
            t.push_back(1);
            std::sort(t.begin(), t.end());
            for (std::size_t i = 1; i < t.size(); ++i) EXPECT_LE((t[i] - t[i - 1]) * edge.rest_length, 0.0251F);
            if (edge.rest_length < 0.0249F) {
                EXPECT_EQ(t.size(), 2U) << "a short edge needs no sample";
            }
        }
    }
}

// As in a mesh of 50 cm edges: lattices would have twice as many, and in slivers any number.
TEST(RefreshContacts, samples_triangles_with_long_edges_by_their_area) {
    const Cloth cloth = make_patch(find_fabric("silk"), {.side = 1, .quads = 2});
    constexpr float kArea = 1;  // m^2
    const float spacing = ContactOptions{}.sample_spacing;
    float nearest_edge = 1;
    std::size_t middles = 0;
    for (std::size_t slot = 0; slot < kBlock * cloth.solver->contacts.samples.size(); ++slot) {
        const SampleBlock& block = cloth.solver->contacts.samples[slot / kBlock];
        if (block.shares[2][slot % kBlock] <= 0) continue;
        ++middles;
        float sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            sum += block.shares[k][slot % kBlock];
            nearest_edge = std::min(nearest_edge, block.shares[k][slot % kBlock]);
        }
        EXPECT_NEAR(sum, 1, 1e-5F);
    }
    EXPECT_NEAR(static_cast<float>(middles), kArea / (spacing * spacing), 0.15F * kArea / (spacing * spacing));
    EXPECT_GT(nearest_edge, 0) << "inside";
}

// The number of samples whose first vertex belongs to an edge that may be split, and the number of the others.
std::array<std::size_t, 2> samples_of(const Cloth& cloth, const SplitLimits& limits) {
    std::set<std::uint32_t> near;  // vertices of edges that may be split
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
        if (limits.allow(cloth.mesh, edge.edge)) near.insert({edge.a.value, edge.b.value});
    }
    std::array<std::size_t, 2> count{};
    for (std::size_t slot = 0; slot < kBlock * cloth.solver->contacts.samples.size(); ++slot) {
        const SampleBlock& block = cloth.solver->contacts.samples[slot / kBlock];
        if (block.shares[0][slot % kBlock] == 0) continue;
        ++count[near.contains(block.vertices[0][slot % kBlock] / 4) ? 0 : 1];
    }
    return count;
}

TEST(RefreshContacts, samples_no_edge_that_is_split_where_it_dips_into_a_body) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.4, .quads = 2});
    const SplitLimits by_level{.max_level = 1}, by_length{.shortest_edge = 0.15F}, all{}, never{.max_level = 0};
    for (const SplitLimits& limits : {by_level, by_length, all}) {
        refine(cloth, 0);
        ASSERT_GT(samples_of(cloth, limits)[0], 0U);
        refresh_contacts(cloth, {}, limits);
        EXPECT_EQ(samples_of(cloth, limits), (std::array<std::size_t, 2>{})) << "all edges may be split";
    }
    for (const SplitLimits& limits : {by_level, by_length}) {
        refine(cloth, 1);
        const std::array<std::size_t, 2> before = samples_of(cloth, limits);
        ASSERT_GT(before[1], 0U);
        refresh_contacts(cloth, {}, limits);
        EXPECT_EQ(samples_of(cloth, limits)[1], before[1]) << "what may not be split is sampled";
    }
    refresh_contacts(cloth, {}, SplitLimits{.shortest_edge = 0.12F});  // at level 1 only diagonals may be split
    std::size_t sides = 0;
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) sides += edge.rest_length < 0.12F ? 1 : 0;
    EXPECT_GE(sample_count(cloth.solver->contacts), 3 * sides);
    EXPECT_LE(sample_count(cloth.solver->contacts), 4 * sides) << "sides alone, no triangles, which have diagonals";
    refresh_contacts(cloth, {}, never);
    const std::size_t sampled = sample_count(cloth.solver->contacts);
    refresh_contacts(cloth, {}, std::nullopt);
    EXPECT_EQ(sample_count(cloth.solver->contacts), sampled);
}

// Two triangles whose long diagonal crosses a small ball between its ends.
TEST(PushOutSamples, keeps_the_middle_of_a_long_edge_out_of_a_small_ball) {
    const Obstacle small(shapes::sphere(Vec3d(0, 1, 0), 0.04, 16));
    Cloth cloth = make_patch(undamped(), {.side = 0.2, .quads = 1, .height = 1.06});
    run(cloth, small.collider, {.extra_damping = 4, .contact = {.floor = kNoFloor}}, 0.5);
    ASSERT_FALSE(find_bad_vertex(cloth).has_value());
    float highest = 0;
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
        for (int i = 0; i <= 100; ++i) {
            const Vec4f& a = cloth.x[edge.a.value];
            const Vec3f p = (a + (cloth.x[edge.b.value] - a) * (float(i) / 100)).head<3>();
            EXPECT_GT(exact_distance(small.collider, p), -0.0005F);
            highest = std::max(highest, p.y());
        }
    }
    EXPECT_GT(highest, 1.03F) << "it fell past the ball, so nothing was tested";
}

// A square of coarse cloth, whose samples far outnumber its vertices, in the solver's arrays.
Cloth coarse_cloth(double height) {
    Cloth cloth = make_patch(undamped(), {.side = 0.5, .quads = 2, .height = height});
    cloth.solver->points = solver_points(cloth, cloth.x);
    cloth.solver->before = cloth.solver->points;
    return cloth;
}

std::size_t push_out(Cloth& cloth) {
    set_contact_offset(cloth, kOffset);
    return push_out_samples(cloth, kernels(simd_level()), ball(), {.offset = kOffset, .floor = kNoFloor});
}

void move_all(Cloth& cloth, const Vec3f& by) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) cloth.solver->points[v.value].head<3>() += by;
}

// The ball reaches up to 1.15 m.
TEST(PushOutSamples, skips_what_is_far_from_the_body_until_it_may_have_come_near) {
    Cloth cloth = coarse_cloth(1.35);
    const std::size_t blocks = cloth.solver->contacts.samples.size();
    EXPECT_EQ(push_out(cloth), blocks) << "nothing is known yet";
    push_out(cloth);  // measures how far the samples in turn may move
    for (int i = 0; i < 20; ++i) {
        move_all(cloth, Vec3f(0, -0.0002F, 0));
        EXPECT_EQ(push_out(cloth), 0U) << "far away";
    }
    move_all(cloth, Vec3f(0, -0.2F, 0));
    EXPECT_GT(push_out(cloth), 0U) << "it is in the ball now";
}

TEST(PushOutSamples, forgets_what_it_skips_when_the_body_moves_or_the_offset_changes) {
    for (const bool body_moves : {true, false}) {
        Cloth cloth = coarse_cloth(1.35);
        for (int i = 0; i < 3; ++i) push_out(cloth);
        ASSERT_EQ(push_out(cloth), 0U);
        if (body_moves) {
            forget_contacts(cloth);
        } else {
            set_contact_offset(cloth, kOffset / 2);
        }
        EXPECT_GT(push_out(cloth), 0U);
    }
}

// Random walks near the ball, of a cloth that skips and of one that looks at every block each time.
TEST(PushOutSamples, skips_no_block_that_has_something_to_do) {
    std::mt19937 random(8);
    Cloth cloth = coarse_cloth(1.16), looks = coarse_cloth(1.16);
    std::size_t seen = 0, all = 0, pushed = 0;
    for (int round = 0; round < 400; ++round) {
        const float reach = round % 20 == 0 ? 0.02F : 0.0005F;
        const Vec3f drift(0, round / 50 % 2 == 0 ? -0.0008F : 0.0006F, 0);
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            const Vec3f by(draw(random, -reach, reach), draw(random, -reach, reach), draw(random, -reach, reach));
            for (Cloth* each : {&cloth, &looks}) {
                each->solver->before[v.value] = each->solver->points[v.value];
                each->solver->points[v.value].head<3>() += by + drift;
            }
        }
        looks.solver->contacts.skips = {};
        const std::vector<Vec4f> before = cloth.solver->points;
        seen += push_out(cloth);
        all += push_out(looks);
        pushed += cloth.solver->points != before ? 1 : 0;
        ASSERT_EQ(cloth.solver->points, looks.solver->points) << "in round " << round;
        ASSERT_EQ(cloth.solver->before, looks.solver->before) << "in round " << round;
    }
    EXPECT_GT(pushed, 50U) << "it hardly touched the ball, so nothing was tested";
    EXPECT_LT(pushed, 390U) << "it always touched the ball";
    EXPECT_LT(seen, all * 9 / 10) << "hardly anything was skipped";
}

// The ball, as if its answers cost by the slot: a slot that was not asked for gets a wrong one.
class BallBySlot final : public Collider {
 public:
    Contact contact(const Vec3f& p) const override { return ball().contact(p); }
    void contacts(std::span<ContactBlock> blocks, float reach) const override { ball().contacts(blocks, reach); }
    void contacts_apart(std::span<ContactBlock> blocks, std::span<const std::uint16_t> left_out,
                        float reach) const override {
        ball().contacts(blocks, reach);
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            for (std::size_t i = 0; i < kContactLanes; ++i) {
                if ((left_out[b] >> i & 1) == 0) continue;
                blocks[b].set(i, {-1, Vec3f::UnitX()});
                ++left_out_;
            }
        }
    }
    bool costs_by_slot() const override { return true; }
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override {
        return ball().first_hit(from, to);
    }
    float band() const override { return ball().band(); }
    float max_error() const override { return ball().max_error(); }
    long left_out() const { return left_out_; }

 private:
    mutable long left_out_ = 0;
};

// Tangent planes of other points are off by their curvature: half the square of kPlaneReach over the ball's radius.
TEST(PushOutSamples, asks_a_collider_that_costs_by_the_slot_for_what_it_needs_alone) {
    const BallBySlot by_slot;
    std::mt19937 random(9);
    Cloth cloth = coarse_cloth(1.16), other = coarse_cloth(1.16);
    std::size_t pushed = 0;
    for (int round = 0; round < 300; ++round) {
        cloth.solver->before = cloth.solver->points;
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            const Vec3f by(draw(random, -0.0005F, 0.0005F), draw(random, -0.0014F, 0.001F), 0);
            cloth.solver->points[v.value].head<3>() += by;
        }
        other.solver->points = cloth.solver->points;
        other.solver->before = cloth.solver->before;
        const std::vector<Vec4f> before = cloth.solver->points;
        push_out(cloth);
        set_contact_offset(other, kOffset);
        push_out_samples(other, kernels(simd_level()), by_slot, {.offset = kOffset, .floor = kNoFloor});
        pushed += cloth.solver->points != before ? 1 : 0;
        for (std::size_t v = 0; v < cloth.x.size(); ++v)
            ASSERT_LT((cloth.solver->points[v] - other.solver->points[v]).norm(), 1e-4F) << "in round " << round;
    }
    EXPECT_GT(pushed, 50U) << "it hardly touched the ball";
    EXPECT_GT(by_slot.left_out(), 1000);
}

// A block in turn gives the same bits as a block for each of its samples.
TEST(PushOutSamples, of_one_block_that_share_vertices_are_pushed_one_after_the_other) {
    Cloth in_turn = coarse_cloth(1.1535), alone = coarse_cloth(1.1535);
    std::vector<SampleBlock>& blocks = in_turn.solver->contacts.samples;
    const auto is_in_turn = [](const SampleBlock& block) { return block.in_turn[0] != 0; };
    ASSERT_TRUE(std::ranges::any_of(blocks, is_in_turn)) << "too few samples for the colours";
    EXPECT_LT(blocks.size(), sample_count(in_turn.solver->contacts) / 4) << "they do not fill blocks";
    std::vector<SampleBlock>& split = alone.solver->contacts.samples;
    split.clear();
    for (const SampleBlock& block : blocks) {
        if (!is_in_turn(block)) split.push_back(block);
        for (std::size_t at = 0; at < kBlock && is_in_turn(block); ++at) {
            split.push_back(dummy_block<SampleBlock>(in_turn.solver->contacts.vertices));
            split.back().slack.fill(1e6F);
            copy_slot(block, split.back(), at);
            split.back().in_turn.fill(0);
        }
    }
    Cloth untouched = in_turn;
    for (int round = 0; round < 60; ++round) {
        for (Cloth* each : {&in_turn, &alone}) {
            each->solver->before = each->solver->points;
            move_all(*each, Vec3f(0.0001F, -0.0003F, 0));
            push_out(*each);
        }
        move_all(untouched, Vec3f(0.0001F, -0.0003F, 0));
        ASSERT_EQ(in_turn.solver->points, alone.solver->points) << "in round " << round;
    }
    EXPECT_NE(in_turn.solver->points, untouched.solver->points) << "nothing touched";
}

// Calls hold_vertices() for the ball with the present positions.
void hold(Cloth& cloth) {
    cloth.solver->points = solver_points(cloth, cloth.x);
    cloth.solver->before = solver_points(cloth, cloth.x_prev);
    hold_vertices(cloth, kernels(simd_level()), ball(), 1, {.friction_scale = 0, .floor = kNoFloor});
    for (std::size_t v = 0; v < cloth.x.size(); ++v) cloth.x[v] = with_zero_w(cloth.solver->points[v].head<3>());
}

// Random walks of vertices near the ball: whatever slack the cache contains, no vertex may end nearer than the offset.
TEST(HoldVertices, the_slack_never_hides_a_contact) {
    std::mt19937 random(21);
    Cloth cloth = make_patch(undamped(), {.side = 0.4, .quads = 8, .height = 1.12});
    hold(cloth);
    const float least = min_clearance(ball());
    long pushed = 0;
    for (int round = 0; round < 300; ++round) {
        const float reach = round % 10 == 0 ? 0.03F : 0.002F;
        cloth.x_prev = cloth.x;
        for (const VertexId v : cloth.mesh.leaf_vertices()) {
            Vec4f& x = cloth.x[v.value];
            const Vec4f home = Vec4f(0, 1, 0, 0) - x;
            for (int axis = 0; axis < 3; ++axis) x[axis] += draw(random, -reach, reach) + home[axis] * 0.01F;
            if (exact_distance(ball(), x.head<3>()) < kOffset) ++pushed;
        }
        hold(cloth);
        ASSERT_GT(deepest(cloth, ball()), least) << "in round " << round;
    }
    EXPECT_GT(pushed, 5000) << "hardly anything came near the ball, so nothing was tested";
}

TEST(HoldVertices, a_falling_cloth_never_comes_nearer_than_the_offset) {
    Cloth cloth = make_patch(undamped("silk"), {.side = 0.4, .quads = 8, .height = 1.25});
    const float least = min_clearance(ball());
    for (int i = 0; i < 120; ++i) {
        step(cloth, ball(), {.contact = {.floor = kNoFloor}});
        ASSERT_GT(deepest(cloth, ball()), least) << "after step " << i;
    }
    // The middles of triangles touch first, so their corners stay some millimetres further away.
    EXPECT_LT(deepest(cloth, ball()), 3 * kOffset) << "it never reached the ball, so nothing was tested";
}

TEST(HoldVertices, the_floor_holds_what_falls_past_the_body) {
    Cloth cloth = make_patch(undamped(), {.side = 0.2, .quads = 2, .height = 0.1});
    run(cloth, nothing_near(), {.extra_damping = 2, .contact = {.floor = 0.02F}}, 1.0);
    for (const VertexId v : cloth.mesh.leaf_vertices()) EXPECT_NEAR(cloth.x[v.value].y(), 0.023F, 1e-4F);
}

// A patch on the upper side of a slab tilted by `angle_deg` about z.
class Slope {
 public:
    Slope(double angle_deg, double mu)
        : turn_(Eigen::AngleAxisd(-angle_deg * std::numbers::pi / 180, Vec3d::UnitZ())), slab_(tilted(turn_)) {
        Fabric fabric = undamped();
        fabric.friction = mu;
        cloth_ = make_patch(fabric, {.side = 0.1, .quads = 2, .height = kOffset});
        const Vec3d start = Vec3d(0, 2, 0) + turn_ * Vec3d(-0.3, 0, 0);
        move_to(cloth_, turn_.toRotationMatrix().cast<float>(), start.cast<float>());
    }

    // The displacement down the slope after `seconds`, m.
    double slide(double seconds) {
        const Vec3d before = centre_of_mass(cloth_);
        run(cloth_, slab_.collider, {}, seconds);
        return (centre_of_mass(cloth_) - before).dot(turn_ * Vec3d::UnitX());
    }

 private:
    static Body tilted(const Eigen::AngleAxisd& turn) {
        Body body = shapes::box(Vec3d(-0.5, -0.06, -0.15), Vec3d(0.5, 0, 0.15), 4);
        for (Vec3d& p : body.x) p = turn * p + Vec3d(0, 2, 0);
        return body;
    }

    Eigen::AngleAxisd turn_;
    Obstacle slab_;
    Cloth cloth_ = make_patch(undamped());
};

TEST(Friction, holds_on_a_slope_flatter_than_its_angle) {
    for (const double angle_deg : {5.0, 15.0, 25.0}) {
        const double limit = std::tan(angle_deg * std::numbers::pi / 180);
        EXPECT_LT(std::abs(Slope(angle_deg, 1.15 * limit).slide(1.0)), 0.001) << angle_deg << " deg";
    }
}

TEST(Friction, slides_on_a_slope_steeper_than_its_angle_as_fast_as_coulomb_says) {
    constexpr double kSeconds = 0.4;
    for (const double angle_deg : {15.0, 25.0, 35.0}) {
        const double angle = angle_deg * std::numbers::pi / 180;
        const double mu = 0.5 * std::tan(angle);
        const double expected = 0.5 * 9.81 * (std::sin(angle) - mu * std::cos(angle)) * kSeconds * kSeconds;
        EXPECT_NEAR(Slope(angle_deg, mu).slide(kSeconds), expected, 0.1 * expected) << angle_deg << " deg";
    }
}

TEST(Friction, none_at_all_lets_it_slide_freely) {
    const double angle = 20 * std::numbers::pi / 180;
    const double expected = 0.5 * 9.81 * std::sin(angle) * 0.4 * 0.4;
    EXPECT_NEAR(Slope(20, 0).slide(0.4), expected, 0.1 * expected);
}

}  // namespace
}  // namespace selvedge::sim::test
