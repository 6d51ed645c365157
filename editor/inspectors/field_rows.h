#pragma once
// Rows of the inspector for the fields of a part that have one (Field::row), by type, measure and range. They set the
// fields by SetFields.
#include "editor/document/part_commands.h"
#include "editor/inspectors/inspectors.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// `of`: names the part, without values. `standing`: holds what a number that is not set stands for. Widgets are called
// edge.NAME, line.NAME, notch.NAME, panel.NAME, seam.NAME and pattern.NAME; fields of a part in it, seam.NAME.INNER.
void field_rows(InspectorContext& context, const SetFields& of, const sim::OutlineEdge& edge,
                const sim::OutlineEdge& standing);
void field_rows(InspectorContext& context, const SetFields& of, const sim::InternalLine& line);
void field_rows(InspectorContext& context, const SetFields& of, const sim::Notch& notch);
void field_rows(InspectorContext& context, const SetFields& of, const sim::Panel& panel, const sim::Panel& standing);
void field_rows(InspectorContext& context, const SetFields& of, const sim::Seam& seam);
void field_rows(InspectorContext& context, const sim::Pattern& pattern, const sim::Pattern& standing);

}  // namespace selvedge::editor
