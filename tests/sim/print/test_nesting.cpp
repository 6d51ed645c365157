// Shapes on a strip lie apart, inside it, in their phase, and always the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/core/error.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "sim/print/nesting.h"
#include "sim/print/paper_sheet.h"
#include "tests/sim/print/sample_pattern.h"

namespace selvedge::sim {
namespace {

std::vector<Vec2d> placed(const NestItem& item, const NestPlace& place) {
    std::vector<Vec2d> out;
    for (const Vec2d& p : item.outline) out.push_back(place.at(p));
    return out;
}

// The least distance of two closed lines; 0 if one lies in the other.
double apart(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2d& p : a) least = std::min(least, is_inside(p, b) ? 0 : distance_to_outline(p, b));
    for (const Vec2d& p : b) least = std::min(least, is_inside(p, a) ? 0 : distance_to_outline(p, a));
    return least;
}

void expect_apart(const std::vector<NestItem>& items, const Nest& nest, const NestOptions& options) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::vector<Vec2d> a = placed(items[i], nest.places[i]);
        for (const Vec2d& p : a) {
            EXPECT_GE(p.x(), -1e-9);
            EXPECT_LE(p.x(), options.width + 1e-9);
            EXPECT_GE(p.y(), -1e-9);
            EXPECT_LE(p.y(), nest.length + 1e-9);
        }
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(apart(a, placed(items[j], nest.places[j])), options.gap - 1e-9) << i << " " << j;
    }
}

// A hollow shape, a triangle, a disc and a strip.
std::vector<NestItem> shapes() {
    std::vector<Vec2d> disc;
    for (int k = 0; k < 40; ++k)
        disc.emplace_back(0.11 * std::cos(k * std::numbers::pi / 20), 0.11 * std::sin(k * std::numbers::pi / 20));
    return {{.name = "U",
             .outline = {{0, 0}, {0.6, 0}, {0.6, 0.5}, {0.45, 0.5}, {0.45, 0.1}, {0.1, 0.1}, {0.1, 0.5}, {0, 0.5}}},
            {.name = "triangle", .outline = {{0, 0}, {0.4, 0.03}, {0.1, 0.5}}, .turns = {0, std::numbers::pi}},
            {.name = "disc", .outline = disc},
            {.name = "strip", .outline = {{0, 0}, {0.7, 0}, {0.7, 0.05}, {0, 0.05}}},
            {.name = "disc", .outline = disc}};
}

TEST(Nesting, many_alike_pieces_are_laid_and_too_many_different_ones_refused) {
    std::vector<NestItem> items(3000, {.name = "square", .outline = {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}}});
    const Nest nested = nest(items, {.orders = 1});
    EXPECT_EQ(nested.places.size(), items.size());
    EXPECT_NEAR(nested.length, 3000.0 / 13 * 0.112, 0.1);  // 13 beside each other, on the raster
    EXPECT_EQ(nested.places[0].shift, Vec2d(0, 0));
    items.resize(100);
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (Vec2d& p : items[i].outline) p *= 1 + 1e-3 * double(i);
    }
    const Nest stopped = nest(items, {.most_work = 1'000'000});
    EXPECT_EQ(stopped.places.size(), 100U);
    EXPECT_GT(stopped.work, 1'000'000U) << "the search ended there";
    EXPECT_LT(stopped.work, 1'001'000U);
    try {
        nest(items, {.most_work = 1000});
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "100 pieces are more than can be laid out together");
    }
}

TEST(Nesting, shapes_lie_apart_and_on_the_strip) {
    const NestOptions options{.width = 0.9, .gap = 0.01};
    const std::vector<NestItem> items = shapes();
    const Nest nest = sim::nest(items, options);
    expect_apart(items, nest, options);
    // Discs lie in the hollow of the U, so it takes little more than the tallest shapes.
    EXPECT_LT(nest.length, 0.70);
}

TEST(Nesting, same_shapes_give_the_same_places) {
    const Nest a = nest(shapes(), {.width = 0.9}), b = nest(shapes(), {.width = 0.9});
    for (std::size_t i = 0; i < a.places.size(); ++i) EXPECT_EQ(a.places[i].shift, b.places[i].shift);
}

TEST(Nesting, shapes_on_a_sett_keep_their_phase_exactly) {
    std::vector<NestItem> items = shapes();
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i].turns = {0};
        items[i].repeat = Vec2d(0.0713, 0.0829);
        items[i].phase = Vec2d(0.01 * static_cast<double>(i), -0.02);
    }
    const NestOptions options{.width = 1.2, .gap = 0.005};
    const Nest nest = sim::nest(items, options);
    expect_apart(items, nest, options);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Vec2d repeats = (nest.places[i].shift - items[i].phase).cwiseQuotient(*items[i].repeat);
        EXPECT_NEAR(repeats.x(), std::round(repeats.x()), 1e-9);
        EXPECT_NEAR(repeats.y(), std::round(repeats.y()), 1e-9);
    }
}

TEST(Nesting, what_is_wider_than_the_strip_is_refused_by_name) {
    try {
        nest(shapes(), {.width = 0.5});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "U");
        EXPECT_EQ(error.problem(), "wider than the 50 cm that there are");
    }
}

// ---- Cutting layouts.

TEST(CuttingLayout, shipped_patterns_lie_apart_with_the_warp_along_the_fabric) {
    for (const std::filesystem::path& file : shipped_patterns()) {
        SCOPED_TRACE(file.filename().string());
        Pattern pattern = load_pattern(file).pattern;
        pattern.allowance = 0.01;
        for (const PaperSheet& layout : cutting_layouts(pattern, {.width = 1.6})) {
            std::vector<NestItem> items;
            for (std::size_t i = 0; i < layout.pieces.size(); ++i) {
                items.push_back({.name = "", .outline = layout.pieces[i].cut});
                const Panel& panel = pattern.panels[static_cast<std::size_t>(layout.pieces[i].panel)];
                const Vec2d warp(-std::sin(panel.grain_angle), std::cos(panel.grain_angle));
                EXPECT_NEAR((Eigen::Rotation2Dd(layout.places[i].turn) * warp).x(), 0, 1e-9);
            }
            expect_apart(items, {layout.places, layout.size.y()}, {.width = 1.6, .gap = 0.005});
        }
    }
}

// A symmetric panel that is cut once, and a pair.
Pattern pattern_to_fold() {
    Panel front;
    front.name = "front";
    front.vertices = {{-0.3, 0}, {0.3, 0}, {0.25, 0.6}, {-0.25, 0.6}};
    front.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    Panel left = front;
    left.name = "left";
    left.vertices = {{0, 0}, {0.3, 0}, {0.2, 0.5}, {0, 0.4}};
    Panel right = left;
    right.name = "right";
    right.mirror_of = "left";
    for (Vec2d& v : right.vertices) v.x() = -v.x();
    std::ranges::reverse(right.vertices);
    Pattern pattern;
    pattern.panels = {front, left, right};
    return pattern;
}

TEST(CuttingLayout, folded_fabric_cuts_pairs_at_once_and_symmetric_panels_on_the_fold) {
    const std::vector<PaperSheet> layouts = cutting_layouts(pattern_to_fold(), {.width = 1.4, .is_folded = true});
    ASSERT_EQ(layouts.size(), 1U);
    const PaperSheet& layout = layouts[0];
    ASSERT_EQ(layout.pieces.size(), 2U);  // the right lies under the left
    EXPECT_DOUBLE_EQ(layout.size.x(), 0.7);
    EXPECT_NEAR(layout.places[0].shift.x(), 0, 1e-9);  // the front's axis is on the fold
    EXPECT_LT(layout.size.y(), 0.62);                  // half a front, and beside it the left
    EXPECT_TRUE(layout.pieces[0].label.lines[1].starts_with("cut 1 on fold")) << layout.pieces[0].label.lines[1];
    for (std::size_t i = 0; i < 2; ++i) {
        for (const PaperLine& line : layout.pieces[i].lines) {
            for (const Vec2d& p : line.points) EXPECT_GE(layout.places[i].at(p).x(), 0) << i;
        }
    }
}

TEST(CuttingLayout, a_matched_sett_is_kept_and_not_folded) {
    Pattern pattern = pattern_to_fold();
    pattern.matched_sett = MatchedSett{.tartan = "test", .repeat = Vec2d(0.1, 0.12)};
    pattern.panels[1].sett_offset = {0.03, 0.05};
    const std::vector<PaperSheet> layouts = cutting_layouts(pattern, {.width = 1.4, .is_folded = true});
    ASSERT_EQ(layouts.size(), 1U);
    EXPECT_EQ(layouts[0].pieces.size(), 3U);
    EXPECT_FALSE(layouts[0].is_folded);
    EXPECT_EQ(layouts[0].notes.size(), 1U);
    const Vec2d off = layouts[0].places[1].shift - pattern.panels[1].sett_offset;
    EXPECT_NEAR(std::remainder(off.x(), 0.1), 0, 1e-9);
    EXPECT_NEAR(std::remainder(off.y(), 0.12), 0, 1e-9);
}

}  // namespace
}  // namespace selvedge::sim
