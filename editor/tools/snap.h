#pragma once
// Where a point comes to lie that a person puts near something: on points of panels, in a direction, in line with
// points, on the grid.
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "editor/tools/sheet_geometry.h"

namespace selvedge::editor {

enum class SnapKind { None, Point, Midpoint, Direction, Guide, Grid };

struct SnapOptions {
    bool is_on = true;         // all of it, but for directions
    double tolerance = 0.005;  // m
    double grid = 0.01;        // m; 0: none
    bool to_points = true;
    bool to_guides = true;
    bool to_directions = false;        // multiples of 45 degrees from the origin: while Shift is held
    std::optional<Vec2d> origin{};     // on the sheet, m: where directions begin; also a point to align with
    std::vector<Vec2d> more_points{};  // on the sheet, m: of what is being drawn
    std::set<PartRef> moving{};        // vertices that move along: nothing snaps to these
    std::set<std::string> moving_panels{};
};

struct SnapGuide {
    Vec2d from = Vec2d::Zero();
    Vec2d to = Vec2d::Zero();
};

struct Snap {
    Vec2d point = Vec2d::Zero();  // on the sheet, m
    SnapKind kind = SnapKind::None;
    std::vector<SnapGuide> guides{};  // to be shown
};

// In this order: a direction (with whole steps of the grid along it, or where it meets the upright or level of a
// point); a vertex; the middle of an edge; in line with vertices, level or upright; the grid.
Snap snap(const SheetGeometry& geometry, const Vec2d& wanted, const SnapOptions& options);

// A fraction of an edge's length near t that is easily said: its middle, thirds and quarters within the tolerance, else
// whole millimetres from its nearer end. Off: t.
double snap_along(const EdgeShape& edge, double t, const SnapOptions& options);

}  // namespace selvedge::editor
