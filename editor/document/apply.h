#pragma once
// What each command does to a pattern. The same pattern and command give the same bits, so that a journal can be played
// again.
#include <optional>
#include <string>

#include "editor/document/command.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

struct PanelRename {
    std::string from;
    std::string to;
};

struct Outcome {
    std::optional<Selection> selection = {};  // what was made, to be selected; none: it stays as it was
    std::optional<PanelRename> rename = {};
};

// Throws DraftError; the pattern may then be half changed. Panels that mirror each other are not yet alike after it.
Outcome carry_out(Pattern& pattern, const Command& command);

// The commands that change parts of panels and seams, and how parts are found; carry_out.h has the others.

// Each throws DraftError where there is no such part.
const Seam& known_seam(const Pattern& pattern, int seam);
SeamSide edge_of(const Pattern& pattern, const PartRef& edge);
void check_vertex(const Panel& panel, int vertex);

// A map of the sheet as one of the panel's own plane.
Eigen::Affine2d map_in_panel(const Pattern& pattern, int panel, const PlaneMap& map);

Outcome run(Pattern& pattern, const RemoveParts& command);
Outcome run(Pattern& pattern, const MoveVertices& command);
Outcome run(Pattern& pattern, const TransformVertices& command);
Outcome run(Pattern& pattern, const SetCurve& command);
Outcome run(Pattern& pattern, const AddVertex& command);
Outcome run(Pattern& pattern, const AddDart& command);
Outcome run(Pattern& pattern, const AddInternalLine& command);
Outcome run(Pattern& pattern, const SetInternalLine& command);
Outcome run(Pattern& pattern, const AddNotch& command);
Outcome run(Pattern& pattern, const MoveNotch& command);
Outcome run(Pattern& pattern, const SewEdges& command);
Outcome run(Pattern& pattern, const SewRuns& command);
Outcome run(Pattern& pattern, const ReverseSeam& command);
Outcome run(Pattern& pattern, const NameSeam& command);
Outcome run(Pattern& pattern, const AcceptEase& command);
Outcome run(Pattern& pattern, const EvenSeam& command);

}  // namespace selvedge
