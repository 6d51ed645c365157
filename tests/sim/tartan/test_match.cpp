#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <random>

#include "sim/pattern/pattern_file.h"
#include "sim/tartan/match.h"
#include "sim/tartan/offset_graph.h"
#include "sim/tartan/tartan_file.h"
#include "tests/sim/tartan/seamed_panels.h"

namespace selvedge::sim {
namespace {

constexpr double kExact = 2e-5;  // m; offsets are rounded to 0.001 mm

Pattern matched(Pattern pattern, const Sett& sett, const MatchOptions& options = {}) {
    const SettMatch match = match_sett(pattern, sett, options);
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) pattern.panels[p].sett_offset = match.offsets[p];
    return pattern;
}

// Two boxes sewn to a tube. At both seams the weft's stripes have the mismatch `rise`, m.
Pattern tube(double rise) {
    Pattern pattern;
    pattern.panels = {box("front", {0, 0}, 0.4, 0.5), box("back", {0.03, rise}, 0.4, 0.5)};
    pattern.seams = {{{0, 1}, {1, 3}}, {{0, 3}, {1, 1}}};
    return pattern;
}

TEST(Match, straight_side_seams_meet_exactly_all_round) {
    for (const Sett& sett : {mirrored_sett(), one_way_sett()}) {
        const SettMatch match = match_sett(tube(0.0171), sett);
        ASSERT_EQ(match.seams.size(), 2U);
        for (const SeamMatch& seam : match.seams) {
            EXPECT_NEAR(seam.length, 0.5, 1e-12);
            EXPECT_NEAR(seam.before, 0.0171, 1e-9);
            EXPECT_LT(seam.after, kExact);
            EXPECT_LE(seam.rms_after, seam.after);
            EXPECT_EQ(seam.met, 1);
            EXPECT_EQ(seam.why, "");
        }
        EXPECT_TRUE(match.offsets[0].isZero(0));  // the first panel keeps its offset
    }
}

TEST(Match, what_is_reported_is_what_an_independent_look_at_the_colours_sees) {
    Pattern pattern = tube(0.0171);
    pattern.panels[1].vertices[2].x() += 0.06;  // one side is slanted
    pattern.panels[0].grain_angle = 0.2;
    for (const Sett& sett : {mirrored_sett(), one_way_sett()}) {
        const SettMatch match = match_sett(pattern, sett);
        const Pattern after = matched(pattern, sett);
        ASSERT_EQ(match.seams.size(), pattern.seams.size());
        for (const SeamMatch& seam : match.seams) {
            const Seam& sewn = pattern.seams[static_cast<std::size_t>(seam.seam)];
            EXPECT_NEAR(seam.before, seen_mismatch(pattern, sewn, sett), 2e-4) << seam.name;
            EXPECT_NEAR(seam.after, seen_mismatch(after, sewn, sett), 2e-4) << seam.name;
        }
    }
}

TEST(Match, stripes_that_run_along_a_seam_go_on_round_the_body_where_that_is_free) {
    const Sett sett = one_way_sett();
    const Pattern after = matched(tube(0), sett);
    // The front's right edge, x = 0.4, is sewn to the back's left edge, x = 0.03. The other seam cannot match, because
    // the circumference of the tube is not an integer number of repeats.
    const auto gap = [&](const Seam& seam) {
        const double x = (sett_place(after, seam.first, 0) - sett_place(after, seam.second, 1)).x();
        return std::abs(std::remainder(x, repeat_size(sett)));
    };
    EXPECT_LT(std::min(gap(after.seams[0]), gap(after.seams[1])), kExact);
}

// Two halves with a slanted seam, so that the stripes of both sides meet the seam at 30 degrees.
Pattern chevron() {
    Pattern pattern;
    const double lean = 0.5 * std::tan(std::numbers::pi / 6);
    pattern.panels = {polygon_panel("left", {{0, 0}, {0.4, 0}, {0.4 - lean, 0.5}, {0, 0.5}}),
                      polygon_panel("right", {{0, 0.011}, {0.4, 0.011}, {0.4, 0.511}, {lean, 0.511}})};
    pattern.seams = {{{0, 1}, {1, 3}}};
    return pattern;
}

TEST(Match, a_chevron_meets_by_its_mirror_image_in_a_sett_that_mirrors) {
    const SettMatch match = match_sett(chevron(), mirrored_sett());
    EXPECT_GT(match.seams[0].before, 0.005);
    EXPECT_LT(match.seams[0].after, kExact);
    EXPECT_EQ(match.seams[0].why, "");
}

TEST(Match, a_chevron_in_a_one_way_sett_cannot_meet_and_says_so) {
    const SettMatch match = match_sett(chevron(), one_way_sett());
    EXPECT_GT(match.seams[0].after, 0.01);
    EXPECT_LT(match.seams[0].met, 0.5);
    EXPECT_NE(match.seams[0].why.find("no mirror"), std::string::npos) << match.seams[0].why;
}

TEST(Match, a_chevron_on_the_bias_meets_too) {
    Pattern pattern = tube(0.013);
    pattern.panels[0].grain_angle = std::numbers::pi / 4;
    pattern.panels[1].grain_angle = -std::numbers::pi / 4;
    pattern.seams.resize(1);
    EXPECT_LT(match_sett(pattern, mirrored_sett()).seams[0].after, kExact);
    const SettMatch one_way = match_sett(pattern, one_way_sett());
    EXPECT_GT(one_way.seams[0].after, 0.01);
    EXPECT_NE(one_way.seams[0].why, "");
}

TEST(Match, other_angles_on_both_sides_cannot_meet_and_say_so) {
    Pattern pattern = tube(0.01);
    pattern.panels[1].grain_angle = 0.3;
    const SettMatch match = match_sett(pattern, mirrored_sett());
    EXPECT_NE(match.seams[0].why.find("angles"), std::string::npos) << match.seams[0].why;
}

// Three boxes in a ring. For any offsets the mismatches around the ring add up to 8 mm.
Pattern ring() {
    Pattern pattern;
    pattern.panels = {box("a", {0, 0}, 0.3, 0.5), box("b", {0, 0}, 0.3, 0.5), box("c", {0, 0}, 0.3, 0.5)};
    pattern.panels[2].vertices[1].y() += 0.008;
    pattern.panels[2].vertices[2].y() += 0.008;
    pattern.seams = {{{0, 1}, {1, 3}}, {{1, 1}, {2, 3}}, {{2, 1}, {0, 3}}};
    return pattern;
}

TEST(Match, a_cycle_that_cannot_close_leaves_its_error_to_one_seam) {
    const SettMatch match = match_sett(ring(), one_way_sett());
    int exact = 0;
    for (const SeamMatch& seam : match.seams) exact += seam.after < kExact ? 1 : 0;
    EXPECT_EQ(exact, 2);
    for (const SeamMatch& seam : match.seams) {
        if (seam.after < kExact) continue;
        EXPECT_NEAR(seam.after, 0.008, kExact);
        EXPECT_EQ(seam.why, "other seams determine the offsets of its panels");
    }
}

TEST(Match, seams_that_are_named_first_win) {
    for (int spared = 0; spared < 3; ++spared) {
        MatchOptions options;
        for (int seam = 0; seam < 3; ++seam) {
            if (seam != spared) options.first_seams.push_back(seam);
        }
        const SettMatch match = match_sett(ring(), one_way_sett(), options);
        for (int seam = 0; seam < 3; ++seam) {
            EXPECT_NEAR(match.seams[static_cast<std::size_t>(seam)].after, seam == spared ? 0.008 : 0, kExact);
        }
    }
}

TEST(Match, a_short_seam_named_first_wins_against_two_long_ones) {
    // The back's lower half is shifted, so its two left edges cannot both match the front's right edges.
    Pattern pattern;
    pattern.panels = {
        polygon_panel("front", {{0, 0}, {0.4, 0}, {0.4, 0.1}, {0.4, 0.5}, {0, 0.5}}),
        polygon_panel("back", {{0, 0}, {0.4, 0}, {0.4, 0.5}, {0, 0.506}, {-0.02, 0.106}, {-0.02, 0.006}})};
    pattern.panels[1].vertices[4] = {0, 0.106};
    pattern.panels[1].vertices[5] = {0, 0.003};
    pattern.panels[1].vertices[0] = {0, -0.02};
    pattern.seams = {{{0, 2}, {1, 3}}, {{0, 1}, {1, 4}}};
    const SettMatch by_length = match_sett(pattern, one_way_sett());
    const SettMatch by_name = match_sett(pattern, one_way_sett(), {.first_seams = {1}});
    EXPECT_LT(by_length.seams[0].after, kExact);
    EXPECT_GT(by_length.seams[1].after, 1e-3);
    EXPECT_GT(by_name.seams[0].after, 1e-3);
    EXPECT_LT(by_name.seams[1].after, by_length.seams[1].after);
}

TEST(Match, an_eased_seam_is_matched_from_its_lower_end) {
    Pattern pattern = tube(0.017);
    for (const std::size_t corner : {2U, 3U}) pattern.panels[1].vertices[corner].y() += 0.012;
    const SettMatch match = match_sett(pattern, one_way_sett());
    const Pattern after = matched(pattern, one_way_sett());
    for (const SeamMatch& seam : match.seams) {
        EXPECT_NEAR(seam.after, 0.012, kExact);
        EXPECT_EQ(seam.why, "its sides differ by 12.0 mm: matched from its lower end");
    }
    const double hem = (sett_place(after, {0, 1}, 0) - sett_place(after, {1, 3}, 1)).y();
    EXPECT_NEAR(std::remainder(hem, repeat_size(one_way_sett())), 0, kExact);
}

TEST(Match, a_sett_may_be_centred_on_a_panel_and_the_others_follow) {
    const Sett sett = mirrored_sett();
    const Pattern pattern = tube(0.0171);
    const SettMatch match = match_sett(pattern, sett, {.centred_panel = 1});
    // The back extends from x = 0.03 to 0.43 m. The sett has mirror lines at 5 mm and 30 mm.
    EXPECT_NEAR(std::remainder(0.23 + match.offsets[1].x() - 0.005, 0.025), 0, kExact);
    EXPECT_LE(std::abs(match.offsets[1].x()), 0.0125 + kExact);
    EXPECT_EQ(match.offsets[1].y(), 0);
    EXPECT_NEAR(match.offsets[0].y(), 0.0171, kExact);
    for (const SeamMatch& seam : match.seams) EXPECT_LT(seam.after, kExact);
    EXPECT_TRUE(match_sett(pattern, one_way_sett(), {.centred_panel = 0}).offsets[0].isZero(0));
}

TEST(Match, matching_again_changes_nothing) {
    for (const Sett& sett : {mirrored_sett(), one_way_sett()}) {
        for (const Pattern& pattern : {tube(0.0171), ring(), chevron()}) {
            const Pattern once = matched(pattern, sett);
            const SettMatch again = match_sett(once, sett);
            for (std::size_t p = 0; p < once.panels.size(); ++p) {
                EXPECT_EQ(again.offsets[p], once.panels[p].sett_offset);
            }
        }
    }
}

// A random garment: boxes of several sizes and grain angles, sewn together at random edges.
Pattern random_garment(unsigned seed, int panels) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * double(random() % 100000) / 100000.0;
    };
    Pattern pattern;
    for (int p = 0; p < panels; ++p) {
        Panel panel = box("p" + std::to_string(p), {between(-1, 1), between(-1, 1)}, between(0.1, 0.5), 0.4);
        for (Vec2d& vertex : panel.vertices) vertex += Vec2d(between(-0.03, 0.03), between(-0.03, 0.03));
        panel.grain_angle = random() % 3 == 0 ? between(-2, 2) : 0;
        pattern.panels.push_back(panel);
    }
    for (int edge = 0; edge < 4; ++edge) {
        for (int p = 0; p + 1 < panels; p += 1 + static_cast<int>(random() % 2)) {
            const auto other = static_cast<int>(random() % static_cast<unsigned>(panels));
            pattern.seams.push_back({.first = {p, edge},
                                     .second = {other, static_cast<int>(random() % 4)},
                                     .is_reversed = random() % 4 != 0});
        }
    }
    return pattern;
}

TEST(Match, the_order_of_the_panels_does_not_matter) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Pattern pattern = random_garment(seed, 9);
        Pattern turned = pattern;
        const int count = static_cast<int>(pattern.panels.size());
        std::reverse(turned.panels.begin(), turned.panels.end());
        std::rotate(turned.panels.begin(), turned.panels.begin() + 4, turned.panels.end());
        const auto moved = [&](int panel) { return ((count - 1 - panel) - 4 + count) % count; };
        for (Seam& seam : turned.seams) {
            seam.first.panel = moved(seam.first.panel);
            seam.second.panel = moved(seam.second.panel);
        }
        for (const Sett& sett : {mirrored_sett(), one_way_sett()}) {
            const SettMatch a = match_sett(pattern, sett);
            const SettMatch b = match_sett(turned, sett);
            ASSERT_EQ(a.seams.size(), pattern.seams.size());
            ASSERT_EQ(b.seams.size(), pattern.seams.size());
            for (std::size_t s = 0; s < a.seams.size(); ++s) {
                EXPECT_EQ(a.seams[s].name, b.seams[s].name);
                EXPECT_NEAR(a.seams[s].after, b.seams[s].after, 5e-6) << seed << a.seams[s].name;
            }
        }
    }
}

TEST(Match, the_same_input_gives_the_same_bits) {
    const Pattern pattern = random_garment(7, 20);
    const SettMatch a = match_sett(pattern, mirrored_sett());
    const SettMatch b = match_sett(pattern, mirrored_sett());
    EXPECT_EQ(a.offsets, b.offsets);
}

TEST(Match, named_seams_come_out_as_well_as_each_could_after_those_before_it) {
    for (unsigned seed = 20; seed < 30; ++seed) {
        const Pattern pattern = random_garment(seed, 8);
        const int first = static_cast<int>(seed) % static_cast<int>(pattern.seams.size());
        const SettMatch match = match_sett(pattern, mirrored_sett(), {.first_seams = {first}});
        Pattern alone = pattern;
        alone.seams = {pattern.seams[static_cast<std::size_t>(first)]};
        const SettMatch best = match_sett(alone, mirrored_sett());
        EXPECT_NEAR(match.seams[static_cast<std::size_t>(first)].rms_after, best.seams[0].rms_after, 5e-6) << seed;
    }
}

TEST(Match, hostile_offsets_darts_and_points_do_no_harm) {
    Pattern pattern = tube(0.01);
    pattern.panels[0].sett_offset = {std::nan(""), 1e9};
    pattern.panels[1].sett_offset = {std::numeric_limits<double>::infinity(), 99.99};
    pattern.seams.push_back({{0, 0}, {0, 2}});  // a panel that is sewn to itself
    pattern.panels.push_back(polygon_panel("point", {{0, 0}, {0, 0}, {0, 0}}));
    pattern.seams.push_back({{2, 0}, {1, 0}});
    pattern.seams.push_back({{2, 1}, {2, 2}});
    const SettMatch match = match_sett(pattern, mirrored_sett());
    for (const Vec2d& offset : match.offsets) EXPECT_TRUE(offset.allFinite());
    for (const SeamMatch& seam : match.seams) EXPECT_TRUE(std::isfinite(seam.after)) << seam.name;
    EXPECT_LT(match.seams[0].after, kExact);
}

TEST(Match, a_garment_without_seams_or_a_sett_of_one_colour_is_left_alone) {
    Pattern pattern = tube(0.01);
    EXPECT_TRUE(match_sett(pattern, parse_threadcount("K20")).offsets[1].isZero(0));
    pattern.seams.clear();
    EXPECT_TRUE(match_sett(pattern, mirrored_sett()).offsets[1].isZero(0));
}

TEST(Match, warp_and_weft_may_repeat_at_different_sizes) {
    Sett sett = parse_threadcount("K20 R30 weft: G7 W14 B2");
    sett.thread_spacing = 5e-4;
    const Pattern pattern = tube(0.0171);
    const SettMatch match = match_sett(pattern, sett);
    EXPECT_NEAR(match.seams[0].before, std::abs(std::remainder(0.0171, 23 * 5e-4)), 1e-9);
    EXPECT_LT(match.seams[0].after, kExact);
}

TEST(Match, offsets_serve_the_sett_that_they_were_found_for_and_no_other) {
    const Sett sett = find_tartan("gordon");
    const MatchedSett matched{.tartan = "Gordon", .repeat = Vec2d(repeat_size(sett), repeat_size(sett))};
    EXPECT_TRUE(is_sett_of(matched, sett));
    EXPECT_FALSE(is_sett_of(matched, with_repeat_size(sett, 0.09)));
    EXPECT_FALSE(is_sett_of(matched, with_repeat_size(find_tartan("anderson"), repeat_size(sett))));
    EXPECT_FALSE(is_sett_of({"no such tartan", matched.repeat}, sett));
}

TEST(Match, other_peoples_patterns_meet_at_their_straight_seams_and_are_told_as_the_colours_show) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const Sett sett = find_tartan("black_watch");
    for (const char* name : {"shirt_mean", "dress_pencil", "example_handwritten"}) {
        const std::string file = std::string(data) + "/garmentcode/" + name + "_specification.json";
        const Pattern pattern = load_pattern(file).pattern;
        const SettMatch match = match_sett(pattern, sett);
        const Pattern after = matched(pattern, sett);
        int straight = 0;
        for (const SeamMatch& seam : match.seams) {
            const Seam& sewn = pattern.seams[static_cast<std::size_t>(seam.seam)];
            EXPECT_NEAR(seam.after, seen_mismatch(after, sewn, sett), 5e-4) << name << " " << seam.name;
            const Panel& first = panel_at(pattern, sewn.first);
            const Panel& second = panel_at(pattern, sewn.second);
            const OutlineEdge& a = first.edges[static_cast<std::size_t>(sewn.first.edge)];
            const OutlineEdge& b = second.edges[static_cast<std::size_t>(sewn.second.edge)];
            const double difference = outline_length(first, a) - outline_length(second, b);
            if (a.kind != CurveKind::Line || b.kind != CurveKind::Line || std::abs(difference) > 1e-3) continue;
            if (seam.length < 0.04 || sewn.first.panel == sewn.second.panel) continue;
            EXPECT_LT(seam.after, 5e-4) << name << " " << seam.name;
            ++straight;
        }
        EXPECT_GE(straight, 2) << name;
    }
}

// A ring of 3,000 panels: the solver must stop when nothing improves, and not after a time limit.
TEST(Match, thousands_of_panels_are_matched_to_the_last) {
    Pattern pattern;
    constexpr int kPanels = 3000;
    for (int p = 0; p < kPanels; ++p) {
        pattern.panels.push_back(box("p" + std::to_string(p), {0, 0.001 * (p * 7919 % 53)}, 0.3, 0.5));
        if (p > 0) pattern.seams.push_back({{p - 1, 1}, {p, 3}});
    }
    pattern.seams.push_back({{kPanels - 1, 1}, {0, 3}});
    const SettMatch match = match_sett(pattern, mirrored_sett());
    ASSERT_EQ(match.seams.size(), pattern.seams.size());
    for (const SeamMatch& seam : match.seams) EXPECT_LT(seam.after, kExact) << seam.name;
}

}  // namespace

namespace {

double cost(const std::vector<ShiftTerm>& terms, double shift, double repeat) {
    double sum = 0;
    for (const ShiftTerm& term : terms) {
        sum += term.weight * std::abs(std::remainder(term.factor * shift + term.value, repeat));
    }
    return sum;
}

TEST(BestShift, one_term_goes_to_zero_by_the_shorter_way) {
    EXPECT_NEAR(best_shift({{0.02, 1, 1}}, 0.1), -0.02, 1e-12);
    EXPECT_NEAR(best_shift({{0.09, 1, 1}}, 0.1), 0.01, 1e-12);
    EXPECT_NEAR(best_shift({{0.02, 1, -1}}, 0.1), 0.02, 1e-12);
    EXPECT_NEAR(best_shift({{0.02, 1, 2}}, 0.1), -0.01, 1e-12);
}

TEST(BestShift, the_heavier_of_two_wins) {
    EXPECT_NEAR(best_shift({{0.02, 1, 1}, {0.03, 2, 1}}, 0.1), -0.03, 1e-12);
}

TEST(BestShift, stays_where_nothing_is_better) {
    EXPECT_EQ(best_shift({{0, 1, 1}}, 0.1), 0);
    EXPECT_EQ(best_shift({{0.05, 1, 1}, {0, 1, 1}}, 0.1), 0);
    EXPECT_EQ(best_shift({{0.02, 0, 1}}, 0.1), 0);
    EXPECT_EQ(best_shift({}, 0.1), 0);
}

TEST(BestShift, is_not_led_astray_by_what_rounding_leaves_of_nothing_or_of_half_a_repeat) {
    EXPECT_NEAR(best_shift({{1.7e-18, 1, 1}, {0.03, 2, 1}}, 0.2), -0.03, 1e-12);
    EXPECT_NEAR(best_shift({{std::nextafter(0.1, 1.0), 1, 1}, {0, 2, 1}}, 0.2), 0, 1e-12);
    EXPECT_NEAR(best_shift({{-1.7e-18, 1, 1}, {0.03, 2, -1}}, 0.2), 0.03, 1e-12);
}

TEST(BestShift, no_shift_on_a_fine_grid_is_better) {
    std::mt19937 random(5);
    const auto number = [&] { return double(random() % 100001) / 100000.0; };
    for (int trial = 0; trial < 300; ++trial) {
        const double repeat = 0.05 + 0.2 * number();
        std::vector<ShiftTerm> terms(1 + random() % 12);
        for (ShiftTerm& term : terms) {
            const int factor = random() % 3 == 0 ? 2 : 1;
            term = {3 * number() - 1.5, number(), random() % 2 == 0 ? factor : -factor};
        }
        const double shift = best_shift(terms, repeat);
        EXPECT_LE(std::abs(shift), repeat / 2 + 1e-12);
        for (int i = 0; i < 2000; ++i) {
            EXPECT_LE(cost(terms, shift, repeat), cost(terms, i * repeat / 2000, repeat) + 1e-8);
        }
    }
}

StripeRepeat repeat_of(const char* threadcount) {
    Sett sett = parse_threadcount(threadcount);
    sett.thread_spacing = 1e-3;
    return warp_repeat(sett);
}

TEST(SettRepeat, a_sett_with_pivots_mirrors_in_the_middle_of_one) {
    const StripeRepeat repeat = repeat_of("K/20 R6 W/4");
    EXPECT_DOUBLE_EQ(repeat.size, 0.036);
    ASSERT_TRUE(repeat.mirror);
    EXPECT_DOUBLE_EQ(*repeat.mirror, 0.010);
}

TEST(SettRepeat, a_sett_that_goes_one_way_has_no_mirror) {
    const StripeRepeat repeat = repeat_of("K20 R6 W4");
    EXPECT_DOUBLE_EQ(repeat.size, 0.030);
    EXPECT_FALSE(repeat.mirror);
}

TEST(SettRepeat, two_colours_mirror_without_a_pivot) {
    const StripeRepeat repeat = repeat_of("K8 W4");
    EXPECT_DOUBLE_EQ(repeat.size, 0.012);
    ASSERT_TRUE(repeat.mirror);
    EXPECT_DOUBLE_EQ(*repeat.mirror, 0.004);
}

TEST(SettRepeat, a_repeat_written_twice_is_found_once) {
    EXPECT_DOUBLE_EQ(repeat_of("K8 W4 R2 K8 W4 R2").size, 0.014);
    EXPECT_DOUBLE_EQ(repeat_of("K4 W4 R2 K8 W4 R2 K4").size, 0.014);  // repeat that begins inside a stripe
}

TEST(SettRepeat, neighbours_of_one_colour_are_one_stripe_across_the_end_too) {
    const StripeRepeat repeat = repeat_of("K3 W4 K5");
    EXPECT_DOUBLE_EQ(repeat.size, 0.012);
    ASSERT_TRUE(repeat.mirror);
    EXPECT_DOUBLE_EQ(*repeat.mirror, -0.001);
}

TEST(SettRepeat, one_colour_has_no_stripes) {
    EXPECT_EQ(repeat_of("K8").size, 0);
    EXPECT_EQ(repeat_of("K/8 K4 K/2").size, 0);
}

TEST(SettRepeat, the_weft_has_its_own) {
    Sett sett = parse_threadcount("K20 R6 W4 weft: K/8 W/4");
    sett.thread_spacing = 1e-3;
    EXPECT_DOUBLE_EQ(weft_repeat(sett).size, 0.012);
    EXPECT_TRUE(weft_repeat(sett).mirror);
    EXPECT_FALSE(warp_repeat(sett).mirror);
}

}  // namespace

}  // namespace selvedge::sim
