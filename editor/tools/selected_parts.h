#pragma once
// What is selected, as tools act on it.
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/tools/sheet_geometry.h"

namespace selvedge {

// The vertices that move with the selection, ends of selected edges included; those of selected panels not.
std::vector<PartRef> selected_vertices(const SheetGeometry& geometry, const Selection& selection);

// Moves selected panels, or else selected vertices and edges. None: nothing of these is selected.
std::optional<Command> move_selected(const SheetGeometry& geometry, const Selection& selection, const Vec2d& by);

// A map of the sheet for the same. `what`: the word for the history.
std::optional<Command> transform_selected(const SheetGeometry& geometry, const Selection& selection,
                                          const PlaneMap& map, const std::string& what);

// The panels that have any part selected.
std::set<std::string> touched_panels(const Selection& selection);

PlaneMap rotation_about(const Vec2d& centre, double angle);
PlaneMap scaling_about(const Vec2d& centre, const Vec2d& factors);
PlaneMap mirror_over(const Vec2d& on_axis, const Vec2d& direction);  // Pre: the direction is not zero
Vec2d apply(const PlaneMap& map, const Vec2d& p);

}  // namespace selvedge
