#include <gtest/gtest.h>
#include <algorithm>
#include <array>

#include "editor/geometry/linked_panels.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/seam_edit.h"
#include "sim/pattern/edge_shape.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

// A rotated, wrapped sleeve with every kind of curve.
sim::Panel sleeve(bool is_mirrored) {
    sim::Panel panel = make_polygon({{0, 0}, {0.3, 0}, {0.4, 0.5}, {0.1, 0.7}, {-0.1, 0.5}});
    panel.name = "left_sleeve";
    panel.edges[0].kind = sim::CurveKind::Arc;
    panel.edges[0].arc_radius = 0.3;
    panel.edges[2] = {
        .start = 2, .end = 3, .kind = sim::CurveKind::Cubic, .control = {Vec2d(0.4, 0.6), Vec2d(0.2, 0.8)}};
    panel.edges[3] = {
        .start = 3, .end = 4, .kind = sim::CurveKind::Quadratic, .control = {Vec2d(0, 0.75), Vec2d(0, 0)}};
    panel.translation = {0.4, 1.1, 0.05};
    panel.rotation = (Eigen::AngleAxisd(0.8, Vec3d(1, 2, -1).normalized())).toRotationMatrix();
    panel.is_mirrored = is_mirrored;
    panel.wrap_radius = 0.2;
    panel.grain_angle = 0.1;
    panel.sett_offset = {0.03, 0.05};
    panel.notches = {{.edge = 2, .t = 0.25}};
    panel.pins = {3};
    panel.internal_lines = {{.name = "hem", .points = {{0.05, 0.1}, {0.25, 0.1}}}};
    return panel;
}

sim::Pattern with_sleeve(bool is_mirrored) {
    sim::Pattern pattern;
    pattern.panels = {sleeve(is_mirrored)};
    return pattern;
}

Vec3d across(const Vec3d& x) {
    return {-x.x(), x.y(), x.z()};
}

Vec3d outward(const sim::Panel& panel, const Vec2d& u) {
    const double h = 1e-5;
    return (panel.place(u + Vec2d(h, 0)) - panel.place(u - Vec2d(h, 0)))
        .cross(panel.place(u + Vec2d(0, h)) - panel.place(u - Vec2d(0, h)))
        .normalized();
}

TEST(SymmetricCopy, stands_on_the_other_side_of_the_body_and_looks_outward_there) {
    for (const bool is_mirrored : {false, true}) {
        sim::Pattern pattern = with_sleeve(is_mirrored);
        EXPECT_EQ(symmetric_copy(pattern, 0, false, {1, 0}), 1);
        const sim::Panel& own = pattern.panels[0];
        const sim::Panel& copy = pattern.panels[1];
        EXPECT_EQ(copy.name, "right_sleeve");
        EXPECT_EQ(copy.mirror_of, "");
        EXPECT_EQ(copy.is_mirrored, is_mirrored);
        EXPECT_NEAR(outline_area(copy), outline_area(own), 1e-9);
        EXPECT_NEAR(copy.rotation.determinant(), 1, 1e-12);
        for (const Vec2d& u : {Vec2d(0.1, 0.2), Vec2d(-0.05, 0.5), Vec2d(0.3, 0.4)}) {
            const Vec2d image(-u.x(), u.y());
            EXPECT_NEAR((copy.place(image) - across(own.place(u))).norm(), 0, 1e-12);
            EXPECT_NEAR((outward(copy, image) - across(outward(own, u))).norm(), 0, 1e-6);
        }
        for (int e = 0; e < 5; ++e) {
            const auto own_edge = static_cast<std::size_t>(e);
            const auto edge = static_cast<std::size_t>((5 - e) % 5);
            for (const double t : {0.0, 0.3, 0.8}) {
                const Vec2d there = outline_point(copy, copy.edges[edge], 1 - t);
                const Vec2d here = outline_point(own, own.edges[own_edge], t);
                EXPECT_NEAR((there - Vec2d(-here.x(), here.y())).norm(), 0, 1e-9);
            }
        }
        EXPECT_NEAR(copy.grain_angle, -0.1, 1e-15);
        EXPECT_EQ(copy.sett_offset, Vec2d(-0.03, 0.05));
        EXPECT_EQ(copy.notches, (std::vector<sim::Notch>{{3, 0.75}}));
        EXPECT_EQ(copy.pins, std::vector<int>{3});
        EXPECT_TRUE(can_be_saved(pattern));
    }
}

TEST(SymmetricCopy, lies_on_the_sheet_where_the_panel_lies_moved_by_the_shift) {
    sim::Pattern pattern = with_sleeve(false);
    symmetric_copy(pattern, 0, true, {1, 0.25});
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    const auto low = [&](std::size_t i) {
        double least = 100;
        for (const Vec2d& p : pattern.panels[i].vertices) least = std::min(least, p.x() + origins[i].x());
        return least;
    };
    EXPECT_NEAR(low(1), low(0) + 1, 1e-3);
    EXPECT_NEAR(origins[1].y(), origins[0].y() + 0.25, 1e-12);
}

TEST(SymmetricCopy, takes_darts_and_no_seam_to_a_panel_without_an_image) {
    sim::Pattern pattern = two_squares();
    insert_dart(pattern, {0, 0}, 0.3, 0.1, 0.4);
    symmetric_copy(pattern, 0, false, {0, 0});
    ASSERT_EQ(pattern.seams.size(), 3U);
    const sim::Seam& dart = pattern.seams[2];
    EXPECT_EQ(dart.first.panel, 2);
    EXPECT_EQ(dart.second.panel, 2);
    EXPECT_TRUE(edge_point(pattern, dart.first, 0).isApprox(edge_point(pattern, dart.second, 1)));  // the apex
    EXPECT_FALSE(is_crossed(pattern, dart));
}

// The place of a seam's side in the world, m, at both its ends and in its middle.
std::array<Vec3d, 3> places_of(const sim::Pattern& pattern, const sim::SeamSide& side) {
    const sim::Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
    return {panel.place(edge_point(pattern, side, 0)), panel.place(edge_point(pattern, side, 0.5)),
            panel.place(edge_point(pattern, side, 1))};
}

// Whether one side is the other one's reflection, end for start.
bool is_reflected(const sim::Pattern& pattern, const sim::SeamSide& one, const sim::SeamSide& other) {
    const std::array<Vec3d, 3> here = places_of(pattern, one), there = places_of(pattern, other);
    return (across(here[0]) - there[2]).norm() < 1e-3 && (across(here[1]) - there[1]).norm() < 1e-3 &&
           (across(here[2]) - there[0]).norm() < 1e-3;
}

// The sewing of the other side of the T-shirt comes back when its sleeve is copied.
TEST(SymmetricCopy, of_a_sleeve_is_sewn_to_the_other_armholes) {
    sim::Pattern pattern = shipped_pattern("tshirt");
    const std::size_t whole = pattern.seams.size();
    remove_panels(pattern, {find_panel(pattern, "right_sleeve_front"), find_panel(pattern, "right_sleeve_back")});
    const std::vector<int> sleeve{find_panel(pattern, "left_sleeve_front"), find_panel(pattern, "left_sleeve_back")};
    const auto is_of_sleeve = [&](const sim::SeamSide& side) {
        return side.panel == sleeve[0] || side.panel == sleeve[1];
    };
    for (sim::Seam& seam : pattern.seams) seam.is_eased = is_of_sleeve(seam.first) && !is_of_sleeve(seam.second);
    const std::vector<sim::Seam> before = pattern.seams;
    EXPECT_EQ(symmetric_copies(pattern, sleeve, true, {1, 0}).size(), 2U);
    EXPECT_EQ(pattern.seams.size(), whole);
    for (std::size_t i = before.size(); i < pattern.seams.size(); ++i) {
        const sim::Seam& seam = pattern.seams[i];
        EXPECT_TRUE(std::any_of(before.begin(), before.end(), [&](const sim::Seam& other) {
            return seam.is_reversed == other.is_reversed && seam.is_eased == other.is_eased &&
                   is_reflected(pattern, seam.first, other.first) && is_reflected(pattern, seam.second, other.second);
        })) << i;
    }
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(SymmetricCopy, of_several_panels_takes_the_seams_among_them_and_mirrors_them_together_on_the_sheet) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].sheet_position = Vec2d(0, 0);
    pattern.panels[1].sheet_position = Vec2d(1.1, 0);
    pattern.seams[0] = {.first = {0, 1}, .second = {1, 3}, .is_reversed = false, .name = "middle", .is_eased = true};
    EXPECT_EQ(symmetric_copies(pattern, {0, 1}, false, {3, 0}), (std::vector<int>{2, 3}));
    ASSERT_EQ(pattern.seams.size(), 2U);
    EXPECT_EQ(pattern.seams[1], (sim::Seam{.first = {2, 3}, .second = {3, 1}, .is_reversed = false, .is_eased = true}));
    const auto left_side = [&](std::size_t i) {
        return outline_box(pattern.panels[i]).min().x() + pattern.panels[i].sheet_position->x();
    };
    EXPECT_NEAR(left_side(3), 3, 1e-9);
    EXPECT_NEAR(left_side(2), 4.1, 1e-9) << "the one on the left is now on the right";
}

TEST(SymmetricCopy, is_sewn_to_the_mirror_image_of_what_the_panel_is_sewn_to) {
    sim::Pattern pattern;
    pattern.panels = {unit_square("left_front"), unit_square("left_pocket")};
    symmetric_copy(pattern, 0, true, {0, 0});
    sew_edges(pattern, {{1, 0}, {0, 1}, true, "pocket"});
    symmetric_copy(pattern, 1, true, {0, 0});
    ASSERT_EQ(pattern.seams.size(), 2U);
    EXPECT_EQ(pattern.seams[1], (sim::Seam{{3, 0}, {2, 3}}));
}

TEST(SymmetricCopy, leaves_seams_alone_that_are_there) {
    sim::Pattern pattern;
    sim::Panel front = make_rectangle({-0.5, 0}, {0.5, 1});
    front.name = "front";
    pattern.panels = {front, unit_square("left_sleeve"), unit_square("other")};
    pattern.panels[1].translation.x() = 1;
    sew_edges(pattern, {{1, 3}, {0, 1}, true, "armhole"});
    sim::Pattern is_free = pattern;
    symmetric_copy(is_free, 1, true, {0, 0});
    ASSERT_EQ(is_free.seams.size(), 2U);
    EXPECT_EQ(is_free.seams[1], (sim::Seam{{3, 1}, {0, 3}}));
    sew_edges(pattern, {{2, 0}, {0, 3}, true, "sewn"});
    symmetric_copy(pattern, 1, true, {0, 0});
    EXPECT_EQ(pattern.seams.size(), 2U);
}

TEST(SymmetricCopy, of_a_panel_that_is_sewn_to_one_at_the_side_is_not_sewn_to_its_other_edge) {
    for (const double aside : {0.0, 0.5}) {
        sim::Pattern pattern;
        sim::Panel cuff = make_rectangle({-0.5, 0}, {0.5, 1});
        cuff.name = "left_cuff";
        cuff.translation.x() = aside;
        pattern.panels = {cuff, unit_square("left_placket")};
        sew_edges(pattern, {{1, 3}, {0, 1}});
        symmetric_copy(pattern, 1, true, {0, 0});
        EXPECT_EQ(pattern.seams.size(), aside == 0.0 ? 2U : 1U) << aside;
    }
}

TEST(SymmetricCopy, of_a_linked_image_is_not_linked) {
    sim::Pattern pattern = with_sleeve(false);
    symmetric_copy(pattern, 0, true, {1, 0});
    EXPECT_EQ(pattern.panels[1].mirror_of, "left_sleeve");
    EXPECT_THROW(symmetric_copy(pattern, 1, true, {1, 0}), GeometryError);
    EXPECT_EQ(symmetric_copy(pattern, 1, false, {1, 0}), 2);
    EXPECT_EQ(pattern.panels[2].name, "left_sleeve_2");
    EXPECT_TRUE(pattern.panels[2].vertices == pattern.panels[0].vertices);
    EXPECT_TRUE(pattern.panels[2].edges == pattern.panels[0].edges);
}

// Expects panels 0 and `image` to be mirror images, as symmetric_copy makes them.
void expect_mirrored(const sim::Pattern& pattern, int image) {
    sim::Pattern fresh;
    fresh.panels = {pattern.panels[0]};
    symmetric_copy(fresh, 0, false, {0, 0});
    const sim::Panel& expected = fresh.panels[1];
    const sim::Panel& found = pattern.panels[static_cast<std::size_t>(image)];
    for (std::size_t i = 0; i < std::min(expected.vertices.size(), found.vertices.size()); ++i) {
        EXPECT_NEAR((expected.vertices[i] - found.vertices[i]).norm(), 0, 1e-12);
    }
    ASSERT_EQ(found.edges.size(), expected.edges.size());
    for (std::size_t e = 0; e < found.edges.size(); ++e) {
        EXPECT_NEAR(
            (outline_point(found, found.edges[e], 0.3) - outline_point(expected, expected.edges[e], 0.3)).norm(), 0,
            1e-9);
    }
    EXPECT_TRUE(found.translation.isApprox(expected.translation));
    EXPECT_TRUE(found.rotation.isApprox(expected.rotation));
    EXPECT_NEAR(found.grain_angle, expected.grain_angle, 1e-12);
    EXPECT_EQ(found.notches.size(), expected.notches.size());
    EXPECT_EQ(found.internal_lines.size(), expected.internal_lines.size());
}

// A bodice with two linked sleeves, sewn to it by edge 2 of the one and the image of edge 2 of the other.
sim::Pattern sleeved() {
    sim::Pattern pattern = with_sleeve(false);
    symmetric_copy(pattern, 0, true, {1, 0});
    sim::Panel bodice = unit_square("bodice");
    const double length = outline_length(pattern.panels[0], pattern.panels[0].edges[2]);
    bodice = make_rectangle({0, 0}, {0.5, length});
    bodice.name = "bodice";
    add_panel(pattern, bodice);
    sew_edges(pattern, {{0, 2}, {2, 3}, true, "left armhole"});
    sew_edges(pattern, {{1, 3}, {2, 1}, true, "right armhole"});
    return pattern;
}

template <class Edit>
sim::Pattern edited(const sim::Pattern& before, Edit edit) {
    sim::Pattern pattern = before;
    edit(pattern);
    update_links(pattern, before);
    EXPECT_TRUE(can_be_saved(pattern));
    return pattern;
}

TEST(UpdateLinks, whichever_side_was_edited_leads) {
    for (const int side : {0, 1}) {
        const sim::Pattern before = sleeved();
        const sim::Pattern pattern = edited(before, [&](sim::Pattern& draft) {
            move_vertices(draft, side, {4}, {0.02, -0.03});
        });
        const double sign = side == 0 ? 1 : -1;
        EXPECT_TRUE(pattern.panels[0].vertices[4].isApprox(Vec2d(-0.1 + sign * 0.02, 0.47)));
        EXPECT_TRUE(pattern.panels[1].vertices[4].isApprox(Vec2d(0.1 - sign * 0.02, 0.47)));
        expect_mirrored(pattern, 1);
        EXPECT_EQ(pattern.panels[0].name, "left_sleeve");
        EXPECT_EQ(pattern.panels[0].mirror_of, "");
        EXPECT_EQ(pattern.panels[1].mirror_of, "left_sleeve");
        EXPECT_EQ(pattern.panels[1].sheet_position, before.panels[1].sheet_position);
        EXPECT_EQ(pattern.seams, before.seams);
    }
}

TEST(UpdateLinks, give_a_new_copy_the_edit_of_its_source_when_one_command_makes_both) {
    sim::Pattern before = with_sleeve(false);
    symmetric_copy(before, 0, true, {1, 0});
    for (const int place : {0, 1, 2}) {
        const int image = place < 2 ? 2 : 1;
        const sim::Pattern pattern = edited(before, [&](sim::Pattern& draft) {
            sim::Panel copy = draft.panels[0];
            copy.name = "third_sleeve";
            copy.copy_of = "left_sleeve";
            draft.panels.insert(draft.panels.begin() + place, copy);
            move_vertices(draft, image, {4}, {0.02, -0.03});
        });
        for (std::size_t i = 0; i < 3; ++i) {
            const double side = static_cast<int>(i) == image ? -1 : 1;
            EXPECT_TRUE(pattern.panels[i].vertices[4].isApprox(Vec2d(side * -0.12, 0.47))) << place << " " << i;
        }
    }
}

TEST(UpdateLinks, placement_grain_notches_and_lines_follow) {
    const sim::Pattern pattern = edited(sleeved(), [](sim::Pattern& draft) {
        sim::Panel& panel = draft.panels[1];
        panel.translation = {-0.5, 1.3, 0.1};
        panel.grain_angle = 0.5;
        panel.notches.push_back({.edge = 0, .t = 0.2});
        panel.internal_lines.clear();
    });
    EXPECT_TRUE(pattern.panels[0].translation.isApprox(Vec3d(0.5, 1.3, 0.1)));
    EXPECT_NEAR(pattern.panels[0].grain_angle, -0.5, 1e-12);
    EXPECT_EQ(pattern.panels[0].notches.back(), (sim::Notch{.edge = 0, .t = 0.8}));
    EXPECT_TRUE(pattern.panels[0].internal_lines.empty());
}

TEST(UpdateLinks, splits_the_image_and_the_edge_sewn_to_it_when_an_edge_is_split) {
    for (const int side : {0, 1}) {
        for (const int own_edge : {0, 2, 3, 4}) {
            const int edge = side == 0 ? own_edge : (5 - own_edge) % 5;
            const sim::Pattern pattern = edited(sleeved(), [&](sim::Pattern& draft) {
                split_edge(draft, {side, edge}, 0.25);
            });
            expect_mirrored(pattern, 1);
            ASSERT_EQ(pattern.panels[1].edges.size(), 6U);
            const std::size_t sewn = own_edge == 2 ? 4 : 2;
            ASSERT_EQ(pattern.seams.size(), sewn);
            for (const sim::Seam& seam : pattern.seams) {
                EXPECT_NEAR(edge_length(pattern, seam.first), edge_length(pattern, seam.second), 1e-9);
                EXPECT_EQ(edge_point(pattern, seam.first, 0.5).y() > 0.5, true);  // still on the sleeve head
            }
            EXPECT_EQ(pattern.panels[2].edges.size(), own_edge == 2 ? 6U : 4U);
        }
    }
}

TEST(UpdateLinks, a_point_taken_out_is_taken_out_of_both) {
    const sim::Pattern whole = sleeved();
    int vertex = 0;
    const sim::Pattern split = edited(whole, [&](sim::Pattern& draft) { vertex = split_edge(draft, {0, 2}, 0.25); });
    const sim::Pattern pattern = edited(split, [&](sim::Pattern& draft) { remove_vertices(draft, 0, {vertex}); });
    expect_mirrored(pattern, 1);
    EXPECT_EQ(pattern.panels[0].edges.size(), 5U);
    EXPECT_EQ(pattern.panels[2].edges.size(), 4U);
    EXPECT_EQ(pattern.panels[2].vertices.size(), 4U);
    ASSERT_EQ(pattern.seams.size(), 2U);
    EXPECT_EQ(pattern.seams[0], whole.seams[0]);
    EXPECT_EQ(pattern.seams[1], whole.seams[1]);
}

TEST(UpdateLinks, a_dart_is_sewn_on_both) {
    const sim::Pattern pattern = edited(sleeved(), [](sim::Pattern& draft) {
        insert_dart(draft, {1, 4}, 0.5, 0.03, 0.1);
    });
    expect_mirrored(pattern, 1);
    ASSERT_EQ(pattern.seams.size(), 4U);
    for (const sim::Seam& seam : pattern.seams) {
        EXPECT_NEAR(edge_length(pattern, seam.first), edge_length(pattern, seam.second), 1e-9);
    }
}

TEST(UpdateLinks, halves_that_are_sewn_to_each_other_keep_their_seam) {
    sim::Pattern halves;
    halves.panels = {unit_square("left_front")};
    symmetric_copy(halves, 0, true, {0, 0});
    sew_edges(halves, {{0, 3}, {1, 1}, true, "centre"});
    for (const int side : {0, 1}) {
        sim::Pattern pattern = edited(halves, [&](sim::Pattern& draft) {
            split_edge(draft, {side, side == 0 ? 3 : 1}, 0.25);
        });
        expect_mirrored(pattern, 1);
        ASSERT_EQ(pattern.seams.size(), 2U);
        for (const sim::Seam& seam : pattern.seams) {
            EXPECT_NEAR(edge_length(pattern, seam.first), edge_length(pattern, seam.second), 1e-9);
            EXPECT_NEAR(edge_point(pattern, seam.first, 0).y(), edge_point(pattern, seam.second, 1).y(), 1e-9);
        }
        pattern = edited(pattern, [&](sim::Pattern& draft) { remove_vertices(draft, side, {4}); });
        EXPECT_EQ(pattern.seams, halves.seams);
        EXPECT_EQ(pattern.panels[1].edges.size(), 4U);
    }
}

// Sewn around a corner: a split of one panel splits the other at a different edge, which splits the first again.
TEST(UpdateLinks, ends_where_splits_would_go_on_for_ever) {
    sim::Pattern before;
    before.panels = {unit_square("left_front")};
    symmetric_copy(before, 0, true, {0, 0});
    sew_edges(before, {{0, 0}, {1, 3}, true});
    sew_edges(before, {{0, 1}, {1, 0}, true});
    sew_edges(before, {{0, 2}, {1, 1}, true});
    sim::Pattern pattern = before;
    split_edge(pattern, {0, 0}, 0.3);
    const sim::Pattern split = pattern;
    try {
        update_links(pattern, before);
        EXPECT_TRUE(can_be_saved(pattern));
        EXPECT_LT(pattern.panels[0].edges.size(), 30U);
    } catch (const GeometryError&) {
        EXPECT_TRUE(pattern == split);
    }
}

TEST(UpdateLinks, panels_that_are_not_linked_stay) {
    sim::Pattern before = two_squares();
    sim::Pattern pattern = before;
    move_vertices(pattern, 0, {0}, {0.1, 0.1});
    const sim::Pattern moved = pattern;
    update_links(pattern, before);
    EXPECT_TRUE(pattern == moved);
}

TEST(UpdateLinks, cutting_an_image_ends_its_link) {
    sim::Pattern pattern = sleeved();
    const sim::Pattern before = pattern;
    cut_panel(pattern, 1, {{-0.15, -0.1}, {-0.15, 0.8}}, true);
    EXPECT_EQ(pattern.panels[1].mirror_of, "");
    update_links(pattern, before);
    EXPECT_EQ(pattern.panels[0].edges.size(), 5U);
    EXPECT_TRUE(can_be_saved(pattern));
}

}  // namespace

}  // namespace selvedge::editor
