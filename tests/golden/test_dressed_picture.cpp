// One garment from its pattern file to its picture, and wrong pictures that the comparison must reject.
#include <gtest/gtest.h>

#include "render/draw/renderer.h"
#include "sim/tartan/tartan_file.h"
#include "tests/golden/drape_numbers.h"
#include "tests/golden/golden.h"

namespace selvedge::test {
namespace {

constexpr const char* kName = "dressed_tshirt";

// Aims at the mannequin's trunk, independently of how the cloth hangs.
render::Camera camera_at_trunk() {
    const std::vector<Vec3f> corners{Vec3f(-0.4F, 0.75F, 0), Vec3f(0.4F, 1.4F, 0)};
    return frame_points(corners, render::View::ThreeQuarter, {.aspect = 1});
}

render::Image draw(const sim::DrawMesh& garment, const std::string& tartan) {
    render::Scene scene;
    render::ClothItem cloth;
    cloth.mesh = garment;
    cloth.sett = sim::find_tartan(tartan);
    scene.cloths.push_back(cloth);
    scene.bodies.push_back(render::make_body_item(coarse_mannequin()));
    scene.camera = camera_at_trunk();
    scene.light = studio_light(scene.camera);
    return render::Renderer().draw(scene, {.width_px = 256, .height_px = 256});
}

// One process runs this suite, so the T-shirt is dressed only once.
class DressedPicture : public testing::Test {
 protected:
    static void SetUpTestSuite() { tshirt_ = dress_shipped("tshirt", {.max_level = 2}).mesh; }

    static void expect_told_apart(const render::Image& faulty) {
        const BlockComparison comparison = compare_blocks(read_reference(kName), faulty);
        EXPECT_FALSE(is_alike(comparison)) << describe(comparison);
    }

    static sim::DrawMesh tshirt_;
};

sim::DrawMesh DressedPicture::tshirt_;

TEST_F(DressedPicture, is_as_it_was) {
    EXPECT_TRUE(matches_golden_by_blocks(draw(tshirt_, "royal_stewart"), kName));
}

TEST_F(DressedPicture, in_another_tartan_is_told_apart) {
    expect_told_apart(draw(tshirt_, "dress_stewart"));
}

TEST_F(DressedPicture, of_another_garment_is_told_apart) {
    expect_told_apart(draw(dress_shipped("two_squares", {.max_level = 2}).mesh, "royal_stewart"));
}

TEST_F(DressedPicture, of_a_garment_that_slipped_by_2_cm_is_told_apart) {
    sim::DrawMesh slipped = tshirt_;
    for (Vec3f& x : slipped.x) x.y() -= 0.02F;
    expect_told_apart(draw(slipped, "royal_stewart"));
}

TEST_F(DressedPicture, of_a_garment_without_a_sleeve_is_told_apart) {
    sim::DrawMesh torn = tshirt_;
    for (std::size_t t = 0; t < torn.triangles.size(); ++t) {
        const std::string& panel = torn.panel_names[torn.panel[t]];
        if (panel.find("sleeve") != std::string::npos) torn.triangles[t] = {0, 0, 0};
    }
    expect_told_apart(draw(torn, "royal_stewart"));
}

TEST(Blocks, pictures_of_unlike_size_are_not_alike) {
    EXPECT_FALSE(is_alike(compare_blocks(render::Image(32, 32), render::Image(32, 48))));
}

TEST(Blocks, a_moved_thread_is_not_seen_and_a_changed_block_is_counted) {
    render::Image striped(64, 64), moved(64, 64);
    for (int y = 0; y < 64; ++y) {
        striped.at(5, y) = {255, 255, 255, 255};
        moved.at(9, y) = {255, 255, 255, 255};
    }
    EXPECT_EQ(compare_blocks(striped, moved).largest_step, 0);
    for (int y = 16; y < 32; ++y) moved.at(40, y) = {255, 255, 255, 255};
    const BlockComparison comparison = compare_blocks(striped, moved, {.tolerance = 12});
    EXPECT_EQ(comparison.blocks, 16);
    EXPECT_EQ(comparison.beyond, 1);
    EXPECT_DOUBLE_EQ(comparison.largest_step, 255.0 / 16);
}

}  // namespace
}  // namespace selvedge::test
