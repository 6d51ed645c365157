// Incremental updates of gains, and gathered seams, whose sides have unequal lengths.
#include <gtest/gtest.h>
#include <algorithm>
#include <cstring>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/solver_lists.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/step.h"
#include "sim/mesh/sew.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

template <class Block>
bool are_same_bytes(const std::vector<Block>& a, const std::vector<Block>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Block)) == 0);
}

template <class Set>
void expect_same_set(const Set& a, const Set& b) {
    EXPECT_TRUE(are_same_bytes(a.blocks, b.blocks));
    EXPECT_TRUE(are_same_bytes(a.records, b.records));
}

void expect_same_blocks(const Constraints& a, const Constraints& b) {
    expect_same_set(a.stretch, b.stretch);
    expect_same_set(a.bend, b.bend);
    ASSERT_EQ(a.parents.size(), b.parents.size());
    for (std::size_t level = 0; level < a.parents.size(); ++level) {
        SCOPED_TRACE(level);
        expect_same_set(a.parents[level].limits, b.parents[level].limits);
        expect_same_set(a.parents[level].bend, b.parents[level].bend);
    }
}

void mark_all_dirty(Constraints& constraints) {
    const auto mark_all = [](auto& set) { set.dirty.mark_all(set.blocks.size()); };
    mark_all(constraints.stretch);
    mark_all(constraints.bend);
    for (ParentLevel& level : constraints.parents) {
        mark_all(level.limits);
        mark_all(level.bend);
    }
}

// Adapts randomly displaced cloth repeatedly and compares the incremental update with a complete one; returns the
// number of adaptations that changed the blocks in place.
int adapt_and_compare(Cloth& cloth, float strength, std::mt19937& random) {
    int in_place = 0;
    for (int i = 0; i < 40; ++i) {
        shake(cloth, strength, random);
        const std::size_t inserted = cloth.solver->lists.inserted;
        if (!adapt_cloth(cloth, nothing_near(), {.shortest_edge = 0}).changed()) continue;
        in_place += cloth.solver->lists.inserted > inserted ? 1 : 0;
        Cloth anew = cloth;
        mark_all_dirty(anew.solver->constraints);
        update_effective_masses(anew);
        expect_same_blocks(cloth.solver->constraints, anew.solver->constraints);
        if (::testing::Test::HasFailure()) return in_place;
        for (int k = 0; k < 2; ++k) step(cloth, nothing_near(), {.contact = {.floor = kNoFloor}});
    }
    return in_place;
}

TEST(EffectiveMasses, of_what_changed_alone_are_those_of_all_worked_out_anew) {
    for (const char* fabric : {"denim", "silk", "wool_twill"}) {
        SCOPED_TRACE(fabric);
        std::mt19937 random(11);
        Cloth cloth = make_patch(find_fabric(fabric), {.side = 0.4});
        cloth.is_pinned[3] = true;
        refresh_solver(cloth);
        refresh_contacts(cloth);
        const int of_many = adapt_and_compare(cloth, 0.004F, random);
        const int of_few = adapt_and_compare(cloth, 0.001F, random);
        EXPECT_GT(of_many + of_few, 5);
    }
}

TEST(EffectiveMasses, of_few_changes_leave_most_blocks_alone) {
    std::mt19937 random(11);
    Cloth cloth = make_patch(find_fabric("denim"), {.side = 0.4});
    refresh_solver(cloth);
    refresh_contacts(cloth);
    for (int i = 0; i < 6; ++i) {
        shake(cloth, 0.004F, random);
        adapt_cloth(cloth, nothing_near(), {.shortest_edge = 0});
    }
    // Blocks that are not marked as dirty are not written.
    for (StretchBlock& block : cloth.solver->constraints.stretch.blocks) block.warp.fill(-1);
    update_effective_masses(cloth);
    for (const StretchBlock& block : cloth.solver->constraints.stretch.blocks) EXPECT_EQ(block.warp[0], -1);
}

constexpr double kBand = 0.2;  // m, the shorter side

Panel rectangle(const std::string& name, double width, double top, double bottom) {
    Panel panel;
    panel.name = name;
    panel.vertices = {{-width / 2, bottom}, {width / 2, bottom}, {width / 2, top}, {-width / 2, top}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

// A band pinned at its upper edge with a ruffle gathered onto its lower one, hanging; vertices are displaced slightly
// to the front and back at random.
Cloth make_ruffle(const Fabric& fabric, double fullness) {
    Pattern pattern;
    pattern.panels = {rectangle("band", kBand, 0, -0.05), rectangle("ruffle", fullness * kBand, -0.05, -0.2)};
    pattern.seams.push_back({.first = {0, 0}, .second = {1, 2}});
    GarmentMesh mesh = assemble(pattern, {.target_edge = 0.025});
    merge_seams(mesh);
    Cloth cloth = make_cloth(mesh, {fabric, fabric}, {.max_level = 2});
    std::mt19937 random(3);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        cloth.is_pinned[v.value] = cloth.x[v.value].y() > -1e-4F;
        if (!cloth.is_pinned[v.value]) cloth.x[v.value].z() += draw(random, -1e-3F, 1e-3F);
    }
    cloth.x_prev = cloth.x;
    refresh_solver(cloth);
    refresh_contacts(cloth);
    return cloth;
}

void hang(Cloth& cloth, double seconds) {
    const StepOptions stepping{.extra_damping = 4, .contact = {.floor = kNoFloor}};
    for (double t = 0; t < seconds; t += 1.0 / 30) {
        adapt_cloth(cloth, nothing_near());
        run(cloth, nothing_near(), stepping, 1.0 / 30);
    }
}

// The extent of the hem from front to back, m.
float depth_of_hem(const Cloth& cloth) {
    float least = 1, most = -1;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f& x = cloth.x[v.value];
        if (x.y() > -0.15F) continue;
        least = std::min(least, x.z());
        most = std::max(most, x.z());
    }
    return most - least;
}

class Gathers : public testing::TestWithParam<const char*> {};

TEST_P(Gathers, hang_in_folds_and_come_to_rest_without_a_stretched_triangle) {
    const Fabric fabric = find_fabric(GetParam());
    Cloth gathered = make_ruffle(fabric, 1.4), plain = make_ruffle(fabric, 1);
    for (Cloth* cloth : {&gathered, &plain}) {
        hang(*cloth, 8);
        ASSERT_FALSE(find_bad_vertex(*cloth).has_value());
        EXPECT_LT(speed_now(*cloth), 0.05F) << "m/s: it trembles";
        for (const TriangleStrain& strain : measure_strain(*cloth)) {
            EXPECT_LT(std::max(strain.warp, strain.weft), fabric.strain_limit + 0.05) << "beyond the limit";
        }
    }
    EXPECT_GT(depth_of_hem(gathered), 0.02F) << "no folds";
    EXPECT_GT(depth_of_hem(gathered), 3 * depth_of_hem(plain));
}

INSTANTIATE_TEST_SUITE_P(Of, Gathers, testing::Values("silk", "cotton_shirting", "denim"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace selvedge::sim::test
