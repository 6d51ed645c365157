#include <gtest/gtest.h>
#include <array>
#include <cmath>

#include "render/scene/camera.h"

namespace selvedge::render {
namespace {

constexpr std::array<View, 7> kAllViews{
    View::Front, View::Back, View::Left, View::Right, View::ThreeQuarter, View::ThreeQuarterBack, View::Top};

std::vector<Vec3f> figure() {
    std::vector<Vec3f> points;
    for (const float y : {0.0F, 0.9F, 1.7F}) {
        for (int i = 0; i < 12; ++i) {
            const float angle = float(i) * 0.5236F;
            points.emplace_back(0.45F * std::cos(angle), y, 0.2F * std::sin(angle));
        }
    }
    return points;
}

Vec3f on_picture(const Camera& camera, float aspect, const Vec3f& point) {
    const Eigen::Vector4f clip = projection_matrix(camera, aspect) * view_matrix(camera) * point.homogeneous();
    return clip.head<3>() / clip.w();
}

TEST(Camera, every_view_holds_every_point_within_the_margin_and_touches_it) {
    for (const View view : kAllViews) {
        for (const float aspect : {0.5F, 1.0F, 2.0F}) {
            const Camera camera = frame_points(figure(), view, {.aspect = aspect, .margin = 0.1F});
            float widest = 0;
            for (const Vec3f& point : figure()) {
                const Vec3f at = on_picture(camera, aspect, point);
                widest = std::max({widest, std::abs(at.x()), std::abs(at.y())});
                EXPECT_LT(std::abs(at.z()), 1) << "cut off by the near or far plane";
            }
            EXPECT_NEAR(widest, 0.9F, 1e-3F) << int(view) << " " << aspect;
        }
    }
}

TEST(Camera, the_figure_stands_in_the_middle_of_the_direction_that_binds) {
    const Camera camera = frame_points(figure(), View::Front, {.aspect = 1});
    float high = -1, low = 1;
    for (const Vec3f& point : figure()) {
        const float y = on_picture(camera, 1, point).y();
        high = std::max(high, y);
        low = std::min(low, y);
    }
    EXPECT_NEAR(high, -low, 1e-3F);
}

TEST(Camera, the_bodys_left_is_on_the_right_of_a_picture_from_the_front) {
    const Vec3f left_hand(0.45F, 0.9F, 0);
    EXPECT_GT(on_picture(frame_points(figure(), View::Front, {}), 1, left_hand).x(), 0);
    EXPECT_LT(on_picture(frame_points(figure(), View::Back, {}), 1, left_hand).x(), 0);
}

TEST(Camera, the_left_view_stands_on_the_bodys_left_and_the_three_quarter_view_in_front_of_it) {
    EXPECT_GT(frame_points(figure(), View::Left, {}).eye.x(), 1);
    EXPECT_LT(frame_points(figure(), View::Right, {}).eye.x(), -1);
    const Vec3f eye = frame_points(figure(), View::ThreeQuarter, {}).eye;
    EXPECT_GT(eye.x(), 1);
    EXPECT_GT(eye.z(), 1);
}

TEST(Camera, a_single_point_and_a_flat_sheet_can_be_framed) {
    const Camera near_point = frame_points({Vec3f(1, 2, 3)}, View::Front, {});
    EXPECT_TRUE(near_point.eye.allFinite());
    EXPECT_GT((near_point.eye - Vec3f(1, 2, 3)).norm(), near_point.near_plane);
    const Camera edge_on = frame_points({Vec3f(0, 0, -1), Vec3f(0, 0, 1), Vec3f(0, 1, 0)}, View::Front, {});
    EXPECT_GT(edge_on.eye.z(), 1);
}

TEST(Camera, room_that_is_kept_free_stays_free_and_the_figure_fills_the_rest) {
    const FrameOptions beside{.aspect = 1, .margin = 0.1F, .free_left = 0.3F},
        below{.aspect = 0.6F, .free_below = 0.2F};
    float left = 1, right = -1, low = 1, high = -1;
    for (const Vec3f& point : figure()) {
        left = std::min(left, on_picture(frame_points(figure(), View::Front, beside), 1, point).x());
        right = std::max(right, on_picture(frame_points(figure(), View::Front, beside), 1, point).x());
        low = std::min(low, on_picture(frame_points(figure(), View::Front, below), 0.6F, point).y());
        high = std::max(high, on_picture(frame_points(figure(), View::Front, below), 0.6F, point).y());
    }
    EXPECT_GE(left, -0.9F + 0.6F - 1e-3F);
    EXPECT_LE(right, 0.9F + 1e-3F);
    EXPECT_GE(low, -0.93F + 0.4F - 1e-3F);
    EXPECT_NEAR(high - low, 1.86F - 0.4F, 1e-2F);
}

TEST(Camera, zoomed_shows_everything_so_many_times_as_large) {
    const Camera camera = frame_points(figure(), View::ThreeQuarter, {});
    for (const float times : {0.5F, 2.0F, 7.0F}) {
        const Vec3f at = on_picture(camera, 1, figure()[3]), larger = on_picture(zoomed(camera, times), 1, figure()[3]);
        EXPECT_NEAR(larger.x(), times * at.x(), 1e-3F);
        EXPECT_NEAR(larger.y(), times * at.y(), 1e-3F);
    }
}

TEST(Camera, turned_sees_the_scene_as_if_it_had_turned) {
    const Camera camera = frame_points(figure(), View::ThreeQuarter, {});
    const Vec3f axis(0.2F, 0, -0.1F);
    const float angle = 0.7F;
    for (const Vec3f& point : figure()) {
        const Vec3f turned_point = axis + Eigen::AngleAxisf(angle, Vec3f::UnitY()) * Vec3f(point - axis);
        const Vec3f expected = on_picture(camera, 1, turned_point);
        EXPECT_LT((on_picture(turned(camera, angle, axis), 1, point) - expected).norm(), 1e-3F);
    }
}

TEST(Camera, views_are_parsed_by_name) {
    EXPECT_EQ(parse_view("three-quarter"), View::ThreeQuarter);
    EXPECT_EQ(parse_view("back"), View::Back);
    EXPECT_FALSE(parse_view("below"));
}

// A tube from y = 0.5 to y = 1.4 with a radius of 0.25.
std::vector<Vec3f> tube() {
    std::vector<Vec3f> points;
    for (int j = 0; j <= 30; ++j) {
        for (int i = 0; i < 36; ++i) {
            const float angle = 0.17453293F * float(i);
            points.emplace_back(0.25F * std::sin(angle), 0.5F + 0.03F * float(j), 0.25F * std::cos(angle));
        }
    }
    return points;
}

TEST(Views, close_holds_the_upper_edge_and_hem_the_lower_one_at_the_front) {
    for (const View view : {View::Close, View::Hem}) {
        const std::vector<Vec3f> patch = detail_patch(tube(), view);
        float low = 1e9F, high = -1e9F;
        for (const Vec3f& x : patch) {
            EXPECT_NEAR(x.z(), 0.25F, 1e-4F);
            low = std::min(low, x.y());
            high = std::max(high, x.y());
        }
        EXPECT_NEAR(high - low, kDetailSize, 1e-4F);
        const float edge = view == View::Close ? 1.4F : 0.5F;
        EXPECT_LT(low, edge);
        EXPECT_GT(high, edge);
    }
}

TEST(Views, a_garment_smaller_than_the_patch_is_still_framed) {
    const std::vector<Vec3f> patch = detail_patch({Vec3f(1, 1, 1)}, View::Close);
    ASSERT_EQ(patch.size(), 4U);
    for (const Vec3f& x : patch) EXPECT_TRUE(x.allFinite());
}

TEST(Views, only_close_and_hem_are_details) {
    EXPECT_TRUE(is_detail(View::Close) && is_detail(View::Hem));
    EXPECT_FALSE(is_detail(View::Front) || is_detail(View::Top));
}

}  // namespace

}  // namespace selvedge::render
