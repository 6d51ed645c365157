// What the panels of a garment show, by their fabrics and surface designs.
#include "render/looks/cloth_looks.h"

#include <gtest/gtest.h>
#include <array>
#include <filesystem>
#include <numbers>
#include <string>

#include "render/draw/renderer.h"
#include "sim/core/error.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::render {
namespace {

using sim::DesignKind;
using sim::SurfaceDesign;

// Panels of 20 cm side by side, each of two triangles, in the plane z = 0, with their right side to +z.
ClothItem squares(const std::vector<std::string>& names) {
    ClothItem item;
    sim::DrawMesh& mesh = item.mesh;
    for (std::size_t p = 0; p < names.size(); ++p) {
        const auto first = static_cast<std::uint32_t>(mesh.x.size());
        const float left = 0.2F * static_cast<float>(p);
        for (const Vec2f& u : {Vec2f(0, 0), Vec2f(0.2F, 0), Vec2f(0.2F, 0.2F), Vec2f(0, 0.2F)})
            mesh.x.emplace_back(left + u.x(), u.y(), 0);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
        mesh.u.push_back({Vec2f(0, 0), Vec2f(0.2F, 0), Vec2f(0.2F, 0.2F)});
        mesh.u.push_back({Vec2f(0, 0), Vec2f(0.2F, 0.2F), Vec2f(0, 0.2F)});
        mesh.panel.insert(mesh.panel.end(), 2, static_cast<std::uint16_t>(p));
        mesh.panel_names.push_back(names[p]);
        mesh.panel_grain_angles.push_back(0);
    }
    return item;
}

sim::Pattern pattern_of(const std::vector<std::string>& names) {
    sim::Pattern pattern;
    for (const std::string& name : names) {
        sim::Panel panel;
        panel.name = name;
        pattern.panels.push_back(panel);
    }
    return pattern;
}

TEST(ClothLooks, panels_that_look_alike_are_one_part) {
    const std::vector<std::string> names{"a", "b", "c"};
    sim::Pattern pattern = pattern_of(names);
    ClothLooks looks(ClothLooks::Unknown::Fail);
    EXPECT_EQ(looks.parts(squares(names), pattern).size(), 1U);
    pattern.panels[1].surface = SurfaceDesign{.kind = DesignKind::Colour, .source = "#FF0000"};
    const std::vector<ClothItem> parts = looks.parts(squares(names), pattern);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].mesh.triangles.size(), 4U);
    EXPECT_EQ(parts[1].mesh.triangles.size(), 2U);
    EXPECT_EQ(parts[1].sett.stripes.at(0).colour, (sim::Rgb8{255, 0, 0}));
    EXPECT_EQ(parts[1].sett.weave, sim::Weave::Plain);
}

TEST(ClothLooks, the_nearest_design_counts) {
    sim::Pattern pattern = pattern_of({"a"});
    sim::Panel& panel = pattern.panels[0];
    ClothLooks looks(ClothLooks::Unknown::Fail);
    EXPECT_EQ(looks.design_of(pattern, panel), plain_design());
    pattern.tartan = "gingham";
    EXPECT_EQ(looks.design_of(pattern, panel).source, "gingham");
    pattern.surface = SurfaceDesign{.kind = DesignKind::Test};
    EXPECT_EQ(looks.design_of(pattern, panel).kind, DesignKind::Test);
    panel.surface = SurfaceDesign{.kind = DesignKind::Colour, .source = "#102030"};
    EXPECT_EQ(looks.design_of(pattern, panel).source, "#102030");
}

TEST(ClothLooks, what_is_unknown_is_told_or_replaced) {
    sim::Pattern pattern = pattern_of({"a"});
    pattern.surface = SurfaceDesign{.kind = DesignKind::Picture, .source = "/nowhere/roses.png"};
    EXPECT_THROW(ClothLooks(ClothLooks::Unknown::Fail).read(pattern), sim::InputError);
    EXPECT_THROW(ClothLooks(ClothLooks::Unknown::Fail).parts(squares({"a"}), pattern), sim::InputError);
    const std::vector<ClothItem> parts = ClothLooks(ClothLooks::Unknown::Replace).parts(squares({"a"}), pattern);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_FALSE(parts[0].picture);
    EXPECT_FALSE(parts[0].sett.stripes.empty());
}

TEST(ClothLooks, a_picture_keeps_its_proportions_and_is_made_opaque) {
    const sim::TemporaryFolder folder;
    const std::filesystem::path file = folder / "wide.png";
    Image image(40, 10, Rgba8{0, 0, 0, 0});
    image.at(0, 0) = {255, 255, 255, 255};
    write_png(file, image);
    const ClothPicture picture =
        picture_of({.kind = DesignKind::Picture, .source = file.string(), .size = 0.4, .ground = "#0000FF"});
    EXPECT_TRUE(picture.size.isApprox(Vec2f(0.4F, 0.1F)));
    EXPECT_EQ(picture.image->at(5, 5), (Rgba8{0, 0, 255, 255}));
    EXPECT_EQ(picture.image->at(0, 0), (Rgba8{255, 255, 255, 255}));
}

TEST(PictureRows, lead_from_the_cloth_to_the_picture) {
    const ClothPicture picture{
        .size = {0.4F, 0.2F}, .position = {0.1F, 0.3F}, .rotation = std::numbers::pi_v<float> / 2};
    const std::array<Vec3f, 2> rows = picture_rows(picture);
    const auto at = [&](float weft, float warp) {
        return Vec2f(rows[0].dot(Vec3f(weft, warp, 1)), rows[1].dot(Vec3f(weft, warp, 1)));
    };
    EXPECT_TRUE(at(0.1F, 0.3F).isApprox(Vec2f(0, 1), 1e-5F)) << "its lower left corner";
    EXPECT_TRUE(at(0.1F, 0.7F).isApprox(Vec2f(1, 1), 1e-5F)) << "its lower right corner, a quarter turn on";
    EXPECT_NEAR(at(-0.1F, 0.3F).y(), 0, 1e-5F) << "its upper left corner";
}

// Red, green; blue, white: seen from the right side as in the file, with the position at the lower left.
TEST(PrintedCloth, shows_the_picture_the_right_way_up_and_once) {
    Image image(2, 2);
    image.at(0, 0) = {220, 0, 0, 255};
    image.at(1, 0) = {0, 200, 0, 255};
    image.at(0, 1) = {0, 0, 220, 255};
    image.at(1, 1) = {250, 250, 250, 255};
    ClothItem item = squares({"a"});
    item.picture = ClothPicture{.image = std::make_shared<const Image>(image),
                                .size = {0.1F, 0.1F},
                                .is_repeated = false,
                                .ground = {120, 0, 120}};
    Scene scene;
    scene.cloths.push_back(item);
    scene.has_ground = false;
    scene.camera = frame_scene(scene, View::Front, 1);
    scene.light = even_light(scene.camera);
    Renderer renderer;
    const Image seen = renderer.draw(scene, {.width_px = 200, .height_px = 200});
    const Eigen::Matrix4f clip = projection_matrix(scene.camera, 1) * view_matrix(scene.camera);
    const auto pixel = [&](float x, float y) {
        const Eigen::Vector4f at = clip * Eigen::Vector4f(x, y, 0, 1);
        return seen.at(static_cast<int>(100 * (1 + at.x() / at.w())), static_cast<int>(100 * (1 - at.y() / at.w())));
    };
    const Rgba8 upper_left = pixel(0.02F, 0.08F), upper_right = pixel(0.08F, 0.08F), lower_left = pixel(0.02F, 0.02F),
                beside = pixel(0.15F, 0.15F);
    EXPECT_GT(upper_left[0], 2 * upper_left[1]);
    EXPECT_GT(upper_right[1], 2 * upper_right[0]);
    EXPECT_GT(lower_left[2], 2 * lower_left[0]);
    EXPECT_GT(beside[0], 2 * beside[1]) << "the ground";
    EXPECT_GT(beside[2], 2 * beside[1]);
}

TEST(TestPattern, has_its_mark_at_the_lower_left) {
    const Image image = test_pattern();
    const Rgba8& mark = image.at(10, image.height_px - 10);
    EXPECT_GT(mark[1], 2 * mark[0]);
    EXPECT_NE(image.at(image.width_px - 10, 10), mark);
}

}  // namespace
}  // namespace selvedge::render
