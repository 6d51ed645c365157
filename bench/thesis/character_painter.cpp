#include "bench/thesis/character_painter.h"

#include "bench/support/cloth_run.h"
#include "render/scene/solids.h"

namespace selvedge::bench {
namespace {

constexpr float kPictureAspect = 0.62F;  // of a picture, as a share of its height

bool faces(const sim::Cloth& cloth, sim::TriangleId leaf, const Vec3f& eye) {
    const std::array<sim::VertexId, 3>& v = cloth.mesh.triangle(leaf).vertices;
    const Vec3f a = position_of(cloth, v[0]);
    return (position_of(cloth, v[1]) - a).cross(position_of(cloth, v[2]) - a).dot(eye - a) > 0;
}

}  // namespace

CharacterPainter::CharacterPainter(const sim::Body& body, int height_px)
    : stature_(static_cast<float>(sim::height_range(body).high)), height_px_(height_px) {
    for (const auto& [a, b, c] : body.triangles)
        triangles_.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
}

render::Image CharacterPainter::draw(const Subject& subject, const render::Direction& from, int scale) {
    render::Scene scene;
    scene.has_ground = false;
    if (subject.dress != nullptr) scene.cloths.push_back({.mesh = *subject.dress, .sett = {}, .show = subject.show});
    if (!subject.body_x.empty()) {
        std::vector<Vec3f> x(subject.body_x.begin(), subject.body_x.end());
        std::vector<Vec3f> normals = sim::vertex_normals(x, triangles_);
        scene.bodies.push_back({.x = std::move(x), .normals = std::move(normals), .triangles = triangles_});
    }
    scene.solids = subject.solids;
    const float low = subject.is_whole ? 0.0F : 0.2F, high = subject.is_whole ? 1.0F : 0.92F;
    const float half = subject.is_whole ? 0.26F : 0.2F;  // like low and high, as a share of the stature
    std::vector<Vec3f> corners;
    for (const float y : {low, high})
        for (const float x : {-half, half})
            for (const float z : {-half, half}) corners.emplace_back(subject.place + stature_ * Vec3f(x, y, z));
    const int height_px = scale * height_px_;
    const auto width_px = static_cast<int>(kPictureAspect * static_cast<float>(height_px));
    scene.camera = render::frame_points(corners, from, {.aspect = kPictureAspect, .margin = 0.02F});
    scene.light = studio_light(scene.camera);
    return renderer_.draw(scene, {.width_px = width_px, .height_px = height_px});
}

render::SolidItem fixed_edges(const sim::Cloth& cloth) {
    constexpr sim::Rgb8 kTurquoise{0x18, 0xC5, 0xC0};
    constexpr float kRadius = 0.0016F;  // m
    render::SolidItem solid;
    for (const sim::LeafEdge& e : cloth.mesh.leaf_edges()) {
        if (cloth.is_pinned[e.a.value] && cloth.is_pinned[e.b.value])
            add_rod(solid, position_of(cloth, e.a), position_of(cloth, e.b), kRadius, kTurquoise);
    }
    return solid;
}

render::SolidItem edges_by_sight(const sim::Cloth& cloth, const Vec3f& eye) {
    constexpr sim::Rgb8 kUnseen{0x1E, 0xA0, 0x3C}, kSeen{0x30, 0x30, 0x38};
    constexpr float kRadius = 0.0009F;  // m
    render::SolidItem solid;
    for (const sim::LeafEdge& e : cloth.mesh.leaf_edges()) {
        bool seen = false;
        for (const int side : {0, 1}) {
            const sim::TriangleId leaf = cloth.mesh.leaf_at(e.edge, side);
            seen = seen || (leaf && faces(cloth, leaf, eye));
        }
        add_rod(solid, position_of(cloth, e.a), position_of(cloth, e.b), kRadius, seen ? kSeen : kUnseen);
    }
    return solid;
}

}  // namespace selvedge::bench
