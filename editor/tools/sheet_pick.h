#pragma once
// What lies under the cursor on the sheet, and in a box drawn with it.
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
    std::set<PartRef> handle_edges{};  // the edges whose curve handles can be taken
};

// Small things first: vertex, curve handle, notch, edge, internal line, panel; of one kind the nearest, of panels the
// one drawn last.
struct Pick {
    PickKind kind = PickKind::Nothing;
    std::string panel{};
    int index = 0;                // of the vertex, edge, notch or internal line; of a handle: its edge
    int control = 0;              // of a handle: 0 or 1
    double t = 0;                 // of an edge: fraction of its length
    Vec2d point = Vec2d::Zero();  // on the sheet, m

    PartRef ref() const { return {panel, index}; }
};

Pick pick(const SheetGeometry& geometry, const Vec2d& sheet, const PickOptions& options);

Hover hover_of(const SheetGeometry& geometry, const Pick& picked);

enum class BoxRule {
    Inside,   // what lies wholly in the box
    Touching  // and what it only touches
};

enum class BoxTargets { Panels, Vertices, Edges };

Selection in_box(const SheetGeometry& geometry, const SheetBox& box, BoxRule rule, BoxTargets targets);

// The number of control points that a curve of this kind has.
int control_count(sim::CurveKind kind);

}  // namespace selvedge::editor
