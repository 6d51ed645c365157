// That the leaf lists, which are kept in place, tell exactly what a comparison of the lists before and after finds.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

// The lists by id, as one who follows them would hold them.
struct Copy {
    std::set<VertexId> vertices;
    std::map<EdgeId, LeafEdge> edges;
    std::map<TriangleId, LeafTriangle> triangles;
    std::map<EdgeId, Hinge> hinges;

    explicit Copy(const LeafLists& lists) : vertices(lists.vertices.begin(), lists.vertices.end()) {
        for (const LeafEdge& e : lists.edges) edges[e.edge] = e;
        for (const LeafTriangle& t : lists.triangles) triangles[t.triangle] = t;
        for (const Hinge& h : lists.hinges) hinges[h.edge] = h;
    }
    bool operator==(const Copy&) const = default;
};

template <class Key, class Value>
void take_over(std::map<Key, Value>& old, const std::map<Key, Value>& now, const std::vector<Key>& changed) {
    for (const Key key : changed) {
        if (const auto it = now.find(key); it != now.end()) old[key] = it->second;
    }
}

// Brings a copy up to date with nothing but what the mesh says has changed.
void follow(Copy& copy, const Copy& now, const LeafChanges& changes) {
    for (const VertexId v : changes.vertices_gone) EXPECT_EQ(copy.vertices.erase(v), 1U);
    for (const EdgeId e : changes.edges_gone) {
        EXPECT_EQ(copy.edges.erase(e), 1U);
        copy.hinges.erase(e);
    }
    for (const TriangleId t : changes.triangles_gone) EXPECT_EQ(copy.triangles.erase(t), 1U);
    for (const VertexId v : changes.vertices_come) EXPECT_TRUE(copy.vertices.insert(v).second);
    for (const EdgeId e : changes.edges_come) EXPECT_FALSE(copy.edges.contains(e));
    for (const TriangleId t : changes.triangles_come) EXPECT_FALSE(copy.triangles.contains(t));
    for (const EdgeId e : changes.hinges_changed) EXPECT_TRUE(copy.hinges.contains(e));
    take_over(copy.edges, now.edges, changes.edges_come);
    take_over(copy.hinges, now.hinges, changes.edges_come);
    take_over(copy.hinges, now.hinges, changes.hinges_changed);
    take_over(copy.triangles, now.triangles, changes.triangles_come);
}

void follow_random_adaptions(const GarmentMesh& base, unsigned seed) {
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    std::mt19937 random(seed);
    Copy copy(mesh.leaves());
    std::size_t changes = 0;
    for (int i = 0; i < 40; ++i) {
        const double eagerness = static_cast<double>(random() % 100) / 100.0;
        adapt(mesh, state, {}, RandomCriterion{random, eagerness, 1.0 - eagerness});
        const Copy now(mesh.leaves());
        follow(copy, now, mesh.changes());
        changes += mesh.changes().triangles_come.size() + mesh.changes().hinges_changed.size();
        ASSERT_EQ(copy, now) << "seed " << seed << ", adaption " << i;
        ASSERT_TRUE(check(mesh).empty()) << check(mesh).front();
    }
    EXPECT_GT(changes, 100U);
}

TEST(Changes, let_a_copy_of_the_lists_follow_them) {
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) follow_random_adaptions(make_square(), seed);
    follow_random_adaptions(tube(5, 2), 6);
    follow_random_adaptions(octahedron(), 7);
    follow_random_adaptions(bow_tie(), 8);
}

TEST(Changes, are_all_of_the_lists_of_a_fresh_mesh) {
    const AdaptiveMesh mesh(make_square());
    EXPECT_EQ(mesh.changes().vertices_come.size(), 25U);
    EXPECT_EQ(mesh.changes().edges_come.size(), 56U);
    EXPECT_EQ(mesh.changes().triangles_come.size(), 32U);
    EXPECT_TRUE(mesh.changes().triangles_gone.empty());
}

TEST(Changes, are_none_when_nothing_changes) {
    AdaptiveMesh mesh(make_square());
    NoState state;
    set_uniform_level(mesh, state, 1);
    EXPECT_FALSE(mesh.changes().triangles_come.empty());
    set_uniform_level(mesh, state, 1);
    EXPECT_TRUE(mesh.changes().triangles_come.empty() && mesh.changes().triangles_gone.empty());
    EXPECT_TRUE(mesh.changes().edges_come.empty() && mesh.changes().edges_gone.empty());
    EXPECT_TRUE(mesh.changes().vertices_come.empty() && mesh.changes().vertices_gone.empty());
    EXPECT_TRUE(mesh.changes().hinges_changed.empty());
}

// One split edge of a large square: what changed is what lies at its two triangles, however large the square.
TEST(Changes, of_one_split_are_as_few_in_a_large_mesh_as_in_a_small_one) {
    for (const int quads : {4, 40}) {
        AdaptiveMesh mesh(make_square({.columns = quads, .rows = quads}));
        NoState state;
        EdgeId inner;
        for (const Hinge& h : mesh.hinges()) inner = h.edge;
        adapt(mesh, state, {}, ChosenEdges{{inner}});
        EXPECT_EQ(mesh.changes().triangles_gone.size(), 2U);
        EXPECT_EQ(mesh.changes().triangles_come.size(), 4U);
        EXPECT_EQ(mesh.changes().edges_gone.size(), 1U);
        EXPECT_EQ(mesh.changes().edges_come.size(), 4U);
        EXPECT_EQ(mesh.changes().vertices_come.size(), 1U);
        EXPECT_LE(mesh.changes().hinges_changed.size(), 4U);
    }
}

TEST(Changes, leave_what_did_not_change_in_its_place) {
    AdaptiveMesh mesh(make_square());
    NoState state;
    const std::vector<LeafTriangle> before(mesh.leaf_triangles().begin(), mesh.leaf_triangles().end());
    adapt(mesh, state, {}, ChosenEdges{{mesh.hinges()[3].edge}});
    std::size_t moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) moved += mesh.leaf_triangles()[i] == before[i] ? 0 : 1;
    EXPECT_EQ(moved, 2U);
}

}  // namespace
}  // namespace selvedge::test
