#include "render/output/baked_textures.h"

#include <gtest/gtest.h>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "render/scene/colour.h"
#include "sim/exchange/mesh_file.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::render {
namespace {

// One flat square panel with its lower left corner at the origin of the material coordinates.
sim::DrawMesh square(float side, float grain = 0) {
    sim::DrawMesh mesh;
    mesh.x = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.u = {{Vec2f(0, 0), Vec2f(side, 0), Vec2f(side, side)}, {Vec2f(0, 0), Vec2f(side, side), Vec2f(0, side)}};
    mesh.panel = {0, 0};
    mesh.panel_names = {"square"};
    mesh.panel_grain_angles = {grain};
    return mesh;
}

ClothItem cloth_of(const sim::DrawMesh& mesh, const std::string& threadcount) {
    return {.mesh = mesh, .sett = sim::parse_threadcount(threadcount)};
}

// Linear light, at material coordinates.
Vec3f colour_at(const Image& image, const sim::DrawMesh& mesh, const sim::AtlasOptions& atlas, Vec2d material) {
    std::vector<sim::PanelPart> parts = split_by_panel(mesh);
    pack_panels(parts, atlas);
    const Vec2d uv = atlas.size_px * parts[0].chart->uv(material);
    const Rgba8& pixel = image.at(static_cast<int>(uv.x()), atlas.size_px - 1 - static_cast<int>(uv.y()));
    return to_linear(sim::Rgb8{pixel[0], pixel[1], pixel[2]});
}

Vec3f reflected(const sim::Rgb8& colour) {
    return 0.94F * to_linear(colour) + Vec3f::Constant(0.008F);
}

constexpr sim::Rgb8 kRed{0xC8, 0x10, 0x20}, kBlue{0x10, 0x20, 0xC8};

// Stripes 36 mm wide: a texel is 2 mm, far coarser than a thread.
TEST(BakedTextures, of_a_tartan_have_its_stripes_where_the_material_coordinates_say) {
    const sim::AtlasOptions atlas{.size_px = 128, .margin_px = 4};
    const sim::DrawMesh mesh = square(0.2F);
    const BakedTextures baked = bake(mesh, {cloth_of(mesh, "R=#C81020; B=#1020C8; R100 B100")}, atlas);
    EXPECT_FALSE(baked.normal) << "no yarn shows";
    const Vec3f red = reflected(kRed), blue = reflected(kBlue);
    EXPECT_LT((colour_at(baked.base_colour, mesh, atlas, {0.018, 0.018}) - red).norm(), 0.01);
    EXPECT_LT((colour_at(baked.base_colour, mesh, atlas, {0.054, 0.054}) - blue).norm(), 0.01);
    const Vec3f crossing = (red + blue) / 2;
    EXPECT_LT((colour_at(baked.base_colour, mesh, atlas, {0.018, 0.054}) - crossing).norm(), 0.01);
}

TEST(BakedTextures, are_turned_with_the_grain) {
    const sim::AtlasOptions atlas{.size_px = 256, .margin_px = 4};
    const std::string warp_and_weft = "R=#C81020; B=#1020C8; R100 B100 weft: R1";
    for (const bool is_turned : {false, true}) {
        const sim::DrawMesh mesh = square(0.2F, is_turned ? 1.5707963F : 0);
        const BakedTextures baked = bake(mesh, {cloth_of(mesh, warp_and_weft)}, atlas);
        // Along the warp the colour stays; across it, it changes from one stripe to the next.
        const auto change = [&](const Vec2d& from, const Vec2d& to) {
            return (colour_at(baked.base_colour, mesh, atlas, from) - colour_at(baked.base_colour, mesh, atlas, to))
                .norm();
        };
        const Vec2d start(0.05, 0.05), right(0.086, 0.05), up(0.05, 0.086);
        EXPECT_GT(change(start, is_turned ? up : right), 0.1);
        EXPECT_LT(change(start, is_turned ? right : up), 0.02);
    }
}

TEST(BakedTextures, show_single_yarns_and_their_relief_where_texels_are_fine) {
    const sim::AtlasOptions atlas{.size_px = 1024, .margin_px = 8};
    const sim::DrawMesh mesh = square(0.036F);  // 100 threads: ten texels each
    const BakedTextures baked = bake(mesh, {cloth_of(mesh, "R=#C81020; B=#1020C8; R10 weft: B10")}, atlas);
    ASSERT_TRUE(baked.normal);
    int red = 0, blue = 0, all = 0;
    Vec3d slope = Vec3d::Zero();
    int steepest = 0;
    for (int y = 100; y < 900; ++y) {
        for (int x = 100; x < 900; ++x, ++all) {
            const Rgba8& colour = baked.base_colour.at(x, y);
            (colour[0] > colour[2] ? red : blue)++;
            const Rgba8& normal = baked.normal->at(x, y);
            slope += Vec3d(normal[0] - 127.5, normal[1] - 127.5, 0);
            steepest = std::max(steepest, std::abs(normal[0] - 128));
        }
    }
    EXPECT_NEAR(red, all / 2, all / 50) << "a 2/2 twill shows as much warp as weft";
    EXPECT_LT((slope / all).norm(), 1) << "the surface is level as a whole";
    EXPECT_GT(steepest, 30);
}

TEST(BakedTextures, of_a_picture_are_the_picture_at_its_size_and_place) {
    const sim::AtlasOptions atlas{.size_px = 256, .margin_px = 8};
    const sim::DrawMesh mesh = square(0.2F);
    Image halves(64, 64, {kRed[0], kRed[1], kRed[2], 255});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) halves.at(x, y) = {kBlue[0], kBlue[1], kBlue[2], 255};
    ClothItem cloth{.mesh = mesh, .sett = {}};
    cloth.picture = ClothPicture{.image = std::make_shared<const Image>(halves),
                                 .size = {0.1F, 0.1F},
                                 .position = {0.05F, 0.05F},
                                 .is_repeated = false};
    const BakedTextures baked = bake(mesh, {cloth}, atlas);
    EXPECT_LT((colour_at(baked.base_colour, mesh, atlas, {0.1, 0.07}) - reflected(kRed)).norm(), 0.01) << "below";
    EXPECT_LT((colour_at(baked.base_colour, mesh, atlas, {0.1, 0.13}) - reflected(kBlue)).norm(), 0.01) << "above";
    EXPECT_LT((colour_at(baked.base_colour, mesh, atlas, {0.02, 0.02}) - reflected(cloth.picture->ground)).norm(),
              0.01);
}

TEST(BakedTextures, are_the_same_for_the_same_garment) {
    const sim::AtlasOptions atlas{.size_px = 256, .margin_px = 8};
    const sim::DrawMesh mesh = square(0.3F, 0.3F);
    const std::vector<ClothItem> cloths{{.mesh = mesh, .sett = sim::find_tartan("buchanan")}};
    const sim::GarmentTextures first = bake_pngs(mesh, cloths, atlas), second = bake_pngs(mesh, cloths, atlas);
    EXPECT_FALSE(first.base_colour.empty());
    EXPECT_EQ(first.base_colour, second.base_colour);
    EXPECT_EQ(first.normal, second.normal);
}

}  // namespace
}  // namespace selvedge::render
