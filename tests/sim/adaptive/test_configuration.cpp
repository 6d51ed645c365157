#include "sim/adaptive/configuration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace selvedge {
namespace {

constexpr std::array<std::size_t, kConfigurations> kStateOf = {0, 1, 2, 3, 4, 4, 5, 5, 6, 6, 7};
constexpr std::array<SplitMask, kStates> kSplitOf = {0, 1, 2, 4, 3, 6, 5, 7};

std::vector<Configuration> all_configurations() {
    std::vector<Configuration> all;
    for (std::size_t i = 0; i < kConfigurations; ++i) all.push_back(static_cast<Configuration>(i));
    return all;
}

std::vector<std::array<LocalPoint, 3>> triangles_of(Configuration c) {
    std::vector<std::array<LocalPoint, 3>> triangles;
    for (std::size_t i = 0; i < layout(c).triangle_count; ++i) triangles.push_back(layout(c).triangles[i].points);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

using Triangles = std::vector<std::array<LocalPoint, 3>>;

// Local points of an actual triangle, in sixteenths: areas are exact.
std::array<int, 2> place(LocalPoint p) {
    constexpr std::array<std::array<int, 2>, 6> kPlaces = {{{0, 0}, {8, 0}, {0, 8}, {4, 0}, {4, 4}, {0, 4}}};
    return kPlaces[p];
}

int twice_area(const std::array<LocalPoint, 3>& points) {
    const auto a = place(points[0]), b = place(points[1]), c = place(points[2]);
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

TEST(Configuration, each_belongs_to_its_state) {
    for (const Configuration c : all_configurations()) {
        EXPECT_EQ(state_of(c), kStateOf[index_of(c)]);
        EXPECT_EQ(layout(c).split, kSplitOf[kStateOf[index_of(c)]]);
    }
}

TEST(Configuration, has_the_triangles_that_the_thesis_draws) {
    EXPECT_EQ(triangles_of(Configuration::C0), Triangles{});
    EXPECT_EQ(triangles_of(Configuration::C1), (Triangles{{0, 3, 2}, {1, 2, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C2), (Triangles{{0, 1, 4}, {0, 4, 2}}));
    EXPECT_EQ(triangles_of(Configuration::C3), (Triangles{{0, 1, 5}, {1, 2, 5}}));
    EXPECT_EQ(triangles_of(Configuration::C4), (Triangles{{0, 3, 2}, {1, 4, 3}, {2, 3, 4}}));
    EXPECT_EQ(triangles_of(Configuration::C5), (Triangles{{0, 3, 4}, {0, 4, 2}, {1, 4, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C6), (Triangles{{0, 1, 4}, {0, 4, 5}, {2, 5, 4}}));
    EXPECT_EQ(triangles_of(Configuration::C7), (Triangles{{0, 1, 5}, {1, 4, 5}, {2, 5, 4}}));
    EXPECT_EQ(triangles_of(Configuration::C8), (Triangles{{0, 3, 5}, {1, 2, 5}, {1, 5, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C9), (Triangles{{0, 3, 5}, {1, 2, 3}, {2, 5, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C10), (Triangles{{0, 3, 5}, {1, 4, 3}, {2, 5, 4}, {3, 4, 5}}));
}

TEST(Configuration, fills_its_triangle_without_overlap) {
    for (const Configuration c : all_configurations()) {
        if (c == Configuration::C0) continue;
        int sum = 0;
        for (const auto& points : triangles_of(c)) {
            EXPECT_GT(twice_area(points), 0);
            sum += twice_area(points);
        }
        EXPECT_EQ(sum, 64);
    }
}

TEST(Configuration, uses_each_internal_edge_twice_and_each_piece_of_an_external_edge_once) {
    for (const Configuration c : all_configurations()) {
        std::array<int, kLocalEdges> uses{};
        for (std::size_t i = 0; i < layout(c).triangle_count; ++i) {
            for (const LocalEdge e : layout(c).triangles[i].edges) ++uses[e];
        }
        if (c == Configuration::C0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_split = (layout(c).split >> k & 1) != 0;
            EXPECT_EQ(uses[k], is_split ? 0 : 1);
            EXPECT_EQ(uses[3 + 2 * k], is_split ? 1 : 0);
            EXPECT_EQ(uses[4 + 2 * k], is_split ? 1 : 0);
            EXPECT_EQ(uses[kFirstInternalEdge + k], k < layout(c).edge_count ? 2 : 0);
        }
    }
}

TEST(Transition, keeps_exactly_what_both_configurations_share) {
    for (const Configuration from : all_configurations()) {
        for (const Configuration to : all_configurations()) {
            const Transition& plan = transition(from, to);
            const Triangles old_triangles = triangles_of(from), new_triangles = triangles_of(to);
            Triangles shared;
            std::set_intersection(old_triangles.begin(), old_triangles.end(), new_triangles.begin(),
                                  new_triangles.end(), std::back_inserter(shared));
            Triangles kept;
            for (std::size_t i = 0; i < layout(to).triangle_count; ++i) {
                if (plan.triangle_from[i] == kNoSlot) continue;
                EXPECT_EQ(layout(from).triangles[plan.triangle_from[i]].points, layout(to).triangles[i].points);
                EXPECT_FALSE(plan.drops_triangle[plan.triangle_from[i]]);
                kept.push_back(layout(to).triangles[i].points);
            }
            std::sort(kept.begin(), kept.end());
            EXPECT_EQ(kept, shared);
        }
    }
}

TEST(Transition, to_the_same_configuration_is_no_work) {
    for (const Configuration c : all_configurations()) EXPECT_EQ(transition(c, c).work, 0);
}

TEST(LeastWork, takes_the_diagonal_that_is_already_there) {
    EXPECT_EQ(least_work(Configuration::C1, 0b011), Configuration::C4);
    EXPECT_EQ(least_work(Configuration::C2, 0b011), Configuration::C5);
    EXPECT_EQ(least_work(Configuration::C2, 0b110), Configuration::C6);
    EXPECT_EQ(least_work(Configuration::C3, 0b110), Configuration::C7);
    EXPECT_EQ(least_work(Configuration::C3, 0b101), Configuration::C8);
    EXPECT_EQ(least_work(Configuration::C1, 0b101), Configuration::C9);
}

TEST(LeastWork, stays_where_it_is_and_conforms_wherever_it_goes) {
    for (const Configuration from : all_configurations()) {
        EXPECT_EQ(least_work(from, layout(from).split), from);
        for (SplitMask split = 0; split < 8; ++split) EXPECT_EQ(layout(least_work(from, split)).split, split);
    }
}

TEST(LeastWork, takes_the_first_where_both_are_equal) {
    EXPECT_EQ(least_work(Configuration::C0, 0b011), Configuration::C4);
    EXPECT_EQ(least_work(Configuration::C10, 0b110), Configuration::C6);
}

}  // namespace
}  // namespace selvedge
