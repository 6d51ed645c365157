#include "editor/viewport3d/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace selvedge::editor {
namespace {

// px at scale 1.
constexpr float kHandleTolerance = 7, kPointTolerance = 9, kPointUnderRing = 5, kEdgeTolerance = 6,
                kVertexTolerance = 8;
constexpr float kSkin = 0.004F;    // m: cloth on a body may lie slightly below its surface
constexpr float kBehind = 0.025F;  // m: points up to this far behind the visible surface count as visible

Vec3f point_of(const sim::DrawMesh& mesh, const MeshHit& hit) {
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    return hit.weights[0] * mesh.x[a] + hit.weights[1] * mesh.x[b] + hit.weights[2] * mesh.x[c];
}

std::optional<MeshHit> hit_body(const Ray& ray, const PickScene& room) {
    return room.body ? nearest_hit(ray, room.body->x, room.body->triangles) : std::nullopt;
}

void find_surface(const Ray& ray, const std::optional<MeshHit>& body, const PickScene& room, UnderCursor& under) {
    const sim::DrawMesh& mesh = room.garment.mesh();
    const auto is_passed = [&](std::size_t triangle) {
        const std::size_t panel = sim::panel_of(mesh, triangle);
        return panel < mesh.panel_names.size() && room.passed.contains(mesh.panel_names[panel]);
    };
    const std::optional<MeshHit> cloth = nearest_hit(ray, mesh.x, mesh.triangles, is_passed);
    if (body && (!cloth || body->distance < cloth->distance - kSkin)) {
        under.surface = ray.at(body->distance);
        return;
    }
    if (!cloth) return;
    under.cloth = cloth;
    under.surface = point_of(mesh, *cloth);
    const std::size_t panel = sim::panel_of(mesh, cloth->triangle);
    if (panel < mesh.panel_names.size()) under.hover.panel = mesh.panel_names[panel];
}

// Accepts the candidate nearest to the cursor on the screen. Ignores candidates deeper than `farthest`.
class Nearest {
 public:
    Nearest(float tolerance_px, float farthest) : min_px_(tolerance_px), farthest_(farthest) {}

    bool take(const std::optional<ScreenDistance>& distance) {
        if (!distance || distance->depth > farthest_ || !(distance->px < min_px_)) return false;
        min_px_ = distance->px;
        return true;
    }

 private:
    float min_px_;
    float farthest_;  // m, depth in front of the eye
};

void find_point(const Viewing& viewing, const Vec2f& px, const PickScene& room, float farthest, UnderCursor& under) {
    // A ring may cover a point: prefer the point, because the ring can be grabbed elsewhere.
    const float tolerance_px = under.handle ? kPointUnderRing : kPointTolerance;
    Nearest nearest(tolerance_px * room.scale, farthest);
    for (std::size_t i = 0; i < room.points->size(); ++i) {
        if (nearest.take(distance_to_point(viewing, px, (*room.points)[i].position.cast<float>()))) under.point = i;
    }
    if (under.point) under.handle.reset();
}

// The dots are drawn over body and cloth: the nearest one on the screen, however deep it lies.
void find_joint(const Viewing& viewing, const Vec2f& px, const PickScene& room, UnderCursor& under) {
    const float tolerance_px = under.handle ? kPointUnderRing : kPointTolerance;
    Nearest nearest(tolerance_px * room.scale, viewing.camera.far_plane);
    for (std::size_t i = 0; i < room.joints.size(); ++i)
        if (nearest.take(distance_to_point(viewing, px, room.joints[i]))) under.joint = i;
    if (under.joint) under.handle.reset();
}

void find_part(const Viewing& viewing, const Vec2f& px, const PickScene& room, float farthest, Hover& hover) {
    Nearest vertices(kVertexTolerance * room.scale, farthest), edges(kEdgeTolerance * room.scale, farthest);
    const std::vector<Vec3f>& x = room.garment.mesh().x;
    for (std::size_t p = 0; p < room.pattern.panels.size() && p < room.garment.outlines().size(); ++p) {
        const ClothOutline& outline = room.garment.outlines()[p];
        const sim::Panel& panel = room.pattern.panels[p];
        if (room.passed.contains(panel.name)) continue;
        for (std::size_t e = 0; e < outline.starts.size() && e < panel.edges.size(); ++e) {
            if (vertices.take(distance_to_point(viewing, px, start_of(outline, e, x))))
                hover.vertex = PartRef{panel.name, panel.edges[e].start};
            if (edges.take(distance_to_path(viewing, px, edge_path(outline, e, x))))
                hover.edge = PartRef{panel.name, static_cast<int>(e)};
        }
    }
    if (hover.vertex) hover.edge.reset();
    if (hover.vertex) hover.panel = hover.vertex->panel;
    if (hover.edge) hover.panel = hover.edge->panel;
}

}  // namespace

BodySurface body_surface(const sim::Body& body) {
    BodySurface surface;
    for (const Vec3d& x : body.x) surface.x.push_back(x.cast<float>());
    for (const auto& [a, b, c] : body.triangles) {
        surface.triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    }
    return surface;
}

UnderCursor find_under(const Viewing& viewing, const Vec2f& px, const PickScene& room) {
    UnderCursor under;
    if (room.gizmo) under.handle = pick_gizmo(*room.gizmo, viewing, px, kHandleTolerance * room.scale);
    const Ray ray = ray_through(viewing, px);
    const std::optional<MeshHit> body = hit_body(ray, room);
    find_surface(ray, body, room, under);
    const auto behind = [&](const std::optional<Vec3f>& surface) {
        return surface ? depth_of(viewing, *surface) + kBehind : viewing.camera.far_plane;
    };
    const float farthest = behind(under.surface);
    const bool may_be_point = !under.handle || under.handle->kind == GizmoKind::Turn;
    if (room.points && may_be_point) {
        // Panels placed in front of the body do not block the arrangement points behind them.
        const auto on_body = body ? std::optional<Vec3f>(ray.at(body->distance)) : std::nullopt;
        find_point(viewing, px, room, behind(on_body), under);
    }
    if (!under.point) find_joint(viewing, px, room, under);
    if (room.choice == ClothChoice::Parts) find_part(viewing, px, room, farthest, under.hover);
    if (under.handle || under.point || under.joint) under.hover = {};
    return under;
}

// Moeller and Trumbore (1997), without back-face culling.
std::optional<MeshHit> nearest_hit(const Ray& ray, const std::vector<Vec3f>& x, const TriangleList& triangles,
                                   const std::function<bool(std::size_t triangle)>& is_passed) {
    std::optional<MeshHit> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Vec3f& a = x[triangles[t][0]];
        const Vec3f ab = x[triangles[t][1]] - a, ac = x[triangles[t][2]] - a;
        const Vec3f across = ray.direction.cross(ac);
        const float volume = ab.dot(across);
        if (volume == 0) continue;
        const Vec3f from_a = ray.origin - a;
        const float v = from_a.dot(across) / volume;
        if (!(v >= 0 && v <= 1)) continue;
        const Vec3f normal = from_a.cross(ab);
        const float w = ray.direction.dot(normal) / volume;
        if (!(w >= 0 && v + w <= 1)) continue;
        const float distance = ac.dot(normal) / volume;
        if (!(distance > 0 && distance < least) || (is_passed && is_passed(t))) continue;
        least = distance;
        nearest = {.distance = distance, .triangle = static_cast<std::uint32_t>(t), .weights = {1 - v - w, v, w}};
    }
    return nearest;
}

std::optional<ScreenDistance> distance_to_point(const Viewing& viewing, const Vec2f& px, const Vec3f& x) {
    const std::optional<Vec2f> at = px_of(viewing, x);
    if (!at) return std::nullopt;
    return ScreenDistance{.px = (*at - px).norm(), .depth = depth_of(viewing, x)};
}

std::optional<ScreenDistance> distance_to_path(const Viewing& viewing, const Vec2f& px,
                                               const std::vector<Vec3f>& path) {
    ScreenDistance nearest{.px = std::numeric_limits<float>::infinity()};
    for (std::size_t i = 1; i < path.size(); ++i) {
        const std::optional<Vec2f> from = px_of(viewing, path[i - 1]), to = px_of(viewing, path[i]);
        if (!from || !to) continue;
        const Vec2f along = *to - *from;
        const float length2 = along.squaredNorm();
        const float t = length2 > 0 ? std::clamp((px - *from).dot(along) / length2, 0.0F, 1.0F) : 0.0F;
        const float distance = (*from + t * along - px).norm();
        if (distance < nearest.px)
            nearest = {.px = distance, .depth = depth_of(viewing, path[i - 1] + t * (path[i] - path[i - 1]))};
    }
    if (!std::isfinite(nearest.px)) return std::nullopt;
    return nearest;
}

}  // namespace selvedge::editor
