#pragma once
// Picking in the 3D view: finds the gizmo handle, arrangement point, garment part or body surface under the cursor.
// Surfaces are picked with a ray, points and lines by their distance on the screen.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "editor/viewport3d/gizmo.h"
#include "editor/viewport3d/orbit_camera.h"
#include "editor/viewport3d/viewport_marks.h"
#include "sim/place/placement.h"

namespace selvedge::editor {

using TriangleList = std::vector<std::array<std::uint32_t, 3>>;

struct MeshHit {
    float distance = 0;  // m, along the ray
    std::uint32_t triangle = 0;
    Vec3f weights = Vec3f::Zero();  // barycentric coordinates of the hit
};

// Returns the nearest hit; both sides of a triangle count. Tests every triangle: about 0.2 ms for 25,000 triangles.
// Triangles for which `is_passed` returns true do not stop the ray.
std::optional<MeshHit> nearest_hit(const Ray& ray, const std::vector<Vec3f>& x, const TriangleList& triangles,
                                   const std::function<bool(std::size_t triangle)>& is_passed = {});

// Distance from the cursor on the screen, and the depth of the nearest point.
struct ScreenDistance {
    float px = 0;
    float depth = 0;  // m
};

// Returns none if the point is behind the eye.
std::optional<ScreenDistance> distance_to_point(const Viewing& viewing, const Vec2f& px, const Vec3f& x);

// Distance to the nearest segment of the path. Ignores segments with an end behind the eye. Returns none if none is
// left.
std::optional<ScreenDistance> distance_to_path(const Viewing& viewing, const Vec2f& px, const std::vector<Vec3f>& path);

// What a click on cloth selects.
enum class ClothChoice {
    Panels,
    Parts  // the outline vertex or edge near the cursor, otherwise the panel
};

// A body's surface in the format that picking uses.
struct BodySurface {
    std::vector<Vec3f> x;
    TriangleList triangles;
};
BodySurface body_surface(const sim::Body& body);

// Everything that can be picked.
struct PickScene {
    const sim::Pattern& pattern;
    const DisplayedGarment& garment;
    const BodySurface* body = nullptr;                           // null: the body is hidden
    const std::vector<sim::ArrangementPoint>* points = nullptr;  // null: the points are hidden
    std::span<const Vec3f> joints{};                             // m, dots of the body's joints
    const Gizmo* gizmo = nullptr;                                // null: there is no gizmo
    ClothChoice choice = ClothChoice::Panels;
    float scale = 1;                    // interface scale factor
    std::set<std::string> passed = {};  // panels that cannot be picked: what lies behind them is
};

struct UnderCursor {
    std::optional<GizmoHandle> handle{};
    std::optional<std::size_t> point{};  // index into the arrangement points
    std::optional<std::size_t> joint{};  // index into the joints
    std::optional<MeshHit> cloth{};      // empty if the body hides the cloth
    std::optional<Vec3f> surface{};      // m, the point on the cloth or body
    Hover hover{};                       // its panel and part; empty over a handle, arrangement point or joint
};

UnderCursor find_under(const Viewing& viewing, const Vec2f& px, const PickScene& room);

}  // namespace selvedge::editor
