// Arrangement points around a body.
#include <gtest/gtest.h>
#include <algorithm>
#include <limits>
#include <map>

#include "sim/collide/surface_bvh.h"
#include "sim/dress/dress.h"
#include "sim/mannequin/mannequin.h"
#include "sim/place/arrangement.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

constexpr float kAnyFar = std::numeric_limits<float>::infinity();

struct NamedOptions {
    const char* name;
    MannequinOptions options;
};

const std::vector<NamedOptions>& mannequins() {
    static const std::vector<NamedOptions> all{
        {"female", {.subdivisions = 1}},
        {"male", {.sex = Sex::Male, .subdivisions = 1}},
        {"wide", {.measures = {.height = 1.60, .bust = 1.20, .waist = 1.05, .hip = 1.25}, .subdivisions = 1}},
        {"narrow", {.measures = {.height = 1.85, .bust = 0.82, .waist = 0.62, .hip = 0.88}, .subdivisions = 1}}};
    return all;
}

std::map<std::string, ArrangementPoint> by_name(const Body& body) {
    std::map<std::string, ArrangementPoint> points;
    for (const ArrangementPoint& point : arrangement_points(body)) points[point.name] = point;
    return points;
}

// Whether the triangle belongs to an arm by its skin weights: a wide panel at the chest may intersect an arm.
bool is_of_an_arm(const Body& body, std::uint32_t triangle) {
    const SkinWeights& skin = body.skin[static_cast<std::size_t>(body.triangles[triangle][0])];
    const auto heaviest = std::ranges::max_element(skin.weights) - skin.weights.begin();
    const std::string& bone = body.bones[skin.bones[static_cast<std::size_t>(heaviest)]].name;
    return bone.find("arm") != std::string::npos || bone.find("hand") != std::string::npos;
}

// m, from the trunk to the nearest of a grid of points on the panel.
float clearance_of(const Panel& panel, const Body& body, const SurfaceBvh& surface) {
    Eigen::AlignedBox2d box;
    for (const Vec2d& u : panel.vertices) box.extend(u);
    float least = 10;
    for (int i = 0; i <= 24; ++i) {
        for (int j = 0; j <= 6; ++j) {
            const Vec2d u = box.min() + Vec2d(i / 24.0 * box.sizes().x(), j / 6.0 * box.sizes().y());
            const auto closest = surface.closest(panel.place(u).cast<float>(), kAnyFar);
            if (!is_of_an_arm(body, closest->triangle)) least = std::min(least, closest->distance);
        }
    }
    return least;
}

TEST(ArrangementPoints, of_mannequins_of_all_kinds_stand_clear_of_them_and_near) {
    for (const NamedOptions& one : mannequins()) {
        const Body body = make_mannequin(one.options).body;
        const SurfaceBvh surface(body);
        for (const ArrangementPoint& point : arrangement_points(body)) {
            const float clear = surface.closest(point.position.cast<float>(), kAnyFar)->distance;
            EXPECT_GE(clear, 0.005F) << one.name << ", " << point.name;
            const bool is_between_thighs = point.name == "below hip front" || point.name == "below hip back";
            EXPECT_LE(clear, is_between_thighs ? 0.1F : 0.06F) << one.name << ", " << point.name;
            EXPECT_NEAR(point.outward.norm(), 1, 1e-9) << point.name;
            EXPECT_NEAR(point.outward.dot(point.upward), 0, 1e-9) << point.name;
        }
    }
}

TEST(ArrangementPoints, of_mannequins_cover_torso_arms_and_legs_in_a_fixed_order) {
    for (const NamedOptions& one : mannequins()) {
        const std::vector<ArrangementPoint> points = arrangement_points(make_mannequin(one.options).body);
        std::vector<std::string> torso;
        for (const ArrangementPoint& point : points) {
            if (torso.size() < 20) torso.push_back(point.name);
        }
        std::vector<std::string> expected;
        for (const char* level : {"neck", "chest", "waist", "hip", "below hip"}) {
            for (const char* way : {"front", "back", "left", "right"})
                expected.push_back(std::string(level) + " " + way);
        }
        EXPECT_EQ(torso, expected) << one.name;
        for (const char* limb : {"upper arm", "forearm", "thigh", "calf"}) {
            for (const char* way : {"outside", "front", "back"}) {
                const std::string name = std::string(limb) + " " + way;
                EXPECT_EQ(std::ranges::count(points, "left " + name, &ArrangementPoint::name), 1) << name;
                EXPECT_EQ(std::ranges::count(points, "right " + name, &ArrangementPoint::name), 1) << name;
            }
        }
    }
}

TEST(ArrangementPoints, of_the_left_are_mirror_images_of_the_right) {
    for (const NamedOptions& one : mannequins()) {
        const auto points = by_name(make_mannequin(one.options).body);
        int pairs = 0;
        for (const auto& [name, point] : points) {
            const std::size_t at = name.find("left");
            if (at == std::string::npos) continue;
            std::string other = name;
            other.replace(at, 4, "right");
            ASSERT_TRUE(points.contains(other)) << other;
            const ArrangementPoint& right = points.at(other);
            const Vec3d mirrored(-right.position.x(), right.position.y(), right.position.z());
            EXPECT_LT((point.position - mirrored).norm(), 0.001) << one.name << ", " << name;
            EXPECT_NEAR(point.radius, right.radius, 0.002) << one.name << ", " << name;
            ++pairs;
        }
        EXPECT_GE(pairs, 5 + 12);
    }
}

TEST(ArrangementPoints, of_a_body_without_bones_are_found_by_its_sections) {
    Body body = make_mannequin({.subdivisions = 1}).body;
    const auto with_bones = by_name(body);
    body.bones.clear();
    body.skin.clear();
    const auto points = by_name(body);
    for (const char* name : {"chest front", "waist left", "hip back", "left upper arm outside", "right thigh front"}) {
        ASSERT_TRUE(points.contains(name)) << name;
        EXPECT_LT((points.at(name).position - with_bones.at(name).position).norm(), 0.08) << name;
    }
    const auto column = by_name(shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.7, 0.1), 8));
    EXPECT_TRUE(column.contains("waist front"));
    EXPECT_FALSE(column.contains("left upper arm outside"));
    EXPECT_TRUE(arrangement_points(Body{}).empty());
}

TEST(Arrange, puts_the_middle_of_a_panel_at_the_point_with_its_right_side_outward) {
    const auto points = by_name(make_mannequin({.subdivisions = 1}).body);
    for (const bool is_back : {false, true}) {
        for (const double shift : {0.0, 0.17}) {  // of the origin, from the panel's centre
            Panel panel = rectangle("panel", {.width = 0.4, .height = 0.1, .is_back = is_back});
            for (Vec2d& u : panel.vertices) u.x() += shift;
            for (const auto& [name, point] : points) {
                arrange(panel, point);
                const Vec2d middle(shift, 0.05);
                EXPECT_LT((panel.place(middle) - point.position).norm(), 1e-9) << name;
                const Vec3d along = panel.place(middle + Vec2d(1e-5, 0)) - panel.place(middle - Vec2d(1e-5, 0));
                const Vec3d up = panel.place(middle + Vec2d(0, 1e-5)) - panel.place(middle - Vec2d(0, 1e-5));
                EXPECT_NEAR(along.cross(up).normalized().dot(point.outward), 1, 1e-6) << name;
                EXPECT_NEAR(up.normalized().dot(point.upward), 1, 1e-6) << name;
            }
        }
    }
}

TEST(Arrange, wraps_a_wide_panel_round_the_torso_clear_of_it) {
    for (const NamedOptions& one : mannequins()) {
        const Body body = make_mannequin(one.options).body;
        const SurfaceBvh surface(body);
        const auto points = by_name(body);
        for (const char* level : {"chest", "waist", "hip", "below hip"}) {
            for (const char* way : {"front", "back"}) {
                const std::string name = std::string(level) + " " + way;
                Panel panel = rectangle("panel", {.width = 0.4, .height = 0.1, .is_back = true});
                arrange(panel, points.at(name));
                EXPECT_GT(clearance_of(panel, body, surface), 0.001F) << one.name << ", " << name;
            }
        }
    }
}

TEST(Arrange, a_tube_skirt_put_at_points_is_sewn_without_a_fault) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const auto points = by_name(body);
    Pattern pattern = tube(0.50, 0.45, 0.6, 0.2);
    pattern.body = "mannequin:sex=female,resolution=1";
    for (Panel& panel : pattern.panels) {
        panel.is_mirrored = false;
        panel.vertices = {Vec2d(-0.3, 0), Vec2d(0.3, 0), Vec2d(0.185, 0.45), Vec2d(-0.185, 0.45)};
    }
    arrange(pattern.panels[0], points.at("hip front"));
    arrange(pattern.panels[1], points.at("hip back"));
    DressOptions options;
    options.max_level = 1;
    const DressReport report = dress(pattern, body, options).report;
    for (const DressFault& fault : report.faults) ADD_FAILURE() << fault.kind << ": " << fault.place;
    EXPECT_EQ(report.seams.open, 0);
}

}  // namespace
}  // namespace selvedge::sim::test
