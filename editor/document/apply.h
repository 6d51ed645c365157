#pragma once
// What each command does to a pattern. The same pattern and command give the same bits, so that a journal can be played
// again.
#include <optional>
#include <string>

#include "editor/document/command.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

struct PanelRename {
    std::string from;
    std::string to;
};

struct Outcome {
    std::optional<Selection> selection = {};  // what was made, to be selected; none: it stays as it was
    std::optional<PanelRename> rename = {};
};

// Throws GeometryError; the pattern may then be half changed. Panels that mirror each other are not yet alike after it.
Outcome apply(sim::Pattern& pattern, const Command& command);

// The commands that change parts of panels and seams, and how parts are found; apply.h has the others.

// Each throws GeometryError where there is no such part.
const sim::Seam& known_seam(const sim::Pattern& pattern, int seam);
sim::SeamSide edge_of(const sim::Pattern& pattern, const PartRef& edge);
void check_vertex(const sim::Panel& panel, int vertex);

// A map of the sheet as one of the panel's own plane.
Eigen::Affine2d map_in_panel(const sim::Pattern& pattern, int panel, const PlaneMap& map);

Outcome run(sim::Pattern& pattern, const RemoveParts& command);
Outcome run(sim::Pattern& pattern, const MoveVertices& command);
Outcome run(sim::Pattern& pattern, const TransformVertices& command);
Outcome run(sim::Pattern& pattern, const SetCurve& command);
Outcome run(sim::Pattern& pattern, const AddVertex& command);
Outcome run(sim::Pattern& pattern, const AddDart& command);
Outcome run(sim::Pattern& pattern, const AddInternalLine& command);
Outcome run(sim::Pattern& pattern, const SetInternalLine& command);
Outcome run(sim::Pattern& pattern, const AddNotch& command);
Outcome run(sim::Pattern& pattern, const MoveNotch& command);
Outcome run(sim::Pattern& pattern, const SewEdges& command);
Outcome run(sim::Pattern& pattern, const SewRuns& command);
Outcome run(sim::Pattern& pattern, const ReverseSeam& command);
Outcome run(sim::Pattern& pattern, const NameSeam& command);
Outcome run(sim::Pattern& pattern, const AcceptEase& command);
Outcome run(sim::Pattern& pattern, const EvenSeam& command);

}  // namespace selvedge::editor
