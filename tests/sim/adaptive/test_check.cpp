// That check() does find what is broken, as far as the mesh's own operations can leave it so.
#include "sim/adaptive/check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

bool names(const std::vector<std::string>& problems, const std::string& problem) {
    return std::find(problems.begin(), problems.end(), problem) != problems.end();
}

TEST(Check, finds_nothing_in_a_fresh_mesh) {
    EXPECT_TRUE(check(AdaptiveMesh(tube(5, 3))).empty());
}

TEST(Check, names_the_triangles_of_a_pass_that_is_not_over) {
    AdaptiveMesh mesh(two_triangles());
    mesh.split(edge_between(mesh, VertexId(1), VertexId(2)));
    const std::vector<std::string> problems = check(mesh);
    EXPECT_TRUE(names(problems, "triangle 0: a pass is not over"));
    EXPECT_TRUE(names(problems, "triangle 1: does not conform to its edges"));
    EXPECT_TRUE(names(problems, "triangle 0: a T-junction lies on its edge"));
    EXPECT_TRUE(names(problems, "vertices: the leaf list is not what a traversal finds"));
}

TEST(Check, names_a_triangle_that_was_left_whole_beside_a_split_edge) {
    AdaptiveMesh mesh(two_triangles(), {.max_level = 1});
    NoState state;
    set_uniform_level(mesh, state, 1);
    mesh.change_configuration(TriangleId(1), Configuration::C0);
    const std::vector<std::string> problems = check(mesh);
    EXPECT_TRUE(names(problems, "triangle 1: does not conform to its edges"));
    const EdgeId shared = edge_between(mesh, VertexId(1), VertexId(2));
    EXPECT_TRUE(names(problems, "edge " + std::to_string(shared.value) + ": a hole opens along a child"));
    EXPECT_TRUE(names(problems, "triangles: the leaf list is not what a traversal finds"));
}

TEST(Check, names_lists_that_are_out_of_date) {
    AdaptiveMesh mesh(two_triangles());
    mesh.split(EdgeId(0));
    mesh.retriangulate(0);
    EXPECT_TRUE(names(check(mesh), "edges: the leaf list is not what a traversal finds"));
    mesh.refresh_lists();
    EXPECT_TRUE(check(mesh).empty());
}

}  // namespace
}  // namespace selvedge::test
