#include "sim/mesh/outline_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

std::vector<Vec2d> comb(int teeth) {
    std::vector<Vec2d> points{{0, -0.1}};
    for (int i = 0; i < teeth; ++i) {
        points.emplace_back(0.01 * i + 0.005, 0.4);
        points.emplace_back(0.01 * i + 0.01, 0);
    }
    points.emplace_back(0.01 * teeth, -0.1);
    return points;
}

std::vector<Vec2d> star(int corners) {
    std::vector<Vec2d> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners, radius = i % 2 == 0 ? 0.3 : 0.15;
        points.emplace_back(5 + radius * std::cos(angle), -7 + radius * std::sin(angle));
    }
    return points;
}

std::vector<std::vector<Vec2d>> outlines() {
    return {comb(300), star(7), star(1000), {{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 0.5}, {0.5, 1}, {0, 1}}};
}

// Near the outline, some at its corners and level with them.
std::vector<Vec2d> points_about(const std::vector<Vec2d>& outline, std::mt19937& random) {
    std::normal_distribution<double> off(0, 0.03);
    std::uniform_int_distribution<std::size_t> any(0, outline.size() - 1);
    std::vector<Vec2d> points;
    for (int i = 0; i < 500; ++i) {
        const Vec2d& corner = outline[any(random)];
        points.push_back(corner);
        points.emplace_back(corner.x() + off(random), corner.y());
        points.emplace_back(corner.x(), corner.y() + off(random));
        points.emplace_back(corner.x() + off(random), corner.y() + off(random));
        points.push_back((corner + outline[any(random)]) / 2);
    }
    return points;
}

std::vector<double> heights_for(const std::vector<Vec2d>& outline, std::mt19937& random) {
    std::uniform_real_distribution<double> height(0.001, 0.05);
    std::vector<double> heights(outline.size());
    for (double& h : heights) h = height(random);
    return heights;
}

TEST(OutlineTree, finds_the_same_points_inside_as_a_walk_round_the_outline) {
    std::mt19937 random(1);
    for (const std::vector<Vec2d>& outline : outlines()) {
        const OutlineTree tree(outline, heights_for(outline, random));
        int inside = 0;
        for (const Vec2d& p : points_about(outline, random)) {
            ASSERT_EQ(tree.is_inside(p), is_inside(p, outline)) << p.transpose();
            if (tree.is_inside(p)) ++inside;
        }
        EXPECT_GT(inside, 100);
    }
}

TEST(OutlineTree, finds_the_same_points_close_as_the_distance_to_the_outline) {
    std::mt19937 random(2);
    for (const std::vector<Vec2d>& outline : outlines()) {
        const OutlineTree tree(outline, heights_for(outline, random));
        for (const Vec2d& p : points_about(outline, random)) {
            const double distance = distance_to_outline(p, outline);
            ASSERT_FALSE(tree.is_closer(p, distance)) << p.transpose();
            ASSERT_TRUE(tree.is_closer(p, std::nextafter(distance, 1))) << p.transpose();
        }
    }
}

TEST(OutlineTree, gives_the_same_lowest_height_as_all_points_of_the_outline) {
    std::mt19937 random(3);
    for (const std::vector<Vec2d>& outline : outlines()) {
        const std::vector<double> heights = heights_for(outline, random);
        const OutlineTree tree(outline, heights);
        for (const Vec2d& p : points_about(outline, random)) {
            double lowest = 0.02;
            for (std::size_t i = 0; i < outline.size(); ++i)
                lowest = std::min(lowest, heights[i] + 0.35 * (outline[i] - p).norm());
            ASSERT_EQ(tree.lowest(p, 0.35, 0.02), lowest) << p.transpose();
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
