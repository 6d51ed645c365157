// Constraints in a block share no vertex, and none is lost or duplicated when constraints are added and removed.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/constraint_set.h"
#include "sim/cloth/solver_state.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

using Set = ConstraintSet<StretchBlock, StretchRecord>;
using Corners = std::array<std::uint32_t, 3>;
constexpr std::size_t kDummyVertex = 60;

// Fills a slot with its corners and a value of the triangle.
void fill(Set& set, TriangleId t, const Corners& corners, std::uint32_t slot) {
    const std::size_t at = slot % kBlock;
    for (std::size_t k = 0; k < 3; ++k) set.blocks[slot / kBlock].vertices[k][at] = 4 * corners[k];
    set.blocks[slot / kBlock].anchor[at] = set.records[slot / kBlock].of_area[at] = static_cast<float>(t.value);
}

void insert(Set& set, TriangleId t, const Corners& corners) {
    set.insert(t, corners, kDummyVertex, [&](std::uint32_t slot) { fill(set, t, corners, slot); });
}

Set empty_set() {
    Set set;
    set.make(
        std::vector<TriangleId>{}, kDummyVertex, [](TriangleId t) { return t; }, [](TriangleId) { return Corners{}; },
        [](TriangleId, std::uint32_t) {});
    return set;
}

void expect_holds(const Set& set, TriangleId t, const Corners& corners) {
    const std::uint32_t slot = set.slot_of(t, corners);
    ASSERT_NE(slot, kNoBlockSlot);
    EXPECT_EQ(slot, set.slot_of(t));
    EXPECT_EQ(set.blocks[slot / kBlock].anchor[slot % kBlock], static_cast<float>(t.value));
    EXPECT_EQ(set.records[slot / kBlock].of_area[slot % kBlock], static_cast<float>(t.value));
}

TEST(ConstraintSet, finds_by_its_triangle_what_was_made_and_inserted_and_not_what_was_removed) {
    std::mt19937 random(8);
    std::map<std::uint32_t, Corners> held;
    const auto among = [&](std::uint32_t least) { return least + static_cast<std::uint32_t>(random() % 20); };
    std::vector<TriangleId> first;
    for (std::uint32_t t = 0; t < 100; ++t) {
        first.emplace_back(3 * t);
        held[3 * t] = {among(0), among(20), among(40)};
    }
    Set set;
    set.make(
        first, kDummyVertex, [](TriangleId t) { return t; }, [&](TriangleId t) { return held[t.value]; },
        [&](TriangleId t, std::uint32_t slot) { fill(set, t, held[t.value], slot); });
    std::uint32_t next = 1000;
    std::vector<std::uint32_t> removed;
    for (int i = 0; i < 3000; ++i) {
        if (random() % 2 == 0 && !held.empty()) {
            const auto one = std::next(held.begin(), static_cast<std::ptrdiff_t>(random() % held.size()));
            set.remove(TriangleId(one->first), kDummyVertex);
            EXPECT_EQ(set.slot_of(TriangleId(one->first)), kNoBlockSlot);
            removed.push_back(one->first);
            held.erase(one);
        } else {
            const bool comes_again = !removed.empty() && random() % 2 == 0;
            const std::uint32_t t = comes_again ? removed.back() : ++next;
            if (comes_again) removed.pop_back();
            held[t] = {among(0), among(20), among(40)};
            insert(set, TriangleId(t), held[t]);
        }
    }
    for (const auto& [t, corners] : held) expect_holds(set, TriangleId(t), corners);
    const StretchBlock dummy = dummy_block<StretchBlock>(kDummyVertex);
    const StretchRecord spare_of_records = dummy_record<StretchRecord>();
    std::size_t used = 0;
    for (std::size_t slot = 0; slot < set.blocks.size() * kBlock; ++slot) {
        const std::size_t at = slot % kBlock;
        StretchBlock block = set.blocks[slot / kBlock];
        StretchRecord record = set.records[slot / kBlock];
        if (block.vertices[0][at] != 4 * kDummyVertex) {
            ++used;
            continue;
        }
        const StretchBlock found = block;
        const StretchRecord found_record = record;
        copy_slot(dummy, block, at);
        copy_slot(spare_of_records, record, at);
        EXPECT_EQ(std::memcmp(&block, &found, sizeof block), 0);
        EXPECT_EQ(std::memcmp(&record, &found_record, sizeof record), 0);
    }
    EXPECT_EQ(used, held.size()) << "all others are spare";
    set.forget();
    EXPECT_EQ(set.slot_of(TriangleId(held.begin()->first)), kNoBlockSlot);
}

TEST(ConstraintSet, does_not_take_another_triangle_of_the_same_id_for_its_own) {
    Set set = empty_set();
    insert(set, TriangleId(5), {1, 21, 41});
    EXPECT_NE(set.slot_of(TriangleId(5), {1, 21, 41}), kNoBlockSlot);
    EXPECT_EQ(set.slot_of(TriangleId(5), {1, 21, 42}), kNoBlockSlot);
    EXPECT_EQ(set.slot_of(TriangleId(6), {1, 21, 41}), kNoBlockSlot);
}

TEST(ConstraintSet, has_each_block_weighed_once_that_was_changed) {
    Set set = empty_set();
    for (std::uint32_t t = 0; t < 40; ++t) insert(set, TriangleId(t), {t, 50, 55});  // each gets its own colour
    std::size_t weighed = 0;
    const auto count = [&](auto blocks, auto records) {
        EXPECT_EQ(blocks.size(), records.size());
        weighed += blocks.size();
    };
    set.update_dirty_masses(count);
    EXPECT_EQ(weighed, 40U);
    set.remove(TriangleId(7), kDummyVertex);
    set.update_dirty_masses(count);
    EXPECT_EQ(weighed, 41U);
    set.update_dirty_masses(count);
    EXPECT_EQ(weighed, 41U);
    Set one = empty_set();
    insert(one, TriangleId(1), {1, 2, 3});
    insert(one, TriangleId(2), {4, 5, 6});  // in the same block
    one.remove(TriangleId(1), kDummyVertex);
    weighed = 0;
    one.update_dirty_masses(count);
    EXPECT_EQ(weighed, 1U);
}

TEST(ConstraintSet, forgets_what_it_had_when_it_is_made_again) {
    Set set = empty_set();
    for (std::uint32_t t = 0; t < 40; ++t) insert(set, TriangleId(t), {t, 50, 55});
    const Corners corners{1, 2, 3};
    set.make(
        std::vector<TriangleId>{TriangleId(3)}, kDummyVertex, [](TriangleId t) { return t; },
        [&](TriangleId) { return corners; }, [&](TriangleId t, std::uint32_t slot) { fill(set, t, corners, slot); });
    EXPECT_EQ(set.slot_of(TriangleId(4)), kNoBlockSlot);
    expect_holds(set, TriangleId(3), corners);
    std::size_t weighed = 0;
    set.update_dirty_masses([&](auto blocks, auto) { weighed += blocks.size(); });
    EXPECT_EQ(weighed, 1U);
}

TEST(SavedStates, are_those_of_one_adaptation) {
    SavedStates<int> states;
    EXPECT_EQ(states.find(TriangleId(3), 1), nullptr);
    states.save(TriangleId(3), 1, 7);
    states.save(TriangleId(900), 1, 8);
    ASSERT_NE(states.find(TriangleId(3), 1), nullptr);
    EXPECT_EQ(*states.find(TriangleId(3), 1), 7);
    EXPECT_EQ(states.find(TriangleId(3), 2), nullptr);
    EXPECT_EQ(states.find(TriangleId(4), 1), nullptr);
    EXPECT_EQ(states.find(TriangleId(4), 0), nullptr);
    states.save(TriangleId(3), 1, 9);
    EXPECT_EQ(*states.find(TriangleId(3), 1), 9);
}

using SortedCorners = std::vector<std::uint32_t>;  // sorted

template <class Block>
SortedCorners sorted_corners_at(const Block& block, std::size_t at) {
    SortedCorners corners;
    for (const BlockPoints& points : block.vertices) corners.push_back(points[at] / 4);
    std::sort(corners.begin(), corners.end());
    return corners;
}

// The constraints of all used slots. Fails if a block contains a vertex twice.
template <class Block>
std::multiset<SortedCorners> constraints_of(const std::vector<Block>& blocks, const Cloth& cloth) {
    const std::uint32_t dummy = static_cast<std::uint32_t>(cloth.mesh.vertex_capacity());
    std::multiset<SortedCorners> found;
    for (const Block& block : blocks) {
        std::set<std::uint32_t> touched;
        for (std::size_t at = 0; at < kBlock; ++at) {
            const SortedCorners corners = sorted_corners_at(block, at);
            if (corners.front() == dummy) {
                EXPECT_EQ(corners.back(), dummy) << "a lane is spare as a whole";
                continue;
            }
            const std::set<std::uint32_t> own(corners.begin(), corners.end());  // a missing hinge repeats a corner
            for (const std::uint32_t v : own) EXPECT_TRUE(touched.insert(v).second) << "twice in a block: " << v;
            found.insert(corners);
        }
    }
    return found;
}

SortedCorners sorted(std::initializer_list<VertexId> vertices) {
    SortedCorners corners;
    for (const VertexId v : vertices) corners.push_back(v.value);
    std::sort(corners.begin(), corners.end());
    return corners;
}

// The apex beyond the edge opposite to a corner, or the corner itself if there is none.
VertexId beyond(const AdaptiveMesh& mesh, const LeafTriangle& leaf, std::size_t corner) {
    const Hinge* hinge = mesh.hinge(mesh.triangle(leaf.triangle).edges[(corner + 1) % 3]);
    if (hinge == nullptr) return leaf.v[corner];
    return hinge->left == leaf.v[corner] ? hinge->right : hinge->left;
}

void expect_sound_blocks(const Cloth& cloth) {
    std::multiset<SortedCorners> leaves, bent;
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        leaves.insert(sorted({t.v[0], t.v[1], t.v[2]}));
        bent.insert(sorted(
            {t.v[0], t.v[1], t.v[2], beyond(cloth.mesh, t, 0), beyond(cloth.mesh, t, 1), beyond(cloth.mesh, t, 2)}));
    }
    const Constraints& constraints = cloth.solver->constraints;
    EXPECT_EQ(constraints_of(constraints.stretch.blocks, cloth), leaves);
    EXPECT_EQ(constraints_of(constraints.bend.blocks, cloth), bent);
    EXPECT_EQ(constraints.stretch.records.size(), constraints.stretch.blocks.size());
    ASSERT_EQ(constraints.parents.size(), static_cast<std::size_t>(cloth.mesh.max_level()));
    for (int level = 0; level < cloth.mesh.max_level(); ++level) {
        std::multiset<SortedCorners> refined;
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
            const std::array<VertexId, 3>& v = cloth.mesh.triangle(t).vertices;
            refined.insert(sorted({v[0], v[1], v[2]}));
        }
        const ParentLevel& parents = constraints.parents[static_cast<std::size_t>(level)];
        EXPECT_EQ(constraints_of(parents.limits.blocks, cloth), refined);
        EXPECT_EQ(constraints_of(parents.bend.blocks, cloth).size(), refined.size());
    }
}

void expect_each_leaf_in_its_lane(const Cloth& cloth) {
    const Constraints& constraints = cloth.solver->constraints;
    ASSERT_EQ(constraints.triangle_of.size(), constraints.stretch.blocks.size() * kBlock);
    std::set<std::uint32_t> seen;
    for (std::size_t slot = 0; slot < constraints.triangle_of.size(); ++slot) {
        if (constraints.triangle_of[slot] == kNoBlockSlot) continue;
        const std::array<VertexId, 3>& v = cloth.mesh.triangle(TriangleId(constraints.triangle_of[slot])).vertices;
        EXPECT_EQ(sorted_corners_at(constraints.stretch.blocks[slot / kBlock], slot % kBlock),
                  sorted({v[0], v[1], v[2]}));
        EXPECT_TRUE(seen.insert(constraints.triangle_of[slot]).second) << "twice";
    }
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) EXPECT_TRUE(seen.contains(leaf.triangle.value));
    EXPECT_EQ(seen.size(), cloth.mesh.leaf_triangles().size());
}

// Triangles of equal size about one vertex.
GarmentMesh fan(int count) {
    GarmentMesh mesh;
    mesh.panel_names = {"fan"};
    mesh.panel_grain_angles = {0};
    std::vector<Vec2d> u{Vec2d::Zero()};
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        u.push_back(Vec2d(std::cos(angle), std::sin(angle)));
    }
    for (const Vec2d& p : u) mesh.x.push_back(Vec3d(p.x(), 1, -p.y()));
    for (int i = 0; i < count; ++i) {
        const int a = 1 + i, b = 1 + (i + 1) % count;
        mesh.triangles.push_back({.vertices = {0, a, b}, .u = {u[0], u[std::size_t(a)], u[std::size_t(b)]}});
    }
    return mesh;
}

TEST(BlockColoring, gives_each_constraint_one_lane_of_a_block_without_common_vertices) {
    std::mt19937 random(5);
    BlockColoring coloring;
    for (int run = 0; run < 3; ++run) {
        std::vector<std::array<std::uint32_t, 3>> constraints;
        coloring.start(300);
        for (int i = 0; i < 2000; ++i) {
            const auto among = [&](std::uint32_t least) { return least + static_cast<std::uint32_t>(random() % 100); };
            constraints.push_back({among(0), among(100), among(200)});
            coloring.add<3>(constraints.back());
        }
        const std::vector<std::uint32_t>& lanes = coloring.assign();
        ASSERT_EQ(lanes.size(), constraints.size());
        std::set<std::uint32_t> taken;
        std::set<std::pair<std::uint32_t, std::uint32_t>> touched;  // block, vertex
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            EXPECT_LT(lanes[i], coloring.block_count() * kBlock);
            EXPECT_TRUE(taken.insert(lanes[i]).second) << "two in one lane";
            const auto block = static_cast<std::uint32_t>(lanes[i] / kBlock);
            for (const std::uint32_t v : constraints[i]) EXPECT_TRUE(touched.insert({block, v}).second);
        }
    }
}

// All share vertex 0, so that colours run out; another constraint is inserted among them.
TEST(BlockColoring, fills_blocks_with_colourless_constraints_in_the_order_of_insertion) {
    BlockColoring coloring;
    coloring.start(10, BlockColoring::Colorless::InTurn);
    coloring.assign();
    std::vector<std::uint32_t> in_turn;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const std::uint32_t slot = coloring.insert<2>({0, 1 + i % 4});
        if (coloring.is_in_turn(slot / kBlock)) in_turn.push_back(slot);
    }
    ASSERT_GT(in_turn.size(), 200U);
    EXPECT_TRUE(std::ranges::is_sorted(in_turn));
    EXPECT_EQ(in_turn.back() - in_turn.front(), in_turn.size() - 1) << "there are gaps";
    coloring.remove<2>(in_turn[3], {0, 1});
    EXPECT_EQ(coloring.insert<2>({0, 2}), in_turn[3]);
    const std::uint32_t other = coloring.insert<2>({7, 8});
    for (int i = 0; i < 17; ++i) EXPECT_TRUE(coloring.is_in_turn(coloring.insert<2>({0, 2}) / kBlock));
    EXPECT_FALSE(coloring.is_in_turn(other / kBlock));
}

TEST(BlockColoring, has_no_block_for_nothing) {
    BlockColoring coloring;
    coloring.start(10);
    EXPECT_TRUE(coloring.assign().empty());
    EXPECT_EQ(coloring.block_count(), 0U);
}

TEST(Constraints, hold_every_leaf_hinge_and_refined_triangle_once) {
    Cloth cloth = make_patch(find_fabric("silk"));
    for (const int level : {0, 1, 3, 2}) {
        refine(cloth, level);
        expect_sound_blocks(cloth);
        expect_each_leaf_in_its_lane(cloth);
    }
    EXPECT_EQ(cloth.solver->constraints.parents[1].centres.size(), cloth.mesh.split_edges(1).size());
}

TEST(BlockColoring, gives_the_lanes_of_what_goes_to_what_comes_and_keeps_colours_apart) {
    std::mt19937 random(6);
    using Corners3 = std::array<std::uint32_t, 3>;
    BlockColoring coloring;
    coloring.start(60);
    coloring.assign();
    std::map<std::uint32_t, Corners3> by_lane;
    for (int i = 0; i < 4000; ++i) {
        if (random() % 100 < 45 && !by_lane.empty()) {
            const auto one = std::next(by_lane.begin(), std::ptrdiff_t(random() % by_lane.size()));
            coloring.remove(one->first, one->second);
            by_lane.erase(one);
            continue;
        }
        const auto among = [&](std::uint32_t least) { return least + static_cast<std::uint32_t>(random() % 20); };
        const Corners3 corners{among(0), among(20), among(40)};
        const std::uint32_t slot = coloring.insert(corners);
        EXPECT_LT(slot, coloring.block_count() * kBlock);
        EXPECT_TRUE(by_lane.emplace(slot, corners).second) << "two in one lane";
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> touched;  // colour, vertex
    for (const auto& [slot, corners] : by_lane) {
        for (const std::uint32_t v : corners) {
            EXPECT_TRUE(touched.insert({coloring.colors()[slot / kBlock], v}).second);
        }
    }
    std::size_t next = 0;
    for (const BlockColoring::Run& run : coloring.runs()) {
        EXPECT_EQ(run.first, next);
        for (std::size_t i = 1; i < run.count; ++i) {
            EXPECT_EQ(coloring.colors()[run.first + i], coloring.colors()[run.first]);
        }
        next += run.count;
    }
    EXPECT_EQ(next, coloring.block_count());
}

// The contents of each used slot, keyed by its corners in order, independent of the slot's number.
template <class Block, class Record>
std::map<SortedCorners, std::vector<float>> contents(const ConstraintSet<Block, Record>& set, const Cloth& cloth) {
    const auto& [blocks, records] = std::tie(set.blocks, set.records);
    std::map<SortedCorners, std::vector<float>> found;
    const auto add_column = [](const auto& rows, std::size_t at, std::vector<float>& to) {
        std::array<float, sizeof(rows) / sizeof(float)> values;
        std::memcpy(values.data(), &rows, sizeof(rows));
        for (std::size_t i = at; i < values.size(); i += kBlock) to.push_back(values[i]);
    };
    for (std::size_t slot = 0; slot < blocks.size() * kBlock; ++slot) {
        const Block& block = blocks[slot / kBlock];
        SortedCorners corners;
        for (const BlockPoints& points : block.vertices) corners.push_back(points[slot % kBlock] / 4);
        if (corners.front() == cloth.mesh.vertex_capacity()) continue;
        EXPECT_FALSE(found.contains(corners)) << "twice";
        std::vector<float>& values = found[corners];
        add_column(block, slot % kBlock, values);
        if constexpr (!std::is_same_v<Record, StretchRecord>) add_column(records[slot / kBlock], slot % kBlock, values);
    }
    return found;
}

void expect_alike(const std::map<SortedCorners, std::vector<float>>& a,
                  const std::map<SortedCorners, std::vector<float>>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (auto i = a.begin(), j = b.begin(); i != a.end(); ++i, ++j) {
        ASSERT_EQ(i->first, j->first);
        for (std::size_t k = 0; k < i->second.size(); ++k) {
            EXPECT_NEAR(i->second[k], j->second[k], 1e-5F * std::abs(j->second[k])) << "figure " << k;
        }
    }
}

TEST(Constraints, that_change_with_the_mesh_hold_what_blocks_made_anew_hold) {
    std::mt19937 random(7);
    Cloth cloth = make_patch(find_fabric("denim"), {.side = 0.4});
    cloth.is_pinned[3] = true;
    refresh_solver(cloth);
    refresh_contacts(cloth);
    int in_place = 0;
    std::size_t samples = 0;
    for (int i = 0; i < 40; ++i) {
        shake(cloth, 0.004F, random);
        const std::size_t inserted = cloth.solver->lists.inserted;
        // Without collision, so that there are samples.
        const CriteriaOptions criteria{.collision = false};
        if (!adapt_cloth(cloth, nothing_near(), {.criteria = criteria, .shortest_edge = 0}).changed()) continue;
        in_place += cloth.solver->lists.inserted > inserted ? 1 : 0;
        expect_sound_blocks(cloth);
        expect_each_leaf_in_its_lane(cloth);
        Cloth anew = cloth;
        refresh_solver(anew);
        refresh_contacts(anew);
        const Constraints &now = cloth.solver->constraints, &then = anew.solver->constraints;
        expect_alike(contents(now.stretch, cloth), contents(then.stretch, anew));
        expect_alike(contents(now.bend, cloth), contents(then.bend, anew));
        for (std::size_t level = 0; level < now.parents.size(); ++level) {
            const ParentLevel &a = now.parents[level], &b = then.parents[level];
            expect_alike(contents(a.limits, cloth), contents(b.limits, anew));
            expect_alike(contents(a.bend, cloth), contents(b.bend, anew));
            EXPECT_EQ(a.centres.size(), b.centres.size());
        }
        EXPECT_EQ(cloth.solver->contacts.friction, anew.solver->contacts.friction);
        EXPECT_EQ(sample_count(cloth.solver->contacts), sample_count(anew.solver->contacts));
        samples += sample_count(anew.solver->contacts);
    }
    EXPECT_GT(in_place, 5);
    EXPECT_GT(samples, 0U);
}

// More triangles meet in one vertex than there are colours.
TEST(Constraints, hold_a_fan_of_a_hundred_triangles) {
    Cloth cloth = make_cloth(fan(100), {find_fabric("silk")}, {.max_level = 1});
    expect_sound_blocks(cloth);
    refine(cloth, 1);
    expect_sound_blocks(cloth);
    for (int i = 0; i < 20; ++i) step(cloth, nothing_near(), {.contact = {.floor = kNoFloor}});
    EXPECT_FALSE(find_bad_vertex(cloth).has_value());
}

}  // namespace
}  // namespace selvedge::sim::test
