#pragma once
// Builds the Scene of the 3D view from the workspace. Returns the same pointer as long as nothing has changed, so that
// the renderer can cache what it derives from the scene.
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "editor/viewport3d/viewport_marks.h"
#include "editor/workspace/workspace.h"
#include "render/looks/cloth_looks.h"

namespace selvedge::editor {

struct ViewportSceneInput {
    const sim::Pattern& pattern;
    std::uint64_t revision = 0;        // of the pattern
    std::uint64_t fabric_version = 0;  // of what fabric files hold
    const DisplayedGarment& garment;
    const CurrentBody& current_body;
    std::shared_ptr<const sim::DrawMesh> curved{};  // drawn instead of the garment's mesh; null: none
    ViewOptions look{};
    ViewportMarks marks{};  // its undrawn panels are left out of the cloth, too
};

class ViewportScene {
 public:
    explicit ViewportScene(ViewportColours colours = {}) : colours_(colours) {}

    // Returns the scene for the input; null: there is nothing to show.
    std::shared_ptr<const render::Scene> update(const ViewportSceneInput& input);

 private:
    // Key of the cached cloth items.
    struct ContentKey {
        std::uint64_t garment = 0;
        std::uint64_t revision = 0;
        std::uint64_t fabric_version = 0;
        render::ShowMode show = render::ShowMode::Tartan;
        bool has_edges = false;
        std::set<std::string> undrawn;
        std::shared_ptr<const sim::DrawMesh> curved;

        bool operator==(const ContentKey&) const = default;
    };

    void update_cloth(const ViewportSceneInput& input);
    void update_body(const ViewportSceneInput& input);

    ViewportColours colours_;
    std::shared_ptr<const render::Scene> scene_;
    ContentKey key_;
    ViewportMarks marks_;
    bool has_body_ = false;
    std::shared_ptr<const sim::Body> body_;
    std::shared_ptr<const std::vector<Vec3f>> body_positions_;
    std::vector<render::BodyItem> bodies_;
    std::vector<render::ClothItem> cloths_;
    render::ClothLooks looks_{render::ClothLooks::Unknown::Replace};
};

// Whether the curved surface can stand for the cloth. The other modes show data of the simulated triangles.
bool may_be_curved(const ViewOptions& look);

// Whether the mode maps values to colours; the program then colours the cloth (render/marks/show.h) before rendering.
bool fills_show_mode(render::ShowMode show);

}  // namespace selvedge::editor
