#include "sim/body/person_likeness.h"

#include <gtest/gtest.h>

#include "sim/mannequin/mannequin.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

TEST(PersonLikeness, of_a_mannequin_is_a_whole_person_that_faces_the_front_in_any_unit) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        for (const double scale : {1.0, 1000.0, 0.4}) {
            Body body = make_mannequin({.sex = sex, .subdivisions = 1}).body;
            for (Vec3d& p : body.x) p *= scale;
            const PersonLikeness found = person_likeness(body);
            EXPECT_TRUE(found.is_whole()) << found.lacks;
            ASSERT_TRUE(found.faces.has_value());
            EXPECT_GT(found.faces->y(), 0.02 * found.stature.height());
            EXPECT_LT(std::abs(found.faces->x()), 0.2 * found.faces->y());
        }
    }
}

TEST(PersonLikeness, of_a_part_is_that_of_a_person_but_not_of_a_whole_one) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const double height = height_range(body).high;
    const Body form =
        shapes::cut(shapes::cut(body, 0.8601 * height, shapes::Side::Below), 0.4501 * height, shapes::Side::Above);
    EXPECT_TRUE(person_likeness(form).is_person()) << person_likeness(form).lacks;
    EXPECT_FALSE(person_likeness(form).is_whole());
    EXPECT_EQ(person_likeness(shapes::cut(body, 0.4501 * height, shapes::Side::Below)).lacks,
              "no neck and no two legs were found on it");
}

TEST(PersonLikeness, of_things_says_what_they_lack) {
    EXPECT_EQ(person_likeness({}).lacks, "it has no surface");
    EXPECT_FALSE(person_likeness(shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 4)).is_person());
    EXPECT_FALSE(person_likeness(shapes::sphere({0, 1, 0}, 1, 8)).is_person());
    // A figure of boxes on two legs is one; on four legs it is not.
    Body figure = shapes::together(shapes::box({-0.2, 0.8, -0.1}, {0.2, 1.4, 0.1}, 4),
                                   shapes::box({-0.09, 1.41, -0.1}, {0.09, 1.7, 0.1}, 4));
    for (const double x : {-0.18, 0.04})
        figure = shapes::together(figure, shapes::box({x, 0, -0.05}, {x + 0.14, 0.79, 0.05}, 4));
    EXPECT_TRUE(person_likeness(figure).is_person()) << person_likeness(figure).lacks;
    Body centaur = shapes::box({-0.2, 0.8, -0.3}, {0.2, 1.4, 0.3}, 4);
    centaur = shapes::together(centaur, shapes::box({-0.09, 1.41, -0.1}, {0.09, 1.7, 0.1}, 4));
    for (const double x : {-0.18, 0.04})
        for (const double z : {-0.25, 0.15})
            centaur = shapes::together(centaur, shapes::box({x, 0, z}, {x + 0.14, 0.79, z + 0.1}, 4));
    EXPECT_EQ(person_likeness(centaur).lacks, "it stands on more than two legs");
}

}  // namespace
}  // namespace selvedge::sim
