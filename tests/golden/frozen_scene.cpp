#include "tests/golden/frozen_scene.h"

#include <algorithm>
#include <cmath>

#include "render/draw/renderer.h"
#include "render/marks/show.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::test {
namespace {

constexpr float kBallRadius = 0.25F;  // m
constexpr float kBallHeight = 0.55F;  // m, of its centre
constexpr float kClothRadius = kBallRadius + 0.004F;
constexpr float kHalfSide = 0.55F;
constexpr std::uint32_t kCells = 48;  // along a side; even, so that the seam runs along the middle

// Position of the sheet's point (x, z): by arc length down the ball to its equator, from there straight down.
Vec3f drape(const Vec2f& at) {
    const float reach = at.norm();
    if (reach == 0) return {0, kBallHeight + kClothRadius, 0};
    const Vec2f outward = at / reach;
    const float quarter = 1.5707963F * kClothRadius;
    const float angle = std::min(reach, quarter) / kClothRadius;
    const float hanging = std::max(reach - quarter, 0.0F);
    const float turn = std::atan2(at.y(), at.x());
    const float fold = 0.22F * hanging * (1 + std::cos(9 * turn));
    const Vec2f flat = outward * (kClothRadius * std::sin(angle) + fold);
    return {flat.x(), kBallHeight + kClothRadius * std::cos(angle) - hanging, flat.y()};
}

Vec2f sheet_point(std::uint32_t i, std::uint32_t j) {
    constexpr float step = 2 * kHalfSide / float(kCells);
    return {float(i) * step - kHalfSide, float(j) * step - kHalfSide};
}

std::uint32_t vertex_at(std::uint32_t i, std::uint32_t j) {
    return j * (kCells + 1) + i;
}

// Seen from above, +z points down: (i, j) (i, j+1) (i+1, j) is anticlockwise.
void add_triangle(sim::DrawMesh& mesh, const std::array<std::array<std::uint32_t, 2>, 3>& corners) {
    const bool is_left = corners[0][0] + corners[1][0] + corners[2][0] < 3 * kCells / 2;
    std::array<Vec2f, 3> u;
    Vec2f centre = Vec2f::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
        const Vec2f at = sheet_point(corners[c][0], corners[c][1]);
        u[c] = Vec2f(at.x() + (is_left ? 0.0F : 0.031F), -at.y());  // the setts do not match at the seam
        centre += at / 3;
    }
    mesh.triangles.push_back({vertex_at(corners[0][0], corners[0][1]), vertex_at(corners[1][0], corners[1][1]),
                              vertex_at(corners[2][0], corners[2][1])});
    mesh.u.push_back(u);
    mesh.panel.push_back(is_left ? 0 : 1);
    mesh.level.push_back(static_cast<std::uint8_t>(std::min(centre.norm() / 0.16F, 4.0F)));
}

sim::DrawMesh make_sheet() {
    sim::DrawMesh mesh;
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i <= kCells; ++i) mesh.x.push_back(drape(sheet_point(i, j)));
    }
    for (std::uint32_t j = 0; j < kCells; ++j) {
        for (std::uint32_t i = 0; i < kCells; ++i) {
            add_triangle(mesh, {{{i, j}, {i, j + 1}, {i + 1, j + 1}}});
            add_triangle(mesh, {{{i, j}, {i + 1, j + 1}, {i + 1, j}}});
        }
    }
    mesh.panel_names = {"left", "right"};
    mesh.panel_grain_angles = {0, 0.7853982F};
    mesh.normals = sim::vertex_normals(mesh.x, mesh.triangles);
    return mesh;
}

render::BodyItem make_ball() {
    constexpr std::uint32_t around = 64, rings = 32;
    render::BodyItem ball;
    for (std::uint32_t ring = 0; ring <= rings; ++ring) {
        const float polar = 3.14159265F * float(ring) / float(rings);
        for (std::uint32_t i = 0; i < around; ++i) {
            const float turn = 6.2831853F * float(i) / float(around);
            const Vec3f normal(std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn));
            ball.normals.push_back(normal);
            ball.x.push_back(kBallRadius * normal + Vec3f(0, kBallHeight, 0));
        }
    }
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = ring * around + i, b = ring * around + (i + 1) % around;
            ball.triangles.push_back({a, a + around, b});
            ball.triangles.push_back({b, a + around, b + around});
        }
    }
    return ball;
}

}  // namespace

render::Scene make_frozen_scene(const FrozenOptions& options) {
    render::Scene scene;
    render::ClothItem cloth;
    cloth.mesh = make_sheet();
    cloth.sett = sim::find_tartan("royal_stewart");
    cloth.show = options.show;
    scene.cloths.push_back(cloth);
    if (options.has_ball) scene.bodies.push_back(make_ball());
    scene.camera = frame_scene(scene, options.view, 1);
    scene.light = studio_light(scene.camera);
    return scene;
}

namespace {

constexpr std::uint32_t kSheetSide = 49;  // vertices along a side of the frozen sheet

// Every eighth vertex along a side has level 0, every fourth level 1, every second level 2, the others level 3.
std::uint8_t vertex_level(std::uint32_t v) {
    const std::uint32_t i = v % kSheetSide, j = v / kSheetSide;
    for (std::uint8_t level = 0; level < 3; ++level) {
        const std::uint32_t step = 8U >> level;
        if (i % step == 0 && j % step == 0) return level;
    }
    return 3;
}

// m, distance from the ball under the sheet, increased to both sides so that the values also vary on top.
std::vector<float> clearances(const sim::DrawMesh& mesh) {
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
    sim::DrawMesh& mesh = frozen.scene.cloths[0].mesh;
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
