#pragma once
// Picking on the sheet: the part under the cursor, and the parts in a selection box.
#include <set>
#include <string>

#include "editor/document/selection.h"
#include "editor/tools/sheet_geometry.h"

namespace selvedge::editor {

enum class PickKind { Nothing, Vertex, Handle, Notch, Edge, InternalLine, Panel };

struct PickOptions {
    double tolerance = 0.005;  // m
    bool vertices = true;
    bool notches = true;
    bool edges = true;
    bool internal_lines = true;
    bool panels = true;
    std::set<PartRef> handle_edges{};  // edges whose curve handles can be picked
};

// The picked part. Hidden and locked panels are passed over, here and in a box. Priority: vertex, curve handle,
// notch, edge, internal line, panel; within a kind the nearest; of panels the one drawn last.
struct Pick {
    PickKind kind = PickKind::Nothing;
    std::string panel{};
    int index = 0;                // of the vertex, edge, notch or internal line; handle: its edge
    int control = 0;              // handle: control point 0 or 1
    double t = 0;                 // edge: fraction of its length; notch: its t
    Vec2d point = Vec2d::Zero();  // on the sheet, m

    PartRef ref() const { return {panel, index}; }
};

Pick pick(const SheetGeometry& geometry, const Vec2d& sheet, const PickOptions& options);

Hover hover_of(const SheetGeometry& geometry, const Pick& picked);

enum class BoxRule {
    Inside,   // parts fully inside the box
    Touching  // also parts that the box touches
};

enum class BoxTargets { Panels, Vertices, Edges };

Selection in_box(const SheetGeometry& geometry, const SheetBox& box, BoxRule rule, BoxTargets targets);

// The number of control points that a curve of this kind has.
int control_count(sim::CurveKind kind);

}  // namespace selvedge::editor
