#pragma once
// What lies under the cursor in the 3D view.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "editor/document/selection.h"
#include "editor/viewport3d/gizmo.h"
#include "editor/viewport3d/orbit_camera.h"
#include "editor/viewport3d/viewport_marks.h"
#include "sim/place/arrangement.h"

namespace selvedge::editor {

// What is under the cursor: triangles that a ray meets, and points and lines that are near it on the screen.

using TriangleList = std::vector<std::array<std::uint32_t, 3>>;

struct MeshHit {
    float distance = 0;  // m, along the ray
    std::uint32_t triangle = 0;
    Vec3f weights = Vec3f::Zero();  // of its corners
};

// The nearest hit, on either side of a triangle. Looks at every triangle: 25,000 take some 0.2 ms.
std::optional<MeshHit> nearest_hit(const Ray& ray, const std::vector<Vec3f>& x, const TriangleList& triangles);

// How near the cursor a thing is on the screen, and how far from the eye there.
struct ScreenDistance {
    float px = 0;
    float depth = 0;  // m
};

// None: it is behind the eye.
std::optional<ScreenDistance> distance_to_point(const Viewing& viewing, const Vec2f& px, const Vec3f& x);

// To the nearest of the path's straight parts; those with an end behind the eye are passed over.
std::optional<ScreenDistance> distance_to_path(const Viewing& viewing, const Vec2f& px, const std::vector<Vec3f>& path);

// What a click on cloth chooses.
enum class ClothChoice {
    Panels,
    Parts  // the vertex or edge of an outline that is near the cursor, else the panel
};

// A body as it is picked.
struct BodySurface {
    std::vector<Vec3f> x;
    TriangleList triangles;
};
BodySurface body_surface(const sim::Body& body);

// All that can be met.
struct PickRoom {
    const sim::Pattern& pattern;
    const DisplayedGarment& garment;
    const BodySurface* body = nullptr;                           // null: none is seen
    const std::vector<sim::ArrangementPoint>* points = nullptr;  // null: none are seen
    const Gizmo* gizmo = nullptr;                                // null: there is none
    ClothChoice choice = ClothChoice::Panels;
    float scale = 1;  // of the interface
};

struct UnderCursor {
    std::optional<GizmoHandle> handle{};
    std::optional<std::size_t> point{};  // of the arrangement points
    std::optional<MeshHit> cloth{};      // where no body lies before it
    std::optional<Vec3f> surface{};      // m, of cloth or body
    Hover hover{};                       // the panel of that cloth, and its part; nothing over a handle or point
};

UnderCursor find_under(const Viewing& viewing, const Vec2f& px, const PickRoom& room);

}  // namespace selvedge::editor
