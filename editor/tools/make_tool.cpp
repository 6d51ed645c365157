#include "editor/tools/draw_tools.h"
#include "editor/tools/edit_point_tool.h"
#include "editor/tools/free_sewing_tool.h"
#include "editor/tools/outline_tools.h"
#include "editor/tools/panel_tools.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/sewing_tool.h"
#include "editor/tools/transform_tool.h"

namespace selvedge {

std::unique_ptr<Tool> make_tool(ToolKind kind) {
    switch (kind) {
        case ToolKind::Select:
            return std::make_unique<SelectTool>();
        case ToolKind::EditPoint:
            return std::make_unique<EditPointTool>();
        case ToolKind::AddPoint:
            return std::make_unique<AddPointTool>();
        case ToolKind::CurvePoint:
            return std::make_unique<CurveTool>();
        case ToolKind::Polygon:
            return std::make_unique<PolygonTool>();
        case ToolKind::Rectangle:
            return std::make_unique<BoxTool>(BoxShape::Rectangle);
        case ToolKind::Ellipse:
            return std::make_unique<BoxTool>(BoxShape::Ellipse);
        case ToolKind::InternalLine:
            return std::make_unique<InternalLineTool>();
        case ToolKind::Dart:
            return std::make_unique<DartTool>();
        case ToolKind::Notch:
            return std::make_unique<NotchTool>();
        case ToolKind::Rotate:
            return std::make_unique<TransformTool>(TransformMode::Rotate);
        case ToolKind::Scale:
            return std::make_unique<TransformTool>(TransformMode::Scale);
        case ToolKind::Mirror:
            return std::make_unique<MirrorTool>();
        case ToolKind::Cut:
            return std::make_unique<CutTool>();
        case ToolKind::Merge:
            return std::make_unique<MergeTool>();
        case ToolKind::Unfold:
            return std::make_unique<UnfoldTool>();
        case ToolKind::Measure:
            return std::make_unique<MeasureTool>();
        case ToolKind::SegmentSewing:
            return std::make_unique<SewingTool>();
        case ToolKind::FreeSewing:
            return std::make_unique<FreeSewingTool>();
    }
    return std::make_unique<SelectTool>();
}

}  // namespace selvedge
