// The sheet as a person sees it, in the states that matter: what is there has its colour, where it stands. With
// SELVEDGE_SHEET_PICTURES naming a folder the pictures are written there, to be looked at.
#include <gtest/gtest.h>

#include <cstdlib>

#include "editor/sheet/sheet_paint.h"
#include "editor/sheet/sheet_pen.h"
#include "render/image/image.h"
#include "render/scene/colour.h"
#include "tests/editor/sheet/sheet_support.h"

namespace selvedge::editor {
namespace {

constexpr SheetColours kColours{};

// A picture of the stage as it stands, and where its sheet lies on it.
class SheetPicture {
 public:
    SheetPicture(SheetFixture& stage, const std::string& name) : camera_(stage.view.camera()), image_(stage.picture()) {
        if (const char* folder = std::getenv("SELVEDGE_SHEET_PICTURES")) {
            write_png(std::filesystem::path(folder) / (name + ".png"), image_);
        }
    }

    // Whether a line, darker than any cloth or paper, passes within 4 px of a place on the sheet.
    bool shows_line(const Vec2d& sheet) const {
        constexpr int kReach = 4, kDark = 150;  // px; of 255, the mean of the channels
        const Vec2d px = to_px(camera_, sheet);
        for (int y = int(px.y()) - kReach; y <= int(px.y()) + kReach; ++y)
            for (int x = int(px.x()) - kReach; x <= int(px.x()) + kReach; ++x)
                if (x >= 0 && y >= 0 && x < image_.width_px && y < image_.height_px) {
                    const render::Rgba8& pixel = image_.at(x, y);
                    if (int(pixel[0]) + pixel[1] + pixel[2] < 3 * kDark) return true;
                }
        return false;
    }

    // Whether a pixel of nearly that colour lies within `reach` px of a place on the sheet.
    bool shows(const render::Rgba8& colour, const Vec2d& sheet, int reach = 4) const {
        const Vec2d px = to_px(camera_, sheet);
        for (int y = int(px.y()) - reach; y <= int(px.y()) + reach; ++y)
            for (int x = int(px.x()) - reach; x <= int(px.x()) + reach; ++x)
                if (x >= 0 && y >= 0 && x < image_.width_px && y < image_.height_px && is_near(image_.at(x, y), colour))
                    return true;
        return false;
    }

    int pixels_of(const render::Rgba8& colour) const {
        return int(std::count_if(image_.pixels.begin(), image_.pixels.end(),
                                 [&](const render::Rgba8& pixel) { return is_near(pixel, colour); }));
    }

 private:
    static bool is_near(const render::Rgba8& a, const render::Rgba8& b) {
        constexpr int kNear = 24;  // of 255, per channel: edges are anti-aliased
        for (std::size_t i = 0; i < 3; ++i)
            if (std::abs(int(a[i]) - int(b[i])) > kNear) return false;
        return true;
    }

    SheetCamera camera_;
    render::Image image_;
};

TEST(SheetPictures, the_tshirt_framed) {
    SheetFixture stage(shipped_pattern("tshirt"), {1280, 800, 1});
    stage.move({0.1, 0.1});
    const SheetPicture picture(stage, "tshirt");
    for (const sim::Panel& panel : stage.document.pattern().panels)
        for (int edge = 0; edge < int(panel.edges.size()); ++edge) {
            const Vec2d middle = stage.on_edge(panel.name, edge, 0.37);
            EXPECT_TRUE(picture.shows_line(middle)) << panel.name << " " << edge;
        }
    EXPECT_EQ(picture.pixels_of(kColours.error), 0) << "no seam of it is uneven";
}

TEST(SheetPictures, an_armhole_with_selection_and_handles) {
    SheetFixture stage(shipped_pattern("tshirt"));
    SheetCamera camera = stage.view.camera();
    camera.centre = stage.on_edge("front", 2, 0.5);
    camera.scale = 2600;
    stage.view.set_camera(camera);
    stage.key(key_of('Z'));
    stage.move(stage.on_edge("front", 2, 0.5));
    EXPECT_FALSE(SheetPicture(stage, "armhole_before").shows(kColours.accent, stage.on_edge("front", 2, 0.3)));
    stage.click(stage.on_edge("front", 2, 0.5));
    stage.move(stage.vertex("front", 2));
    const SheetPicture picture(stage, "armhole");
    EXPECT_TRUE(picture.shows(kColours.accent, stage.on_edge("front", 2, 0.3))) << "the selected edge";
    EXPECT_TRUE(picture.shows(kColours.handle, stage.vertex("front", 2), 8)) << "a handle at its end";
}

TEST(SheetPictures, a_hidden_panel_and_its_seams_are_not_drawn) {
    SheetFixture stage(shipped_pattern("two_squares"));
    const sim::Pattern& pattern = stage.document.pattern();
    const std::string kept = pattern.panels[0].name, hidden = pattern.panels[1].name;
    const sim::Rgb8 kind = render::line_colour(0);
    const render::Rgba8 seam{kind[0], kind[1], kind[2], 255};
    const auto shows_outline = [&](const SheetPicture& picture, const std::string& name) {
        return picture.shows_line(stage.on_edge(name, 0, 0.37)) || picture.shows_line(stage.on_edge(name, 1, 0.37));
    };
    stage.frame();
    const SheetPicture before(stage, "all_panels");
    EXPECT_TRUE(shows_outline(before, kept) && shows_outline(before, hidden));
    EXPECT_GT(before.pixels_of(seam), 0);
    stage.document.set_panel_states({.hidden = {hidden}, .locked = {}});
    stage.hover = {.panel = hidden};
    stage.frame();
    const SheetPicture after(stage, "hidden_panel");
    EXPECT_TRUE(shows_outline(after, kept));
    EXPECT_FALSE(shows_outline(after, hidden));
    EXPECT_EQ(after.pixels_of(seam), 0);
}

TEST(SheetPictures, a_locked_panel_has_a_faint_outline) {
    SheetFixture stage(shipped_pattern("two_squares"));
    const std::string name = stage.document.pattern().panels[0].name;
    stage.shows.seams = stage.shows.cloth = false;
    stage.document.set_panel_states({.hidden = {}, .locked = {name}});
    stage.frame();
    const SheetPicture picture(stage, "locked_panel");
    EXPECT_FALSE(picture.shows_line(stage.on_edge(name, 0, 0.37)));
    EXPECT_TRUE(picture.shows_line(stage.on_edge(stage.document.pattern().panels[1].name, 0, 0.37)));
}

// Below the lower edge of a square, outside of it, by its allowance.
TEST(SheetPictures, an_allowance_shows_as_the_cut_line) {
    SheetFixture stage(shipped_pattern("two_squares"));
    const std::string name = stage.document.pattern().panels[0].name;
    stage.shows.names = stage.shows.seams = false;
    const Vec2d middle = (stage.vertex(name, 0) + stage.vertex(name, 1)) / 2;
    const Vec2d along = (stage.vertex(name, 1) - stage.vertex(name, 0)).normalized(), out(along.y(), -along.x());
    constexpr double kWidth = 0.03;
    stage.frame();
    EXPECT_FALSE(SheetPicture(stage, "without_allowance").shows_line(middle + kWidth * out));
    stage.document.run(SetAllowance{.panel = name, .width = kWidth});
    stage.frame();
    EXPECT_TRUE(SheetPicture(stage, "allowance").shows_line(middle + kWidth * out));
    stage.document.run(SetAllowance{.panel = name, .edge = 0, .width = 0.0});
    stage.frame();
    EXPECT_FALSE(SheetPicture(stage, "no_allowance_of_an_edge").shows_line(middle + kWidth * out));
}

TEST(SheetPictures, a_panel_with_a_colour_of_its_own) {
    SheetFixture stage(shipped_pattern("two_squares"));
    const std::string name = stage.document.pattern().panels[0].name;
    stage.shows.names = stage.shows.seams = false;
    stage.document.run(
        SetSurface{.panel = name, .surface = sim::SurfaceDesign{.kind = sim::DesignKind::Colour, .source = "#C01818"}});
    stage.frame();
    const SheetColours colours;
    const auto over_white = [&](int part) {  // at the strength of cloth on the sheet
        return static_cast<std::uint8_t>(255 - colours.cloth_strength * float(255 - part));
    };
    const Vec2d middle = (stage.vertex(name, 0) + stage.vertex(name, 2)) / 2;
    EXPECT_TRUE(SheetPicture(stage, "red").shows({over_white(0xC0), over_white(0x18), over_white(0x18), 255}, middle));
}

TEST(SheetPictures, sewing_in_progress) {
    sim::PatternDocument source = shipped_pattern("tshirt");
    source.pattern.seams.erase(source.pattern.seams.begin(), source.pattern.seams.begin() + 2);
    SheetFixture stage(source, {1280, 800, 1});
    stage.key(key_of('N'));
    stage.click(stage.on_edge("front", 3, 0.2));
    const Vec2d first = stage.on_edge("front", 3, 0.35), second = stage.on_edge("back", 5, 0.65);
    EXPECT_FALSE(SheetPicture(stage, "sewing_before").shows(kColours.accent, second));
    stage.move(stage.on_edge("back", 5, 0.8));
    const SheetPicture picture(stage, "sewing");
    EXPECT_TRUE(picture.shows(kColours.accent, first)) << "the edge that was clicked";
    EXPECT_TRUE(picture.shows(kColours.accent, second)) << "the one under the cursor";
}

TEST(SheetPictures, an_uneven_seam) {
    SheetFixture stage(shipped_pattern("tshirt"), {1280, 800, 1});
    stage.key(key_of('N'));
    stage.click(stage.on_edge("front", 1, 0.2));
    EXPECT_EQ(SheetPicture(stage, "even").pixels_of(kColours.error), 0);
    stage.tools.run({stage.document, stage.hover, stage.messages}, MoveVertices{{{"front", 1}}, Vec2d(0.0, 0.008)});
    stage.move(stage.on_edge("front", 1, 0.2));
    EXPECT_GT(SheetPicture(stage, "uneven").pixels_of(kColours.error), 20) << "its length differs by 8 mm";
}

TEST(SheetPictures, a_drag_that_would_make_the_outline_cross_itself) {
    SheetFixture stage(shipped_pattern("tshirt"), {1280, 800, 1});
    const Vec2d from = stage.vertex("front", 2), to = from - Vec2d(0.6, 0.1);
    stage.press(from);
    stage.move(from - Vec2d(0.02, 0.0));
    EXPECT_FALSE(SheetPicture(stage, "refused_before").shows(kColours.warning, (to + 0.1 * (from - to)).eval()));
    stage.move(to);
    const SheetPicture picture(stage, "refused");
    EXPECT_GT(picture.pixels_of(kColours.bubble_problem), 20) << "the reason";
    EXPECT_TRUE(picture.shows_line(stage.on_edge("front", 2, 0.37))) << "the panel is where it was";
    stage.release();
    const int after = SheetPicture(stage, "refused_after").pixels_of(kColours.warning);  // seams have such colours, too
    EXPECT_GT(picture.pixels_of(kColours.warning), after + 200) << "the outline that is not possible";
}

TEST(SheetBubble, stands_beside_the_cursor_and_inside_of_the_view) {
    const SheetCamera camera{.view_low = Vec2d(40, 30), .view_size = Vec2d(500, 400)};
    const auto corner = [&](const Vec2d& cursor, const Vec2d& size) {
        const ImVec2 low = bubble_corner(camera, cursor, size, 18);
        return Vec2d(low.x, low.y);
    };
    const Vec2d size(300, 50);
    EXPECT_EQ(corner({100, 100}, size), Vec2d(118, 118));
    EXPECT_EQ(corner({500, 100}, size), Vec2d(182, 118)) << "on the left";
    EXPECT_EQ(corner({100, 400}, size), Vec2d(118, 332)) << "above";
    EXPECT_EQ(corner({300, 100}, size), Vec2d(40, 118)) << "neither side has room";
    EXPECT_EQ(corner({300, 100}, {600, 50}), Vec2d(40, 118)) << "wider than the view: its beginning shows";
}

TEST(SheetPictures, a_sewing_of_several_parts_has_one_colour) {
    sim::PatternDocument source = shipped_pattern("two_squares");
    source.pattern.seams.clear();
    SheetFixture stage(source);
    stage.document.run(SewRuns{.first = {{"front", 1}}, .second = {{"back", 0, 0, 0.5}, {"back", 0, 0.5, 1}}});
    ASSERT_EQ(stage.document.pattern().seams.size(), 2U);
    Selection both;
    both.seams = {0, 1};
    stage.document.select(both);  // other seams are faded
    stage.frame();
    const SheetPicture picture(stage, "sewing_of_two_parts");
    const auto pixels = [&](std::size_t seam) {
        const sim::Rgb8 colour = render::line_colour(seam);
        return picture.pixels_of({colour[0], colour[1], colour[2], 255});
    };
    EXPECT_GT(pixels(0), 100);
    EXPECT_LT(pixels(1), pixels(0) / 20);
}

TEST(SheetPictures, a_polygon_with_a_typed_number) {
    SheetFixture stage(sim::PatternDocument{});
    stage.key(key_of('H'));
    stage.click({0.20, 0.15});
    stage.click({0.75, 0.15});
    stage.click({0.85, 0.45}, {.ctrl = true});
    stage.click({0.70, 0.65});
    stage.move({0.35, 0.65});
    const int readout = SheetPicture(stage, "polygon_before").pixels_of(kColours.bubble);
    stage.type("92/4+1");
    const SheetPicture picture(stage, "polygon");
    EXPECT_TRUE(picture.shows(kColours.accent, {0.475, 0.15})) << "the first side";
    EXPECT_TRUE(picture.shows(kColours.accent, {0.20, 0.15}, 8)) << "the point it began at";
    EXPECT_NE(picture.pixels_of(kColours.bubble), readout) << "the readout shows what is typed";
}

}  // namespace
}  // namespace selvedge::editor
