#include "editor/viewport3d/viewport_scene.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "sim/core/error.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/garments.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::editor {
namespace {

constexpr float kEdgeInk = 0.55F;
// A body that moves is drawn this much smaller: the triangles of the cloth on it have their corners 0.3 mm outside, and
// their middles dip into what is round.
constexpr float kDrawnInside = 0.0015F;  // m

// The fabric name of each panel of the mesh.
std::vector<std::string> fabrics_of(const sim::DrawMesh& mesh, const sim::Pattern& pattern) {
    std::vector<std::string> names(std::max<std::size_t>(1, mesh.panel_names.size()), pattern.fabric);
    for (std::size_t i = 0; i < mesh.panel_names.size(); ++i) {
        const auto panel = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                        [&](const sim::Panel& known) { return known.name == mesh.panel_names[i]; });
        if (panel != pattern.panels.end() && !panel->fabric.empty()) names[i] = panel->fabric;
    }
    return names;
}

// The triangles made of `fabric`, with all vertices.
sim::DrawMesh part_of(const sim::DrawMesh& mesh, const std::vector<std::string>& fabrics, const std::string& fabric) {
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (fabrics[panel_of(mesh, t)] == fabric) kept.push_back(t);
    }
    return with_triangles(mesh, kept);
}

// Without the panels of these garments.
sim::DrawMesh without(const sim::DrawMesh& mesh, const sim::Pattern& pattern, const std::set<std::string>& garments) {
    std::set<std::string> hidden;
    for (const sim::Panel& panel : pattern.panels) {
        if (garments.contains(garment_of(pattern, panel))) hidden.insert(panel.name);
    }
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(mesh, t);
        if (panel >= mesh.panel_names.size() || !hidden.contains(mesh.panel_names[panel])) kept.push_back(t);
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

// An unknown fabric falls back to the default one; the inspector reports it.
const sim::Fabric& ViewportScene::fabric(const std::string& name) {
    const auto known = fabrics_.find(name);
    if (known != fabrics_.end()) return known->second;
    sim::Fabric fabric;
    try {
        fabric = sim::find_fabric(name);
    } catch (const sim::InputError&) {
        fabric.name = name;
    }
    return fabrics_.emplace(name, std::move(fabric)).first->second;
}

void ViewportScene::update_sett(const sim::Pattern& pattern) {
    if (sett_ && pattern.tartan == tartan_ && pattern.sett_size == sett_size_) return;
    tartan_ = pattern.tartan;
    sett_size_ = pattern.sett_size;
    try {
        sett_ = sim::find_tartan(tartan_.empty() ? sim::kDefaultTartan : tartan_);
    } catch (const sim::InputError&) {
        sett_ = sim::find_tartan(sim::kDefaultTartan);
    }
    if (sett_size_ && *sett_size_ > 0) sett_ = with_repeat_size(std::move(*sett_), *sett_size_);
}

void ViewportScene::update_cloth(const ViewportSceneInput& input) {
    cloths_.clear();
    const sim::DrawMesh& all = input.curved ? *input.curved : input.garment.mesh();
    std::optional<sim::DrawMesh> visible;
    if (!input.look.hidden_garments.empty()) visible = without(all, input.pattern, input.look.hidden_garments);
    const sim::DrawMesh& mesh = visible ? *visible : all;
    if (!is_sound(mesh)) return;
    update_sett(input.pattern);
    const std::vector<std::string> names = fabrics_of(mesh, input.pattern);
    const std::set<std::string> distinct(names.begin(), names.end());
    for (const std::string& name : distinct) {
        const sim::Fabric& made_of = fabric(name);
        render::ClothItem item;
        item.mesh = distinct.size() == 1 ? mesh : part_of(mesh, names, name);
        if (item.mesh.triangles.empty()) continue;
        item.sett = *sett_;
        item.sett_position = input.pattern.sett_position.cast<float>();
        item.show = input.look.show;
        item.material = render::material_of(made_of);
        if (input.look.has_edges) {
            if (item.show == render::ShowMode::Plain) item.show = render::ShowMode::Edges;
            item.ink = kEdgeInk;
        }
        cloths_.push_back(std::move(item));
    }
}

void ViewportScene::update_body(const ViewportSceneInput& input) {
    has_body_ = input.look.has_body;
    body_ = input.current_body.body;
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
                         .show = input.look.show,
                         .has_edges = input.look.has_edges,
                         .hidden = input.look.hidden_garments,
                         .curved = input.curved};
    const bool is_cloth_new = !(key == key_);
    const bool is_body_new = input.current_body.body != body_ || input.look.has_body != has_body_ ||
                             input.garment.body_positions() != body_positions_;
    if (!is_cloth_new && !is_body_new && input.marks == marks_) return scene_;
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
