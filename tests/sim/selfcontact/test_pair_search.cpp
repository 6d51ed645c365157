// Pairs of elements that can touch: none is missed, none is found twice.
#include "sim/selfcontact/pair_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/sim/selfcontact/sheets.h"

namespace selvedge::sim::test {
namespace {

// Distances by sampling, m: never too small.
float distance_to_triangle(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c, int steps) {
    float nearest = std::numeric_limits<float>::max();
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const float s = static_cast<float>(i) / static_cast<float>(steps),
                        t = static_cast<float>(j) / static_cast<float>(steps);
            nearest = std::min(nearest, (a + (b - a) * s + (c - a) * t - p).squaredNorm());
        }
    }
    return std::sqrt(nearest);
}

float distance_of_segments(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, int steps) {
    float nearest = std::numeric_limits<float>::max();
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            const float s = static_cast<float>(i) / static_cast<float>(steps),
                        t = static_cast<float>(j) / static_cast<float>(steps);
            nearest = std::min(nearest, (a + (b - a) * s - c - (d - c) * t).squaredNorm());
        }
    }
    return std::sqrt(nearest);
}

// A pair of this kind with random vertices in a cube of 0.1 m.
PairBlock random_pairs(std::mt19937& random, std::vector<Vec4f>& points) {
    std::uniform_real_distribution<float> place(0, 0.1F);
    points.clear();
    PairBlock block;
    for (std::size_t i = 0; i < 4 * kBlock; ++i) points.emplace_back(place(random), place(random), place(random), 1.0F);
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t i = 0; i < kBlock; ++i) block.vertices[k][i] = static_cast<std::uint32_t>(4 * (4 * i + k));
    }
    return block;
}

TEST(MeasurePairs, finds_the_distance_of_a_vertex_from_a_triangle_and_of_two_edges) {
    std::mt19937 random(3);
    std::vector<Vec4f> points;
    for (const SimdLevel level : {SimdLevel::Plain, detected_simd_level()}) {
        for (const PairKind kind : {PairKind::VertexTriangle, PairKind::EdgeEdge}) {
            PairBlock block = random_pairs(random, points);
            const std::vector<Vec4f> still(points.size(), Vec4f::Zero());
            const unsigned found = self_contact_kernels(level).measure_pairs(
                kind, block, points.front().data(), {.moves = still.front().data(), .substeps = 1}, {.margin = 0.01F});
            for (std::size_t i = 0; i < kBlock; ++i) {
                const auto at = [&](std::size_t k) -> Vec3f { return points[4 * i + k].head<3>(); };
                const float exact = kind == PairKind::VertexTriangle
                                        ? distance_to_triangle(at(0), at(1), at(2), at(3), 400)
                                        : distance_of_segments(at(0), at(1), at(2), at(3), 400);
                EXPECT_NEAR(block.gap[i], exact, 2e-4F);
                EXPECT_LE(block.gap[i], exact + 1e-6F);
                EXPECT_EQ((found >> i & 1U) != 0, block.gap[i] <= 0.01F);
            }
        }
    }
}

TEST(PairSearch, finds_every_pair_within_reach_once) {
    Sheets sheets = random_sheets(150, 0.3F, 7);
    const std::vector<Vec4f> still(sheets.now.size(), Vec4f::Zero());
    const Sweep sweep{.moves = still.front().data(), .substeps = 1};
    const SelfContactKernels& loops = self_contact_kernels(simd_level());
    PairSearch search;
    search.set_surface(sheets.surface, sheets.vertices());
    const float reach = 0.001F + kMargin;
    search.find_triangles(loops, sheets.surface, sheets.now.front().data(), sweep, reach);
    ContactPairs pairs;
    search.find_elements(loops, sheets.surface, sheets.now.front().data(), sweep, {.margin = kMargin}, 1, pairs);
    const std::multiset<Key> vertices = keys_of(pairs.vertex_triangle), edges = keys_of(pairs.edge_edge);
    EXPECT_EQ(std::set<Key>(vertices.begin(), vertices.end()).size(), vertices.size());
    EXPECT_EQ(std::set<Key>(edges.begin(), edges.end()).size(), edges.size());

    const auto at = [&](std::uint32_t v) -> Vec3f { return sheets.now[v].head<3>(); };
    int near_vertices = 0, near_edges = 0;
    for (const ContactTriangle& t : sheets.surface.triangles) {
        for (std::uint32_t v = 0; v < sheets.vertices(); ++v) {
            if (std::ranges::find(t.vertices, v) != t.vertices.end()) continue;
            const Vec3f a = at(t.vertices[0]);
            if ((at(v) - a).norm() > 0.12F) continue;
            if (distance_to_triangle(at(v), a, at(t.vertices[1]), at(t.vertices[2]), 40) > 0.9F * reach) continue;
            const Key key = key_of({v, t.vertices[0], t.vertices[1], t.vertices[2]}, PairKind::VertexTriangle);
            if (std::ranges::any_of(sheets.surface.triangles, [&](const ContactTriangle& other) {
                    return std::ranges::count(other.vertices, v) != 0 && other.sheet == t.sheet;
                }))
                continue;  // the other half of a square: a flat neighbour
            EXPECT_EQ(vertices.count(key), 1U);
            ++near_vertices;
        }
    }
    for (std::size_t e = 0; e < sheets.surface.edges.size(); ++e) {
        for (std::size_t f = e + 1; f < sheets.surface.edges.size(); ++f) {
            const auto [a, b] = sheets.surface.edges[e].ends;
            const auto [c, d] = sheets.surface.edges[f].ends;
            const std::uint32_t mine = sheets.surface.edges[e].triangles[0],
                                theirs = sheets.surface.edges[f].triangles[0];
            if (sheets.surface.triangles[mine].sheet == sheets.surface.triangles[theirs].sheet) continue;
            if ((at(a) - at(c)).norm() > 0.12F) continue;
            if (distance_of_segments(at(a), at(b), at(c), at(d), 40) > 0.9F * reach) continue;
            EXPECT_EQ(edges.count(key_of({a, b, c, d}, PairKind::EdgeEdge)), 1U);
            ++near_edges;
        }
    }
    EXPECT_GT(near_vertices, 20);
    EXPECT_GT(near_edges, 20);
}

TEST(PairSearch, leaves_out_pairs_within_flat_cloth) {
    Sheets sheets;
    add_flat_sheet(sheets, 10, 0.02F, 0, 0);
    const std::vector<Vec4f> still(sheets.now.size(), Vec4f::Zero());
    const Sweep sweep{.moves = still.front().data(), .substeps = 1};
    const SelfContactKernels& loops = self_contact_kernels(simd_level());
    PairSearch search;
    search.set_surface(sheets.surface, sheets.vertices());
    search.find_triangles(loops, sheets.surface, sheets.now.front().data(), sweep, 0.005F);
    EXPECT_TRUE(search.triangle_pairs().empty());
}

}  // namespace
}  // namespace selvedge::sim::test
