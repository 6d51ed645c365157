#include "tests/golden/frozen_mode.h"

#include <cmath>

#include "render/draw/renderer.h"
#include "render/marks/show.h"

namespace selvedge::test {
namespace {

constexpr std::uint32_t kSide = 49;  // vertices along a side of the frozen sheet

// Every eighth vertex along a side has level 0, every fourth level 1, every second level 2, the others level 3.
std::uint8_t vertex_level(std::uint32_t v) {
    const std::uint32_t i = v % kSide, j = v / kSide;
    for (std::uint8_t level = 0; level < 3; ++level) {
        const std::uint32_t step = 8U >> level;
        if (i % step == 0 && j % step == 0) return level;
    }
    return 3;
}

// m, distance from the ball under the sheet, increased to both sides so that the values also vary on top.
std::vector<float> clearances(const sim::PlainMesh& mesh) {
    std::vector<float> distances;
    for (const Vec3f& x : mesh.x) {
        const float away = (x - Vec3f(0, 0.55F, 0)).norm() - 0.25F;
        distances.push_back(away * (1 + 2 * std::abs(x.x())));
    }
    return distances;
}

// Refined towards one corner, down to level 3.
void add_refined(sim::TriangleHierarchy& all, const std::array<Vec2f, 3>& u, std::uint16_t panel, std::uint8_t level) {
    const Vec2f middle = (u[0] + u[1] + u[2]) / 3;
    const bool is_leaf = level == 3 || middle.norm() > 0.55F / float(1 << level);
    all.push_back({.u = u, .panel = panel, .level = level, .is_leaf = is_leaf});
    if (is_leaf) return;
    const std::array<Vec2f, 3> m{(u[0] + u[1]) / 2, (u[1] + u[2]) / 2, (u[2] + u[0]) / 2};
    const auto next = static_cast<std::uint8_t>(level + 1);
    add_refined(all, {u[0], m[0], m[2]}, panel, next);
    add_refined(all, {u[1], m[1], m[0]}, panel, next);
    add_refined(all, {u[2], m[2], m[1]}, panel, next);
    add_refined(all, m, panel, next);
}

sim::TriangleHierarchy hierarchy() {
    sim::TriangleHierarchy all;
    for (const std::uint16_t panel : {std::uint16_t{0}, std::uint16_t{1}}) {
        const float width = panel == 0 ? 0.5F : 0.3F;
        add_refined(all, {Vec2f(0, 0), Vec2f(width, 0), Vec2f(width, 0.4F)}, panel, 0);
        add_refined(all, {Vec2f(0, 0), Vec2f(width, 0.4F), Vec2f(0, 0.4F)}, panel, 0);
    }
    return all;
}

}  // namespace

FrozenMode make_frozen_mode(render::ShowMode mode) {
    if (mode == render::ShowMode::Hierarchy) {
        FrozenMode frozen;
        frozen.legend = fill_hierarchy(frozen.scene, hierarchy(), render::StackSide::Right,
                                       {.clearance = {}, .line_radius = 0.002F});
        frozen.scene.ground_y = -0.01F;
        frozen.scene.camera =
            frame_points(scene_points(frozen.scene), render::Direction{.azimuth = 0.3F, .elevation = 0.62F}, {});
        frozen.scene.light = even_light(frozen.scene.camera);
        return frozen;
    }
    FrozenMode frozen{.scene = make_frozen_scene({.show = mode}), .legend = {}};
    sim::PlainMesh& mesh = frozen.scene.cloths[0].mesh;
    for (std::uint32_t v = 0; v < mesh.x.size(); ++v) mesh.vertex_level.push_back(vertex_level(v));
    frozen.legend = fill_show(frozen.scene, {.clearance = clearances(mesh), .line_radius = 0.006F});
    frozen.scene.light = even_light(frozen.scene.camera);
    return frozen;
}

render::Image draw_frozen(const FrozenMode& frozen, int side_px) {
    render::Image image = render::Renderer().draw(frozen.scene, {.width_px = side_px, .height_px = side_px});
    if (frozen.legend) draw_legend(image, *frozen.legend, render::Corner::LowerLeft);
    return image;
}

}  // namespace selvedge::test
