#include <gtest/gtest.h>

#include "editor/sheet/panel_faces.h"
#include "sim/pattern/outline.h"
#include "sim/tartan/tartan_file.h"
#include "tests/editor/sheet/sheet_support.h"

namespace selvedge::editor {
namespace {

double area_of(const PanelFace& face) {
    double area = 0;
    for (const auto& [a, b, c] : face.triangles) {
        const Vec2d &p = face.points[std::size_t(a)], &q = face.points[std::size_t(b)],
                    &r = face.points[std::size_t(c)];
        area += sim::cross2(q - p, r - p) / 2;
    }
    return area;
}

TEST(PanelFaces, triangles_fill_the_outline_of_every_shipped_panel) {
    for (const char* name : {"tshirt", "skirt", "poncho"}) {
        for (const sim::Panel& panel : shipped_pattern(name).pattern.panels) {
            const PanelFace face = make_face(panel, 1e-4);
            EXPECT_NEAR(area_of(face), outline_area(panel), 1e-3 * outline_area(panel)) << panel.name;
        }
    }
}

TEST(PanelFaces, edges_of_a_face_end_where_the_next_begin) {
    const sim::Panel panel = shipped_pattern("tshirt").pattern.panels.at(0);
    const PanelFace face = make_face(panel, 1e-3);
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
        EXPECT_EQ(edge_points(face, i).back(), edge_points(face, (i + 1) % panel.edges.size()).front());
    }
}

TEST(PanelFaces, an_outline_that_crosses_itself_has_no_triangles) {
    sim::Panel panel;
    panel.vertices = {{0, 0}, {0.1, 0.1}, {0.1, 0}, {0, 0.1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    EXPECT_TRUE(make_face(panel, 1e-3).triangles.empty());
}

TEST(PanelFaces, come_finer_as_one_comes_near) {
    const sim::PatternDocument source = shipped_pattern("tshirt");
    SheetGeometry geometry;
    geometry.update(source.pattern, 1);
    PanelFaces faces;
    faces.begin_frame(geometry);
    const std::size_t far = faces.face(geometry.panels()[0], 200).points.size();
    EXPECT_GT(faces.face(geometry.panels()[0], 20000).points.size(), far);
}

constexpr render::Rgba8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};

sim::Sett checks() {
    return sim::parse_threadcount("A=#000000; B=#FFFFFF; A16 B16");
}

TEST(SettPicture, one_repeat_shows_each_stripe_where_it_crosses_itself) {
    const render::Image picture = sett_tile(checks(), 64);
    ASSERT_EQ(picture.width_px, 64);
    ASSERT_EQ(picture.height_px, 64);
    EXPECT_EQ(picture.at(8, 8), kBlack);
    EXPECT_EQ(picture.at(40, 40), kWhite);
}

TEST(SettPicture, threads_of_both_are_seen_where_they_cross_and_mix_from_afar) {
    const render::Image near = sett_tile(checks(), 64);
    bool has_black = false, has_white = false;
    for (int y = 4; y < 20; ++y) {
        for (int x = 40; x < 56; ++x) {
            has_black |= near.at(x, y) == kBlack;
            has_white |= near.at(x, y) == kWhite;
        }
    }
    EXPECT_TRUE(has_black && has_white);
    const render::Rgba8 mixed = sett_tile(checks(), 32).at(24, 8);
    EXPECT_NEAR(mixed[0], 188, 1) << "half the light, in sRGB";
}

TEST(SettPicture, has_the_proportions_of_warp_and_weft) {
    const sim::Sett sett = sim::parse_threadcount("K24 W8 weft: K8 W8");
    EXPECT_EQ(sett_tile(sett, 64).height_px, 32);
}

TEST(SettPicture, sizes_are_powers_of_two_that_the_screen_has_use_for) {
    EXPECT_EQ(sett_tile_side(3), 32);
    EXPECT_EQ(sett_tile_side(100), 128);
    EXPECT_EQ(sett_tile_side(1e9), 1024);
}

}  // namespace

}  // namespace selvedge::editor
