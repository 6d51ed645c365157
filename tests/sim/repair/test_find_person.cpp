// The person among the pieces of a file: what is taken, what is left out and told, and what is refused.
#include "sim/repair/find_person.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>

#include "sim/core/error.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"
#include "tests/support/bodies.h"
#include "tests/support/notes.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

const Body& woman() {
    static const Body body = make_mannequin({.subdivisions = 1}).body;
    return body;
}

double stature() {
    return height_range(woman()).high;
}

Body moved(Body body, const std::function<Vec3d(const Vec3d&)>& move) {
    for (Vec3d& p : body.x) p = move(p);
    return body;
}

Body shifted(const Body& body, const Vec3d& by) {
    return moved(body, [&](const Vec3d& p) { return Vec3d(p + by); });
}

Body z_up(const Body& body, double scale) {
    return moved(body, [&](const Vec3d& p) { return Vec3d(scale * Vec3d(p.x(), -p.z(), p.y())); });
}

// Without the triangles all of whose corners are so.
Body without(const Body& body, const std::function<bool(const Vec3d&)>& is_so) {
    Body rest = body;
    std::erase_if(rest.triangles, [&](const std::array<int, 3>& triangle) {
        return std::ranges::all_of(triangle, [&](int v) { return is_so(body.x[std::size_t(v)]); });
    });
    return rest;
}

Body crownless(double share) {
    return without(woman(), [&](const Vec3d& p) { return p.y() > share * stature(); });
}

class FindPerson : public testing::Test {
 protected:
    Body load(const Body& body, LoadBodyOptions options = {}, bool must_be_person = true) {
        {
            std::ofstream file(folder_ / "body.obj");
            file.precision(9);
            for (const Vec3d& p : body.x) file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
            for (const auto& [a, b, c] : body.triangles) file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        }
        options.must_be_person = must_be_person;
        return load_body(folder_ / "body.obj", options, &report_);
    }
    std::string problem_of(const Body& body) {
        try {
            load(body);
        } catch (const InputError& error) {
            return error.problem();
        }
        return "none";
    }
    // The woman alone, on the floor.
    void expect_woman(const Body& file, const char* reason) {
        const Body body = load(file);
        EXPECT_EQ(body.triangles.size(), woman().triangles.size()) << reason;
        EXPECT_NEAR(height_range(body).low, 0, 1e-5) << reason;
        EXPECT_NEAR(height_range(body).high, stature(), 2e-4) << reason;
        EXPECT_TRUE(shapes::is_closed(body)) << reason;
        EXPECT_TRUE(noted(reason)) << reason;
    }
    bool noted(const std::string& text) const { return has_note(report_.notes, text); }

    TemporaryFolder folder_;
    LoadBodyReport report_;
};

TEST_F(FindPerson, takes_a_person_as_it_is) {
    const Body body = load(woman());
    EXPECT_EQ(body.x.size(), woman().x.size());
    EXPECT_EQ(body.triangles.size(), woman().triangles.size());
    EXPECT_TRUE(report_.notes.empty()) << report_.notes.front();
}

TEST_F(FindPerson, leaves_out_platforms_rooms_helpers_and_scraps_and_says_why) {
    const Body platform = shapes::box({-0.5, -0.06, -0.5}, {0.5, -0.005, 0.5}, 8);
    const Body small_platform = shapes::box({-0.2, -0.06, -0.1}, {0.2, -0.005, 0.15}, 8);
    const Body disc = moved(shapes::sphere({0, 0, 0}, 1, 24),
                            [](const Vec3d& p) { return Vec3d(p.x(), 0.02 * p.y() - 0.03, p.z()); });
    const Body floor = shapes::box({-4, -0.02, -4}, {4, -0.01, 4}, 2);
    const Body room = shapes::box({-3, -0.01, -3}, {3, 2.8, 3}, 4);
    const Body helper = shapes::sphere({0, 0, 0}, 10, 20);
    const Body scrap = shapes::sphere({-0.3, 1.5, 0.13}, 0.01, 4);
    expect_woman(shapes::together(platform, woman()), "it reaches beyond the person");
    expect_woman(shapes::together(small_platform, woman()), "it lies under the person's feet");
    expect_woman(shapes::together(woman(), disc), "it reaches beyond the person");
    expect_woman(shapes::together(floor, woman()), "left out a piece of 48 triangles");
    expect_woman(shapes::together(woman(), room), "it reaches beyond the person");
    expect_woman(shapes::together(helper, woman()), "left out a piece of 4800 triangles");
    expect_woman(shapes::together(woman(), scrap), "it is apart from the person");
    expect_woman(z_up(shapes::together(disc, shapes::together(woman(), scrap)), 1000), "assumed millimetres");
}

TEST_F(FindPerson, takes_a_person_of_several_pieces_with_what_it_wears) {
    constexpr double kHull = 0.001;  // m, to which one surface round all pieces is exact
    const Body upper = shapes::cut(woman(), 0.9001, shapes::Side::Above);
    const Body lower = shapes::cut(woman(), 0.9001, shapes::Side::Below);
    const Body eye = shapes::sphere({0.03, 0.93 * stature(), 0.06}, 0.013, 6);
    const Body hat = shapes::box({-0.1, stature() + 0.001, -0.1}, {0.1, stature() + 0.06, 0.1}, 8);
    const Body person = shapes::together(shapes::together(shifted(upper, {0, 0.001, 0}), lower), eye);
    EXPECT_NEAR(height_range(load(person)).high, stature() + 0.001, kHull);
    EXPECT_TRUE(report_.left_out.empty());
    EXPECT_NEAR(height_range(load(shapes::together(person, shapes::sphere({0, 0, 0}, 10, 20)))).high, stature() + 0.001,
                kHull);
    EXPECT_EQ(report_.left_out.size(), 1U);
    EXPECT_NEAR(height_range(load(shapes::together(woman(), hat))).high, stature() + 0.06, kHull);
    EXPECT_TRUE(report_.left_out.empty());
}

TEST_F(FindPerson, closes_a_crown_that_a_scan_did_not_see_with_the_top_of_a_head) {
    for (const double share : {0.94, 0.95, 0.96}) {
        const Body body = load(crownless(share));
        EXPECT_TRUE(shapes::is_closed(body)) << share;
        EXPECT_NEAR(height_range(body).high, stature(), 0.02) << share;
        EXPECT_TRUE(noted("closed the top of the head")) << share;
        EXPECT_EQ(report_.repair.capped_crowns, 1) << share;
    }
    Body inside_out = crownless(0.95);
    for (auto& triangle : inside_out.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(height_range(load(inside_out)).high, stature(), 0.02);
    const Body platform = shapes::box({-0.5, -0.06, -0.5}, {0.5, -0.005, 0.5}, 8);
    EXPECT_NEAR(height_range(load(z_up(shapes::together(crownless(0.95), platform), 1000))).high, stature(), 0.02);
    const Body half = without(woman(), [](const Vec3d& p) { return p.z() > 0.02; });
    EXPECT_NE(problem_of(half).find("it is open: a hole of"), std::string::npos);
}

// A notch of 4 cm in the side of a post, seen by no scanner: it stays one.
TEST_F(FindPerson, closes_a_hole_in_a_hollow_inward) {
    for (const bool is_turned : {false, true}) {
        Body post = shapes::box({-0.2, 0, -0.15}, {0.2, 0.6, 0.15}, 40);
        for (Vec3d& p : post.x) {
            const double from_notch = Vec2d(p.y() - 0.3, p.z()).norm();
            if (p.x() > 0.199 && from_notch < 0.1) p.x() -= 0.4 * (0.1 - from_notch);
        }
        const double notched = shapes::volume(post);
        Body open = without(post, [](const Vec3d& p) {
            return p.x() < 0.185 && p.x() > 0.1 && Vec2d(p.y() - 0.3, p.z()).norm() < 0.1;
        });
        ASSERT_LT(open.triangles.size(), post.triangles.size());
        if (is_turned)
            for (auto& triangle : open.triangles) std::swap(triangle[0], triangle[1]);
        const Body closed = load(open, {}, false);
        EXPECT_TRUE(shapes::is_closed(closed));
        EXPECT_NEAR(shapes::volume(closed), notched, 7e-5) << "flat, 1e-4 more";
        EXPECT_LT(closed.x.back().x(), 0.178) << "0.185 at the rim, 0.16 at the bottom";
    }
}

TEST_F(FindPerson, measures_a_ragged_hole_as_a_tape_does) {
    // Every other triangle of the rim is missing too: the rim is long, and the hole is not.
    std::size_t count = 0;
    Body ragged = woman();
    std::erase_if(ragged.triangles, [&](const std::array<int, 3>& triangle) {
        const double y = ragged.x[std::size_t(triangle[0])].y();
        return y < 0.004 || (y < 0.02 && ++count % 3 == 0);
    });
    EXPECT_TRUE(shapes::is_closed(load(ragged)));
}

TEST_F(FindPerson, turns_a_person_to_the_front_and_upright_or_says_that_it_lies) {
    const auto is_woman = [&](const Body& body) {
        double farthest = 0;
        for (std::size_t v = 0; v < body.x.size(); ++v) {
            double nearest = 1;
            for (const Vec3d& p : woman().x) nearest = std::min(nearest, (p - body.x[v]).squaredNorm());
            farthest = std::max(farthest, nearest);
            v += 40;
        }
        return std::sqrt(farthest) < 1e-4;
    };
    EXPECT_TRUE(is_woman(load(moved(woman(), [](const Vec3d& p) { return Vec3d(-p.x(), p.y(), -p.z()); }))));
    EXPECT_TRUE(noted("turned by 180 degrees to face the front"));
    EXPECT_TRUE(is_woman(load(moved(woman(), [](const Vec3d& p) { return Vec3d(p.z(), p.y(), -p.x()); }))));
    EXPECT_TRUE(noted("turned by 90 degrees"));
    // On its back, its head towards +z.
    EXPECT_TRUE(is_woman(load(moved(woman(), [](const Vec3d& p) { return Vec3d(-p.x(), p.z(), p.y()); }))));
    EXPECT_TRUE(noted("z up to y up"));
    for (const auto& lies : {moved(woman(), [](const Vec3d& p) { return Vec3d(p.y(), -p.x(), p.z()); }),
                             moved(woman(), [](const Vec3d& p) { return Vec3d(-p.x(), -p.y(), p.z()); })})
        EXPECT_NE(problem_of(lies).find("lies on a side or stands on its head"), std::string::npos);
}

TEST_F(FindPerson, guesses_the_unit_by_the_stature_of_a_person) {
    const std::map<double, std::string> units{{100, "centimetres"}, {1000, "millimetres"},
                                              {10, "decimetres"},   {1 / 0.0254, "inches"},
                                              {1 / 0.3048, "feet"}, {1 / 2.62128, "Poser's units of 8.6 feet"}};
    for (const auto& [scale, name] : units) {
        const double per_metre = scale;
        const Body body = load(moved(woman(), [&](const Vec3d& p) { return Vec3d(per_metre * p); }));
        EXPECT_NEAR(height_range(body).high, stature(), 1e-4) << name;
        EXPECT_TRUE(noted("assumed " + name + ": 1.61 m tall")) << name;
    }
    load(woman(), {.unit = LengthUnit::Feet});
    EXPECT_TRUE(noted("read as feet: 0.49 m tall"));
    EXPECT_THROW(load(woman(), {.unit = LengthUnit::Inches}), InputError) << "no person is 4 cm tall";
    EXPECT_THROW(load(moved(woman(), [](const Vec3d& p) { return Vec3d(2 * p); }), {.unit = LengthUnit::Metres}),
                 InputError);
}

TEST_F(FindPerson, refuses_what_is_no_person_and_says_what_it_lacks) {
    Body chair = shapes::box({-0.2, 0.45, -0.2}, {0.2, 0.49, 0.2}, 4);
    for (const double x : {-0.2, 0.16})
        for (const double z : {-0.2, 0.16})
            chair = shapes::together(chair, shapes::box({x, 0, z}, {x + 0.04, 0.44, z + 0.04}, 4));
    chair = shapes::together(chair, shapes::box({-0.2, 0.5, -0.2}, {0.2, 0.9, -0.16}, 4));
    const Body leg = shapes::cut(moved(woman(), [](const Vec3d& p) { return p; }), 0.7001, shapes::Side::Below);
    for (const Body& thing :
         {chair, leg, shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 6), shapes::sphere({0, 0.9, 0}, 0.9, 12)})
        EXPECT_TRUE(problem_of(thing).starts_with("it is no person: ")) << problem_of(thing);
    EXPECT_EQ(problem_of(shapes::together(shifted(woman(), {-0.6, 0, 0}), shifted(woman(), {0.6, 0, 0}))),
              "it holds 2 persons: leave one of them in the file");
}

// A strip that goes up and down between floor and crown, of as many triangles as the woman has.
TEST_F(FindPerson, ends_the_search_among_more_long_triangles_than_a_body_has) {
    Surface strip;
    for (int i = 0; i < int(woman().triangles.size()) + 2; ++i) {
        strip.x.emplace_back(1e-4 * i, i % 2 == 0 ? 0 : stature(), 0.1 * std::sin(0.01 * i));
        if (i > 1) strip.triangles.push_back({i - 2, i % 2 == 0 ? i - 1 : i, i % 2 == 0 ? i : i - 1});
    }
    const auto problem_within = [](const Surface& surface, double most_cuts) {
        try {
            find_person(surface, {}, {.file = "body.obj", .most_cuts = most_cuts});
        } catch (const InputError& error) {
            return error.problem();
        }
        return std::string("none");
    };
    const double cuts = cuts_of_likeness(woman());
    EXPECT_LT(cuts, 1e5);
    EXPECT_EQ(problem_within({.x = woman().x, .triangles = woman().triangles, .origin = {}}, 10 * cuts), "none");
    EXPECT_EQ(problem_within(strip, 10 * cuts),
              "its triangles are too long and too many to look for a person among them");
    EXPECT_EQ(problem_within(strip, 1e9), "none") << "what is no person is not refused here";
}

TEST_F(FindPerson, counts_the_planes_that_cut_triangles) {
    EXPECT_EQ(cuts_of_likeness({}), 0);
    const Body box = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 1);
    EXPECT_NEAR(cuts_of_likeness(box), 260 * 8, 1) << "of its twelve triangles eight reach from the floor to the top";
}

TEST_F(FindPerson, takes_a_dress_form_without_head_or_legs) {
    const Body headless = shapes::cut(woman(), 0.8601 * stature(), shapes::Side::Below);
    EXPECT_EQ(load(headless).triangles.size(), headless.triangles.size());
    const Body form = shapes::cut(headless, 0.4501 * stature(), shapes::Side::Above);
    EXPECT_EQ(load(form).triangles.size(), form.triangles.size());
}

// A scanner's file in millimetres with z up: a person whose crown, armpits and soles were not seen, a platform, scraps.
TEST_F(FindPerson, finds_the_person_on_a_scanners_platform) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const Body body = load_body(std::filesystem::path(data) / "cases/body-scan-with-platform/b_scan_platform.obj",
                                {.must_be_person = true}, &report_);
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(report_.repair.pieces, 1);
    EXPECT_TRUE(noted("left out a piece of 12 triangles: it reaches beyond the person"));
    EXPECT_TRUE(noted("left out 6 pieces of 288 triangles together: they are apart from the person"));
    EXPECT_EQ(report_.repair.capped_crowns, 1);
    EXPECT_NEAR(height_range(body).high, 1.605, 0.02);
    EXPECT_NEAR(body.lift, -0.008, 0.001) << "the soles are flat";
}

}  // namespace
}  // namespace selvedge::sim
