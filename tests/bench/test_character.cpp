// The dress on the walking character of the thesis' chapters 5 and 6, at small size.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bench/thesis/character_painter.h"
#include "bench/thesis/character_run.h"
#include "bench/thesis/character_tables.h"
#include "bench/thesis/thesis.h"
#include "sim/cloth/cloth_penetration.h"
#include "sim/cloth/solver_state.h"
#include "sim/motion/motion_file.h"
#include "tests/bench/support.h"
#include "tests/support/checkout.h"
#include "tests/support/mannequin.h"

namespace selvedge::bench {
namespace {

ThesisOptions quick() {
    return {.is_quick = true, .dress = source_folder() + "/patterns/dress.json"};
}

const DressedCharacter& character() {
    static const DressedCharacter dressed = make_dressed_character(quick());
    return dressed;
}

double angle_between(const sim::Pose& a, const sim::Pose& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.bones.size(); ++i)
        most = std::max(most, a.bones[i].rotation.angularDistance(b.bones[i].rotation));
    return most;
}

TEST(Character, is_blended_from_the_animation_frames_round_each_cloth_step_in_proportion) {
    const sim::Body& body = sim::test::mannequin();
    const sim::Clip walk = sim::find_motion("walk", body);
    const BlendedMotion motion(body, walk, kWalkStart + 1);
    const double frame = kWalkStart + 4 * kAnimationFrame;
    const sim::Pose first = sample(body, walk, 4 * kAnimationFrame), next = sample(body, walk, 5 * kAnimationFrame);
    EXPECT_LT(angle_between(motion.pose(frame), first), 1e-6);
    ASSERT_GT(angle_between(first, next), 0.01);
    for (const double share : {0.25, 0.8}) {
        const BlendedMotion::Moment moment = motion.at(frame + share * kAnimationFrame);
        EXPECT_EQ(moment.frame, 54U) << "2 s and 4 frames at 25 per second";
        EXPECT_NEAR(moment.share, share, 1e-9);
        EXPECT_LT(angle_between(motion.pose(frame + share * kAnimationFrame), blend(first, next, share)), 1e-6);
    }
    EXPECT_LT(angle_between(motion.pose(0), rest_pose(body)), 1e-9) << "it stands at first";
    EXPECT_LT(angle_between(motion.pose(1000), motion.pose(2000)), 1e-9) << "and stays where its frames end";
}

TEST(Character, wears_a_dress_of_488_base_triangles_fixed_at_both_shoulders) {
    EXPECT_EQ(character().base.triangles.size(), 488U);
    int left = 0, right = 0;
    float low = 10, high = 0;
    for (const int v : character().base.pins) {
        const Vec4f& x = character().cloth.x[static_cast<std::size_t>(v)];
        (x.x() > 0 ? left : right) += 1;
        low = std::min(low, x.y());
        high = std::max(high, x.y());
    }
    EXPECT_GE(left, 4);
    EXPECT_GE(right, 4);
    EXPECT_LT(left + right, 40);
    EXPECT_LT(high - low, 0.2F) << "none at the waist";
}

TEST(Character, takes_the_fixed_vertices_along_and_keeps_them_at_their_distance) {
    CharacterRun run(character(), {.level = 1});
    const auto distance = [&](std::uint32_t v) {
        return run.collider().surface().closest(run.cloth().x[v].head<3>(), 1)->distance;
    };
    std::vector<float> before;
    for (const int v : character().base.pins) before.push_back(distance(static_cast<std::uint32_t>(v)));
    const Vec4f at = run.cloth().x[static_cast<std::size_t>(character().base.pins[0])];
    CharacterTimes times;
    while (run.seconds() < kWalkStart + 0.5) run.frame(times);
    EXPECT_GT((run.cloth().x[static_cast<std::size_t>(character().base.pins[0])] - at).norm(), 0.1F) << "it walks";
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NEAR(distance(static_cast<std::uint32_t>(character().base.pins[i])), before[i], 0.002F);
    for (double CharacterTimes::*part : {&CharacterTimes::skinning, &CharacterTimes::structures,
                                         &CharacterTimes::simulation, &CharacterTimes::collision})
        EXPECT_GT(times.*part, 0);
    EXPECT_EQ(times.adaptation, 0) << "a uniform mesh does not adapt";
    EXPECT_EQ(find_bad_vertex(run.cloth()), std::nullopt);
}

TEST(Character, whose_dress_touches_at_vertices_has_no_contact_points_between_them_and_no_standoffs) {
    const auto most = [](bool at_vertices) {
        CharacterRun run(character(), {.level = 0, .touches_at_vertices = at_vertices});
        CharacterTimes times;
        run.frame(times);
        const sim::ContactState& contacts = run.cloth().solver->contacts;
        return std::pair(sample_count(contacts), *std::ranges::max_element(contacts.standoff));
    };
    EXPECT_GT(most(false).first, 100U);
    EXPECT_GT(most(false).second, 0);
    EXPECT_EQ(most(true), std::pair(std::size_t{0}, 0.0F));
}

TEST(Character, has_fewer_triangles_with_coarse_back_faces_and_unseen_edges_are_green) {
    CharacterRun all(character(), {}), seen(character(), {.coarsens_back_faces = true});
    CharacterTimes times;
    for (int i = 0; i < 20; ++i) {
        all.frame(times);
        seen.frame(times);
    }
    EXPECT_GT(times.adaptation, 0);
    EXPECT_LT(seen.cloth().mesh.leaf_triangles().size(),
              0.9 * static_cast<double>(all.cloth().mesh.leaf_triangles().size()));
    const render::SolidItem edges = edges_by_sight(seen.cloth(), viewer_of(seen.body_x()));
    const auto is_green = [](const sim::Rgb8& colour) { return colour[1] > colour[0] && colour[1] > colour[2]; };
    double front_green = 0, front = 0, back_green = 0, back = 0;
    const float middle = place_of(seen.body_x()).z();
    for (std::size_t i = 0; i < edges.x.size(); ++i) {
        const bool is_front = edges.x[i].z() > middle;
        (is_front ? front : back) += 1;
        (is_front ? front_green : back_green) += is_green(edges.colours[i]) ? 1 : 0;
    }
    EXPECT_LT(front_green / front, 0.3) << "the viewer stands in front";
    EXPECT_GT(back_green / back, 0.7);
}

TEST(Character, tables_have_a_row_for_each_level_and_the_thesis_structures_miss_no_triangle) {
    const ThesisResult result = measure_character(quick());
    ASSERT_EQ(result.tables.size(), 4U);
    EXPECT_EQ(result.tables[0].rows.size(), 2U) << "the thesis' structures, and ours";
    const Table &cloth = result.tables[1], &collision = result.tables[2];
    ASSERT_EQ(cloth.rows.size(), 6U);
    ASSERT_EQ(collision.rows.size(), 6U);
    const std::array<double, 4> triangles{488, 1952, 7808, 31232};
    for (std::size_t row = 0; row < 6; ++row) {
        if (row < 4) {
            EXPECT_EQ(number(cloth, row, 1), triangles[row]);
        }
        double sum = 0;
        for (std::size_t part = 2; part < 6; ++part) sum += number(cloth, row, part);
        EXPECT_NEAR(number(cloth, row, 6), sum, 1e-6) << "the total is that of its parts";
        for (const std::size_t column : {1U, 2U, 3U, 4U, 5U, 6U})
            EXPECT_GT(number(collision, row, column), 0) << collision.columns[column];
        EXPECT_EQ(number(collision, row, 7), 0) << "missed";
        EXPECT_GE(number(collision, row, 8), number(collision, row, 9)) << "some of all vertices";
    }
    EXPECT_LT(number(cloth, 4, 1), triangles[3]) << "adaptive";
    const Table& runs = result.tables[3];
    ASSERT_EQ(runs.rows.size(), 2U) << "the thesis' collider, and ours";
    for (std::size_t row = 0; row < 2; ++row) {
        for (const std::size_t column : {1U, 2U, 3U, 4U}) EXPECT_GT(number(runs, row, column), 0);
    }
}

TEST(Character, wears_its_dress_on_the_thesis_cylinders_and_spheres_as_well) {
    CharacterRun run(character(), {.level = 1, .collides_with_limbs = true});
    const std::vector<Vec3f> start(run.body_x().begin(), run.body_x().end());
    CharacterTimes times;
    while (run.seconds() < kWalkStart + 0.5) run.frame(times);
    EXPECT_GT((run.body_x()[0] - start[0]).norm(), 0.1F) << "it walks";
    ASSERT_EQ(find_bad_vertex(run.cloth()), std::nullopt);
    EXPECT_TRUE(run.cloth().solver->contacts.moving.last.empty()) << "nothing follows planes of the hierarchy";
    const auto found = find_penetration(run.cloth(), run.collider().surface(), {.depth = 0.001F});
    EXPECT_LT(found.faces, 0.01 * static_cast<double>(run.cloth().mesh.leaf_triangles().size()));
    EXPECT_LT(found.deepest_vertex, 0.01F);
    EXPECT_GT(times.structures, 0);
}

TEST(Character, figures_of_the_budget_hold_count_and_target_over_time) {
    const ThesisResult result = measure_changing_budget(quick());
    ASSERT_EQ(result.figures.size(), 2U);
    for (const Figure& figure : result.figures) {
        EXPECT_EQ(figure.series.columns, (std::vector<std::string>{"time, s", "triangles", "target"}));
        std::set<double> targets;
        for (std::size_t row = 0; row < figure.series.rows.size(); ++row) targets.insert(number(figure.series, row, 2));
        EXPECT_GE(targets.size(), 2U) << "the target changes while it runs";
    }
}

// 3,000 triangles, then 6,000, then 3,000 again: within 5 % from 1 s after each change on.
TEST(Character, holds_a_triangle_budget_that_changes_while_it_walks) {
    CharacterRun run(character(), {.budget = 3000});
    CharacterTimes times;
    while (run.seconds() < 1) run.frame(times);
    for (const std::size_t target : {3000U, 6000U, 3000U}) {
        run.budget()->set_target(target);
        const double changed = run.seconds();
        while (run.seconds() < changed + 1.5) {
            run.frame(times);
            const auto count = static_cast<double>(run.cloth().mesh.leaf_triangles().size());
            if (run.seconds() < changed + 1) continue;
            EXPECT_NEAR(count / static_cast<double>(target), 1, 0.05) << target << " at " << run.seconds();
        }
    }
}

}  // namespace
}  // namespace selvedge::bench
