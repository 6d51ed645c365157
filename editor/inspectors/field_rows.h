#pragma once
// Rows of the inspector for the fields of a part that have one (Field::row), by type, measure and range. They set the
// fields by SetFields.
#include "editor/document/part_commands.h"
#include "editor/inspectors/inspectors.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// `of`: names the part, without values. Widgets are called edge.NAME, line.NAME and seam.NAME; fields of a part in it,
// seam.NAME.INNER.
void field_rows(InspectorContext& context, const SetFields& of, const sim::OutlineEdge& edge);
void field_rows(InspectorContext& context, const SetFields& of, const sim::InternalLine& line);
void field_rows(InspectorContext& context, const SetFields& of, const sim::Seam& seam);

}  // namespace selvedge::editor
