// The choice between the two configurations of a triangle with two split edges.
#include "sim/adaptive/diagonal.h"

#include <gtest/gtest.h>

#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

constexpr TriangleId kOwner{0};
constexpr SplitMask kTwoSplits[] = {0b011, 0b110, 0b101};

TEST(EitherWay, gives_the_two_configurations_of_a_state_and_their_own_diagonals) {
    const EitherWay ways = either_way(0b011);
    EXPECT_EQ(ways.configurations, (std::array{Configuration::C4, Configuration::C5}));
    EXPECT_EQ(ways.diagonals[0], (InternalEdge{{2, 3}}));
    EXPECT_EQ(ways.diagonals[1], (InternalEdge{{0, 4}}));
    for (const SplitMask split : kTwoSplits) {
        for (const Configuration c : either_way(split).configurations) EXPECT_EQ(layout(c).split, split);
    }
    for (const unsigned split : {0b000U, 0b001U, 0b010U, 0b100U, 0b111U}) {
        EXPECT_FALSE(has_two_ways(static_cast<SplitMask>(split)));
    }
}

class Choice : public testing::Test {
 protected:
    // E0 and E1 split: the diagonals run from V2 to M0 (C4) and from V0 to M1 (C5).
    template <class C>
    Configuration chosen(const C& choice) {
        const std::set<EdgeId> two = {mesh.triangle(kOwner).edges[0], mesh.triangle(kOwner).edges[1]};
        adapt_choosing(choice, mesh, state, {}, ChosenEdges{two});
        EXPECT_TRUE(check(mesh).empty());
        const Configuration result = mesh.triangle(kOwner).configuration;
        adapt(mesh, state, {}, ChosenEdges{});
        return result;
    }

    GarmentMesh base = one_triangle();  // (0, 0) (1, 0) (0.25, 0.75)
    AdaptiveMesh mesh{base};
    PositionState state{base, mesh};
};

TEST_F(Choice, by_default_is_the_least_work) {
    EXPECT_EQ(chosen(LeastWork{}), Configuration::C4);
}

TEST_F(Choice, by_rest_length_takes_the_shorter_in_the_material) {
    EXPECT_EQ(chosen(ShortestRestDiagonal{}), Configuration::C5);  // 0.7289 against 0.7906 m
}

TEST_F(Choice, by_length_takes_the_shorter_in_the_room) {
    EXPECT_EQ(chosen(ShortestDiagonal{state.x}), Configuration::C5);
    state.x[0] = {-1.0F, 0.0F, 0.0F};
    EXPECT_EQ(chosen(ShortestDiagonal{state.x}), Configuration::C4);
}

TEST_F(Choice, by_curvature_takes_the_one_that_bends_less) {
    std::vector<Vec3f> normals(mesh.vertex_capacity(), Vec3f::UnitZ());
    normals[2] = Vec3f::UnitX();
    EXPECT_EQ(chosen(FlattestDiagonal{normals}), Configuration::C5);
    normals[2] = Vec3f::UnitZ();
    normals[0] = Vec3f::UnitX();
    EXPECT_EQ(chosen(FlattestDiagonal{normals}), Configuration::C4);
    normals[0] = Vec3f::UnitZ();
    EXPECT_EQ(chosen(FlattestDiagonal{normals}), Configuration::C4) << "equal: the least work";
}

TEST_F(Choice, leaves_a_triangle_as_it_is_when_its_edges_do_not_change) {
    const std::set<EdgeId> two = {mesh.triangle(kOwner).edges[0], mesh.triangle(kOwner).edges[1]};
    adapt(mesh, state, {}, ChosenEdges{two});
    ASSERT_EQ(mesh.triangle(kOwner).configuration, Configuration::C4);
    adapt_choosing(ShortestRestDiagonal{}, mesh, state, {}, ChosenEdges{two});
    EXPECT_EQ(mesh.triangle(kOwner).configuration, Configuration::C4);
}

TEST(Choices, keep_a_mesh_sound_in_random_adaptions) {
    const GarmentMesh base = make_square();
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    std::mt19937 random(9);
    for (int i = 0; i < 40; ++i) {
        const RandomCriterion criterion{random, 0.5, 0.5};
        adapt_choosing(ShortestRestDiagonal{}, mesh, state, {}, criterion);
        ASSERT_TRUE(check(mesh).empty()) << check(mesh).front();
    }
}

}  // namespace
}  // namespace selvedge::test
