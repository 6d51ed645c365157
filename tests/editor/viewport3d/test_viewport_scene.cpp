#include <gtest/gtest.h>
#include <imgui.h>
#include <chrono>
#include <memory>
#include <thread>

#include "editor/viewport3d/cloth_outline.h"
#include "editor/viewport3d/curved_drape.h"
#include "editor/viewport3d/viewport.h"
#include "editor/viewport3d/viewport_scene.h"
#include "render/surface/curve.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/collider.h"
#include "sim/dress/dressing.h"
#include "sim/inspection/report.h"
#include "sim/mesh/sew.h"
#include "sim/session/dress.h"
#include "tests/editor/viewport3d/viewport_support.h"
#include "tests/sim/session/session_support.h"

namespace selvedge::editor {
namespace {

// Two triangles of two panels that meet at vertex 2, and a pin at each vertex.
TEST(ViewportMarks, pins_of_panels_that_are_not_drawn_are_not_drawn) {
    auto frame = std::make_shared<sim::SessionFrame>();
    sim::DrawMesh& mesh = frame->mesh;
    mesh.x = {{0, 0, 0}, {0.2F, 0, 0}, {0.3F, 0.2F, 0}, {0.4F, 0, 0}, {0.6F, 0, 0}};
    mesh.normals.assign(5, Vec3f(0, 0, 1));
    mesh.triangles = {{0, 1, 2}, {2, 3, 4}};
    mesh.u = {{Vec2f(0, 0), Vec2f(0.2F, 0), Vec2f(0.3F, 0.2F)}, {Vec2f(0, 0.2F), Vec2f(0.1F, 0), Vec2f(0.3F, 0)}};
    mesh.panel = {0, 1};
    mesh.panel_names = {"front", "back"};
    frame->stage = sim::SessionStage::Settled;
    frame->pins = mesh.x;
    DisplayedGarment garment;
    garment.update({}, 1, frame, GarmentState::AsItIs);
    const auto pins_without = [&](const std::set<std::string>& undrawn) {
        ViewportMarks marks;
        marks.undrawn = undrawn;
        return make_marks({}, garment, {}, marks, {}).triangles.size();
    };
    const std::size_t all = pins_without({});
    ASSERT_GT(all, 0U);
    EXPECT_EQ(pins_without({"front"}) * 5, all * 3) << "the one at the seam is drawn";
    EXPECT_EQ(pins_without({"back"}) * 5, all * 3);
    EXPECT_EQ(pins_without({"front", "back"}), 0U);
}

class ViewportSceneTest : public testing::Test {
 protected:
    std::shared_ptr<const render::Scene> update() {
        viewport.rest();
        marks.undrawn = undrawn_panels(viewport.document().pattern(), viewport.workspace().look,
                                       viewport.document().panel_states());
        return scene.update({.pattern = viewport.document().pattern(),
                             .revision = viewport.document().revision(),
                             .garment = viewport.controller().garment(),
                             .current_body = viewport.workspace().drape.current_body(),
                             .look = viewport.workspace().look,
                             .marks = marks});
    }

    ViewportFixture viewport;
    ViewportScene scene;
    ViewportMarks marks;
};

TEST_F(ViewportSceneTest, is_the_same_pointer_while_nothing_changes) {
    const auto first = update();
    ASSERT_TRUE(first);
    EXPECT_EQ(update(), first);
    EXPECT_EQ(first->cloths.size(), 1U);
    EXPECT_EQ(first->bodies.size(), 1U);
    EXPECT_TRUE(first->solids.empty());
}

TEST_F(ViewportSceneTest, selection_hover_look_and_pattern_make_another) {
    std::shared_ptr<const render::Scene> last = update();
    const auto is_another = [&] {
        const auto next = update();
        const bool is = next != last;
        last = next;
        return is;
    };
    marks.selection.panels.insert("square");
    EXPECT_TRUE(is_another());
    EXPECT_EQ(last->solids.size(), 1U);
    marks.hover.edge = PartRef{"square", 2};
    EXPECT_TRUE(is_another());
    viewport.workspace().look.show = render::ShowMode::Level;
    EXPECT_TRUE(is_another());
    EXPECT_EQ(last->cloths.front().show, render::ShowMode::Level);
    viewport.workspace().run(SetTartan{.tartan = "K/8 R24 W/4"});
    EXPECT_TRUE(is_another());
    EXPECT_EQ(last->cloths.front().sett.stripes.front().threads, 8);
    viewport.workspace().look.has_body = false;
    EXPECT_TRUE(is_another());
    EXPECT_TRUE(last->bodies.empty());
    EXPECT_FALSE(is_another());
}

TEST_F(ViewportSceneTest, a_selected_edge_is_marked_where_it_lies_on_the_cloth) {
    marks.selection.edges.insert({"square", 2});
    marks.size = 0.001F;
    const auto made = update();
    ASSERT_EQ(made->solids.size(), 1U);
    Eigen::AlignedBox3f box;
    for (const Vec3f& x : made->solids.front().x) box.extend(x);
    EXPECT_NEAR(box.center().y(), 1.2F, 1e-3F) << "the upper edge";
    EXPECT_NEAR(box.sizes().x(), 0.4F, 0.01F);
    EXPECT_LT(box.sizes().y(), 0.01F);
}

TEST_F(ViewportSceneTest, panels_of_other_fabrics_are_cloths_of_their_own) {
    sim::Panel other = viewport.panel();
    other.name = "other";
    other.translation.x() += 0.5;
    other.fabric = "denim";
    viewport.workspace().run(AddPanels{.panels = {other}});
    viewport.rest();
    viewport.workspace().drape.session().advance(0);
    const auto made = update();
    ASSERT_EQ(made->cloths.size(), 2U);
    EXPECT_EQ(made->cloths[0].mesh.triangles.size() + made->cloths[1].mesh.triangles.size(),
              viewport.controller().garment().mesh().triangles.size());
    EXPECT_FALSE(made->cloths[0].material == made->cloths[1].material);
}

TEST_F(ViewportSceneTest, garments_that_are_hidden_are_not_drawn) {
    sim::Panel other = viewport.panel();
    other.name = "other";
    other.translation.x() += 0.5;
    other.garment = "coat";
    viewport.workspace().run(AddPanels{.panels = {other}});
    viewport.rest();
    viewport.workspace().drape.session().advance(0);
    const std::size_t all = update()->cloths.at(0).mesh.triangles.size();
    viewport.workspace().look.hidden_garments = {"coat"};
    EXPECT_EQ(update()->cloths.at(0).mesh.triangles.size(), all / 2);
    viewport.workspace().look.hidden_garments = {"nothing of that name"};
    EXPECT_EQ(update()->cloths.at(0).mesh.triangles.size(), all);
}

TEST_F(ViewportSceneTest, a_hidden_panel_is_neither_drawn_nor_marked_but_still_simulated) {
    sim::Panel other = viewport.panel();
    other.name = "other";
    other.translation.x() += 0.5;
    viewport.workspace().run(AddPanels{.panels = {other}});
    viewport.rest();
    viewport.workspace().drape.session().advance(0);
    marks.selection.panels = {"other"};
    const std::size_t all = update()->cloths.at(0).mesh.triangles.size();
    EXPECT_EQ(update()->solids.size(), 1U);
    viewport.workspace().document->set_panel_states({.hidden = {"other"}, .locked = {}});
    const auto made = update();
    EXPECT_EQ(made->cloths.at(0).mesh.triangles.size(), all / 2);
    EXPECT_TRUE(made->solids.empty()) << "its outline is not marked";
    EXPECT_EQ(viewport.controller().garment().frame().mesh.triangles.size(), all) << "the session has it";
    viewport.workspace().document->set_panel_states({.hidden = {}, .locked = {"other"}});
    EXPECT_EQ(update()->cloths.at(0).mesh.triangles.size(), all) << "a locked one is drawn";
}

TEST_F(ViewportSceneTest, lines_of_open_seams_to_a_hidden_panel_are_not_drawn) {
    sim::Panel other = viewport.panel();
    other.name = "other";
    other.translation.x() += 0.5;
    viewport.workspace().run(AddPanels{.panels = {other}});
    viewport.workspace().run(SewEdges{.first = {"square", 1}, .second = {"other", 3}});
    viewport.rest();
    viewport.workspace().drape.session().advance(0);
    viewport.workspace().document->select({});
    ASSERT_EQ(update()->solids.size(), 1U);
    viewport.workspace().document->set_panel_states({.hidden = {"other"}, .locked = {}});
    EXPECT_TRUE(update()->solids.empty());
}

TEST_F(ViewportSceneTest, an_unknown_tartan_or_panel_does_not_stop_it) {
    marks.wrong = {{.panel = "nowhere", .edge = 3}, {.panel = "square", .edge = 77}, {.panel = "square", .vertex = -5}};
    marks.selection.vertices.insert({"square", 99});
    marks.hover.seam = 5;
    EXPECT_TRUE(update());
}

TEST(PlacedMesh, takes_a_sewn_mesh_apart_where_the_pattern_places_its_panels) {
    sim::Pattern pattern = square_pattern();
    pattern.panels.push_back(pattern.panels.front());
    pattern.panels.back().name = "other";
    pattern.panels.back().translation = {0, 1, -0.3};
    sim::DrawMesh sewn;  // one triangle per panel, sharing an edge
    sewn.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    sewn.triangles = {{0, 1, 2}, {1, 3, 2}};
    sewn.u = {{Vec2f(0, 0), Vec2f(0.1F, 0), Vec2f(0, 0.1F)}, {Vec2f(0, 0), Vec2f(0.1F, 0), Vec2f(0, 0.1F)}};
    sewn.panel = {0, 1};
    sewn.panel_names = {"square", "other"};
    const sim::DrawMesh placed = placed_mesh(sewn, pattern);
    EXPECT_EQ(placed.x.size(), 6U);
    EXPECT_EQ(placed.x[placed.triangles[0][1]], Vec3f(0.1F, 1, 0.3F));
    EXPECT_EQ(placed.x[placed.triangles[1][2]], Vec3f(0, 1.1F, -0.3F));
    EXPECT_EQ(placed.normals.size(), 6U);
}

}  // namespace

namespace {

CurrentBody mannequin(const std::string& text) {
    CurrentBody made = current_body({.source = text, .body = sim::test::session_body()});
    made.points.clear();
    return made;
}

// Two squares that hang from the shoulders of the mannequin, in a window that holds only the 3D view.
class CurvedDrapeTest : public testing::Test {
 protected:
    CurvedDrapeTest() {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {800, 600};
        io.DeltaTime = 1;
        io.Fonts->Build();
        ImGui::GetStyle().WindowPadding = {0, 0};
        workspace.drape.options() = sim::test::coarse_options();
        show();
    }
    ~CurvedDrapeTest() override { ImGui::DestroyContext(context_); }

    // One frame of the editor, which is one of the drape while that runs.
    void show() {
        workspace.drape.update(*workspace.document, workspace.messages);
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({800, 600});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        view.show({.workspace = workspace, .output = output, .seconds = seconds});
        ImGui::End();
        ImGui::Render();
    }

    std::size_t shown() const { return view.scene()->cloths.front().mesh.triangles.size(); }
    const sim::SessionFrame& frame() const { return view.controller().garment().frame(); }
    std::size_t leaves() const { return frame().mesh.triangles.size(); }
    bool is_at_rest() const { return frame().stage == sim::SessionStage::Settled; }

    // The left button of the mouse over the point, with Ctrl or without.
    void press(const Vec2f& px, bool is_down, bool has_ctrl) {
        ViewportInput input{.size_px = {800, 600}, .cursor_px = px, .is_over = true};
        input.modifiers.ctrl = has_ctrl;
        view.controller().update(workspace, input, ClothChoice::Panels);
        input.buttons[0] = {.is_down = is_down, .was_pressed = is_down, .was_released = !is_down};
        view.controller().update(workspace, input, ClothChoice::Panels);
    }
    Vec2f middle_of_a_triangle() const {
        const sim::DrawMesh& mesh = frame().mesh;
        std::size_t nearest = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (mesh.x[mesh.triangles[t][0]].z() > mesh.x[mesh.triangles[nearest][0]].z()) nearest = t;
        }
        const auto& [a, b, c] = mesh.triangles[nearest];
        return px_of(view.controller().viewing(), (mesh.x[a] + mesh.x[b] + mesh.x[c]) / 3).value();
    }

 private:
    ImGuiContext* context_ = ImGui::CreateContext();

 protected:
    Workspace workspace{
        {.pattern = sim::test::session_pattern("two_squares"), .json = {}}, sim::SessionDrive::Caller, mannequin};
    FrameOutput output;
    Viewport view;
    float seconds = 0;  // s, per frame
};

// A view that rests is drawn once more for each sample of a smooth picture, and then no more.
TEST_F(CurvedDrapeTest, rests_while_its_picture_gets_smooth) {
    const auto samples_of = [&](int frames) {
        std::vector<std::optional<int>> samples;
        for (int i = 0; i < frames; ++i) {
            output = {};
            show();
            for (const SceneRequest& request : output.scenes) samples.push_back(request.sample);
        }
        return samples;
    };
    seconds = 0.1F;
    samples_of(60);  // until the view that is new has come to rest
    EXPECT_TRUE(samples_of(5).empty());
    EXPECT_FALSE(output.is_animating) << "resting costs nothing";

    view.controller().look_from(StandardView::Left);
    output = {};
    show();
    ASSERT_EQ(output.scenes.size(), 1U) << "a change shows at once";
    EXPECT_FALSE(output.scenes.front().sample);
    std::vector<std::optional<int>> after = samples_of(60);
    EXPECT_FALSE(output.is_animating);
    std::erase(after, std::nullopt);  // the camera's way
    ASSERT_EQ(after.size(), 16U);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(after[static_cast<std::size_t>(i)], i);

    view.controller().look_from(StandardView::Front);
    for (const std::optional<int>& sample : samples_of(6)) EXPECT_FALSE(sample);
    workspace.drape.session().start();
    for (const std::optional<int>& sample : samples_of(30)) EXPECT_FALSE(sample) << "cloth moves";
}

TEST_F(CurvedDrapeTest, rests_also_while_the_simulation_runs_and_the_cloth_has_settled) {
    show();
    workspace.drape.session().start();
    for (int i = 0; i < 1000 && !is_at_rest(); ++i) show();
    ASSERT_TRUE(is_at_rest());
    ASSERT_TRUE(frame().is_running);
    seconds = 0.1F;
    int samples = 0;
    for (int i = 0; i < 60; ++i) {
        output = {};
        show();
        for (const SceneRequest& request : output.scenes) samples += request.sample ? 1 : 0;
    }
    EXPECT_EQ(samples, 16);
}

TEST_F(CurvedDrapeTest, is_shown_at_rest_only_and_only_if_the_view_option_is_on) {
    ASSERT_TRUE(view.scene());
    workspace.drape.session().start();
    int moving = 0;
    for (; moving < 1000 && !is_at_rest(); ++moving) {
        EXPECT_EQ(shown(), leaves());
        show();
    }
    EXPECT_GT(moving, 20);
    ASSERT_TRUE(is_at_rest());
    ASSERT_TRUE(frame().collider);
    render::CurvedMeshOptions options{.light_normals = render::LightNormals::Interpolated};
    options.curve.move.body = frame().collider.get();
    const sim::DrawMesh curved = curved_mesh(frame().mesh, options);
    EXPECT_GT(curved.triangles.size(), leaves());
    EXPECT_EQ(view.scene()->cloths.front().mesh, curved);
    for (const Vec3f& x : curved.x) EXPECT_GT(frame().collider->contact(x).distance, -0.0005F) << "in the body";

    const auto scene = view.scene();
    output.scenes.clear();
    show();
    EXPECT_EQ(view.scene(), scene) << "nothing has changed";
    EXPECT_TRUE(output.scenes.empty());

    workspace.look.is_curved = false;
    show();
    EXPECT_EQ(view.scene()->cloths.front().mesh, frame().mesh);
    workspace.look.is_curved = true;
    show();
    EXPECT_EQ(view.scene()->cloths.front().mesh, curved);
    for (const render::ShowMode mode : {render::ShowMode::Level, render::ShowMode::Edges, render::ShowMode::Strain}) {
        workspace.look.show = mode;
        show();
        EXPECT_EQ(shown(), leaves()) << "the mode shows data of the simulated triangles";
    }
    workspace.look.show = render::ShowMode::Plain;
    workspace.look.as_placed = true;
    show();
    EXPECT_EQ(shown(), leaves());
    workspace.look.as_placed = false;

    // Picking uses the simulated triangles under the surface.
    view.controller().look_from(StandardView::Front);
    for (int i = 0; i < 3; ++i) show();
    press(middle_of_a_triangle(), true, true);
    ASSERT_TRUE(view.controller().under().cloth);
    EXPECT_LT(view.controller().under().cloth->triangle, leaves());
    press(middle_of_a_triangle(), false, true);
    show();
    show();
    EXPECT_EQ(frame().pins.size(), 1U);
    EXPECT_EQ(shown(), curved.triangles.size());
    press(middle_of_a_triangle(), true, false);
    press(middle_of_a_triangle() + Vec2f(40, 0), true, false);
    show();
    show();
    EXPECT_FALSE(is_at_rest());
    EXPECT_EQ(shown(), leaves()) << "the cloth is pulled";
}

TEST(CurvedDrape, does_not_wait_for_the_task_where_the_drape_has_its_own_thread) {
    const sim::Pattern pattern = square_pattern();
    const auto cloth = std::make_shared<const sim::Cloth>(make_cloth(assemble(pattern), sim::fabrics_of(pattern)));
    auto at_rest = std::make_shared<sim::SessionFrame>();
    at_rest->cloth = cloth;
    at_rest->mesh = draw_mesh(*cloth, {"square"});
    CurvedDrape drape;
    EXPECT_FALSE(drape.update(at_rest, sim::SessionDrive::Thread)) << "it has only begun";
    EXPECT_TRUE(drape.is_making());
    std::shared_ptr<const sim::DrawMesh> mesh;
    for (int i = 0; i < 1000 && !mesh; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        mesh = drape.update(at_rest, sim::SessionDrive::Thread);
    }
    ASSERT_TRUE(mesh);
    EXPECT_FALSE(drape.is_making());
    EXPECT_EQ(*mesh, render::curved_mesh(at_rest->mesh, {.light_normals = render::LightNormals::Interpolated}));
    EXPECT_FALSE(drape.update(std::make_shared<const sim::SessionFrame>(), sim::SessionDrive::Thread)) << "it moves";
    EXPECT_EQ(drape.update(at_rest, sim::SessionDrive::Thread), mesh) << "the same cloth gives the same pointer";
}

}  // namespace

namespace {

// Two squares of 1 m side by side, "left" and "right", sewn along their common edge; each has a vertex in its centre.
struct SewnSquares {
    sim::Pattern pattern;
    sim::DrawMesh mesh;
};

sim::Panel square_panel(const std::string& name) {
    sim::Panel panel;
    panel.name = name;
    panel.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

SewnSquares sewn_squares() {
    SewnSquares squares;
    squares.pattern.panels = {square_panel("right"), square_panel("left")};
    sim::DrawMesh& mesh = squares.mesh;
    mesh.panel_names = {"left", "right"};
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 0}, {1.5F, 0.5F, 0}};
    const std::array<std::array<std::uint32_t, 5>, 2> corners{{{0, 1, 4, 5, 6}, {1, 2, 3, 4, 7}}};
    for (std::uint16_t p = 0; p < 2; ++p) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<std::uint32_t, 3> triangle{corners[p][i], corners[p][(i + 1) % 4], corners[p][4]};
            mesh.triangles.push_back(triangle);
            mesh.panel.push_back(p);
            std::array<Vec2f, 3> u;
            for (std::size_t c = 0; c < 3; ++c) u[c] = mesh.x[triangle[c]].head<2>() - Vec2f(float(p), 0);
            mesh.u.push_back(u);
        }
    }
    return squares;
}

TEST(ClothOutline, follows_each_panel_along_its_seams_too) {
    const SewnSquares squares = sewn_squares();
    const std::vector<ClothOutline> outlines = find_outlines(squares.mesh, squares.pattern);
    ASSERT_EQ(outlines.size(), 2U);
    EXPECT_EQ(outlines[0].vertices.size(), 4U);
    EXPECT_EQ(start_of(outlines[0], 0, squares.mesh.x), Vec3f(1, 0, 0));
    EXPECT_EQ(start_of(outlines[0], 2, squares.mesh.x), Vec3f(2, 1, 0));
    EXPECT_EQ(edge_path(outlines[0], 3, squares.mesh.x), (std::vector<Vec3f>{{1, 1, 0}, {1, 0, 0}})) << "the seam";
    EXPECT_EQ(edge_path(outlines[1], 1, squares.mesh.x), (std::vector<Vec3f>{{1, 0, 0}, {1, 1, 0}}))
        << "its other side";
    EXPECT_EQ(whole_path(outlines[1], squares.mesh.x).size(), 5U);
}

TEST(ClothOutline, a_seam_within_a_panel_is_part_of_its_outline) {
    // Both squares belong to the left panel, but at different material coordinates, as at the closing seam of a tube.
    SewnSquares squares = sewn_squares();
    squares.mesh.panel.assign(8, 0);
    for (std::size_t t = 4; t < 8; ++t) {
        for (Vec2f& u : squares.mesh.u[t]) u += Vec2f(5, 0);
    }
    const std::vector<ClothOutline> outlines = find_outlines(squares.mesh, squares.pattern);
    EXPECT_EQ(outlines[1].vertices.size(), 4U) << "not the six round both";
    EXPECT_TRUE(outlines[0].is_empty()) << "no triangle is of the panel on the right";
}

TEST(ClothOutline, a_panel_that_the_mesh_does_not_know_has_none) {
    SewnSquares squares = sewn_squares();
    squares.pattern.panels[0].name = "collar";
    const std::vector<ClothOutline> outlines = find_outlines(squares.mesh, squares.pattern);
    EXPECT_TRUE(outlines[0].is_empty());
    EXPECT_FALSE(outlines[1].is_empty());
}

TEST(ClothOutline, a_mesh_without_material_coordinates_has_none) {
    SewnSquares squares = sewn_squares();
    squares.mesh.u.clear();
    EXPECT_TRUE(find_outlines(squares.mesh, squares.pattern)[0].is_empty());
}

}  // namespace

}  // namespace selvedge::editor
