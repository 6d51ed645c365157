#pragma once
// Snapping of a point on the sheet: to points of panels that are not hidden, to directions, to alignment with points,
// to the grid; and of a position along an edge.
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "editor/tools/sheet_geometry.h"

namespace selvedge::editor {

enum class SnapKind { None, Point, Midpoint, Direction, Guide, Grid };

struct SnapOptions {
    bool is_on = true;         // false: all snapping off, except to_directions
    double tolerance = 0.005;  // m
    double grid = 0.01;        // m; 0: no grid
    bool to_points = true;
    bool to_guides = true;
    bool to_directions = false;        // multiples of 45 degrees from `origin`; set while Shift is held
    std::optional<Vec2d> origin{};     // on the sheet, m: start of directions; also a point to align with
    std::vector<Vec2d> more_points{};  // on the sheet, m: points of the path being drawn
    std::set<PartRef> moving{};        // vertices in the drag: not snapped to
    std::set<std::string> moving_panels{};
};

struct SnapGuide {
    Vec2d from = Vec2d::Zero();
    Vec2d to = Vec2d::Zero();
};

struct Snap {
    Vec2d point = Vec2d::Zero();  // on the sheet, m
    SnapKind kind = SnapKind::None;
    std::vector<SnapGuide> guides{};  // lines to show
};

// Snaps in this order: to a direction (and along it to the vertical or horizontal line through a point, else to whole
// grid steps); to a vertex; to the middle of an edge; to vertical or horizontal alignment with vertices; to the grid.
Snap snap(const SheetGeometry& geometry, const Vec2d& wanted, const SnapOptions& options);

// A round fraction of the edge's length near t: its middle, thirds and quarters within half the tolerance; else whole
// millimetres from its nearer end. Returns t if snapping is off.
double snap_along(const EdgeShape& edge, double t, const SnapOptions& options);

}  // namespace selvedge::editor
