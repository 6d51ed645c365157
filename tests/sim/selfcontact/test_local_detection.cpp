// Detections that ask a part of the cloth only, and what carries them: expected paths and dividing planes.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sim/selfcontact/dividing_planes.h"
#include "sim/selfcontact/expected_paths.h"
#include "sim/selfcontact/pair_search.h"
#include "tests/sim/selfcontact/sheets.h"

namespace selvedge::sim::test {
namespace {

constexpr float kReach = 0.005F;         // m
constexpr float kSubstep = 1.0F / 1440;  // s

std::vector<std::uint32_t> all_vertices(const Sheets& sheets) {
    std::set<std::uint32_t> used;
    for (const ContactTriangle& t : sheets.surface.triangles) used.insert(t.vertices.begin(), t.vertices.end());
    return {used.begin(), used.end()};
}

// Gives each vertex a velocity (m/s) of its own.
void set_velocities(Sheets& sheets, std::mt19937& random, float speed) {
    std::uniform_real_distribution<float> component(-speed, speed);
    for (std::size_t v = 0; v < sheets.vertices(); ++v) {
        const Vec3f move = Vec3f(component(random), component(random), component(random)) * kSubstep;
        sheets.before[v].head<3>() = sheets.now[v].head<3>() - move;
    }
}

void move_on(Sheets& sheets, int substeps) {
    for (std::size_t v = 0; v < sheets.vertices(); ++v) {
        const Vec3f move = (sheets.now[v] - sheets.before[v]).head<3>();
        sheets.now[v].head<3>() += move * static_cast<float>(substeps);
        sheets.before[v].head<3>() += move * static_cast<float>(substeps);
    }
}

TEST(ExpectedPaths, vertices_that_move_on_stay_on_their_paths_until_these_end) {
    Sheets sheets;
    add_flat_sheet(sheets, 6, 0.02F, 0, 0);
    std::mt19937 random(1);
    set_velocities(sheets, random, 1);
    ExpectedPaths paths(12);
    paths.start(all_vertices(sheets), sheets.points());
    move_on(sheets, 12);
    EXPECT_LT(paths.measure(sheets.points(), 0).off_path, 1e-5F);
    move_on(sheets, 12);
    EXPECT_GT(paths.measure(sheets.points(), 0).off_path, 0.004F);
}

TEST(ExpectedPaths, motion_that_all_vertices_share_does_not_leave_the_paths) {
    Sheets sheets;
    add_flat_sheet(sheets, 6, 0.02F, 0, 0);
    ExpectedPaths paths(12);
    paths.start(all_vertices(sheets), sheets.points());
    for (Vec4f& x : sheets.now) x += Vec4f(0.5F, -0.3F, 0.1F, 0);
    sheets.before = sheets.now;
    EXPECT_LT(paths.measure(sheets.points(), 6).off_path, 1e-5F);
    EXPECT_TRUE(paths.frame(sheets.points()).isApprox(Vec3f(0.5F, -0.3F, 0.1F), 1e-4F));
}

TEST(ExpectedPaths, a_vertex_off_its_path_gets_a_new_one_and_the_others_keep_theirs) {
    Sheets sheets;
    add_flat_sheet(sheets, 20, 0.02F, 0, 0);
    ExpectedPaths paths(12);
    paths.start(all_vertices(sheets), sheets.points());
    sheets.now[7].y() += 0.01F;
    sheets.now[8].y() += 0.001F;
    EXPECT_NEAR(paths.measure(sheets.points(), 0).off_path, 0.01F, 1e-4F);
    std::vector<std::uint8_t> stays(sheets.vertices(), 1);
    stays[7] = 0;
    paths.restart(stays, sheets.points());
    EXPECT_NEAR(paths.measure(sheets.points(), 0).off_path, 0.001F, 1e-4F);
    EXPECT_LT(paths.squared_deviation(7), 1e-10F);
}

// A search of the parts that left their paths knows every pair that a search of everything finds, and each once.
TEST(PairSearch, asking_the_parts_off_their_paths_misses_no_pair) {
    std::mt19937 random(5);
    Sheets sheets = random_sheets(200, 0.25F, 5);
    set_velocities(sheets, random, 0.3F);
    const SelfContactKernels& loops = self_contact_kernels(simd_level());
    const std::vector<std::uint32_t> vertices = all_vertices(sheets);
    ExpectedPaths paths(12);
    PairSearch search;
    ContactPairs pairs;
    search.set_surface(sheets.surface, sheets.vertices());
    paths.start(vertices, sheets.points());
    const auto find = [&](PairSearch& by, ContactPairs& into, const Sweep& sweep, float margin) {
        by.find_triangles(loops, sheets.surface, sheets.now.front().data(), sweep, kReach);
        by.find_elements(loops, sheets.surface, sheets.now.front().data(), sweep, {.margin = margin}, 1, into);
    };
    find(search, pairs, paths.sweep(sheets.points()), kMargin);
    double asked = 0;
    for (int round = 0; round < 6; ++round) {
        // A quarter of the heap turns round, the rest moves on; everything falls.
        for (std::size_t v = 0; v < sheets.vertices(); ++v) {
            if (v < sheets.vertices() / 4)
                sheets.before[v].head<3>() += 2 * (sheets.now[v] - sheets.before[v]).head<3>();
            const Vec3f fall(0, -0.001F, 0);
            sheets.before[v].head<3>() += fall;
            sheets.now[v].head<3>() += fall;
        }
        move_on(sheets, 3);
        paths.measure(sheets.points(), 0);
        std::vector<std::uint8_t> is_off(sheets.vertices(), 0);
        constexpr float kOff = 5e-4F;  // m
        for (const std::uint32_t v : vertices) is_off[v] = paths.squared_deviation(v) > kOff * kOff ? 1 : 0;
        search.select(sheets.surface, is_off);
        asked += search.share_asked();
        paths.restart(search.stays(), sheets.points());
        find(search, pairs, paths.sweep(sheets.points()), kMargin);

        PairSearch everything;
        ContactPairs all;
        everything.set_surface(sheets.surface, sheets.vertices());
        const std::vector<Vec4f> still(sheets.now.size(), Vec4f::Zero());
        find(everything, all, {.moves = still.front().data(), .substeps = 0}, kMargin - 2 * kOff);
        const auto check = [](const PairList& known, const PairList& expected) {
            const std::multiset<Key> keys = keys_of(known);
            EXPECT_EQ(std::set<Key>(keys.begin(), keys.end()).size(), keys.size());
            EXPECT_GT(expected.size(), 30U);
            for (const Key& key : keys_of(expected)) {
                // Whether a sheet is flat is judged at its last search.
                EXPECT_TRUE(key[0] / 16 == key[3] / 16 || keys.count(key) == 1);
            }
        };
        check(pairs.vertex_triangle, all.vertex_triangle);
        check(pairs.edge_edge, all.edge_edge);
    }
    EXPECT_LT(asked, 4.5);
    EXPECT_GT(asked, 0.5);
}

TEST(PairList, removing_pairs_keeps_the_others_and_frees_their_slots) {
    PairList pairs(PairKind::VertexTriangle);
    pairs.clear(1000);
    for (std::uint32_t i = 0; i < 40; ++i) pairs.add({4 * i, 4, 8, 12}, {i, i + 1}, 0.001F, 0.3F);
    pairs.remove(std::vector<std::size_t>{0, 1, 17, 30, 38, 39});
    ASSERT_EQ(pairs.size(), 34U);
    std::set<std::uint32_t> left;
    for (std::size_t i = 0; i < 34; ++i) left.insert(pairs.blocks()[i / kBlock].triangles[0][i % kBlock]);
    EXPECT_EQ(left.size(), 34U);
    for (const std::uint32_t gone : {0U, 1U, 17U, 30U, 38U, 39U}) EXPECT_EQ(left.count(gone), 0U);
    for (std::size_t at = 34 % kBlock; at < kBlock; ++at) {
        EXPECT_EQ(pairs.blocks()[2].vertices[0][at], 4000U);
        EXPECT_LT(pairs.blocks()[2].radius[at], 0);
    }
}

// Twenty sheets of 2 mm distance, with all pairs that can touch.
struct Stack {
    Sheets sheets;
    ContactPairs pairs;
    std::vector<std::uint32_t> vertices;
    std::vector<Vec4f> start;
    const SelfContactKernels& loops = self_contact_kernels(simd_level());

    Stack() {
        for (int layer = 0; layer < 20; ++layer) {
            add_flat_sheet(sheets, 4, 0.01F, layer, 0.002F * static_cast<float>(layer));
        }
        ExpectedPaths paths(12);
        PairSearch search;
        search.set_surface(sheets.surface, sheets.vertices());
        vertices = all_vertices(sheets);
        paths.start(vertices, sheets.points());
        const Sweep sweep = paths.sweep(sheets.points());
        search.find_triangles(loops, sheets.surface, sheets.now.front().data(), sweep, kReach);
        search.find_elements(loops, sheets.surface, sheets.now.front().data(), sweep, {.margin = kMargin}, 1, pairs);
        start = sheets.now;
    }
    CertificateReport certify(DividingPlanes& dividers, const DividingPlanes::Motion& motion = {}) {
        return dividers.certify(loops, pairs, {vertices, start}, motion, sheets.points());
    }
};

// However far the vertices of a stack were moved through each other, all pairs end divided by their planes.
TEST(DividingPlanes, what_was_apart_at_the_start_is_apart_at_the_end) {
    Stack stack;
    Sheets& sheets = stack.sheets;
    std::mt19937 random(9);
    std::uniform_real_distribution<float> off(-0.02F, 0.02F);
    for (std::size_t v = 0; v < sheets.vertices(); ++v) sheets.now[v].y() = off(random) - 3 * sheets.now[v].y();
    DividingPlanes dividers;
    EXPECT_GT(stack.certify(dividers).truncated, 0);
    ASSERT_GT(stack.pairs.size(), 100U);
    for (const PairList* const list : {&stack.pairs.vertex_triangle, &stack.pairs.edge_edge}) {
        for (std::size_t i = 0; i < list->size(); ++i) {
            const DividerExtremes nearest =
                extremes_of(list->blocks()[i / kBlock], i % kBlock, first_side(list->kind()), sheets.points());
            EXPECT_GT(nearest.apart, 0);
        }
    }
}

// A foot has taken the stack along by 10 cm, and pressed it together: what must go back does not stay behind the foot.
TEST(DividingPlanes, leave_a_moving_stack_where_it_was_taken_when_pairs_share_their_motion) {
    const Vec3f way(0.02F, 0, 0.1F);
    for (const bool is_by_pair : {false, true}) {
        Stack stack;
        Sheets& sheets = stack.sheets;
        std::mt19937 random(9);
        std::uniform_real_distribution<float> off(-0.02F, 0.02F);
        for (std::size_t v = 0; v < sheets.vertices(); ++v) {
            sheets.now[v].head<3>() += way + Vec3f(0, off(random) - 4 * sheets.now[v].y(), 0);
            sheets.before[v].head<3>() += 0.99F * way;
        }
        DividingPlanes dividers;
        EXPECT_GT(stack.certify(dividers, {.is_by_pair = is_by_pair}).truncated, 0);
        float farthest = 0, slowest = 1;  // m; per sub-step, along z
        for (const std::uint32_t v : stack.vertices) {
            const Vec3f from_way = sheets.now[v].head<3>() - stack.start[v].head<3>() - way;
            farthest = std::max({farthest, std::abs(from_way.x()), std::abs(from_way.z())});
            slowest = std::min(slowest, sheets.now[v].z() - sheets.before[v].z());
        }
        if (is_by_pair) {
            EXPECT_LT(farthest, 1e-4F);
            EXPECT_NEAR(slowest, 0.001F, 1e-4F);
        } else {
            EXPECT_GT(farthest, 0.03F) << "they go back to where the rest of the cloth is";
        }
    }
}

// What is known of slack from the last look never hides a pair: the positions are the same as without it.
TEST(DividingPlanes, a_certificate_after_others_gives_the_same_positions_as_the_first_one) {
    Stack stack;
    Sheets& sheets = stack.sheets;
    std::mt19937 random(5);
    DividingPlanes knowing;
    int parted = 0;
    for (int step = 0; step < 40; ++step) {
        // most vertices tremble and some move far
        std::uniform_real_distribution<float> little(-2e-5F, 2e-5F), much(-1.5e-3F, 1.5e-3F);
        for (std::size_t v = 0; v < sheets.vertices(); ++v) {
            sheets.now[v].y() += (random() % 100 == 0 ? much(random) : little(random));
        }
        Stack other = stack;
        DividingPlanes fresh;
        parted += stack.certify(knowing).parted;
        other.certify(fresh);
        for (std::size_t v = 0; v < sheets.vertices(); ++v) ASSERT_EQ(sheets.now[v], other.sheets.now[v]) << step;
    }
    EXPECT_GT(parted, 40);
}

}  // namespace
}  // namespace selvedge::sim::test
