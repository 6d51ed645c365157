#pragma once
// The commands that change parts of panels and seams, and how parts are found; carry_out.h has the others.
#include "editor/document/carry_out.h"

namespace selvedge {

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
