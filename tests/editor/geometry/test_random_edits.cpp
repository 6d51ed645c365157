// Thousands of random operations in sequence on the shipped garments. Each either succeeds, and the result can be saved
// and loaded, or throws GeometryError and leaves the pattern unchanged.
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "editor/geometry/linked_panels.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/seam_edit.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

class Drafter {
 public:
    explicit Drafter(unsigned seed) : random_(seed) {}

    static constexpr int kOperations = 21;

    void draft(sim::Pattern& pattern, int operation) {
        const sim::SeamSide at = side(pattern);
        switch (operation) {
            case 0:
                return void(split_edge(pattern, at, number(-0.1, 1.1)));
            case 1:
                return remove_vertices(pattern, at.panel, vertices(pattern));
            case 2:
                return move_vertices(pattern, at.panel, vertices(pattern), vector(0.1));
            case 3:
                return transform_vertices(pattern, at.panel, vertices(pattern), map());
            case 4:
                return transform_panel(pattern, at.panel, map());
            case 5:
                return set_curve(pattern, at, curve(pattern));
            case 6:
                return void(sew_edges(pattern, {at, side(pattern), below(2) == 0}));
            case 7:
                return void(sew_runs(pattern, run(pattern), run(pattern), below(2) == 0));
            case 8:
                return remove_seams(pattern, {seam(pattern)});
            case 9:
                return equalize_seam(pattern, seam(pattern));
            case 10:
                return set_notch(pattern);
            case 11:
                return add_line(pattern);
            default:
                return draft_panels(pattern, operation, at);
        }
    }

    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(std::max(1, count))); }

 private:
    void draft_panels(sim::Pattern& pattern, int operation, const sim::SeamSide& at) {
        const Vec2d shift = vector(0.5);
        switch (operation) {
            case 12:
                return void(add_panel(pattern, make_ellipse(shift, vector(0.3))));
            case 13:
                return remove_panels(pattern, {at.panel});
            case 14:
                return void(duplicate_panels(pattern, {at.panel, below(static_cast<int>(pattern.panels.size()))},
                                             {.on_sheet = shift}));
            case 15:
                return void(symmetric_copy(pattern, at.panel, below(2) == 0, shift));
            case 16:
                return void(cut_panel(pattern, at.panel, path(pattern), below(2) == 0));
            case 17:
                return merge_any(pattern);
            case 18:
                return unfold_panel(pattern, at);
            case 19:
                return insert_dart(pattern, at, number(0, 1), number(-0.01, 0.08), number(-0.01, 0.2));
            default:
                return rename_panel(pattern, at.panel, "panel_" + std::to_string(below(5)));
        }
    }

    // Few seams have two sides of the same shape, so this tries all seams.
    void merge_any(sim::Pattern& pattern) {
        const sim::Pattern before = pattern;
        for (int i = 0; i <= static_cast<int>(pattern.seams.size()); ++i) {
            try {
                merge_panels(pattern, i);
                return;
            } catch (const GeometryError&) {
                ASSERT_TRUE(pattern == before);
            }
        }
        throw GeometryError("no two panels can be joined");
    }

    double number(double low, double high) { return low + (high - low) * below(10001) / 10000.0; }
    Vec2d vector(double size) { return {number(-size, size), number(-size, size)}; }
    // Sometimes (1 in 50) the range includes one index too many.
    int index(std::size_t count) { return below(static_cast<int>(count) + (below(50) == 0 ? 1 : 0)); }
    int seam(const sim::Pattern& pattern) { return index(pattern.seams.size()); }

    const sim::Panel& last(const sim::Pattern& pattern) {
        const auto at = static_cast<std::size_t>(panel_);
        return at < pattern.panels.size() ? pattern.panels[at] : none_;
    }

    sim::SeamSide side(const sim::Pattern& pattern) {
        panel_ = index(pattern.panels.size());
        return {panel_, index(last(pattern).edges.size())};
    }

    // Random vertices of the panel chosen last.
    std::vector<int> vertices(const sim::Pattern& pattern) {
        std::vector<int> found;
        for (int i = below(4); i >= 0; --i) found.push_back(index(last(pattern).vertices.size()));
        return found;
    }

    Eigen::Affine2d map() {
        Eigen::Affine2d map = Eigen::Affine2d::Identity();
        map.translation() = vector(0.1);
        map.linear() = Eigen::Rotation2Dd(number(-3, 3)).toRotationMatrix() * number(0.8, 1.2);
        if (below(2) == 0) map.linear().col(0) *= -1;
        if (below(3) == 0) map.linear()(0, 1) += number(-0.3, 0.3);
        return map;
    }

    sim::OutlineEdge curve(const sim::Pattern& pattern) {
        constexpr std::array kKinds{sim::CurveKind::Line, sim::CurveKind::Quadratic, sim::CurveKind::Cubic,
                                    sim::CurveKind::Arc};
        sim::OutlineEdge edge{.kind = kKinds[static_cast<std::size_t>(below(4))]};
        const std::vector<Vec2d>& points = last(pattern).vertices;
        const Vec2d near = points.empty() ? Vec2d(0, 0) : points[static_cast<std::size_t>(below(int(points.size())))];
        edge.control = {near + vector(0.1), near + vector(0.1)};
        edge.arc_radius = number(0, 1);
        edge.is_large_arc = below(4) == 0;
        edge.turns_right = below(2) == 0;
        return edge;
    }

    std::vector<Vec2d> path(const sim::Pattern& pattern) {
        const sim::Panel& own = last(pattern);
        std::vector<Vec2d> points;
        for (int i = 0; i < 2 + below(3); ++i) {
            points.push_back(own.vertices.empty() ? vector(1)
                                                  : own.vertices[std::size_t(below(int(own.vertices.size())))]);
            points.back() += vector(0.1);
        }
        return points;
    }

    std::vector<EdgeSpan> run(const sim::Pattern& pattern) {
        const sim::SeamSide at = side(pattern);
        std::vector<EdgeSpan> spans;
        const int count = std::max(1, static_cast<int>(last(pattern).edges.size()));
        for (int i = 0; i <= below(3); ++i) spans.push_back({at.panel, (at.edge + i) % count});
        if (below(2) == 0) spans.front().from = number(0, 0.5);
        if (below(2) == 0) spans.back().to = number(0.5, 1);
        return spans;
    }

    void set_notch(sim::Pattern& pattern) {
        const sim::SeamSide at = side(pattern);
        if (last(pattern).edges.empty()) return;
        sim::Panel& own = pattern.panels[static_cast<std::size_t>(at.panel)];
        own.notches.push_back({.edge = at.edge % static_cast<int>(own.edges.size()), .t = number(0, 1)});
        if (below(3) == 0) own.pins = {own.edges[0].start};
    }

    void add_line(sim::Pattern& pattern) {
        if (last(pattern).edges.empty()) return;
        pattern.panels[static_cast<std::size_t>(panel_)].internal_lines.push_back(
            {.name = "fold", .points = path(pattern)});
    }

    std::mt19937 random_;
    int panel_ = 0;
    sim::Panel none_;
};

constexpr unsigned kGarments = 16;

class RandomDrafts : public ::testing::TestWithParam<const char*> {};

TEST_P(RandomDrafts, are_sound_or_refused) {
    std::array<int, Drafter::kOperations> done{};
    int refused = 0;
    for (unsigned seed = 0; seed < kGarments; ++seed) {
        Drafter drafter(seed * 7919 + 1);
        sim::Pattern pattern = shipped_pattern(GetParam());
        for (int i = 0; i < 100; ++i) {
            const sim::Pattern before = pattern;
            const int operation = drafter.below(Drafter::kOperations);
            const std::string what = "seed " + std::to_string(seed) + ", step " + std::to_string(i) + ", operation " +
                                     std::to_string(operation);
            try {
                drafter.draft(pattern, operation);
                ++done[static_cast<std::size_t>(operation)];
                if (pattern.panels.empty()) pattern = shipped_pattern(GetParam());
            } catch (const GeometryError& error) {
                ++refused;
                ASSERT_TRUE(pattern == before) << what << ": " << error.what();
                continue;
            }
            ASSERT_TRUE(can_be_saved(pattern)) << what;
            const sim::Pattern unlinked = pattern;
            try {
                update_links(pattern, before);
                ASSERT_TRUE(can_be_saved(pattern)) << what << ", mirrored";
            } catch (const GeometryError& error) {
                ASSERT_TRUE(pattern == unlinked) << what << ": " << error.what();
                pattern = before;  // as Document does
            }
            ASSERT_EQ(sheet_positions(pattern).size(), pattern.panels.size());
            for (const sim::Seam& seam : pattern.seams) is_crossed(pattern, seam);
            if (pattern.panels.size() > 12) pattern = before;
        }
    }
    for (std::size_t i = 0; i < done.size(); ++i) EXPECT_GT(done[i], 0) << "operation " << i << " never worked";
    EXPECT_GT(refused, 50);
    RecordProperty("refused", refused);
}

INSTANTIATE_TEST_SUITE_P(Usual, RandomDrafts, ::testing::Values("tshirt"),
                         [](const auto& garment) { return std::string(garment.param); });
INSTANTIATE_TEST_SUITE_P(Thorough, RandomDrafts,
                         ::testing::Values("tshirt_thesis", "skirt", "poncho", "two_squares", "vest"),
                         [](const auto& garment) { return std::string(garment.param); });

}  // namespace

}  // namespace selvedge::editor
