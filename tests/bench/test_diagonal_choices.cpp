// The choices of a diagonal that the thesis tried, on two crossing diagonals of one cloth.
#include "bench/thesis/diagonal_choices.h"

#include <gtest/gtest.h>

#include "bench/support/square.h"

namespace selvedge::bench {
namespace {

class DiagonalCost : public testing::Test {
 protected:
    bool prefers_first(DiagonalChoice choice) const {
        const auto cost = diagonal_cost(cloth, choice);
        return cost(first) < cost(second);
    }

    sim::Cloth cloth = make_cloth(make_square({.columns = 1, .rows = 1}), {sim::find_fabric("cotton_shirting")});
    sim::Diagonal first{.a = sim::VertexId(0), .b = sim::VertexId(3), .u_a = {0, 0}, .u_b = {1, 1}};
    sim::Diagonal second{.a = sim::VertexId(1), .b = sim::VertexId(2), .u_a = {1, 0}, .u_b = {0, 0.5F}};
};

TEST_F(DiagonalCost, of_the_minimal_change_does_not_exist) {
    EXPECT_FALSE(diagonal_cost(cloth, DiagonalChoice::MinimalChange));
}

TEST_F(DiagonalCost, is_the_length_in_the_material) {
    EXPECT_FALSE(prefers_first(DiagonalChoice::RestLength));
    second.u_b = {0, 2};
    EXPECT_TRUE(prefers_first(DiagonalChoice::RestLength));
}

TEST_F(DiagonalCost, is_the_length_in_space) {
    cloth.x[0] = {-1, 0, 0, 0};
    EXPECT_FALSE(prefers_first(DiagonalChoice::Length));
    cloth.x[0] = cloth.x[3];
    EXPECT_TRUE(prefers_first(DiagonalChoice::Length));
}

TEST_F(DiagonalCost, is_lower_where_the_surface_bends_less) {
    for (Vec3f& normal : cloth.normals) normal = Vec3f::UnitY();
    cloth.normals[0] = Vec3f::UnitX();
    EXPECT_FALSE(prefers_first(DiagonalChoice::Curvature));
    cloth.normals[1] = -Vec3f::UnitY();
    EXPECT_TRUE(prefers_first(DiagonalChoice::Curvature));
}

}  // namespace
}  // namespace selvedge::bench
