#include "sim/dress/anchor.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "sim/body/landmarks.h"
#include "sim/dress/dressing.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim::test {
namespace {

constexpr double kChest = 1.12;  // m, of the file's origin over the floor

AnchoredPattern anchor(const Pattern& pattern, const Body& onto) {
    return PatternAnchor().anchor(pattern, MeasuredBody(onto));
}

class PatternForAFile : public testing::Test {
 protected:
    // A post whose origin is at its chest, with panels placed about it in the file's frame.
    PatternForAFile() {
        write_post(file_, kChest);
        pattern_ = tube(0.5, 0.4, -0.2, 0.2);
        pattern_.body = canonical_name(file_);
    }
    // origin: m, over its lower end
    static void write_post(const std::filesystem::path& file, double origin) {
        const Body post = shapes::box({-0.15, 0, -0.1}, {0.15, 1.6, 0.1}, 6);
        std::ostringstream text;
        for (const Vec3d& p : post.x) text << "v " << p.x() << ' ' << p.y() - origin << ' ' << p.z() << '\n';
        for (const auto& [a, b, c] : post.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        std::ofstream(file) << text.str();
    }
    AnchoredPattern anchored(const Body& onto) const { return anchor(pattern_, onto); }
    void expect_raised(const AnchoredPattern& anchored, double lift) const {
        for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
            const Vec3d moved = anchored.pattern.panels[p].translation - pattern_.panels[p].translation;
            EXPECT_LT((moved - Vec3d(0, lift, 0)).norm(), 1e-5) << p;
        }
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "post.obj";
    Pattern pattern_;
};

TEST_F(PatternForAFile, moves_up_to_the_floor_with_its_body) {
    const Body body = load_body(file_);
    EXPECT_NEAR(body.lift, kChest, 1e-6);
    const AnchoredPattern moved = anchored(body);
    expect_raised(moved, kChest);
    ASSERT_EQ(moved.notes.size(), 1U);
    EXPECT_NE(moved.notes[0].find("up 1120 mm"), std::string::npos) << moved.notes[0];
}

TEST_F(PatternForAFile, is_anchored_from_the_named_body_to_another) {
    expect_raised(anchored(shapes::box({-0.15, 0, -0.1}, {0.15, 1.6, 0.1}, 5)), kChest);
    // On a body 1.25 times as tall, what hangs from the shoulders goes up as these do.
    expect_raised(anchored(shapes::box({-0.15, 0, -0.1}, {0.15, 2.0, 0.1}, 5)), kChest + 0.8 * 0.4);
}

TEST_F(PatternForAFile, can_be_set_while_another_body_is_worn) {
    Dressing dressing;
    dressing.set_body(std::make_shared<const Body>(shapes::box({-0.15, 0, -0.1}, {0.15, 1.6, 0.1}, 5)));
    dressing.set_pattern(pattern_);
    for (const Vec3d& x : dressing.placed().x) EXPECT_GT(x.y(), 0.5);
}

TEST_F(PatternForAFile, is_dressed_on_another_body_without_its_file_and_says_so) {
    std::filesystem::remove(file_);
    const AnchoredPattern moved = anchored(make_mannequin({.subdivisions = 1}).body);
    ASSERT_FALSE(moved.notes.empty());
    EXPECT_NE(moved.notes[0].find("post.obj"), std::string::npos) << moved.notes[0];
    for (const Panel& panel : moved.pattern.panels) EXPECT_GT(panel.translation.y(), 0.6);
}

// The frame of a body file may have its origin at the chest, but says so itself.
TEST_F(PatternForAFile, takes_a_garment_over_it_in_the_frame_of_the_file) {
    ASSERT_TRUE(is_placed_below_floor(pattern_));
    Pattern outer = tube(0.6, 0.4, 0.92, 0.25);  // as high over the floor as the other in its frame
    outer.body = canonical_name(folder_ / "standing.obj");
    write_post(folder_ / "standing.obj", 0);
    std::vector<std::string> notes;
    const Pattern moved = moved_to_body_of(pattern_, outer, notes);
    for (std::size_t p = 0; p < moved.panels.size(); ++p)
        EXPECT_NEAR(moved.panels[p].translation.y(), pattern_.panels[p].translation.y(), 1e-5);
    Pattern low = tube(0.6, 0.4, -0.2, 0.25);
    low.body = pattern_.body;
    EXPECT_EQ(moved_to_body_of(pattern_, low, notes), low);
}

TEST(PlacedBelowFloor, are_panels_for_a_body_with_its_origin_at_the_chest) {
    EXPECT_TRUE(is_placed_below_floor(tube(0.5, 0.6, -0.1, 0.2)));
    EXPECT_FALSE(is_placed_below_floor(tube(0.5, 0.4, 0.9, 0.2)));
    EXPECT_FALSE(is_placed_below_floor(tube(0.5, 1.4, -0.15, 0.2))) << "a train on the floor";
    EXPECT_FALSE(is_placed_below_floor({}));
}

TEST(PlacedBelowFloor, move_up_as_a_whole_and_say_so) {
    const Pattern low = tube(0.5, 0.6, -0.1, 0.2);
    Pattern high = low;
    raise_panels(high, kChest);
    const Body worn = make_mannequin({.subdivisions = 1}).body;
    const AnchoredPattern moved = anchor(low, worn);
    EXPECT_EQ(moved.pattern, anchor(high, worn).pattern);
    ASSERT_EQ(moved.notes.size(), 1U);
    EXPECT_NE(moved.notes[0].find("below the floor"), std::string::npos) << moved.notes[0];
}

TEST(PlacedBelowFloor, move_up_with_a_body_that_was_lifted_to_the_floor) {
    const Pattern low = tube(0.5, 0.6, -0.1, 0.2);
    Body worn = shapes::box({-0.15, 0, -0.1}, {0.15, 1.6, 0.1}, 5);
    worn.lift = 1.05;
    Pattern high = low;
    raise_panels(high, 1.05);
    EXPECT_EQ(anchor(low, worn).pattern, high);
}

TEST(Anchor, says_what_it_assumes_of_a_body_without_a_head) {
    const Body whole = make_mannequin({.subdivisions = 1}).body;
    const Body headless = shapes::cut(whole, 1.4001, shapes::Side::Below);
    const AnchoredPattern moved = anchor(tube(0.5, 0.4, 0.9, 0.2), headless);
    ASSERT_EQ(moved.notes.size(), 1U);
    EXPECT_NE(moved.notes[0].find("no head: panels placed as on a whole one 1.6"), std::string::npos) << moved.notes[0];
}

// A bodice whose upper edges are labelled as GarmentCode's are.
Pattern strapless(double top) {
    Pattern pattern = tube(0.5, 0.2, top - 0.2, 0.2);
    for (Panel& panel : pattern.panels) panel.edges[2].label = "strapless_top";
    return pattern;
}

TEST(Anchor, raises_a_strapless_bodice_to_the_armpits_and_says_so_when_it_names_no_body) {
    const Pattern pattern = strapless(1.1);
    const AnchoredPattern raised = anchor(pattern, placed_for(pattern));
    const double armpit = find_landmarks(placed_for(pattern)).armpit.value();
    ASSERT_GT(armpit, 1.15);
    for (const Panel& panel : raised.designed.panels) EXPECT_NEAR(panel.place(Vec2d(0, 0.2)).y(), armpit, 1e-6);
    for (const Panel& panel : raised.pattern.panels) EXPECT_NEAR(panel.place(Vec2d(0, 0.2)).y(), armpit, 1e-6);
    ASSERT_EQ(raised.notes.size(), 1U);
    EXPECT_NE(raised.notes[0].find("panels without straps raised by up to"), std::string::npos) << raised.notes[0];
}

TEST(Anchor, leaves_a_strapless_bodice_where_it_is_when_it_is_high_enough_or_hangs_from_a_shoulder) {
    const Pattern high = strapless(1.4);
    Pattern on_shoulder = strapless(1.1);
    on_shoulder.panels[1].edges[2].label = "right_collar";
    Pattern with_body = strapless(1.1);
    with_body.body = "mannequin:sex=female";
    for (const Pattern& pattern : {high, on_shoulder, with_body}) {
        const AnchoredPattern left = anchor(pattern, placed_for(pattern));
        EXPECT_TRUE(left.notes.empty());
        for (std::size_t p = 0; p < 2; ++p)
            EXPECT_EQ(left.pattern.panels[p].translation, pattern.panels[p].translation);
    }
}

TEST(Dressing, is_designed_for_its_body_after_an_equal_one_has_replaced_it) {
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    pattern.body = "mannequin:resolution=1";
    const auto body = std::make_shared<const Body>(make_mannequin(parse_mannequin(pattern.body)).body);
    Dressing dressing;
    dressing.set_body(body);
    dressing.set_pattern(pattern);
    ASSERT_EQ(&dressing.designed_for(), &dressing.measured());
    dressing.set_body(std::make_shared<const Body>(*body));
    EXPECT_EQ(&dressing.designed_for(), &dressing.measured());
}

TEST(Dressing, sews_on_after_an_equal_body_has_replaced_its_own) {
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    pattern.body = "mannequin:resolution=1";
    const auto body = std::make_shared<const Body>(make_mannequin(parse_mannequin(pattern.body)).body);
    std::shared_ptr<const PreparedBody> first = PreparedBody::in_given_pose(body);
    const std::weak_ptr<const PreparedBody> watched = first;
    Dressing dressing;
    dressing.set_body(std::move(first));
    dressing.set_pattern(pattern);
    for (int i = 0; i < 2; ++i) dressing.advance();
    ASSERT_EQ(dressing.stage(), DressingStage::Sew);
    dressing.set_body(PreparedBody::in_given_pose(std::make_shared<const Body>(*body)));
    EXPECT_FALSE(watched.expired()) << "its limbs are looked at when the seams have closed";
    while (dressing.stage() == DressingStage::Sew) dressing.advance();
    EXPECT_TRUE(dressing.is_hanging());
    EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace selvedge::sim::test
