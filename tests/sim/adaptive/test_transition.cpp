// Transitions of one actual triangle, through the mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

constexpr TriangleId kOwner{0};

std::vector<Configuration> all_configurations() {
    std::vector<Configuration> all;
    for (std::size_t i = 0; i < kConfigurations; ++i) all.push_back(static_cast<Configuration>(i));
    return all;
}

// One base triangle all of whose edges are split; its configuration is then set by hand.
AdaptiveMesh with_all_edges_split() {
    AdaptiveMesh mesh(one_triangle(), {.max_level = 1});
    for (std::uint32_t e = 0; e < 3; ++e) mesh.split(EdgeId(e));
    mesh.retriangulate(0);
    return mesh;
}

AdaptiveMesh in_configuration(Configuration c) {
    AdaptiveMesh mesh = with_all_edges_split();
    mesh.change_configuration(kOwner, Configuration::C0);
    mesh.change_configuration(kOwner, c);
    return mesh;
}

using Corners = std::array<VertexId, 3>;

std::map<Corners, TriangleId> triangles_inside(const AdaptiveMesh& mesh) {
    std::map<Corners, TriangleId> inside;
    const AdaptiveTriangle& owner = mesh.triangle(kOwner);
    for (std::size_t i = 0; i < layout(owner.configuration).triangle_count; ++i) {
        const TriangleId t = owner.internal_triangles[i];
        inside[mesh.triangle(t).vertices] = t;
    }
    return inside;
}

std::map<std::array<VertexId, 2>, EdgeId> edges_inside(const AdaptiveMesh& mesh) {
    std::map<std::array<VertexId, 2>, EdgeId> inside;
    const AdaptiveTriangle& owner = mesh.triangle(kOwner);
    for (std::size_t i = 0; i < layout(owner.configuration).edge_count; ++i) {
        const EdgeId e = owner.internal_edges[i];
        inside[mesh.edge(e).ends] = e;
    }
    return inside;
}

template <class Map>
auto keys(const Map& map) {
    std::vector<typename Map::key_type> all;
    for (const auto& [key, value] : map) all.push_back(key);
    return all;
}

// The leaf triangles listed by the vertices, each once per corner.
std::size_t listed_corners(const AdaptiveMesh& mesh) {
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < 6; ++v) {
        for (const TriangleId t : mesh.triangles_at(VertexId(v))) {
            EXPECT_TRUE(is_leaf(mesh.triangle(t)));
            ++count;
        }
    }
    return count;
}

template <class F>
void for_each_transition(F&& f) {
    for (const Configuration from : all_configurations()) {
        for (const Configuration to : all_configurations()) {
            SCOPED_TRACE("C" + std::to_string(index_of(from)) + " to C" + std::to_string(index_of(to)));
            if (from != to) f(from, to);
        }
    }
}

TEST(Transition, directly_gives_the_same_triangles_as_by_way_of_none) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh direct = in_configuration(from);
        direct.change_configuration(kOwner, to);
        const AdaptiveMesh by_way_of_c0 = in_configuration(to);
        EXPECT_EQ(keys(triangles_inside(direct)), keys(triangles_inside(by_way_of_c0)));
        EXPECT_EQ(keys(edges_inside(direct)), keys(edges_inside(by_way_of_c0)));
        EXPECT_EQ(direct.triangles().size(), by_way_of_c0.triangles().size());
        EXPECT_EQ(direct.edges().size(), by_way_of_c0.edges().size());
    });
}

TEST(Transition, keeps_the_ids_of_all_that_both_configurations_share) {
    int kept = 0;
    for_each_transition([&](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        const auto old_triangles = triangles_inside(mesh);
        const auto old_edges = edges_inside(mesh);
        mesh.change_configuration(kOwner, to);
        for (const auto& [corners, id] : triangles_inside(mesh)) {
            if (!old_triangles.contains(corners)) continue;
            EXPECT_EQ(old_triangles.at(corners), id);
            ++kept;
        }
        for (const auto& [ends, id] : edges_inside(mesh)) {
            if (!old_edges.contains(ends)) continue;
            EXPECT_EQ(old_edges.at(ends), id);
            ++kept;
        }
    });
    EXPECT_GT(kept, 50);
}

TEST(Transition, updates_the_adjacency_of_vertices_and_the_sides_of_edges) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        mesh.change_configuration(kOwner, to);
        const std::size_t leaves = std::max<std::size_t>(1, layout(to).triangle_count);
        EXPECT_EQ(listed_corners(mesh), 3 * leaves);
        for (const auto& [corners, id] : triangles_inside(mesh)) {
            const AdaptiveTriangle& t = mesh.triangle(id);
            EXPECT_EQ(t.regular, to == Configuration::C10);
            for (std::size_t k = 0; k < 3; ++k) {
                const AdaptiveEdge& edge = mesh.edge(t.edges[k]);
                if (edge.level == 0) continue;  // an external edge that this configuration takes as whole
                EXPECT_EQ(edge.sides[edge.ends[0] == t.vertices[k] ? 0 : 1], id);
                EXPECT_EQ(edge.ends[edge.ends[0] == t.vertices[k] ? 1 : 0], t.vertices[(k + 1) % 3]);
            }
        }
    });
}

TEST(Transition, keeps_the_material_coordinates_of_the_corners) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        mesh.change_configuration(kOwner, to);
        float area = to == Configuration::C0 ? material_area(mesh.triangle(kOwner).u) : 0.0F;
        for (const auto& [corners, id] : triangles_inside(mesh)) area += material_area(mesh.triangle(id).u);
        EXPECT_FLOAT_EQ(area, 0.375F);
    });
}

TEST(Transition, that_goes_there_and_back_leaves_nothing_behind) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        const auto triangles = triangles_inside(mesh);
        const std::size_t edge_count = mesh.edges().size();
        mesh.change_configuration(kOwner, to);
        mesh.change_configuration(kOwner, from);
        EXPECT_EQ(keys(triangles_inside(mesh)), keys(triangles));
        EXPECT_EQ(mesh.edges().size(), edge_count);
    });
}

}  // namespace
}  // namespace selvedge::test
