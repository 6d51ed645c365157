#include "sim/body/landmarks.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

Body mannequin(Sex sex = Sex::Female) {
    return make_mannequin({.sex = sex, .subdivisions = 1}).body;
}

TEST(Landmarks, of_a_mannequin_are_found_from_crotch_to_neck) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Body body = mannequin(sex);
        const double stature = height_range(body).high;
        const LandmarkHeights found = find_landmarks(body);
        ASSERT_TRUE(found.crotch && found.waist && found.armpit && found.neck);
        EXPECT_NEAR(*found.crotch, 0.475 * stature, 0.015 * stature);
        EXPECT_NEAR(*found.waist, 0.645 * stature, 0.02 * stature);
        EXPECT_NEAR(*found.armpit, 0.757 * stature, 0.01 * stature);
        EXPECT_NEAR(*found.neck, 0.85 * stature, 0.015 * stature);
    }
}

TEST(Landmarks, of_a_box_are_none) {
    const LandmarkHeights found = find_landmarks(shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 4));
    EXPECT_FALSE(found.crotch || found.waist || found.armpit || found.neck);
    EXPECT_FALSE(find_landmarks({}).neck);
}

TEST(Stature, of_a_whole_body_is_its_own_height) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Body body = mannequin(sex);
        const Stature stature = find_stature(body);
        EXPECT_EQ(stature.floor, height_range(body).low);
        EXPECT_EQ(stature.crown, height_range(body).high);
        EXPECT_TRUE(stature.has_head && stature.has_legs);
    }
}

TEST(Stature, of_a_body_without_head_or_legs_is_that_of_the_whole_body) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Body body = mannequin(sex);
        const double whole = height_range(body).high;
        const Body headless = shapes::cut(body, 0.8701 * whole, shapes::Side::Below);
        ASSERT_TRUE(shapes::is_closed(headless));
        EXPECT_FALSE(find_stature(headless).has_head);
        EXPECT_TRUE(find_stature(headless).has_legs);
        EXPECT_NEAR(find_stature(headless).crown, whole, 0.03 * whole);
        for (const double share : {0.3001, 0.4201, 0.5201}) {
            for (const Body& from : {body, headless}) {
                const Body part = shapes::cut(from, share * whole, shapes::Side::Above);
                const Stature stature = find_stature(part);
                EXPECT_FALSE(stature.has_legs) << share;
                EXPECT_NEAR(stature.floor, 0, 0.06 * whole) << share;
                EXPECT_NEAR(stature.crown, whole, 0.03 * whole) << share;
            }
        }
    }
}

// As figures of cartoons have: nothing shows their necks.
TEST(Stature, of_a_figure_whose_head_is_as_wide_as_its_trunk_is_its_own_height) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        Body body = mannequin(sex);
        const double whole = height_range(body).high;
        for (Vec3d& p : body.x) {
            const double wider = 1 + 1.4 * smoothstep(p.y(), 0.83 * whole, 0.88 * whole);
            p.x() *= wider;
            p.z() *= wider;
        }
        const Stature stature = find_stature(body);
        EXPECT_TRUE(stature.has_head && stature.has_legs);
        EXPECT_EQ(stature.floor, height_range(body).low);
        EXPECT_EQ(stature.crown, whole);
    }
}

TEST(Stature, of_a_body_from_elsewhere_is_that_of_the_whole_body) {
    const char* folder = std::getenv("SELVEDGE_TEST_DATA");
    if (!folder) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const std::filesystem::path bodies = std::filesystem::path(folder) / "bodies";
    const Body woman = load_body(bodies / "mh_female.obj");
    const double whole = height_range(woman).high;
    EXPECT_EQ(find_stature(woman).crown, whole);
    const Stature headless = find_stature(shapes::cut(woman, 0.8701 * whole, shapes::Side::Below));
    EXPECT_FALSE(headless.has_head);
    EXPECT_NEAR(headless.crown, whole, 0.03 * whole);
    // His head is as wide as his trunk.
    EXPECT_TRUE(find_stature(load_body(bodies / "CesiumMan.glb")).has_head);
}

}  // namespace
}  // namespace selvedge::sim
