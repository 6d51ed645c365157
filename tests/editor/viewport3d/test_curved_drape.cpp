#include "editor/viewport3d/curved_drape.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <memory>
#include <thread>

#include "editor/viewport3d/viewport.h"
#include "render/surface/curved_mesh.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/collider.h"
#include "sim/dress/dress.h"
#include "sim/dress/report.h"
#include "sim/mesh/sew.h"
#include "tests/editor/viewport3d/viewport_support.h"
#include "tests/sim/dress/session_support.h"

namespace selvedge::editor {
namespace {

CurrentBody mannequin(const std::string& text) {
    return {.text = text, .body = sim::test::session_body(), .measures = {}, .points = {}};
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
        workspace.drape.follow(*workspace.document, workspace.messages);
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({800, 600});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        view.show({.workspace = workspace, .output = output});
        ImGui::End();
        ImGui::Render();
    }

    std::size_t shown() const { return view.scene()->cloths.front().mesh.triangles.size(); }
    const sim::SessionFrame& frame() const { return view.hand().garment().frame(); }
    std::size_t leaves() const { return frame().mesh.triangles.size(); }
    bool is_at_rest() const { return frame().stage == sim::SessionStage::Settled; }

    // The left button of the mouse over the point, with Ctrl or without.
    void press(const Vec2f& px, bool is_down, bool has_ctrl) {
        ViewportInput input{.size_px = {800, 600}, .cursor_px = px, .is_over = true};
        input.modifiers.ctrl = has_ctrl;
        view.hand().update(workspace, input, ClothChoice::Panels);
        input.buttons[0] = {.is_down = is_down, .was_pressed = is_down, .was_released = !is_down};
        view.hand().update(workspace, input, ClothChoice::Panels);
    }
    Vec2f middle_of_a_triangle() const {
        const sim::PlainMesh& mesh = frame().mesh;
        std::size_t nearest = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (mesh.x[mesh.triangles[t][0]].z() > mesh.x[mesh.triangles[nearest][0]].z()) nearest = t;
        }
        const auto& [a, b, c] = mesh.triangles[nearest];
        return px_of(view.hand().viewing(), (mesh.x[a] + mesh.x[b] + mesh.x[c]) / 3).value();
    }

 private:
    ImGuiContext* context_ = ImGui::CreateContext();

 protected:
    Workspace workspace{
        {.pattern = sim::test::session_pattern("two_squares"), .json = {}}, sim::SessionDrive::Caller, mannequin};
    FrameOutput output;
    Viewport view;
};

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
    const sim::PlainMesh curved = curved_mesh(frame().mesh, options);
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
    view.hand().look_from(StandardView::Front);
    for (int i = 0; i < 3; ++i) show();
    press(middle_of_a_triangle(), true, true);
    ASSERT_TRUE(view.hand().under().cloth);
    EXPECT_LT(view.hand().under().cloth->triangle, leaves());
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
    at_rest->mesh = plain_mesh(*cloth, {"square"});
    CurvedDrape drape;
    EXPECT_FALSE(drape.follow(at_rest, sim::SessionDrive::Thread)) << "it has only begun";
    EXPECT_TRUE(drape.is_making());
    std::shared_ptr<const sim::PlainMesh> mesh;
    for (int i = 0; i < 1000 && !mesh; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        mesh = drape.follow(at_rest, sim::SessionDrive::Thread);
    }
    ASSERT_TRUE(mesh);
    EXPECT_FALSE(drape.is_making());
    EXPECT_EQ(*mesh, render::curved_mesh(at_rest->mesh, {.light_normals = render::LightNormals::Interpolated}));
    EXPECT_FALSE(drape.follow(std::make_shared<const sim::SessionFrame>(), sim::SessionDrive::Thread)) << "it moves";
    EXPECT_EQ(drape.follow(at_rest, sim::SessionDrive::Thread), mesh) << "the same cloth gives the same pointer";
}

}  // namespace
}  // namespace selvedge::editor
