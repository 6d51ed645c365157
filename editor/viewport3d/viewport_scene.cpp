#include "editor/viewport3d/viewport_scene.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "sim/mesh/draw_mesh.h"

namespace selvedge::editor {
namespace {

constexpr float kEdgeInk = 0.55F;
// A body that moves is drawn this much smaller: the triangles of the cloth on it have their corners 0.3 mm outside, and
// their middles dip into what is round.
constexpr float kDrawnInside = 0.0015F;  // m

sim::DrawMesh without(const sim::DrawMesh& mesh, const std::set<std::string>& panels) {
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(mesh, t);
        if (panel >= mesh.panel_names.size() || !panels.contains(mesh.panel_names[panel])) kept.push_back(t);
    }
    return with_triangles(mesh, kept);
}

bool is_sound(const sim::DrawMesh& mesh) {
    return !mesh.triangles.empty() &&
           std::all_of(mesh.x.begin(), mesh.x.end(), [](const Vec3f& x) { return x.allFinite(); });
}

}  // namespace

bool fills_show_mode(render::ShowMode show) {
    return show > render::ShowMode::Plain;
}

bool may_be_curved(const ViewOptions& look) {
    const bool shows_surface = look.show == render::ShowMode::Tartan || look.show == render::ShowMode::Plain ||
                               look.show == render::ShowMode::Panels || look.show == render::ShowMode::Seams;
    return look.is_curved && shows_surface && !look.has_edges;
}

// What is unknown looks like the default; the inspector reports it.
void ViewportScene::update_cloth(const ViewportSceneInput& input) {
    cloths_.clear();
    const sim::DrawMesh& all = input.curved ? *input.curved : input.garment.mesh();
    std::optional<sim::DrawMesh> visible;
    if (!input.marks.undrawn.empty()) visible = without(all, input.marks.undrawn);
    const sim::DrawMesh& mesh = visible ? *visible : all;
    if (!is_sound(mesh)) return;
    render::ClothItem item{.mesh = mesh, .sett = {}, .show = input.look.show};
    if (input.look.has_edges) {
        if (item.show == render::ShowMode::Plain) item.show = render::ShowMode::Edges;
        item.ink = kEdgeInk;
    }
    cloths_ = looks_.parts(std::move(item), input.pattern);
}

void ViewportScene::update_body(const ViewportSceneInput& input) {
    has_body_ = input.look.has_body;
    body_ = input.current_body.body();
    body_positions_ = input.garment.body_positions();
    bodies_.clear();
    if (!has_body_ || !body_ || body_->triangles.empty()) return;
    render::BodyItem item = render::make_body_item(*body_);
    if (body_positions_ && body_positions_->size() == item.x.size()) {  // else the frame is of the body before
        item.x = *body_positions_;
        item.normals = sim::vertex_normals(item.x, item.triangles);
        for (std::size_t v = 0; v < item.x.size(); ++v) item.x[v] -= kDrawnInside * item.normals[v];
    }
    bodies_.push_back(std::move(item));
}

std::shared_ptr<const render::Scene> ViewportScene::update(const ViewportSceneInput& input) {
    const ContentKey key{.garment = input.garment.version(),
                         .revision = input.revision,
                         .fabric_version = input.fabric_version,
                         .show = input.look.show,
                         .has_edges = input.look.has_edges,
                         .undrawn = input.marks.undrawn,
                         .curved = input.curved};
    const bool is_cloth_new = !(key == key_);
    const bool is_body_new = input.current_body.body() != body_ || input.look.has_body != has_body_ ||
                             input.garment.body_positions() != body_positions_;
    if (!is_cloth_new && !is_body_new && input.marks == marks_) return scene_;
    if (key.fabric_version != key_.fabric_version) looks_.forget_fabrics();
    key_ = key;
    marks_ = input.marks;
    if (is_cloth_new) update_cloth(input);
    if (is_body_new) update_body(input);
    auto scene = std::make_shared<render::Scene>();
    scene->cloths = cloths_;
    scene->bodies = bodies_;
    render::SolidItem marks =
        make_marks(input.pattern, input.garment, input.current_body.points, input.marks, colours_);
    if (!marks.triangles.empty()) scene->solids.push_back(std::move(marks));
    scene->background = colours_.background;
    if (scene->cloths.empty() && scene->bodies.empty()) {
        scene_.reset();
        return scene_;
    }
    scene_ = std::move(scene);
    return scene_;
}

}  // namespace selvedge::editor
