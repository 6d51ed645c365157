#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "sim/pattern/fabric_fields.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {
namespace {

template <class Part>
class FieldsOf : public ::testing::Test {};
using Parts = ::testing::Types<OutlineEdge, InternalLine, Notch, WrapCone, SurfaceDesign, Underlay, SeamSide, Panel,
                               Seam, Pattern, Thread, Topstitch, MatchedSett, Fabric>;
TYPED_TEST_SUITE(FieldsOf, Parts);

template <class T>
void change(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        value = !value;
    } else if constexpr (std::is_enum_v<T>) {
        value = static_cast<T>(1);
    } else if constexpr (std::is_same_v<T, std::string>) {
        value += "x";
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
        value += 1;
    } else if constexpr (Described<T>) {
        std::apply([&](const auto& first, const auto&...) { change(value.*first.member); }, fields_of<T>());
    } else if constexpr (requires { value.has_value(); }) {
        value.emplace();
    } else if constexpr (requires { value.rows(); }) {
        value.data()[0] += 1;
    } else if constexpr (requires { value.resize(1); }) {
        value.resize(value.size() + 1);
    } else {
        change(value[0](0));
    }
}

TYPED_TEST(FieldsOf, make_two_parts_unequal_when_one_differs) {
    for_each_field<TypeParam>([](const auto& field) {
        TypeParam part{};
        change(part.*field.member);
        EXPECT_FALSE(part == TypeParam{}) << field.name;
    });
}

TYPED_TEST(FieldsOf, have_unique_names_keys_and_journal_names) {
    std::set<std::string_view> names, keys, journal;
    std::size_t count = 0;
    for_each_field<TypeParam>([&](const auto& field) {
        names.insert(field.name);
        keys.insert(field.key);
        journal.insert(field.journal);
        ++count;
    });
    EXPECT_EQ(names.size(), count);
    EXPECT_EQ(keys.size(), count);
    EXPECT_EQ(journal.size(), count);
}

TYPED_TEST(FieldsOf, have_defaults_within_their_ranges) {
    const TypeParam usual{};
    visit_fields(usual, [](const auto& field, const auto& value) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
            EXPECT_TRUE(field.range.holds(static_cast<double>(value))) << field.name;
        }
    });
}

TEST(FieldVisit, reaches_values_in_lists_optionals_and_parts_with_their_own_fields) {
    Pattern pattern;
    pattern.panels.resize(2);
    pattern.panels[1].fabric = "denim";
    pattern.panels[1].interlinings = {"linen", "canvas"};
    pattern.panels[1].edges = {{.topstitch = Topstitch{.thread = {.colour = "#102030"}}}, {}};
    std::vector<std::string> fabrics, colours;
    int parts = 0;
    visit_values(pattern, [&]<class T>(const auto& field, T& value) {
        parts += Described<T> ? 1 : 0;
        if constexpr (std::is_same_v<T, std::string>) {
            if (field.measure == Measure::Fabric) fabrics.push_back(value);
            if (field.measure == Measure::Colour) colours.push_back(value);
        }
    });
    EXPECT_EQ(fabrics, (std::vector<std::string>{"", "denim", "linen", "canvas", ""}));
    EXPECT_EQ(colours, std::vector<std::string>{"#102030"});
    EXPECT_EQ(parts, 8) << "two panels, two edges with their keys, a topstitch and its thread";
}

Panel marked_panel() {
    Panel panel;
    panel.vertices = {{0, 0}, {0.4, 0}, {0.4, 0.3}};
    panel.edges = {{.start = 0, .end = 1, .label = "hem", .allowance = 0.02},
                   {.start = 1, .end = 2, .kind = CurveKind::Arc, .arc_radius = 0.3},
                   {.start = 2, .end = 0, .allowance_corner = AllowanceCorner::Squared}};
    panel.grain_angle = 0.25;
    panel.sett_offset = {0.01, 0.02};
    panel.notches = {{.edge = 1, .t = 0.25, .kind = NotchKind::V}};
    panel.internal_lines = {{.name = "fold", .points = {{0.1, 0.05}, {0.2, 0.1}}, .use = LineUse::Fold}};
    panel.drill_points = {{0.3, 0.1}};
    panel.wrap_cone = WrapCone{.apex = {0.5, 0.25}, .sine = 0.5};
    panel.mirror_of = "other";
    return panel;
}

TEST(FieldMoves, mirroring_or_flipping_twice_gives_the_panel_back) {
    const Eigen::Affine2d mirror(Eigen::Scaling(-1.0, 1.0));
    Panel panel = mapped_panel(mapped_panel(marked_panel(), mirror), mirror);
    EXPECT_EQ(panel, marked_panel());
    flip_fields(panel);
    EXPECT_EQ(panel.grain_angle, -0.25);
    EXPECT_EQ(panel.wrap_cone->apex, Vec2d(-0.5, 0.25));
    EXPECT_EQ(panel.internal_lines[0].points[1], Vec2d(-0.2, 0.1));
    EXPECT_EQ(panel.sett_offset, Vec2d(0.01, 0.02));
    EXPECT_EQ(panel.notches, marked_panel().notches);
    flip_fields(panel);
    EXPECT_EQ(panel, marked_panel());
}

TEST(FieldMoves, mirroring_changes_points_notches_and_directions_of_a_panel) {
    const Panel panel = mapped_panel(marked_panel(), Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    EXPECT_EQ(panel.sett_offset, Vec2d(-0.01, 0.02));
    EXPECT_EQ(panel.notches[0], (Notch{.edge = 2, .t = 0.75, .kind = NotchKind::V}));
    EXPECT_EQ(panel.drill_points[0], Vec2d(-0.3, 0.1));
    EXPECT_NEAR(panel.grain_angle, -0.25, 1e-15);
    EXPECT_EQ(panel.edges[0].allowance, 0.02);
    EXPECT_EQ(panel.edges[1].allowance_corner, AllowanceCorner::Squared) << "edge 2, reversed";
}

TEST(FieldMoves, turning_changes_directions_and_keeps_lengths) {
    const Panel panel = mapped_panel(marked_panel(), Eigen::Affine2d(Eigen::Rotation2Dd(0.5)));
    EXPECT_NEAR(panel.grain_angle, 0.75, 1e-12);
    EXPECT_EQ(panel.sett_offset, Vec2d(0.01, 0.02));
    EXPECT_EQ(panel.notches, marked_panel().notches);
    EXPECT_FALSE(panel.wrap_cone);
}

TEST(FieldMoves, copies_lose_their_names_and_replacements_keep_them) {
    const Seam seam{.first = {0, 1}, .second = {1, 2}, .name = "side", .is_eased = true, .sewing = "all"};
    Seam copy = copy_of(seam);
    EXPECT_EQ(copy, (Seam{.first = {0, 1}, .second = {1, 2}, .is_eased = true}));
    keep_names(copy, seam);
    EXPECT_EQ(copy, seam);
    OutlineEdge edge{.start = 4, .end = 5};
    keep_properties(edge, marked_panel().edges[0]);
    EXPECT_EQ(edge, (OutlineEdge{.start = 4, .end = 5, .label = "hem", .allowance = 0.02}));
}

TEST(FieldMoves, taking_a_placement_copies_its_fields_and_no_others) {
    Panel panel = marked_panel(), placed = marked_panel();
    placed.translation = {0, 1, 0.2};
    placed.rotation = Eigen::AngleAxisd(0.5, Vec3d::UnitY()).matrix();
    placed.is_mirrored = true;
    placed.wrap_radius = 0.1;
    placed.layer = 3;
    EXPECT_FALSE(has_same_placement(panel, placed));
    take_placement(panel, placed);
    EXPECT_TRUE(has_same_placement(panel, placed));
    EXPECT_EQ(panel.layer, 0);
    panel.layer = 3;
    EXPECT_EQ(panel, placed);
    take_placement(panel, {});
    EXPECT_FALSE(panel.wrap_cone);
    EXPECT_TRUE(panel.rotation.isIdentity());
}

TEST(FieldMoves, taking_changes_copies_values_that_are_not_defaults) {
    Notch notch{.edge = 4, .t = 0.25, .kind = NotchKind::V};
    take_changes(notch, Notch{.t = 0.75, .count = 2});
    EXPECT_EQ(notch, (Notch{.edge = 4, .t = 0.75, .kind = NotchKind::V, .count = 2}));
}

TEST(FieldMoves, outlines_are_equal_when_only_labels_and_allowances_differ) {
    Panel panel = marked_panel();
    panel.edges[0].allowance = 0.03;
    panel.edges[1].label = "side";
    EXPECT_TRUE(has_same_outline(panel, marked_panel()));
    panel.edges[1].arc_radius = 0.4;
    EXPECT_FALSE(has_same_outline(panel, marked_panel()));
}

}  // namespace
}  // namespace selvedge::sim
