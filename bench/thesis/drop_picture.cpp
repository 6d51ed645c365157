#include "bench/thesis/drop_picture.h"

#include <cmath>
#include <numbers>

#include "render/show.h"
#include "sim/dress/inspect.h"

namespace selvedge {
namespace {

constexpr std::uint32_t kSegments = 48;

// A surface of revolution: points (along, radius) from one end to the other, turned about an axis.
BodyItem revolve(const std::vector<Vec2f>& profile, bool about_x) {
    BodyItem item;
    for (const Vec2f& p : profile) {
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSegments;
            const float c = p.y() * std::cos(turn), s = p.y() * std::sin(turn);
            item.x.emplace_back(about_x ? Vec3f(p.x(), c, s) : Vec3f(s, p.x(), c));
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const std::uint32_t a = ring * kSegments + i, b = ring * kSegments + (i + 1) % kSegments;
            item.triangles.push_back({a, b, b + kSegments});
            item.triangles.push_back({a, b + kSegments, a + kSegments});
        }
    }
    item.normals = vertex_normals(item.x, item.triangles);
    return item;
}

BodyItem object_item(DropObject object) {
    if (object == DropObject::Cylinder)
        return revolve({{-kDropHalfLength, 0.001F},
                        {-kDropHalfLength, 0.999F * kDropRadius},
                        {-0.999F * kDropHalfLength, kDropRadius},
                        {0.999F * kDropHalfLength, kDropRadius},
                        {kDropHalfLength, 0.999F * kDropRadius},
                        {kDropHalfLength, 0.001F}},
                       true);
    std::vector<Vec2f> profile;
    for (int i = 0; i <= 24; ++i) {
        const float angle = std::numbers::pi_v<float> * (static_cast<float>(i) / 24 - 0.5F);
        profile.emplace_back(kDropRadius * std::sin(angle), std::max(1e-4F, kDropRadius * std::cos(angle)));
    }
    return revolve(profile, false);
}

}  // namespace

Image DropPainter::draw(const Cloth& cloth, DropObject object) {
    Scene scene;
    scene.cloths.push_back({.mesh = plain_mesh(cloth, {"cloth"}), .sett = {}, .show = ShowMode::Level});
    scene.bodies.push_back(object_item(object));
    scene.camera = {.eye = Vec3f(1.25F, 1.0F, 2.9F), .target = Vec3f(0, -0.08F, 0)};
    scene.light = studio_light(scene.camera);
    scene.has_ground = false;
    Image image = renderer_.draw(scene, {.width_px = side_px_, .height_px = side_px_});
    draw_legend(image, level_legend(scene.cloths.front().mesh), Corner::LowerLeft);
    return image;
}

}  // namespace selvedge
