#pragma once
// Applies each command to a pattern. Deterministic: the same pattern and command give a bit-identical result, so that a
// journal can be replayed.
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
    std::optional<Selection> selection = {};  // new selection; none: unchanged
    std::optional<PanelRename> rename = {};
};

// Throws GeometryError; the pattern may then be partly changed. Does not update linked mirror images (update_mirrors
// does).
Outcome apply(sim::Pattern& pattern, const Command& command);

// Commands on parts of panels and on seams, and access to parts with checks. The other commands are private to
// apply.cpp.

// Each throws GeometryError if there is no such part.
const sim::Seam& known_seam(const sim::Pattern& pattern, int seam);
sim::SeamSide edge_of(const sim::Pattern& pattern, const PartRef& edge);
void check_vertex(const sim::Panel& panel, int vertex);

// Converts a map in sheet coordinates to the panel's own coordinates.
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
