#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

#include "editor/geometry/draft.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/pattern_fields.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

// A panel with a number in each of its fields.
sim::Panel full_square() {
    sim::Panel panel = unit_square();
    panel.edges[0] = {.end = 1, .allowance = 0.02, .topstitch = sim::Topstitch()};
    panel.internal_lines = {{.name = "fold", .points = {{0.2, 0.2}, {0.8, 0.2}}, .topstitch = sim::Topstitch()}};
    panel.notches = {{.edge = 1, .t = 0.25}};
    panel.drill_points = {{0.5, 0.5}};
    panel.allowance = 0.01;
    panel.wrap_cone = sim::WrapCone();
    panel.sheet_position = Vec2d(1, 2);
    return panel;
}

// Puts the number in place of the one that is visited as the `nth`. False: there are fewer.
bool put(sim::Panel& panel, int nth, double number, std::string_view& field_name) {
    bool is_put = false;
    visit_values(panel, [&]<class T>(const auto& field, T& value) {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vec2d> || std::is_same_v<T, Vec3d>) {
            if (nth-- != 0) return;
            if constexpr (std::is_same_v<T, double>) {
                value = number;
            } else {
                value.y() = number;
            }
            field_name = field.name;
            is_put = true;
        }
    });
    return is_put;
}

TEST(CheckPanel, refuses_each_number_that_is_not_finite) {
    EXPECT_NO_THROW(check_panel(full_square()));
    int count = 0;
    for (;; ++count) {
        sim::Panel panel = full_square();
        std::string_view name;
        if (!put(panel, count, std::numeric_limits<double>::quiet_NaN(), name)) break;
        if (name == "radius") continue;  // only arcs have one
        EXPECT_THROW(check_panel(panel), GeometryError) << name;
    }
    EXPECT_GT(count, 25);
}

TEST(CheckPanel, refuses_lengths_and_points_beyond_100_m_and_takes_other_numbers) {
    for (const auto& [is_far, change] :
         {std::pair<bool, void (*)(sim::Panel&)>{true, [](sim::Panel& panel) { panel.translation.z() = 101; }},
          {true, [](sim::Panel& panel) { panel.drill_points[0].x() = -101; }},
          {true, [](sim::Panel& panel) { panel.internal_lines[0].topstitch->distances.x() = 101; }},
          {false, [](sim::Panel& panel) { panel.grain_angle = 101; }}}) {
        sim::Panel panel = full_square();
        change(panel);
        if (is_far) {
            EXPECT_THROW(check_panel(panel), GeometryError);
        } else {
            EXPECT_NO_THROW(check_panel(panel));
        }
    }
}

}  // namespace
}  // namespace selvedge::editor
