// Seams that are proposed for patterns whose seams are known, and taken away first.
#include "sim/proposals/seam_proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::sim {
namespace {

struct Score {
    std::size_t right = 0;  // proposed pairs of edges that a seam joins
    std::size_t wrong = 0;
    std::size_t found = 0;  // seams
    std::size_t seams = 0;

    void operator+=(const Score& other) {
        right += other.right;
        wrong += other.wrong;
        found += other.found;
        seams += other.seams;
    }
};

// Takes the seams of a pattern away, and compares those that are proposed with them.
Score score_of(const Pattern& truth) {
    std::map<std::pair<SeamSide, SeamSide>, std::size_t> seam_of;
    for (std::size_t s = 0; s < truth.seams.size(); ++s) {
        seam_of[{truth.seams[s].first, truth.seams[s].second}] = s;
        seam_of[{truth.seams[s].second, truth.seams[s].first}] = s;
    }
    Pattern bare = truth;
    bare.seams.clear();
    Score score;
    score.seams = truth.seams.size();
    std::set<std::size_t> found;
    const ProposalOptions options;
    for (const SeamProposal& proposal : propose_seams(bare, options)) {
        if (proposal.confidence < options.accepted) continue;
        for (const auto& [first, second] : proposal.parts) {
            const auto seam = seam_of.find({{first.panel, first.edge}, {second.panel, second.edge}});
            ++(seam == seam_of.end() ? score.wrong : score.right);
            if (seam != seam_of.end()) found.insert(seam->second);
        }
    }
    score.found = found.size();
    return score;
}

std::filesystem::path shipped(const std::string& name) {
    return std::filesystem::path(source_folder()) / "patterns" / (name + ".json");
}

TEST(SeamProposals, find_the_seams_of_shipped_garments_and_no_others) {
    Score all;
    for (const char* name : {"tshirt", "dress", "vest", "skirt", "tshirt_thesis"})
        all += score_of(load_pattern(shipped(name)).pattern);
    EXPECT_EQ(all.seams, 30U);
    EXPECT_GE(all.found, 28U);
    EXPECT_EQ(all.wrong, 0U);
}

TEST(SeamProposals, find_most_seams_of_published_patterns) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const std::filesystem::path folder = std::filesystem::path(data) / "garmentcode";
    Score all;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().string().ends_with("_specification.json")) all += score_of(load_pattern(entry.path()).pattern);
    }
    EXPECT_GE(10 * all.found, 7 * all.seams) << all.found << " of " << all.seams;
    EXPECT_GE(all.right, 7 * all.wrong) << all.right << " right, " << all.wrong << " wrong";
}

TEST(SeamProposals, are_accepted_by_dividing_edges_where_they_end) {
    Pattern pattern = load_pattern(shipped("tshirt")).pattern;
    pattern.seams.clear();
    const std::size_t edges = pattern.panels[0].edges.size();
    const SeamProposal proposal{.parts = {{{0, 0, 0.25, 0.75}, {1, 0, 0, 0.5}}}};
    accept_proposals(pattern, {proposal});
    ASSERT_EQ(pattern.seams.size(), 1U);
    EXPECT_EQ(pattern.panels[0].edges.size(), edges + 2);
    EXPECT_EQ(pattern.seams[0].first, (SeamSide{0, 1}));
    EXPECT_EQ(pattern.seams[0].second, (SeamSide{1, 0}));
    const Pattern whole = load_pattern(shipped("tshirt")).pattern;
    const Vec2d start = pattern.panels[0].vertices[static_cast<std::size_t>(pattern.panels[0].edges[1].start)];
    EXPECT_LT((start - outline_point(whole.panels[0], whole.panels[0].edges[0], 0.25)).norm(), 1e-9);
}

// As outlines of many edges are in DXF: joints of both sides pair up only where that divides both sides alike.
TEST(SeamProposals, divide_a_seam_with_ease_evenly_whatever_edges_its_sides_have) {
    Pattern pattern = load_pattern(shipped("tshirt")).pattern;
    pattern.seams.clear();
    const auto index_of = [&](const char* name) {
        return static_cast<int>(std::ranges::find(pattern.panels, name, &Panel::name) - pattern.panels.begin());
    };
    const int front = index_of("front"), sleeve = index_of("left_sleeve_front");
    const auto panel = [&](int p) -> Panel& { return pattern.panels[static_cast<std::size_t>(p)]; };
    for (const int p : {sleeve, index_of("left_sleeve_back")})
        panel(p) = mapped_panel(panel(p), Eigen::Affine2d(Eigen::Scaling(1.06, 1.06)));
    constexpr int kArmhole = 2, kCap = 3;
    for (const double t : {0.9, 0.8, 0.65, 0.5, 0.35, 0.25, 0.12, 0.06}) split_edge(panel(sleeve), kCap, t);
    for (const double t : {0.95, 0.7, 0.6, 0.57, 0.3, 0.18, 0.15}) split_edge(panel(front), kArmhole, t);
    accept_proposals(pattern, propose_seams(pattern, {.least_confidence = 0.5}));
    const auto length = [&](const SeamSide& side) {
        const Panel& own = panel_of(pattern, side);
        return outline_length(own, own.edges[static_cast<std::size_t>(side.edge)]);
    };
    int between = 0;
    for (const Seam& seam : pattern.seams) {
        if (std::minmax(seam.first.panel, seam.second.panel) != std::minmax(front, sleeve)) continue;
        ++between;
        const double one = length(seam.first), other = length(seam.second);
        EXPECT_LT(std::abs(one - other), std::max(0.005, 0.35 * std::min(one, other))) << one << " " << other;
    }
    EXPECT_GE(between, 8);
}

// As they come from a PDF: one sleeve is drawn, cut twice, and its curves are many pieces.
TEST(SeamProposals, close_a_sleeve_of_two_halves_below_and_put_its_top_to_the_shoulder) {
    const Pattern whole = load_pattern(shipped("tshirt")).pattern;
    const auto named = [&](const char* name) { return *std::ranges::find(whole.panels, name, &Panel::name); };
    Pattern pattern = whole;
    pattern.seams.clear();
    pattern.panels = {named("back"), named("left_sleeve_back"), named("left_sleeve_front"), named("front")};
    constexpr std::size_t kBack = 1, kFront = 2, kTorso = 3;
    for (const auto& [p, edge] : {std::pair(kBack, 0), std::pair(kFront, 3), std::pair(kTorso, 2)}) {
        for (const double t : {0.8, 0.6, 0.4, 0.2}) split_edge(pattern.panels[p], edge, t);
    }
    for (const std::size_t p : {kBack, kFront}) {
        Panel& panel = pattern.panels[p];
        panel.name = panel.name.substr(5);
        Panel image = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
        image.mirror_of = panel.name;
        image.name += "_mirrored";
        pattern.panels.push_back(std::move(image));
    }
    int between_halves = 0;
    std::vector<std::pair<double, double>> heights;  // of the front's armhole and the sleeve
    const auto height = [&](const EdgeSpan& span) {
        const Panel& panel = pattern.panels[static_cast<std::size_t>(span.panel)];
        return outline_point(panel, panel.edges[static_cast<std::size_t>(span.edge)], (span.from + span.to) / 2).y();
    };
    for (const SeamProposal& proposal : propose_seams(pattern, {.least_confidence = 0.5})) {
        const auto is = [&](const EdgeSpan& span, std::size_t p) { return span.panel == static_cast<int>(p); };
        const auto& [one, other] = proposal.parts.front();
        between_halves += (is(one, kBack) && is(other, kFront)) || (is(one, kFront) && is(other, kBack)) ? 1 : 0;
        for (const auto& [first, second] : proposal.parts) {
            if (is(first, kFront) && is(second, kTorso)) heights.emplace_back(height(second), height(first));
            if (is(first, kTorso) && is(second, kFront)) heights.emplace_back(height(first), height(second));
        }
    }
    EXPECT_EQ(between_halves, 2);
    ASSERT_GE(heights.size(), 2U);
    std::ranges::sort(heights);
    EXPECT_TRUE(std::ranges::is_sorted(heights, {}, [](const auto& pair) { return pair.second; }));
}

// What is told of a proposal is where it lies once others are sewn.
TEST(SeamProposals, name_edges_as_they_are_after_others_divided_them) {
    const SeamProposal sewn{.parts = {{{0, 1, 0.25, 0.75}, {1, 0, 0, 0.5}}}};
    const SeamProposal other{.parts = {{{0, 1, 0.75, 1}, {0, 3, 0, 1}}, {{0, 0, 0, 1}, {1, 0, 0.5, 0.75}}}};
    const std::vector<SeamProposal> now = after_acceptance({sewn, other}, {sewn});
    EXPECT_EQ(now[0].parts, (decltype(sewn.parts){{{0, 2, 0, 1}, {1, 0, 0, 1}}}));
    EXPECT_EQ(now[1].parts, (decltype(sewn.parts){{{0, 3, 0, 1}, {0, 5, 0, 1}}, {{0, 0, 0, 1}, {1, 1, 0, 0.5}}}));
}

TEST(SeamProposals, leave_sewn_edges_and_unworn_panels_alone) {
    Pattern pattern = load_pattern(shipped("tshirt")).pattern;
    EXPECT_TRUE(propose_seams(pattern, {.least_confidence = 0.5}).empty());
    pattern.seams.clear();
    for (Panel& panel : pattern.panels) panel.is_worn = false;
    EXPECT_TRUE(propose_seams(pattern).empty());
}

TEST(SeamProposals, say_why_in_words) {
    Pattern pattern = load_pattern(shipped("skirt")).pattern;
    pattern.seams.clear();
    const std::vector<SeamProposal> proposals = propose_seams(pattern);
    ASSERT_FALSE(proposals.empty());
    const std::string text = describe(pattern, proposals[0]);
    EXPECT_NE(text.find("lengths 55.0 and 55.0 cm"), std::string::npos) << text;
    EXPECT_NE(text.find("%"), std::string::npos) << text;
}

}  // namespace
}  // namespace selvedge::sim
