#include "render/scene/scene.h"

#include <utility>

namespace selvedge::render {
namespace {

constexpr std::array<std::pair<std::string_view, ShowMode>, 12> kShowModes{{{"tartan", ShowMode::Tartan},
                                                                            {"level", ShowMode::Level},
                                                                            {"edges", ShowMode::Edges},
                                                                            {"plain", ShowMode::Plain},
                                                                            {"vertices", ShowMode::Vertices},
                                                                            {"hierarchy", ShowMode::Hierarchy},
                                                                            {"strain-warp", ShowMode::StrainWarp},
                                                                            {"strain-weft", ShowMode::StrainWeft},
                                                                            {"strain", ShowMode::Strain},
                                                                            {"clearance", ShowMode::Clearance},
                                                                            {"panels", ShowMode::Panels},
                                                                            {"seams", ShowMode::Seams}}};

}  // namespace

std::optional<ShowMode> parse_show_mode(std::string_view name) {
    for (const auto& [known, mode] : kShowModes) {
        if (known == name) return mode;
    }
    return std::nullopt;
}

std::string show_mode_names() {
    std::string names;
    for (const auto& [name, mode] : kShowModes) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

BodyItem make_body_item(const sim::Body& body) {
    BodyItem item;
    item.x.reserve(body.x.size());
    for (const Vec3d& point : body.x) item.x.push_back(point.cast<float>());
    item.triangles.reserve(body.triangles.size());
    for (const auto& [a, b, c] : body.triangles) {
        item.triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    }
    item.normals = sim::vertex_normals(item.x, item.triangles);
    return item;
}

std::vector<Vec3f> scene_points(const Scene& scene) {
    std::vector<Vec3f> points;
    for (const ClothItem& cloth : scene.cloths) points.insert(points.end(), cloth.mesh.x.begin(), cloth.mesh.x.end());
    for (const BodyItem& body : scene.bodies) points.insert(points.end(), body.x.begin(), body.x.end());
    return points;
}

Camera frame_scene(const Scene& scene, View view, float aspect) {
    return frame_points(scene_points(scene), view, {.aspect = aspect});
}

Light studio_light(const Camera& camera) {
    const Vec3f back = (camera.eye - camera.target).normalized();
    const Vec3f right = camera.up.cross(back).normalized();
    Light light;
    light.to_key = (-0.62F * right + 0.80F * Vec3f::UnitY() + 0.66F * back).normalized();
    light.to_fill = (0.85F * right + 0.15F * Vec3f::UnitY() + 0.5F * back).normalized();
    return light;
}

Light even_light(const Camera& camera) {
    Light light = studio_light(camera);
    light.key = 0.52F;
    light.fill = 0.16F;
    light.sky = 0.60F;
    light.bounce = 0.42F;
    return light;
}

// Row 0 of an image is its top, and v grows downwards.
std::array<Vec3f, 2> picture_rows(const ClothPicture& picture) {
    const float c = std::cos(picture.rotation), s = std::sin(picture.rotation);
    const Vec2f across = Vec2f(c, s) / picture.size.x(), up = Vec2f(-s, c) / picture.size.y();
    return {Vec3f(across.x(), across.y(), -across.dot(picture.position)),
            Vec3f(-up.x(), -up.y(), 1 + up.dot(picture.position))};
}

Material material_of(const sim::Fabric& fabric) {
    return {.gloss = static_cast<float>(fabric.gloss),
            .roughness = static_cast<float>(fabric.roughness),
            .sheen = static_cast<float>(fabric.sheen)};
}

}  // namespace selvedge::render
