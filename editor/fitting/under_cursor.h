#pragma once
// What lies under the cursor in the 3D view.
#include <optional>
#include <vector>

#include "editor/document/hover.h"
#include "editor/fitting/gizmo.h"
#include "editor/fitting/ray_pick.h"
#include "editor/fitting/seen_garment.h"
#include "sim/dress/arrangement.h"

namespace selvedge {

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
BodySurface body_surface(const Body& body);

// All that can be met.
struct PickRoom {
    const Pattern& pattern;
    const SeenGarment& garment;
    const BodySurface* body = nullptr;                      // null: none is seen
    const std::vector<ArrangementPoint>* points = nullptr;  // null: none are seen
    const Gizmo* gizmo = nullptr;                           // null: there is none
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

}  // namespace selvedge
