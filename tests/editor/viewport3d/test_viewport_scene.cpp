#include <gtest/gtest.h>

#include "editor/viewport3d/viewport_scene.h"
#include "tests/editor/viewport3d/viewport_support.h"

namespace selvedge::editor {
namespace {

class FittingSceneTest : public testing::Test {
 protected:
    std::shared_ptr<const render::Scene> follow() {
        desk.rest();
        return scene.follow({.pattern = desk.document().pattern(),
                             .revision = desk.document().revision(),
                             .garment = desk.hand().garment(),
                             .worn = desk.workspace().drape.worn(),
                             .look = desk.workspace().look,
                             .marks = marks});
    }

    ViewportFixture desk;
    ViewportScene scene;
    ViewportMarks marks;
};

TEST_F(FittingSceneTest, is_the_same_pointer_while_nothing_changes) {
    const auto first = follow();
    ASSERT_TRUE(first);
    EXPECT_EQ(follow(), first);
    EXPECT_EQ(first->cloths.size(), 1U);
    EXPECT_EQ(first->bodies.size(), 1U);
    EXPECT_TRUE(first->solids.empty());
}

TEST_F(FittingSceneTest, selection_hover_look_and_pattern_make_another) {
    std::shared_ptr<const render::Scene> last = follow();
    const auto is_another = [&] {
        const auto next = follow();
        const bool is = next != last;
        last = next;
        return is;
    };
    marks.selection.panels.insert("square");
    EXPECT_TRUE(is_another());
    EXPECT_EQ(last->solids.size(), 1U);
    marks.hover.edge = PartRef{"square", 2};
    EXPECT_TRUE(is_another());
    desk.workspace().look.show = render::ShowMode::Level;
    EXPECT_TRUE(is_another());
    EXPECT_EQ(last->cloths.front().show, render::ShowMode::Level);
    desk.workspace().run(SetTartan{.tartan = "K/8 R24 W/4"});
    EXPECT_TRUE(is_another());
    EXPECT_EQ(last->cloths.front().sett.stripes.front().threads, 8);
    desk.workspace().look.has_body = false;
    EXPECT_TRUE(is_another());
    EXPECT_TRUE(last->bodies.empty());
    EXPECT_FALSE(is_another());
}

TEST_F(FittingSceneTest, a_selected_edge_is_marked_where_it_lies_on_the_cloth) {
    marks.selection.edges.insert({"square", 2});
    marks.size = 0.001F;
    const auto made = follow();
    ASSERT_EQ(made->solids.size(), 1U);
    Eigen::AlignedBox3f box;
    for (const Vec3f& x : made->solids.front().x) box.extend(x);
    EXPECT_NEAR(box.center().y(), 1.2F, 1e-3F) << "the upper edge";
    EXPECT_NEAR(box.sizes().x(), 0.4F, 0.01F);
    EXPECT_LT(box.sizes().y(), 0.01F);
}

TEST_F(FittingSceneTest, panels_of_other_fabrics_are_cloths_of_their_own) {
    sim::Panel other = desk.panel();
    other.name = "other";
    other.translation.x() += 0.5;
    other.fabric = "denim";
    desk.workspace().run(AddPanels{.panels = {other}});
    desk.rest();
    desk.workspace().drape.session().advance(0);
    const auto made = follow();
    ASSERT_EQ(made->cloths.size(), 2U);
    EXPECT_EQ(made->cloths[0].mesh.triangles.size() + made->cloths[1].mesh.triangles.size(),
              desk.hand().garment().mesh().triangles.size());
    EXPECT_FALSE(made->cloths[0].material == made->cloths[1].material);
}

TEST_F(FittingSceneTest, an_unknown_tartan_or_panel_does_not_stop_it) {
    marks.wrong = {{.panel = "nowhere", .edge = 3}, {.panel = "square", .edge = 77}, {.panel = "square", .vertex = -5}};
    marks.selection.vertices.insert({"square", 99});
    marks.hover.seam = 5;
    EXPECT_TRUE(follow());
}

TEST(PlacedMesh, takes_a_sewn_mesh_apart_where_the_pattern_places_its_panels) {
    sim::Pattern pattern = square_pattern();
    pattern.panels.push_back(pattern.panels.front());
    pattern.panels.back().name = "other";
    pattern.panels.back().translation = {0, 1, -0.3};
    sim::PlainMesh sewn;  // one triangle per panel, sharing an edge
    sewn.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    sewn.triangles = {{0, 1, 2}, {1, 3, 2}};
    sewn.u = {{Vec2f(0, 0), Vec2f(0.1F, 0), Vec2f(0, 0.1F)}, {Vec2f(0, 0), Vec2f(0.1F, 0), Vec2f(0, 0.1F)}};
    sewn.panel = {0, 1};
    sewn.panel_names = {"square", "other"};
    const sim::PlainMesh placed = placed_mesh(sewn, pattern);
    EXPECT_EQ(placed.x.size(), 6U);
    EXPECT_EQ(placed.x[placed.triangles[0][1]], Vec3f(0.1F, 1, 0.3F));
    EXPECT_EQ(placed.x[placed.triangles[1][2]], Vec3f(0, 1.1F, -0.3F));
    EXPECT_EQ(placed.normals.size(), 6U);
}

}  // namespace

}  // namespace selvedge::editor
